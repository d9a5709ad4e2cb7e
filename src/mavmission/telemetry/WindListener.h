// The wind, as the autopilot estimates it: WIND of ArduPilot, WIND_COV of PX4.
#pragma once

#include "EitherListener.h"

namespace mavmission {

// Used like a PositionListener. A plane estimates the wind, a copter only if it is set up for it; without an estimate
// ArduPilot sends a wind of 0, and PX4 does not send the message. A speed that is no number, or does not fit, is 0; so
// is one beyond 300 m/s, but for downCmS().
class WindListener : public detail::EitherListener {
 public:
  // Must live as long as the client. `intervalMs`: from one message to the next; 0: the message is not requested.
  explicit WindListener(MissionClient& client, uint16_t intervalMs = 1000);

  // The speed [cm/s]: on PX4 the horizontal one; on ArduPilot, by its source, that of the whole wind, what blows up or
  // down included.
  uint16_t speedCmS() const;
  // Where the wind comes from, from north, clockwise [whole degrees], 0 to 359. PX4 gives it as components: from these
  // it is computed to within a degree.
  uint16_t fromDeg() const;
  // The speed downwards [cm/s]; negative: upwards.
  int32_t downCmS() const;

 private:
  static bool decode(TelemetryListener& listener, const detail::FrameParser& frame);

  // Of WIND: direction and speed; of WIND_COV: the speeds to the north and to the east; then the speed downwards. As in
  // the messages: floats as bits.
  struct Values {
    int32_t first, second, down;
  };
  Values values_ = {0, 0, 0};
  bool hasDirection_ = false;
};

}  // namespace mavmission
