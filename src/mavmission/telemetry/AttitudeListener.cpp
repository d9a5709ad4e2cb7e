#include "AttitudeListener.h"

#include "../base/FloatBits.h"
#include "TelemetryKeys.h"

namespace mavmission {
using namespace detail;
namespace {

MAVMISSION_TELEMETRY_KEYS(ATTITUDE);

}  // namespace

AttitudeListener::AttitudeListener(MissionClient& client, uint16_t intervalMs)
    : TelemetryListener(client, kListened, intervalMs, decode) {}

// A message with a NaN tells nothing: it is as if it had not come.
bool AttitudeListener::decode(TelemetryListener& listener, const FrameParser& frame) {
  mavlink_attitude_t message;
  frame.copyPayload(&message, sizeof(message));
  static_assert(offsetof(mavlink_attitude_t, pitch) == offsetof(mavlink_attitude_t, roll) + 4 &&
                    offsetof(mavlink_attitude_t, yaw) == offsetof(mavlink_attitude_t, roll) + 8,
                "the three angles must lie one after the other");
  const uint8_t* const angles = reinterpret_cast<const uint8_t*>(&message) + offsetof(mavlink_attitude_t, roll);
  for (uint8_t i = 0; i < 12; i += 4) {
    if (kindOf(angles + i) != FloatKind::Finite) return false;
  }
  memcpy(static_cast<AttitudeListener&>(listener).radians_, angles, 12);
  return true;
}

Degrees AttitudeListener::angle(uint8_t index) const {
  uint32_t degrees = radians_[index];
  multiply(&degrees, Times::Degree);
  return Degrees::fromE7(timesWhole(static_cast<int32_t>(degrees), 10000000));
}

}  // namespace mavmission
