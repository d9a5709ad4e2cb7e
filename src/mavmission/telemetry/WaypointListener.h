// Where the target is that the aircraft flies to (NAV_CONTROLLER_OUTPUT): the distance and the bearing to the waypoint.
#pragma once

#include "TelemetryListener.h"

namespace mavmission {

// Used like a PositionListener. ArduPilot sends this message while it flies to a place; PX4 sends it only for some
// vehicles, and not for a copter.
class WaypointListener : public TelemetryListener {
 public:
  // Must live as long as the client. `intervalMs`: from one message to the next; 0: the message is not requested.
  explicit WaypointListener(MissionClient& client, uint16_t intervalMs = 1000);

  // The distance over the ground to the waypoint [m]: 65535 means 65535 m or more, and 0 may mean that there is no
  // waypoint.
  uint16_t distanceM() const { return values_.distance; }
  // The direction to it from north, clockwise [whole degrees], 0 to 360.
  int16_t bearingDeg() const { return values_.bearing; }
  // How far the aircraft is beside its track [cm]; the sign is the autopilot's. 0 also if it is no number, or does not
  // fit.
  int32_t crossTrackCm() const;

 private:
  static bool decode(TelemetryListener& listener, const detail::FrameParser& frame);

  struct Values {
    int32_t crossTrack;  // as in the message: a float [m], as bits
    int16_t bearing;
    uint16_t distance;
  };
  Values values_ = {0, 0, 0};
};

}  // namespace mavmission
