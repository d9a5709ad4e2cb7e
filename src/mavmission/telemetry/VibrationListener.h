// How much the aircraft shakes (VIBRATION).
#pragma once

#include "Fitness.h"
#include "TelemetryListener.h"

namespace mavmission {

// Used like a PositionListener. On the ground it says little: judge it in flight.
class VibrationListener : public TelemetryListener {
 public:
  // Must live as long as the client. `intervalMs`: from one message to the next, at most 5000; 0: the message is not
  // requested.
  explicit VibrationListener(MissionClient& client, uint16_t intervalMs = 1000);

  // AllWell: below the limit. Vibration: at or above the limit, which is 3000 cm/s^2 on ArduPilot (its documentation
  // calls less than that normal) and 490 cm/s^2 on PX4 (from where its Flight Review shows it in orange). Clipping:
  // clipping() has grown since the message before. NotHeard: no message for 10 s.
  FitReason reason() const;
  Fitness fitness() const { return fitnessOf(reason()); }

  // The vibration of the accelerometer [cm/s^2]: on ArduPilot the greatest of the three axes, on PX4 its measure of
  // high frequencies. The two cannot be compared. INT32_MAX: so much or more, also without end.
  int32_t worstCmS2() const;
  // How often an accelerometer has been at the end of its range, since the autopilot's start.
  uint32_t clipping() const { return clipping_; }

 private:
  static bool decode(TelemetryListener& listener, const detail::FrameParser& frame);

  uint32_t worst_ = 0;  // a float [m/s^2], as bits
  uint32_t clipping_ = 0;
  FitReason reason_ = FitReason::NotHeard;
};

}  // namespace mavmission
