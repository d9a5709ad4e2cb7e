#include "mavmission/plan/WirePlan.h"

#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>
#include <limits>
#include <vector>

#include "mavmission/autopilot/Rules.h"
#include "mavmission/plan/Comparison.h"
#include "mavmission/plan/ItemSource.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

const float kNaN = std::numeric_limits<float>::quiet_NaN();
const float kInfinity = std::numeric_limits<float>::infinity();

const MissionItem kHere = waypoint(-35.3632621_deg, 149.1652374_deg, 20_m);

struct Plan {
  WirePlan wire;
  std::vector<MissionItem> items;

  Plan(const std::vector<MissionItem>& given, Firmware firmware, bool raw = false, PlanType type = PlanType::Mission,
       uint8_t vehicle = 2)
      : items(given) {
    memset(static_cast<void*>(&wire), 0, sizeof(wire));
    wire.setSource(inRam(items.data(), static_cast<uint32_t>(items.size())));
    wire.begin(firmware, vehicle, type, raw);
  }
  Plan(const Plan&) = delete;

  // Item `index` as it goes out, after as many calls as it takes.
  Status read(uint16_t index, MissionItem& item) {
    for (int calls = 0; calls < 10000; ++calls) {
      const Status status = wire.read(index, item);
      if (status == Status::Accepted && notKept(item, wire.keeper()) != ItemField::None) return Status::NotKept;
      if (status != Status::Checking) return status;
    }
    return Status::Checking;
  }
  // The last item's status.
  Status last() {
    MissionItem item;
    return read(static_cast<uint16_t>(wire.wireCount() - 1), item);
  }
};

Status check(const MissionItem& item, Firmware firmware = Firmware::Other, bool raw = false) {
  return Plan({kHere, item}, firmware, raw).last();
}

MissionItem at(int32_t x, int32_t y) { return waypoint(Degrees::fromE7(x), Degrees::fromE7(y), 20_m); }

const Firmware kAll[] = {Firmware::ArduPilot, Firmware::Px4, Firmware::Other};

}  // namespace

TEST_CASE("ArduPilot gets home before the plan, the others do not") {
  MissionItem item;
  for (Firmware firmware : kAll) {
    Plan plan({kHere, kHere}, firmware);
    const bool isArduPilot = firmware == Firmware::ArduPilot;
    CHECK(plan.wire.numbers().before() == (isArduPilot ? 1 : 0));
    CHECK(plan.wire.wireCount() == (isArduPilot ? 3 : 2));
    CHECK((plan.read(0, item) == Status::Accepted));
    CHECK(item.command == (isArduPilot ? 112 : kNavWaypoint));  // CONDITION_DELAY: no home can be that
    CHECK(item.x == (isArduPilot ? 0 : kHere.x));
    CHECK((item.frame == (isArduPilot ? CoordinateFrame::Global : CoordinateFrame::GlobalRelative)));
  }
}

TEST_CASE("an empty plan, a raw one, a fence and rally points have no home before them") {
  CHECK(Plan({}, Firmware::ArduPilot).wire.wireCount() == 0);
  CHECK(Plan({kHere}, Firmware::ArduPilot, true).wire.wireCount() == 1);
  CHECK(Plan({kHere}, Firmware::ArduPilot, false, PlanType::Fence).wire.wireCount() == 1);
  CHECK(Plan({kHere}, Firmware::ArduPilot, false, PlanType::Rally).wire.wireCount() == 1);
}

TEST_CASE("65,535 items are too many only where home is one more") {
  WirePlan wire;
  memset(static_cast<void*>(&wire), 0, sizeof(wire));
  wire.setSource(fromFunction(nullptr, 65535));
  wire.begin(Firmware::ArduPilot, 2, PlanType::Mission, false);
  CHECK(wire.isTooLong());
  wire.begin(Firmware::ArduPilot, 2, PlanType::Mission, true);
  CHECK_FALSE(wire.isTooLong());
  wire.begin(Firmware::Px4, 2, PlanType::Mission, false);
  CHECK_FALSE(wire.isTooLong());
  CHECK(wire.wireCount() == 65535);
  wire.setSource(fromFunction(nullptr, 65534));
  wire.begin(Firmware::ArduPilot, 2, PlanType::Mission, false);
  CHECK_FALSE(wire.isTooLong());
  CHECK(wire.wireCount() == 65535);
}

