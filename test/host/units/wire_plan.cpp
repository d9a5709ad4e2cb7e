#include "mavmission/plan/WirePlan.h"

#include <doctest/doctest.h>
#include <stdio.h>
#include <string.h>

#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

#include "Script.h"
#include "mavmission/autopilot/Rules.h"
#include "mavmission/plan/Comparison.h"
#include "mavmission/plan/ItemSource.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

typedef std::vector<MissionItem> Items;

const float kNaN = std::numeric_limits<float>::quiet_NaN();
const float kInfinity = std::numeric_limits<float>::infinity();
constexpr int32_t kLeast = std::numeric_limits<int32_t>::min(), kMost = std::numeric_limits<int32_t>::max();

constexpr Firmware kArduPilot = Firmware::ArduPilot, kPx4 = Firmware::Px4, kOther = Firmware::Other;
const Firmware kAll[] = {kArduPilot, kPx4, kOther};

const MissionItem kHere = waypoint(-35.3632621_deg, 149.1652374_deg, 20_m);
const char* const kHereAsSent = "16 frame 3: 0 0 0 nan -353632621 1491652374 20";

float MissionItem::*const kNumbers[] = {&MissionItem::param1, &MissionItem::param2, &MissionItem::param3,
                                        &MissionItem::param4, &MissionItem::z};

MissionItem at(int32_t x, int32_t y) { return waypoint(Degrees::fromE7(x), Degrees::fromE7(y), 20_m); }
template <typename Field, typename Value>
MissionItem with(Field MissionItem::*field, Value value, MissionItem item) {
  item.*field = value;
  return item;
}

// An item as "command frame F: param1 param2 param3 param4 x y z".
std::string textOf(const MissionItem& item) {
  char text[160];
  snprintf(text, sizeof(text), "%u frame %u: %g %g %g %g %ld %ld %g%s%s", unsigned(item.command), unsigned(item.frame),
           double(item.param1), double(item.param2), double(item.param3), double(item.param4), long(item.x),
           long(item.y), double(item.z), item.current != 0 ? " current" : "", item.autocontinue != 1 ? " stops" : "");
  return text;
}

struct Plan {
  WirePlan wire;
  Items items;

  Plan(const Items& given, Firmware firmware, bool raw = false, PlanType type = PlanType::Mission, uint8_t vehicle = 2)
      : items(given) {
    memset(static_cast<void*>(&wire), 0, sizeof(wire));
    wire.setSource(inRam(items.data(), static_cast<uint32_t>(items.size())));
    wire.begin(firmware, vehicle, type, raw);
  }
  Plan(const ItemSource& source, Firmware firmware, bool raw = false) {
    memset(static_cast<void*>(&wire), 0, sizeof(wire));
    wire.setSource(source);
    wire.begin(firmware, 2, PlanType::Mission, raw);
  }
  Plan(const Plan&) = delete;

  // Wire item `index`, after as many calls as it takes.
  Status read(uint16_t index, MissionItem& item) {
    for (int calls = 0; calls < 10000; ++calls) {
      const Status status = wire.read(index, item);
      if (status == Status::Accepted && notKept(item, wire.keeper()) != ItemField::None) return Status::NotKept;
      if (status != Status::Checking) return status;
    }
    return Status::Checking;
  }
  // The sketch's item `index` as it goes out, or why it does not.
  std::string sent(uint16_t index) { return sentOnWire(wire.numbers().toWire(index)); }
  std::string sentOnWire(uint16_t index) {
    MissionItem item;
    memset(static_cast<void*>(&item), 0xFF, sizeof(item));
    const Status status = read(index, item);
    return status == Status::Accepted ? textOf(item) : nameOf(status);
  }
  // Its place alone: "x y".
  std::string place(uint16_t index) {
    MissionItem item;
    const Status status = read(wire.numbers().toWire(index), item);
    return status == Status::Accepted ? std::to_string(item.x) + " " + std::to_string(item.y) : nameOf(status);
  }
  // The last item's status.
  std::string last() {
    MissionItem item;
    return nameOf(read(static_cast<uint16_t>(wire.wireCount() - 1), item));
  }
};

