#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "Readbacks.h"

using namespace mavmission;

namespace {

// Not foretold, because it is not the same everywhere: a negative number for an unsigned one, a number beyond 2^31, a
// heading beyond the turn, where PX4's own loop ends.
bool isUnforeseeable(const Readback& row, unsigned index) {
  const double sent = numberOf(row.sent, index);
  return sent < 0 || std::fabs(sent) >= 2147483648.0 || (row.isPx4() && std::fabs(sent) > 180);
}

}  // namespace

TEST_CASE("what a random value that is not kept became is foretold, to the bit, or not known where it depends") {
  unsigned told = 0, unknown = 0, wrong = 0, line = 0;
  std::string vehicle;
  for (const Readback& row : readbacks()) {
    if (!row.isRead) continue;
    const Field field = notKept(row.sent, row.keeper);
    const unsigned index = static_cast<unsigned>(field) - static_cast<unsigned>(Field::Param1);
    // A NaN is refused for itself.
    if (field == Field::None || std::isnan(numberOf(row.sent, index))) continue;
    const float foretold = keptValue(row.sent, field, row.keeper);
    const bool isKnown = !std::isnan(foretold);
    (isKnown ? told : unknown) += 1;
    const bool isRight =
        isKnown ? foretold == static_cast<float>(numberOf(row.read, index)) : isUnforeseeable(row, index);
    if (isRight) continue;
    if (wrong++ == 0) vehicle = row.vehicle, line = row.line;
  }
  CAPTURE(vehicle);
  CAPTURE(line);
  CHECK(wrong == 0);
  CHECK(told > 1500);
  CHECK(unknown < told);
}