TEST_CASE("places are refused exactly beyond 90 and 180 degrees") {
  for (Firmware firmware : kAll) {
    for (int sign : {1, -1}) {
      CHECK((check(at(sign * 900000000, 0), firmware) == Status::Accepted));
      CHECK((check(at(sign * 900000001, 0), firmware) == Status::BadLatitude));
      CHECK((check(at(0, sign * 1800000000), firmware) == Status::Accepted));
      CHECK((check(at(0, sign * 1800000001), firmware) == Status::BadLongitude));
    }
    CHECK((check(at(std::numeric_limits<int32_t>::min(), 0), firmware) == Status::BadLatitude));
    CHECK((check(at(std::numeric_limits<int32_t>::max(), 0), firmware) == Status::BadLatitude));
    CHECK((check(at(0, std::numeric_limits<int32_t>::min()), firmware) == Status::BadLongitude));
  }
}

TEST_CASE("parameters 5 and 6 of an item without a place are no coordinates") {
  MissionItem home = returnToLaunch();
  home.x = home.y = 1900000000;
  CHECK((check(home, Firmware::ArduPilot) == Status::Accepted));
  CHECK((check(home, Firmware::Other) == Status::Accepted));
  home.x = home.y = std::numeric_limits<int32_t>::min();  // which a float holds
  for (Firmware firmware : kAll) CHECK((check(home, firmware) == Status::Accepted));
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
  float MissionItem::*const numbers[] = {&MissionItem::param1, &MissionItem::param2, &MissionItem::param3,
                                         &MissionItem::param4, &MissionItem::z};
  for (Firmware firmware : kAll) {
    for (float MissionItem::*number : numbers) {
      MissionItem item = kHere;
      item.*number = kNaN;
      const bool isRadius = number == &MissionItem::param2 && firmware != Firmware::ArduPilot;
      const bool isUnused = number == &MissionItem::param3 && firmware == Firmware::Px4;
      const bool isUnset = number == &MissionItem::param4 || isRadius || isUnused;
      CHECK((check(item, firmware) == (isUnset ? Status::Accepted : Status::NotANumber)));
      CHECK((check(item, firmware, true) == (isUnset ? Status::Accepted : Status::NotANumber)));
      item.*number = kInfinity;
      CHECK((check(item, firmware) == Status::NotFinite));
      item.*number = -kInfinity;
      CHECK((check(item, firmware) == Status::NotFinite));
    }
    MissionItem speed = changeSpeed(5_mps);
    speed.param4 = kNaN;
    CHECK((check(speed, firmware) == Status::NotANumber));
  }
}

TEST_CASE("of the commands without a yaw those take a NaN to which it means something, and ArduPilot none") {
  float MissionItem::*const numbers[] = {&MissionItem::param1, &MissionItem::param2, &MissionItem::param3,
                                         &MissionItem::param4, &MissionItem::z};
  int taken = 0;
  for (uint16_t command = 86; command < 3001; ++command) {
    for (int i = 0; i < 5; ++i) {
      MissionItem item = anyCommand(command);
      item.*numbers[i] = kNaN;
      const bool isUnset = mayBeUnset(command, i < 4 ? i + 1 : 7);
      if (isUnset) ++taken;
      for (Firmware firmware : {Firmware::Px4, Firmware::Other}) {
        // PX4 uses no parameter of it.
        const bool isUnused = command == 195 && i < 4 && firmware == Firmware::Px4;
        CHECK((check(item, firmware) == Status::NotANumber) == !(isUnset || isUnused));
        if (isUnset) CHECK((check(item, firmware) == Status::Accepted));
      }
      CHECK((check(item, Firmware::ArduPilot) == Status::NotANumber));
    }
  }
  CHECK(taken == 3 + 4 + 4 + 3 + 3 + 1 + 2 + 4 + 4);
}

