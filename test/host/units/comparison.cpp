#include "mavmission/Comparison.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <set>
#include <string>

#include "Readbacks.h"

using namespace mavmission;

namespace {

const PlanType kTypes[] = {PlanType::Mission, PlanType::Fence, PlanType::Rally};
const Firmware kFirmwares[] = {Firmware::ArduPilot, Firmware::Px4, Firmware::Other};
constexpr uint8_t kCopterType = 2, kPlaneType = 1;  // HEARTBEAT.type

Keeper keeper(Firmware firmware, PlanType type = PlanType::Mission, uint8_t vehicle = kCopterType) {
  return keeperOf(firmware, vehicle, type);
}

// The first field that does not mean what was sent, by the recording alone.
Field lostIn(const Readback& row) {
  for (unsigned i = 0; i < kFourBytes; ++i) {
    if (!meansTheSame(row, i)) return fieldOf(i);
  }
  return Field::None;
}

// Fields of a row are altered until this says so, and the rest is passed over.
struct Wrong {
  unsigned count = 0, line = 0, field = 0;
  uint32_t bits = 0;
  std::string vehicle;

  void add(const Readback& row, unsigned index, uint32_t altered) {
    if (count++ != 0) return;
    vehicle = row.vehicle;
    line = row.line;
    field = index;
    bits = altered;
  }
};

// Its place is one that a float holds.
MissionItem here() { return waypoint(Degrees::fromE7(1 << 28), Degrees::fromE7(1 << 27), 20_m); }

}  // namespace

TEST_CASE("of a random item each autopilot's answer is what was sent, or names the field that lost its meaning") {
  unsigned same = 0, lost = 0;
  Wrong wrong;
  for (const Readback& row : readbacks()) {
    if (!row.isRead) continue;
    const Field expected = lostIn(row);
    (expected == Field::None ? same : lost) += 1;
    if (difference(row.sent, row.read, row.keeper) != expected) wrong.add(row, static_cast<unsigned>(expected), 0);
    // So it is known before it is sent.
    if (notKept(row.sent, row.keeper) != expected) wrong.add(row, static_cast<unsigned>(expected), 1);
  }
  CAPTURE(wrong.vehicle);
  CAPTURE(wrong.line);
  CAPTURE(wrong.field);
  CAPTURE(wrong.bits);
  CHECK(wrong.count == 0);
  CHECK(same > 6000);
  CHECK(lost > 3000);
}

TEST_CASE("of a random item that came back right every other bit of every field is seen") {
  Wrong wrong;
  for (const Readback& row : readbacks()) {
    if (!row.isRead || lostIn(row) != Field::None) continue;
    for (unsigned index = 0; index < kFourBytes; ++index) {
      const uint32_t read = bitsOf(row.read, index), sent = bitsOf(row.sent, index);
      for (unsigned bit = 0; bit < 32; ++bit) {
        MissionItem altered = row.read;
        setBits(altered, index, read ^ 1u << bit);
        const bool isSent = bitsOf(altered, index) == sent;
        const bool isNoNumber =
            index == 3 && std::isnan(numberOf(row.sent, index)) && std::isnan(numberOf(altered, index));
        const Field expected = isSent || isNoNumber ? Field::None : fieldOf(index);
        if (difference(row.sent, altered, row.keeper) != expected) wrong.add(row, index, bitsOf(altered, index));
      }
    }
  }
  CAPTURE(wrong.vehicle);
  CAPTURE(wrong.line);
  CAPTURE(wrong.field);
  CAPTURE(wrong.bits);
  CHECK(wrong.count == 0);
}

TEST_CASE("a field that the vehicle drops may come back as it was sent, whatever it was") {
  // Another version may keep it. Only where the number itself is allowed.
  Wrong wrong;
  for (const Readback& row : readbacks()) {
    if (!row.isRead || lostIn(row) != Field::None) continue;
    MissionItem whole = row.sent;
    whole.frame = row.read.frame;
    whole.autocontinue = row.read.autocontinue;
    if (difference(row.sent, whole, row.keeper) != Field::None) wrong.add(row, 0, 0);
  }
  CAPTURE(wrong.vehicle);
  CAPTURE(wrong.line);
  CHECK(wrong.count == 0);
}

