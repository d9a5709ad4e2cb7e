// The messages of SensorMessages.h, byte by byte as they are sent.
#include "mavmission/payload/SensorMessages.h"

#include <Arduino.h>
#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>
#include <new>

#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

constexpr uint32_t kNowMs = 4294967295u;  // in microseconds it needs more than 32 bits
constexpr uint64_t kNowUs = 4294967295000u;

// Every byte is that of the message as it ought to be.
template <typename Message>
bool carries(const OutgoingMessage& sent, const Message& wanted) {
  return sent.length == sizeof(wanted) && memcmp(sent.payload, &wanted, sizeof(wanted)) == 0;
}

bool isSentAs(const OutgoingMessage& sent, uint32_t id, uint8_t crcExtra, uint8_t length, uint8_t lengthV1) {
  return sent.id == id && sent.crcExtra == crcExtra && sent.length == length && sent.lengthV1 == lengthV1;
}

const float kNotKnown = __builtin_nanf("");

// Where the upper right triangle of a matrix of six by six, row by row, has its diagonal.
constexpr uint8_t kDiagonal[] = {0, 6, 11, 15, 18, 20};

}  // namespace

TEST_CASE("of the obstacles nothing is known at first, in 72 directions") {
  setMillis(1);
  mavlink_obstacle_distance_t wanted = mavlink_obstacle_distance_t();
  wanted.time_usec = 1000;
  wanted.min_distance = 20;
  wanted.max_distance = 600;
  wanted.sensor_type = 0;
  wanted.increment = 5;
  wanted.frame = 12;  // MAV_FRAME_BODY_FRD
  for (int i = 0; i < 72; ++i) wanted.distances[i] = 65535;
  const ObstacleDistance around(20, 600);
  CHECK(carries(around, wanted));
  CHECK(isSentAs(around, 330, 23, 167, 0));
}

TEST_CASE("what no function has set is 0, whatever was in that memory before") {
  setMillis(1);
  alignas(8) uint8_t first[sizeof(Odometry)], second[sizeof(Odometry)];
  memset(first, 0, sizeof(first));
  memset(second, 255, sizeof(second));
  const ObstacleDistance* const around = new (first) ObstacleDistance(20, 600);
  const ObstacleDistance* const other = new (second) ObstacleDistance(20, 600);
  CHECK(memcmp(OutgoingMessage(*around).payload, OutgoingMessage(*other).payload, 167) == 0);
  memset(first, 0, sizeof(first));
  memset(second, 255, sizeof(second));
  const VisionPosition* const vision = new (first) VisionPosition;
  const VisionPosition* const seen = new (second) VisionPosition;
  CHECK(memcmp(OutgoingMessage(*vision).payload, OutgoingMessage(*seen).payload, 117) == 0);
}

TEST_CASE("the directions are at least 5 degrees apart") {
  for (uint8_t step : {0, 4, 5, 6, 45, 180}) {
    mavlink_obstacle_distance_t sent;
    memcpy(&sent, OutgoingMessage(ObstacleDistance(20, 600, step, 3)).payload, sizeof(sent));
    CHECK(uint8_t{sent.increment} == (step < 5 ? 5 : step));
    CHECK(uint8_t{sent.sensor_type} == 3);
  }
}

TEST_CASE("each direction has a distance, is free, or is not known, and one more there is none") {
  setMillis(1);
  ObstacleDistance around(20, 600, 5, 1);
  mavlink_obstacle_distance_t wanted = mavlink_obstacle_distance_t();
  memcpy(&wanted, OutgoingMessage(around).payload, sizeof(wanted));
  setMillis(kNowMs);
  around.set(72, 100);
  around.set(255, 100);
  around.setFree(72);
  around.setUnknown(72);
  CHECK(carries(around, wanted));  // not even the time is another one
  around.set(0, 321);
  wanted.time_usec = kNowUs;
  wanted.distances[0] = 321;
  CHECK(carries(around, wanted));
  around.set(71, 45);
  around.set(70, 46);
  around.setFree(1);
  wanted.distances[71] = 45;
  wanted.distances[70] = 46;
  wanted.distances[1] = 601;  // one more than the longest
  CHECK(carries(around, wanted));
  around.setUnknown(0);
  wanted.distances[0] = 65535;
  CHECK(carries(around, wanted));
  around.setUnknown();
  for (int i = 0; i < 72; ++i) wanted.distances[i] = 65535;
  CHECK(carries(around, wanted));
}

