#include "PositionListener.h"

#include "../base/FloatBits.h"
#include "../base/Root.h"
#include "../client/Port.h"
#include "TelemetryKeys.h"

namespace mavmission {
using namespace detail;
namespace {

MAVMISSION_TELEMETRY_KEYS(GLOBAL_POSITION_INT);

}  // namespace

PositionListener::PositionListener(MissionClient& client, uint16_t intervalMs)
    : TelemetryListener(client, kListened, intervalMs, decode) {}

bool PositionListener::decode(TelemetryListener& listener, const FrameParser& frame) {
  PositionListener& self = static_cast<PositionListener&>(listener);
  mavlink_global_position_int_t message;
  frame.copyPayload(&message, sizeof(message));
  self.place_ = LatLon{Degrees::fromE7(message.lat), Degrees::fromE7(message.lon)};
  self.aboveSeaLevelMm_ = message.alt;
  // No home: PX4 then gives both heights alike, and ArduPilot, which does not know where it is, gives zeros.
  const bool mayBeNone = has(self.client_.autopilot().firmware(), kSameHeightsWithoutHome) || !self.hasPlace();
  self.aboveHomeMm_ = mayBeNone && message.relative_alt == message.alt ? kNoHeight : message.relative_alt;
  self.northCmS_ = message.vx;
  self.eastCmS_ = message.vy;
  self.downCmS_ = message.vz;
  self.headingCdeg_ = message.hdg;
  return true;
}

int32_t PositionListener::homeAboveSeaLevelMm() const {
  if (aboveHomeMm() == kNoHeight) return kNoHeight;
  // In 32 bits without a sign, which do not overflow. A difference that does not fit is no height of a home.
  const int32_t home =
      static_cast<int32_t>(static_cast<uint32_t>(aboveSeaLevelMm_) - static_cast<uint32_t>(aboveHomeMm_));
  return (home < aboveSeaLevelMm_) == (aboveHomeMm_ > 0) ? home : kNoHeight;
}

Altitude PositionListener::altitude() const { return aboveHome(Metres(quotient(aboveHomeMm_, 1000))); }

uint16_t PositionListener::speedCmS() const {
  return rootOf(static_cast<uint32_t>(int32_t{northCmS_} * northCmS_) +
                static_cast<uint32_t>(int32_t{eastCmS_} * eastCmS_));
}

Degrees PositionListener::heading() const {
  if (!hasHeading()) return Degrees();
  const int32_t cdeg = headingCdeg_ > 18000 ? int32_t{headingCdeg_} - 36000 : headingCdeg_;
  return Degrees::fromE7(cdeg * 100000);
}

}  // namespace mavmission
