#include "Referee.h"

using mavmission::Aboard;
using mavmission::StartArming;
using mavmission::Status;

namespace {

constexpr uint32_t kBufferedMs = 20;      // a frame that has begun to leave goes on
constexpr uint32_t kDoubtfulMs = 600;     // targets go on while the mode that was seen may be older than the order
constexpr uint32_t kStepsMs = 9;          // two update()s: a task ends in the one after a heartbeat
constexpr uint32_t kBeatMs = 1100;        // the time between two heartbeats, and that on the line
constexpr uint32_t kTurnedBackMs = 1000;  // nobody turns a switch away and back in this time
constexpr uint32_t kStreamMs = 1200;      // a target may call PX4 back from its failsafe
constexpr uint32_t kLookMs = 400;         // the time to read each item, and from then to the arming
constexpr uint32_t kLostMs = 5000;
constexpr uint32_t kOnTheLineMs = 100;   // what has left before the sketch names another aircraft arrives by then
constexpr uint32_t kLateMs = 1500;       // from the answer that decides to the end of an operation
constexpr uint32_t kPlanShownMs = 4000;  // by then a plan that can be told from ours is detected

bool isDisarming(const mavlink_command_long_t& command) {
  return command.command == MAV_CMD_COMPONENT_ARM_DISARM && command.param1 == 0;
}

// Returns whether this status says that somebody else flies it, as Status::TakenOver does.
bool saysTaken(Status status) {
  return status == Status::TakenOver || status == Status::PilotHasIt || status == Status::FailsafeHasIt;
}

}  // namespace

void Referee::say(const std::string& words) {
  if (log_ != nullptr) *log_ += std::to_string(nowMs_) + " " + name_ + words + "\n";
}

void Referee::breaks(const std::string& rule) {
  if (broken_.empty()) broken_ = rule;
  say("BROKEN: " + rule);
}

void Referee::at(uint32_t nowMs) {
  nowMs_ = nowMs;
  if (nowMs_ - cameMs_ > kLostMs) wasLost_ = true;
  if (!foreign_.is || !foreign_.isUndone || !foreign_.isShown || !isClean_) return;
  if (nowMs_ - foreign_.undoneMs > kGivenBackMs) {
    breaks("an order has undone " + name(foreign_.mode) + ", and it is not set again");
    foreign_.is = false;
  }
}

void Referee::isAsked() {
  say("the sketch asks for the aircraft");
  wasShownDisarmed_ = true;
  // Whatever was shown; and what has just come is read behind that.
  if (foreign_.isShown || (isHeard_ && nowMs_ - cameMs_ < kStepsMs)) foreign_.is = false;
  isKept_ = false;
}

void Referee::isNamed() {
  say("the sketch names this aircraft");
  isNamed_ = true;
  // (What has just come is read behind the naming.)
  wasShownDisarmed_ = isHeard_ && !isShownArmed_ && nowMs_ - cameMs_ < kStepsMs;
  isKept_ = isHeard_ = false;
  wasLost_ = true;
}

void Referee::begins(Task task, double loss, bool isDisturbed, const Autopilot& autopilot) {
  task_ = task;
  isRunning_ = hasBegun_ = true;
  isDisarmed_ = isDisarmedShown_ = false;
  beganMs_ = nowMs_;
  isKnown_ = isHeard_ && nowMs_ - cameMs_ <= kLostMs && cameMs_ >= stoodBlindMs_;
  isArmingShown_ = isShownArmed_ && isHeard_;
  isClean_ = loss <= 0 && !isDisturbed;
  isBad_ = loss > 0.006;
  firstMode_ = autopilot.mode;
  isFirstOver_ = hasOrdered_ = false;
  // These are for a sketch that takes the aircraft in any case.
  const bool takesAnyway = task == Task::SetMode || task == Task::StartMission;
  if (!autopilot.isArmed || takesAnyway) foreign_ = Foreign();
  wasForeign_ = foreign_.is;
  isArmed_ = autopilot.isArmed;
  wasArmedByUs_ = false;
  say(std::string("the sketch begins ") + kTaskNames[static_cast<int>(task)]);
}