std::string onPx4(const MissionItem& item, PlanType type = PlanType::Mission) {
  return Plan({item}, kPx4, false, type).sent(0);
}

// Whether the item is sent: on ArduPilot, PX4, and others; one word if it is the same on all.
std::string verdicts(const MissionItem& item, bool raw = false) {
  std::string words[3];
  for (int i = 0; i < 3; ++i) words[i] = Plan({kHere, item}, kAll[i], raw).last();
  return words[0] == words[1] && words[1] == words[2] ? words[0] : words[0] + ", " + words[1] + ", " + words[2];
}

}  // namespace

TEST_CASE("ArduPilot gets home before the plan, the others do not") {
  for (Firmware firmware : kAll) {
    for (uint16_t items : {1, 2}) {
      Plan plan(Items(items, kHere), firmware);
      const bool isArduPilot = firmware == kArduPilot;
      CHECK(plan.wire.numbers().before() == (isArduPilot ? 1 : 0));
      CHECK(plan.wire.wireCount() == (isArduPilot ? items + 1 : items));
      // CONDITION_DELAY: no home can be that. An unset yaw is 0 for ArduPilot and stays unset for the others.
      CHECK(plan.sentOnWire(0) == (isArduPilot ? "112 frame 0: 0 0 0 0 0 0 0" : kHereAsSent));
      CHECK(plan.sent(0) == (isArduPilot ? "16 frame 3: 0 0 0 0 -353632621 1491652374 20" : kHereAsSent));
    }
  }
}

TEST_CASE("an empty plan, a raw one, a fence and rally points have no home before them") {
  CHECK(Plan(Items(), kArduPilot).wire.wireCount() == 0);
  CHECK(Plan({kHere}, kArduPilot, true).wire.wireCount() == 1);
  CHECK(Plan({kHere}, kArduPilot, false, PlanType::Fence).wire.wireCount() == 1);
  CHECK(Plan({kHere}, kArduPilot, false, PlanType::Rally).wire.wireCount() == 1);
}

TEST_CASE("65,535 items are too many only where home is one more") {
  const auto plan = [](uint32_t items) { return fromFunction(nullptr, items); };
  CHECK(Plan(plan(65535), kArduPilot).wire.isTooLong());
  CHECK_FALSE(Plan(plan(65535), kArduPilot, true).wire.isTooLong());
  CHECK_FALSE(Plan(plan(65535), kPx4).wire.isTooLong());
  CHECK(Plan(plan(65535), kPx4).wire.wireCount() == 65535);
  CHECK_FALSE(Plan(plan(65534), kArduPilot).wire.isTooLong());
  CHECK(Plan(plan(65534), kArduPilot).wire.wireCount() == 65535);
}

TEST_CASE("a plan is from the source that was set last") {
  Plan plan({kHere}, kPx4);
  const auto read = [](void*, uint16_t, MissionItem&) { return false; };
  const ItemSource source = inRam(plan.items.data(), 1);
  CHECK(plan.wire.isFrom(source));
  CHECK_FALSE(plan.wire.isFrom(inRam(plan.items.data(), 2)));
  CHECK_FALSE(plan.wire.isFrom(inRam(&kHere, 1)));
  CHECK_FALSE(plan.wire.isFrom(fromFunction(read, 1, source.context)));
}

TEST_CASE("places are refused exactly beyond 90 and 180 degrees") {
  for (int sign : {1, -1}) {
    CHECK(verdicts(at(sign * 900000000, 0)) == "Accepted");
    CHECK(verdicts(at(sign * 900000001, 0)) == "BadLatitude");
    CHECK(verdicts(at(0, sign * 1800000000)) == "Accepted");
    CHECK(verdicts(at(0, sign * 1800000001)) == "BadLongitude");
  }
  for (int32_t x : {kLeast, kMost}) CHECK(verdicts(at(x, 0)) == "BadLatitude");
  CHECK(verdicts(at(0, kLeast)) == "BadLongitude");
  // Parameters 5 and 6 of an item without a place are no coordinates. (A float holds each of these; the bits of the
  // last two are those of an infinity and of a NaN.)
  for (int32_t number : {int32_t{1900000000}, kLeast, int32_t{0x7F800000}, int32_t{0x7FC00000}}) {
    CHECK(verdicts(with(&MissionItem::x, number, with(&MissionItem::y, number, returnToLaunch()))) == "Accepted");
  }
}

