#include "HomeListener.h"

#include "TelemetryKeys.h"

namespace mavmission {
using namespace detail;
namespace {

MAVMISSION_TELEMETRY_KEYS(HOME_POSITION);
static_assert(MAVLINK_MSG_ID_HOME_POSITION_LEN == 60, "HomeListener says how many bytes must be kept");

}  // namespace

HomeListener::HomeListener(MissionClient& client, uint16_t intervalMs, Kept)
    : TelemetryListener(client, kListened, intervalMs, decode) {}

bool HomeListener::decode(TelemetryListener& listener, const FrameParser& frame) {
  HomeListener& self = static_cast<HomeListener&>(listener);
  typedef mavlink_home_position_t Home;
  self.place_ = LatLon{Degrees::fromE7(static_cast<int32_t>(frame.payloadLong(offsetof(Home, latitude)))),
                       Degrees::fromE7(static_cast<int32_t>(frame.payloadLong(offsetof(Home, longitude))))};
  self.aboveSeaLevelMm_ = static_cast<int32_t>(frame.payloadLong(offsetof(Home, altitude)));
  return true;
}

}  // namespace mavmission