void Referee::take(uint16_t mode, uint16_t before) {
  const bool isOnGround = isStart(task_) || task_ == Task::TakeOff;
  figures_.hasTaken = true;
  takenMs_ = nowMs_;
  // (What it was before it was heard, the sketch cannot know.)
  const bool isKnown = isKnown_ && nowMs_ - cameMs_ <= kLostMs;
  const bool takesAnyway = task_ == Task::SetMode || task_ == Task::StartMission;
  if ((!isArmed_ && !(isRunning_ && isOnGround)) || (!isKnown && isRunning_ && (isOnGround || takesAnyway))) {
    foreign_.is = false;  // whoever had set a mode has set another one, or the same again
    return;
  }
  // It is the mode in which the order began, and no heartbeat has shown another one; or it is the mode that an order
  // has just set, with somebody's other mode between, or is on its way to set: nobody can tell who set it
  // (docs/in_control.md).
  const bool isTurnedBack = foreign_.is && mode == orderedMode_ && nowMs_ - orderedMs_ < kTurnedBackMs;
  // (What a sketch sets in any case is its own, whoever was first; so is the mode in which it pauses.)
  // (At the top of its takeoff PX4 sets HOLD by itself.)
  const bool isTop = !isRunning_ && kind_ == Kind::Px4 && before == modeOf(kind_, Means::TakeOff) &&
                     mode == modeOf(kind_, Means::Hold);
  const bool isSame = isRunning_ && ((mode == orderedMode_ && orderedMs_ >= beganMs_) ||
                                     ((takesAnyway || task_ == Task::Pause) && mode == modeWanted(kind_, task_)));
  if ((isRunning_ && mode == firstMode_ && !isFirstOver_) || isTurnedBack || isSame || isTop ||
      (mode == shownMode_ && !(foreign_.is && foreign_.isShown))) {
    foreign_.is = false;
    return;
  }
  foreign_ = Foreign();
  foreign_.is = true;
  foreign_.mode = mode;
  foreign_.sinceMs = nowMs_;
}

void Referee::obeys(const std::string& what) {
  if (!hasBegun_ && nowMs_ >= leftMs_ + kOnTheLineMs)
    breaks(what + " is taken by an aircraft for which nothing was begun");
}

void Referee::modeSet(uint16_t mode, By by) {
  const char* const who = by == By::Order ? "an order" : by == By::Actor ? "somebody" : "the autopilot";
  say(std::string(who) + " sets " + name(mode));
  const uint16_t before = mode_;
  mode_ = mode;
  isModeOurs_ = by == By::Order && !isStart(task_) && nowMs_ - cancelledMs_ > kOnTheLineMs;
  if (by == By::Order) obeys("a mode");
  if (by == By::Order) wasLost_ = false;
  // PX4's failsafe counts as somebody else; the end of its takeoff does not.
  if (by == By::Actor) return take(mode, before);
  if (by == By::Itself && mode == modeOf(kind_, Means::Return)) {
    take(mode, before);
    foreign_.isOfStream = true;
    return;
  }
  if (by == By::Itself || !foreign_.is) return;
  if (mode == foreign_.mode) {
    if (!foreign_.isUndone) return;
    foreign_.isUndone = false;
    const uint32_t undoneMs = nowMs_ - foreign_.undoneMs;
    // Nobody can know of a mode that no heartbeat has shown: so much later the order is the sketch's own.
    if (!foreign_.isShown && undoneMs > kGivenBackLossyMs) foreign_.is = false;
    if (foreign_.isShown) figures_.undoneMs.push_back(undoneMs);
    if (foreign_.isShown && undoneMs > figures_.longestUndoneMs) figures_.longestUndoneMs = undoneMs;
    const uint32_t stoodMs = foreign_.undoneMs < stoodStillMs_ ? stoodStillMs_ - foreign_.undoneMs : 0;
    if (foreign_.isShown && !isBad_ && undoneMs > kGivenBackLossyMs + stoodMs)
      breaks("it is set again too late: " + name(mode));
    return;
  }
  if (foreign_.isUndone) return;
  const uint32_t windowMs = nowMs_ - foreign_.sinceMs;
  // A target was sent before a heartbeat had told of the failsafe: see docs/in_control.md.
  const bool mayBeUnseen = windowMs < kStreamMs || isBad_;
  const bool wasShown = foreign_.isShown && nowMs_ - foreign_.shownMs > kBufferedMs;
  if (foreign_.isOfStream && mode == modeOf(kind_, Means::Offboard) && !wasShown && mayBeUnseen) {
    foreign_.is = false;
    return;
  }
  if (windowMs > figures_.longestWindowMs) figures_.longestWindowMs = windowMs;
  if (windowMs > kWindowMs) {
    breaks("an order undoes " + name(foreign_.mode) + ", which was set " + std::to_string(windowMs) + " ms before");
  }
  foreign_.isUndone = true;
  foreign_.undoneMs = nowMs_;
}

