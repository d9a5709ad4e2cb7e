// A plan as one autopilot wants it on the wire. The sketch numbers its items from 0 and writes one plan for all; this
// is where home is put before it (ArduPilot), jumps are shifted, items without a place get the frame that is taken, a
// takeoff gets the place that PX4 needs, and what cannot be right or is not flown there is refused.
#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../ItemSource.h"
#include "../PlanType.h"
#include "../Status.h"
#include "../autopilot/Commands.h"

namespace mavmission {
namespace detail {

struct Rules;

class WirePlan {
 public:
  // Sets what is to go: a source of at most 65,535 items.
  void setSource(const ItemSource& plan);

  // Sets to whom it is to go, by HEARTBEAT.type too. `raw`: item numbers and item 0 are the autopilot's own, nothing is
  // put before or shifted. So it is with fence and rally, which have no home and no jumps.
  void begin(Firmware firmware, uint8_t vehicleType, PlanType type, bool raw);

  Firmware firmware() const { return firmware_; }
  // Who is to keep it.
  Keeper keeper() const { return keeper_; }

  // True where wire item 0 is home, whoever supplies it.
  bool beginsWithHome() const { return (keeper_ & (kByArduPilot | kIsRaw)) == kByArduPilot; }

  // The sketch's items.
  uint16_t count() const { return count_; }

  // 1 where wire item 0 is home and we supply it, else 0. An empty plan has no home either: COUNT 0 clears.
  uint8_t homeItems() const { return homeItems_; }

  // True when the items and home are more than the protocol can count.
  bool isTooLong() const { return count_ == 0xFFFF && homeItems_ != 0; }

  // Items on the wire, home included. Not when isTooLong().
  uint16_t wireCount() const { return count_ + homeItems_; }

  // Makes wire item `wireIndex` (below wireCount()). Status::Accepted: `item` is what goes out. Status::Checking: not
  // ready yet, call again (a place is being looked for, a few items a call). Anything else: the plan cannot go to this
  // autopilot, because of this item. Whether the autopilot would keep it is another question: notKept().
  Status read(uint16_t wireIndex, MissionItem& item);

 private:
  static constexpr uint8_t kIsRaw = 64;  // beside the flags of a Keeper
  Status check(const MissionItem& item, const Rules& rules) const;
  // Looks for an item near item `index`, which is `item`, whose place that one can have, and puts it there instead.
  MAVMISSION_APART Status findPlaceFor(uint16_t index, MissionItem& item);

  ItemFunction read_;
  void* context_;
  uint16_t count_;
  uint16_t searched_;  // places that have been looked at around an item that needs one
  Firmware firmware_;
  uint8_t homeItems_;
  Keeper keeper_;  // and kIsRaw
};

// The way back: makes of an item of the mission, as the autopilot gave it, the item that a sketch would have written.
// Jump targets count the sketch's items, frames have their present numbers, an item without a place has Frame::Mission,
// and a yaw that ArduPilot does not keep is NaN, "as you fly".
void fromWire(MissionItem& item, Firmware firmware);

}  // namespace detail
}  // namespace mavmission
