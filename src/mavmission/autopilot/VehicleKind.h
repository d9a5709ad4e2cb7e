// What kind of vehicle a HEARTBEAT.type is on ArduPilot, whose mode numbers and whose way of starting a mission depend
// on it. The one place where that is decided; docs/modes.md has it as a table.
#pragma once

#include <stdint.h>

namespace mavmission {
namespace detail {

// Unknown: no vehicle of ArduPilot's sends this type, unless a plane is set to it (Q_MAV_TYPE). Its modes are not
// known.
enum class Vehicle : uint8_t { Unknown, Plane, QuadPlane, Copter, Rover, Submarine, Blimp };

// `type`: MAV_TYPE. The types are those that the sources of ArduPilot 4.6.3 send.
Vehicle vehicleOf(uint8_t type);

// True for the types of Plane (MAV_TYPE_FIXED_WING) and of QuadPlane (all of VTOL).
constexpr uint8_t kFixedWing = 1, kFirstVtol = 19, kLastVtol = 25;
constexpr bool isPlane(uint8_t type) {
  return type == kFixedWing || static_cast<uint8_t>(type - kFirstVtol) <= kLastVtol - kFirstVtol;
}

}  // namespace detail
}  // namespace mavmission