void Referee::armed(bool isArmed, By by) {
  say(std::string("it is ") + (isArmed ? "armed" : "disarmed"));
  if (by == By::Order) obeys("an arming");
  if (by == By::Actor && !isArmed) {
    isDisarmed_ = isRunning_;
    wasDisarmed_ = true;
  }
  isArmed_ = isArmed;
  armedMs_ = nowMs_;
  if (isArmed) wasArmedMs_ = nowMs_;
  if (isArmed && by == By::Itself) wasLost_ = true;  // whoever has set its mode, it was not the sketch
  wasArmedByUs_ = isArmed && by == By::Order;
  if (wasArmedByUs_ && task_ == Task::VerifyAndStart && !isOurPlan_ && isClean_ && nowMs_ - otherPlanMs_ > kLookMs) {
    breaks("it is armed " + std::to_string(nowMs_ - otherPlanMs_) + " ms behind another plan");
  }
  if (!isArmed || by == By::Itself) foreign_.is = isModeOurs_ = false;
}

void Referee::planSet(bool isOurs, By by) {
  if (by == By::Order) obeys("a plan");
  say(isOurs ? "our plan is aboard" : "another plan is aboard");
  isOurPlan_ = isOurs;
  if (isOurs) wasOurPlan_ = true;
  otherNamed_ = 0;
  if (!isOurs) otherPlanMs_ = nowMs_;
}

void Referee::comes(const FrameParts& message, uint32_t sentMs) {
  // ArduPilot tells only how long its plan is.
  if (message.messageId == MAVLINK_MSG_ID_MISSION_CURRENT && !isOurPlan_ && sentMs > otherPlanMs_ &&
      otherNamed_ != 255) {
    if (kind_ == Kind::Px4 || messageIn<mavlink_mission_current_t>(message.payload).total != kItems) ++otherNamed_;
  }
  if (message.messageId == MAVLINK_MSG_ID_COMMAND_ACK) {
    const mavlink_command_ack_t ack = messageIn<mavlink_command_ack_t>(message.payload);
    const bool arms =
        ack.command == MAV_CMD_COMPONENT_ARM_DISARM || (ack.command == MAV_CMD_MISSION_START && kind_ == Kind::Px4);
    if (arms && ack.result == MAV_RESULT_ACCEPTED) isArmingShown_ = true;
  }
  if (message.messageId != MAVLINK_MSG_ID_HEARTBEAT) return;
  const mavlink_heartbeat_t beat = messageIn<mavlink_heartbeat_t>(message.payload);
  // (A look at the items ends with an item, whatever heartbeat has just come and is not read yet.)
  const bool isBefore = nowMs_ - cameMs_ < kStepsMs || task_ == Task::VerifyAndStart;
  shownBefore_ = isBefore ? shownMode_ : kNoSuchMode;
  wasShownArmedBefore_ = isBefore && isShownArmed_;
  cameMs_ = nowMs_;
  shownMode_ = static_cast<uint16_t>(kind_ == Kind::Px4 ? beat.custom_mode >> 16 : beat.custom_mode);
  isShownArmed_ = (beat.base_mode & MAV_MODE_FLAG_SAFETY_ARMED) != 0;
  if (!isShownArmed_) wasShownDisarmed_ = true;
  if (isShownArmed_) isArmingShown_ = true;
  if (!isShownArmed_ && isDisarmed_ && isArmingShown_ && sentMs > armedMs_) isDisarmedShown_ = true;
  shownMs_ = sentMs;
  isHeard_ = true;
  if (nowMs_ >= stoodBlindMs_) isKnown_ = true;
  say("a heartbeat of " + std::to_string(sentMs) + " shows " + name(shownMode_) + (isShownArmed_ ? ", armed" : ""));
  if (shownMode_ != firstMode_ && hasOrdered_) isFirstOver_ = true;
  if (!foreign_.is) return;
  if (sentMs < foreign_.sinceMs || shownMode_ != foreign_.mode || foreign_.isShown) return;
  foreign_.isShown = true;
  foreign_.shownMs = nowMs_;
}

