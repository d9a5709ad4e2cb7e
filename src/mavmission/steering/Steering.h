// Flying without a plan: take off, go to a place now, hold, go on with the mission, land, return.
#pragma once

#include "../autopilot/VehicleKind.h"
#include "../client/CommandPort.h"
#include "../item/LatLon.h"
#include "../service/Listener.h"
#include "../transfer/ModeOrder.h"
#include "SteeringOrders.h"

namespace mavmission {

class Adjustments;
class MovingTarget;
class SteeredFlight;

// The steps of a Steering operation, in order; each operation needs only some of them. AskLanded: PX4 is asked whether
// it is in the air (EXTENDED_SYS_STATE), and a plane of ArduPilot whether it can hover. AskHome: PX4 is asked whether
// it knows where home is (HOME_POSITION). AskPosition: the position is requested twice a second (GLOBAL_POSITION_INT).
// Mode, Arm: the mode is set, the aircraft is armed. Command: NAV_TAKEOFF, DO_REPOSITION or DO_CHANGE_SPEED is sent.
// Confirm: waits for the message which shows that the command is carried out. Disarm: takeOff() has failed after it had
// armed. GiveBack: a command has replaced a mode that somebody else had set at the same moment, and that mode is set
// again.
enum class SteerStep : uint8_t { None, AskLanded, AskHome, AskPosition, Mode, Arm, Command, Confirm, Disarm, GiveBack };

// Steers the client's aircraft. Declare one beside the client:
//
//   MissionClient autopilot(Serial1);
//   Steering steering(autopilot);
//
// Each function begins an operation of the client, which ends as the client's other operations do: update() returns
// Status::Done, or another status that says why it failed. Only one operation runs at a time: Status::Busy while
// another one runs.
//
// Steering never takes control from a pilot, a failsafe or another station. Every function acts only while the
// heartbeat shows the mission mode, or the mode that this sketch has set itself (by this object, or by setMode()).
// Otherwise it sends nothing, and ends with Status::FailsafeHasIt if PX4 reports a failsafe or the aircraft returns or
// lands without a command of this sketch, else with Status::PilotHasIt. (MissionClient::setMode() sets a mode in any
// case.) On PX4, goTo() flies in the mode HOLD, which a pilot may choose too: a pilot who chooses HOLD is not detected
// there, one who chooses any other mode is.
//
// A command that changes the mode is sent right after a heartbeat, which is requested for this purpose. If the aircraft
// is in the wanted mode already, the command is sent in a form that does not change the mode. If somebody else sets a
// mode between that heartbeat and the arrival of the command, and a heartbeat has shown that mode, it is set again: the
// status is PilotHasIt or FailsafeHasIt if the aircraft flies in it again, Overruled if it could not be set.
// docs/in_control.md gives the times.
//
// When somebody takes the aircraft, that is remembered, also after it has landed and was disarmed: takeOff(), start()
// and arm() then end with PilotHasIt or FailsafeHasIt, and send nothing, until the sketch calls requestControl().
// (MissionClient::takenBy() tells.)
//
// The mode that the sketch has set is forgotten when the aircraft is disarmed, and when the autopilot was not heard for
// 20 s: call requestControl() then, if a person wants it so.
//
// After a reset in flight nothing happens by itself: until this object has seen the aircraft disarmed, its functions
// end with Status::Armed, unless MissionClient::allowWhileArmed(true) allows them. Then they act only in the mission
// mode, since it is not known who set any other mode.
//
// Numbers are checked before anything is sent; MissionClient::differingField() names the field that was refused.
class Steering : public detail::Listener, private detail::SteerRules {
 public:
  // This object must live as long as the client: declare it next to the client, not in a function.
  explicit Steering(MissionClient& client);

