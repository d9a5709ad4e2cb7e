// VelocityTarget: how a velocity ends, to the millisecond.
#include <doctest/doctest.h>

#include "SteeredAircraft.h"
#include "mavmission/base/Checksum.h"

using namespace mavmission;
using namespace steered;

namespace {

typedef mavlink_set_position_target_local_ned_t Message;

// A copter that flies to the north, as long as the sketch renews that.
struct Flown : Aircraft {
  VelocityTarget velocity;
  bool renews = true;

  Flown() : Aircraft(kArduPilot), velocity(steering) { fly(kAuto); }
  void loop() override {
    velocity.update();
    if (renews && nowMs() % 50 == 0) velocity.renew(EarthVelocity(2_mps, 0_mps));
  }
  void begin() {
    REQUIRE((velocity.start(EarthVelocity(2_mps, 0_mps)) == Status::WaitingForAutopilot));
    REQUIRE((end() == Status::Done));
    pass(1000);
    sent.clear();
    said();
  }
  std::vector<Message> messages() const {
    std::vector<Message> found;
    for (const SentFrame& frame : sent) {
      if (frame.messageId != 84) continue;
      Message message;
      memcpy(&message, frame.payload.data(), sizeof(message));
      found.push_back(message);
    }
    return found;
  }
};

}  // namespace

TEST_CASE("a velocity that ends is one of 0 at once, for 2 s, and then a place") {
  for (bool isStopped : {false, true}) {
    CAPTURE(isStopped);
    Flown copter;
    copter.begin();
    copter.renews = false;
    copter.velocity.renew(EarthVelocity(2_mps, 0_mps));
    uint32_t endMs = copter.nowMs() + 1001;  // this loop() finds that it was not renewed
    if (isStopped) {
      copter.pass(77);
      copter.velocity.stop();
      endMs = copter.nowMs();
    }
    while (copter.nowMs() != endMs) copter.pass(1);
    copter.sent.clear();
    while (copter.nowMs() != endMs + 2000) copter.pass(1);
    CHECK_FALSE(copter.client.isBusy());
    copter.pass(1);
    CHECK(copter.client.isBusy());
    const std::vector<Message> all = copter.messages();
    REQUIRE(all.size() >= 10);
    size_t still = 0;
    uint32_t firstMs = 0;
    for (const Message& message : all) {
      if (uint32_t{message.time_boot_ms} < endMs) continue;
      if (still == 0) firstMs = message.time_boot_ms;
      CHECK(uint32_t{message.time_boot_ms} == firstMs + 200 * still);
      ++still;
      CHECK(float{message.vx} == 0.0f);
    }
    CHECK(still == 10);
    CHECK(firstMs - endMs <= (isStopped ? 0 : 2));  // the velocity before may still be leaving
    CHECK((copter.end() == Status::Done));
    copter.pass(2);
    CHECK((copter.velocity.status() == (isStopped ? Status::Done : Status::NotRenewed)));
  }
}

TEST_CASE("another order of the sketch takes the place of a velocity, and none of 0 is sent") {
  Flown copter;
  copter.begin();
  copter.steering.goTo({-35.3630000_deg, 149.1652374_deg}, 20_m);
  copter.pass(2);
  const uint32_t orderedMs = copter.nowMs();
  CHECK((copter.end() == Status::Done));
  copter.pass(1000);
  for (const Message& message : copter.messages()) CHECK(uint32_t{message.time_boot_ms} < orderedMs);
  CHECK((copter.velocity.status() == Status::Cancelled));
}

TEST_CASE("a velocity is refused while another one is flown, or another operation runs, and is then none") {
  Flown copter;
  copter.steering.setSpeed(5_mps);
  CHECK((copter.velocity.start(EarthVelocity(2_mps, 0_mps)) == Status::Busy));
  CHECK((copter.velocity.status() == Status::Idle));
  REQUIRE((copter.end() == Status::Done));
  copter.begin();
  CHECK((copter.velocity.start(EarthVelocity(1_mps, 0_mps)) == Status::Busy));
  CHECK(float{copter.messages().size() != 0 ? copter.messages().back().vx : 2.0f} == 2.0f);
}

TEST_CASE("a velocity has the checksum of its message") {
  Flown copter;
  copter.begin();
  copter.pass(500);
  size_t found = 0;
  for (const SentFrame& frame : copter.sent) {
    if (frame.messageId != 84) continue;
    ++found;
    const uint8_t extra = 143;
    uint16_t crc = detail::kChecksumStart;
    for (size_t i = 1; i + 2 < frame.frame.size(); ++i) crc = detail::checksum(crc, &frame.frame[i], 1);
    crc = detail::checksum(crc, &extra, 1);
    CHECK(frame.frame[frame.frame.size() - 2] == static_cast<uint8_t>(crc));
    CHECK(frame.frame[frame.frame.size() - 1] == crc >> 8);
  }
  CHECK(found >= 2);
}