// What must hold whatever the task is, for a frame that is addressed to it.
void Referee::judge(const FrameParts& message, bool isArming, bool isOrder) {
  const uint16_t command = messageIn<mavlink_command_long_t>(message.payload).command;
  const bool isQuestion = message.messageId == MAVLINK_MSG_ID_COMMAND_LONG &&
                          (command == MAV_CMD_REQUEST_MESSAGE || command == MAV_CMD_SET_MESSAGE_INTERVAL);
  const auto leaves = [&](const char* how) {
    breaks("message " + std::to_string(message.messageId) + " (" + std::to_string(command) + ") leaves " + how);
  };
  if (!hasBegun_ && !(isNamed_ && isQuestion)) return leaves("to an aircraft for which nothing was begun");
  const bool isTarget = message.messageId == MAVLINK_MSG_ID_SET_POSITION_TARGET_GLOBAL_INT;
  if (isOrder && cameMs_ < (isTarget ? stoodBlindMs_ : stoodStillMs_))
    leaves("with no heartbeat since loop() stood still");
  const bool isSteered = isStart(task_) || (task_ >= Task::TakeOff && task_ <= Task::Follow);
  if (isOrder && isSteered && isShownArmed_ && !wasShownDisarmed_)
    leaves("to an aircraft that was armed when it was named");
  if (isArming && isDisarmedShown_) leaves("behind a heartbeat that shows it disarmed by somebody");
  if (isArming && isKept_) leaves("though somebody has taken the aircraft");
}

bool Referee::leaves(const FrameParts& message) {
  const mavlink_command_long_t command = messageIn<mavlink_command_long_t>(message.payload);
  const bool isCommand =
      message.messageId == MAVLINK_MSG_ID_COMMAND_LONG || message.messageId == MAVLINK_MSG_ID_COMMAND_INT;
  const bool isTarget = message.messageId == MAVLINK_MSG_ID_SET_POSITION_TARGET_GLOBAL_INT;
  const bool isHarmless = !isCommand || command.command == MAV_CMD_REQUEST_MESSAGE ||
                          command.command == MAV_CMD_SET_MESSAGE_INTERVAL ||
                          command.command == MAV_CMD_DO_VTOL_TRANSITION || isDisarming(command);
  if (log_ != nullptr) {
    say(isCommand ? "the sketch sends command " + std::to_string(command.command) + "(" +
                        std::to_string(static_cast<int>(command.param1)) + ", " +
                        std::to_string(static_cast<int>(command.param2)) + ")"
                  : "the sketch sends message " + std::to_string(message.messageId));
  }
  const bool isArming = isCommand && (command.command == MAV_CMD_NAV_TAKEOFF ||
                                      (command.command == MAV_CMD_COMPONENT_ARM_DISARM && command.param1 == 1) ||
                                      (command.command == MAV_CMD_MISSION_START && kind_ == Kind::Px4));
  judge(message, isArming, !isHarmless || isTarget || (isCommand && isDisarming(command)));
  if (!isHarmless) hasOrdered_ = true;
  const uint32_t ordered = static_cast<uint32_t>(command.param2) | static_cast<uint32_t>(command.param3) << 8;
  const bool isPlace = isCommand && command.command == MAV_CMD_DO_REPOSITION;
  if (isPlace || (isCommand && command.command == MAV_CMD_DO_SET_MODE)) {
    orderedMode_ = isPlace ? modeWanted(kind_, Task::GoTo) : static_cast<uint16_t>(ordered);
    // Somebody has set the same before, and no heartbeat has shown it: nobody can tell who it was.
    if (orderedMode_ == foreign_.mode && !foreign_.isShown) foreign_.is = false;
    orderedMs_ = nowMs_;
  }
  if (message.messageId == MAVLINK_MSG_ID_MISSION_REQUEST_LIST) listedMs_ = nowMs_;
  if (task_ == Task::Arm) return !isHarmless;  // this task arms in any mode
  if ((isHarmless && !isTarget) || !foreign_.is || !foreign_.isShown) return !isHarmless;
  if (nowMs_ - foreign_.shownMs < (isTarget ? kDoubtfulMs : kBufferedMs)) return !isHarmless;
  if (command.command == MAV_CMD_DO_SET_MODE && ordered == foreign_.mode) return !isHarmless;
  breaks(isTarget ? "a target leaves behind a heartbeat that shows " + name(foreign_.mode)
                  : "command " + std::to_string(command.command) + " leaves behind a heartbeat that shows " +
                        name(foreign_.mode));
  return !isHarmless;
}

