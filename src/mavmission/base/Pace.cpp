#include "Pace.h"

namespace mavmission {
namespace detail {

uint16_t Pace::againMs() const {
  const bool lossy = isLossy();
  const uint16_t waitMs = lossy ? 2 * roundTripMs_ : 4 * roundTripMs_;
  const uint16_t leastMs = lossy ? 5 * busyMs_ : kPatienceMs;
  return waitMs > leastMs ? waitMs : leastMs;
}

}  // namespace detail
}  // namespace mavmission