TEST_CASE("of several differences the first in the order of the message is told") {
  const MissionItem sent = here();
  MissionItem read = sent;
  CHECK((difference(sent, read, 0) == Field::None));
  read.autocontinue = 0;
  CHECK((difference(sent, read, 0) == Field::Autocontinue));
  read.z = 7;
  CHECK((difference(sent, read, 0) == Field::Height));
  read.y = 7;
  CHECK((difference(sent, read, 0) == Field::Longitude));
  read.x = 7;
  CHECK((difference(sent, read, 0) == Field::Latitude));
  read.param4 = 7;
  CHECK((difference(sent, read, 0) == Field::Param4));
  read.param3 = 7;
  CHECK((difference(sent, read, 0) == Field::Param3));
  read.param2 = 7;
  CHECK((difference(sent, read, 0) == Field::Param2));
  read.param1 = 7;
  CHECK((difference(sent, read, 0) == Field::Param1));
  read.frame = Frame::Global;
  CHECK((difference(sent, read, 0) == Field::Reference));
  read.command = 17;
  CHECK((difference(sent, read, 0) == Field::Command));
}

TEST_CASE("an autopilot that is neither keeps every field of every command as it was sent") {
  std::set<uint16_t> commands;
  for (const Readback& row : readbacks()) commands.insert(row.sent.command);
  CHECK(commands.size() > 60);
  for (const uint16_t command : commands) {
    for (const PlanType type : kTypes) {
      for (unsigned index = 0; index < kFourBytes; ++index) {
        MissionItem sent = here();
        sent.command = command;
        sent.param4 = 0;
        setBits(sent, index, isInteger(index) ? 7 : 0x429B3333);  // 77.6
        MissionItem read = sent;
        CAPTURE(command);
        CHECK((difference(sent, read, keeper(Firmware::Other, type)) == Field::None));
        setBits(read, index, 0);
        CHECK((difference(sent, read, keeper(Firmware::Other, type)) == fieldOf(index)));
      }
    }
  }
}

TEST_CASE("a NaN that was sent may come back as any NaN, and only as a yaw") {
  const float kNaN = std::numeric_limits<float>::quiet_NaN();
  for (const Firmware firmware : {Firmware::Px4, Firmware::Other}) {
    MissionItem sent = here(), read = sent;
    setBits(read, 3, 0xFFC12345);
    CHECK((difference(sent, read, keeper(firmware)) == Field::None));
    sent.param1 = kNaN;
    read = sent;
    setBits(read, 0, 0xFFC12345);
    CHECK((difference(sent, read, keeper(firmware)) == Field::Param1));
    sent = here();
    read = sent;
    read.param4 = 0;
    CHECK((difference(sent, read, keeper(firmware)) == Field::Param4));
    read.param4 = kNaN;
    sent.param4 = 0;
    CHECK((difference(sent, read, keeper(firmware)) == Field::Param4));
    read.param4 = std::numeric_limits<float>::infinity();
    sent.param4 = kNaN;
    CHECK((difference(sent, read, keeper(firmware)) == Field::Param4));
  }
}

TEST_CASE("coordinates are compared as the integers that they are") {
  const MissionItem sent = here();
  for (const Firmware firmware : kFirmwares) {
    MissionItem zero = sent, lowest = sent;
    zero.x = 0;
    lowest.x = std::numeric_limits<int32_t>::min();  // as a float it would be -0
    CHECK((difference(zero, lowest, keeper(firmware)) == Field::Latitude));
    zero.x = lowest.x = sent.x;
    zero.y = 0;
    lowest.y = std::numeric_limits<int32_t>::min();
    CHECK((difference(zero, lowest, keeper(firmware)) == Field::Longitude));
  }
}

