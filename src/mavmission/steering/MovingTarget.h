// A moving target: the aircraft follows a place that the sketch updates again and again.
#pragma once

#include "Steering.h"

namespace mavmission {

// Lets an aircraft follow a target: SET_POSITION_TARGET_GLOBAL_INT is sent 5 times a second. For copters, rovers and
// submarines of ArduPilot, and for PX4. Declare one next to the client and its Steering:
//
//   MissionClient autopilot(Serial1);
//   Steering steering(autopilot);
//   MovingTarget target(steering);
//
//   void loop() {
//     target.update();     // before the client's
//     autopilot.update();
//     if (beacon.hasMoved()) target.renew(beacon.place(), 20_m);
//   }
//
// A target is sent only from update(), and only if the sketch has called renew() within the last second. If it has not,
// or if it calls stop(), the aircraft is made to hold its position, as by Steering::pause(). So if loop() runs while
// the sensor is silent, the aircraft holds. If loop() is blocked, nothing is sent: ArduPilot then flies to the last
// target and stays there, and PX4 does what its failsafe for OFFBOARD says (by default it returns home 1 s later). When
// loop() runs again, an old target is not sent.
//
// No target is sent either when 0.6 s have passed since the last message of the autopilot: PX4 would leave its failsafe
// at the first target that it receives. After such a gap, and after a loop() that was blocked for as long, a heartbeat
// has to show first that the sketch is still in control.
//
// As Steering, it never takes control from a pilot, a failsafe or another station. When a heartbeat shows another mode,
// or a failsafe, the following ends: nothing more is sent until the sketch calls start(), which is refused while
// somebody else is in control. Any operation of Steering except setSpeed() ends the following, too.
class MovingTarget : private detail::Listener, private detail::TargetRules {
 public:
  // This object and the Steering must live as long as the client: declare them next to the client, not in a function.
  explicit MovingTarget(Steering& steering);

  // Begins to follow. This is an operation of the client, and it is refused for the same reasons as Steering::goTo().
  // Done when the heartbeat shows the mode: ArduPilot's GUIDED, or PX4's OFFBOARD. PX4 wants targets before it changes
  // to OFFBOARD: they are sent for a second. Call renew() meanwhile, too. Status::Busy if it follows already, or
  // another operation runs; Status::CommandUnsupported for ArduPilot's planes, which would take only the altitude.
  // After MissionClient::cancel() the aircraft is not made to hold: PX4, if it is in OFFBOARD by then, does what its
  // failsafe for that mode says.
  Status start(const LatLon& place, Altitude altitude);

  // Gives the target's place again, or its new place. Returns Status::Transferring if this target is sent from now on.
  // Any other status means that this call did not count as a renewal: the number that MissionClient::differingField()
  // names is not possible; or the altitude has another reference than in start() (Status::BadFrame); or no targets are
  // sent any more, and the status says why.
  Status renew(const LatLon& place, Altitude altitude);

  // Stops following: the aircraft holds its position. If start() is not done yet, it is given up.
  void stop();

  // To be called from loop(), before the client's update(): so a message that was half sent when loop() was blocked is
  // not completed. Returns the status with which the following has ended, once; otherwise Status::Transferring, or
  // Status::Idle. That status is Done (after stop()), NotRenewed, PilotHasIt, FailsafeHasIt, Cancelled (the sketch has
  // given another command), NotArmed, NoAutopilot, or the reason why start() or the hold was refused. Done and
  // NotRenewed mean that the aircraft holds its position: a heartbeat has shown that mode.
  Status update();

  // The status with which it ended last; Status::Transferring while it runs, also until the hold is confirmed.
  Status status() const { return status_; }
  // True while the aircraft follows: from the end of start() to the beginning of the hold.
  bool isFollowed() const { return stage_ == Stage::Following; }

  // The longest time between two calls of renew() [ms]; 1000 by default.
  void setTimeout(uint16_t ms) { timeoutMs_ = ms; }

 private:
  friend class VelocityTarget;

  // Another target than a place: writes what it is into the payload, or, without one, says whether this vehicle takes
  // it.
  typedef Status (*Other)(const MovingTarget& target, uint8_t* payload);

  enum class Stage : uint8_t { Off, Starting, Following, Holding };

  MovingTarget(Steering& steering, Other other);
  static void take(detail::Listener& listener, const detail::FrameParser& frame);
  static void fill(detail::Client& client, FlightCommand& command);
  static Status on(detail::Client& client, detail::CommandEvent event, Status status, const detail::FrameParser* frame,
                   uint16_t nowMs);
  Status onEvent(detail::CommandEvent event, Status status, uint16_t nowMs);
  Status onStart(detail::CommandEvent event, Status status, uint16_t nowMs);
  Status startOther();
  void begin();
  Status whyClosed() const;
  Status blame(Status status, ItemField field) const { return steering_.refuseField(status, field); }
  void takeOver();
  bool isOperating() const;
  bool isLate() const;
  void look(uint32_t nowMs);
  void ask(uint16_t nowMs);
  bool isSteered() const;
  bool needsStream() const;
  bool mayFollow() const;
  Status whoHasIt() const;
  void follow(uint16_t nowMs);
  void hold(Status ending);
  void keepHolding(uint16_t nowMs);
  void aimHere();
  void withdraw();
  void send(uint16_t nowMs);
  void finish(Status status);

  Steering& steering_;
  Other other_;  // null: a place
  uint32_t renewedMs_;
  uint16_t timeoutMs_;
  uint16_t sentMs_;   // when the last target left
  uint16_t beganMs_;  // when the first target left
  uint16_t blindMs_;  // since when it is blind
  uint16_t askedMs_;  // when a heartbeat was asked for last
  uint16_t mode_;     // in which the aircraft follows
  LatLon at_;         // the target
  int32_t heightCm_;
  CoordinateFrame frame_;
  Status status_;
  Status toReturn_;
  Status ending_;  // with which a hold ends
  Stage stage_;
  bool isBlind_ : 1;      // loop() has stood still, or the autopilot was silent, and no heartbeat has come since then
  bool isStopped_ : 1;    // by stop()
  bool hasSent_ : 1;      // a target has left since start()
  bool isOrdered_ : 1;    // the hold is an operation of the client, and has not ended
  bool isAimed_ : 1;      // there is something to send
  bool isHere_ : 1;       // the target is no longer the sketch's, but where the aircraft is
  bool isWithdrawn_ : 1;  // the last message need not be withdrawn
  uint8_t payload_[53];   // of the message that is sent
};

}  // namespace mavmission
