// Where the aircraft is, as it has estimated it (GLOBAL_POSITION_INT).
#pragma once

#include "LatLon.h"
#include "TelemetryListener.h"
#include "Units.h"

namespace mavmission {

// Declare one beside the client; it asks for the message every `intervalMs`, and update() of the client does the rest:
//
//   MissionClient autopilot(Serial1);
//   PositionListener position(autopilot, 500);
//
//   if (position.isNew() && position.hasPlace()) use(position.place());
//
// The values are those of the last message, however old: ageMs() tells.
class PositionListener : public TelemetryListener {
 public:
  // The value of a height that is not known [mm].
  static constexpr int32_t kNoHeight = INT32_MIN;

  // Must live as long as the client. `intervalMs`: from one message to the next; 0: it is not asked for.
  explicit PositionListener(MissionClient& client, uint16_t intervalMs = 1000);

  // False until the autopilot knows where it is: ArduPilot sends 0 N 0 E before.
  bool hasPlace() const { return place_.latitude != Degrees() || place_.longitude != Degrees(); }
  LatLon place() const { return place_; }

  // Heights [mm], or kNoHeight. PX4 without a home sends the height above sea level as that above home, too: it is not
  // known then, nor where home is at 0.000 m above sea level (HomeListener tells).
  bool hasHeights() const { return aboveHomeMm() != kNoHeight; }
  int32_t aboveSeaLevelMm() const { return aboveSeaLevelMm_; }
  int32_t aboveHomeMm() const { return aboveHomeMm_; }
  // The height of home above sea level [mm], or kNoHeight.
  int32_t homeAboveSeaLevelMm() const;
  // The height above home as an altitude for a plan or a command. Only where aboveHomeMm() is known.
  Altitude altitude() const;

  // The speed over the ground, its components to the north, to the east and downwards, and its amount in the plane
  // [cm/s].
  int16_t northCmS() const { return northCmS_; }
  int16_t eastCmS() const { return eastCmS_; }
  int16_t downCmS() const { return downCmS_; }
  uint16_t speedCmS() const;

  // Where the nose points, from north, clockwise, -180 to 180 degrees: it may be given to a plan as a yaw. 0 while it
  // is not known.
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
