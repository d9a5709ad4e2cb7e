// The aircraft's position, as the autopilot estimates it (GLOBAL_POSITION_INT).
#pragma once

#include "../item/LatLon.h"
#include "../item/Units.h"
#include "TelemetryListener.h"

namespace mavmission {

// Declare one next to the client. It requests the message every `intervalMs`, and update() of the client does the rest:
//
//   MissionClient autopilot(Serial1);
//   PositionListener position(autopilot, 500);
//
//   if (position.isNew() && position.hasPlace()) use(position.place());
//
// The values are those of the last message, however old it is: ageMs() says how old.
class PositionListener : public TelemetryListener {
 public:
  // This value of a height means that it is not known [mm].
  static constexpr int32_t kNoHeight = INT32_MIN;

  // Must live as long as the client. `intervalMs`: from one message to the next; 0: the message is not requested.
  explicit PositionListener(MissionClient& client, uint16_t intervalMs = 1000);

  // False until the autopilot knows where it is: ArduPilot sends 0 N 0 E before.
  bool hasPlace() const { return place_.latitude != Degrees() || place_.longitude != Degrees(); }
  LatLon place() const { return place_; }

  // Heights [mm], or kNoHeight. A PX4 without a home sends the height above sea level in both fields: the height above
  // home is then not known. If home is at exactly 0.000 m above sea level, the two are the same, too, and it also
  // counts as not known (HomeListener knows it).
  bool hasHeights() const { return aboveHomeMm() != kNoHeight; }
  int32_t aboveSeaLevelMm() const { return aboveSeaLevelMm_; }
  int32_t aboveHomeMm() const { return aboveHomeMm_; }
  // The height of home above sea level [mm], or kNoHeight, also if it does not fit.
  int32_t homeAboveSeaLevelMm() const;
  // The height above home as an altitude for a plan or a command. Valid only if aboveHomeMm() is known.
  Altitude altitude() const;

  // The velocity: its components to the north, to the east and downwards, and the horizontal speed [cm/s].
  int16_t northCmS() const { return northCmS_; }
  int16_t eastCmS() const { return eastCmS_; }
  int16_t downCmS() const { return downCmS_; }
  uint16_t speedCmS() const;

  // The heading of the nose, from north, clockwise, -180 to 180 degrees: it may be given to a plan as a yaw. It is 0 if
  // it is not known.
  bool hasHeading() const { return headingCdeg_ <= 36000; }
  Degrees heading() const;
  // The same from 0 to 35999, for printing [1/100 degree]; 65535: not known.
  uint16_t headingCdeg() const { return headingCdeg_; }

 private:
  static bool decode(TelemetryListener& listener, const detail::FrameParser& frame);

  LatLon place_;
  int32_t aboveSeaLevelMm_ = kNoHeight;
  int32_t aboveHomeMm_ = kNoHeight;
  int16_t northCmS_ = 0, eastCmS_ = 0, downCmS_ = 0;
  uint16_t headingCdeg_ = 0xFFFF;
};

}  // namespace mavmission
