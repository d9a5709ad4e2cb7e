#include "GpsListener.h"

#include "TelemetryKeys.h"

namespace mavmission {
using namespace detail;
namespace {

MAVMISSION_TELEMETRY_KEYS(GPS_RAW_INT);

}  // namespace

GpsListener::GpsListener(MissionClient& client, uint16_t intervalMs)
    : TelemetryListener(client, kListened, intervalMs, decode) {}

bool GpsListener::decode(TelemetryListener& listener, const FrameParser& frame) {
  GpsListener& self = static_cast<GpsListener&>(listener);
  mavlink_gps_raw_int_t message;
  frame.copyPayload(&message, sizeof(message));
  self.place_ = LatLon{Degrees::fromE7(message.lat), Degrees::fromE7(message.lon)};
  self.aboveSeaLevelMm_ = message.alt;
  self.accuracyMm_ = message.h_acc;
  self.hdopHundredths_ = message.eph;
  self.speedCmS_ = message.vel;
  self.courseCdeg_ = message.cog;
  self.satellites_ = message.satellites_visible;
  self.fix_ = static_cast<GpsFix>(message.fix_type);
  return true;
}

}  // namespace mavmission