TEST_CASE("what PX4 does not use goes out as 0, whatever it was, and as it is to others") {
  float MissionItem::*const params[] = {&MissionItem::param1, &MissionItem::param2, &MissionItem::param3,
                                        &MissionItem::param4};
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
    CAPTURE(one.command);
    const bool hasPlace = one.command != 20 && one.command != 93 && one.command != 178;
    for (char number = '1'; number <= '4'; ++number) {
      CAPTURE(number);
      float MissionItem::*const param = params[number - '1'];
      const bool isUnused = strchr(one.unused, number) != nullptr;
      MissionItem item = hasPlace ? anyCommandAt(one.command, 1_deg, 2_deg, 20_m) : anyCommand(one.command);
      MissionItem sent;
      item.*param = 1;
      Plan whole({item}, Firmware::Px4, false, one.type);
      const bool isRoiMode = (one.command == 80 || one.command == 201) && number == '1';  // of which 1 is no place
      if (isRoiMode) continue;
      REQUIRE((whole.read(0, sent) == Status::Accepted));
      if (isUnused) {
        CHECK(sent.*param == 0.f);
        item.*param = kNaN;
        Plan unset({item}, Firmware::Px4, false, one.type);
        REQUIRE((unset.read(0, sent) == Status::Accepted));
        CHECK(sent.*param == 0.f);
        item.*param = kInfinity;
        CHECK((Plan({item}, Firmware::Px4, false, one.type).last() == Status::NotFinite));
        item.*param = 1;
        Plan other({item}, Firmware::Other, false, one.type);
        if (other.read(0, sent) == Status::Accepted) CHECK(sent.*param == 1.f);
        Plan arduPilot({item}, Firmware::ArduPilot, true, one.type);
        if (arduPilot.read(0, sent) == Status::Accepted) CHECK(sent.*param == 1.f);
      } else {
        CHECK(sent.*param == 1.f);
      }
    }
  }
}

TEST_CASE("on PX4 a landing keeps the height to abort at, which 1.18 uses, and to 1.17 it may come back as 0") {
  MissionItem land = anyCommandAt(kNavLand, 1_deg, 2_deg, 0_m), sent;
  land.param1 = 12;
  Plan plan({land}, Firmware::Px4);
  REQUIRE((plan.read(0, sent) == Status::Accepted));
  CHECK(sent.param1 == 12.f);
  MissionItem read = sent;
  CHECK((difference(sent, read, plan.wire.keeper()) == ItemField::None));
  read.param1 = 0;
  CHECK((difference(sent, read, plan.wire.keeper()) == ItemField::None));
  read.param1 = 5;
  CHECK((difference(sent, read, plan.wire.keeper()) == ItemField::Param1));
  land.param1 = kNaN;
  CHECK((check(land, Firmware::Px4) == Status::NotANumber));
}

TEST_CASE("PX4 gets DO_AUTOTUNE_ENABLE, which newer ones take") {
  MissionItem item = anyCommand(212, 1, 2), sent;
  Plan plan({item}, Firmware::Px4);
  REQUIRE((plan.read(0, sent) == Status::Accepted));
  CHECK((sent.frame == CoordinateFrame::Mission));
  CHECK(sent.param1 == 1.f);
  CHECK(sent.param2 == 2.f);
}

TEST_CASE("current says where to begin, and 2 and more would mean fly there now") {
  for (unsigned current = 0; current <= 255; ++current) {
    MissionItem item = kHere;
    item.current = static_cast<uint8_t>(current);
    for (Firmware firmware : kAll) {
      CHECK((check(item, firmware) == (current <= 1 ? Status::Accepted : Status::BadCurrent)));
    }
  }
}

TEST_CASE("a jump leads to an item of the plan") {
  for (float target : {0.f, 1.f}) CHECK((check(anyCommand(kDoJump, target, 3)) == Status::Accepted));
  for (float target : {2.f, 3.f, -1.f, 0.5f, 65535.f, 65536.f, 1e9f}) {
    CAPTURE(target);
    for (Firmware firmware : kAll) {
      CHECK((check(anyCommand(kDoJump, target, 3), firmware) == Status::BadJump));
      CHECK((check(anyCommand(kDoJump, target, 3), firmware, true) == Status::BadJump));
    }
  }
}

TEST_CASE("a jump counts the sketch's items: with home before them it goes one further") {
  MissionItem item;
  for (Firmware firmware : kAll) {
    Plan plan({kHere, kHere, jump(1, 2)}, firmware);
    REQUIRE((plan.read(static_cast<uint16_t>(plan.wire.wireCount() - 1), item) == Status::Accepted));
    CHECK(item.param1 == (firmware == Firmware::ArduPilot ? 2.f : 1.f));
    CHECK(item.param2 == 2.f);
    CHECK((item.frame == CoordinateFrame::Mission));
  }
  Plan raw({kHere, kHere, jump(1, 2)}, Firmware::ArduPilot, true);
  REQUIRE((raw.read(2, item) == Status::Accepted));
  CHECK(item.param1 == 1.f);
}

