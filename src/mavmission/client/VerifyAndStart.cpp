// MissionClient's verifyAndStart(): a start() between two looks at each item that the autopilot holds.
#include "CommandOperations.h"
#include "MissionClient.h"
#include "Reading.h"

namespace mavmission {
using namespace detail;

// No autopilot's: somebody has set another mode while the plan was read.
constexpr uint16_t kOtherMode = kNoMode - 1;

struct Client::VerifiedStart {
  static void wait(Client& client, const FrameParser* frame, uint16_t nowMs);
  static void note(Client& client);
  static Status compareFirst(Client& client, uint16_t wireItem, MissionItem& item);
  static void start(Client& client, Status status);
  static Status on(Client&, CommandEvent, Status, const FrameParser*, uint16_t);
  static void end(Client& client, Status status);
  static Status leaveOther(Client&, CommandEvent, Status, const FrameParser*, uint16_t);
  static void takeLook(Client& client);
};

Status MissionClient::verifyAndStart(const ItemSource& plan, uint16_t item) {
  const Status status = verify(plan);
  if (isEnd(status)) return status;
  state_.operation = VerifiedStart::wait;
  startItem_ = item;
  modeFlagsBefore_ = link_.finder().heartbeat().baseMode;
  reading_.take = VerifiedStart::compareFirst;
  session_.tellEnd = VerifiedStart::start;
  session_.startStep = 0;
  session_.startArming = 0;
  state_.next = hasAutopilot() ? shownMode() : kNoMode;
  return status;
}

// What is set from now on is somebody else's mode already; and who disarms then wants it so.
void Client::VerifiedStart::note(Client& client) {
  uint16_t& first = client.state_.next;
  const uint16_t shown = client.shownMode();
  if (first != shown) first = first == kNoMode ? shown : kOtherMode;
  client.modeFlagsBefore_ |= client.link_.finder().heartbeat().baseMode;
}

void Client::VerifiedStart::wait(Client& client, const FrameParser* frame, uint16_t nowMs) {
  if (client.hasAutopilot()) note(client);
  ReadingPlan::beginStep(client, frame, nowMs);
}

Status Client::VerifiedStart::compareFirst(Client& client, uint16_t wireItem, MissionItem& item) {
  note(client);
  return ReadingPlan::compare(client, wireItem, item);
}

// Takes the end of a look: the sketch is not told about it, unless it is the end of the operation.
void Client::VerifiedStart::takeLook(Client& client) {
  client.session_.tellEnd = client.session_.ended != nullptr ? tellEnd : nullptr;
  client.session_.toReturn = Status::Idle;
}

void Client::VerifiedStart::start(Client& client, Status status) {
  takeLook(client);
  if (status != Status::Verified) return client.end(status);
  const uint16_t item = client.startItem_, mode = client.state_.next;
  const uint8_t modeFlags = client.modeFlagsBefore_;
  client.beginCommand(Starting::fill, on);
  client.commanding_.modeFlags = modeFlags;
  client.commanding_.start.setFirst(item);
  client.state_.next = mode;
  client.state_.status = Status::Checking;  // the autopilot is there
}

// What flies is looked at once more. PX4 has named its plan's checksum meanwhile.
Status Client::VerifiedStart::on(Client& client, CommandEvent event, Status status, const FrameParser* frame,
                                 uint16_t nowMs) {
  status = Starting::on(client, event, status, frame, nowMs);
  if (status != Status::Done || client.known_.planId != 0) return status;
  client.startOperation(ReadingPlan::beginStep);
  client.reading_.take = ReadingPlan::compare;
  client.state_.isCompared = true;
  client.state_.itemsTotal = client.plan_.count();
  client.session_.tellEnd = end;
  return Status::Transferring;
}

void Client::VerifiedStart::end(Client& client, Status status) {
  takeLook(client);
  if (status == Status::Cancelled) return client.end(status);
  if (status == Status::Differs) client.setAboard(PlanType::Mission, Aboard::OtherPlan);
  if (!client.isArmed()) return client.end(Starting::noted(client, Status::NotArmed));
  const uint16_t wanted = client.numberOf(FlightMode::Auto);  // kNoMode: its modes are not known
  if (wanted != kNoMode && client.shownMode() != wanted) return client.end(Starting::noted(client, Status::TakenOver));
  // What was read after a standstill may be over: so may what the heartbeat before has shown.
  const bool isNow = client.link_.isCurrent() && !client.link_.isOld();
  if (status == Status::Verified) return client.end(isNow ? Status::Done : Status::Unconfirmed);
  // Not to be read is not to be another plan: it goes on with what it flies.
  if (status != Status::Differs) return client.end(Status::FliesOtherPlan);
  client.beginCommand(Starting::fill, leaveOther);
  client.state_.status = Status::Checking;
}

Status Client::VerifiedStart::leaveOther(Client& client, CommandEvent, Status, const FrameParser*, uint16_t nowMs) {
  Commanding& commanding = client.commanding_;
  commanding.on = Starting::on;
  const Status status =
      commanding.start.leaveFlying(client.startArming(), Starting::aircraftOf(client, nowMs), commanding.transfer);
  Starting::note(client);
  return status;
}

}  // namespace mavmission
