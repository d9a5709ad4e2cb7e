#include "../FlightMode.h"

#include "../base/Flash.h"
#include "Personality.h"
#include "Vehicle.h"

namespace mavmission {
using namespace detail;
namespace {

constexpr uint8_t kNone = 255;
constexpr uint8_t kModes = 7;

// Mode numbers in the order of FlightMode: ArduPilot's custom modes by Vehicle (from its sources: the Mode::Number of
// each vehicle's mode.h), PX4's main modes and sub modes (bits 16 to 23 and 24 to 31 of its custom mode).
const uint8_t kArduPilot[][kModes] PROGMEM = {
    {kNone, kNone, kNone, kNone, kNone, kNone, kNone},  // Unknown
    {10, 15, 11, 12, kNone, kNone, 0},                  // Plane
    {10, 15, 11, 12, 20, kNone, 0},                     // QuadPlane: QLAND
    {3, 4, 6, 5, 9, 17, 0},                             // Copter
    {10, 15, 11, 4, kNone, kNone, 0},                   // Rover
    {3, 4, kNone, 16, kNone, kNone, 19},                // Submarine: POSHOLD
    {kNone, kNone, 4, 3, 0, kNone, 1},                  // Blimp
};
const uint8_t kPx4Main[kModes] PROGMEM = {4, 6, 4, 4, 4, kNone, 1};
const uint8_t kPx4Sub[kModes] PROGMEM = {4, 0, 5, 3, 6, kNone, 0};

}  // namespace

uint16_t modeNumber(FlightMode mode, Firmware firmware, uint8_t vehicleType) {
  const uint8_t index = static_cast<uint8_t>(mode);
  uint8_t mainMode = kNone, subMode = 0;
  if (has(firmware, kModesHaveSubModes)) {
    mainMode = fromFlash(&kPx4Main[index]);
    subMode = fromFlash(&kPx4Sub[index]);
  } else if (has(firmware, kModesByVehicle)) {
    mainMode = fromFlash(&kArduPilot[static_cast<uint8_t>(vehicleOf(vehicleType))][index]);
  }
  return mainMode == kNone ? kNoMode : static_cast<uint16_t>(mainMode | subMode << 8);
}

bool isInMode(FlightMode mode, Firmware firmware, uint8_t vehicleType, uint32_t customMode) {
  const uint16_t number = modeNumber(mode, firmware, vehicleType);
  return number != kNoMode && modeNumberOf(customMode) == number;
}

}  // namespace mavmission
