#include "SensorMessages.h"

#include <Arduino.h>

#include "OutgoingFields.h"

namespace mavmission {
using namespace detail;
namespace {

// The messages with an id above 255 do not exist in MAVLink 1.
#define MAVMISSION_OUTGOING_V2(NAME, payload)                                                             \
  OutgoingMessage {                                                                                       \
    MAVLINK_MSG_ID_##NAME, MAVLINK_MSG_ID_##NAME##_CRC, static_cast<uint8_t>(sizeof(payload)), 0, payload \
  }

constexpr uint16_t kUnknownCm = 0xFFFF;
constexpr uint8_t kLeastStepDeg = 5;  // PX4 reads 360 divided by this many distances

uint64_t bootUs() { return uint64_t{1000} * millis(); }

// A covariance is the upper right triangle of a matrix of six by six, row by row: the diagonal is what begins each row.
void putVariances(uint8_t* covariance, float first, float second) {
  for (uint8_t row = 0, at = 0; row < 6; ++row) {
    put(covariance, at, row < 3 ? first : second);
    at = static_cast<uint8_t>(at + (6 - row) * sizeof(float));
  }
}

void putThree(uint8_t* payload, uint8_t offset, float first, float second, float third) {
  const float numbers[] = {first, second, third};
  memcpy(payload + offset, numbers, sizeof(numbers));
}

constexpr float kNotKnown = __builtin_nanf("");

}  // namespace

// --- OBSTACLE_DISTANCE

ObstacleDistance::ObstacleDistance(uint16_t leastCm, uint16_t mostCm, uint8_t stepDeg, uint8_t type) {
  typedef mavlink_obstacle_distance_t Message;
  static_assert(sizeof(payload_) == sizeof(Message) && sizeof(Message::distances) == sizeof(uint16_t) * kCount,
                "the payload is the whole message");
  memset(payload_, 0, sizeof(payload_));
  put(payload_, offsetof(Message, min_distance), leastCm);
  put(payload_, offsetof(Message, max_distance), mostCm);
  put(payload_, offsetof(Message, sensor_type), type);
  put(payload_, offsetof(Message, increment), stepDeg < kLeastStepDeg ? kLeastStepDeg : stepDeg);
  put(payload_, offsetof(Message, frame), static_cast<uint8_t>(MAV_FRAME_BODY_FRD));
  setUnknown();
}

void ObstacleDistance::set(uint8_t index, uint16_t distanceCm) {
  typedef mavlink_obstacle_distance_t Message;
  if (index >= kCount) return;
  put(payload_, static_cast<uint8_t>(offsetof(Message, distances) + sizeof(distanceCm) * index), distanceCm);
  put(payload_, offsetof(Message, time_usec), bootUs());
}

void ObstacleDistance::setFree(uint8_t index) {
  uint16_t mostCm;
  memcpy(&mostCm, payload_ + offsetof(mavlink_obstacle_distance_t, max_distance), sizeof(mostCm));
  set(index, static_cast<uint16_t>(mostCm + 1));
}

void ObstacleDistance::setUnknown(uint8_t index) { set(index, kUnknownCm); }

void ObstacleDistance::setUnknown() {
  for (uint8_t i = 0; i < kCount; ++i) setUnknown(i);
}

ObstacleDistance::operator OutgoingMessage() const { return MAVMISSION_OUTGOING_V2(OBSTACLE_DISTANCE, payload_); }

// --- GPS_INPUT

GpsInput::GpsInput(uint8_t id) {
  typedef mavlink_gps_input_t Message;
  static_assert(sizeof(payload_) == sizeof(Message), "the payload is the whole message");
  memset(payload_, 0, sizeof(payload_));
  put(payload_, offsetof(Message, gps_id), id);
  constexpr uint16_t kAll = GPS_INPUT_IGNORE_FLAG_ALT | GPS_INPUT_IGNORE_FLAG_HDOP | GPS_INPUT_IGNORE_FLAG_VDOP |
                            GPS_INPUT_IGNORE_FLAG_VEL_HORIZ | GPS_INPUT_IGNORE_FLAG_VEL_VERT |
                            GPS_INPUT_IGNORE_FLAG_SPEED_ACCURACY | GPS_INPUT_IGNORE_FLAG_HORIZONTAL_ACCURACY |
                            GPS_INPUT_IGNORE_FLAG_VERTICAL_ACCURACY;
  put(payload_, offsetof(Message, ignore_flags), kAll);
}

void GpsInput::know(uint8_t fields) {
  static_assert(GPS_INPUT_IGNORE_FLAG_VERTICAL_ACCURACY < 256, "the flags are in the first of two bytes");
  payload_[offsetof(mavlink_gps_input_t, ignore_flags)] &= static_cast<uint8_t>(~fields);
}

void GpsInput::set(const LatLon& place, Metres aboveSea, GpsFix fix, uint8_t satellites) {
  typedef mavlink_gps_input_t Message;
  put(payload_, offsetof(Message, time_usec), bootUs());
  put(payload_, offsetof(Message, lat), place.latitude.e7());
  put(payload_, offsetof(Message, lon), place.longitude.e7());
  put(payload_, offsetof(Message, alt), aboveSea.value);
  put(payload_, offsetof(Message, fix_type), fix);
  put(payload_, offsetof(Message, satellites_visible), satellites);
  know(GPS_INPUT_IGNORE_FLAG_ALT);
}

void GpsInput::setVelocity(float north, float east, float down) {
  putThree(payload_, offsetof(mavlink_gps_input_t, vn), north, east, down);
  know(GPS_INPUT_IGNORE_FLAG_VEL_HORIZ | GPS_INPUT_IGNORE_FLAG_VEL_VERT);
}

void GpsInput::setAccuracy(float place, float altitude, float speed) {
  putThree(payload_, offsetof(mavlink_gps_input_t, speed_accuracy), speed, place, altitude);
  know(GPS_INPUT_IGNORE_FLAG_SPEED_ACCURACY | GPS_INPUT_IGNORE_FLAG_HORIZONTAL_ACCURACY |
       GPS_INPUT_IGNORE_FLAG_VERTICAL_ACCURACY);
}

void GpsInput::setDilution(float horizontal, float vertical) {
  typedef mavlink_gps_input_t Message;
  put(payload_, offsetof(Message, hdop), horizontal);
  put(payload_, offsetof(Message, vdop), vertical);
  know(GPS_INPUT_IGNORE_FLAG_HDOP | GPS_INPUT_IGNORE_FLAG_VDOP);
}

void GpsInput::setTime(uint16_t week, uint32_t msOfWeek) {
  typedef mavlink_gps_input_t Message;
  put(payload_, offsetof(Message, time_week), week);
  put(payload_, offsetof(Message, time_week_ms), msOfWeek);
}

void GpsInput::setHeading(uint16_t cdeg) { put(payload_, offsetof(mavlink_gps_input_t, yaw), cdeg); }

GpsInput::operator OutgoingMessage() const { return MAVMISSION_OUTGOING(GPS_INPUT, payload_); }

// --- VISION_POSITION_ESTIMATE

VisionPosition::VisionPosition() {
  static_assert(sizeof(payload_) == sizeof(mavlink_vision_position_estimate_t), "the payload is the whole message");
  memset(payload_, 0, sizeof(payload_));
  setVariance(kNotKnown, kNotKnown);
}

void VisionPosition::set(float north, float east, float down, float roll, float pitch, float yaw) {
  typedef mavlink_vision_position_estimate_t Message;
  put(payload_, offsetof(Message, usec), bootUs());
  putThree(payload_, offsetof(Message, x), north, east, down);
  putThree(payload_, offsetof(Message, roll), roll, pitch, yaw);
}

void VisionPosition::setVariance(float position, float angle) {
  putVariances(payload_ + offsetof(mavlink_vision_position_estimate_t, covariance), position, angle);
}

void VisionPosition::countReset() { ++payload_[offsetof(mavlink_vision_position_estimate_t, reset_counter)]; }

VisionPosition::operator OutgoingMessage() const { return MAVMISSION_OUTGOING(VISION_POSITION_ESTIMATE, payload_); }

// --- ODOMETRY

Odometry::Odometry(uint8_t frame) {
  typedef mavlink_odometry_t Message;
  static_assert(sizeof(payload_) == sizeof(Message), "the payload is the whole message");
  memset(payload_, 0, sizeof(payload_));
  put(payload_, offsetof(Message, frame_id), frame);
  put(payload_, offsetof(Message, child_frame_id), static_cast<uint8_t>(MAV_FRAME_BODY_FRD));
  put(payload_, offsetof(Message, estimator_type), static_cast<uint8_t>(MAV_ESTIMATOR_TYPE_VISION));
  put(payload_, offsetof(Message, q), 1.0f);  // not turned
  setVelocity(kNotKnown, kNotKnown, kNotKnown);
  setRotation(kNotKnown, kNotKnown, kNotKnown);
  setVariance(kNotKnown, kNotKnown, kNotKnown);
}

void Odometry::setPose(float x, float y, float z, float qw, float qx, float qy, float qz) {
  typedef mavlink_odometry_t Message;
  put(payload_, offsetof(Message, time_usec), bootUs());
  putThree(payload_, offsetof(Message, x), x, y, z);
  put(payload_, offsetof(Message, q), qw);
  putThree(payload_, offsetof(Message, q) + sizeof(qw), qx, qy, qz);
}

void Odometry::setVelocity(float forward, float right, float down) {
  putThree(payload_, offsetof(mavlink_odometry_t, vx), forward, right, down);
}

void Odometry::setRotation(float roll, float pitch, float yaw) {
  putThree(payload_, offsetof(mavlink_odometry_t, rollspeed), roll, pitch, yaw);
}

void Odometry::setVariance(float position, float angle, float velocity) {
  typedef mavlink_odometry_t Message;
  putVariances(payload_ + offsetof(Message, pose_covariance), position, angle);
  putVariances(payload_ + offsetof(Message, velocity_covariance), velocity, kNotKnown);
}

void Odometry::setQuality(int8_t percent) { put(payload_, offsetof(mavlink_odometry_t, quality), percent); }

void Odometry::countReset() { ++payload_[offsetof(mavlink_odometry_t, reset_counter)]; }

Odometry::operator OutgoingMessage() const { return MAVMISSION_OUTGOING_V2(ODOMETRY, payload_); }

}  // namespace mavmission
