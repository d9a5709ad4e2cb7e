#include "WaypointListener.h"

#include "../base/FloatBits.h"
#include "TelemetryKeys.h"

namespace mavmission {
using namespace detail;
namespace {

MAVMISSION_TELEMETRY_KEYS(NAV_CONTROLLER_OUTPUT);

}  // namespace

WaypointListener::WaypointListener(MissionClient& client, uint16_t intervalMs)
    : TelemetryListener(client, kListened, intervalMs, decode) {}

bool WaypointListener::decode(TelemetryListener& listener, const FrameParser& frame) {
  mavlink_nav_controller_output_t message;
  frame.copyPayload(&message, sizeof(message));
  Values& values = static_cast<WaypointListener&>(listener).values_;
  memcpy(&values.crossTrack, &message.xtrack_error, sizeof(values.crossTrack));
  values.bearing = message.target_bearing;
  if (values.bearing < 0) values.bearing += 360;  // the message leaves open where it begins
  values.distance = message.wp_dist;
  return true;
}

int32_t WaypointListener::crossTrackCm() const { return timesWhole(values_.crossTrack, 100); }

}  // namespace mavmission
