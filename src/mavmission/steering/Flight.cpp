#include "Flight.h"

#include <Arduino.h>

#include "../autopilot/VehicleKind.h"
#include "../base/Flash.h"
#include "../client/CommandPort.h"
#include "../link/Messages.h"

namespace mavmission {
using namespace detail;
namespace {

const MessageKey kFlown[] PROGMEM = {
    MAVMISSION_LISTENER_KEY(HEARTBEAT),
    MAVMISSION_LISTENER_KEY(MISSION_CURRENT),
    MAVMISSION_LISTENER_KEY(STATUSTEXT),
};

constexpr int32_t kIntervalUs = 1000000;  // of MISSION_CURRENT

// Commands that fly somewhere, or wait; what is no such command is carried out on the way (MAV_CMD).
constexpr bool isFlown(uint16_t command) { return command >= MAV_CMD_NAV_WAYPOINT && command < MAV_CMD_NAV_LAST; }
constexpr bool isLanding(uint16_t command) {
  return command == MAV_CMD_NAV_LAND || command == MAV_CMD_NAV_VTOL_LAND || command == MAV_CMD_NAV_RETURN_TO_LAUNCH;
}

constexpr uint16_t kNearCm = 300;
constexpr uint8_t kSlowCmS = 100;
constexpr uint16_t kFreshMs = 3000;  // an older position does not say where it is

}  // namespace

Flight::Flight(MissionClient& client)
    : Listener(client, kFlown, sizeof(kFlown) / sizeof(kFlown[0]), take), autopilot_(client), stages_() {
  reason_[0] = reason_[sizeof(reason_) - 1] = 0;
  ways_ = nullptr;
  lookForStop_ = nullptr;
  beginPlan_ = nullptr;
  position_ = nullptr;
  plan_ = emptyPlan();
  place_ = LatLon();
  item_ = stop_ = last_ = MissionClient::kNoItem;
  beatsLeft_ = 0;
  isSteered_ = comesDown_ = isOnTheWay_ = isAsked_ = isBeat_ = wantsReason_ = hasBegun_ = false;
  isAtEnd_ = isComplete_ = isDoubted_ = isOtherPlan_ = isStop_ = returns_ = false;
}

Flight::Flight(MissionClient& client, const PositionListener& position) : Flight(client) {
  position_ = &position;
  lookForStop_ = lookForStop;
}

// --- What the sketch calls

Status Flight::beginWith(FlightOrder first) {
  stages_.setNow(millis());
  const Status status = stages_.begin(first);
  if (status != Status::Transferring) return status;
  isSteered_ = comesDown_ = isOnTheWay_ = isAsked_ = hasBegun_ = isAtEnd_ = isComplete_ = isDoubted_ = isOtherPlan_ =
      false;
  item_ = stop_ = MissionClient::kNoItem;
  reason_[0] = 0;
  return status;
}

Status Flight::fly(const ItemSource& plan) {
  const Status status = beginWith(FlightOrder::Upload);
  if (status != Status::Transferring) return status;
  plan_ = plan;
  beginPlan_ = beginPlan;
  return status;
}

void Flight::begin() {
  stages_.setNow(millis());
  if (state() == FlightState::Ended) client_.noteTaken(Status::Idle);
  stages_.forget();
  isAsked_ = state() == FlightState::Idle;
}

void Flight::giveUp() {
  stages_.setNow(millis());
  stages_.giveUp(FlightOrder::None);
}

bool Flight::goOn() {
  if (stop() == MissionClient::kNoItem || isSteered_ || autopilot_.isBusy()) return false;
  autopilot_.setCurrentItem(static_cast<uint16_t>(stop_ + 1));
  return true;
}

uint32_t Flight::inStateMs() const { return stages_.inStateMs(millis()); }

bool Flight::update() {
  isAsked_ = false;  // what a person has asked for is done at once, or not at all
  autopilot_.update();
  stages_.setNow(millis());
  const bool hasEnded = stages_.running() != FlightOrder::None && !autopilot_.isBusy();
  if (lookForStop_ != nullptr && stages_.isInFlight()) lookForStop_(*this);
  // What it needs to know of the aircraft changes with a heartbeat, with the end of an operation, or by silence.
  if (hasEnded || isBeat_ || !client_.autopilot().isFound()) look(hasEnded);
  if (autopilot_.isBusy()) return stages_.takeNews();
  const FlightOrder order = stages_.due(client_.autopilot().isFound());
  if (order == FlightOrder::None) {
    // By an operation, which is repeated until it is answered: without MISSION_CURRENT a landing looks like a pilot's.
    if (stages_.isInFlight() && !isSteered_ && beatsLeft_ == 0) {
      autopilot_.setMessageInterval(MAVLINK_MSG_ID_MISSION_CURRENT, kIntervalUs);
      beatsLeft_ = kSilence;
    }
  } else {
    stages_.begun(client_.commands().shownMode());
    if (order == FlightOrder::Start || order == FlightOrder::TakeOff) wantsReason_ = true;
    if (isOfPlan(order)) {
      beginPlan_(*this, order);
    } else {
      ways_->begin(*this, order);
    }
  }
  return stages_.takeNews();
}

// --- What is heard

void Flight::take(Listener& listener, const FrameParser& frame) {
  Flight& self = static_cast<Flight&>(listener);
  if (!self.isFromAutopilot(frame)) return;
  switch (frame.messageId()) {
    case MAVLINK_MSG_ID_HEARTBEAT: return self.takeHeartbeat();
    case MAVLINK_MSG_ID_MISSION_CURRENT: return self.takeCurrent(frame);
    default: return self.takeText(frame);
  }
}

void Flight::takeHeartbeat() {
  isBeat_ = true;
  if (beatsLeft_ != 0) --beatsLeft_;
}

void Flight::takeCurrent(const FrameParser& frame) {
  typedef mavlink_mission_current_t Current;
  if (!stages_.isInFlight()) return;
  beatsLeft_ = kSilence;
  item_ = client_.itemFromWire(frame.payloadWord(offsetof(Current, seq)));
  const uint8_t missionState = frame.payloadByte(offsetof(Current, mission_state));
  // A rover at its plan's end is there still when its current item is set once more.
  const bool isReset = missionState == MISSION_STATE_NOT_STARTED && isRover();
  isComplete_ = missionState == MISSION_STATE_COMPLETE || (isReset && hasBegun_);
  const bool isEnd = item_ == last_ || isComplete_;
  if (!isEnd && !isReset) hasBegun_ = true;
  if (isEnd && hasBegun_) isAtEnd_ = true;  // for good: ArduPilot rewinds its plan when it is disarmed
  // What is older than the start may be about the plan before.
  const bool isOther = client_.namesOther(frame);
  isOtherPlan_ = isOther && isDoubted_;
  isDoubted_ = isOther;
}

// The first text of an attempt: an autopilot names all its reasons each time, in the same order.
void Flight::takeText(const FrameParser& frame) {
  typedef mavlink_statustext_t Text;
  if (!wantsReason_ || !stages_.isWaiting()) return;
  if (frame.payloadByte(offsetof(Text, severity)) > MAV_SEVERITY_WARNING) return;
  wantsReason_ = false;
  bool isNew = false;
  constexpr uint8_t kLongest = sizeof(reason_) - 1;
  for (uint8_t i = 0; i < kLongest; ++i) {
    const char letter = static_cast<char>(frame.payloadByte(static_cast<uint8_t>(offsetof(Text, text) + i)));
    if (letter != reason_[i]) isNew = true;
    reason_[i] = letter;
    if (letter == 0) break;
  }
  if (isNew) stages_.noteNews();
}

// --- Who has the aircraft

bool Flight::isRover() const {
  return has(client_.autopilot().firmware(), kModesByVehicle) &&
         vehicleOf(client_.autopilot().vehicleType()) == Vehicle::Rover;
}

FlightHands Flight::hands() const {
  const FlightHands steered = isSteered_ ? ways_->hands(*this) : FlightHands::Pilot;
  if (steered != FlightHands::Pilot) return steered;
  // PX4 says CRITICAL while a failsafe flies, in whatever mode.
  if (has(client_.autopilot().firmware(), kCriticalInFailsafe) &&
      client_.autopilot().heartbeat().state >= MAV_STATE_CRITICAL) {
    return FlightHands::Failsafe;
  }
  const CommandPort& commands = client_.commands();
  const uint16_t shown = commands.shownMode();
  if (!isSteered_ && shown == commands.numberOf(FlightMode::Auto)) return FlightHands::Own;
  if (commands.isReturn(shown)) {
    // PX4 and ArduPilot's planes carry out a plan's return by changing their mode. MISSION_CURRENT may say so later.
    if (!isSteered_ && returns_) return isAtEnd_ ? FlightHands::Own : FlightHands::Unclear;
    return FlightHands::Failsafe;
  }
  return shown == commands.numberOf(FlightMode::Land) ? FlightHands::Failsafe : FlightHands::Pilot;
}

void Flight::look(bool hasEnded) {
  const CommandPort& commands = client_.commands();
  FlightSight sight;
  sight.hands = hands();
  sight.mode = commands.shownMode();
  sight.isHeard = client_.autopilot().isFound();
  sight.isLossy = client_.link().pace().isLossy();
  sight.isArmed = client_.autopilot().isArmed();
  sight.isOver = isSteered_ ? comesDown_ : isAtEnd_;
  sight.staysArmed = isRover() && !isSteered_ && isAtEnd_ && isComplete_;
  // PX4 leaves its modes of returning and landing by itself when it is disarmed.
  sight.mayRest =
      !has(client_.autopilot().firmware(), kFliesByMode) &&
      (sight.mode == commands.numberOf(FlightMode::Hold) || sight.mode == commands.numberOf(FlightMode::Auto));
  sight.isOtherPlan = !isSteered_ && (isOtherPlan_ || autopilot_.aboard() == Aboard::OtherPlan);
  const bool isBeat = isBeat_;
  isBeat_ = false;
  if (hasEnded) {
    const bool isStart = stages_.running() == FlightOrder::Start;
    const bool hasArmed =
        isStart ? autopilot_.startArming() == StartArming::Disarmed : ways_ != nullptr && ways_->hasArmed(*this);
    stages_.onEnd(autopilot_.status(), sight, hasArmed);
  }
  stages_.look(sight, isBeat);
  if (stages_.takeBreak()) client_.end(Status::Cancelled);
}

// --- The plan's stops

void Flight::lookForStop(Flight& flight) {
  const uint16_t item = flight.item_;
  if (item != flight.stop_) {
    if (flight.state() == FlightState::AtStop) flight.stages_.leave();
    flight.stop_ = item;
    MissionItem read;
    const ItemSource& plan = flight.plan_;
    flight.isStop_ = item < plan.count && plan.read(plan.context, item, read) && read.command == MAV_CMD_NAV_WAYPOINT &&
                     read.param1 >= 1;
    if (!flight.isStop_) return;
    flight.place_.latitude = Degrees::fromE7(read.x);
    flight.place_.longitude = Degrees::fromE7(read.y);
  }
  const PositionListener& position = *flight.position_;
  // On a lossy link, the listener's own request may not arrive in time.
  const bool mayAsk = flight.isBeat_ && flight.stages_.running() == FlightOrder::None && position.intervalMs() != 0;
  if (mayAsk && position.ageMs() >= kFreshMs && flight.client_.link().pace().isLossy()) {
    flight.autopilot_.setMessageInterval(MAVLINK_MSG_ID_GLOBAL_POSITION_INT, int32_t{1000} * position.intervalMs());
  }
  if (flight.isStop_ && flight.state() == FlightState::Flying && position.ageMs() < kFreshMs &&
      position.speedCmS() < kSlowCmS && distanceCm(position.place(), flight.place_) < kNearCm) {
    flight.stages_.arrive();
  }
}

// --- What is begun

// The item with which the plan ends on the ground; false if an aircraft would stay in the air. A rover's plan is over
// when the autopilot says so.
bool Flight::findEnd() {
  last_ = MissionClient::kNoItem;
  returns_ = false;
  if (isRover()) return true;
  for (uint32_t i = plan_.count; i != 0 && i <= MissionClient::kMaxItems; --i) {
    MissionItem item;
    const uint16_t index = static_cast<uint16_t>(i - 1);
    if (!plan_.read(plan_.context, index, item)) break;
    if (!isFlown(item.command)) continue;
    last_ = index;
    returns_ = item.command == MAV_CMD_NAV_RETURN_TO_LAUNCH;
    return isLanding(item.command);
  }
  return true;  // the upload says what is wrong with it
}

void Flight::beginPlan(Flight& flight, FlightOrder order) {
  switch (order) {
    case FlightOrder::Upload:
      if (flight.findEnd()) {
        flight.autopilot_.uploadWithoutReadback(flight.plan_);
      } else {
        flight.stages_.refuse(Status::NoLanding);
      }
      return;
    case FlightOrder::Start: flight.autopilot_.start(); return;
    case FlightOrder::Disarm: flight.client_.commands().beginCommands(fillDisarming, onDisarming, &flight); return;
    case FlightOrder::None:
    case FlightOrder::TakeOff:
    case FlightOrder::GoTo:
    case FlightOrder::Home:
    case FlightOrder::Land: return;
  }
}

void Flight::fillDisarming(Client&, FlightCommand& command) { CommandPort::fillArming(command, false); }

// Each attempt leaves after a heartbeat that shows the mission's mode: it is not a pilot's vehicle that is disarmed.
Status Flight::onDisarming(Client& client, CommandEvent event, Status status, const FrameParser*, uint16_t) {
  const Flight& self = *static_cast<const Flight*>(CommandPort::ownerOf(client));
  if (event == CommandEvent::Ready || event == CommandEvent::Heartbeat) {
    if (!self.client_.autopilot().isArmed()) return Status::Done;
    if (self.hands() != FlightHands::Own) return Status::PilotHasIt;
  }
  return status;
}

}  // namespace mavmission
