// The attitude of the aircraft (ATTITUDE): roll, pitch and yaw.
#pragma once

#include "../item/Degrees.h"
#include "TelemetryListener.h"

namespace mavmission {

// Used like a PositionListener.
class AttitudeListener : public TelemetryListener {
 public:
  // Must live as long as the client. `intervalMs`: from one message to the next; 0: the message is not requested.
  explicit AttitudeListener(MissionClient& client, uint16_t intervalMs = 1000);

  // Each is -180 to 180 degrees. Positive: the right side is down, the nose is up, the nose points east of north.
  Degrees roll() const { return angle(0); }
  Degrees pitch() const { return angle(1); }
  Degrees yaw() const { return angle(2); }

 private:
  static bool decode(TelemetryListener& listener, const detail::FrameParser& frame);
  Degrees angle(uint8_t index) const;

  uint32_t radians_[3] = {0, 0, 0};  // floats as bits, changed into degrees where the sketch asks for them
};

}  // namespace mavmission
