#include "../FlightMode.h"

#include "../base/Flash.h"
#include "../link/MavlinkHeaders.h"

namespace mavmission {
using namespace detail;
namespace {

constexpr uint8_t kNone = 255;
constexpr uint8_t kModes = 7;

// In the order of FlightMode. ArduPilot's custom modes by vehicle (ArduPilot's documentation, "Flight modes"), PX4's
// main and sub modes (bits 16 to 23 and 24 to 31 of its custom mode).
const uint8_t kCopter[kModes] PROGMEM = {3, 4, 6, 5, 9, 17, 0};
const uint8_t kRover[kModes] PROGMEM = {10, 15, 11, 4, kNone, kNone, 0};
const uint8_t kPlane[kModes] PROGMEM = {10, 15, 11, 12, kNone, kNone, 0};
const uint8_t kPx4Main[kModes] PROGMEM = {4, 6, 4, 4, 4, kNone, 1};
const uint8_t kPx4Sub[kModes] PROGMEM = {4, 0, 5, 3, 6, kNone, 0};

const uint8_t* arduPilotModes(uint8_t vehicleType) {
  switch (vehicleType) {
    case MAV_TYPE_GROUND_ROVER:
    case MAV_TYPE_SURFACE_BOAT: return kRover;
    case MAV_TYPE_FIXED_WING:
    case MAV_TYPE_VTOL_TAILSITTER_DUOROTOR:
    case MAV_TYPE_VTOL_TAILSITTER_QUADROTOR:
    case MAV_TYPE_VTOL_TILTROTOR:
    case MAV_TYPE_VTOL_FIXEDROTOR:
    case MAV_TYPE_VTOL_TAILSITTER:
    case MAV_TYPE_VTOL_TILTWING: return kPlane;
    default: return kCopter;
  }
}

}  // namespace

uint16_t modeNumber(FlightMode mode, Firmware firmware, uint8_t vehicleType) {
  const uint8_t index = static_cast<uint8_t>(mode);
  uint8_t mainMode = kNone, subMode = 0;
  if (firmware == Firmware::Px4) {
    mainMode = fromFlash(&kPx4Main[index]);
    subMode = fromFlash(&kPx4Sub[index]);
  } else if (firmware == Firmware::ArduPilot) {
    mainMode = fromFlash(&arduPilotModes(vehicleType)[index]);
  }
  return mainMode == kNone ? kNoMode : static_cast<uint16_t>(mainMode | subMode << 8);
}

bool isInMode(FlightMode mode, Firmware firmware, uint8_t vehicleType, uint32_t customMode) {
  const uint16_t number = modeNumber(mode, firmware, vehicleType);
  return number != kNoMode && modeNumberOf(customMode) == number;
}

}  // namespace mavmission
