// The first GPS receiver (GPS_RAW_INT): its fix, its satellites, and its position.
#pragma once

#include "../item/LatLon.h"
#include "TelemetryListener.h"

namespace mavmission {

// GPS_FIX_TYPE (MAVLink common messages).
enum class GpsFix : uint8_t {
  NoReceiver = 0,
  NoFix = 1,
  TwoDimensional = 2,
  ThreeDimensional = 3,
  Differential = 4,
  RtkFloat = 5,
  RtkFixed = 6,
  Static = 7,
  Ppp = 8
};

// Used like a PositionListener. For flying use PositionListener: its position is estimated from all sensors.
class GpsListener : public TelemetryListener {
 public:
  // Must live as long as the client. `intervalMs`: from one message to the next; 0: the message is not requested.
  explicit GpsListener(MissionClient& client, uint16_t intervalMs = 1000);

  // The kind of fix.
  GpsFix fix() const { return fix_; }
  // True with a fix in three dimensions, or a better one.
  bool hasFix() const { return fix_ >= GpsFix::ThreeDimensional; }
  // The number of satellites in use.
  bool hasSatellites() const { return satellites_ != 255; }
  uint8_t satellites() const { return satellites_; }  // 255: not known

  // Where the receiver is; only with a fix.
  LatLon place() const { return place_; }
  int32_t aboveSeaLevelMm() const { return aboveSeaLevelMm_; }

  // Dilution of precision, horizontal [1/100]; 65535: not known.
  uint16_t hdopHundredths() const { return hdopHundredths_; }
  // The accuracy of the place [mm]; 0: not known, as over MAVLink 1.
  uint32_t accuracyMm() const { return accuracyMm_; }
  // The speed over the ground [cm/s], and its direction from north, clockwise [1/100 degree]; 65535: not known.
  uint16_t speedCmS() const { return speedCmS_; }
  uint16_t courseCdeg() const { return courseCdeg_; }

 private:
  static bool decode(TelemetryListener& listener, const detail::FrameParser& frame);

  LatLon place_;
  int32_t aboveSeaLevelMm_ = 0;
  uint32_t accuracyMm_ = 0;
  uint16_t hdopHundredths_ = 0xFFFF, speedCmS_ = 0xFFFF, courseCdeg_ = 0xFFFF;
  uint8_t satellites_ = 255;
  GpsFix fix_ = GpsFix::NoReceiver;
};

}  // namespace mavmission
