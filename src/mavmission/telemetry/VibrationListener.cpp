#include "VibrationListener.h"

#include "../base/FloatBits.h"
#include "../client/Port.h"
#include "FitReasons.h"
#include "TelemetryKeys.h"

namespace mavmission {
using namespace detail;
namespace {

MAVMISSION_TELEMETRY_KEYS(VIBRATION);

constexpr uint32_t kArduPilotLimit = 0x41F00000;  // 30 m/s^2, as the bits of a float
constexpr uint32_t kLimit = 0x409CCCCD;           // 4.9 m/s^2
constexpr uint32_t kBeyond = 0x4BA3D70B;          // 21474838 m/s^2: more than INT32_MAX in cm/s^2

}  // namespace

VibrationListener::VibrationListener(MissionClient& client, uint16_t intervalMs)
    : TelemetryListener(client, kListened, intervalMs, decode) {}

bool VibrationListener::decode(TelemetryListener& listener, const FrameParser& frame) {
  typedef mavlink_vibration_t Message;
  VibrationListener& self = static_cast<VibrationListener&>(listener);
  // PX4's x and y are of its gyroscope.
  const bool hasAxes = has(self.client_.autopilot().firmware(), kStreamsAsArduPilot);
  self.worst_ = hasAxes ? greatestBits(frame, offsetof(Message, vibration_x), 3)
                        : greatestBits(frame, offsetof(Message, vibration_z), 1);
  const uint32_t clipping = frame.payloadLong(offsetof(Message, clipping_0)) +
                            frame.payloadLong(offsetof(Message, clipping_1)) +
                            frame.payloadLong(offsetof(Message, clipping_2));
  const bool hasClipped = self.isHeard() && clipping > self.clipping_;
  self.clipping_ = clipping;
  self.reason_ = hasClipped                                            ? FitReason::Clipping
                 : self.worst_ >= (hasAxes ? kArduPilotLimit : kLimit) ? FitReason::Vibration
                                                                       : FitReason::AllWell;
  return true;
}

FitReason VibrationListener::reason() const { return reasonAt(ageMs(), reason_); }

int32_t VibrationListener::worstCmS2() const {
  return worst_ >= kBeyond ? INT32_MAX : timesWhole(static_cast<int32_t>(worst_), 100);
}

}  // namespace mavmission