namespace {

// The parameters that may be NaN, but for a yaw: on PX4, and where the guide alone is followed.
bool mayBeUnset(uint16_t command, int param) {
  switch (command) {
    case 16: return param == 2;                                // NAV_WAYPOINT, the acceptance radius
    case 179: return param == 2 || param == 3 || param == 4;   // DO_SET_HOME
    case 187:                                                  // DO_SET_ACTUATOR
    case 1000: return param <= 4;                              // DO_GIMBAL_MANAGER_PITCHYAW
    case 530:                                                  // SET_CAMERA_MODE
    case 2500: return param == 3 || param == 4 || param == 7;  // VIDEO_START_CAPTURE
    case 532: return param == 4;                               // SET_CAMERA_FOCUS
    case 2000: return param == 4 || param == 7;                // IMAGE_START_CAPTURE
    case 2001:
    case 2501: return param != 1;  // IMAGE_STOP_CAPTURE, VIDEO_STOP_CAPTURE
    default: return false;
  }
}

}  // namespace

TEST_CASE("a NaN is refused but where it means unset, an infinity everywhere") {
  // PX4 does not use param3.
  const char* const kOfNaN[] = {"NotANumber", "NotANumber, Accepted, Accepted", "NotANumber, Accepted, NotANumber",
                                "Accepted", "NotANumber"};
  for (int i = 0; i < 5; ++i) {
    CAPTURE(i);
    CHECK(verdicts(with(kNumbers[i], kNaN, kHere)) == kOfNaN[i]);
    CHECK(verdicts(with(kNumbers[i], kNaN, kHere), true) == kOfNaN[i]);
    for (float infinity : {kInfinity, -kInfinity}) CHECK(verdicts(with(kNumbers[i], infinity, kHere)) == "NotFinite");
  }
  CHECK(verdicts(with(&MissionItem::param4, kNaN, changeSpeed(5_mps))) == "NotANumber");
  CHECK(onPx4(with(&MissionItem::param1, kNaN, anyCommandAt(kNavLand, 1_deg, 2_deg, 0_m))) == "NotANumber");
}

TEST_CASE("of the commands without a yaw those take a NaN to which it means something, and ArduPilot none") {
  int taken = 0;
  for (uint16_t command = 86; command < 3001; ++command) {
    for (int i = 0; i < 5; ++i) {
      const MissionItem item = with(kNumbers[i], kNaN, anyCommand(command));
      const bool isUnset = mayBeUnset(command, i < 4 ? i + 1 : 7);
      if (isUnset) ++taken;
      for (Firmware firmware : kAll) {
        const bool isUnused = command == 195 && i < 4 && firmware == kPx4;  // it uses no parameter of it
        const bool isTaken = firmware != kArduPilot && (isUnset || isUnused);
        const std::string found = Plan({kHere, item}, firmware).last();
        CHECK((found == "NotANumber") == !isTaken);
        if (isTaken && isUnset) CHECK(found == "Accepted");
      }
    }
  }
  CHECK(taken == 3 + 4 + 4 + 3 + 3 + 1 + 2 + 4 + 4);
}

