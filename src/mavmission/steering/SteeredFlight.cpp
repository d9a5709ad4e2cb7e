#include "SteeredFlight.h"

namespace mavmission {
using namespace detail;

const Flight::Ways SteeredFlight::kWays = {beginOrder, hands, hasArmed};

SteeredFlight::SteeredFlight(MissionClient& client)
    : Flight(client), steering_(client), place_(LatLon()), altitude_(Metres(0)) {
  ways_ = &kWays;
  lookForStop_ = lookForArrival;
}

Status SteeredFlight::takeOff(Metres aboveHome) {
  const Status status = beginWith(FlightOrder::TakeOff);
  if (status != Status::Transferring) return status;
  isSteered_ = true;
  altitude_ = aboveHome;
  return status;
}

Status SteeredFlight::goTo(const LatLon& place, Altitude altitude) {
  const Status status = stages_.order(FlightOrder::GoTo);
  if (status != Status::Transferring) return status;
  isOnTheWay_ = false;
  place_ = place;
  altitude_ = altitude;
  return status;
}

Status SteeredFlight::comeDown(FlightOrder order) {
  if (!isAsked_ || !autopilot_.isArmed()) return stages_.order(order);
  // It is in the air already.
  if (!steering_.isFlownByOrders()) return Status::PilotHasIt;
  const Status status = stages_.take(order);
  if (status != Status::Transferring) return status;
  isAsked_ = false;
  isSteered_ = true;
  steering_.requestControl();
  return status;
}

Status SteeredFlight::beginOrder(Flight& flight, FlightOrder order) {
  SteeredFlight& self = static_cast<SteeredFlight&>(flight);
  self.isSteered_ = true;
  self.comesDown_ = order == FlightOrder::Home || order == FlightOrder::Land;
  self.isOnTheWay_ = !self.comesDown_;
  switch (order) {
    case FlightOrder::TakeOff: return self.steering_.takeOff(Metres(self.altitude_.metres()));
    case FlightOrder::GoTo: return self.steering_.goTo(self.place_, self.altitude_);
    case FlightOrder::Home: return self.steering_.returnHome();
    case FlightOrder::Land: return self.steering_.landNow();
    case FlightOrder::None:
    case FlightOrder::Upload:
    case FlightOrder::Start:
    case FlightOrder::Disarm: break;
  }
  return Status::Idle;
}

FlightHands SteeredFlight::hands(const Flight& flight) {
  const Steering& steering = static_cast<const SteeredFlight&>(flight).steering_;
  // What a loop() that stood still has not read yet may say otherwise: until then it counts as it was.
  if (steering.isOurs()) return FlightHands::Own;
  return steering.mayHaveClimbed() ? FlightHands::Unclear : FlightHands::Pilot;
}

void SteeredFlight::lookForArrival(Flight& flight) {
  SteeredFlight& self = static_cast<SteeredFlight&>(flight);
  if (!self.isOnTheWay_ || self.stages_.running() != FlightOrder::None || !self.steering_.hasArrived()) return;
  self.isOnTheWay_ = false;
  self.stages_.arrive();
}

bool SteeredFlight::hasArmed(const Flight& flight) {
  return static_cast<const SteeredFlight&>(flight).steering_.step() == SteerStep::Disarm;
}

}  // namespace mavmission
