// A plan in the form that one autopilot needs on the wire. The sketch numbers its items from 0 and writes one plan for
// all autopilots. This class puts home before the plan (ArduPilot), shifts the targets of jumps, gives items without a
// place the frame that the autopilot takes, gives a takeoff the place that PX4 needs, and refuses items that cannot be
// right or that this autopilot does not fly.
#pragma once

#include <stdint.h>

#include "../autopilot/Commands.h"
#include "../autopilot/Personality.h"
#include "../base/Config.h"
#include "../base/Status.h"
#include "../item/PlanType.h"
#include "ItemNumbers.h"
#include "ItemSource.h"

namespace mavmission {
namespace detail {

struct Rules;

class WirePlan {
 public:
  // Sets the source of the items, at most 65,535.
  void setSource(const ItemSource& plan);
  // True if this source was set last.
  bool isFrom(const ItemSource& plan) const {
    return read_ == plan.read && context_ == plan.context && count_ == static_cast<uint16_t>(plan.count);
  }

  // Sets the autopilot that gets the plan. `vehicleType`: HEARTBEAT.type. `raw`: the sketch uses the autopilot's own
  // item numbers, so that home is not added and jumps are not shifted. Fence and rally are always raw, since they have
  // neither home nor jumps.
  void begin(Firmware firmware, uint8_t vehicleType, PlanType type, bool raw);

  Firmware firmware() const { return firmware_; }
  bool has(Trait trait) const { return detail::has(firmware_, trait); }
  // The autopilot that will keep the plan, and the plan's type.
  Keeper keeper() const { return keeper_; }

  // The number of the sketch's items.
  uint16_t count() const { return count_; }

  // The numbers of its items, the sketch's and those on the wire.
  const ItemNumbers& numbers() const { return numbers_; }

  // True if there are more items, home included, than the protocol can count.
  bool isTooLong() const { return count_ == 0xFFFF && numbers_.isHomeAdded(); }

  // The number of items on the wire, home included. Not valid when isTooLong().
  MAVMISSION_APART uint16_t wireCount() const { return numbers_.wireCount(count_); }

  // Makes wire item `wireIndex` (below wireCount()). Status::Accepted: `item` is the item to send. Status::Checking:
  // the search for a place goes on, a few items in every call; call again. Any other status: the plan cannot be sent to
  // this autopilot, because of this item. Whether the autopilot would keep the item is not checked here (notKept()),
  // nor whether the items of a fence make areas (Areas).
  Status read(uint16_t wireIndex, MissionItem& item);

  // Whether an item that was read leads where it can go. A DO_JUMP_TAG: the search for its tag goes on, an item in
  // every call, and reads the items over `item`; call read() and this again while it is Checking. Any other: Accepted.
  Status follow(MissionItem& item);

 private:
  MAVMISSION_APART Status settle(uint16_t index, MissionItem& item) const;
  Status check(MissionItem& item, Rules rules) const;
  // Searches for the item with a place that is nearest to item `index`. `item` holds item `index` before the call, and
  // the item that was found after it.
  MAVMISSION_APART Status findPlaceFor(uint16_t index, MissionItem& item);

  ItemFunction read_;
  void* context_;
  uint16_t count_;
  uint16_t searched_;  // how many positions around an item without a place, or items for a tag, have been searched
  Firmware firmware_;
  ItemNumbers numbers_;
  Keeper keeper_;
};

// True if an item of a command that has a place has an altitude: zeros are none, but in a command of navigation
// (MAV_CMD_NAV_LAST is 95). MAV_FRAME_MISSION does not say what it is measured from, and ArduPilot takes it for one
// above sea level.
bool hasHeight(const MissionItem& item);

// The opposite conversion: turns a mission item, as the autopilot gave it, into the item that a sketch would have
// written. Jump targets then count the sketch's items, deprecated frame numbers are replaced by current ones, an item
// without a place has CoordinateFrame::Mission, and a yaw that ArduPilot does not keep is NaN, "as you fly".
void fromWire(MissionItem& item, Firmware firmware);

}  // namespace detail
}  // namespace mavmission
