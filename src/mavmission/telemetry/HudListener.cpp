#include "HudListener.h"

#include "../base/FloatBits.h"
#include "TelemetryKeys.h"

namespace mavmission {
using namespace detail;
namespace {

MAVMISSION_TELEMETRY_KEYS(VFR_HUD);

}  // namespace

HudListener::HudListener(MissionClient& client, uint16_t intervalMs)
    : TelemetryListener(client, kListened, intervalMs, decode) {}

bool HudListener::decode(TelemetryListener& listener, const FrameParser& frame) {
  static_assert(sizeof(Values) == MAVLINK_MSG_ID_VFR_HUD_LEN &&
                    offsetof(Values, groundSpeed) == offsetof(mavlink_vfr_hud_t, groundspeed) &&
                    offsetof(Values, climb) == offsetof(mavlink_vfr_hud_t, climb) &&
                    offsetof(Values, heading) == offsetof(mavlink_vfr_hud_t, heading),
                "the values lie as in the message");
  frame.copyPayload(&static_cast<HudListener&>(listener).values_, sizeof(Values));
  return true;
}

bool HudListener::hasAirspeed() const { return isHeard() && kindOf(&values_.airspeed) == FloatKind::Finite; }

int32_t HudListener::hundredths(int32_t metresPerSecond) { return timesWhole(metresPerSecond, 100); }

}  // namespace mavmission
