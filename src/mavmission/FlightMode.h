// What the aircraft is to do, by one name on every autopilot; each has numbers of its own for it.
#pragma once

#include <stdint.h>

#include "AutopilotFinder.h"

namespace mavmission {

// By what the aircraft then does.
enum class FlightMode : uint8_t {
  Auto,            // fly the mission: AUTO on ArduPilot, MISSION on PX4
  Guided,          // fly where a companion says: GUIDED, or OFFBOARD on PX4 (which wants setpoints first)
  ReturnToLaunch,  // fly home: RTL
  Hold,            // stay: LOITER on Copter and Plane, HOLD on Rover and PX4
  Land,            // land here: LAND; Copter and PX4
  Brake,           // stop at once: BRAKE; Copter
  Manual,          // the pilot steers: MANUAL on Rover, Plane and PX4, STABILIZE on Copter
};

// DO_SET_MODE's parameters 2 and 3 for a mode; false if this vehicle has no such mode.
bool modeNumbers(FlightMode mode, Firmware firmware, uint8_t vehicleType, uint8_t& mainMode, uint8_t& subMode);

// True if HEARTBEAT.custom_mode says that the vehicle is in this mode.
bool isInMode(FlightMode mode, Firmware firmware, uint8_t vehicleType, uint32_t customMode);

}  // namespace mavmission
