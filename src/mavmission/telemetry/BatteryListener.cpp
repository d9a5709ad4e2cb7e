#include "BatteryListener.h"

#include "TelemetryKeys.h"

namespace mavmission {
using namespace detail;
namespace {

MAVMISSION_TELEMETRY_KEYS(BATTERY_STATUS);

}  // namespace

BatteryListener::BatteryListener(MissionClient& client, uint16_t intervalMs, uint8_t number)
    : TelemetryListener(client, kListened, intervalMs, decode), number_(number) {}

bool BatteryListener::decode(TelemetryListener& listener, const FrameParser& frame) {
  BatteryListener& self = static_cast<BatteryListener&>(listener);
  mavlink_battery_status_t message;
  frame.copyPayload(&message, sizeof(message));
  if (message.id != self.number_) return false;
  // A cell that is not there is 65535, or 0 among the four cells of the extension. A voltage beyond 65.534 V without
  // cells is spread over several of them.
  uint32_t sum = 0;
  constexpr uint8_t kCells = sizeof(message.voltages) / sizeof(message.voltages[0]);
  constexpr uint8_t kMoreCells = sizeof(message.voltages_ext) / sizeof(message.voltages_ext[0]);
  for (uint8_t i = 0; i < kCells; ++i) {
    if (message.voltages[i] != 0xFFFF) sum += message.voltages[i];
  }
  for (uint8_t i = 0; i < kMoreCells; ++i) {
    if (message.voltages_ext[i] != 0xFFFF) sum += message.voltages_ext[i];
  }
  self.voltageMv_ = sum;
  self.consumedMah_ = message.current_consumed;
  self.currentCa_ = message.current_battery;
  self.temperatureCdeg_ = message.temperature;
  self.remainingPercent_ = message.battery_remaining;
  return true;
}

}  // namespace mavmission
