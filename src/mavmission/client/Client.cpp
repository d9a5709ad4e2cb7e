#include "MissionClient.h"

#include <Arduino.h>

#include "../base/Clock.h"
#include "../base/Flash.h"
#include "../link/Messages.h"
#include "../link/Sending.h"
#include "Reading.h"
#include "Uploading.h"

namespace mavmission {
using namespace detail;

Client::Client(Stream& stream) {
  // All parts are plain data that begins at zero: one call is smaller than a constructor for each.
  memset(static_cast<void*>(this), 0, sizeof(*this));
  link_.begin(stream);
  state_.failedItem = kNoItem;
  state_.lastResult = 255;
  state_.unsettled = kFromOpen;
  session_.planType = PlanType::All;
}

void MissionClient::onProgress(ProgressFunction function, void* context) {
  session_.progress = function;
  session_.progressContext = context;
}

void MissionClient::onEnd(EndFunction function, void* context) {
  session_.ended = function;
  session_.endedContext = context;
  session_.tellEnd = function != nullptr ? tellEnd : nullptr;
}

void MissionClient::setSourceIds(uint8_t systemId, uint8_t componentId) { link_.setSourceIds(systemId, componentId); }

void MissionClient::setTargetIds(uint8_t systemId, uint8_t componentId) {
  // What waits for an autopilot that is clear by now was begun for that one.
  const bool isForOther = link_.finder().isChosen();
  link_.finder().setTargetIds(systemId, componentId);
  if (!link_.finder().takeChange()) return;
  forgetAutopilot();
  if (isForOther && state_.operation != nullptr) end(Status::NoAutopilot);
}

// All that was learned belongs to one autopilot: it is forgotten here, and what was begun for it ends.
void Client::forgetAutopilot() {
  memset(&known_, 0, sizeof(known_));
  state_.cancelled = 0;
  link_.cut();
  if (state_.operation != nullptr && state_.status == Status::Transferring) end(Status::NoAutopilot);
}

void Port::beginSeconds(uint16_t nowMs) {
  Client::State& state = static_cast<Client&>(*this).state_;
  state.secondMs = nowMs;
  state.seconds = 0;
  state.limitFromS = 0;
  state.isLate = false;
}

Status Client::startOperation(Step operation) {
  beginSeconds(static_cast<uint16_t>(millis()));
  state_.operation = operation;
  state_.failedItem = kNoItem;
  state_.itemsDone = 0;
  state_.itemsTotal = 0;
  state_.lastResult = 255;
  session_.field = ItemField::None;
  state_.proving = false;
  session_.backOffPauseS = 0;
  state_.isCommanding = false;
  state_.isPlanless = false;
  state_.isDoubtful = false;
  state_.status = Status::WaitingForAutopilot;
  return state_.status;
}

void Port::end(Status status) {
  Client& client = static_cast<Client&>(*this);
  // The line may bring its last frames once more, and what they draw, when the next operation runs.
  if (client.state_.status == Status::Transferring && !client.state_.isPlanless) client.expectAnswers(kFromBefore);
  client.state_.operation = nullptr;
  client.state_.status = status;
  // The first of two ends: the other one is a refusal, and whoever asked has got it.
  if (client.session_.toReturn == Status::Idle) client.session_.toReturn = status;
  if (client.session_.tellEnd != nullptr) client.session_.tellEnd(client, status);
}

// The function may begin an operation that ends at once: the next update() then tells about that end. Otherwise a
// sketch that tries again with each end would call itself until the stack is used up.
void Client::tellEnd(Client& client, Status status) {
  if (client.state_.isTelling) {
    client.state_.operation = tellLaterStep;
    return;
  }
  client.state_.isTelling = true;
  client.session_.ended(client.session_.endedContext, status);
  client.state_.isTelling = false;
}

void Client::tellLaterStep(Client& client, const FrameParser* frame, uint16_t) {
  if (frame == nullptr && client.session_.toReturn == Status::Idle) client.end(client.state_.status);
}

void Client::expectAnswers(uint8_t what) {
  state_.unsettled |= what;
  state_.unsettledMs = state_.tickMs;
}

bool Client::awaitsCopies() {
  // Where frames come over two ways, so does the answer to a copy of ours.
  const uint16_t copyMs = link_.hasTwoWays() ? 2 * kCopyMs : kCopyMs;
  const uint16_t lateMs = state_.unsettled >= kOneSecond ? kLateMs : copyMs;
  return (state_.unsettled & kFromBefore) != 0 &&
         since(state_.unsettledMs, state_.tickMs) < lateMs + 2 * link_.pace().roundTripMs();
}

void Client::tellCancelled(PlanType type) { state_.cancelled = static_cast<uint8_t>(type) + 1; }

// A callback is called in the middle of an operation, which goes on to the end of this update().
void MissionClient::cancel() {
  if (state_.atEnd == nullptr) return cancelNow();
  if (state_.operation != nullptr) state_.atEnd = session_.toReturn == Status::Idle ? cancelAtEnd : cancelSecond;
}

void Client::cancelAtEnd(Client& client) {
  if (client.session_.toReturn == Status::Idle) client.cancelNow();  // otherwise it has ended by itself
}

// Cancels an operation that was begun in this update(), after the end of another one. update() returns that end, and
// the next update() this one.
void Client::cancelSecond(Client& client) {
  if (client.state_.operation == nullptr) return;
  const bool wasTelling = client.state_.isTelling;
  client.state_.isTelling = true;
  client.cancelNow();
  client.state_.isTelling = wasTelling;
  client.state_.operation = tellLaterStep;
}

void Client::cancelNow() {
  if (state_.operation == nullptr || state_.operation == tellLaterStep) return;
  noteSent(2);
  const bool isUpload = state_.operation == Uploading::step;
  if (state_.status == Status::Transferring && (isUpload || state_.proving || state_.operation == ReadingPlan::step)) {
    tellCancelled();
    if (isUpload) setAboard(Uploading::aboardAfter(*this, Status::Cancelled));
    unsettle();
  }
  end(Status::Cancelled);
}

void Port::waitForAutopilot() {
  Client& client = static_cast<Client&>(*this);
  Client::State& state = client.state_;
  // An update() returns one end: this operation goes on in the next one.
  if (client.session_.toReturn != Status::Idle) return;
  const AutopilotFinder& finder = client.link_.finder();
  if (finder.isCertain()) {
    // Whatever was seen before loop() stood still may be over. (A loop() that is always slow sees nothing else: it goes
    // on with that, but for what moves the aircraft.)
    if (!client.link_.isCurrent() && (!client.link_.isBlind() || state.isCommanding)) return;
    if (finder.isFrom(client.link_.systemId(), client.link_.componentId())) return end(Status::SameIdsAsAutopilot);
    if (kOnly != Firmware::Unknown && finder.firmware() != kOnly) return end(Status::OtherAutopilot);
    // What comes before this operation has sent anything is no answer to it: so it waits for late answers first. What
    // transfers no plan is not answered by a message of the mission protocol.
    if (!state.isPlanless) {
      if (client.awaitsCopies()) return;
      client.link_.forgetTwoWays();
    }
    state.status = Status::Checking;
    return;
  }
  if (client.session_.waitingLimitS == 0 || state.seconds < client.session_.waitingLimitS) return;
  end(finder.severalHeard() ? Status::SeveralAutopilots : Status::NoAutopilot);
}

void Client::report(uint16_t done) {
  if (done <= state_.itemsDone) return;
  state_.itemsDone = done;
  if (session_.progress != nullptr) session_.progress(session_.progressContext, state_.itemsDone, state_.itemsTotal);
}

void Client::sendAck(uint8_t result, PlanType type) { sendShort(KeyIndex::MISSION_ACK, result, type); }

// MISSION_COUNT, MISSION_REQUEST_INT and MISSION_REQUEST begin with a number, MISSION_REQUEST_LIST, MISSION_CLEAR_ALL
// and MISSION_ACK with the target; after the target MISSION_ACK has its result, and all have the type of the plan.
void Client::sendShort(KeyIndex message, uint16_t number, PlanType type) {
  static_assert(offsetof(mavlink_mission_count_t, mission_type) == 4 && offsetof(mavlink_mission_count_t, count) == 0 &&
                    offsetof(mavlink_mission_request_int_t, mission_type) == 4 &&
                    offsetof(mavlink_mission_request_int_t, seq) == 0 &&
                    offsetof(mavlink_mission_request_list_t, mission_type) == 2 &&
                    offsetof(mavlink_mission_clear_all_t, mission_type) == 2 &&
                    offsetof(mavlink_mission_ack_t, type) == 2 && offsetof(mavlink_mission_ack_t, mission_type) == 3,
                "the short messages must lie as they are made here");
  uint8_t* const payload = static_cast<uint8_t*>(link_.draftToSend());
  memset(payload, 0, sizeof(mavlink_mission_count_t));
  payload[0] = static_cast<uint8_t>(number);
  payload[1] = static_cast<uint8_t>(number >> 8);
  const MessageKey* const key = &kKeys[static_cast<uint8_t>(message)];
  uint8_t* afterTarget = payload + fromFlash(&key->target) + 2;
  if (message == KeyIndex::MISSION_ACK) *afterTarget++ = static_cast<uint8_t>(number);
  *afterTarget = static_cast<uint8_t>(type);
  link_.sendMessage(payload, key);
}

Status MissionClient::update() {
  // Hides from the optimiser which object this is: it would use 4-byte addresses instead of 2-byte offsets.
  MissionClient* client = this;
  asm("" : "+r"(client));
  return client->updateAt(millis());
}

// Work that depends on the clock, but need not be exact to the millisecond.
void Client::onTick(uint16_t nowMs) {
  while (since(state_.secondMs, nowMs) >= 1000) {
    state_.secondMs += 1000;
    ++state_.seconds;
    link_.pace().onSecond();
    if (state_.unsettled >= kOneSecond) state_.unsettled -= kOneSecond;
    const uint16_t limitS = session_.transferLimitS != 0 ? session_.transferLimitS : defaultLimitS(state_.itemsTotal);
    // Its limit does not count while an autopilot is waited for.
    if (state_.status == Status::WaitingForAutopilot) {
      state_.limitFromS = state_.seconds + 1;
    } else if (static_cast<uint16_t>(state_.seconds - state_.limitFromS) >= limitS) {
      state_.isLate = true;
    }
  }
  if (since(state_.unsettledMs, nowMs) >= kLeftoversMs) state_.unsettled &= kOfRepeats;
  link_.onTime(nowMs);
}

// Claims the time for heavy work. False when reading bytes has used up the time of this update(): heavy work then waits
// for the next one, which reads at most half as many.
bool Port::claimHeavyWork() {
  Client::State& state = static_cast<Client&>(*this).state_;
  const bool isAllowed = state.isTimeLeft;
  state.readsHalf = !isAllowed;
  return isAllowed;
}

Status Client::updateAt(uint32_t exactMs) {
  if (state_.atEnd != nullptr) return Status::Busy;  // called from a callback
  const uint16_t nowMs = static_cast<uint16_t>(exactMs);
  link_.look(exactMs);
#if MAVMISSION_SIGNING
  if (link_.workOnSignatures()) {  // nothing else is done then, so that the longest update() is no longer
    link_.flush(nowMs, kStartBytes);
    return state_.operation != nullptr ? state_.status : Status::Idle;
  }
#endif
  state_.atEnd = doNothing;
  FrameParser::Budget budget;
  constexpr uint8_t kAll = MAVMISSION_BYTES_PER_UPDATE, kHalf = kAll / 2;
  const uint8_t allowed = state_.readsHalf ? kHalf : kAll;
  budget.left = allowed;
  state_.isTimeLeft = false;
  while (link_.receive(budget, nowMs)) {
    if (link_.finder().takeChange()) forgetAutopilot();
    if (state_.operation != nullptr) state_.operation(*this, &link_.frame(), nowMs);
    budget.left = budget.left > kFrameBytes ? budget.left - kFrameBytes : 0;
  }
  if (budget.left != 0) link_.noteEmpty(exactMs);
  state_.isTimeLeft = static_cast<uint8_t>(allowed - budget.left) <= kAll - kHalf;
  // Not to an autopilot that is not heard: it would not hear us either.
  if (state_.cancelled != 0 && hasAutopilot() && link_.canSend()) {
    sendAck(MAV_MISSION_OPERATION_CANCELLED, static_cast<PlanType>(state_.cancelled - 1));
    state_.cancelled = 0;
    expectAnswers(kFromBefore);
  }
  if (static_cast<uint16_t>(nowMs ^ state_.tickMs) >= kTickMs) {
    state_.tickMs = nowMs;
    onTick(nowMs);
  }
  if (state_.operation != nullptr) state_.operation(*this, nullptr, nowMs);
  // The rest of the budget of bytes is for those that go out.
  link_.flush(nowMs, budget.left > kStartBytes ? budget.left : kStartBytes);

  state_.atEnd(*this);
  state_.atEnd = nullptr;
  const Status ended = session_.toReturn;
  session_.toReturn = Status::Idle;
  if (ended != Status::Idle) return ended;
  return state_.operation != nullptr ? state_.status : Status::Idle;
}

}  // namespace mavmission
