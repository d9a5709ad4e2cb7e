#include "Comparison.h"

#include <stddef.h>
#include <string.h>

#include "Flash.h"
#include "FloatBits.h"

namespace mavmission {
namespace {

// What becomes of a parameter. Kept as it was is right for each.
enum Rule : uint8_t {
  K = 0,  // kept
  D = 1,  // dropped: read as 0
  W = 2,  // whole: what is behind the point is dropped
  S = 3,  // sign: read as 1, or as -1 if it was negative
};

constexpr uint8_t rules(Rule param1, Rule param2, Rule param3, Rule param4) {
  return static_cast<uint8_t>(param1 | param2 << 2 | param3 << 4 | param4 << 6);
}

struct Row {
  uint16_t command;
  uint8_t arduPilot;
  uint8_t px4;
};

// Observed: test/recordings/readback_arducopter.csv, readback_ardurover.csv and readback_px4.csv. Commands that are not
// here keep their parameters on both.
const Row kRows[] PROGMEM = {
    {16, rules(W, D, D, D), rules(K, K, D, K)},   // NAV_WAYPOINT: seconds whole; PX4 drops the pass radius
    {17, rules(K, K, K, D), rules(K, K, K, K)},   // NAV_LOITER_UNLIM
    {18, rules(K, D, K, K), rules(K, K, K, K)},   // NAV_LOITER_TURNS
    {19, rules(W, D, S, K), rules(K, K, K, K)},   // NAV_LOITER_TIME: of the radius only the direction
    {21, rules(K, D, K, S), rules(D, K, K, K)},   // NAV_LAND
    {22, rules(K, K, K, D), rules(D, K, K, K)},   // NAV_TAKEOFF
    {31, rules(D, K, K, K), rules(K, K, K, K)},   // NAV_LOITER_TO_ALT
    {84, rules(K, K, K, D), rules(K, K, K, K)},   // NAV_VTOL_TAKEOFF
    {85, rules(K, K, K, D), rules(K, K, K, K)},   // NAV_VTOL_LAND
    {201, rules(K, K, K, K), rules(D, K, K, K)},  // DO_SET_ROI
};

constexpr uint16_t kDoMountControl = 205;

// Whether `read` is what the rule makes of `sent`, or `sent` itself.
bool obeys(uint8_t rule, float sent, float read) {
  float kept = sent;
  switch (rule) {
    case D:
      kept = 0;
      break;
    case W:
      kept = wholePart(sent);
      break;
    case S:
      kept = isNegative(sent) ? -1 : 1;
      break;
    default:
      break;
  }
  return isSame(read, sent) || isSame(read, kept);
}

bool isSameFrame(const MissionItem& sent, const MissionItem& read, Firmware firmware, PlanType type) {
  if (modern(sent.frame) == modern(read.frame)) return true;
  // ArduPilot gives items without a place as Global, whatever they had, and those of a fence, which has no altitude there.
  const bool hasNoHeight =
      type == PlanType::Fence || sent.frame == Frame::Mission || (traitsOf(sent.command) & kHasNoPlace);
  return firmware == Firmware::ArduPilot && read.frame == Frame::Global && hasNoHeight;
}

// The rules of param1 to param4, of an item of this plan.
uint8_t rulesOf(const MissionItem& sent, Firmware firmware, PlanType type) {
  if (type != PlanType::Mission || (firmware != Firmware::ArduPilot && firmware != Firmware::Px4)) return 0;
  for (const Row& row : kRows) {
    if (fromFlash(&row.command) == sent.command) return fromFlash(firmware == Firmware::Px4 ? &row.px4 : &row.arduPilot);
  }
  return 0;
}

// Heights that ArduPilot gives back another way than whole, dropped, or as a sign.
bool isHeightKept(const MissionItem& sent, const MissionItem& read) {
  if (sent.command == kDoMountControl) return isSame(read.z, 2);  // MAV_MOUNT_MODE_MAVLINK_TARGETING, always
  return centimetresKept(sent.z) == centimetresRead(read.z);
}

// param1 to param4, x, y, z lie one behind the other, four bytes each.
constexpr uint8_t kX = 4, kY = 5, kZ = 6;
static_assert(offsetof(MissionItem, x) == sizeof(float) * kX && offsetof(MissionItem, y) == sizeof(float) * kY &&
                  offsetof(MissionItem, z) == sizeof(float) * kZ,
              "in their order");
static_assert(static_cast<uint8_t>(Field::Latitude) == static_cast<uint8_t>(Field::Param1) + kX &&
                  static_cast<uint8_t>(Field::Height) == static_cast<uint8_t>(Field::Param1) + kZ,
              "fields have the same order");

}  // namespace

Field difference(const MissionItem& sent, const MissionItem& read, Firmware firmware, PlanType type) {
  if (read.command != sent.command) return Field::Command;
  if (!isSameFrame(sent, read, firmware, type)) return Field::Reference;
  uint8_t rules = rulesOf(sent, firmware, type);
  const uint8_t* sentBytes = reinterpret_cast<const uint8_t*>(&sent);
  const uint8_t* readBytes = reinterpret_cast<const uint8_t*>(&read);
  for (uint8_t i = 0; i <= kZ; ++i, rules >>= 2, sentBytes += 4, readBytes += 4) {
    if (memcmp(sentBytes, readBytes, 4) == 0) continue;
    if (i != kX && i != kY) {
      float sentNumber, readNumber;
      memcpy(&sentNumber, sentBytes, 4);
      memcpy(&readNumber, readBytes, 4);
      const bool isArduPilots = i == kZ && firmware == Firmware::ArduPilot;
      // Rally heights are whole metres, and a fence has none.
      if (isArduPilots && type != PlanType::Mission) rules = type == PlanType::Rally ? W : D;
      if (obeys(rules & 3, sentNumber, readNumber)) continue;
      if (isArduPilots && type == PlanType::Mission && isHeightKept(sent, read)) continue;
    }
    return static_cast<Field>(static_cast<uint8_t>(Field::Param1) + i);
  }
  // Fence and rally items come back with 0, those of ArduPilot's missions with 1.
  const bool isAlways1 = firmware == Firmware::ArduPilot && read.autocontinue == 1;
  if (type == PlanType::Mission && !isAlways1 && read.autocontinue != sent.autocontinue) return Field::Autocontinue;
  return Field::None;
}

}  // namespace mavmission
