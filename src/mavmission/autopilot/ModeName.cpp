#include "../base/FlashTable.h"
#include "FlightMode.h"
#include "Personality.h"
#include "VehicleKind.h"

namespace mavmission {
using namespace detail;
namespace {

// The modes of each vehicle of ArduPilot, by their numbers (the Mode::Number of its mode.h); "-": a number without one.
// Each name begins after the zero of the one before.
const char kPlane[] PROGMEM =
    "MANUAL\0CIRCLE\0STABILIZE\0TRAINING\0ACRO\0FBWA\0FBWB\0CRUISE\0AUTOTUNE\0-\0AUTO\0RTL\0LOITER\0TAKEOFF\0"
    "AVOID_ADSB\0GUIDED\0INITIALISING\0QSTABILIZE\0QHOVER\0QLOITER\0QLAND\0QRTL\0QAUTOTUNE\0QACRO\0THERMAL\0"
    "LOITERALTQLAND\0AUTOLAND\0";
const char kCopter[] PROGMEM =
    "STABILIZE\0ACRO\0ALT_HOLD\0AUTO\0GUIDED\0LOITER\0RTL\0CIRCLE\0-\0LAND\0-\0DRIFT\0-\0SPORT\0FLIP\0AUTOTUNE\0"
    "POSHOLD\0BRAKE\0THROW\0AVOID_ADSB\0GUIDED_NOGPS\0SMART_RTL\0FLOWHOLD\0FOLLOW\0ZIGZAG\0SYSTEMID\0AUTOROTATE\0"
    "AUTO_RTL\0TURTLE\0";
const char kRover[] PROGMEM =
    "MANUAL\0ACRO\0-\0STEERING\0HOLD\0LOITER\0FOLLOW\0SIMPLE\0DOCK\0CIRCLE\0AUTO\0RTL\0SMART_RTL\0-\0-\0GUIDED\0"
    "INITIALISING\0";
const char kSubmarine[] PROGMEM =
    "STABILIZE\0ACRO\0ALT_HOLD\0AUTO\0GUIDED\0-\0-\0CIRCLE\0-\0SURFACE\0-\0-\0-\0-\0-\0-\0POSHOLD\0-\0-\0MANUAL\0";
const char kBlimp[] PROGMEM = "LAND\0MANUAL\0VELOCITY\0LOITER\0RTL\0";

// PX4's main modes from 1 on, then, from kPx4Auto on, the sub modes of AUTO from 1 on.
const char kPx4[] PROGMEM =
    "MANUAL\0ALTCTL\0POSCTL\0AUTO\0ACRO\0OFFBOARD\0STABILIZED\0RATTITUDE\0"
    "READY\0TAKEOFF\0HOLD\0MISSION\0RTL\0LAND\0-\0FOLLOW\0PRECLAND\0VTOL_TAKEOFF\0";
constexpr uint8_t kPx4Mains = 8, kPx4AutoMain = 4, kPx4AutoSubs = 10;

const char kUnknown[] PROGMEM = "unknown";

const char* namesOf(Vehicle vehicle) {
  switch (vehicle) {
    case Vehicle::Plane:
    case Vehicle::QuadPlane: return kPlane;
    case Vehicle::Copter: return kCopter;
    case Vehicle::Rover: return kRover;
    case Vehicle::Submarine: return kSubmarine;
    case Vehicle::Blimp: return kBlimp;
    default: return nullptr;
  }
}

// The name's number in kPx4, or 255.
uint8_t indexOfPx4(uint32_t customMode) {
  const uint8_t main = static_cast<uint8_t>(customMode >> 16), sub = static_cast<uint8_t>(customMode >> 24);
  if (main == kPx4AutoMain && sub != 0) return sub <= kPx4AutoSubs ? kPx4Mains + sub - 1 : 255;
  return main != 0 && main <= kPx4Mains ? main - 1 : 255;
}

}  // namespace

FlashText modeName(Firmware firmware, uint8_t vehicleType, uint32_t customMode) {
  const char* names = nullptr;
  uint8_t index = 255;
  if (has(firmware, kModesHaveSubModes)) {
    names = kPx4;
    index = indexOfPx4(customMode);
  } else if (has(firmware, kModesByVehicle)) {
    names = namesOf(vehicleOf(vehicleType));
    if (customMode < index) index = static_cast<uint8_t>(customMode);
  }
  const FlashText name = names == nullptr ? nullptr : textAt(names, index);
  const bool isNone = name == nullptr || fromFlash(reinterpret_cast<const uint8_t*>(name)) == '-';
  return isNone ? reinterpret_cast<FlashText>(kUnknown) : name;
}

}  // namespace mavmission