TEST_CASE("what PX4 does not use goes out as 0, whatever it was, and as it is to others") {
  const struct {
    uint16_t command;
    const char* unused;  // of param1 to param4
    PlanType type;
  } kCases[] = {
      {16, "3", PlanType::Mission},     {17, "12", PlanType::Mission},   {19, "", PlanType::Mission},
      {20, "", PlanType::Mission},      {21, "3", PlanType::Mission},    {22, "123", PlanType::Mission},
      {31, "3", PlanType::Mission},     {80, "234", PlanType::Mission},  {84, "123", PlanType::Mission},
      {85, "123", PlanType::Mission},   {93, "", PlanType::Mission},     {178, "", PlanType::Mission},
      {195, "1234", PlanType::Mission}, {201, "234", PlanType::Mission}, {4501, "1234", PlanType::Mission},
      {5000, "1234", PlanType::Fence},  {5001, "234", PlanType::Fence},  {5002, "234", PlanType::Fence},
      {5003, "234", PlanType::Fence},   {5004, "234", PlanType::Fence},  {5100, "1234", PlanType::Rally},
  };
  for (const auto& one : kCases) {
    const bool hasPlace = one.command != 20 && one.command != 93 && one.command != 178;
    const MissionItem bare = hasPlace ? anyCommandAt(one.command, 1_deg, 2_deg, 20_m) : anyCommand(one.command);
    for (char number = '1'; number <= '4'; ++number) {
      CAPTURE(one.command);
      CAPTURE(number);
      const bool isRoiMode = (one.command == 80 || one.command == 201) && number == '1';  // of which 1 is no place
      if (isRoiMode) continue;
      float MissionItem::*const param = kNumbers[number - '1'];
      const bool isUnused = strchr(one.unused, number) != nullptr;
      const MissionItem item = with(param, 1.f, bare);
      MissionItem sent;
      REQUIRE((Plan({item}, kPx4, false, one.type).read(0, sent) == Status::Accepted));
      CHECK(sent.*param == (isUnused ? 0.f : 1.f));
      if (!isUnused) continue;
      CHECK(onPx4(with(param, kNaN, bare), one.type) == textOf(sent));
      CHECK(onPx4(with(param, kInfinity, bare), one.type) == "NotFinite");
      for (Firmware firmware : {kArduPilot, kOther}) {
        Plan other({item}, firmware, true, one.type);
        if (other.read(0, sent) == Status::Accepted) CHECK(sent.*param == 1.f);
      }
    }
  }
}

TEST_CASE("current says where to begin, and 2 and more would mean fly there now") {
  for (unsigned current = 0; current <= 255; ++current) {
    CHECK(verdicts(with(&MissionItem::current, static_cast<uint8_t>(current), kHere)) ==
          (current <= 1 ? "Accepted" : "BadCurrent"));
  }
}

TEST_CASE("a jump leads to an item of the plan") {
  for (float target : {0.f, 1.f}) CHECK(verdicts(anyCommand(kDoJump, target, 3)) == "Accepted");
  for (float target : {2.f, 3.f, -1.f, 0.5f, 65535.f, 65536.f, 1e9f}) {
    CAPTURE(target);
    CHECK(verdicts(anyCommand(kDoJump, target, 3)) == "BadJump");
    CHECK(verdicts(anyCommand(kDoJump, target, 3), true) == "BadJump");
  }
  // Home is no item to jump to, where the sketch's own numbers count it.
  CHECK(verdicts(anyCommand(kDoJump, 0, 3), true) == "BadJump, Accepted, Accepted");
}

TEST_CASE("a jump counts the sketch's items: with home before them it goes one further") {
  const Items items = {kHere, kHere, jump(1, 2)};
  for (Firmware firmware : {kPx4, kOther}) CHECK(Plan(items, firmware).sent(2) == "177 frame 2: 1 2 0 0 0 0 0");
  CHECK(Plan(items, kArduPilot).sent(2) == "177 frame 2: 2 2 0 0 0 0 0");
  CHECK(Plan(items, kArduPilot, true).sent(2) == "177 frame 2: 1 2 0 0 0 0 0");
}

TEST_CASE("a jump for ever goes to PX4 as the most that it counts, and comes back as it was written") {
  MissionItem item;
  REQUIRE((Plan({kHere, jump(0, -1)}, kPx4).read(1, item) == Status::Accepted));
  CHECK(textOf(item) == "177 frame 2: 0 65535 0 0 0 0 0");
  fromWire(item, kPx4);
  CHECK(textOf(item) == "177 frame 2: 0 -1 0 0 0 0 0");
  CHECK(Plan({kHere, jump(0, -1)}, kArduPilot).sent(1) == "177 frame 2: 1 -1 0 0 0 0 0");
}

TEST_CASE("an item without a place goes out in the frame that both autopilots take") {
  for (CoordinateFrame frame : {CoordinateFrame::Global, CoordinateFrame::Mission, CoordinateFrame::GlobalRelative,
                                CoordinateFrame::GlobalInt}) {
    const Items items = {kHere, with(&MissionItem::frame, frame, changeSpeed(5_mps))};
    for (Firmware firmware : kAll) CHECK(Plan(items, firmware).sent(1) == "178 frame 2: 1 5 -1 0 0 0 0");
  }
}

