#include "WirePlan.h"

#include <string.h>

#include "../autopilot/Rules.h"
#include "../base/Config.h"
#include "../base/FloatBits.h"

namespace mavmission {
namespace detail {
namespace {

constexpr uint16_t kNavLast = 95, kJumpTag = 600, kDoJumpTag = 601;  // MAV_CMD
// Above the limit, or below its negative. In one comparison: what is below becomes large.
bool isBeyond(int32_t value, uint32_t limit) { return static_cast<uint32_t>(value) + limit > 2 * limit; }

bool is(const float& number, uint32_t bits) {
  uint32_t found;
  memcpy(&found, &number, sizeof(found));
  return found == bits;
}
constexpr uint32_t kMinus1 = 0xBF800000, k65535 = 0x477FFF00;

// True for an altitude within ArduPilot's limit of 83,000 m. (NaN and infinity are refused before.)
bool isBelow83km(float metres) {
  uint32_t bits;
  memcpy(&bits, &metres, sizeof(bits));
  return (bits & 0x7FFFFFFF) < 0x47A21C00;  // 83,000
}

// Of a JUMP_TAG and of a DO_JUMP_TAG; 65535 for what is no tag, and no vehicle keeps.
uint16_t tagOf(const MissionItem& item) { return static_cast<uint16_t>(wholeNumber(&item.param1)); }

bool hasPlace(const MissionItem& item) { return item.frame != CoordinateFrame::Mission; }
MAVMISSION_APART bool isAtZero(const MissionItem& item) { return (item.x | item.y) == 0; }
bool isSomewhere(const MissionItem& item) { return hasPlace(item) && !isAtZero(item); }

// True if the autopilot takes this frame, by its modern number, in an item with a place.
bool isTakenBy(Firmware firmware, CoordinateFrame frame) {
  return has(firmware, kMayTakeAnyFrame) || frame == CoordinateFrame::Global ||
         frame == CoordinateFrame::GlobalRelative ||
         (frame == CoordinateFrame::GlobalTerrain && has(firmware, kTakesTerrainFrames));
}

}  // namespace

void WirePlan::setSource(const ItemSource& plan) {
  read_ = plan.read;
  context_ = plan.context;
  count_ = static_cast<uint16_t>(plan.count);
}

void WirePlan::begin(Firmware firmware, uint8_t vehicleType, PlanType type, bool raw) {
  firmware_ = firmware;
  keeper_ = keeperOf(firmware, vehicleType, type);
  numbers_.begin(firmware, type, raw);
  searched_ = 0;
}

bool hasHeight(const MissionItem& item) { return item.command < kNavLast || !isAtZero(item) || !is(item.z, 0); }

Status WirePlan::check(MissionItem& item, Rules rules) const {
  if (item.current > 1) return Status::BadCurrent;
  const Keeper keeper = keeper_;  // once from memory, since the item might be there
  // param1 to param4, x, y and z lie one after the other, four bytes each.
  uint8_t* number = reinterpret_cast<uint8_t*>(&item);
  uint16_t kinds = static_cast<uint16_t>(rules.bits);  // of param1 to param4; after them 0, which is K
  for (uint8_t bit = 1 << 1; bit != 0; bit <<= 1, kinds >>= 4, number += 4) {
    if ((bit & (1 << 5 | 1 << 6)) != 0) continue;
    const FloatKind kind = kindOf(number);
    if (kind == FloatKind::Infinite) return Status::NotFinite;
    const uint8_t keptAs = static_cast<uint8_t>(kinds) & 15;
    if (!isByPx4(keeper) || keptAs != keeping::D) {
      if (kind == FloatKind::Finite) continue;
      // ArduPilot takes no NaN, nor do those with a table of their own.
      const bool isTaken = !isByArduPilot(keeper) && !isByOwn(keeper);
      const bool isYaw = bit == 1 << 4 && Rules::isYaw(keptAs);
      if (!isYaw && (!isTaken || (unsetOf(item.command) & bit) == 0)) return Status::NotANumber;
      // As a yaw it means "as you fly": ArduPilot has 0 for that, and the others turn to no heading.
      if (isTaken) continue;
    }
    memset(number, 0, 4);
  }
  if (rules.has(kIsNotTaken)) return Status::NotFlown;
  const bool isArduPilot = isByArduPilot(keeper);
  const bool isMission = (keeper & (kOfFence | kOfRally)) == 0;
  if (!rules.has(kHasNoPlace)) {
    // The coordinates are checked in every frame: in a mission ArduPilot uses them even if the frame says that there
    // are none.
    if (isBeyond(item.x, 900000000)) return Status::BadLatitude;
    if (isBeyond(item.y, 1800000000)) return Status::BadLongitude;
    if (hasPlace(item)) {
      if (!isTakenBy(firmware_, item.frame)) return Status::BadFrame;
    } else if (!isMission || isByPx4(keeper) || isByOwn(keeper)) {
      return Status::NeedsCoordinates;
    } else if (!rules.has(kPlaceIsOptional) && hasHeight(item)) {
      return Status::BadFrame;
    }
    if (isArduPilot && (keeper & kOfFence) == 0 && !isBelow83km(item.z)) return Status::BadAltitude;
    if ((isByPx4(keeper) || isByOwn(keeper)) && rules.has(kPlaceIsOptional) && isAtZero(/*item=*/item))
      return Status::Checking;
  }
  if (item.command == kDoJump) {
    const uint16_t target = static_cast<uint16_t>(wholeNumber(&item.param1));  // 65535, which is beyond: it is none
    // Home cannot be a jump's target. With raw item numbers, home is item 0.
    if (target >= count_ || numbers_.isOwnHome(target)) return Status::BadJump;
    if (numbers_.isHomeAdded()) setWhole(&item.param1, target + 1);
  }
  return Status::Accepted;
}

Status WirePlan::follow(MissionItem& item) {
  if (item.command != kDoJumpTag) return Status::Accepted;
  const uint16_t tag = tagOf(item);
  Status found = Status::BadJump;
  if (searched_ < count_) {
    found = Status::SourceRefused;
    if (read_(context_, searched_, item)) {
      ++searched_;
      if (item.command != kJumpTag || tagOf(item) != tag) return Status::Checking;
      found = Status::Accepted;
    }
  }
  searched_ = 0;
  return found;
}

Status WirePlan::findPlaceFor(uint16_t index, MissionItem& item) {
  // The nearest item with a place, in the order of the plan. Of two that are equally near, a takeoff gets the place of
  // the item after it and a landing that of the item before it, which is where the aircraft is at that time.
  const uint8_t firstSide = item.command == kNavLand || item.command == kNavVtolLand ? 1 : 0;
  for (uint8_t looked = 0; looked < MAVMISSION_ITEMS_PER_UPDATE; ++looked) {
    const uint16_t distance = searched_ / 2 + 1;
    const bool isBefore = ((searched_ & 1) ^ firstSide) != 0;
    const uint16_t near = isBefore ? index - distance : index + distance;  // before item 0: wraps beyond the plan
    ++searched_;
    Status found = Status::NeedsCoordinates;
    if (distance < count_) {
      if (near >= count_) continue;
      found = Status::SourceRefused;
      if (read_(context_, near, item)) {
        // Only the place of a navigation command counts: the aircraft does not fly to a region of interest.
        if (item.command >= kNavLast || !isSomewhere(item) || rulesOf(item, keeper_).has(kHasNoPlace)) continue;
        found = Status::Accepted;
      }
    }
    searched_ = 0;
    return found;
  }
  return Status::Checking;
}

Status WirePlan::read(uint16_t wireIndex, MissionItem& item) {
  if (numbers_.isHomeAdded()) {
    if (wireIndex == 0) {
      // ArduPilot parses item 0, but then stores its own home instead, and gives back that. Who only says that it is an
      // ArduPilot stores the item, and may fly it: so it is one that moves nothing (CONDITION_DELAY for 0 s), and that
      // no home can be (ReadingPlan::compare()).
      // All zero, CoordinateFrame::Global too. Copying a constant item would cost RAM for that constant.
      memset(&item, 0, sizeof(item));
      item.command = kConditionDelay;
      item.autocontinue = 1;
      return Status::Accepted;
    }
    --wireIndex;
  }
  Status status = settle(wireIndex, item);
  if (kOnlyArduPilot || status != Status::Checking) return status;  // else it lacks a place
  status = findPlaceFor(wireIndex, item);
  if (status != Status::Accepted) return status;
  const int32_t x = item.x, y = item.y;
  // The search has read other items over this one, which is read again: this saves the stack of a second item.
  const Status again = settle(wireIndex, item);
  item.x = x;
  item.y = y;
  return again == Status::Checking ? status : again;
}

// Reads an item of the sketch's, makes it one for this autopilot, and checks it. Checking: it is good, but PX4, and
// those with a table of their own, need a place for it.
Status WirePlan::settle(uint16_t index, MissionItem& item) const {
  if (!read_(context_, index, item)) return Status::SourceRefused;
  if (isByPx4(keeper_)) {
    if (item.command == kDoSetRoi) {
      item.command = kNavRoi;  // PX4 takes both for the same, but 1.18 takes no place in DO_SET_ROI
    } else if (item.command == kDoJump && is(item.param2, kMinus1)) {
      // "For ever". PX4 stores the repeats unsigned, and the conversion of a negative float depends on its board.
      item.param2 = 65535;
    }
  }
  const Rules rules = rulesOf(item, keeper());
  item.frame = rules.has(kHasNoPlace) ? CoordinateFrame::Mission : modern(item.frame);
  return check(item, rules);
}

void fromWire(MissionItem& item, Firmware firmware) {
  item.frame = modern(item.frame);
  const Rules rules = rulesOf(item, keeperOf(firmware, 0, PlanType::Mission));
  if (rules.has(kHasNoPlace)) item.frame = CoordinateFrame::Mission;
  item.current = 0;
  const bool isJump = item.command == kDoJump;
  if (has(firmware, kWantsRepeatsWithin16) && isJump && is(item.param2, k65535)) item.param2 = -1;
  if (has(firmware, kDropsNanYaw) && rules.hasYaw()) item.param4 = Yaw().inDegrees();
  if (ItemNumbers::hasHome(firmware) && isJump) item.param1 = oneLess(item.param1);
}

}  // namespace detail
}  // namespace mavmission
