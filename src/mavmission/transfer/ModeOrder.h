// An order that changes the mode of an aircraft of which others may change the mode, too: a pilot, a failsafe, another
// station. MAVLink has no command that changes a mode only if it is still the one that was seen. So each attempt of the
// order leaves right after a heartbeat (CommandTransfer::guard()) in which this class has seen no foreign mode; and
// when a foreign mode has come too late for that, and the order undoes it, the foreign mode is set again.
#pragma once

#include <stdint.h>

#include "../base/Config.h"

namespace mavmission {
namespace detail {

// All zero at the start.
class ModeOrder {
 public:
  // What a heartbeat shows.
  //   Before: the mode from which the order leads away; the order may be sent, or sent again.
  //   Wanted: its mode.
  //   Doubtful: a foreign mode, while the order may still be under way, or for the first time the mode that is set
  //   again, while a repeat of its command may be: ask for another heartbeat.
  //   Foreign: a foreign mode, which stays.
  //   Undone: the order has undone a foreign mode. From now on this is the order to set the foreign mode, wanted(),
  //   again, and isRestoring(): send it at once.
  enum class Sight : uint8_t { Before, Wanted, Doubtful, Foreign, Undone };

  MAVMISSION_APART void begin(uint16_t from, uint16_t wanted);
  uint16_t wanted() const { return wanted_; }
  // True for the mode from which the order leads away, as long as no other one was seen.
  bool isFrom(uint16_t mode) const { return !isForeign_ && mode == other_; }
  bool isRestoring() const { return isRestoring_; }
  // Makes it the order to go back to the mode from which it led away.
  void turn() { begin(wanted_, other_); }

  // `isSent`: the order has left. `isUnderWay`: it may not have arrived yet.
  MAVMISSION_APART Sight onHeartbeat(uint16_t mode, bool isSent, bool isUnderWay);

 private:
  uint16_t wanted_;
  uint16_t other_;  // the mode from which it leads away; isForeign_: the last foreign mode that was seen
  bool isForeign_ : 1;
  bool isSeen_ : 1;  // a heartbeat has shown the wanted mode
  bool isRestoring_ : 1;
};

}  // namespace detail
}  // namespace mavmission
