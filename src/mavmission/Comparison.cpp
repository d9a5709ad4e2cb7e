#include "Comparison.h"

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

uint8_t rulesOf(uint16_t command, Firmware firmware) {
  for (const Row& row : kRows) {
    if (fromFlash(&row.command) == command) return fromFlash(firmware == Firmware::Px4 ? &row.px4 : &row.arduPilot);
  }
  return 0;
}

bool obeys(uint8_t rule, float sent, float read) {
  if (isSame(sent, read)) return true;
  switch (rule) {
    case D:
      return isSame(read, 0);
    case W:
      return isSame(read, wholePart(sent));
    case S:
      return isSame(read, isNegative(sent) ? -1 : 1);
    default:
      return false;
  }
}

bool isSameFrame(const MissionItem& sent, const MissionItem& read, Firmware firmware) {
  if (modern(sent.frame) == modern(read.frame)) return true;
  // ArduPilot gives items without a place as Global, whatever they had.
  const bool hasNoPlace = sent.frame == Frame::Mission || (traitsOf(sent.command) & kHasNoPlace);
  return firmware == Firmware::ArduPilot && read.frame == Frame::Global && hasNoPlace;
}

bool isSameHeight(const MissionItem& sent, const MissionItem& read, Firmware firmware, PlanType type) {
  if (isSame(sent.z, read.z)) return true;
  if (firmware != Firmware::ArduPilot) return false;
  if (type == PlanType::Rally) return isSame(read.z, wholePart(sent.z));  // rally heights are whole metres
  if (sent.command == kDoMountControl) return isSame(read.z, 2);          // MAV_MOUNT_MODE_MAVLINK_TARGETING, always
  return centimetresKept(sent.z) == centimetresRead(read.z);
}

}  // namespace

Field difference(const MissionItem& sent, const MissionItem& read, Firmware firmware, PlanType type) {
  if (read.command != sent.command) return Field::Command;
  if (!isSameFrame(sent, read, firmware)) return Field::Reference;
  const bool rewrites = type == PlanType::Mission && (firmware == Firmware::ArduPilot || firmware == Firmware::Px4);
  uint8_t left = rewrites ? rulesOf(sent.command, firmware) : 0;
  const float sentParams[] = {sent.param1, sent.param2, sent.param3, sent.param4};
  const float readParams[] = {read.param1, read.param2, read.param3, read.param4};
  for (uint8_t i = 0; i < 4; ++i, left >>= 2) {
    if (!obeys(left & 3, sentParams[i], readParams[i])) {
      return static_cast<Field>(static_cast<uint8_t>(Field::Param1) + i);
    }
  }
  if (read.x != sent.x) return Field::Latitude;
  if (read.y != sent.y) return Field::Longitude;
  if (!isSameHeight(sent, read, firmware, type)) return Field::Height;
  // Fence and rally items come back with 0, those of ArduPilot's missions with 1.
  const bool isAlways1 = firmware == Firmware::ArduPilot && read.autocontinue == 1;
  if (type == PlanType::Mission && !isAlways1 && read.autocontinue != sent.autocontinue) return Field::Autocontinue;
  return Field::None;
}

}  // namespace mavmission
