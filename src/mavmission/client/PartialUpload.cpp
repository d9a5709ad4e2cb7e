// MissionClient's partial upload, which only ArduPilot takes. A file of its own, since few sketches need it.
#include <Arduino.h>

#include "../link/Messages.h"
#include "../link/Sending.h"
#include "MissionClient.h"
#include "Uploading.h"

namespace mavmission {
using namespace detail;

Status MissionClient::uploadPartial(const ItemSource& plan, uint16_t first, uint16_t count) {
  if (state_.operation != nullptr) return Status::Busy;
  const Status status = upload(plan);
  if (isEnd(status)) return status;
  session_.announcePart = Uploading::announcePart;
  partFirst_ = first;
  partCount_ = count;
  if (count == 0 || first >= plan.count || count > plan.count - first) {
    session_.planType = PlanType::All;  // there is no whole plan for uploadAgain()
    return refuse(Status::BadRange);
  }
  return state_.status;
}

void Client::Uploading::announcePart(Client& client) {
  const uint16_t first = client.plan_.numbers().toWire(client.partFirst_);
  const uint16_t end = first + client.partCount_;
  // Before the first announcement nothing is taken for an answer to it.
  if (client.transfer_.tries() == 0) client.transfer_.limitTo(first, end);
  mavlink_mission_write_partial_list_t list = mavlink_mission_write_partial_list_t();
  list.start_index = static_cast<int16_t>(first);
  list.end_index = static_cast<int16_t>(end - 1);
  client.link_.send(list);
}

}  // namespace mavmission
