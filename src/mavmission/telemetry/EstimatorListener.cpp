#include "EstimatorListener.h"

#include "../base/FloatBits.h"
#include "FitReasons.h"
#include "TelemetryKeys.h"

namespace mavmission {
using namespace detail;
namespace {

// EKF_STATUS_REPORT is of ArduPilot's dialect (ardupilotmega.xml): five variances, then the flags.
constexpr uint16_t kEkfStatusReport = 193;
constexpr uint8_t kEkfCrcExtra = 71, kEkfLengthV1 = 22, kEkfFlags = 20;

const MessageKey kListened[4] PROGMEM = {
    MAVMISSION_LISTENER_KEY(HEARTBEAT),
    MAVMISSION_LISTENER_KEY(COMMAND_ACK),
    {kEkfStatusReport, kEkfCrcExtra, kEkfLengthV1, kEkfLengthV1 + sizeof(float), MessageKey::kNoTarget},
    MAVMISSION_LISTENER_KEY(ESTIMATOR_STATUS)};

// Of both autopilots.
constexpr uint16_t kKnown = ESTIMATOR_ATTITUDE | ESTIMATOR_VELOCITY_HORIZ | ESTIMATOR_VELOCITY_VERT |
                            ESTIMATOR_POS_HORIZ_ABS | ESTIMATOR_POS_VERT_ABS;
// Of ArduPilot's EKF_STATUS_FLAGS.
constexpr uint16_t kEkfUninitialised = 1024, kEkfGpsGlitching = 32768;

constexpr uint32_t kEkfLimit = 0x3F4CCCCD;  // 0.8, as the bits of a float
constexpr uint32_t kLimit = 0x3F800000;     // 1.0
constexpr uint32_t kBeyond = 0x447A0000;    // 1000.0
constexpr uint8_t kSensors = 4;             // velocity, place, height, compass

FitReason reasonOf(bool isArduPilots, uint16_t flags, uint32_t worst) {
  const uint16_t glitch = isArduPilots ? kEkfGpsGlitching : static_cast<uint16_t>(ESTIMATOR_GPS_GLITCH);
  if ((flags & glitch) != 0) return FitReason::GpsGlitch;
  if (worst >= (isArduPilots ? kEkfLimit : kLimit)) return FitReason::Disagreement;
  if (!isArduPilots && (flags & ESTIMATOR_ACCEL_ERROR) != 0) return FitReason::Disagreement;
  if ((flags & ESTIMATOR_ATTITUDE) == 0 || (isArduPilots && (flags & kEkfUninitialised) != 0))
    return FitReason::NoAttitude;
  return (flags & kKnown) == kKnown ? FitReason::AllWell : FitReason::NoPosition;
}

}  // namespace

EstimatorListener::EstimatorListener(MissionClient& client, uint16_t intervalMs)
    : EitherListener(client, kListened, intervalMs, decode) {}

bool EstimatorListener::decode(TelemetryListener& listener, const FrameParser& frame) {
  typedef mavlink_estimator_status_t Message;
  static_assert(offsetof(Message, mag_ratio) == offsetof(Message, vel_ratio) + (kSensors - 1) * sizeof(float),
                "the ratios lie one after the other");
  EstimatorListener& self = static_cast<EstimatorListener&>(listener);
  const bool isArduPilots = frame.messageId() == kEkfStatusReport;
  self.isArduPilots_ = isArduPilots;
  self.flags_ = frame.payloadWord(isArduPilots ? kEkfFlags : offsetof(Message, flags));
  self.worst_ = greatestBits(frame, isArduPilots ? 0 : offsetof(Message, vel_ratio), kSensors);
  self.reason_ = reasonOf(isArduPilots, self.flags_, self.worst_);
  return true;
}

FitReason EstimatorListener::reason() const { return reasonAt(ageMs(), reason_); }

uint16_t EstimatorListener::worstPercent() const {
  // Beyond 65535 % in either case, and within the 31 bits that the product may have.
  if (worst_ >= kBeyond) return 0xFFFF;
  const int32_t percent = timesWhole(static_cast<int32_t>(worst_), isArduPilots_ ? 125 : 100);
  return percent > 0xFFFF ? 0xFFFF : static_cast<uint16_t>(percent);
}

}  // namespace mavmission
