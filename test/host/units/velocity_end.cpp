// VelocityTarget: how a velocity ends, to the millisecond.
#include <doctest/doctest.h>

#include "VelocityAircraft.h"

using namespace mavmission;
using namespace steered;

namespace {

// A copter that flies to the north, as long as the sketch renews that.
struct Flown : VelocityAircraft {
  bool renews = true;

  void loop() override {
    velocity.update();
    if (renews && nowMs() % 50 == 0) velocity.renew(earth(2, 0));
  }
  Flown& fliesNorth() {
    begin(earth(2, 0)).pass(750);
    CHECK(velocity.isFlown());
    sent.clear();
    said();
    return *this;
  }
  void upTo(uint32_t ms) {
    while (nowMs() != ms) pass(1);
  }
};

}  // namespace

TEST_CASE("a velocity that ends is one of 0 at once, for 2 s, and then a place") {
  for (bool isStopped : {false, true}) {
    CAPTURE(isStopped);
    Flown copter;
    copter.fliesNorth().renews = false;
    copter.velocity.renew(earth(2, 0));
    uint32_t endMs = copter.nowMs() + 1001;  // this loop() finds that it was not renewed
    if (isStopped) {
      copter.pass(77);
      copter.velocity.stop();
      endMs = copter.nowMs();
    }
    copter.upTo(endMs);
    copter.sent.clear();
    copter.upTo(endMs + 2000);
    CHECK_FALSE(copter.client.isBusy());
    CHECK(copter.wait(1).client.isBusy());
    std::vector<uint32_t> stillMs;  // since the end
    for (const VelocityMessage& message : copter.messages()) {
      if (uint32_t{message.time_boot_ms} < endMs) continue;
      stillMs.push_back(message.time_boot_ms - endMs);
      CHECK(float{message.vx} == 0.0f);
    }
    REQUIRE(stillMs.size() == 10);
    CHECK(stillMs[0] <= (isStopped ? 0 : 2));  // the velocity before may still be leaving
    for (uint32_t i = 0; i < 10; ++i) CHECK(stillMs[i] == stillMs[0] + 200 * i);
    CHECK(copter.status() == "Done");
    copter.pass(2);
    CHECK((copter.velocity.status() == (isStopped ? Status::Done : Status::NotRenewed)));
  }
}

TEST_CASE("another order of the sketch takes the place of a velocity, and none of 0 is sent") {
  Flown copter;
  const uint32_t orderedMs = copter.fliesNorth().goTo().wait(2).nowMs();
  CHECK(copter.status() == "Done");
  copter.pass(1000);
  for (const VelocityMessage& message : copter.messages()) CHECK(uint32_t{message.time_boot_ms} < orderedMs);
  CHECK((copter.velocity.status() == Status::Cancelled));
}

TEST_CASE("a velocity is refused while another one is flown, or another operation runs, and is then none") {
  Flown copter;
  copter.inMission().setSpeed(5);
  CHECK((copter.velocity.start(earth(2, 0)) == Status::Busy));
  CHECK((copter.velocity.status() == Status::Idle));
  copter.done();
  CHECK((copter.fliesNorth().velocity.start(earth(1, 0)) == Status::Busy));
  CHECK(copter.wait(300).times("") == 0);
  CHECK(copter.last() == "earth 2 0 0, yaw 0, turn 0, mask 0x5c7");
}

TEST_CASE("a velocity has the checksum of its message") {
  Flown copter;
  copter.fliesNorth().pass(500);
  CHECK(copter.messages().size() >= 2);
  for (const SentFrame& frame : copter.sent) {
    if (frame.messageId == kVelocity) CHECK(AnsweringPeer::packedAgain(frame, 143) == frame.frame);
  }
}
