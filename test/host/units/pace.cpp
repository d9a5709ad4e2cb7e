#include "mavmission/base/Pace.h"

#include <doctest/doctest.h>

using namespace mavmission;
using namespace mavmission::detail;

TEST_CASE("a line that has lost nothing waits as the rule says, and one that has not so long for 10 s") {
  Pace pace = Pace();
  CHECK(pace.waitMs(1500) == 1500);
  pace.noteLoss();
  for (int second = 0; second < Pace::kLossyS; ++second) {
    CHECK(pace.waitMs(1500) == uint16_t{Pace::kLeastMs});
    pace.onSecond();
  }
  CHECK_FALSE(pace.isLossy());
  CHECK(pace.waitMs(1500) == 1500);
  pace.onSecond();
  CHECK_FALSE(pace.isLossy());
}

TEST_CASE("an answer to a message that was sent once says how long a round trip takes: a longer one by a quarter") {
  Pace pace = Pace();
  pace.learn(600, true);
  CHECK(pace.waitMs(250) == 4 * 600);
  pace.noteLoss();
  CHECK(pace.waitMs(250) == 75);
  pace.learn(1000, true);
  CHECK(pace.waitMs(250) == 87);
  pace.learn(560, true);
  CHECK(pace.waitMs(250) == 70);
}

TEST_CASE("an answer to a message that was sent again says only that a round trip is no longer than that") {
  Pace pace = Pace();
  pace.noteLoss();
  pace.learn(640, false);
  CHECK(pace.waitMs(250) == 80);
  pace.learn(1000, false);
  CHECK(pace.waitMs(250) == 80);
  pace.learn(480, false);
  CHECK(pace.waitMs(250) == 60);
}

TEST_CASE("nothing is waited for longer than the longest round trip that is reckoned with asks for") {
  Pace pace = Pace();
  pace.learn(9000, true);
  CHECK(pace.waitMs(250) == 4 * Pace::kMostMs);
  pace.noteSlower();
  CHECK(pace.waitMs(250) == 4 * Pace::kMostMs);
  pace.noteLoss();
  CHECK(pace.waitMs(250) == uint16_t{Pace::kMostWaitMs});
}

TEST_CASE("what comes a round trip after something new was sent is no answer to anything before that") {
  Pace pace = Pace();
  pace.learn(300, true);
  CHECK_FALSE(pace.isBehind(300 + uint16_t{Pace::kLeastMs} - 1));
  CHECK(pace.isBehind(300 + uint16_t{Pace::kLeastMs}));
  pace.noteSlower();
  CHECK_FALSE(pace.isBehind(600 + uint16_t{Pace::kLeastMs} - 1));
  CHECK(pace.isBehind(600 + uint16_t{Pace::kLeastMs}));
}

TEST_CASE("repeats are five times apart what the line takes for a frame, and a busy time is forgotten by halves") {
  Pace pace = Pace();
  pace.noteLoss();
  pace.noteBusy(60);
  pace.noteBusy(20);
  CHECK(pace.waitMs(250) == 300);
  pace.onSecond();
  CHECK(pace.waitMs(250) == 150);
}
