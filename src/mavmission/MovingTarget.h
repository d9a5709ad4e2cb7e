// A target that moves: the aircraft flies to the place that the sketch names again and again.
#pragma once

#include "Steering.h"

namespace mavmission {

// Lets an aircraft follow a target, by SET_POSITION_TARGET_GLOBAL_INT, 5 times a second. Copters and rovers of
// ArduPilot, and PX4. Declare one beside the client and its Steering:
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
// A target leaves only from update(), and only while the sketch has renewed it within the last second: when it stops
// doing so, or calls stop(), the aircraft is made to hold where it is, as Steering::pause() does. So a loop() that goes
// on while its sensor is silent ends with a hold. A loop() that stands still sends nothing: ArduPilot then flies to the
// last target and stays there, PX4 does what its failsafe for OFFBOARD says (by default it returns home 1 s later).
// When loop() goes on later, an old target is not sent.
//
// Nor does a target leave while the autopilot is not heard: none 0.6 s after its last message. For PX4 would take the
// first target that gets through for an order to come back from its failsafe. After such a gap, and after a loop()
// that stood still for so long, a heartbeat has to show first that the aircraft is still the sketch's.
//
// The aircraft is never taken out of other hands: what Steering says about that holds here too. A heartbeat that shows
// another mode, or a failsafe, ends it for good: nothing more is sent until the sketch calls start(), which is refused
// while the aircraft is in other hands. An order of Steering, but for setSpeed(), ends it as well.
class MovingTarget : private detail::Listener, private detail::TargetRules {
 public:
  // This object and the Steering must live as long as the client: declare them beside it, not in a function.
  explicit MovingTarget(Steering& steering);

  // Begins: an operation of the client, as Steering::goTo(), and with its refusals. Done when the heartbeat shows the
  // mode: GUIDED, or PX4's OFFBOARD, before which targets go out for a second. The target must be renewed meanwhile.
  // Status::Busy if it runs already, or another operation does; Status::CommandUnsupported for ArduPilot's planes,
  // which would take the altitude alone. After MissionClient::cancel() no hold is ordered: PX4, if it is in OFFBOARD by
  // then, does what its failsafe for that mode says.
  Status start(const LatLon& place, Altitude altitude);

  // Names the target's place again, or its new one. Returns Status::Transferring when that is what goes out from now
  // on. Otherwise nothing has changed, and the old target has still to be renewed: a number that cannot be meant, which
  // MissionClient::differingField() names; Status::BadFrame for an altitude that is not measured as in start(); or, if
  // no target goes out any more, why.
  Status renew(const LatLon& place, Altitude altitude);

  // Ends with a hold. Before start() is done, it is given up.
  void stop();

  // To be called from loop(), before the client's update(): so what has been going out when loop() stood still is not
  // completed. Returns the status with which all has ended, once; otherwise Status::Transferring, or Status::Idle. That
  // status is Done after stop(), NotRenewed, PilotHasIt, FailsafeHasIt, Cancelled (the sketch has ordered something
  // else), NotArmed, NoAutopilot, or how start() or the hold was refused. When it is Done or NotRenewed, the aircraft
  // holds: the heartbeat has shown the mode in which it does.
  Status update();

  // How it ended last; Status::Transferring while it runs, also while it holds.
  Status status() const { return status_; }
  // True while the aircraft follows: from the end of start() to the beginning of the hold.
  bool isFollowed() const { return stage_ == Stage::Following; }

  // The longest time between two calls of renew() [ms]; 1000 by default.
  void setTimeout(uint16_t ms) { timeoutMs_ = ms; }

 private:
  enum class Stage : uint8_t { Off, Starting, Following, Holding };

  static void take(detail::Listener& listener, const detail::FrameParser& frame);
  static void fill(detail::Client& client, FlightCommand& command);
  static Status on(detail::Client& client, detail::Client::CommandEvent event, Status status,
                   const detail::FrameParser* frame, uint16_t nowMs);
  Status onEvent(detail::Client::CommandEvent event, Status status, uint16_t nowMs);
  Status onStart(detail::Client::CommandEvent event, Status status, uint16_t nowMs);
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
  void spoil();
  void send(uint16_t nowMs);
  void finish(Status status);

  Steering& steering_;
  uint32_t renewedMs_;
  uint32_t updatedMs_;  // when update() was called last
  uint16_t timeoutMs_;
  uint16_t sentMs_;   // when the last target left
  uint16_t beganMs_;  // when the first one did
  uint16_t blindMs_;  // since when it is blind
  uint16_t askedMs_;  // when a heartbeat was asked for last
  uint16_t mode_;     // in which the aircraft follows
  LatLon at_;         // the target
  int32_t heightCm_;
  Frame frame_;
  Status status_;
  Status toReturn_;
  Status ending_;  // with which a hold ends
  Stage stage_;
  bool isBlind_ : 1;     // loop() has stood still, or the autopilot was silent, and no heartbeat has come since then
  bool isStale_ : 1;     // loop() has stood still: what comes next may be from before
  bool isStopped_ : 1;   // by stop()
  bool hasSent_ : 1;     // a target has left since start()
  bool isOrdered_ : 1;   // the hold is an operation of the client, and has not ended
  bool isAimed_ : 1;     // there is something to send
  bool isHere_ : 1;      // the target is no longer the sketch's, but where the aircraft is
  bool isSpoilt_ : 1;    // the last message need not be spoilt
  uint8_t payload_[53];  // of the message that goes out
};

}  // namespace mavmission
