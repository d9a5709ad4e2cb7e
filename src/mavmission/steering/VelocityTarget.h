// Guided by velocities: the aircraft flies at the speed, in the direction and with the heading that the sketch renews.
#pragma once

#include "../item/Units.h"
#include "MovingTarget.h"

namespace mavmission {

// How fast something turns, clockwise as seen from above [degrees/s].
struct DegreesPerSecond {
  float value;  // [degrees/s]
  // From a number that was computed.
  constexpr explicit DegreesPerSecond(float degreesPerSecond) : value(degreesPerSecond) {}
  // As fast, the other way round.
  constexpr DegreesPerSecond operator-() const { return DegreesPerSecond(-value); }
};
// A rate of turn as a literal: 10_dps.
constexpr DegreesPerSecond operator"" _dps(unsigned long long value) {
  return DegreesPerSecond(static_cast<float>(value));
}
constexpr DegreesPerSecond operator"" _dps(long double value) { return DegreesPerSecond(static_cast<float>(value)); }

// What both kinds of velocities have in common; name one of them.
class Velocity {
 protected:
  // By the two kinds.
  constexpr Velocity(bool isOfAircraft, float x, float y, float up, float heading, float turn)
      : x_(x), y_(y), up_(up), heading_(heading), turn_(turn), isOfAircraft_(isOfAircraft) {}

  float x_;            // north, or forward [m/s]
  float y_;            // east, or to the right [m/s]
  float up_;           // [m/s]
  float heading_;      // [degrees from north]; NaN: none is named
  float turn_;         // [degrees/s]
  bool isOfAircraft_;  // as seen from the aircraft

 private:
  friend class VelocityTarget;
};

// A velocity over the ground [m/s], such as EarthVelocity(2_mps, 0_mps): to the north, to the east, and up. The heading
// stays as it is, unless one of the functions is called. A rover drives forward in this direction.
class EarthVelocity : public Velocity {
 public:
  // A negative number is the opposite direction: MetresPerSecond(-2).
  constexpr EarthVelocity(MetresPerSecond north, MetresPerSecond east, MetresPerSecond up = MetresPerSecond(0))
      : Velocity(false, north.value, east.value, up.value, Yaw().inDegrees(), 0) {}
  // The same velocity, and the heading that is turned to and kept.
  constexpr EarthVelocity facing(Yaw heading) const { return EarthVelocity(x_, y_, up_, heading.inDegrees(), 0); }
  // The same velocity while the aircraft turns.
  constexpr EarthVelocity turning(DegreesPerSecond turn) const {
    return EarthVelocity(x_, y_, up_, Yaw().inDegrees(), turn.value);
  }

 private:
  constexpr EarthVelocity(float north, float east, float up, float heading, float turn)
      : Velocity(false, north, east, up, heading, turn) {}
};

// A velocity as seen from the aircraft [m/s]: forward, to its right, and up, however it is tilted. The heading stays as
// it is, unless it turns.
class BodyVelocity : public Velocity {
 public:
  // A negative number is the opposite direction: MetresPerSecond(-2).
  constexpr BodyVelocity(MetresPerSecond forward, MetresPerSecond right = MetresPerSecond(0),
                         MetresPerSecond up = MetresPerSecond(0))
      : Velocity(true, forward.value, right.value, up.value, Yaw().inDegrees(), 0) {}
  // The same velocity while the aircraft turns: a curve.
  constexpr BodyVelocity turning(DegreesPerSecond turn) const { return BodyVelocity(x_, y_, up_, turn.value); }

 private:
  constexpr BodyVelocity(float forward, float right, float up, float turn)
      : Velocity(true, forward, right, up, Yaw().inDegrees(), turn) {}
};

// Makes an aircraft fly at a velocity: SET_POSITION_TARGET_LOCAL_NED is sent 5 times a second, with the velocity and
// the heading. For ArduPilot's copters and rovers, and PX4's copters. Declare one next to the client and its Steering:
//
//   MissionClient autopilot(Serial1);
//   Steering steering(autopilot);
//   VelocityTarget velocity(steering);
//
//   void loop() {
//     velocity.update();  // before the client's
//     autopilot.update();
//     if (line.isSeen()) velocity.renew(BodyVelocity(1_mps).turning(DegreesPerSecond(line.offset())));
//   }
//
// It has the rules of a MovingTarget, and no rule of its own: a velocity is sent only from update(), and only if the
// sketch has called renew() within the last second. If it has not, or if it calls stop(), the aircraft is stopped, and
// holds its position, as by Steering::pause(). A pilot, a failsafe or another station who sets a mode keeps the
// aircraft. If loop() is blocked, or the line is cut, nothing is sent: ArduCopter and ArduRover then fly on at the last
// velocity until 3 s have passed (ArduCopter's `GUID_TIMEOUT`), and stop; PX4 does what its failsafe for OFFBOARD says
// (by default it returns home 1 s later).
//
// Nothing here knows where obstacles or the ground are, and no height is kept for the sketch: what climbs or sinks does
// so until another velocity is named.
class VelocityTarget : private MovingTarget {
 public:
  // This object and the Steering must live as long as the client: declare them next to the client, not in a function.
  explicit VelocityTarget(Steering& steering);

  // Begins to fly at this velocity. This is an operation of the client, refused for the same reasons as
  // Steering::goTo(), and done as MovingTarget::start() is. Status::CommandUnsupported, before anything is sent, for a
  // vehicle of another kind, and for a velocity that this vehicle cannot have: a rover neither climbs nor drives
  // sideways, and over the ground it looks where it drives. MissionClient::differingField() names the number then, and
  // for a number that is not possible (NotANumber, NotFinite; BadSpeed: above 100 m/s, or turning by more than 360
  // degrees/s): Param1 to Param3 of the velocity, in its order, Param4 of the heading or of the turn.
  Status start(const Velocity& velocity);
  // Gives the velocity again, or another one. Returns Status::Transferring if it is sent from now on. Any other status
  // means that this call did not count as a renewal, for a reason of start(), or because none are sent any more.
  Status renew(const Velocity& velocity);

  // As those of MovingTarget.
  using MovingTarget::setTimeout;
  using MovingTarget::status;
  using MovingTarget::stop;
  using MovingTarget::update;
  // True while the aircraft flies at the velocities: from the end of start() to the beginning of the hold.
  bool isFlown() const { return isFollowed(); }

 private:
  static Status onOther(const MovingTarget& target, uint8_t* payload);
  bool drives() const;
  Status refuseNumber(float value, float most, ItemField field) const;
  Status refuse(const Velocity& velocity, bool isVehicleKnown) const;
  void fill(uint8_t* payload) const;

  Velocity velocity_;
};

}  // namespace mavmission