TEST_CASE("an item without a place goes out in the frame that both autopilots take") {
  MissionItem item;
  for (Firmware firmware : kAll) {
    MissionItem speed = changeSpeed(5_mps);
    for (CoordinateFrame frame : {CoordinateFrame::Global, CoordinateFrame::Mission, CoordinateFrame::GlobalRelative,
                                  CoordinateFrame::GlobalInt}) {
      speed.frame = frame;
      Plan plan({kHere, speed}, firmware);
      REQUIRE((plan.read(static_cast<uint16_t>(plan.wire.wireCount() - 1), item) == Status::Accepted));
      CHECK((item.frame == CoordinateFrame::Mission));
    }
  }
}

TEST_CASE("an altitude above the ground is refused for PX4, and a frame without a name for both") {
  for (CoordinateFrame frame : {CoordinateFrame::GlobalTerrain, CoordinateFrame::GlobalTerrainInt}) {
    MissionItem item = kHere;
    item.frame = frame;
    CHECK((check(item, Firmware::Px4) == Status::BadFrame));
    CHECK((check(item, Firmware::ArduPilot) == Status::Accepted));
    CHECK((check(item, Firmware::Other) == Status::Accepted));
  }
  for (unsigned number : {1u, 4u, 7u, 9u, 12u, 20u, 255u}) {
    MissionItem item = kHere;
    item.frame = static_cast<CoordinateFrame>(number);
    CHECK((check(item, Firmware::Px4) == Status::BadFrame));
    CHECK((check(item, Firmware::ArduPilot) == Status::BadFrame));
    CHECK((check(item, Firmware::Other) == Status::Accepted));
  }
}

TEST_CASE("what an autopilot does not fly is refused for it alone, however items are numbered") {
  const MissionItem servo = setServo(1, 1500);
  CHECK((check(servo, Firmware::Px4) == Status::NotFlown));
  CHECK((check(servo, Firmware::Px4, true) == Status::NotFlown));
  CHECK((check(servo, Firmware::ArduPilot) == Status::Accepted));
  const MissionItem actuator = anyCommand(187);
  CHECK((check(actuator, Firmware::ArduPilot) == Status::NotFlown));
  CHECK((check(actuator, Firmware::Px4) == Status::Accepted));
}

TEST_CASE("an unset yaw is 0 for ArduPilot and stays unset for the others") {
  MissionItem item;
  for (Firmware firmware : kAll) {
    Plan plan({kHere}, firmware);
    REQUIRE((plan.read(static_cast<uint16_t>(plan.wire.wireCount() - 1), item) == Status::Accepted));
    CHECK((item.param4 != item.param4) == (firmware != Firmware::ArduPilot));
    if (firmware == Firmware::ArduPilot) CHECK(item.param4 == 0.f);
  }
}

TEST_CASE("on PX4 a takeoff or landing without a place gets that of the nearest item, and keeps its altitude") {
  const MissionItem west = at(10, -20), east = at(30, 40);
  MissionItem item;

  Plan takeoffFirst({takeoff(15_m), changeSpeed(5_mps), west, east}, Firmware::Px4);
  REQUIRE((takeoffFirst.read(0, item) == Status::Accepted));
  CHECK(item.x == west.x);
  CHECK(item.y == west.y);
  CHECK(item.z == 15.f);

  Plan landLast({west, east, changeSpeed(5_mps), land()}, Firmware::Px4);
  REQUIRE((landLast.read(3, item) == Status::Accepted));
  CHECK(item.x == east.x);

  // Of two equally near, a landing takes the one before it, a takeoff the one behind it.
  Plan landBetween({west, land(), east}, Firmware::Px4);
  REQUIRE((landBetween.read(1, item) == Status::Accepted));
  CHECK(item.x == west.x);
  MissionItem vtolLand = land();
  vtolLand.command = 85;
  Plan vtolBetween({west, vtolLand, east}, Firmware::Px4);
  REQUIRE((vtolBetween.read(1, item) == Status::Accepted));
  CHECK(item.x == west.x);
  Plan takeoffBetween({west, takeoff(9_m), east}, Firmware::Px4);
  REQUIRE((takeoffBetween.read(1, item) == Status::Accepted));
  CHECK(item.x == east.x);

  Plan nowhere({takeoff(15_m), changeSpeed(5_mps), returnToLaunch()}, Firmware::Px4);
  CHECK((nowhere.read(0, item) == Status::NeedsCoordinates));
  Plan alone({takeoff(15_m)}, Firmware::Px4);
  CHECK((alone.read(0, item) == Status::NeedsCoordinates));

  Plan onArduPilot({takeoff(15_m), west}, Firmware::ArduPilot);
  REQUIRE((onArduPilot.read(1, item) == Status::Accepted));
  CHECK(item.x == 0);
}

