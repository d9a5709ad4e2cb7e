// MissionClient's download into a sink.
#include <Arduino.h>

#include "../base/FloatBits.h"
#include "../link/Messages.h"
#include "MissionClient.h"
#include "Reading.h"

namespace mavmission {
using namespace detail;

Status MissionClient::download(const ItemSink& sink, PlanType type) {
  if (state_.operation != nullptr) return Status::Busy;
  if (type == PlanType::All) return refuseType();
  state_.type = type;
  startOperation(ReadingPlan::beginStep);
  reading_.take = ReadingPlan::store;
  state_.isCompared = false;
  reading_.sink = sink;
  return state_.status;
}

Status Client::ReadingPlan::store(Client& client, uint16_t wireItem, MissionItem& item) {
  const ItemSink& sink = client.reading_.sink;
  if (sink.isReady != nullptr && !sink.isReady(sink.context)) return Status::Checking;
  if (!client.session_.raw) fromWire(item, client.plan_.firmware());
  static_assert(kHomeIndex == static_cast<uint16_t>(0 - 1), "the number that ItemNumbers::toOwn() gives home");
  return sink.write(sink.context, client.ownItem(wireItem), item) ? Status::Transferring : Status::SinkFull;
}

}  // namespace mavmission
