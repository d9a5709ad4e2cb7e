#include "mavmission/plan/Comparison.h"

#include <doctest/doctest.h>

#include <string.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "Names.h"
#include "RecordedItems.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

const PlanType kTypes[] = {PlanType::Mission, PlanType::Fence, PlanType::Rally};
const Firmware kFirmwares[] = {Firmware::ArduPilot, Firmware::Px4, Firmware::Other};
constexpr uint8_t kCopterType = 2;  // HEARTBEAT.type

Keeper keeper(Firmware firmware, PlanType type = PlanType::Mission, uint8_t vehicle = kCopterType) {
  return keeperOf(firmware, vehicle, type);
}

// The first field that does not mean what was sent, by the recording alone.
ItemField lostIn(const RecordedItem& row) {
  for (unsigned i = 0; i < kFourBytes; ++i) {
    if (!meansTheSame(row, i)) return fieldOf(i);
  }
  return ItemField::None;
}

// Fields of a row are altered until this says so, and the rest is passed over.
struct Wrong {
  unsigned count = 0, line = 0, field = 0;
  uint32_t bits = 0;
  std::string vehicle;

  void add(const RecordedItem& row, unsigned index, uint32_t altered) {
    if (count++ != 0) return;
    vehicle = row.vehicle;
    line = row.line;
    field = index;
    bits = altered;
  }
  void checkNone() const {
    CAPTURE(vehicle);
    CAPTURE(line);
    CAPTURE(field);
    CAPTURE(bits);
    CHECK(count == 0);
  }
};

constexpr Keeper kCopter = kByArduPilot, kPlane = kByArduPilot | kByPlane;

// Of a command with a place, or in PX4's frame without one: one field and its bits.
bool isKept(Keeper keeper, uint16_t command, unsigned index, uint32_t bits,
            CoordinateFrame frame = CoordinateFrame::GlobalRelative) {
  MissionItem item = anyCommandAt(command, Degrees::fromE7(128), Degrees::fromE7(64), 20_m);
  item.frame = frame;
  setBits(item, index, bits);
  const ItemField field = notKept(item, keeper);
  CHECK((field == ItemField::None || field == fieldOf(index)));
  return field == ItemField::None;
}

uint32_t bitsOfFloat(float number) {
  uint32_t bits;
  memcpy(&bits, &number, sizeof(bits));
  return bits;
}

// Its place is one that a float holds.
MissionItem here() { return waypoint(Degrees::fromE7(1 << 28), Degrees::fromE7(1 << 27), 20_m); }

// Each of the first fields is kept, and told when it comes back as 0.
void checkKeepsAll(uint16_t command, unsigned fields, Keeper keeper,
                   CoordinateFrame frame = CoordinateFrame::GlobalRelative) {
  for (unsigned index = 0; index < fields; ++index) {
    MissionItem sent = here();
    sent.command = command;
    sent.frame = frame;
    sent.param4 = 0;
    setBits(sent, index, isInteger(index) ? 7 : bitsOfFloat(77.6f));
    MissionItem read = sent;
    CAPTURE(command);
    CHECK((difference(sent, read, keeper) == ItemField::None));
    setBits(read, index, 0);
    CHECK((difference(sent, read, keeper) == fieldOf(index)));
  }
}

}  // namespace

TEST_CASE("of a random item each autopilot's answer is what was sent, or names the field that lost its meaning") {
  unsigned same = 0, lost = 0;
  Wrong wrong;
  for (const RecordedItem& row : recordedItems()) {
    if (!row.isRead) continue;
    const ItemField expected = lostIn(row);
    (expected == ItemField::None ? same : lost) += 1;
    if (difference(row.sent, row.read, row.keeper) != expected) wrong.add(row, static_cast<unsigned>(expected), 0);
    // So it is known before it is sent.
    if (notKept(row.sent, row.keeper) != expected) wrong.add(row, static_cast<unsigned>(expected), 1);
  }
  wrong.checkNone();
  CHECK(same > 6000);
  CHECK(lost > 3000);
}

