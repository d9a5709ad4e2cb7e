// MissionClient's download into a sink.
#include <Arduino.h>

#include "../MissionClient.h"
#include "../base/FloatBits.h"
#include "../link/Messages.h"

namespace mavmission {
using namespace detail;

Status MissionClient::download(const ItemSink& sink, PlanType type) {
  if (state_.operation != nullptr) return Status::Busy;
  if (type == PlanType::All) return refuseType();
  state_.type = type;
  startOperation(readStep);
  reading_.take = storeItem;
  state_.isCompared = false;
  reading_.fromFloats = fromFloats;
  reading_.sink = sink;
  return state_.status;
}

Status Client::storeItem(Client& client, uint16_t wireItem, MissionItem& item) {
  const ItemSink& sink = client.reading_.sink;
  if (sink.isReady != nullptr && !sink.isReady(sink.context)) return Status::Checking;
  uint16_t index = wireItem;
  if (!client.rest_.raw) {
    if (client.homeBefore() != 0) index = wireItem == 0 ? kHomeIndex : wireItem - 1;
    fromWire(item, client.plan_.firmware());
  }
  return sink.write(sink.context, index, item) ? Status::Transferring : Status::SinkFull;
}

}  // namespace mavmission