TEST_CASE("each frame of a place above sea level or above home is taken by both, and leaves by its newer number") {
  const CoordinateFrame kFrames[][2] = {{CoordinateFrame::Global, CoordinateFrame::Global},
                                        {CoordinateFrame::GlobalRelative, CoordinateFrame::GlobalRelative},
                                        {CoordinateFrame::GlobalInt, CoordinateFrame::Global},
                                        {CoordinateFrame::GlobalRelativeInt, CoordinateFrame::GlobalRelative}};
  for (const auto& frame : kFrames) {
    for (const Firmware firmware : kAll) {
      MissionItem sent;
      const Items items = {with(&MissionItem::frame, frame[0], kHere)};
      CHECK((Plan(items, firmware, true).read(0, sent) == Status::Accepted));
      CHECK((sent.frame == frame[1]));
      CHECK((sent.frame == modern(frame[0])));
    }
  }
}

TEST_CASE("an altitude above the ground is refused for PX4, and a frame without a name for both") {
  for (unsigned number : {10u, 11u}) {
    CHECK(verdicts(with(&MissionItem::frame, static_cast<CoordinateFrame>(number), kHere)) ==
          "Accepted, BadFrame, Accepted");
  }
  for (unsigned number : {1u, 4u, 7u, 9u, 12u, 20u, 255u}) {
    CHECK(verdicts(with(&MissionItem::frame, static_cast<CoordinateFrame>(number), kHere)) ==
          "BadFrame, BadFrame, Accepted");
  }
}

TEST_CASE("an item whose altitude is flown is refused in the frame that says of no altitude what it is measured from") {
  for (uint16_t command : {16, 17, 18, 19, 21, 22, 30, 31, 36, 82, 84, 85, 94, 113, 179, 195, 201}) {
    CAPTURE(command);
    const Items items = {kHere, anyCommand(command, 0, 0, 0, 0, 0, 0, 20)};
    for (Firmware firmware : {kArduPilot, kOther}) {
      CHECK(Plan(items, firmware).last() == (command == 113 ? "NotFlown" : "BadFrame"));
    }
    const std::string found = Plan(items, kPx4).last();
    const bool isNoPlace = command == 179 || command == 201;  // on PX4, in that frame
    if (found != "NotFlown" || isNoPlace) CHECK(found == (isNoPlace ? "Accepted" : "NeedsCoordinates"));
  }
  // Zeros are an altitude in a command of navigation alone.
  for (uint16_t command : {16, 94}) CHECK(Plan({kHere, anyCommand(command)}, kArduPilot).last() == "BadFrame");
  for (uint16_t command : {179, 201}) CHECK(Plan({kHere, anyCommand(command)}, kArduPilot).last() == "Accepted");
  for (uint16_t command : {92, 188, 189, 191}) {  // of which it is not flown
    CHECK(Plan({kHere, anyCommand(command, 0, 0, 0, 0, 10, 20, 20)}, kArduPilot).last() == "Accepted");
  }
}

TEST_CASE("what an autopilot does not fly is refused for it alone, however items are numbered") {
  for (bool raw : {false, true}) {
    CHECK(verdicts(setServo(1, 1500), raw) == "Accepted, NotFlown, Accepted");
    CHECK(verdicts(anyCommand(187), raw) == "NotFlown, Accepted, Accepted");
  }
}

TEST_CASE("ArduPilot takes altitudes below 83 km, and PX4 any") {
  for (const float metres : {82999.f, -82999.f, 82999.9921875f}) {
    CHECK(verdicts(with(&MissionItem::z, metres, kHere)) == "Accepted");
  }
  for (const float metres : {83000.f, -83000.f, 1e30f}) {
    CHECK(verdicts(with(&MissionItem::z, metres, kHere)) == "BadAltitude, Accepted, Accepted");
  }
  // The height of a fence is nothing that it looks at.
  const MissionItem circle = with(&MissionItem::z, 83000.f, fenceInsideCircle(1_deg, 1_deg, 20_m));
  CHECK(Plan({circle}, kArduPilot, false, PlanType::Fence).last() == "Accepted");
}

