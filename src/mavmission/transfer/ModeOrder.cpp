#include "ModeOrder.h"

#include "../autopilot/FlightMode.h"

namespace mavmission {
namespace detail {

void ModeOrder::begin(uint16_t from, uint16_t wanted) {
  wanted_ = wanted;
  other_ = from;
  isForeign_ = isSeen_ = isRestoring_ = false;
}

ModeOrder::Sight ModeOrder::onHeartbeat(uint16_t mode, bool isSent, bool isUnderWay) {
  if (wanted_ == kNoMode) return Sight::Wanted;  // its modes are not known
  if (mode == wanted_) {
    if (!isForeign_) {
      // A repeat that is still to arrive would undo whatever mode is set meanwhile: a second heartbeat decides.
      const bool isSure = !isRestoring_ || isSeen_ || !isUnderWay;
      if (isSent) isSeen_ = true;
      return isSure ? Sight::Wanted : Sight::Doubtful;
    }
    turn();
    isRestoring_ = true;
    return Sight::Undone;
  }
  // Once the wanted mode, or a foreign one, was seen, a change back to the mode of before is somebody else's choice.
  if (isFrom(mode) && !isSeen_) return Sight::Before;
  if (!isSent || !isUnderWay) return Sight::Foreign;
  isForeign_ = true;
  other_ = mode;
  return Sight::Doubtful;
}

}  // namespace detail
}  // namespace mavmission
