// What MISSION_CURRENT tells about whose plan is aboard. A file of its own, since only start() and MissionFollower ask.
#include "../link/Messages.h"
#include "MissionClient.h"

namespace mavmission {
using namespace detail;

// True if this MISSION_CURRENT is about another plan than ours: by the name that PX4 gives it, elsewhere by the number
// of its items. PX4 without a plan names none, and its number is 65535.
bool Port::namesOther(const FrameParser& frame) const {
  typedef mavlink_mission_current_t Current;
  const Client& client = static_cast<const Client&>(*this);
  const uint32_t name = frame.payloadLong(offsetof(Current, mission_id));
  const uint16_t total = frame.payloadWord(offsetof(Current, total));
  const uint32_t ours = client.known_.planId;
  if (ours != 0 && (name != 0 || total == 0xFFFF)) return name != ours;
  // An autopilot that does not know the mission's state does not know its total either.
  const bool isTotalKnown = has(client.firmware(), kTellsTotal) && client.isMissionInPlan() &&
                            frame.payloadByte(offsetof(Current, mission_state)) != MISSION_STATE_UNKNOWN;
  if (!isTotalKnown) return false;
  return total != client.numbersAboard().toldTotal(client.plan_.count());
}

}  // namespace mavmission
