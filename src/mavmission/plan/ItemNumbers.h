// An item has two numbers: the sketch's, which begins at 0, and the one on the wire, in MISSION_ITEM_INT.seq. They
// differ where wire item 0 is the autopilot's home and the sketch does not count it. The one place that knows of home.
#pragma once

#include <stdint.h>

#include "../autopilot/Personality.h"
#include "../item/PlanType.h"

namespace mavmission {
namespace detail {

class ItemNumbers {
 public:
  // `raw`: the sketch uses the autopilot's numbers, so home is its item 0. Fences and rally points have no home.
  void begin(Firmware firmware, PlanType type, bool raw) {
    home_ = 0;
    if (type == PlanType::Mission && hasHome(firmware)) home_ = raw ? kCounted : kBefore;
  }

  // 1 if home is on the wire before the sketch's first item, else 0.
  uint8_t before() const { return kServesArduPilot ? home_ & kBefore : 0; }
  bool isHomeAdded() const { return kServesArduPilot && home_ == kBefore; }
  // 1 if wire item 0 is home, whoever counts it, else 0.
  uint8_t home() const { return kServesArduPilot && home_ != 0 ? 1 : 0; }
  bool isHome(uint16_t wireItem) const { return wireItem == 0 && home() != 0; }
  bool isOwnHome(uint16_t item) const { return item == 0 && home_ == kCounted; }

  uint16_t toWire(uint16_t item) const { return item + before(); }
  // 0xFFFF, which is no item's number, for a home that the sketch does not count.
  MAVMISSION_APART uint16_t toOwn(uint16_t wireItem) const { return wireItem - before(); }

  // How many items MISSION_COUNT announces for so many of the sketch's. Home is not added to an empty plan: a count of
  // 0 clears the plan aboard.
  uint16_t wireCount(uint16_t items) const { return items == 0 ? 0 : toWire(items); }
  // How many of the sketch's are in a plan that the autopilot counts so.
  uint16_t ownCount(uint16_t wireItems) const { return wireItems == 0 ? 0 : toOwn(wireItems); }
  // Whether the autopilot counts so a plan of so many of the sketch's items. ArduPilot without a plan counts 0, or 1
  // for its home.
  bool isCountOf(uint16_t items, uint16_t wireItems) const {
    return wireItems == toWire(items) || (items | wireItems) == 0;
  }
  // What MISSION_CURRENT.total says of so many of the sketch's items: ArduPilot does not count home there.
  uint16_t toldTotal(uint16_t items) const { return items != 0 && home_ == kCounted ? items - 1 : items; }

  // Whether wire item 0 of a mission is the autopilot's home.
  static bool hasHome(Firmware firmware) { return has(firmware, kHomeIsItem0); }

  // The wire item with which a flight from this one begins, which is never home.
  static uint16_t firstFlown(uint16_t wireItem, Firmware firmware) {
    return wireItem == 0 && hasHome(firmware) ? 1 : wireItem;
  }

 private:
  static constexpr uint8_t kBefore = 1;   // wire item 0 is home, and none of the sketch's
  static constexpr uint8_t kCounted = 2;  // the sketch's item 0 is home
  uint8_t home_;                          // one of these, or 0: there is no home
};

}  // namespace detail
}  // namespace mavmission
