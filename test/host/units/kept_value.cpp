#include <doctest/doctest.h>

#include <string.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>

#include "RecordedItems.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

// Not foretold, because it is not the same everywhere: a negative number for an unsigned one, a number beyond 2^31, a
// heading beyond the turn, where PX4's own loop ends.
bool isUnforeseeable(const RecordedItem& row, unsigned index) {
  const double sent = numberOf(row.sent, index);
  return sent < 0 || std::fabs(sent) >= 2147483648.0 || (row.isPx4() && std::fabs(sent) > 180);
}

constexpr Keeper kCopter = kByArduPilot, kPlane = kByArduPilot | kByPlane;
const float kNaN = std::numeric_limits<float>::quiet_NaN();

MissionItem itemWith(uint16_t command, unsigned index, float value) {
  MissionItem item = anyCommandAt(command, 1_deg, 1_deg, 20_m);
  uint32_t bits;
  memcpy(&bits, &value, sizeof(bits));
  setBits(item, index, bits);
  return item;
}

struct Case {
  Keeper keeper;
  uint16_t command;
  unsigned index;  // 0: param1
  float sent, kept;
};

}  // namespace

TEST_CASE("what a random value that is not kept became is foretold, to the bit, or not known where it depends") {
  unsigned told = 0, unknown = 0, wrong = 0, line = 0;
  std::string vehicle;
  for (const RecordedItem& row : recordedItems()) {
    if (!row.isRead) continue;
    const ItemField field = notKept(row.sent, row.keeper);
    const unsigned index = static_cast<unsigned>(field) - static_cast<unsigned>(ItemField::Param1);
    // A NaN is refused for itself.
    if (field == ItemField::None || std::isnan(numberOf(row.sent, index))) continue;
    const float foretold = keptValue(row.sent, field, row.keeper);
    const bool isKnown = !std::isnan(foretold);
    (isKnown ? told : unknown) += 1;
    const bool isRight =
        isKnown ? foretold == static_cast<float>(numberOf(row.read, index)) : isUnforeseeable(row, index);
    if (isRight) continue;
    if (wrong++ == 0) vehicle = row.vehicle, line = row.line;
  }
  CAPTURE(vehicle);
  CAPTURE(line);
  CHECK(wrong == 0);
  CHECK(told > 1500);
  CHECK(unknown < told);
}

