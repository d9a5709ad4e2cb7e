// The rows of Betaflight and iNav, in a library that was compiled for one of the two (MAVMISSION_GENERIC_FIRMWARE).
#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <set>

#include "mavmission/autopilot/Commands.h"
#include "mavmission/autopilot/Personality.h"
#include "mavmission/autopilot/Rules.h"
#include "mavmission/item/MissionItem.h"
#include "mavmission/plan/Comparison.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

constexpr bool kIsBetaflight = MAVMISSION_GENERIC_FIRMWARE == 1;
constexpr Firmware kThis = kIsBetaflight ? Firmware::Betaflight : Firmware::Inav;
constexpr Firmware kTheOther = kIsBetaflight ? Firmware::Inav : Firmware::Betaflight;
constexpr uint8_t kCopter = 2;

Rules rulesOfCommand(uint16_t command, PlanType type = PlanType::Mission,
                     CoordinateFrame frame = CoordinateFrame::Global) {
  MissionItem item{};
  item.command = command;
  item.frame = frame;
  return rulesOf(item, keeperOf(kThis, kCopter, type));
}

uint8_t kindOfParam(uint16_t command, uint8_t number) {
  return static_cast<uint8_t>(rulesOfCommand(command).bits >> (4 * (number - 1)) & 15);
}

}  // namespace

TEST_CASE("a generic autopilot is the one that the macro names, and no other autopilot is") {
  for (unsigned autopilot = 0; autopilot < 256; ++autopilot) {
    CAPTURE(autopilot);
    const Firmware expected = autopilot == 0    ? kThis
                              : autopilot == 3  ? Firmware::ArduPilot
                              : autopilot == 12 ? Firmware::Px4
                                                : Firmware::Other;
    CHECK((firmwareOf(static_cast<uint8_t>(autopilot)) == expected));
  }
}

TEST_CASE("what is known of it, and what is not") {
  CHECK(has(kThis, kDropsPlanFirst) == kIsBetaflight);
  CHECK(has(kThis, kIsReadBack) == kIsBetaflight);
  CHECK(has(kThis, kGivesHeightsAboveSea) == kIsBetaflight);
  CHECK(has(kThis, kMayBeOld));
  CHECK(has(kThis, kTellsTotal));
  for (const Trait trait : {kHomeIsItem0, kReplacesItemByItem, kKeepsPlanUntilWhole, kTakesTerrainFrames,
                            kMayTakeAnyFrame, kSaysChecksum, kRepeatsAcceptance, kRefusesTakenItems, kHasPlanFiles,
                            kFliesByMode, kArmsByMissionStart, kModesByVehicle, kModesHaveSubModes, kIntegersAsBits}) {
    CAPTURE(static_cast<unsigned long long>(trait));
    CHECK_FALSE(has(kThis, trait));
  }
}

TEST_CASE("the other of the two has no traits and no table here, and those that say who they are keep theirs") {
  for (unsigned bit = 0; bit < 42; ++bit) CHECK_FALSE(has(kTheOther, static_cast<Trait>(1ull << bit)));
  CHECK(flagOf(kTheOther) == 0);
  CHECK(has(Firmware::ArduPilot, kHomeIsItem0));
  CHECK(has(Firmware::Px4, kSaysChecksum));
  CHECK(flagOf(Firmware::ArduPilot) == kByArduPilot);
  CHECK(flagOf(Firmware::Px4) == kByPx4);
}

TEST_CASE("of all commands those of its table are taken, whatever the frame says") {
  const std::set<uint16_t> taken =
      kIsBetaflight ? std::set<uint16_t>{16, 19, 21, 22} : std::set<uint16_t>{16, 19, 20, 21, 115, 177, 201};
  for (const CoordinateFrame frame :
       {CoordinateFrame::Global, CoordinateFrame::GlobalRelative, CoordinateFrame::Mission}) {
    for (uint32_t command = 0; command <= 65535; ++command) {
      const uint16_t one = static_cast<uint16_t>(command);
      const bool isTaken = !rulesOfCommand(one, PlanType::Mission, frame).has(kIsNotTaken);
      if (isTaken != (taken.count(one) != 0)) FAIL_CHECK(command);
    }
  }
}

TEST_CASE("no item of a fence and no rally point is taken") {
  for (uint16_t command = 5000; command <= 5100; ++command) {
    CHECK(rulesOfCommand(command, PlanType::Fence).has(kIsNotTaken));
    CHECK(rulesOfCommand(command, PlanType::Rally).has(kIsNotTaken));
  }
}

