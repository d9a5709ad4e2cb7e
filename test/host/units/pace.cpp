#include "mavmission/base/Pace.h"

#include <doctest/doctest.h>

using namespace mavmission;
using namespace mavmission::detail;

namespace {

Pace begun() {
  Pace pace = Pace();
  pace.begin();
  return pace;
}

}  // namespace

TEST_CASE("a line that has lost nothing is patient, and one that has is not for 10 s") {
  Pace pace = begun();
  CHECK(pace.againMs() == uint16_t{Pace::kPatienceMs});
  pace.noteLoss();
  for (int second = 0; second < Pace::kLossyS; ++second) {
    CHECK(pace.againMs() == 2 * uint16_t{Pace::kFirstMs});
    pace.onSecond();
  }
  CHECK_FALSE(pace.isLossy());
  CHECK(pace.againMs() == uint16_t{Pace::kPatienceMs});
  pace.onSecond();
  CHECK_FALSE(pace.isLossy());
}

TEST_CASE(
    "an answer to what was sent once says how long the line takes; one to what was sent again only that it is less") {
  Pace pace = begun();
  pace.noteLoss();
  pace.learn(160, true);
  CHECK(pace.againMs() == 320);
  pace.learn(400, false);
  CHECK(pace.againMs() == 320);
  pace.learn(20, false);
  CHECK(pace.againMs() == 40);
  pace.learn(30, true);
  CHECK(pace.againMs() == 60);
}
