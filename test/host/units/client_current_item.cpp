// setCurrentItem() where the autopilot does not know the command, so that the older message is sent: the answer is
// MISSION_CURRENT.
#include <doctest/doctest.h>

#include "ClientOnLine.h"

using namespace mavmission;

namespace {

const uint16_t kSetCurrent = 41, kCommandLong = 76;
const uint8_t kActive = 3;  // MISSION_STATE_ACTIVE

uint8_t low(uint16_t word) { return static_cast<uint8_t>(word & 255); }
uint8_t high(uint16_t word) { return static_cast<uint8_t>(word >> 8); }

FrameParts currentParts(uint16_t item, uint16_t total) {
  return FrameParts(42, {low(item), high(item), low(total), high(total), kActive}, 28);
}

// The command is sent, answered with MAV_RESULT_UNSUPPORTED, and the message follows.
void orderByMessage(ClientOnLine& desk, uint16_t item, uint16_t wireItem) {
  desk.run(3000);
  desk.client.setCurrentItem(item);
  REQUIRE(desk.runUntilSent(kCommandLong, 3000));
  const uint16_t command = 224;
  desk.hear(FrameParts(77, {low(command), high(command), 3, 0, 0, 0, 0, 0, 1, 191}, 143));
  REQUIRE(desk.runUntilSent(kSetCurrent, 1000));
  CHECK(desk.sent.back().payload[0] == wireItem);
}

}  // namespace

TEST_CASE("an item is current when MISSION_CURRENT names it, and not before") {
  for (const uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    const uint16_t wireItem = autopilot == ClientOnLine::kArduPilot ? 3 : 2;
    ClientOnLine desk(autopilot);
    orderByMessage(desk, 2, wireItem);
    desk.hear(currentParts(1, 0));  // a total of 0: the autopilot does not tell it
    desk.hear(currentParts(1, 6));
    desk.run(100);
    CHECK(desk.client.isBusy());
    desk.hear(currentParts(wireItem, 6));
    desk.run(100);
    CHECK((desk.ended == Status::Done));
  }
}

TEST_CASE("the last item of a plan can be current, and the one behind it cannot") {
  for (const uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    const bool isHomeCounted = autopilot == ClientOnLine::kArduPilot;
    for (const uint16_t item : {5, 6}) {
      ClientOnLine desk(autopilot);
      orderByMessage(desk, item, isHomeCounted ? item + 1 : item);
      desk.hear(currentParts(1, 6));  // the total, in which home is not counted
      desk.run(100);
      CHECK(desk.client.isBusy() == (item == 5));
      if (item == 5) continue;
      CHECK((desk.ended == Status::NoSuchItem));
      CHECK(desk.client.failedItem() == 6);
    }
  }
}

TEST_CASE("a PX4 without a plan has no item that could be current") {
  ClientOnLine desk(ClientOnLine::kPx4);
  orderByMessage(desk, 0, 0);
  desk.hear(currentParts(1, 0xFFFF));
  desk.run(100);
  CHECK((desk.ended == Status::NoSuchItem));
}