TEST_CASE("a yaw may be unset where there is one, and is not kept") {
  for (const uint16_t command : {16, 19, 21}) {
    CAPTURE(command);
    CHECK(kindOfParam(command, 4) == keeping::NoYaw);
    CHECK(rulesOfCommand(command).hasYaw());
  }
  CHECK(kindOfParam(16, 1) == keeping::Zero);  // it does not hold at a waypoint
  CHECK(kindOfParam(19, 3) == keeping::Zero);  // nor has a circle a radius
  CHECK(kindOfParam(19, 1) == (kIsBetaflight ? keeping::U8 : keeping::I16));
}

TEST_CASE("which of its commands have a place") {
  CHECK(rulesOfCommand(21).has(kPlaceIsOptional));
  CHECK_FALSE(rulesOfCommand(16).has(kPlaceIsOptional));
  if (kIsBetaflight) {
    CHECK(rulesOfCommand(22).has(kPlaceIsOptional));
  } else {
    for (const uint16_t command : {20, 115, 177}) CHECK(rulesOfCommand(command).has(kHasNoPlace));
    CHECK_FALSE(rulesOfCommand(201).has(kHasNoPlace));
    CHECK(kindOfParam(115, 4) == keeping::Zero);  // a turn by an angle is refused
  }
}

TEST_CASE("iNav's headings are 0 to 359, and its regions of interest have a place: it refuses others in mid-upload") {
  if (kIsBetaflight) return;
  const struct {
    uint16_t command;
    float param1;
    bool isTaken;
  } kCases[] = {
      {115, 0, true},    {115, 359, true},   {115, 360, false},    {115, 361, false}, {115, -1, false},
      {115, -90, false}, {115, 45.5, false}, {201, 3, true},       {201, 0, false},   {201, 2, false},
      {201, 4, false},   {201, -3, false},   {201, 3.25f, false},  {201, 259, false}, {177, 32767, true},
      {19, 32767, true}, {19, 32768, false}, {19, 32767.5, false},
  };
  for (const auto& one : kCases) {
    CAPTURE(one.command);
    CAPTURE(one.param1);
    MissionItem item{};
    item.command = one.command;
    item.frame = CoordinateFrame::GlobalRelative;
    item.autocontinue = 1;
    item.param1 = one.param1;
    const Keeper keeper = keeperOf(kThis, kCopter, PlanType::Mission);
    CHECK((difference(item, item, keeper) == (one.isTaken ? ItemField::None : ItemField::Param1)));
    // Some versions refuse it, some round it.
    if (!one.isTaken) CHECK(std::isnan(keptValue(item, ItemField::Param1, keeper)));
  }
}

TEST_CASE(
    "a height may come back as the number next to it, a yaw as any number; an item at which it stops is not kept") {
  MissionItem sent{};
  sent.command = 16;
  sent.frame = CoordinateFrame::GlobalRelative;
  sent.autocontinue = 1;
  sent.x = 473977420;
  sent.z = 50.1f;
  const Keeper keeper = keeperOf(kThis, kCopter, PlanType::Mission);
  const auto found = [&](const MissionItem& read) { return difference(sent, read, keeper); };
  MissionItem read = sent;
  CHECK((found(read) == ItemField::None));
  read.z = std::nextafter(sent.z, 100.0f);
  CHECK((found(read) == ItemField::None));
  read.z = std::nextafter(read.z, 100.0f);
  CHECK((found(read) == ItemField::Height));
  read = sent;
  read.param1 = std::nextafter(0.0f, 1.0f);  // the number next to it, in another field
  CHECK((found(read) == ItemField::Param1));
  CHECK(keptValue(sent, ItemField::Param1, keeper) == 0);
  read = sent;
  read.x += 1;
  CHECK((found(read) == ItemField::Latitude));
  read = sent;
  read.frame = CoordinateFrame::Global;
  CHECK((found(read) == ItemField::Reference));
  read = sent;
  read.autocontinue = 0;
  CHECK((found(read) == ItemField::Autocontinue));
  read = sent;
  sent.param4 = NAN;
  CHECK((found(read) == ItemField::None));
  read.param4 = NAN;
  CHECK((found(read) == ItemField::None));
  sent.autocontinue = read.autocontinue = 0;
  CHECK((found(read) == ItemField::Autocontinue));
}
