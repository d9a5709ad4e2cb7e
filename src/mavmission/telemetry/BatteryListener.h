// One battery of the aircraft (BATTERY_STATUS).
#pragma once

#include "TelemetryListener.h"

namespace mavmission {

// Used like a PositionListener. The values of other batteries are ignored.
class BatteryListener : public TelemetryListener {
 public:
  // Must live as long as the client. `intervalMs`: from one message to the next; 0: the message is not requested.
  // `number`: which battery, counted from 0.
  explicit BatteryListener(MissionClient& client, uint16_t intervalMs = 1000, uint8_t number = 0);

  // The sum of all cells that the autopilot reports [mV]. 0: not known.
  bool hasVoltage() const { return voltageMv_ != 0; }
  uint32_t voltageMv() const { return voltageMv_; }
  // An autopilot does not measure all of these: each value is valid only if its has...() is true.
  bool hasCurrent() const { return currentCa_ >= 0; }
  int16_t currentCa() const { return currentCa_; }  // [10 mA]
  bool hasConsumed() const { return consumedMah_ >= 0; }
  int32_t consumedMah() const { return consumedMah_; }  // since it was switched on [mAh]
  bool hasRemaining() const { return remainingPercent_ >= 0; }
  int8_t remainingPercent() const { return remainingPercent_; }  // 0 to 100 [%]
  bool hasTemperature() const { return temperatureCdeg_ != INT16_MAX; }
  int16_t temperatureCdeg() const { return temperatureCdeg_; }  // [1/100 degree Celsius]

 private:
  static bool decode(TelemetryListener& listener, const detail::FrameParser& frame);

  uint32_t voltageMv_ = 0;
  int32_t consumedMah_ = -1;
  int16_t currentCa_ = -1;
  int16_t temperatureCdeg_ = INT16_MAX;
  int8_t remainingPercent_ = -1;
  uint8_t const number_;
};

}  // namespace mavmission
