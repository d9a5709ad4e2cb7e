// How the aircraft is turned (ATTITUDE).
#pragma once

#include "Degrees.h"
#include "TelemetryListener.h"

namespace mavmission {

// Used like a PositionListener.
class AttitudeListener : public TelemetryListener {
 public:
  // Must live as long as the client. `intervalMs`: from one message to the next; 0: it is not asked for.
  explicit AttitudeListener(MissionClient& client, uint16_t intervalMs = 1000);

  // -180 to 180 degrees each: the right side down, the nose up, and the nose to the east of north are positive.
  Degrees roll() const { return angle(0); }
  Degrees pitch() const { return angle(1); }
  Degrees yaw() const { return angle(2); }

 private:
  static bool decode(TelemetryListener& listener, const detail::FrameParser& frame);
  Degrees angle(uint8_t index) const;

  uint32_t radians_[3] = {0, 0, 0};  // floats as bits, changed into degrees where the sketch asks for them
};

}  // namespace mavmission
