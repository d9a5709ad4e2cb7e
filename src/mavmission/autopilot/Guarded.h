// The gate for whatever takes an aircraft, arms it, or lets its motors start: which commands pass it.
//
// Such a command leaves the client right after a heartbeat that came after loop() last stood still, and that shows no
// reason against it; so does each of its repeats. Client::Command::send() is the gate: there is no other way out for a
// COMMAND_LONG or COMMAND_INT of an operation.
#pragma once

#include <stdint.h>

namespace mavmission {
namespace detail {

// MAV_CMD, as the MAVLink guide numbers them; those of ArduPilot's own dialect are named here.
enum GuardedCommand : uint16_t {
  kNavTakeoff = 22,
  kNavTakeoffLocal = 24,
  kNavVtolTakeoff = 84,
  kLastNavigation = 95,  // MAV_CMD_NAV_LAST: NAV_TAKEOFF, NAV_LAND, DO_ORBIT and the others change the mode at once
  kDoSetMode = 176,
  kDoChangeSpeed = 178,  // changes what a failsafe of PX4 flies, of which its heartbeat tells up to a second later
  kDoReposition = 192,
  kDoPauseContinue = 193,
  kDoMotorTest = 209,
  kDoEngineControl = 223,
  kDoSetStandardMode = 262,
  kMissionStart = 300,
  kArmDisarm = 400,
  kSoloFlyClick = 42001,  // SOLO_BTN_FLY_CLICK, _HOLD and _PAUSE_CLICK: set modes, arm and take off
  kSoloPauseClick = 42003,
};

// True for a command that may take the aircraft from somebody.
constexpr bool isGuarded(uint16_t command) {
  return (command != 0 && command <= kLastNavigation) || command == kDoSetMode || command == kDoChangeSpeed ||
         command == kDoReposition || command == kDoPauseContinue || command == kDoMotorTest ||
         command == kDoEngineControl || command == kDoSetStandardMode || command == kMissionStart ||
         command == kArmDisarm || (command >= kSoloFlyClick && command <= kSoloPauseClick);
}

// True for a command that may arm a disarmed aircraft, or let its motors start. `isOn`: its param1 is not 0.
constexpr bool mayStartMotors(uint16_t command, bool isOn) {
  return command == kNavTakeoff || command == kNavTakeoffLocal || command == kNavVtolTakeoff ||
         command == kDoMotorTest || command == kMissionStart ||
         (isOn && (command == kArmDisarm || command == kDoEngineControl)) ||
         (command >= kSoloFlyClick && command < kSoloPauseClick);
}

}  // namespace detail
}  // namespace mavmission
