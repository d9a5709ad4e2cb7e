// Where home is (HOME_POSITION): the place to which the aircraft returns, and from which heights are measured.
#pragma once

#include "../base/Config.h"
#include "../item/LatLon.h"
#include "TelemetryListener.h"

namespace mavmission {

// Used like a PositionListener. HOME_POSITION has 60 bytes, more than the library receives by default: compile it with
// -DMAVMISSION_MAX_PAYLOAD=60, or change that line of Config.h. For the height of home alone,
// PositionListener::homeAboveSeaLevelMm() works without that.
class HomeListener : public TelemetryListener {
 public:
  // Must live as long as the client. `intervalMs`: from one message to the next; 0: the message is not requested.
  template <uint8_t kMaxPayload = MAVMISSION_MAX_PAYLOAD>
  explicit HomeListener(MissionClient& client, uint16_t intervalMs = 5000) : HomeListener(client, intervalMs, Kept()) {
    static_assert(kMaxPayload >= 60, "compile the library with -DMAVMISSION_MAX_PAYLOAD=60 to use HomeListener");
  }

  // Both are valid only when isHeard() is true: an autopilot without a home does not send the message.
  LatLon place() const { return place_; }
  int32_t aboveSeaLevelMm() const { return aboveSeaLevelMm_; }

 private:
  struct Kept {};
  HomeListener(MissionClient& client, uint16_t intervalMs, Kept);
  static bool decode(TelemetryListener& listener, const detail::FrameParser& frame);

  LatLon place_;
  int32_t aboveSeaLevelMm_ = 0;
};

}  // namespace mavmission
