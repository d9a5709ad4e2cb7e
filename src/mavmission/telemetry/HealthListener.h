// What the autopilot says of its sensors and of its checks before arming (SYS_STATUS).
#pragma once

#include "Fitness.h"
#include "TelemetryListener.h"

namespace mavmission {

// Used like a PositionListener.
class HealthListener : public TelemetryListener {
 public:
  // Must live as long as the client. `intervalMs`: from one message to the next, at most 5000; 0: the message is not
  // requested.
  explicit HealthListener(MissionClient& client, uint16_t intervalMs = 1000);

  // AllWell: disarmed, and the autopilot's checks before arming have passed (MAV_SYS_STATUS_PREARM_CHECK is healthy);
  // or armed, and no sensor that is in use has failed. NotReady: those checks have not passed; the autopilot says in a
  // text what is wrong (TextListener). SensorFailed: armed, and failedSensors() is not 0. NotTold: disarmed, and an
  // autopilot that does not report those checks. NotHeard: no message for 10 s.
  FitReason reason() const;
  Fitness fitness() const { return fitnessOf(reason()); }

  // The sensors that are in use and not healthy: bits of MAV_SYS_STATUS_SENSOR (MAVLink common messages). Of these
  // SensorFailed counts gyroscope, accelerometer, compass, barometer, GPS, AHRS, battery and motors.
  uint32_t failedSensors() const { return failed_; }
  // The autopilot's processor load [1/10 %].
  uint16_t loadPermille() const { return loadPermille_; }

 private:
  static bool decode(TelemetryListener& listener, const detail::FrameParser& frame);

  uint32_t failed_ = 0;
  uint16_t loadPermille_ = 0;
  bool haveChecksPassed_ = false;
};

}  // namespace mavmission