TEST_CASE("rally points and fences without a place are refused") {
  MissionItem point = rallyPoint(1_deg, 1_deg, 20_m), corner = fenceInsideCircle(1_deg, 1_deg, 20_m);
  point.frame = corner.frame = CoordinateFrame::Mission;
  for (Firmware firmware : {kArduPilot, kPx4}) {
    CHECK(Plan({point}, firmware, false, PlanType::Rally).last() == "NeedsCoordinates");
    CHECK(Plan({corner}, firmware, false, PlanType::Fence).last() == "NeedsCoordinates");
  }
}

TEST_CASE("on PX4 a takeoff or landing without a place gets that of the nearest item, and keeps its altitude") {
  const MissionItem west = at(10, -20), east = at(30, 40), speed = changeSpeed(5_mps), up = takeoff(15_m);
  const MissionItem vtolLand = with(&MissionItem::command, uint16_t{85}, land());
  const MissionItem noNavigation = anyCommandAt(95, 1_deg, 1_deg, 20_m);
  const struct {
    Items items;
    uint16_t index;
    const char* place;
  } kPlans[] = {
      {{up, speed, west, east}, 0, "10 -20"},
      {{west, east, speed, land()}, 3, "30 40"},
      {{land(), east}, 0, "30 40"},
      {{west, speed, speed, up, speed, east}, 3, "30 40"},
      // Of two equally near, a landing takes the one before it, a takeoff the one after it.
      {{west, land(), east}, 1, "10 -20"},
      {{west, vtolLand, east}, 1, "10 -20"},
      {{west, up, east}, 1, "30 40"},
      {{west, speed, up, speed, east}, 2, "30 40"},
      {{up, speed, returnToLaunch()}, 0, "NeedsCoordinates"},
      {{up}, 0, "NeedsCoordinates"},
      // The origin, a ROI off, an item without a place and the first command that is none of navigation are of no use.
      {{up, at(0, 0), regionOfInterestOff(), east}, 0, "30 40"},
      {{up, noNavigation, east}, 0, "30 40"},
      // The equator and the prime meridian are.
      {{up, at(0, 40)}, 0, "0 40"},
      {{up, at(30, 0)}, 0, "30 0"},
  };
  for (const auto& given : kPlans) {
    Plan plan(given.items, kPx4);
    for (int reads = 0; reads < 3; ++reads) CHECK(plan.place(given.index) == given.place);
  }
  CHECK(Plan({up, west}, kPx4).sent(0) == "22 frame 3: 0 0 0 nan 10 -20 15");
  // On ArduPilot a takeoff keeps its missing place, in raw numbers too.
  for (bool raw : {false, true}) CHECK(Plan({west, up, east}, kArduPilot, raw).place(1) == "0 0");
}

TEST_CASE("a place is looked for a few items a call, and found at either end of a long plan") {
  for (size_t placed : {size_t(0), size_t(999)}) {
    Items items(1000, changeSpeed(5_mps));
    items[placed] = at(10, -20);
    items[500] = takeoff(15_m);
    Plan plan(items, kPx4);
    MissionItem item;
    int calls = 1;
    while (plan.wire.read(500, item) == Status::Checking) ++calls;
    CHECK(item.x == 10);
    CHECK(calls >= 498 * 2 / MAVMISSION_ITEMS_PER_UPDATE);
  }
}

TEST_CASE("a search that was broken off does not reach into the next plan") {
  MissionItem item;
  Items items(200, changeSpeed(5_mps));
  items[100] = takeoff(9_m);
  Plan plan(items, kPx4);
  REQUIRE((plan.wire.read(100, item) == Status::Checking));
  plan.items = {at(10, 20), takeoff(9_m), at(30, 40)};
  plan.wire.setSource(inRam(plan.items.data(), 3));
  plan.wire.begin(kPx4, 2, PlanType::Mission, false);
  CHECK(plan.place(1) == "30 40");
}

