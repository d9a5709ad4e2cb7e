// The messages of PayloadMessages.h, byte by byte as they are sent: in words, how long they are and all that is not 0.
#include "mavmission/payload/PayloadMessages.h"

#include <Arduino.h>
#include <doctest/doctest.h>

#include "Messages.h"

using namespace mavmission;

namespace {

constexpr uint32_t kNowMs = 4294967295u;  // in microseconds it needs more than 32 bits

}  // namespace

TEST_CASE("a distance has the range of its sensor, the first laser downwards by default, and when it was set") {
  setMillis(kNowMs);
  CHECK(wordsOf(DistanceSensor(1, 2)) ==
        "14 14: DISTANCE_SENSOR min_distance 1 max_distance 2 orientation 25 covariance 255");
  DistanceSensor sensor(20, 40000, 24, 3, 1);
  CHECK(wordsOf(sensor) ==
        "14 14: DISTANCE_SENSOR min_distance 20 max_distance 40000 type 1 id 3 orientation 24 covariance 255");
  sensor.set(31234);
  CHECK(wordsOf(sensor) ==
        "14 14: DISTANCE_SENSOR time_boot_ms 4294967295 min_distance 20 max_distance 40000 current_distance 31234 "
        "type 1 id 3 orientation 24 covariance 255");
}

TEST_CASE("what no function has set is 0, whatever was in that memory before") {
  setMillis(1);
  CHECK(isSameAnywhere<DistanceSensor>(1, 2));
  CHECK(isSameAnywhere<LandingTarget>());
  CHECK(isSameAnywhere<LandingTargetPosition>());
  CHECK(isSameAnywhere<NamedValue>("weight"));
  CHECK(isSameAnywhere<TextMessage>());
}

TEST_CASE("a landing target as a camera sees it has two angles and a distance, and no position") {
  setMillis(kNowMs);
  CHECK(wordsOf(LandingTarget()) == "30 30: LANDING_TARGET frame 12");  // MAV_FRAME_BODY_FRD
  LandingTarget target(2);
  target.set(0.25f, -0.5f, 12.5f);
  const std::string seen =
      "30 30: LANDING_TARGET time_usec 4294967295000 target_num 2 frame 12 angle_x 0.25 angle_y -0.5";
  CHECK(wordsOf(target) == seen + " distance 12.5");
  target.set(0.25f, -0.5f);  // how far it is is not known
  CHECK(wordsOf(target) == seen);
}

TEST_CASE("a landing target as a position is valid, not turned, and no message of MAVLink 1") {
  setMillis(kNowMs);
  LandingTargetPosition target(7);
  CHECK(wordsOf(target) == "60 0: LANDING_TARGET target_num 7 q[0] 1 position_valid 1");
  target.setFromAircraft(1.5f, -2.5f, 10, 11);
  CHECK(wordsOf(target) ==
        "60 0: LANDING_TARGET time_usec 4294967295000 target_num 7 frame 12 distance 11 x 1.5 y -2.5 z 10 q[0] 1 "
        "position_valid 1");
  target.setFromOrigin(100, 200, -3);  // MAV_FRAME_LOCAL_NED
  CHECK(wordsOf(target) ==
        "60 0: LANDING_TARGET time_usec 4294967295000 target_num 7 frame 1 x 100 y 200 z -3 q[0] 1 position_valid 1");
}

TEST_CASE("a value has up to 10 characters of its name, without a zero after the tenth") {
  setMillis(kNowMs);
  NamedValue value("0123456789cut");
  CHECK(wordsOf(value) == "18 18: NAMED_VALUE_FLOAT name 0123456789");
  value.set(3.25f);
  CHECK(wordsOf(value) == "18 18: NAMED_VALUE_FLOAT time_boot_ms 4294967295 name 0123456789 value 3.25");
  CHECK(wordsOf(NamedValue("weight")) == "18 18: NAMED_VALUE_FLOAT name weight");
}

TEST_CASE("a text has up to 50 characters, and nothing of the text before it") {
  TextMessage text;
  CHECK(wordsOf(text) == "51 51: STATUSTEXT");
  text.set(2, "01234567890123456789012345678901234567890123456789cut");
  CHECK(wordsOf(text) == "51 51: STATUSTEXT severity 2 text 01234567890123456789012345678901234567890123456789");
  text.set(6, F("dropped"));
  CHECK(wordsOf(text) == "51 51: STATUSTEXT severity 6 text dropped");
}
