// Flight modes, with one name for all autopilots. Each autopilot has its own number for a mode.
#pragma once

#include <stdint.h>

#include "AutopilotFinder.h"

namespace mavmission {

// Each mode is named after what the aircraft does in it.
enum class FlightMode : uint8_t {
  Auto,            // fly the mission: AUTO on ArduPilot, MISSION on PX4
  Guided,          // fly where a companion says: GUIDED, or OFFBOARD on PX4 (which wants setpoints first)
  ReturnToLaunch,  // fly home: RTL
  Hold,            // stay: LOITER on Copter, Plane and Blimp, HOLD on Rover and PX4, POSHOLD on Sub
  Land,            // land here: LAND on Copter, PX4 and Blimp, QLAND on a QuadPlane that says it is one
  Brake,           // stop at once: BRAKE; Copter
  Manual,          // the pilot steers: STABILIZE on Copter, else MANUAL
};

namespace detail {

// The other mode in which a vehicle returns by itself, which no sketch sets by name: QRTL of ArduPilot's planes,
// SMART_RTL of its copters and rovers.
constexpr FlightMode kOtherReturn = static_cast<FlightMode>(static_cast<uint8_t>(FlightMode::Manual) + 1);

}  // namespace detail

// This vehicle's number of a mode (docs/modes.md lists them all): DO_SET_MODE's parameter 2 in the lower byte,
// parameter 3 in the upper one; kNoMode if the vehicle has no such mode, or if no ArduPilot vehicle has that type
// (HEARTBEAT.type).
constexpr uint16_t kNoMode = 0xFFFF;
uint16_t modeNumber(FlightMode mode, Firmware firmware, uint8_t vehicleType);

// The same number from a HEARTBEAT.custom_mode: PX4 has its main and sub mode in the upper half, and zeros in the lower
// one.
inline uint16_t modeNumberOf(uint32_t customMode) {
  const uint16_t upper = static_cast<uint16_t>(customMode >> 16);
  return upper != 0 ? upper : static_cast<uint16_t>(customMode);
}

// True if HEARTBEAT.custom_mode is this mode.
bool isInMode(FlightMode mode, Firmware firmware, uint8_t vehicleType, uint32_t customMode);

// The autopilot's own name of a HEARTBEAT.custom_mode, such as "GUIDED" or "POSCTL", for Serial.print(). Flash text;
// "unknown" for a mode that has none, or of a vehicle or an autopilot that is not known.
FlashText modeName(Firmware firmware, uint8_t vehicleType, uint32_t customMode);

}  // namespace mavmission
