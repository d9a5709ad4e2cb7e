// VelocityTarget by a whole client: what a velocity is on the wire, and that it ends in standing still.
#include <doctest/doctest.h>

#include "VelocityAircraft.h"

using namespace mavmission;
using namespace steered;

namespace {

const char kStill[] = "body 0 0 0, yaw 0, turn 0, mask 0x5c7";

}  // namespace

TEST_CASE("a velocity is that of the sketch, in the frame and with the turn that it names") {
  VelocityAircraft copter;
  copter.begin(earth(2, -1, 3));
  CHECK(copter.last() == "earth 2 -1 -3, yaw 0, turn 0, mask 0x5c7");
  CHECK(copter.flown(body(1, 2, -3).turning(180_dps)) == "body 1 2 3, yaw 0, turn 3.1416, mask 0x5c7");
}

TEST_CASE("a velocity that is not renewed is one of 0, and then the aircraft is told where to stay") {
  VelocityAircraft copter;
  copter.begin(earth(2, 0).facing(90_deg)).wait(1250).said();
  CHECK(copter.last() == kStill);
  CHECK((copter.velocity.status() == Status::Transferring));
  CHECK((copter.velocity.renew(earth(2, 0)) == Status::NotRenewed));
  copter.sent.clear();
  for (int i = 0; i < 5; ++i) {
    copter.pass(200);
    CHECK(copter.last() == kStill);
  }
  CHECK(copter.said() == "");
  CHECK(copter.how() == "Done at Confirm: L511 33 500000 0 0 0 0 0, I192 frame 6 -1 0 0 nan -353632621 1491652374 0");
}

TEST_CASE("a heartbeat with a pilot's mode ends the velocities, at once and for good") {
  VelocityAircraft copter;
  copter.begin(body(2)).velocity.stop();
  copter.wait(300).show(kLoiter);
  copter.wait(10).forget();
  CHECK((copter.velocity.status() == Status::PilotHasIt));
  copter.mode = kGuided;
  CHECK((copter.velocity.renew(body(2)) == Status::PilotHasIt));
  CHECK(copter.wait(3000).said() == "");
  CHECK(copter.last() == "");
}

TEST_CASE("one stream at a time: a place that is followed ends the velocity without a gap, and a velocity ends it") {
  VelocityAircraft copter;
  MovingTarget place(copter.steering);
  copter.begin(body(2)).pass(600);
  for (bool isPlace : {true, false}) {
    isPlace ? place.start(kThere, 20_m) : copter.velocity.start(body(2));
    copter.sent.clear();
    for (int ms = 0; ms < 2000; ++ms) {
      place.renew(kThere, 20_m);
      copter.velocity.renew(body(2));
      place.update();
      copter.pass(1);
    }
    CHECK(place.isFollowed() == isPlace);
    CHECK(copter.velocity.isFlown() != isPlace);
    const std::vector<uint32_t> places = copter.timesOf(86, 0), velocities = copter.timesOf(kVelocity, 0);
    const std::vector<uint32_t>&ended = isPlace ? velocities : places, &begun = isPlace ? places : velocities;
    REQUIRE_FALSE(begun.empty());
    CHECK((ended.empty() || ended.back() <= begun.front()));
    CHECK(((isPlace ? copter.velocity.status() : place.status()) == Status::Cancelled));
  }
}