TEST_CASE("a place is looked for a few items a call, and found at either end of a long plan") {
  for (size_t placed : {size_t(0), size_t(999)}) {
    std::vector<MissionItem> items(1000, changeSpeed(5_mps));
    items[placed] = at(10, -20);
    items[500] = takeoff(15_m);
    Plan plan(items, Firmware::Px4);
    MissionItem item;
    int calls = 1;
    while (plan.wire.read(500, item) == Status::Checking) ++calls;
    CHECK(item.x == 10);
    CHECK(calls >= 498 * 2 / MAVMISSION_ITEMS_PER_UPDATE);
  }
}

TEST_CASE("a place that is of no use is not taken: the origin, a ROI off, an item without a place") {
  MissionItem item;
  Plan plan({takeoff(15_m), at(0, 0), regionOfInterestOff(), at(30, 40)}, Firmware::Px4);
  REQUIRE((plan.read(0, item) == Status::Accepted));
  CHECK(item.x == 30);
}

TEST_CASE("a source that gives no item is said as such, for the item and for one that was looked at for a place") {
  struct Refusing {
    static bool read(void* context, uint16_t index, MissionItem& item) {
      if (index == *static_cast<uint16_t*>(context)) return false;
      item = index == 0 ? takeoff(10_m) : changeSpeed(5_mps);
      return true;
    }
  };
  uint16_t refused = 2;
  WirePlan wire;
  memset(static_cast<void*>(&wire), 0, sizeof(wire));
  wire.setSource(fromFunction(Refusing::read, 5, &refused));
  wire.begin(Firmware::Px4, 2, PlanType::Mission, false);
  MissionItem item;
  CHECK((wire.read(2, item) == Status::SourceRefused));
  CHECK((wire.read(1, item) == Status::Accepted));
  Status status = wire.read(0, item);
  for (int calls = 0; status == Status::Checking && calls < 10; ++calls) status = wire.read(0, item);
  CHECK((status == Status::SourceRefused));
}

TEST_CASE("a jump for ever goes to PX4 as the most that it counts, and comes back as it was written") {
  MissionItem item;
  Plan plan({kHere, jump(0, -1)}, Firmware::Px4);
  REQUIRE((plan.read(1, item) == Status::Accepted));
  CHECK(item.param2 == 65535.f);
  fromWire(item, Firmware::Px4);
  CHECK(item.param2 == -1.f);
  Plan onArduPilot({kHere, jump(0, -1)}, Firmware::ArduPilot);
  REQUIRE((onArduPilot.read(2, item) == Status::Accepted));
  CHECK(item.param2 == -1.f);
}

TEST_CASE("ArduPilot takes altitudes below 83 km, and PX4 any") {
  MissionItem item = kHere;
  for (const float metres : {82999.f, -82999.f, 82999.9921875f}) {
    item.z = metres;
    for (Firmware firmware : kAll) CHECK((check(item, firmware) == Status::Accepted));
  }
  for (const float metres : {83000.f, -83000.f, 1e30f}) {
    item.z = metres;
    CHECK((check(item, Firmware::ArduPilot) == Status::BadAltitude));
    CHECK((check(item, Firmware::Px4) == Status::Accepted));
  }
}

TEST_CASE("the height of a fence is nothing that ArduPilot looks at") {
  MissionItem circle = fenceInsideCircle(1_deg, 1_deg, 20_m);
  circle.z = 83000.f;
  CHECK((Plan({circle}, Firmware::ArduPilot, false, PlanType::Fence).last() == Status::Accepted));
}

TEST_CASE("rally points and fences without a place are refused") {
  MissionItem point = rallyPoint(1_deg, 1_deg, 20_m), corner = fenceInsideCircle(1_deg, 1_deg, 20_m);
  point.frame = corner.frame = CoordinateFrame::Mission;
  for (Firmware firmware : {Firmware::ArduPilot, Firmware::Px4}) {
    CHECK((Plan({point}, firmware, false, PlanType::Rally).last() == Status::NeedsCoordinates));
    CHECK((Plan({corner}, firmware, false, PlanType::Fence).last() == Status::NeedsCoordinates));
  }
}