TEST_CASE("a source that gives no item is said as such, for the item and for one that was looked at for a place") {
  struct Placeless {
    uint16_t refused, highest;

    static bool read(void* context, uint16_t index, MissionItem& item) {
      Placeless& source = *static_cast<Placeless*>(context);
      if (index > source.highest) source.highest = index;
      item = index == 1 ? takeoff(10_m) : changeSpeed(5_mps);
      return index != source.refused;
    }
  };
  Placeless refusing = {2, 0}, whole = {9, 0};
  Plan plan(fromFunction(Placeless::read, 5, &refusing), kPx4);
  CHECK(plan.sent(2) == "SourceRefused");
  CHECK(plan.sent(0) == "178 frame 2: 1 5 -1 0 0 0 0");
  CHECK(plan.sent(1) == "SourceRefused");
  // No item beyond the plan is looked at.
  CHECK(Plan(fromFunction(Placeless::read, 3, &whole), kPx4).sent(1) == "NeedsCoordinates");
  CHECK(whole.highest == 2);
}

TEST_CASE("an item from the wire is the one that a sketch would have written") {
  MissionItem place = kHere, speed = changeSpeed(5_mps);
  place.frame = CoordinateFrame::GlobalRelativeInt;
  place.param4 = 45;
  place.current = 1;
  speed.frame = CoordinateFrame::Global;
  for (const Firmware firmware : kAll) {
    const auto written = [firmware](MissionItem item) {
      fromWire(item, firmware);
      return textOf(item);
    };
    const bool isArduPilot = firmware == kArduPilot;
    CHECK(written(place) == (isArduPilot ? kHereAsSent : "16 frame 3: 0 0 0 45 -353632621 1491652374 20"));
    CHECK(written(speed) == "178 frame 2: 1 5 -1 0 0 0 0");
    CHECK(written(jump(3, 2)) == (isArduPilot ? "177 frame 2: 2 2 0 0 0 0 0" : "177 frame 2: 3 2 0 0 0 0 0"));
  }
}

TEST_CASE("a jump to a tag leads to a tag of the plan, before it or after it, and its item stays as it is") {
  const MissionItem toTag8 = anyCommand(601, 8, 2), tag7 = anyCommand(600, 7), tag8 = anyCommand(600, 8);
  const struct {
    Items items;
    uint16_t jump;
    Status status;
  } kPlans[] = {
      {{kHere, tag8, toTag8}, 2, Status::Accepted},
      {{kHere, toTag8, tag7, tag8}, 1, Status::Accepted},
      {{kHere, tag7, toTag8}, 2, Status::BadJump},
      {{kHere, toTag8, anyCommand(177, 0, 8), anyCommand(112, 8)}, 1, Status::BadJump},
      {{kHere, toTag8}, 1, Status::BadJump},
  };
  for (const auto& given : kPlans) {
    for (Firmware firmware : {kArduPilot, kOther}) {
      Plan plan(given.items, firmware);
      Status status = Status::Checking;
      for (int calls = 0; status == Status::Checking && calls < 10; ++calls) {
        MissionItem item;
        REQUIRE((plan.read(plan.wire.numbers().toWire(given.jump), item) == Status::Accepted));
        CHECK(item.param1 == 8.f);
        status = plan.wire.follow(item);
      }
      CHECK((status == given.status));
    }
  }
}

TEST_CASE("a region of interest goes to PX4 by the number that takes a place in each version, and nothing else does") {
  for (const uint16_t command : {kNavRoi, kDoSetRoiLocation, kDoSetRoi}) {
    MissionItem item;
    REQUIRE((Plan({anyCommandAt(command, 1_deg, 1_deg, 20_m)}, kPx4).read(0, item) == Status::Accepted));
    CHECK(item.command == (command == kDoSetRoi ? uint16_t{kNavRoi} : command));
  }
}

TEST_CASE("which commands have a place or a yaw does not depend on the vehicle") {
  for (uint32_t command = 0; command <= 0xFFFF; ++command) {
    const MissionItem item = anyCommand(static_cast<uint16_t>(command));
    for (Firmware firmware : kAll) {
      const Rules copter = rulesOf(item, keeperOf(firmware, 2, PlanType::Mission));
      const Rules plane = rulesOf(item, keeperOf(firmware, 1, PlanType::Mission));
      CHECK(copter.has(kHasNoPlace) == plane.has(kHasNoPlace));
      CHECK(copter.hasYaw() == plane.hasYaw());
    }
  }
}
