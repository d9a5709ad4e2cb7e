#include "FlightMode.h"

#include "../base/Flash.h"
#include "Personality.h"
#include "VehicleKind.h"

namespace mavmission {
using namespace detail;
namespace {

constexpr uint8_t kNone = 255;
constexpr uint8_t kModes = 8;

// Mode numbers in the order of FlightMode, kOtherReturn last: ArduPilot's custom modes by Vehicle (from its sources:
// the Mode::Number of each vehicle's mode.h), PX4's main modes and sub modes (bits 16 to 23 and 24 to 31 of its custom
// mode).
const uint8_t kArduPilot[][kModes] PROGMEM = {
    {kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone},  // Unknown
    {10, 15, 11, 12, kNone, kNone, 0, 21},                     // Plane
    {10, 15, 11, 12, 20, kNone, 0, 21},                        // QuadPlane: QLAND, QRTL
    {3, 4, 6, 5, 9, 17, 0, 21},                                // Copter: SMART_RTL
    {10, 15, 11, 4, kNone, kNone, 0, 12},                      // Rover: SMART_RTL
    {3, 4, kNone, 16, kNone, kNone, 19, kNone},                // Submarine: POSHOLD
    {kNone, kNone, 4, 3, 0, kNone, 1, kNone},                  // Blimp
};
const uint16_t kPx4[kModes] PROGMEM = {0x0404, 0x0006, 0x0504, 0x0304, 0x0604, kNoMode, 0x0001, kNoMode};

}  // namespace

uint16_t modeNumber(FlightMode mode, Firmware firmware, uint8_t vehicleType) {
  const uint8_t index = static_cast<uint8_t>(mode);
  if (has(firmware, kModesHaveSubModes)) return fromFlash(&kPx4[index]);
  if (!has(firmware, kModesByVehicle)) return kNoMode;
  const uint8_t number = fromFlash(&kArduPilot[static_cast<uint8_t>(vehicleOf(vehicleType))][index]);
  return number == kNone ? kNoMode : number;
}

bool isInMode(FlightMode mode, Firmware firmware, uint8_t vehicleType, uint32_t customMode) {
  const uint16_t number = modeNumber(mode, firmware, vehicleType);
  return number != kNoMode && modeNumberOf(customMode) == number;
}

}  // namespace mavmission
