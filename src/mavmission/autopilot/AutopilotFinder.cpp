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

// It is another one from now on, or has restarted.
void AutopilotFinder::change() {
  isVehicleKnown_ = isPlane_ = isDoubted_ = false;
  isOther_ = true;
  knowledge_ = static_cast<uint8_t>(knowledge_ + 0x10);
}

void AutopilotFinder::setTargetIds(uint8_t systemId, uint8_t componentId) {
  const bool isKept = (heard_ || settled_) && systemId == heartbeat_.systemId && componentId == heartbeat_.componentId;
  named_ = systemId != 0;
  severalHeard_ = false;
  if (isKept && named_) return;
  heard_ = settled_ = false;
  change();
  heartbeat_ = Heartbeat();
  heartbeat_.systemId = systemId;
  heartbeat_.componentId = componentId;
}

bool AutopilotFinder::onHeartbeat(uint8_t systemId, uint8_t componentId, uint8_t autopilot, uint8_t vehicleType,
                                  uint16_t nowMs) {
  if (autopilot == MAV_AUTOPILOT_INVALID || !isVehicle(vehicleType)) return false;
  if (autopilot == MAV_AUTOPILOT_GENERIC && !isGenericKnown() && !named_) return false;
  if (systemId != heartbeat_.systemId || componentId != heartbeat_.componentId) {
    if (named_) return false;
    if (settled_) return false;
    if (heard_) {
      severalHeard_ = true;
      searchMs_ = nowMs;
      return false;
    }
  }
  if (!heard_ && !settled_) {
    searchMs_ = nowMs;
  } else {
    const bool isOther = autopilot != heartbeat_.autopilot || vehicleType != heartbeat_.vehicleType;
    if (isOther && settled_ && !isDoubted_) {
      // Of damaged heartbeats one in 65,536 has a right checksum.
      isDoubted_ = true;
      return false;
    }
    if (isOther) change();
    if (!heard_ && since(searchMs_, nowMs) >= kForgetMs) forget();
  }
  isDoubted_ = false;
  heard_ = true;
  heardMs_ = nowMs;
  return true;
}

// It boots: it has restarted since. (MAV_STATE_UNINIT is what PX4 says while it would not be armed in its mode.)
void AutopilotFinder::noteState(uint8_t before) {
  if (heartbeat_.state == MAV_STATE_BOOT && before > MAV_STATE_BOOT) change();
}

void AutopilotFinder::onTime(uint16_t nowMs) {
  if (heard_ && quietMs(nowMs) >= kLostMs) {
    heard_ = false;
    searchMs_ = nowMs;
  }
  const uint16_t searched = since(searchMs_, nowMs);
  if (!heard_ && searched >= kForgetMs) searchMs_ = static_cast<uint16_t>(nowMs - kForgetMs);  // it does not wrap
  if (severalHeard_ && searched >= kLostMs) severalHeard_ = false;
  if (heard_ && !severalHeard_ && searched >= kSettleMs) settled_ = true;
}

Firmware AutopilotFinder::firmware() const { return heard_ ? firmwareOf(heartbeat_.autopilot) : Firmware::Unknown; }

bool AutopilotFinder::isArmed() const { return (heartbeat_.baseMode & MAV_MODE_FLAG_SAFETY_ARMED) != 0; }

}  // namespace detail
}  // namespace mavmission