TEST_CASE("what would be kept as another value is refused, and a value that is kept is not") {
  const struct {
    MissionItem kept, other;
    Firmware firmware;
    uint8_t vehicle;
  } kPairs[] = {
      {loiterTurns(1_deg, 1_deg, 20_m, 255), loiterTurns(1_deg, 1_deg, 20_m, 300), Firmware::ArduPilot, 2},
      {loiterTurns(1_deg, 1_deg, 20_m, 0.25f), loiterTurns(1_deg, 1_deg, 20_m, 1.5f), Firmware::ArduPilot, 2},
      {loiterTurns(1_deg, 1_deg, 20_m, 1, 300_m), loiterTurns(1_deg, 1_deg, 20_m, 1, 303_m), Firmware::ArduPilot, 2},
      {waypoint(1_deg, 1_deg, 20_m, 65535_s), waypoint(1_deg, 1_deg, 20_m, 65536_s), Firmware::ArduPilot, 2},
      {waypoint(1_deg, 1_deg, 20_m, 2_s), waypoint(1_deg, 1_deg, 20_m, 2.5_s), Firmware::ArduPilot, 2},
      {waypoint(1_deg, 1_deg, 20_m, 0_s), waypoint(1_deg, 1_deg, 20_m, 1_s), Firmware::ArduPilot, 1},
      {waypoint(1_deg, 1_deg, 20_m, 0_s, 2_m), waypoint(1_deg, 1_deg, 20_m, 0_s, 2.5_m), Firmware::ArduPilot, 1},
      {waypoint(1_deg, 1_deg, 20_m, 0_s, 255_m), waypoint(1_deg, 1_deg, 20_m, 0_s, 256_m), Firmware::ArduPilot, 1},
      {loiterTime(1_deg, 1_deg, 20_m, 5_s, -(1_m)), loiterTime(1_deg, 1_deg, 20_m, 5_s, 50_m), Firmware::ArduPilot, 1},
      {loiterTime(1_deg, 1_deg, 20_m, 5_s, 50_m), loiterTime(1_deg, 1_deg, 20_m, 5.5_s), Firmware::ArduPilot, 2},
      {delay(1.5_s), anyCommand(kNavDelay, 1, 128), Firmware::ArduPilot, 2},
      {anyCommand(kDoJump, 0, 32767), anyCommand(kDoJump, 0, 32768), Firmware::ArduPilot, 2},
      {anyCommand(kDoJump, 0, 65535), anyCommand(kDoJump, 0, -2), Firmware::Px4, 2},
      {waypoint(1_deg, 1_deg, 20_m, 0_s, 0_m, -180_deg), anyCommandAt(kNavWaypoint, 1_deg, 1_deg, 20_m, 0, 0, 0, -181),
       Firmware::Px4, 2},
      {waypoint(1_deg, 1_deg, 20_m, 0_s, 0_m, 360_deg), anyCommandAt(kNavWaypoint, 1_deg, 1_deg, 20_m, 0, 0, 0, 361),
       Firmware::Px4, 2},
      {anyCommand(kNavReturnToLaunch, 0, 0, 0, 0, 1 << 24), anyCommand(kNavReturnToLaunch, 0, 0, 0, 0, (1 << 24) + 1),
       Firmware::Px4, 2},
  };
  for (const auto& pair : kPairs) {
    CAPTURE(pair.kept.command);
    CAPTURE(pair.other.param1);
    CHECK((Plan({kHere, pair.kept}, pair.firmware, false, PlanType::Mission, pair.vehicle).last() == Status::Accepted));
    CHECK((Plan({kHere, pair.other}, pair.firmware, false, PlanType::Mission, pair.vehicle).last() == Status::NotKept));
    CHECK((Plan({kHere, pair.other}, Firmware::Other).last() == Status::Accepted));
  }
}

TEST_CASE("an item from the wire is the one that a sketch would have written") {
  for (const Firmware firmware : kAll) {
    const bool isArduPilot = firmware == Firmware::ArduPilot;
    MissionItem item = kHere;
    item.frame = CoordinateFrame::GlobalRelativeInt;
    item.param4 = 45;
    item.current = 1;
    fromWire(item, firmware);
    CHECK((item.frame == CoordinateFrame::GlobalRelative));
    CHECK(item.current == 0);
    CHECK((item.param4 != item.param4) == isArduPilot);
    if (!isArduPilot) CHECK(item.param4 == 45.f);
    item = changeSpeed(5_mps);
    item.frame = CoordinateFrame::Global;
    const MissionItem speed = item;
    fromWire(item, firmware);
    CHECK((item.frame == CoordinateFrame::Mission));
    CHECK(item.param1 == speed.param1);
    CHECK(item.param4 == speed.param4);
    item = jump(3, 2);
    fromWire(item, firmware);
    CHECK(item.param1 == (isArduPilot ? 2.f : 3.f));
    CHECK(item.param2 == 2.f);
  }
}

