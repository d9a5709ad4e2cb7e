#include "../SteeredFlight.h"

namespace mavmission {
using namespace detail;

const Flight::Ways SteeredFlight::kWays = {beginOrder, isOurs, hasArmed};

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

Status SteeredFlight::comeDown(FlightOrder order) { return stages_.order(order); }

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

bool SteeredFlight::isOurs(const Flight& flight) {
  return static_cast<const SteeredFlight&>(flight).steering_.maySteer();
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