TEST_CASE("autocontinue may be 1 in a mission from ArduPilot, is of no account in a fence, and is kept elsewhere") {
  for (const Firmware firmware : kFirmwares) {
    for (const PlanType type : kTypes) {
      for (uint8_t was : {0, 1}) {
        for (uint8_t is : {0, 1, 2}) {
          MissionItem sent = here(), read = sent;
          sent.autocontinue = was;
          read.autocontinue = is;
          const bool isRight = type != PlanType::Mission || is == was || (firmware == Firmware::ArduPilot && is == 1);
          const Field expected = isRight ? Field::None : Field::Autocontinue;
          CHECK((difference(sent, read, keeper(firmware, type)) == expected));
        }
      }
    }
  }
}

TEST_CASE("a frame may come back by its other number, or as Global where there is no height") {
  const Frame frames[] = {Frame::Global,          Frame::Mission,           Frame::GlobalRelative,
                          Frame::GlobalInt,       Frame::GlobalRelativeInt, Frame::GlobalTerrain,
                          Frame::GlobalTerrainInt};
  const auto number = [](Frame frame) {
    return frame == Frame::GlobalInt           ? Frame::Global
           : frame == Frame::GlobalRelativeInt ? Frame::GlobalRelative
           : frame == Frame::GlobalTerrainInt  ? Frame::GlobalTerrain
                                               : frame;
  };
  for (const Firmware firmware : kFirmwares) {
    for (const PlanType type : kTypes) {
      for (const uint16_t command : {uint16_t(16), uint16_t(178)}) {  // with a place, and without
        for (const Frame was : frames) {
          for (const Frame is : frames) {
            MissionItem sent = here();
            sent.command = command;
            sent.frame = was;
            sent.param4 = 0;
            MissionItem read = sent;
            read.frame = is;
            const bool isArduPilot = firmware == Firmware::ArduPilot;
            const bool hasNoHeight = isArduPilot ? type == PlanType::Fence || was == Frame::Mission || command == 178
                                                 : firmware == Firmware::Px4 && type == PlanType::Fence;
            const bool isRight = number(was) == number(is) || (number(is) == Frame::Global && hasNoHeight);
            CAPTURE(static_cast<int>(firmware));
            CAPTURE(static_cast<int>(type));
            CAPTURE(static_cast<int>(was));
            CAPTURE(static_cast<int>(is));
            CHECK((difference(sent, read, keeper(firmware, type)) == (isRight ? Field::None : Field::Reference)));
          }
        }
      }
    }
  }
}

TEST_CASE("ArduPilot keeps no height of a fence and only whole metres of rally points; PX4 keeps both") {
  MissionItem sent = fenceInsideCircle(1_deg, 1_deg, 20_m), point = rallyPoint(1_deg, 1_deg, 30_m);
  sent.z = 30.5f;
  for (const float height : {0.f, 30.f, 30.5f, 31.f, 1.f}) {
    MissionItem read = sent;
    read.z = height;
    const bool isSame = height == 30.5f;
    const auto expected = [](bool isRight) { return isRight ? Field::None : Field::Height; };
    CAPTURE(height);
    CHECK((difference(sent, read, keeper(Firmware::ArduPilot, PlanType::Fence)) == expected(isSame || height == 0)));
    CHECK((difference(sent, read, keeper(Firmware::Px4, PlanType::Fence)) == expected(isSame)));
    read = point;
    read.z = height;
    CHECK((difference(point, read, keeper(Firmware::ArduPilot, PlanType::Rally)) == expected(height == 30)));
    CHECK((difference(point, read, keeper(Firmware::Px4, PlanType::Rally)) == expected(height == 30)));
  }
  point.z = 30.5f;
  CHECK((notKept(point, keeper(Firmware::ArduPilot, PlanType::Rally)) == Field::Height));
  CHECK((notKept(point, keeper(Firmware::Px4, PlanType::Rally)) == Field::None));
}
