// The messages of PayloadMessages.h, byte by byte as they are sent.
#include "mavmission/payload/PayloadMessages.h"

#include <Arduino.h>
#include <doctest/doctest.h>
#include <string.h>

#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

constexpr uint32_t kNowMs = 4294967295u;  // in microseconds it needs more than 32 bits

// Every byte is that of the message as it ought to be, as far as it is sent.
template <typename Message>
bool carries(const OutgoingMessage& sent, const Message& wanted) {
  return sent.length <= sizeof(wanted) && memcmp(sent.payload, &wanted, sent.length) == 0;
}

bool isSentAs(const OutgoingMessage& sent, uint32_t id, uint8_t crcExtra, uint8_t length, uint8_t lengthV1) {
  return sent.id == id && sent.crcExtra == crcExtra && sent.length == length && sent.lengthV1 == lengthV1;
}

}  // namespace

TEST_CASE("a distance has the range of its sensor, and the time at which it was set") {
  setMillis(kNowMs);
  DistanceSensor sensor(20, 40000, 24, 3, 1);
  mavlink_distance_sensor_t wanted = mavlink_distance_sensor_t();
  wanted.min_distance = 20;
  wanted.max_distance = 40000;
  wanted.orientation = 24;
  wanted.id = 3;
  wanted.type = 1;
  wanted.covariance = 255;  // not known
  CHECK(carries(sensor, wanted));
  sensor.set(31234);
  wanted.time_boot_ms = kNowMs;
  wanted.current_distance = 31234;
  CHECK(carries(sensor, wanted));
  CHECK(isSentAs(sensor, 132, 85, 14, 14));
}

TEST_CASE("a distance is that of the first laser, downwards, where nothing else is said") {
  mavlink_distance_sensor_t wanted = mavlink_distance_sensor_t();
  wanted.min_distance = 1;
  wanted.max_distance = 2;
  wanted.orientation = 25;
  wanted.covariance = 255;
  CHECK(carries(DistanceSensor(1, 2), wanted));
}

TEST_CASE("a landing target as a camera sees it has two angles and a distance, and no position") {
  setMillis(kNowMs);
  LandingTarget target(2);
  target.set(0.25f, -0.5f, 12.5f);
  mavlink_landing_target_t wanted = mavlink_landing_target_t();
  wanted.time_usec = 4294967295000u;
  wanted.angle_x = 0.25f;
  wanted.angle_y = -0.5f;
  wanted.distance = 12.5f;
  wanted.target_num = 2;
  wanted.frame = 12;  // MAV_FRAME_BODY_FRD
  CHECK(carries(target, wanted));
  CHECK(isSentAs(target, 149, 200, 30, 30));
  target.set(0.25f, -0.5f);  // how far it is is not known
  wanted.distance = 0;
  CHECK(carries(target, wanted));
  wanted = mavlink_landing_target_t();
  wanted.frame = 12;
  CHECK(carries(LandingTarget(), wanted));
}

TEST_CASE("a landing target as a position is valid, not turned, and no message of MAVLink 1") {
  setMillis(kNowMs);
  LandingTargetPosition target(7);
  mavlink_landing_target_t wanted = mavlink_landing_target_t();
  wanted.target_num = 7;
  wanted.q[0] = 1;
  wanted.position_valid = 1;
  CHECK(carries(target, wanted));
  wanted.time_usec = 4294967295000u;
  target.setFromAircraft(1.5f, -2.5f, 10, 11);
  wanted.frame = 12;  // MAV_FRAME_BODY_FRD
  wanted.x = 1.5f;
  wanted.y = -2.5f;
  wanted.z = 10;
  wanted.distance = 11;
  CHECK(carries(target, wanted));
  target.setFromOrigin(100, 200, -3);
  wanted.frame = 1;  // MAV_FRAME_LOCAL_NED
  wanted.x = 100;
  wanted.y = 200;
  wanted.z = -3;
  wanted.distance = 0;
  CHECK(carries(target, wanted));
  CHECK(isSentAs(target, 149, 200, 60, 0));
}

TEST_CASE("a value has up to 10 characters of its name, without a zero after the tenth") {
  setMillis(kNowMs);
  NamedValue value("0123456789cut");
  mavlink_named_value_float_t wanted = mavlink_named_value_float_t();
  memcpy(wanted.name, "0123456789", 10);
  CHECK(carries(value, wanted));
  value.set(3.25f);
  wanted.time_boot_ms = kNowMs;
  wanted.value = 3.25f;
  CHECK(carries(value, wanted));
  CHECK(isSentAs(value, 251, 170, 18, 18));
  wanted = mavlink_named_value_float_t();
  memcpy(wanted.name, "weight", 6);
  CHECK(carries(NamedValue("weight"), wanted));
}

TEST_CASE("a text has up to 50 characters, and nothing of the text before it") {
  mavlink_statustext_t wanted = mavlink_statustext_t();
  TextMessage text;
  CHECK(carries(text, wanted));
  const char* const kLong = "01234567890123456789012345678901234567890123456789cut";
  text.set(2, kLong);
  wanted.severity = 2;
  memcpy(wanted.text, kLong, 50);
  CHECK(carries(text, wanted));
  text.set(6, F("dropped"));
  wanted = mavlink_statustext_t();
  wanted.severity = 6;
  memcpy(wanted.text, "dropped", 7);
  CHECK(carries(text, wanted));
  CHECK(isSentAs(text, 253, 83, 51, 51));
}
