// MissionClient's verifyAndStart(): a start() between two looks at each item that the autopilot holds.
#include "../MissionClient.h"

namespace mavmission {
using namespace detail;

Status MissionClient::verifyAndStart(const ItemSource& plan, uint16_t item) {
  const Status status = verify(plan);
  if (isEnd(status)) return status;
  startItem_ = item;
  reading_.take = compareFirst;
  rest_.tellEnd = startVerified;
  rest_.startStep = 0;
  rest_.startArming = 0;
  state_.next = hasAutopilot() ? shownMode() : kNoMode;
  return status;
}

// What is set while the plan is read is somebody else's mode already.
Status Client::compareFirst(Client& client, uint16_t wireItem, MissionItem& item) {
  if (client.state_.next == kNoMode) client.state_.next = client.shownMode();
  return compareItem(client, wireItem, item);
}

// Takes the end of a look: the sketch is not told about it, unless it is the end of the operation.
void Client::takeLook() {
  rest_.tellEnd = rest_.ended != nullptr ? tellEnd : nullptr;
  rest_.toReturn = Status::Idle;
}

void Client::startVerified(Client& client, Status status) {
  client.takeLook();
  if (status != Status::Verified) return client.end(status);
  const uint16_t item = client.startItem_, mode = client.state_.next;
  client.beginCommand(fillStart, onVerifiedStart);
  client.commanding_.start.setFirst(item);
  client.state_.next = mode;
  client.state_.status = Status::Checking;  // the autopilot is there
}

// What flies is looked at once more. PX4 has named its plan's checksum meanwhile.
Status Client::onVerifiedStart(Client& client, CommandEvent event, Status status, const FrameParser* frame,
                               uint16_t nowMs) {
  status = onStart(client, event, status, frame, nowMs);
  if (status != Status::Done || client.rest_.planId != 0) return status;
  client.startOperation(readStep);
  client.reading_.take = compareItem;
  client.state_.isCompared = true;
  client.reading_.fromFloats = fromFloats;
  client.rest_.itemsTotal = client.plan_.count();
  client.rest_.tellEnd = endVerifiedStart;
  return Status::Transferring;
}

void Client::endVerifiedStart(Client& client, Status status) {
  client.takeLook();
  if (status == Status::Cancelled) return client.end(status);
  if (status == Status::Differs) client.setAboard(PlanType::Mission, Aboard::OtherPlan);
  if (!client.isArmed()) return client.end(Status::NotArmed);
  const uint16_t wanted = client.numberOf(FlightMode::Auto);  // kNoMode: its modes are not known
  if (wanted != kNoMode && client.shownMode() != wanted) return client.end(Status::TakenOver);
  if (status == Status::Verified) return client.end(Status::Done);
  // Not to be read is not to be another plan: it goes on with what it flies.
  if (status != Status::Differs) return client.end(Status::Unproven);
  client.beginCommand(fillStart, leaveOther);
  client.state_.status = Status::Checking;
}

Status Client::leaveOther(Client& client, CommandEvent, Status, const FrameParser*, uint16_t nowMs) {
  Commanding& commanding = client.commanding_;
  commanding.on = onStart;
  const Status status = commanding.start.leaveFlying(client.startArming(), client.aircraft(nowMs), commanding.transfer);
  client.noteStart();
  return status;
}

}  // namespace mavmission
