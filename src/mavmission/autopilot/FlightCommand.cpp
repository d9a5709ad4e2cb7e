#include "FlightCommand.h"

#include "../base/Flash.h"
#include "../base/MavlinkHeaders.h"

namespace mavmission {
using namespace detail;
namespace {

const uint16_t kOnceOnly[] PROGMEM = {
    MAV_CMD_DO_SET_RELAY,
    MAV_CMD_DO_REPEAT_RELAY,
    MAV_CMD_DO_SET_SERVO,
    MAV_CMD_DO_REPEAT_SERVO,
    MAV_CMD_DO_FLIGHTTERMINATION,
    MAV_CMD_DO_SET_ACTUATOR,
    MAV_CMD_DO_DIGICAM_CONTROL,
    MAV_CMD_DO_PARACHUTE,
    MAV_CMD_DO_MOTOR_TEST,
    MAV_CMD_DO_GRIPPER,
    MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN,
    MAV_CMD_IMAGE_START_CAPTURE,
    MAV_CMD_PAYLOAD_PREPARE_DEPLOY,
    MAV_CMD_DO_WINCH,
};

}  // namespace

bool isOnceOnly(uint16_t id) {
  for (const uint16_t& once : kOnceOnly) {
    if (fromFlash(&once) == id) return true;
  }
  return false;
}

}  // namespace mavmission
