// Whether the autopilot knows where it is (its EKF): EKF_STATUS_REPORT of ArduPilot, ESTIMATOR_STATUS of PX4.
#pragma once

#include "EitherListener.h"
#include "Fitness.h"

namespace mavmission {

// Used like a PositionListener.
class EstimatorListener : public detail::EitherListener {
 public:
  // Must live as long as the client. `intervalMs`: from one message to the next, at most 5000; 0: the message is not
  // requested.
  explicit EstimatorListener(MissionClient& client, uint16_t intervalMs = 1000);

  // AllWell: attitude, velocity, place and height are known, and no sensor disagrees with them. NoAttitude, NoPosition:
  // not known yet; indoors this stays so. GpsGlitch: the autopilot says so. Disagreement: worstPercent() is at 100 or
  // above, or on PX4 the accelerometer is said to be wrong. NotHeard: no message for 10 s.
  FitReason reason() const;
  Fitness fitness() const { return fitnessOf(reason()); }

  // How far the sensor that disagrees most (velocity, place, height, compass) is from what the estimator expects [% of
  // the limit]. The limit is 0.8 on ArduPilot, the default of FS_EKF_THRESH, and 1.0 on PX4, which then rejects the
  // sensor.
  uint16_t worstPercent() const;
  // The flags as in the message: EKF_STATUS_FLAGS on ArduPilot, ESTIMATOR_STATUS_FLAGS on PX4.
  uint16_t flags() const { return flags_; }

 private:
  static bool decode(TelemetryListener& listener, const detail::FrameParser& frame);

  uint32_t worst_ = 0;  // a float, as bits
  uint16_t flags_ = 0;
  bool isArduPilots_ = false;
  FitReason reason_ = FitReason::NotHeard;
};

}  // namespace mavmission
