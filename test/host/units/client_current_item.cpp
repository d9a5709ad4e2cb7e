// setCurrentItem() where the autopilot does not know the command, so that the older message is sent: the answer is
// MISSION_CURRENT.
#include <doctest/doctest.h>

#include "Conversation.h"

using namespace mavmission;

namespace {

constexpr uint8_t kArduPilot = Conversation::kArduPilot, kPx4 = Conversation::kPx4;

// What follows the older message.
std::string ordered(uint8_t autopilot, uint16_t item, const std::string& events) {
  Conversation desk(autopilot);
  const std::string number = std::to_string(item + (autopilot == kArduPilot ? 1 : 0));
  desk.client.setCurrentItem(item);
  const std::string all = desk.plays("20 ms, answer 224 unsupported, 20 ms | " + events);
  const std::string begun = (number == "0" ? "LONG 224" : "LONG 224 " + number) + ", CURRENT " + number + " | ";
  return all.compare(0, begun.size(), begun) == 0 ? all.substr(begun.size()) : "not ordered: " + all;
}

}  // namespace

TEST_CASE("an item is current when MISSION_CURRENT names it, and not before") {
  // A total of 0: the autopilot does not tell it.
  CHECK(ordered(kArduPilot, 2, "current 1 of 0, current 1 of 6, 100 ms | current 3 of 6") == "| -> Done (NotKnown)");
  CHECK(ordered(kPx4, 2, "current 1 of 0, current 1 of 6, 100 ms | current 2 of 6") == "| -> Done (NotKnown)");
}

TEST_CASE("the last item of a plan can be current, and the one after it cannot") {
  for (const uint8_t autopilot : {kArduPilot, kPx4}) {  // in the total home is not counted
    CHECK(ordered(autopilot, 5, "current 1 of 6, 100 ms |") == "|");
    CHECK(ordered(autopilot, 6, "current 1 of 6, 100 ms |") == "-> NoSuchItem at 6 (NotKnown) |");
  }
  CHECK(ordered(kPx4, 0, "current 1 of 65535") == "-> NoSuchItem at 0 (NotKnown)");  // without a plan
}
