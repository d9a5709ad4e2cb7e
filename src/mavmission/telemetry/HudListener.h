// What a pilot's display shows (VFR_HUD): airspeed, speed over the ground, climb, throttle, heading.
#pragma once

#include "TelemetryListener.h"

namespace mavmission {

// Used like a PositionListener. A speed that is no number, or does not fit, is 0.
class HudListener : public TelemetryListener {
 public:
  // Must live as long as the client. `intervalMs`: from one message to the next; 0: the message is not requested.
  explicit HudListener(MissionClient& client, uint16_t intervalMs = 1000);

  // The airspeed [cm/s]. Without a sensor ArduPilot sends an estimate; PX4 sends none, and then hasAirspeed() is false
  // and the airspeed 0.
  bool hasAirspeed() const;
  int32_t airspeedCmS() const { return hundredths(values_.airspeed); }
  // The speed over the ground [cm/s].
  int32_t groundSpeedCmS() const { return hundredths(values_.groundSpeed); }
  // How fast the aircraft climbs [cm/s]; negative: it sinks.
  int32_t climbCmS() const { return hundredths(values_.climb); }
  // The throttle [%], 0 to 100.
  uint16_t throttlePercent() const { return values_.throttle; }
  // Where the nose points, from north, clockwise [whole degrees], 0 to 360.
  int16_t headingDeg() const { return values_.heading; }

 private:
  static bool decode(TelemetryListener& listener, const detail::FrameParser& frame);
  static int32_t hundredths(int32_t metresPerSecond);

  // As in the message: floats as bits, changed into centimetres only when the sketch asks for them.
  struct Values {
    int32_t airspeed, groundSpeed, altitude, climb;
    int16_t heading;
    uint16_t throttle;
  };
  Values values_ = {0, 0, 0, 0, 0, 0};
};

}  // namespace mavmission
