// Numbers of metres and of places, as Steering looks at them.
#pragma once

#include <stdint.h>
#include <string.h>

#include "../base/FloatBits.h"

namespace mavmission {
namespace detail {

// A number of metres in centimetres; 0 if it does not fit.
inline int32_t centimetres(float metres) {
  int32_t bits;
  memcpy(&bits, &metres, sizeof(bits));
  return timesWhole(bits, 100);
}

inline bool isNear(int32_t a, int32_t b, int32_t within) {
  // In 32 bits without a sign, which do not overflow: places may be 360 degrees apart.
  const uint32_t most = static_cast<uint32_t>(within);
  return static_cast<uint32_t>(a) - static_cast<uint32_t>(b) + most <= 2 * most;
}

// The same for longitudes [1e-7 deg]: 180 degrees west is 180 degrees east.
inline bool isNearInLongitude(int32_t a, int32_t b, int32_t within) {
  constexpr uint32_t kTurn = 3600000000u;
  const uint32_t most = static_cast<uint32_t>(within);
  const uint32_t apart = static_cast<uint32_t>(a) - static_cast<uint32_t>(b) + most;
  return apart <= 2 * most || apart - kTurn <= 2 * most || apart + kTurn <= 2 * most;
}

// PX4's mode while it takes off, in the numbers of modeNumber(); it goes over to HOLD by itself.
constexpr uint16_t kPx4TakeOff = 4 | 2 << 8;

// QLAND of ArduPilot's planes.
constexpr uint16_t kQLand = 20;

// So near to its height PX4 ends a takeoff: 0.8 m as it comes (NAV_MC_ALT_RAD), and what it climbs from one position to
// the next [cm].
constexpr uint8_t kTopCm = 200;

}  // namespace detail
}  // namespace mavmission