TEST_CASE("a GPS receiver says only what was set: all the rest is to be ignored") {
  setMillis(kNowMs);
  GpsInput gps(1);
  mavlink_gps_input_t wanted = mavlink_gps_input_t();
  wanted.gps_id = 1;
  wanted.ignore_flags = 255;
  CHECK(carries(gps, wanted));
  CHECK(isSentAs(gps, 232, 151, 65, 63));

  GpsInput placed(2);
  placed.set({-35.3632621_deg, 149.1652374_deg}, 584.5_m, GpsFix::ThreeDimensional, 11);
  wanted.gps_id = 2;
  wanted.time_usec = kNowUs;
  wanted.lat = -353632621;
  wanted.lon = 1491652374;
  wanted.alt = 584.5f;
  wanted.fix_type = 3;
  wanted.satellites_visible = 11;
  wanted.ignore_flags = 255 & ~1;  // GPS_INPUT_IGNORE_FLAG_ALT
  CHECK(carries(placed, wanted));

  GpsInput moving;
  moving.setVelocity(1, -2, 3.5f);
  wanted = mavlink_gps_input_t();
  wanted.vn = 1;
  wanted.ve = -2;
  wanted.vd = 3.5f;
  wanted.ignore_flags = 255 & ~(8 | 16);  // both velocities
  CHECK(carries(moving, wanted));

  GpsInput accurate;
  accurate.setAccuracy(1.5f, 2.5f, 0.25f);
  wanted = mavlink_gps_input_t();
  wanted.horiz_accuracy = 1.5f;
  wanted.vert_accuracy = 2.5f;
  wanted.speed_accuracy = 0.25f;
  wanted.ignore_flags = 255 & ~(32 | 64 | 128);
  CHECK(carries(accurate, wanted));

  GpsInput diluted;
  diluted.setDilution(0.75f, 1.25f);
  wanted = mavlink_gps_input_t();
  wanted.hdop = 0.75f;
  wanted.vdop = 1.25f;
  wanted.ignore_flags = 255 & ~(2 | 4);
  CHECK(carries(diluted, wanted));

  GpsInput dated;
  dated.setTime(2345, 604799999);
  dated.setHeading(36000);
  wanted = mavlink_gps_input_t();
  wanted.time_week = 2345;
  wanted.time_week_ms = 604799999;
  wanted.yaw = 36000;
  wanted.ignore_flags = 255;
  CHECK(carries(dated, wanted));
}

TEST_CASE("what a GPS receiver has said stays known") {
  GpsInput gps;
  gps.setVelocity(1, 2, 3);
  gps.setAccuracy(1, 2, 3);
  gps.setDilution(1, 2);
  gps.set({1_deg, 2_deg}, 3_m, GpsFix::ThreeDimensional, 6);
  mavlink_gps_input_t sent;
  memcpy(&sent, OutgoingMessage(gps).payload, sizeof(sent));
  CHECK(uint16_t{sent.ignore_flags} == 0);
}

TEST_CASE("a position by a camera has variances that are not known until they are set") {
  setMillis(kNowMs);
  VisionPosition vision;
  mavlink_vision_position_estimate_t wanted = mavlink_vision_position_estimate_t();
  for (uint8_t at : kDiagonal) wanted.covariance[at] = kNotKnown;
  CHECK(carries(vision, wanted));
  CHECK(isSentAs(vision, 102, 158, 117, 32));

  vision.set(1, 2, -3, 0.1f, -0.2f, 3.1f);
  wanted.usec = kNowUs;
  wanted.x = 1;
  wanted.y = 2;
  wanted.z = -3;
  wanted.roll = 0.1f;
  wanted.pitch = -0.2f;
  wanted.yaw = 3.1f;
  CHECK(carries(vision, wanted));

  vision.setVariance(0.25f, 0.5f);
  for (int i = 0; i < 6; ++i) wanted.covariance[kDiagonal[i]] = i < 3 ? 0.25f : 0.5f;
  CHECK(carries(vision, wanted));

  vision.countReset();
  vision.countReset();
  wanted.reset_counter = 2;
  CHECK(carries(vision, wanted));
}

TEST_CASE("an odometry is not turned, and neither its speeds nor its variances are known until they are set") {
  setMillis(kNowMs);
  Odometry odometry;
  mavlink_odometry_t wanted = mavlink_odometry_t();
  wanted.frame_id = 20;        // MAV_FRAME_LOCAL_FRD
  wanted.child_frame_id = 12;  // MAV_FRAME_BODY_FRD
  wanted.estimator_type = 2;   // MAV_ESTIMATOR_TYPE_VISION
  wanted.q[0] = 1;
  wanted.vx = wanted.vy = wanted.vz = kNotKnown;
  wanted.rollspeed = wanted.pitchspeed = wanted.yawspeed = kNotKnown;
  for (uint8_t at : kDiagonal) wanted.pose_covariance[at] = wanted.velocity_covariance[at] = kNotKnown;
  CHECK(carries(odometry, wanted));
  CHECK(isSentAs(odometry, 331, 91, 233, 0));

  odometry.setPose(1, 2, 3, 0.5f, -0.5f, 0.25f, -0.25f);
  wanted.time_usec = kNowUs;
  wanted.x = 1;
  wanted.y = 2;
  wanted.z = 3;
  wanted.q[0] = 0.5f;
  wanted.q[1] = -0.5f;
  wanted.q[2] = 0.25f;
  wanted.q[3] = -0.25f;
  CHECK(carries(odometry, wanted));

  odometry.setVelocity(4, 5, 6);
  wanted.vx = 4;
  wanted.vy = 5;
  wanted.vz = 6;
  CHECK(carries(odometry, wanted));

  odometry.setRotation(0.1f, 0.2f, 0.3f);
  wanted.rollspeed = 0.1f;
  wanted.pitchspeed = 0.2f;
  wanted.yawspeed = 0.3f;
  CHECK(carries(odometry, wanted));

  odometry.setVariance(0.01f, 0.02f, 0.04f);
  for (int i = 0; i < 3; ++i) {
    wanted.pose_covariance[kDiagonal[i]] = 0.01f;
    wanted.pose_covariance[kDiagonal[i + 3]] = 0.02f;
    wanted.velocity_covariance[kDiagonal[i]] = 0.04f;
  }
  CHECK(carries(odometry, wanted));

  odometry.setQuality(-1);
  odometry.countReset();
  odometry.countReset();
  odometry.countReset();
  wanted.quality = -1;
  wanted.reset_counter = 3;
  CHECK(carries(odometry, wanted));

  mavlink_odometry_t other;
  memcpy(&other, OutgoingMessage(Odometry(1)).payload, sizeof(other));
  CHECK(uint8_t{other.frame_id} == 1);
}