TEST_CASE("an item whose altitude is flown is refused in the frame that says of no altitude what it is measured from") {
  for (uint16_t command : {16, 17, 18, 19, 21, 22, 30, 31, 36, 82, 84, 85, 94, 113, 179, 195, 201}) {
    for (Firmware firmware : kAll) {
      CAPTURE(command);
      const MissionItem item = anyCommand(command, 0, 0, 0, 0, 0, 0, 20);
      const Status found = check(item, firmware);
      if (firmware == Firmware::Px4) {
        const bool isNoPlace = command == 179 || command == 201;  // on PX4, in that frame
        CHECK((found == (isNoPlace ? Status::Accepted : found == Status::NotFlown ? found : Status::NeedsCoordinates)));
      } else {
        CHECK((found == (command == 113 ? Status::NotFlown : Status::BadFrame)));
      }
    }
  }
  for (uint16_t command : {92, 188, 189, 191}) {  // of which it is not flown
    CHECK((check(anyCommand(command, 0, 0, 0, 0, 10, 20, 20), Firmware::ArduPilot) == Status::Accepted));
  }
}

TEST_CASE("a jump to a tag leads to a tag of the plan, before it or behind it, and its item stays as it is") {
  const MissionItem toTag8 = anyCommand(601, 8, 2), tag7 = anyCommand(600, 7), tag8 = anyCommand(600, 8);
  const struct {
    std::vector<MissionItem> items;
    Status status;
  } kPlans[] = {
      {{kHere, tag8, toTag8}, Status::Accepted},
      {{kHere, toTag8, tag7, tag8}, Status::Accepted},
      {{kHere, tag7, toTag8}, Status::BadJump},
      {{kHere, toTag8, anyCommand(177, 0, 8), anyCommand(112, 8)}, Status::BadJump},
      {{kHere, toTag8}, Status::BadJump},
  };
  for (const auto& given : kPlans) {
    for (Firmware firmware : {Firmware::ArduPilot, Firmware::Other}) {
      Plan plan(given.items, firmware);
      for (uint16_t i = 0; i < given.items.size(); ++i) {
        if (given.items[i].command != 601) continue;
        MissionItem item, followed;
        Status status = Status::Checking;
        for (int calls = 0; status == Status::Checking && calls < 10; ++calls) {
          REQUIRE((plan.read(plan.wire.numbers().toWire(i), item) == Status::Accepted));
          CHECK(item.param1 == 8.f);
          followed = item;
          status = plan.wire.follow(followed);
        }
        CHECK((status == given.status));
      }
    }
  }
}

TEST_CASE("a place on the equator or on the prime meridian is one to take") {
  for (const MissionItem& near : {at(0, 40), at(30, 0)}) {
    MissionItem item;
    Plan plan({takeoff(15_m), near}, Firmware::Px4);
    REQUIRE((plan.read(0, item) == Status::Accepted));
    CHECK(item.x == near.x);
    CHECK(item.y == near.y);
  }
}

TEST_CASE("the place of the first command that is none of navigation is not taken") {
  MissionItem item;
  Plan plan({takeoff(15_m), anyCommandAt(95, 1_deg, 1_deg, 20_m), at(30, 40)}, Firmware::Px4);
  REQUIRE((plan.read(0, item) == Status::Accepted));
  CHECK(item.x == 30);
}

TEST_CASE("no item beyond the plan is looked at for a place") {
  struct Placeless {
    static bool read(void* beyond, uint16_t index, MissionItem& item) {
      if (index >= 3) *static_cast<bool*>(beyond) = true;
      item = index == 1 ? takeoff(10_m) : changeSpeed(5_mps);
      return index < 3;
    }
  };
  bool beyond = false;
  WirePlan wire;
  memset(static_cast<void*>(&wire), 0, sizeof(wire));
  wire.setSource(fromFunction(Placeless::read, 3, &beyond));
  wire.begin(Firmware::Px4, 2, PlanType::Mission, false);
  MissionItem item;
  Status status = Status::Checking;
  for (int calls = 0; status == Status::Checking && calls < 10; ++calls) status = wire.read(1, item);
  CHECK((status == Status::NeedsCoordinates));
  CHECK_FALSE(beyond);
}