TEST_CASE("what becomes of numbers at the limits of an integer, of a range and of a rounding") {
  const Case kCases[] = {
      // 16 bits without a sign, up to where an integer of 32 bits ends.
      {kCopter, 16, 0, 65536, 0},
      {kCopter, 16, 0, 65537.5f, 1},
      {kCopter, 16, 0, 9437185, 1},          // 0x900001
      {kCopter, 16, 0, 1073741952, 128},     // 2^30 + 2^7
      {kCopter, 16, 0, 2147483520, 65408},   // the last below 2^31
      {kCopter, 16, 0, 2147483648.f, kNaN},  // 2^31
      {kCopter, 16, 0, 8589934592.f, kNaN},  // 2^33
      {kCopter, 16, 0, -1, kNaN},
      {kCopter, 16, 0, 0.5f, 0},
      {kCopter, 202, 0, 257, 1},    // 8 bits
      {kCopter, 93, 1, 128, -128},  // 8 bits with a sign
      {kCopter, 93, 1, -129, 127},
      {kCopter, 93, 1, -9437185, -1},
      {kCopter, 177, 1, 32768, -32768},  // 16 bits with a sign
      // A radius keeps its sign beside 16 bits.
      {kCopter, 17, 2, 65537, 1},
      {kCopter, 17, 2, -65537, -1},
      {kCopter, 17, 2, 98304, 32768},
      {kCopter, 17, 2, 9437185, 1},
      // The acceptance radius of a plane: 16 bits, and then 255 at the most.
      {kPlane, 16, 1, 32800, 255},
      {kPlane, 16, 1, 65540, 4},
      {kPlane, 16, 1, 3.5f, 3},
      {kPlane, 16, 1, -1, kNaN},
      // Turns and their radius.
      {kCopter, 18, 0, 1.5f, 1},
      {kCopter, 18, 0, 256, 255},
      {kCopter, 18, 0, 0.3f, 0.296875f},
      {kCopter, 18, 0, -1, kNaN},
      {kCopter, 18, 0, 1e10f, kNaN},
      {kCopter, 18, 2, 254.5f, 254},
      {kCopter, 18, 2, 255.5f, 250},
      {kCopter, 18, 2, 259, 250},
      {kCopter, 18, 2, -265, -260},
      {kCopter, 18, 2, 5000, 2550},
      // What is dropped, and would change the flight.
      {kCopter, 178, 3, 1, 0},
      {kCopter, 207, 1, 2, 0},
      {kCopter, 3000, 1, 1, 0},
      // 0 or 1.
      {kCopter, 18, 3, 0.5f, 1},
      {kCopter, 18, 3, -0.5f, 0},
      {kCopter, 18, 3, -0.f, 0},
      {kCopter, 18, 3, 0, 0},
      {kCopter, 223, 3, 0.5f, 0},
      {kCopter, 223, 3, 3, 1},
      {kCopter, 223, 3, -1, kNaN},
      {kCopter, 223, 3, 2147483648.f, kNaN},
      // NAV_ATTITUDE_TIME: what is beyond the range is 0, what is within is cut.
      {kCopter, 42703, 0, 70000, 65535},
      {kCopter, 42703, 0, 1e10f, 65535},
      {kCopter, 42703, 0, -3, 0},
      {kCopter, 42703, 1, 179.5f, 179},
      {kCopter, 42703, 1, -179.5f, -179},
      {kCopter, 42703, 1, 180, 180},
      {kCopter, 42703, 1, -180, -180},
      {kCopter, 42703, 1, 180.5f, 0},
      {kCopter, 42703, 1, -180.5f, 0},
      {kCopter, 42703, 2, 89.5f, 89},
      {kCopter, 42703, 2, 90, 90},
      {kCopter, 42703, 2, 90.5f, 0},
      {kCopter, 42703, 2, -90.5f, 0},
      {kCopter, 42703, 3, 359.5f, 359},
      {kCopter, 42703, 3, 360, 360},
      {kCopter, 42703, 3, 360.5f, 0},
      {kCopter, 42703, 3, -180.5f, 0},
      {kCopter, 42703, 3, -180, -180},
      // Fences: ArduPilot's circles, and the number of corners, which PX4 rounds.
      {kByArduPilot | kOfFence, 5003, 0, 5.0005f, 5},
      {kByArduPilot | kOfFence, 5003, 0, 0.0005f, 0},
      {kByArduPilot | kOfFence, 5003, 0, 1.0005f, 1},
      {kByArduPilot | kOfFence, 5001, 0, 3.75f, 3},
      {kByPx4 | kOfFence, 5001, 0, 3.25f, 3},
      {kByPx4 | kOfFence, 5001, 0, 3.375f, 3},
      {kByPx4 | kOfFence, 5001, 0, 3.5f, 4},
      {kByPx4 | kOfFence, 5001, 0, 4.75f, 5},
      {kByPx4 | kOfFence, 5001, 0, 65537, 1},
      // The height of a rally point.
      {kByArduPilot | kOfRally, 5100, 6, 20.5f, 20},
      {kByArduPilot | kOfRally, 5100, 6, -20.5f, -20},
      {kByArduPilot | kOfRally, 5100, 6, 40000, kNaN},
      {kByArduPilot | kOfRally, 5100, 6, 1e10f, kNaN},
      // Limits, to the last bit.
      {kCopter, 18, 2, 255, 255},
      {kCopter, 18, 2, std::nextafter(255.f, 256.f), 250},
      {kCopter, 42703, 1, std::nextafter(180.f, 181.f), 0},
      {kCopter, 42703, 2, std::nextafter(90.f, 91.f), 0},
      {kCopter, 42703, 3, std::nextafter(360.f, 361.f), 0},
      {kCopter, 42703, 3, std::nextafter(360.f, 0.f), 359},
      {kCopter, 93, 1, 2147483648.f, kNaN},
  };
  for (const Case& one : kCases) {
    const float kept = keptValue(itemWith(one.command, one.index, one.sent), fieldOf(one.index), one.keeper);
    CAPTURE(one.command);
    CAPTURE(one.index);
    CAPTURE(one.sent);
    CAPTURE(kept);
    CHECK(std::isnan(kept) == std::isnan(one.kept));
    if (!std::isnan(one.kept)) CHECK(kept == one.kept);
    // No 0 below 0, that is.
    if (kept == 0) CHECK_FALSE(std::signbit(kept));
  }
}

TEST_CASE("integers beyond what a float holds are foretold as it rounds them, and 2^31 is not known") {
  const struct {
    int32_t sent;
    double kept;
  } kCases[] = {{16777215, 16777215.0},
                {16777216, 16777216.0},
                {16777217, 16777216.0},
                {16777219, 16777220.0},
                {-16777219, -16777220.0},
                {33554433, 33554432.0},
                {-1, -1.0},
                {1, 1.0},
                {2147483583, 2147483520.0},
                {2147483647, static_cast<double>(kNaN)},
                {INT32_MIN, -2147483648.0}};
  for (const auto& one : kCases) {
    MissionItem item = anyCommand(kNavReturnToLaunch);
    item.x = one.sent;
    const double kept = static_cast<double>(keptValue(item, ItemField::Latitude, kByPx4));
    CAPTURE(one.sent);
    CAPTURE(kept);
    CHECK((std::isnan(one.kept) ? std::isnan(kept) : kept == one.kept));
  }
}

TEST_CASE("what is no number of an item has no kept value") {
  const MissionItem item = land();
  for (const ItemField field :
       {ItemField::None, ItemField::Count, ItemField::Command, ItemField::Reference, ItemField::Autocontinue}) {
    for (const Keeper keeper : {kCopter, Keeper(kByPx4), Keeper(0)}) CHECK(std::isnan(keptValue(item, field, keeper)));
  }
}
