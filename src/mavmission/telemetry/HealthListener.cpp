#include "HealthListener.h"

#include "../client/Port.h"
#include "FitReasons.h"
#include "TelemetryKeys.h"

namespace mavmission {
using namespace detail;
namespace {

MAVMISSION_TELEMETRY_KEYS(SYS_STATUS);

constexpr uint32_t kNeeded = MAV_SYS_STATUS_SENSOR_3D_GYRO | MAV_SYS_STATUS_SENSOR_3D_ACCEL |
                             MAV_SYS_STATUS_SENSOR_3D_MAG | MAV_SYS_STATUS_SENSOR_ABSOLUTE_PRESSURE |
                             MAV_SYS_STATUS_SENSOR_GPS | MAV_SYS_STATUS_SENSOR_MOTOR_OUTPUTS | MAV_SYS_STATUS_AHRS |
                             MAV_SYS_STATUS_SENSOR_BATTERY | MAV_SYS_STATUS_SENSOR_PROPULSION;

}  // namespace

HealthListener::HealthListener(MissionClient& client, uint16_t intervalMs)
    : TelemetryListener(client, kListened, intervalMs, decode) {}

bool HealthListener::decode(TelemetryListener& listener, const FrameParser& frame) {
  typedef mavlink_sys_status_t Message;
  HealthListener& self = static_cast<HealthListener&>(listener);
  const uint32_t healthy = frame.payloadLong(offsetof(Message, onboard_control_sensors_health));
  self.failed_ = frame.payloadLong(offsetof(Message, onboard_control_sensors_enabled)) & ~healthy &
                 ~uint32_t{MAV_SYS_STATUS_PREARM_CHECK};
  self.loadPermille_ = frame.payloadWord(offsetof(Message, load));
  self.haveChecksPassed_ = (healthy & MAV_SYS_STATUS_PREARM_CHECK) != 0;
  return true;
}

// A heartbeat may have shown the arming since the message came.
FitReason HealthListener::reason() const {
  FitReason reason = FitReason::AllWell;
  if (client_.autopilot().isArmed()) {
    if ((failed_ & kNeeded) != 0) reason = FitReason::SensorFailed;
  } else if (!haveChecksPassed_) {
    const bool hasChecks = has(client_.autopilot().firmware(), kTellsArmingChecks);
    reason = hasChecks ? FitReason::NotReady : FitReason::NotTold;
  }
  return reasonAt(ageMs(), reason);
}

}  // namespace mavmission