TEST_CASE("of a random item that came back right every other bit of every field is seen, and a 0") {
  Wrong wrong;
  for (const RecordedItem& row : recordedItems()) {
    if (!row.isRead || lostIn(row) != ItemField::None) continue;
    for (unsigned index = 0; index < kFourBytes; ++index) {
      const uint32_t read = bitsOf(row.read, index), sent = bitsOf(row.sent, index);
      for (unsigned bit = 0; bit <= 32; ++bit) {
        MissionItem altered = row.read;
        setBits(altered, index, bit < 32 ? read ^ 1u << bit : 0);
        const bool isSent = bitsOf(altered, index) == sent || bitsOf(altered, index) == read;
        const bool isNoNumber =
            index == 3 && std::isnan(numberOf(row.sent, index)) && std::isnan(numberOf(altered, index));
        const ItemField expected = isSent || isNoNumber ? ItemField::None : fieldOf(index);
        if (difference(row.sent, altered, row.keeper) != expected) wrong.add(row, index, bitsOf(altered, index));
      }
    }
  }
  wrong.checkNone();
}

TEST_CASE("a field that the vehicle drops may come back as it was sent, whatever it was") {
  // Another version may keep it. Only where the number itself is allowed.
  Wrong wrong;
  for (const RecordedItem& row : recordedItems()) {
    if (!row.isRead || lostIn(row) != ItemField::None) continue;
    MissionItem whole = row.sent;
    whole.frame = row.read.frame;
    whole.autocontinue = row.read.autocontinue;
    if (difference(row.sent, whole, row.keeper) != ItemField::None) wrong.add(row, 0, 0);
  }
  wrong.checkNone();
}

TEST_CASE("of several differences the first in the order of the message is told") {
  const MissionItem sent = here();
  MissionItem read = sent;
  const auto told = [&] { return std::string(nameOf(difference(sent, read, 0))); };
  CHECK(told() == "None");
  read.autocontinue = 0;
  CHECK(told() == "Autocontinue");
  for (unsigned index = kFourBytes; index-- != 0;) {
    setBits(read, index, bitsOfFloat(7));
    CHECK(told() == nameOf(fieldOf(index)));
  }
  read.frame = CoordinateFrame::Global;
  CHECK(told() == "Reference");
  read.command = 17;
  CHECK(told() == "Command");
}

TEST_CASE("PX4 alone keeps two commands by other numbers") {
  const uint16_t kKeptAs[][2] = {{kNavRoi, kDoSetRoi}, {kConditionDelay, kNavDelay}};
  for (const uint16_t(&pair)[2] : kKeptAs) {
    for (const Firmware firmware : {Firmware::Px4, Firmware::ArduPilot, Firmware::Unknown}) {
      const Keeper keeper = keeperOf(firmware, 0, PlanType::Mission);
      MissionItem sent = anyCommand(pair[0]), read = anyCommand(pair[1]);
      CHECK((difference(sent, read, keeper) == ItemField::None) == (firmware == Firmware::Px4));
      CHECK((difference(read, sent, keeper) == ItemField::Command));
      read.command = 92;
      CHECK((difference(sent, read, keeper) == ItemField::Command));
    }
  }
}

TEST_CASE("an autopilot that is neither keeps every field of every command as it was sent") {
  std::set<uint16_t> commands;
  for (const RecordedItem& row : recordedItems()) commands.insert(row.sent.command);
  CHECK(commands.size() > 60);
  for (const uint16_t command : commands) {
    for (const PlanType type : kTypes) checkKeepsAll(command, kFourBytes, keeper(Firmware::Other, type));
  }
}

TEST_CASE("every number of a command that is not in the table is kept as it is, with a place and without") {
  for (const Keeper keeper : {kCopter, kPlane, Keeper(kByPx4)}) {
    for (const CoordinateFrame frame : {CoordinateFrame::Mission, CoordinateFrame::GlobalRelative}) {
      checkKeepsAll(31337, 4, keeper, frame);
    }
  }
}

TEST_CASE("a NaN that was sent may come back as any NaN, and only as a yaw; a coordinate is compared as an integer") {
  const uint32_t kNaN = bitsOfFloat(std::numeric_limits<float>::quiet_NaN()), kOtherNaN = 0xFFC12345;
  const uint32_t kInfinity = bitsOfFloat(std::numeric_limits<float>::infinity());
  const uint32_t kLowest = 0x80000000;  // of the integers; as a float it would be -0
  const struct {
    unsigned index;
    uint32_t sent, read;
    const char* told;
  } kCases[] = {
      {3, kNaN, kOtherNaN, "None"}, {0, kNaN, kOtherNaN, "Param1"}, {3, kNaN, 0, "Param4"},
      {3, 0, kNaN, "Param4"},       {3, kNaN, kInfinity, "Param4"}, {4, 0, kLowest, "Latitude"},
      {5, 0, kLowest, "Longitude"},
  };
  for (const auto& one : kCases) {
    for (const Firmware firmware : kFirmwares) {
      const bool isOfFloat = one.index < 4;
      if (isOfFloat && firmware == Firmware::ArduPilot) continue;  // no NaN is sent to it
      MissionItem sent = here();
      setBits(sent, one.index, one.sent);
      MissionItem read = sent;
      setBits(read, one.index, one.read);
      CAPTURE(&one - kCases);
      CHECK(std::string(nameOf(difference(sent, read, keeper(firmware)))) == one.told);
    }
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
          const ItemField expected = isRight ? ItemField::None : ItemField::Autocontinue;
          CHECK((difference(sent, read, keeper(firmware, type)) == expected));
        }
      }
    }
  }
}

