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

TEST_CASE("a line that has lost nothing waits as the rule says, and one that has not so long for 10 s") {
  Pace pace = begun();
  CHECK(pace.waitMs(1500) == 1500);
  pace.noteLoss();
  for (int second = 0; second < Pace::kLossyS; ++second) {
    CHECK(pace.waitMs(1500) == 2 * uint16_t{Pace::kFirstMs});
    pace.onSecond();
  }
  CHECK_FALSE(pace.isLossy());
  CHECK(pace.waitMs(1500) == 1500);
  pace.onSecond();
  CHECK_FALSE(pace.isLossy());
}

TEST_CASE("an answer to a message that was sent once says how long a round trip takes") {
  Pace pace = begun();
  pace.noteLoss();
  pace.learn(160, true);
  CHECK(pace.waitMs(250) == 320);
  pace.learn(30, true);
  CHECK(pace.waitMs(250) == 60);
}

TEST_CASE("an answer to a message that was sent again says only that a round trip is no longer than that") {
  Pace pace = begun();
  pace.noteLoss();
  pace.learn(160, true);
  pace.learn(400, false);
  CHECK(pace.waitMs(250) == 320);
  pace.learn(20, false);
  CHECK(pace.waitMs(250) == 40);
}

TEST_CASE("repeats are five times apart what the line takes for a frame, and a busy time is forgotten by halves") {
  Pace pace = begun();
  pace.noteLoss();
  pace.noteBusy(60);
  pace.noteBusy(20);
  CHECK(pace.waitMs(250) == 300);
  pace.onSecond();
  CHECK(pace.waitMs(250) == 150);
}
