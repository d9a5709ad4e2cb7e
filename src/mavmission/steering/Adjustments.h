// How an aircraft flies to where Steering sends it: with which heading, and how fast up and down.
#pragma once

#include "Steering.h"
#include "VelocityTarget.h"

namespace mavmission {

// Declare it next to the client and its Steering:
//
//   Steering steering(autopilot);
//   Adjustments adjustments(steering);
//
// For ArduCopter alone: with every other vehicle each function ends with Status::CommandUnsupported, and nothing is
// sent. (PX4 has no such commands. With PX4 a VelocityTarget turns to a heading.) Each is an operation of the client,
// Done when the autopilot has acknowledged it, and refused for the same reasons as Steering::setSpeed(): it never
// changes the mode, nor the place to which the aircraft flies, and it is not sent while somebody else has the aircraft.
class Adjustments {
 public:
  // This object and the Steering must live as long as the client: declare them next to the client, not in a function.
  explicit Adjustments(Steering& steering) : steering_(steering), value_(0), turn_(0), kind_(Kind::Heading) {}

  // Turns to this heading, on the shorter way, and keeps it (MAV_CMD_CONDITION_YAW): where the aircraft hovers, and on
  // the way to the place that is flown to; in a mission until its next waypoint. The next goTo() or velocity has its
  // own heading again. `turn`: how fast, up to 360 degrees/s and not above what the autopilot allows; 0: as it likes.
  // Numbers that are refused: the heading (Param1) if it is not set, not finite (NotANumber, NotFinite) or beyond 360
  // degrees, the turn (Param2) if it is negative or above 360 (BadRange).
  Status turnTo(Yaw heading, DegreesPerSecond turn = DegreesPerSecond(0));

  // Sets how fast it climbs, or sinks, from now on: above 0 and up to 20 m/s (MAV_CMD_DO_CHANGE_SPEED; else
  // Status::BadSpeed, Param2). In GUIDED ArduCopter has one of the two alone: setting one gives the other its default
  // again, and the first place after a takeoff does so for both: set it after that goTo(). For the ground speed use
  // Steering::setSpeed().
  Status setClimbSpeed(MetresPerSecond speed);
  Status setDescentSpeed(MetresPerSecond speed);

 private:
  // The last two with their numbers in MAV_CMD_DO_CHANGE_SPEED.
  enum class Kind : uint8_t { Heading = 0, Climb = 2, Descent = 3 };

  static void fill(detail::Client& client, FlightCommand& command);
  static Status on(detail::Client& client, detail::CommandEvent event, Status status, const detail::FrameParser* frame,
                   uint16_t nowMs);
  Status begin(Kind kind, float value, float turn);
  Status refuse();
  Status refuseNumber(float value, float least, float most, Status range, ItemField field);

  Steering& steering_;
  float value_;  // the heading [degrees], or the speed [m/s]
  float turn_;   // [degrees/s]
  Kind kind_;
};

}  // namespace mavmission