void Referee::ends(Status status, const Sketch& sketch, const Autopilot& autopilot) {
  isRunning_ = false;
  say(std::string("it ends: ") + mavmission::toString(status));
  const std::string words =
      std::string(kTaskNames[static_cast<int>(task_)]) + " ends with \"" + mavmission::toString(status) + "\", and ";
  const uint16_t wanted = modeWanted(kind_, task_);
  const bool isDone = status == Status::Done;
  // PX4 goes over to HOLD at the top of a takeoff.
  const bool isHold = kind_ == Kind::Px4 && shownMode_ == modeOf(kind_, Means::Hold);
  const bool isTop = task_ == Task::TakeOff && isHold;
  // A MovingTarget tells its end a turn of loop() later, before anything is read that came while loop() stood still.
  const bool isUnread = task_ == Task::Follow && nowMs_ - stoodStillMs_ < kStepsMs;
  const bool isShown = isUnread || shownMode_ == wanted || (shownBefore_ == wanted && nowMs_ - cameMs_ < kStepsMs);
  if (isDone && wanted != kNoSuchMode && !isShown && !isTop) {
    breaks(words + "the last heartbeat has shown " + name(shownMode_));
  }
  const bool isToArm = task_ == Task::Arm || isStart(task_) || task_ == Task::TakeOff;
  const bool wasShownArmed = isShownArmed_ || (wasShownArmedBefore_ && nowMs_ - cameMs_ < kStepsMs);
  if (isDone && isToArm && !wasShownArmed) breaks(words + "the last heartbeat has shown it disarmed");
  if (isDone && isToArm && !sketch.client.isArmed() && isShownArmed_) breaks(words + "isArmed() is false");
  if (isDone && task_ == Task::Disarm && sketch.client.isArmed()) breaks(words + "isArmed() is true");
  // (start() ends with a MISSION_CURRENT, which tells too that the mission is flown.)
  const bool isLateTold = !isClean_ && (isStart(task_) || task_ == Task::Follow);
  if (isDone && nowMs_ - shownMs_ > kBeatMs && !isLateTold) breaks(words + "the last heartbeat is old");
  // (Who disarms it has it, whoever arms it then; and a mode counts as the sketch's when its order has ended.)
  const bool isOurs = isModeOurs_ || mode_ == modeOf(kind_, Means::Mission);
  if (status == Status::Cancelled) {
    isModeOurs_ = false;
    cancelledMs_ = nowMs_;
  }
  if (saysTaken(status) && isOurs && !foreign_.is && autopilot.isArmed && !figures_.hasTaken && !wasDisarmed_ &&
      !wasLost_ && !isHold) {
    breaks(words + "nobody has taken it");
  }
  // PX4's HOLD at the top of its takeoff, where no position has shown it: it stays somebody's until it is asked for.
  if (saysTaken(status) && isHold) figures_.hasTaken = true;
  const bool isOver = figures_.hasTaken && !wasLost_ && takenMs_ >= beganMs_ && !wasForeign_
                          ? saysTaken(status) || (isStart(task_) && status == Status::Overruled)
                          : isDisarmed_ && isStart(task_) && status == Status::NotArmed;
  if (isOver && (task_ <= Task::Follow || isStart(task_))) isKept_ = true;
  if (sketch.client.aboard() == Aboard::OurPlan && !wasOurPlan_) breaks(words + "aboard() is of another aircraft");
  // Nor can the sketch know what came while its loop() stood still, with the answer in its receive buffer.
  const bool isRecent =
      nowMs_ - otherPlanMs_ < kLateMs + (nowMs_ < stoodStillMs_ + kLateMs ? nowMs_ - stoodFromMs_ : 0);
  if (status == Status::Accepted && !isRecent && (!isOurPlan_ || autopilot.plan.size() != kItems)) {
    breaks(words + "another plan is aboard");
  }
  if (status == Status::Cleared && !isRecent && !autopilot.plan.empty()) breaks(words + "a plan is aboard");
  if (isDone && isStart(task_)) {
    if (sketch.client.aboard() != Aboard::OurPlan) breaks(words + "aboard() is not our plan");
    const bool isTold = kind_ == Kind::Px4 || autopilot.plan.size() != kItems;
    if (!isOurPlan_ && isTold && isClean_ && nowMs_ - otherPlanMs_ > kPlanShownMs) {
      breaks(words + "another plan has been flown for long");
    }
    if (otherNamed_ > 1) breaks(words + "it has named another plan");
    // ArduPilot does not tell that its plan is another one, if it is as long: the items must have been looked at.
    if (task_ == Task::VerifyAndStart && kind_ != Kind::Px4) {
      if (listedMs_ < wasArmedMs_) breaks(words + "nothing has looked at the items since it was armed");
      if (!isOurPlan_ && otherPlanMs_ < listedMs_) breaks(words + "another plan was there before the look");
    }
  }
}