TEST_CASE("home is item 0 of the smallest plan too, above sea level, and is gone on from") {
  Plan plan({kHere}, Firmware::ArduPilot);
  CHECK(plan.wire.wireCount() == 2);
  MissionItem item;
  memset(static_cast<void*>(&item), 0xFF, sizeof(item));
  REQUIRE((plan.read(0, item) == Status::Accepted));
  CHECK((item.frame == CoordinateFrame::Global));
  CHECK(item.autocontinue == 1);
}

TEST_CASE("home is no item to jump to, where the sketch's own numbers count it") {
  CHECK((check(anyCommand(kDoJump, 0, 3), Firmware::ArduPilot, true) == Status::BadJump));
  CHECK((check(anyCommand(kDoJump, 0, 3), Firmware::Px4, true) == Status::Accepted));
}

TEST_CASE("each frame of a place above sea level or above home is taken by both, and leaves by its newer number") {
  for (const CoordinateFrame frame : {CoordinateFrame::Global, CoordinateFrame::GlobalRelative,
                                      CoordinateFrame::GlobalInt, CoordinateFrame::GlobalRelativeInt}) {
    MissionItem item = kHere;
    item.frame = frame;
    for (const Firmware firmware : kAll) {
      Plan plan({item}, firmware, true);
      MissionItem sent;
      CHECK((plan.read(0, sent) == Status::Accepted));
      CHECK((sent.frame == modern(frame)));
    }
  }
}

TEST_CASE("a region of interest goes to PX4 by the number that takes a place in each version, and nothing else does") {
  for (const uint16_t command : {kNavRoi, kDoSetRoiLocation, kDoSetRoi}) {
    MissionItem item;
    Plan plan({anyCommandAt(command, 1_deg, 1_deg, 20_m)}, Firmware::Px4);
    REQUIRE((plan.read(0, item) == Status::Accepted));
    CHECK(item.command == (command == kDoSetRoi ? uint16_t{kNavRoi} : command));
  }
}

TEST_CASE("of two places the nearer one is taken, and again when it is asked for again") {
  Plan plan({at(10, 20), changeSpeed(5_mps), changeSpeed(5_mps), takeoff(9_m), changeSpeed(5_mps), at(30, 40)},
            Firmware::Px4);
  for (int times = 0; times < 2; ++times) {
    MissionItem item;
    REQUIRE((plan.read(3, item) == Status::Accepted));
    CHECK(item.x == 30);
  }
}

TEST_CASE("on PX4 a landing gets the place of an item behind it where there is none before it") {
  MissionItem item;
  Plan plan({land(), at(30, 40)}, Firmware::Px4);
  REQUIRE((plan.read(0, item) == Status::Accepted));
  CHECK(item.x == 30);
}

TEST_CASE("of two places that are two items away a takeoff gets the one behind it, each time that it is read") {
  MissionItem item;
  Plan plan({at(10, 20), changeSpeed(5_mps), takeoff(9_m), changeSpeed(5_mps), at(30, 40)}, Firmware::Px4);
  for (int reads = 0; reads < 3; ++reads) {
    REQUIRE((plan.read(2, item) == Status::Accepted));
    CHECK(item.x == 30);
  }
  Plan near({at(10, 20), takeoff(9_m), at(30, 40)}, Firmware::Px4);
  for (int reads = 0; reads < 3; ++reads) {
    REQUIRE((near.read(1, item) == Status::Accepted));
    CHECK(item.x == 30);
  }
}

TEST_CASE("a search that was broken off does not reach into the next plan") {
  MissionItem item;
  std::vector<MissionItem> items(200, changeSpeed(5_mps));
  items[100] = takeoff(9_m);
  Plan plan(items, Firmware::Px4);
  REQUIRE((plan.wire.read(100, item) == Status::Checking));
  plan.items = {at(10, 20), takeoff(9_m), at(30, 40)};
  plan.wire.setSource(inRam(plan.items.data(), 3));
  plan.wire.begin(Firmware::Px4, 2, PlanType::Mission, false);
  REQUIRE((plan.read(1, item) == Status::Accepted));
  CHECK(item.x == 30);
}

TEST_CASE("on ArduPilot a takeoff keeps its missing place, in raw numbers too") {
  MissionItem item;
  Plan plan({at(10, 20), takeoff(9_m), at(30, 40)}, Firmware::ArduPilot, true);
  REQUIRE((plan.read(1, item) == Status::Accepted));
  CHECK(item.x == 0);
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