  // Arms the aircraft, and makes it climb vertically to this height above home: for ArduPilot's copters and QuadPlanes,
  // and for PX4. Done when it has left the ground; hasArrived() becomes true at that height, on PX4 in HOLD. In the air
  // it is refused (Status::Armed). If it is armed and the takeoff is refused or not answered, or does not leave the
  // ground within 15 s, it is disarmed again. A plane is asked first whether it can hover (EXTENDED_SYS_STATE). A
  // QuadPlane climbs to this height above the place where it stands, not above home.
  Status takeOff(Metres aboveHome);

  // Flies to a place now, and stays there (MAV_CMD_DO_REPOSITION). Done when the autopilot has accepted the place and
  // its heartbeat shows the mode; if the autopilot reports its target (POSITION_TARGET_GLOBAL_INT), Done also waits
  // until that is the place. hasArrived() then says whether the aircraft is there. PX4 takes each altitude as above sea
  // level, whatever the frame says: so the altitude of home is requested and added, and goTo() ends with Status::NoHome
  // if it is not known. Only ArduPilot takes an altitude above the ground (else Status::BadFrame). Status::NotFlying:
  // the aircraft is on the ground; a rover has only to be armed.
  Status goTo(const LatLon& place, Altitude altitude);

  // Stops, and stays there, until goTo() or resume(). The mode is then ArduPilot's GUIDED, in which the sticks do
  // nothing, or PX4's HOLD.
  Status pause();
  // Goes on with the mission, at its current item. Status::NotFlying: the aircraft is on the ground; use
  // MissionClient::start() there.
  Status resume();
  // Flies home and lands, or lands here.
  Status returnHome();
  Status landNow();

  // Sets the ground speed from now on, above 0 and up to 100 m/s (MAV_CMD_DO_CHANGE_SPEED; in a plan: changeSpeed()).
  // ArduCopter goes back to its default speed at the first place after a takeoff: with ArduCopter set it after that
  // goTo().
  Status setSpeed(MetresPerSecond speed);

  // True when the aircraft is at the place of the last goTo(), or at the height of takeOff(), within this distance
  // north and south, east and west, up and down [cm]; false when its position is not known.
  bool hasArrived(uint16_t withinCm = 200) const;

  // True while the heartbeat shows the mission mode, or the mode that this sketch has set; false when no heartbeat has
  // come since loop() stood still last.
  bool maySteer() const;

  // Asks for the aircraft again: MissionClient::requestControl(), and the mode that its last heartbeat has shown, or
  // that its first one will show, counts as the sketch's own, until a heartbeat shows another. To be called when a
  // person wants it so, such as by a button. An order may follow at once. Nothing is sent.
  void requestControl();

  // The step of the running operation, or the step at which the last one ended.
  SteerStep step() const { return step_; }

 private:
  friend class Adjustments;
  friend class MovingTarget;
  friend class SteeredFlight;

  // What an altitude is measured from.
  enum class Above : uint8_t { Nothing, Home, Sea };

  struct Place {
    LatLon at;
    int32_t heightCm;
    Above above;
    bool hasPlace;
  };

