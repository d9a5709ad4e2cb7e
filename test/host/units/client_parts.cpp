// What few uploads need, by a whole client: a part of a plan, and items as MISSION_ITEM.
#include <doctest/doctest.h>
#include <string.h>

#include "Conversation.h"

using namespace mavmission;

namespace {

constexpr uint8_t kArduPilot = Conversation::kArduPilot, kPx4 = Conversation::kPx4, kOther = Conversation::kOther;
const MissionItem kPlan[] = {takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
                             changeSpeed(MetresPerSecond(5)), returnToLaunch()};

// Floats for an autopilot that may be old, when it asks for them or from the beginning.
struct Floats : Conversation {
  template <size_t N>
  Floats(uint8_t autopilot, const MissionItem (&items)[N], bool atOnce = false) : Conversation(autopilot, items) {
    client.useMissionItemFallback(atOnce);
  }
  // Of the item that left last, 4: x, 5: y, 6: z.
  float number(size_t index) const {
    float value;
    memcpy(&value, &sent.back().payload[4 * index], sizeof(value));
    return value;
  }
};

}  // namespace

TEST_CASE("a part of a plan is announced by its first and its last item, and these items go out") {
  Conversation desk(kArduPilot, kPlan);
  desk.pass(8000);
  CHECK((desk.client.uploadPartial(inRam(kPlan), 1, 2) == Status::WaitingForAutopilot));
  CHECK((desk.client.uploadPartial(inRam(kPlan), 1, 2) == Status::Busy));
  CHECK(desk.plays("100 ms, asks 2-3, accepted") == "PART 2-3, ITEM 2-3, -> Accepted (OurPlan)");  // after home
  // The same plan again goes as a whole only where it is given as a whole.
  CHECK(desk.plays("upload, until COUNT 3 s") == "COUNT 5");
}

TEST_CASE("a part that is not within its plan is refused, and there is no plan for uploadAgain() then") {
  const struct {
    uint16_t first, count;
    const char* end;
  } kParts[] = {{0, 0, "-> BadRange (NotKnown)"},
                {4, 1, "-> BadRange (NotKnown)"},
                {3, 2, "-> BadRange (NotKnown)"},
                {0, 5, "-> BadRange (NotKnown)"},
                {3, 1, "PART 4-4"},
                {0, 4, "PART 1-4"}};
  for (const auto& part : kParts) {
    Conversation desk(kArduPilot, kPlan);
    desk.pass(8000);
    const bool isGood = part.end[0] == 'P';
    const Status status = desk.client.uploadPartial(inRam(kPlan), part.first, part.count);
    CHECK((status == (isGood ? Status::WaitingForAutopilot : Status::BadRange)));
    CHECK(desk.plays("100 ms, cancel") == part.end);
    CHECK((desk.client.uploadAgain() == (isGood ? Status::WaitingForAutopilot : Status::SourceRefused)));
  }
  Conversation px4(kPx4, kPlan);
  px4.client.uploadPartial(inRam(kPlan), 1, 2);
  CHECK(px4.plays("100 ms") == "-> WholePlansOnly (NotKnown)");
}

TEST_CASE("an autopilot that may be old, and refuses the first item as unsupported, gets all items as floats") {
  Floats desk(kOther, kPlan);
  CHECK(desk.plays("upload unread, until COUNT, asks 0 | unsupported, 20 ms | ask 0 | ask 1") ==
        "COUNT 4, ITEM 0 | COUNT 4 | FLOAT ITEM 0 | FLOAT ITEM 1");
  CHECK(desk.number(4) == doctest::Approx(-35.3632621f));
  CHECK(desk.number(5) == doctest::Approx(149.1652374f));
  CHECK(desk.number(6) == 20);
  // Refused as floats too: that is the end. And from now on floats are what it gets at once.
  CHECK(desk.plays("unsupported | again, until COUNT, ask 0") ==
        "-> Unsupported at 1 (NotKnown) | COUNT 4, FLOAT ITEM 0");
}

TEST_CASE("no other refusal, no later one, none of an ArduPilot or a PX4, and none unasked begins with floats") {
  const auto ends = [](uint8_t autopilot, const std::string& events, bool isAsked = true) {
    Conversation desk(autopilot, kPlan);
    if (isAsked) desk.client.useMissionItemFallback();
    desk.plays("upload unread, until COUNT");
    return desk.plays(events + ", 50 ms");
  };
  CHECK(ends(kOther, "asks 0, no space") == "ITEM 0, -> NoSpace at 0 (NotKnown)");
  CHECK(ends(kOther, "asks 0, unsupported", false) == "ITEM 0, -> Unsupported at 0 (NotKnown)");
  CHECK(ends(kOther, "asks 0-1, unsupported") == "ITEM 0-1, -> Unsupported at 1 (NotKnown)");
  CHECK(ends(kOther, "unsupported") == "-> Unsupported (AsBefore)");
  CHECK(ends(kArduPilot, "asks 0, unsupported") == "ITEM 0, -> Unsupported (Mixture)");
  CHECK(ends(kPx4, "asks 0, unsupported") == "ITEM 0, -> Unsupported at 0 (AsBefore)");
}

TEST_CASE("floats from the beginning: no MISSION_ITEM_INT, degrees as coordinates, parameters as they are") {
  const MissionItem jumps[] = {jump(0, 3)};
  for (const uint8_t autopilot : {kOther, kPx4}) {
    Floats desk(autopilot, jumps, true);
    CHECK(desk.plays("upload unread, until COUNT, ask 0") == "COUNT 1, FLOAT ITEM 0");
    CHECK(desk.number(1) == 3);
    // PX4's checksum is that of its integers: a wrong one proves nothing here.
    CHECK(desk.plays("accepted named 7") == "-> Accepted (OurPlan)");
  }
  const MissionItem plan[] = {anyCommand(kDoDigicamControl, 0, 0, 0, 0, 7, -3), waypoint(45_deg, 180_deg, 20_m)};
  Floats desk(kOther, plan, true);
  desk.plays("upload unread, until COUNT, ask 0");
  CHECK(desk.number(4) == 7);
  CHECK(desk.number(5) == -3);
  CHECK(desk.plays("ask 1") == "FLOAT ITEM 1");
  CHECK(desk.number(4) == 45);
  CHECK(desk.number(5) == 180);
}

TEST_CASE("a plan that is refused when it begins anew as floats may have changed what was aboard before") {
  CHECK(Floats(kOther, kPlan).plays("upload unread, until COUNT, asks 0, unsupported, 20 ms | no space") ==
        "COUNT 4, ITEM 0, COUNT 4 | -> NoSpace (NotKnown)");
}
