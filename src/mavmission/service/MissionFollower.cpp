#include "MissionFollower.h"

#include <Arduino.h>
#include <string.h>

#include "../base/Clock.h"
#include "../base/Flash.h"
#include "../client/Port.h"
#include "../link/Messages.h"

namespace mavmission {
using namespace detail;
namespace {

constexpr float kIntervalUs = 1000000;

const MessageKey kFollowed[] PROGMEM = {
    MAVMISSION_LISTENER_KEY(HEARTBEAT),       MAVMISSION_LISTENER_KEY(MISSION_COUNT),
    MAVMISSION_LISTENER_KEY(COMMAND_ACK),     MAVMISSION_LISTENER_KEY(MISSION_ACK),
    MAVMISSION_LISTENER_KEY(MISSION_CURRENT), MAVMISSION_LISTENER_KEY(MISSION_ITEM_REACHED),
    MAVMISSION_LISTENER_KEY(STATUSTEXT),
};

const char kRejected[] PROGMEM = "Mission rejected";

// How ArduPilot's texts at the end of an upload begin: "Flight plan received", "Mission upload timeout". They go to the
// line of the station that has uploaded, and nowhere else: so these are ours, or of a station on our line.
const char kReceived[] PROGMEM = "Flight pl";
const char kBrokenOff[] PROGMEM = "Mission up";

}  // namespace

MissionFollower::MissionFollower(MissionClient& client)
    : MessageIntervals(client, kFollowed, sizeof(kFollowed) / sizeof(kFollowed[0]), take),
      isDoubted_(false),
      wasArmed_(false),
      hasJumped_(false),
      isReachedBefore_(false) {}

void MissionFollower::onCurrent(ItemNumberFunction function, void* context) {
  currentFunction_ = function;
  currentContext_ = context;
}

void MissionFollower::onReached(ItemNumberFunction function, void* context) {
  reachedFunction_ = function;
  reachedContext_ = context;
}

void MissionFollower::onText(TextFunction function, void* context) {
  textFunction_ = function;
  textContext_ = context;
}

void MissionFollower::take(Listener& listener, const FrameParser& frame) {
  MissionFollower& self = static_cast<MissionFollower&>(listener);
  if (!self.isFromAutopilot(frame)) return;
  switch (frame.messageId()) {
    case MAVLINK_MSG_ID_HEARTBEAT: return self.takeHeartbeat();
    case MAVLINK_MSG_ID_COMMAND_ACK:
      if (self.isAnswer(frame)) self.settle();
      return;
    case MAVLINK_MSG_ID_MISSION_COUNT: {
      typedef mavlink_mission_count_t Count;
      if (frame.payloadByte(offsetof(Count, mission_type)) != MAV_MISSION_TYPE_MISSION) return;
      return self.takeName(frame.payloadLong(offsetof(Count, opaque_id)));
    }
    case MAVLINK_MSG_ID_MISSION_ACK: {
      typedef mavlink_mission_ack_t Ack;
      if (frame.payloadByte(offsetof(Ack, type)) != MAV_MISSION_ACCEPTED) return;
      if (frame.payloadByte(offsetof(Ack, mission_type)) != MAV_MISSION_TYPE_MISSION) return;
      self.takeAcceptance(frame);
      return self.takeName(frame.payloadLong(offsetof(Ack, opaque_id)));
    }
    case MAVLINK_MSG_ID_MISSION_CURRENT: return self.takeCurrent(frame);
    case MAVLINK_MSG_ID_MISSION_ITEM_REACHED: return self.takeReached(frame);
    default: return self.takeText(frame);
  }
}

// Requests MISSION_CURRENT when none has come for a while. Success is a MISSION_CURRENT, and not the answer to the
// request: PX4 refuses the request, and sends the message anyway.
void MissionFollower::takeHeartbeat() {
  const bool isArmed = client_.autopilot().isArmed();
  if (isArmed && !wasArmed_) isReachedBefore_ = true;
  wasArmed_ = isArmed;
  const uint16_t nowMs = static_cast<uint16_t>(millis());
  giveUpWaiting(nowMs);
  if (textDue_ != 0) --textDue_;
  if (heartbeatsLeft_ != 0) --heartbeatsLeft_;
  // Heartbeats that an order asks for come sooner than once a second. Of two requests the second answer would be taken
  // for one to a command of the client's.
  if (heartbeatsLeft_ != 0 || isWaiting() || !mayAsk(nowMs) || !client_.link().canSend()) return;
  ask(MAVLINK_MSG_ID_MISSION_CURRENT, kIntervalUs, 0, nowMs);
  heartbeatsLeft_ = pause_;
  if (pause_ < FollowRules::kLongestPause) pause_ *= 2;
}

// The answer to an upload or a download of a mission names the plan aboard.
void MissionFollower::takeName(uint32_t planId) {
  if (planId == 0) return;
  planId_ = planId;
  isDoubted_ = false;
  patience_ = FollowRules::kPatience;
  client_.noteMissionName(planId_);
}

// The acceptance of a mission of ours, about which ArduPilot's text is still to come. One for another ground station
// tells nothing: ArduPilot also accepts the item with which a station orders it to fly somewhere now.
void MissionFollower::takeAcceptance(const FrameParser& frame) {
  if (!has(client_.autopilot().firmware(), kSaysUploadsInWords)) return;
  if (!frame.isFor(client_.link().systemId(), client_.link().componentId())) return;
  patience_ = FollowRules::kPatience;
  textDue_ = FollowRules::kText;
}

void MissionFollower::takeCurrent(const FrameParser& frame) {
  heartbeatsLeft_ = FollowRules::kSilence;
  pause_ = FollowRules::kFirstPause;
  mavlink_mission_current_t message;
  frame.copyPayload(&message, sizeof(message));
  const uint16_t item = client_.itemFromWire(message.seq);
  const uint16_t total = message.total == 0xFFFF ? 0 : message.total;
  // What is older than our plan has the total of before. Another one is somebody else's: it is believed when it comes
  // twice.
  if (patience_ > 1 && total != total_) patience_ = 1;
  total_ = total;
  const bool wasUnderWay = state_ == MissionState::Active && client_.autopilot().isArmed();
  state_ = static_cast<MissionState>(message.mission_state);
  const uint32_t planId = message.mission_id;
  const bool isNew = planId != planId_;
  bool isDoubted = false;
  if (isNew && patience_ != 0 && planId_ == client_.acceptedPlanId()) {
    --patience_;
  } else {
    planId_ = planId;
    client_.noteMissionName(planId);
    if (planId == 0 && client_.namesOther(frame)) {
      if (patience_ == 0) client_.noteOtherMission();
      if (patience_ != 0) --patience_;  // the message may be older than the acceptance of our plan
    } else {
      patience_ = planId == 0 ? 1 : 0;  // a total is no name: two messages must have the same
    }
    // PX4 checks a plan after it has accepted it, and reports no mission until then too: only the second report counts.
    isDoubted = planId != 0 && state_ == MissionState::NoMission && isOurPlan();
    if (isDoubted && isDoubted_ && !isNew) client_.noteInfeasible();
  }
  isDoubted_ = isDoubted;
  // After the last item there is none that would become the current one.
  if (!wasUnderWay) hasJumped_ = false;
  if (wasUnderWay && state_ == MissionState::Complete) tellUpTo(total_, current_);
  const uint16_t left = current_;
  if (item == left) return;
  current_ = item;
  if (item == Port::kNoItem) {
    next_ = 0;
    return;
  }
  // An item of which it was told before it was the current one is not flown again.
  const bool isSame = item == reached_ && leg_ == Leg::Early;
  if (item >= reached_) {
    if (leg_ == Leg::Early) {
      leg_ = Leg::Flown;
    } else if (item == reached_) {
      leg_ = Leg::Again;
    }
  }
  // What it has left behind in flight it has reached, unless the client's own operation makes it go elsewhere.
  const bool isOrdered = client_.running() != Status::Idle && !client_.hasItems();
  if (wasUnderWay && !isOrdered) {
    if (item < left && left != Port::kNoItem) hasJumped_ = true;
    tellUpTo(item, left);
  }
  if (!isSame) next_ = item;
  if (currentFunction_ != nullptr) currentFunction_(currentContext_, item);
}

void MissionFollower::takeReached(const FrameParser& frame) {
  const uint16_t item = client_.itemFromWire(frame.payloadWord(offsetof(mavlink_mission_item_reached_t, seq)));
  // PX4 repeats the message every second while it stays at the item.
  if (item == Port::kNoItem || (item == reached_ && leg_ != Leg::Again)) return;
  if (state_ == MissionState::Active && client_.autopilot().isArmed() && current_ != Port::kNoItem)
    tellUpTo(item, current_);
  tell(item);
}

// Each item before this one of which nothing was told, although it is behind: ArduPilot tells of each once, and PX4
// only of the last of a waypoint and the commands after it. More of them at once are no flight, but a jump.
// Where the plan has jumped back, the items between may never be flown: then it is told of the one that was left alone.
void MissionFollower::tellUpTo(uint16_t end, uint16_t left) {
  if (end > next_ + FollowRules::kMostBehind) return;
  if (hasJumped_) {
    if (next_ <= left && left < end) tell(left);
    return;
  }
  while (next_ < end) tell(next_);
}

void MissionFollower::tell(uint16_t item) {
  reached_ = item;
  isReachedBefore_ = false;
  next_ = static_cast<uint16_t>(item + 1);
  leg_ = static_cast<uint16_t>(current_ + 1) <= item ? Leg::Early : Leg::Flown;  // or none is current yet
  if (reachedFunction_ != nullptr) reachedFunction_(reachedContext_, item);
}

void MissionFollower::takeText(const FrameParser& frame) {
  typedef mavlink_statustext_t Text;
  constexpr uint8_t kEnd = offsetof(Text, text) + sizeof(Text::text);
  static_assert(kEnd < sizeof(Text), "a text is ended where it lies");
  char message[sizeof(Text)];
  frame.copyPayload(message, sizeof(message));
  message[kEnd] = 0;
  const char* const text = message + offsetof(Text, text);
  // PX4 accepts a plan first and checks it afterwards.
  if (has(client_.autopilot().firmware(), kRejectsInWords) && strncmp_P(text, kRejected, sizeof(kRejected) - 1) == 0) {
    client_.noteInfeasible();
  }
  takePlanText(text);
  if (textFunction_ != nullptr)
    textFunction_(textContext_, static_cast<uint8_t>(message[offsetof(Text, severity)]), text);
}

// ArduPilot says in words that an upload has ended. One such text belongs to each upload of ours.
void MissionFollower::takePlanText(const char* text) {
  if (!has(client_.autopilot().firmware(), kSaysUploadsInWords)) return;
  if (strncmp_P(text, kReceived, sizeof(kReceived) - 1) != 0 &&
      strncmp_P(text, kBrokenOff, sizeof(kBrokenOff) - 1) != 0)
    return;
  const bool isDue = textDue_ != 0;
  textDue_ = 0;
  // A transfer of ours decides by itself what is aboard. (Commands have no items.)
  const bool isTransferring = client_.running() != Status::Idle && client_.hasItems();
  if (!isDue && !isTransferring) client_.noteOtherMission();
}

bool MissionFollower::isOurPlan() const { return client_.isOurMission(); }

}  // namespace mavmission
