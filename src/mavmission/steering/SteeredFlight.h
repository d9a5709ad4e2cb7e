// A Flight that the sketch steers: to places that it computes in flight, after a target, by hand, home on a signal.
#pragma once

#include "Flight.h"
#include "Steering.h"

namespace mavmission {

// Used as a Flight, and flies plans as one does; a plan in flight can be broken off by goHome() or land().
//
//   MissionClient autopilot(TELEM);
//   SteeredFlight flight(autopilot);
//
//   void setup() { flight.takeOff(10_m); }
//   void loop() {
//     if (!flight.update() || flight.state() != FlightState::AtStop) return;
//     flight.goTo(moved(place, 3000, 0), 10_m);
//   }
//
// takeOff() waits until the autopilot is ready, as Flight::fly() does. The state is AtStop at the height of takeOff()
// and at each place: there the aircraft waits for the next order, until its battery is low. **If the Arduino fails, it
// does not come down by itself: fly a plan where you can.** An order whose answer is lost is given again, for some 30
// s.
//
// It has a Steering: MovingTarget target(flight.steering()) begins to follow when the state is AtStop.
class SteeredFlight : public Flight {
 public:
  // Must live as long as the client: declare it next to the client, not in a function.
  explicit SteeredFlight(MissionClient& client);

  // Begins a flight without a plan: arms, and climbs to this height above home (Steering::takeOff()). For ArduPilot's
  // copters and QuadPlanes, and for PX4; with another vehicle it ends with Status::CommandUnsupported. Returns as
  // fly().
  Status takeOff(Metres aboveHome);

  // Orders in flight; each replaces the one before. Status::NotFlying: it is on the ground. After Ended: why(); so no
  // order takes the aircraft from a pilot or a failsafe. Otherwise Status::Transferring, and why() says if the
  // autopilot refuses the order.
  Status goTo(const LatLon& place, Altitude altitude);
  // Flies home and lands, or lands here: the state becomes Landed. On the ground the flight is given up. Right after
  // begin() also an aircraft that is in the air already, such as after a reset or a long silence, while its mode is one
  // in which it flies by itself; else Status::PilotHasIt.
  Status goHome() { return comeDown(detail::FlightOrder::Home); }
  Status land() { return comeDown(detail::FlightOrder::Land); }

  // For a MovingTarget, a VelocityTarget, or Steering::setSpeed(), in flight.
  Steering& steering() { return steering_; }

 private:
  static Status beginOrder(Flight& flight, detail::FlightOrder order);
  static detail::FlightHands hands(const Flight& flight);
  static void lookForArrival(Flight& flight);
  static bool hasArmed(const Flight& flight);
  Status comeDown(detail::FlightOrder order);

  static const Ways kWays;

  Steering steering_;
  LatLon place_;
  Altitude altitude_;
};

}  // namespace mavmission