void Referee::restsAfterMany(const Sketch& sketch, const Autopilot& autopilot) {
  if (sketch.client.hasAutopilot() && nowMs_ - armedMs_ > kBeatMs && sketch.client.isArmed() != autopilot.isArmed) {
    breaks("at the end isArmed() is not so");
  }
}

void Referee::rests(const Sketch& sketch, const Autopilot& autopilot) {
  const std::string words = std::string("behind ") + kTaskNames[static_cast<int>(task_)] + " (" +
                            mavmission::toString(sketch.status()) + ") ";
  if (foreign_.is && foreign_.isUndone) {
    if (foreign_.isShown && sketch.status() != Status::Overruled) {
      breaks(words + "an order has undone " + name(foreign_.mode) + " for good");
    } else {
      figures_.isUnseen = true;
    }
  }
  const bool hasIt = foreign_.is && !foreign_.isUndone && nowMs_ - foreign_.sinceMs > kBeatMs;
  // (PX4 flies HOLD at the end of its mission, too.)
  if (hasIt && isInAir(task_) && !(kind_ == Kind::Px4 && foreign_.mode == modeOf(kind_, Means::Hold))) isKept_ = true;
  // Near the top of its takeoff PX4 goes over to HOLD by itself: there a pilot's HOLD cannot be told.
  const bool isHold = kind_ == Kind::Px4 && shownMode_ == modeOf(kind_, Means::Hold);
  const bool isTop = task_ == Task::TakeOff && foreign_.mode == modeOf(kind_, Means::Hold);
  if (hasIt && !isTop && sketch.steering.maySteer()) breaks(words + "maySteer() is true in " + name(foreign_.mode));
  if (sketch.client.takenBy() != Status::Idle && !figures_.hasTaken && !wasDisarmed_ && !wasLost_ && !isHold) {
    breaks(words + "takenBy() says that somebody has taken it, and nobody has");
  }
  const bool isLong = nowMs_ - armedMs_ > kBeatMs;
  if (isLong && sketch.client.isArmed() != autopilot.isArmed) breaks(words + "isArmed() is not so");
  const bool isTold = kind_ == Kind::Px4 || autopilot.plan.size() != kItems;
  if (!isOurPlan_ && isTold && sketch.client.aboard() == Aboard::OurPlan && nowMs_ - otherPlanMs_ > kPlanShownMs) {
    breaks(words + "aboard() is our plan, and another one is there");
  }
  // (One damaged frame of 65536 has the right checksum: such a heartbeat is another autopilot's.)
  if (isOurPlan_ && sketch.client.aboard() != Aboard::OurPlan && !isBad_)
    breaks(words + "our plan is aboard, and aboard() denies it");
  const bool isFailed = (isStart(task_) || task_ == Task::TakeOff) && sketch.status() != Status::Done;
  // If somebody has set the earlier mode again, the aircraft is his in that mode.
  const bool isHis = foreign_.is || (figures_.hasTaken && saysTaken(sketch.status()));
  if (isFailed && !wasLost_ && wasArmedByUs_ && autopilot.isArmed && !autopilot.isAirborne() && !isHis &&
      autopilot.mode != modeOf(kind_, Means::Mission)) {
    breaks(words + "it stands armed");
  }
  const StartArming arming = sketch.client.startArming();
  if (isStart(task_) && arming == StartArming::Disarmed && autopilot.isArmed) {
    breaks(words + "startArming() says disarmed, and it is armed");
  }
}
