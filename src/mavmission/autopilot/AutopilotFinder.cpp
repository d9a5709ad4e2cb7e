#include "AutopilotFinder.h"

#include "../base/Clock.h"
#include "../base/Flash.h"
#include "../base/MavlinkHeaders.h"

namespace mavmission {
namespace detail {
namespace {

// The vehicle types (MAV_TYPE) of components that send heartbeats but are no vehicles; some of them name an autopilot
// in their heartbeats. A type that is not in this list is taken for a vehicle, since newer types may fly.
// clang-format off
const uint8_t kNoVehicles[] PROGMEM = {
    MAV_TYPE_ANTENNA_TRACKER, MAV_TYPE_GCS,     MAV_TYPE_ONBOARD_CONTROLLER, MAV_TYPE_GIMBAL,    MAV_TYPE_ADSB,
    MAV_TYPE_CAMERA,          MAV_TYPE_CHARGING_STATION, MAV_TYPE_FLARM,     MAV_TYPE_SERVO,     MAV_TYPE_ODID,
    MAV_TYPE_BATTERY,         MAV_TYPE_PARACHUTE, MAV_TYPE_LOG,              MAV_TYPE_OSD,       MAV_TYPE_IMU,
    MAV_TYPE_GPS,             MAV_TYPE_WINCH,   MAV_TYPE_ILLUMINATOR,        MAV_TYPE_GRIPPER,   MAV_TYPE_RADIO,
};
// clang-format on

bool isVehicle(uint8_t type) {
  for (const uint8_t& other : kNoVehicles) {
    if (fromFlash(&other) == type) return false;
  }
  return true;
}

}  // namespace

void AutopilotFinder::setTargetIds(uint8_t systemId, uint8_t componentId) {
  const bool isOther = !isFrom(systemId, componentId);
  named_ = systemId != 0;
  severalHeard_ = false;
  if (!isOther && named_) return;
  heard_ = false;
  settled_ = false;
  isVehicleKnown_ = false;
  isPlane_ = false;
  heartbeat_ = Heartbeat();
  heartbeat_.systemId = systemId;
  heartbeat_.componentId = componentId;
}

bool AutopilotFinder::onHeartbeat(uint8_t systemId, uint8_t componentId, uint8_t autopilot, uint8_t vehicleType,
                                  uint16_t nowMs) {
  if (autopilot == MAV_AUTOPILOT_INVALID || !isVehicle(vehicleType)) return false;
  if (systemId != heartbeat_.systemId || componentId != heartbeat_.componentId) {
    if (named_) return false;
    if (heard_) {
      severalHeard_ = true;
      otherMs_ = nowMs;
      return false;
    }
  }
  if (!heard_) firstMs_ = nowMs;
  heard_ = true;
  heardMs_ = nowMs;
  return true;
}

void AutopilotFinder::onTime(uint16_t nowMs) {
  if (heard_) {
    if (since(firstMs_, nowMs) >= kSettleMs) settled_ = true;
    if (since(heardMs_, nowMs) >= kLostMs) {
      heard_ = false;
      settled_ = false;
      isVehicleKnown_ = false;
      isPlane_ = false;
    }
  }
  if (severalHeard_ && since(otherMs_, nowMs) >= kLostMs) severalHeard_ = false;
}

Firmware AutopilotFinder::firmware() const { return heard_ ? firmwareOf(heartbeat_.autopilot) : Firmware::Unknown; }

bool AutopilotFinder::isArmed() const { return (heartbeat_.baseMode & MAV_MODE_FLAG_SAFETY_ARMED) != 0; }

}  // namespace detail
}  // namespace mavmission
