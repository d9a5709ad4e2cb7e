#include "WindListener.h"

#include "../base/FloatBits.h"
#include "../base/Root.h"
#include "TelemetryKeys.h"

namespace mavmission {
using namespace detail;
namespace {

// WIND is of ArduPilot's dialect (ardupilotmega.xml): direction from which it comes [degrees], speed, speed downwards.
constexpr uint16_t kWind = 168;
constexpr uint8_t kWindCrcExtra = 1, kWindLength = 12;

const MessageKey kListened[4] PROGMEM = {MAVMISSION_LISTENER_KEY(HEARTBEAT),
                                         MAVMISSION_LISTENER_KEY(COMMAND_ACK),
                                         {kWind, kWindCrcExtra, kWindLength, kWindLength, MessageKey::kNoTarget},
                                         MAVMISSION_LISTENER_KEY(WIND_COV)};

constexpr int32_t kFastestCmS = 30000;  // of a component; more is none

int16_t componentCmS(int32_t bits) {
  const int32_t speed = timesWhole(bits, 100);
  return speed > kFastestCmS || speed < -kFastestCmS ? 0 : static_cast<int16_t>(speed);
}

// The angle whose tangent is part / whole, 0 to 45 degrees, to within a quarter of one.
uint8_t angleOf(uint16_t part, uint16_t whole) {
  if (whole == 0) return 0;
  const uint32_t tangent = (uint32_t{part} << 8) / whole;  // 256: 45 degrees
  // 45 t + 15.64 t (1 - t), rounded
  return static_cast<uint8_t>((tangent * (uint32_t{45} * 256 + 4004 * (256 - tangent) / 256) + 32768) >> 16);
}

}  // namespace

WindListener::WindListener(MissionClient& client, uint16_t intervalMs)
    : EitherListener(client, kListened, intervalMs, decode) {}

bool WindListener::decode(TelemetryListener& listener, const FrameParser& frame) {
  typedef mavlink_wind_cov_t Covariance;
  static_assert(offsetof(Covariance, wind_y) == offsetof(Covariance, wind_x) + sizeof(float) &&
                    offsetof(Covariance, wind_z) == offsetof(Covariance, wind_y) + sizeof(float),
                "the components lie one after the other");
  WindListener& self = static_cast<WindListener&>(listener);
  self.hasDirection_ = frame.messageId() == kWind;
  const uint8_t first = self.hasDirection_ ? 0 : offsetof(Covariance, wind_x);
  self.values_.first = static_cast<int32_t>(frame.payloadLong(first));
  self.values_.second = static_cast<int32_t>(frame.payloadLong(first + sizeof(float)));
  self.values_.down = static_cast<int32_t>(frame.payloadLong(first + 2 * sizeof(float)));
  return true;
}

uint16_t WindListener::speedCmS() const {
  const int32_t second = componentCmS(values_.second);
  if (hasDirection_) return static_cast<uint16_t>(second < 0 ? 0 : second);
  const int32_t first = componentCmS(values_.first);
  return rootOf(static_cast<uint32_t>(first * first) + static_cast<uint32_t>(second * second));
}

uint16_t WindListener::fromDeg() const {
  if (hasDirection_) {
    int32_t degrees = timesWhole(values_.first, 1) % 360;
    if (degrees < 0) degrees += 360;
    return static_cast<uint16_t>(degrees);
  }
  const int16_t toNorth = componentCmS(values_.first), toEast = componentCmS(values_.second);
  const uint16_t north = static_cast<uint16_t>(toNorth < 0 ? -toNorth : toNorth);
  const uint16_t east = static_cast<uint16_t>(toEast < 0 ? -toEast : toEast);
  const uint16_t off = east <= north ? angleOf(east, north) : 90 - angleOf(north, east);  // from the north-south line
  uint16_t degrees = toNorth > 0 ? 180 : 0;  // a wind to the north comes from the south
  // East of it (a wind to the west comes from the east) clockwise from north, and counterclockwise from south.
  const bool isClockwise = (toEast < 0) == (degrees == 0);
  degrees += isClockwise ? off : 360 - off;
  return degrees >= 360 ? degrees - 360 : degrees;
}

int32_t WindListener::downCmS() const { return timesWhole(values_.down, 100); }

}  // namespace mavmission