TEST_CASE("a frame may come back by its other number, or as Global where there is no height") {
  const CoordinateFrame frames[] = {
      CoordinateFrame::Global,          CoordinateFrame::Mission,           CoordinateFrame::GlobalRelative,
      CoordinateFrame::GlobalInt,       CoordinateFrame::GlobalRelativeInt, CoordinateFrame::GlobalTerrain,
      CoordinateFrame::GlobalTerrainInt};
  const auto number = [](CoordinateFrame frame) {
    return frame == CoordinateFrame::GlobalInt           ? CoordinateFrame::Global
           : frame == CoordinateFrame::GlobalRelativeInt ? CoordinateFrame::GlobalRelative
           : frame == CoordinateFrame::GlobalTerrainInt  ? CoordinateFrame::GlobalTerrain
                                                         : frame;
  };
  for (const Firmware firmware : kFirmwares) {
    for (const PlanType type : kTypes) {
      for (const uint16_t command : {uint16_t(16), uint16_t(178)}) {  // with a place, and without
        for (const CoordinateFrame was : frames) {
          for (const CoordinateFrame is : frames) {
            MissionItem sent = here();
            sent.command = command;
            sent.frame = was;
            sent.param4 = 0;
            MissionItem read = sent;
            read.frame = is;
            const bool isArduPilot = firmware == Firmware::ArduPilot;
            const bool hasNoHeight = isArduPilot
                                         ? type == PlanType::Fence || was == CoordinateFrame::Mission || command == 178
                                         : firmware == Firmware::Px4 && type == PlanType::Fence;
            const bool isRight = number(was) == number(is) || (number(is) == CoordinateFrame::Global && hasNoHeight);
            CAPTURE(static_cast<int>(firmware));
            CAPTURE(static_cast<int>(type));
            CAPTURE(static_cast<int>(was));
            CAPTURE(static_cast<int>(is));
            CHECK(
                (difference(sent, read, keeper(firmware, type)) == (isRight ? ItemField::None : ItemField::Reference)));
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
    const auto expected = [](bool isRight) { return isRight ? ItemField::None : ItemField::Height; };
    CAPTURE(height);
    CHECK((difference(sent, read, keeper(Firmware::ArduPilot, PlanType::Fence)) == expected(isSame || height == 0)));
    CHECK((difference(sent, read, keeper(Firmware::Px4, PlanType::Fence)) == expected(isSame)));
    read = point;
    read.z = height;
    CHECK((difference(point, read, keeper(Firmware::ArduPilot, PlanType::Rally)) == expected(height == 30)));
    CHECK((difference(point, read, keeper(Firmware::Px4, PlanType::Rally)) == expected(height == 30)));
  }
  point.z = 30.5f;
  CHECK((notKept(point, keeper(Firmware::ArduPilot, PlanType::Rally)) == ItemField::Height));
  CHECK((notKept(point, keeper(Firmware::Px4, PlanType::Rally)) == ItemField::None));
}

TEST_CASE("each kind of whole number is kept up to its limits, and not beyond") {
  const struct {
    uint16_t command;
    unsigned index;
    float lowest, highest;
  } kKinds[] = {
      {18, 3, 0, 1},         {202, 0, 0, 255},        {93, 1, -128, 127},
      {16, 0, 0, 65535},     {177, 1, -32768, 32767}, {17, 2, -65535, 65535},
      {42703, 1, -180, 180}, {42703, 2, -90, 90},     {42703, 3, -180, 360},
  };
  for (const auto& kind : kKinds) {
    CAPTURE(kind.command);
    CAPTURE(kind.index);
    for (const float kept : {kind.lowest, kind.highest, 0.f, 1.f}) {
      CHECK(isKept(kCopter, kind.command, kind.index, bitsOfFloat(kept)));
    }
    for (const float lost : {kind.lowest - 1, kind.highest + 1, 0.5f, -0.5f, 0.001f}) {
      CHECK_FALSE(isKept(kCopter, kind.command, kind.index, bitsOfFloat(lost)));
    }
  }
}

TEST_CASE("-0 is kept as 0 where a whole number is") {
  MissionItem sent = here(), read;
  sent.param1 = -0.f;
  read = sent;
  read.param1 = 0;
  CHECK((difference(sent, read, kCopter) == ItemField::None));
  CHECK((difference(read, sent, kCopter) == ItemField::Param1));
}

TEST_CASE("turns are whole to 255, and below 1 in 256ths") {
  for (int turns = 0; turns <= 300; ++turns)
    CHECK(isKept(kCopter, 18, 0, bitsOfFloat(static_cast<float>(turns))) == (turns <= 255));
  for (int parts = 1; parts < 1024; ++parts) {
    CHECK(isKept(kCopter, 18, 0, bitsOfFloat(static_cast<float>(parts) / 1024)) == (parts % 4 == 0));
  }
}

TEST_CASE("a number is kept up to the limits of its kind") {
  constexpr Keeper kPx4Fence = kByPx4 | kOfFence;
  const struct {
    Keeper keeper;
    uint16_t command;
    unsigned index;
    std::vector<float> kept, lost;
  } kKinds[] = {
      // x of a command without a place is a whole number on ArduPilot, where it uses it.
      {kCopter, 202, 4, {0, 1, 255}, {-1, 256, 257, 1000}},
      {kCopter, 42703, 4, {-32768, 0, 32767}, {-32769, 32768}},
      // Turns, and what is kept in centimetres.
      {kCopter, 18, 0, {}, {1.5f, -1, -0.25f}},
      {kCopter, 94, 0, {std::nextafter(655.36f, 0.f)}, {655.36f, -1}},
      // The direction of a circle is 0, 1 or -1 on a plane, and of any size where it is not used.
      {kPlane, 19, 2, {0, 1, -1}, {2, -2, 50, 0.5f}},
      {kCopter, 19, 2, {2, -2, 50, 0.5f}, {}},
      // A heading on PX4, and its fences: a whole number of corners, and any radius of a circle.
      {kByPx4, 16, 3, {-180, 0, 360}, {std::nextafter(-180.f, -181.f), std::nextafter(360.f, 361.f)}},
      {kPx4Fence, 5001, 0, {4}, {3.5f}},
      {kPx4Fence, 5002, 0, {4}, {3.5f}},
      {kPx4Fence, 5003, 0, {3.5f}, {}},
  };
  for (const auto& kind : kKinds) {
    const auto isKeptAs = [&kind](float number) {
      const bool isWhole = isInteger(kind.index);
      const uint32_t bits = isWhole ? static_cast<uint32_t>(static_cast<int32_t>(number)) : bitsOfFloat(number);
      return isKept(kind.keeper, kind.command, kind.index, bits);
    };
    CAPTURE(&kind - kKinds);
    for (const float number : kind.kept) CHECK(isKeptAs(number));
    for (const float number : kind.lost) CHECK_FALSE(isKeptAs(number));
  }
}

TEST_CASE("a region of interest has a mode that PX4 takes: none or a place, or without a place none or an item") {
  for (unsigned mode = 0; mode < 300; ++mode) {
    CAPTURE(mode);
    const uint32_t bits = bitsOfFloat(static_cast<float>(mode));
    CHECK(isKept(kByPx4, 201, 0, bits) == (mode == 0 || mode == 3));
    CHECK(isKept(kByPx4, 201, 0, bits, CoordinateFrame::Mission) == (mode <= 2));
  }
}

TEST_CASE("an altitude of a command that is not in the table comes back in centimetres from ArduPilot alone") {
  MissionItem sent = here();
  sent.command = 31337;
  sent.param4 = 0;
  sent.z = 20.125f;
  MissionItem read = sent;
  read.z = 20.1199989f;
  CHECK((difference(sent, read, keeper(Firmware::ArduPilot)) == ItemField::None));
  CHECK((difference(sent, read, keeper(Firmware::Px4)) == ItemField::Height));
  CHECK((difference(sent, read, keeper(Firmware::Other)) == ItemField::Height));
}