  static void take(detail::Listener& listener, const detail::FrameParser& frame);
  static void fill(detail::Client& client, FlightCommand& command);
  static Status on(detail::Client& client, detail::CommandEvent event, Status status, const detail::FrameParser* frame,
                   uint16_t nowMs);
  Status begin(detail::OrderRow row);
  Status onEvent(detail::CommandEvent event, Status status, uint16_t nowMs);
  void takeHeartbeat();
  void takePosition(const detail::FrameParser& frame);
  void takeTarget(const detail::FrameParser& frame);
  Status refuse();
  Status refuseNumbers();
  Status refuseNumber(float value, ItemField field);
  Status refuseHeight(float metres, int32_t* cm);
  Status refusePlace(const LatLon& at, CoordinateFrame frame);
  Status refuseField(Status status, ItemField field);
  Status otherHands() const;
  Status whoFlies() const;
  bool isOurs() const;
  Status judgeFlight();
  Status nextStep(uint16_t nowMs);
  bool beginStep(uint16_t nowMs);
  Status onRefused(Status refusal, uint16_t nowMs);
  Status onSilent(Status silence);
  Status onHeartbeat(uint16_t nowMs);
  Status onOwnMode(uint16_t nowMs);
  void noteSent();
  void lead(uint16_t from, uint16_t wanted);
  Status leaveTo(Status other);
  Status giveBack();
  uint16_t secondsOfStep() const;
  Status onTime(uint16_t nowMs);
  Status leave(Status refusal);
  Status done();
  void forgetTarget();
  void fillStep(FlightCommand& command) const;
  void fillCommand(FlightCommand& command) const;
  void findWanted();
  bool isRunning() const;
  bool is(detail::OrderTrait trait) const { return (row_.bits & trait) != 0; }
  detail::Vehicle vehicle() const { return detail::vehicleOf(client_.autopilot().vehicleType()); }
  bool isPlane() const;
  MAVMISSION_APART uint16_t shownMode() const;
  bool isGround() const;
  bool isInAir() const;
  bool isToldByHeartbeat() const;
  bool mayBeOfPlan() const;
  bool isMissionMode() const;
  bool isFailsafe() const;
  bool isFlownByOrders() const;
  bool needsHome() const;
  bool stopsByPlace() const;
  bool hasCommand() const;
  bool wantsPosition() const;
  bool changesMode() const;
  bool isInHoldAloft() const;
  bool hasClimbed() const;
  bool mayHaveClimbed() const;
  uint16_t positionAgeS() const;
  bool isPositionKnown() const;
  void forgetShown();
  bool isRelative() const { return modern(frame_) == CoordinateFrame::GlobalRelative; }
  uint16_t wantedMode() const;

  // What the code asks for most often comes first, where avr-gcc reaches it cheaply.
  bool seenDisarmed_ : 1;  // since the sketch began
  bool hasArmed_ : 1;      // in this operation
  bool isModeSeen_ : 1;    // a heartbeat has shown the wanted mode
  bool isHeard_ : 1;       // the message that the step asked for has come
  bool isAnswered_ : 1;    // and its COMMAND_ACK
  bool isTargetSame_ : 1;  // the autopilot has named our place as its target
  bool isOrdered_ : 1;     // what changes the mode has left in this operation
  bool isDenied_ : 1;      // the place was refused: it is looked who has the aircraft
  bool canHover_ : 1;      // EXTENDED_SYS_STATE has named a state of a VTOL
  bool hadControl_ : 1;    // the last heartbeat has shown it armed, and the sketch in control
  bool wasArmed_ : 1;      // the last heartbeat has shown it armed
  bool isRequested_ : 1;   // by requestControl(), before any heartbeat has told the mode
  SteerStep step_;
  detail::OrderRow row_;  // of the running order, or of the last one
  CoordinateFrame frame_;
  Status refusal_;            // with which a takeoff will end
  uint8_t landedState_;       // MAV_LANDED_STATE; 0: not known
  uint8_t targetAge_;         // heartbeats since the last POSITION_TARGET_GLOBAL_INT
  uint8_t knowledge_;         // AutopilotFinder::knowledge() of what is known here
  uint16_t positionS_;        // when the last position came [1.024 s]
  uint16_t beatS_;            // the same of the heartbeat
  uint16_t ownMode_;          // the mode that this sketch has set, while it lasts; kNoMode: none
  uint16_t oldMode_;          // the mode at the beginning of the operation
  detail::ModeOrder change_;  // from that mode to the one of the order
  uint16_t beganS_;           // when the step began [s]
  float value_;               // the altitude [m] or the speed [m/s] of the order
  int32_t homeCm_;            // its altitude above home
  int32_t seaCm_;             // its altitude above the sea
  Place wanted_;              // of the running goTo() or takeOff()
  Place target_;              // to which it flies
  LatLon here_;               // its position
  MovingTarget* stream_;      // which sends targets
};

}  // namespace mavmission
