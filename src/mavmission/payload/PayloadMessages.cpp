#include "PayloadMessages.h"

#include <Arduino.h>
#include <string.h>

#include "../base/Flash.h"
#include "OutgoingFields.h"

namespace mavmission {
using namespace detail;

// --- DISTANCE_SENSOR

DistanceSensor::DistanceSensor(uint16_t leastCm, uint16_t mostCm, uint8_t orientation, uint8_t id, uint8_t type) {
  static_assert(sizeof(payload_) == MAVLINK_MSG_ID_DISTANCE_SENSOR_MIN_LEN, "extensions are left out: they stay 0");
  typedef mavlink_distance_sensor_t Message;
  memset(payload_, 0, sizeof(payload_));
  put(payload_, offsetof(Message, min_distance), leastCm);
  put(payload_, offsetof(Message, max_distance), mostCm);
  put(payload_, offsetof(Message, type), type);
  put(payload_, offsetof(Message, id), id);
  put(payload_, offsetof(Message, orientation), orientation);
  put(payload_, offsetof(Message, covariance), uint8_t{255});  // not known
}

void DistanceSensor::set(uint16_t distanceCm) {
  typedef mavlink_distance_sensor_t Message;
  put(payload_, offsetof(Message, time_boot_ms), static_cast<uint32_t>(millis()));
  put(payload_, offsetof(Message, current_distance), distanceCm);
}

DistanceSensor::operator OutgoingMessage() const { return MAVMISSION_OUTGOING(DISTANCE_SENSOR, payload_); }

// --- LANDING_TARGET

LandingTarget::LandingTarget(uint8_t number) {
  static_assert(sizeof(payload_) == MAVLINK_MSG_ID_LANDING_TARGET_MIN_LEN, "extensions are left out: they stay 0");
  typedef mavlink_landing_target_t Message;
  memset(payload_, 0, sizeof(payload_));
  put(payload_, offsetof(Message, target_num), number);
  put(payload_, offsetof(Message, frame), static_cast<uint8_t>(MAV_FRAME_BODY_FRD));
}

void LandingTarget::set(float rightRad, float downRad, float distanceM) {
  typedef mavlink_landing_target_t Message;
  put(payload_, offsetof(Message, time_usec), uint64_t{1000} * millis());
  put(payload_, offsetof(Message, angle_x), rightRad);
  put(payload_, offsetof(Message, angle_y), downRad);
  put(payload_, offsetof(Message, distance), distanceM);
}

LandingTarget::operator OutgoingMessage() const { return MAVMISSION_OUTGOING(LANDING_TARGET, payload_); }

LandingTargetPosition::LandingTargetPosition(uint8_t number) {
  typedef mavlink_landing_target_t Message;
  static_assert(sizeof(payload_) == sizeof(Message), "the payload is the whole message");
  memset(payload_, 0, sizeof(payload_));
  put(payload_, offsetof(Message, target_num), number);
  put(payload_, offsetof(Message, q), 1.0f);  // not turned
  put(payload_, offsetof(Message, position_valid), uint8_t{1});
}

void LandingTargetPosition::set(uint8_t frame, float x, float y, float z, float distanceM) {
  typedef mavlink_landing_target_t Message;
  put(payload_, offsetof(Message, time_usec), uint64_t{1000} * millis());
  put(payload_, offsetof(Message, frame), frame);
  put(payload_, offsetof(Message, x), x);
  put(payload_, offsetof(Message, y), y);
  put(payload_, offsetof(Message, z), z);
  put(payload_, offsetof(Message, distance), distanceM);
}

void LandingTargetPosition::setFromAircraft(float forwardM, float rightM, float downM, float distanceM) {
  set(MAV_FRAME_BODY_FRD, forwardM, rightM, downM, distanceM);
}

void LandingTargetPosition::setFromOrigin(float northM, float eastM, float downM) {
  set(MAV_FRAME_LOCAL_NED, northM, eastM, downM, 0);
}

LandingTargetPosition::operator OutgoingMessage() const {
  // Without its extensions it would say that the target is straight below.
  return OutgoingMessage{MAVLINK_MSG_ID_LANDING_TARGET, MAVLINK_MSG_ID_LANDING_TARGET_CRC, sizeof(payload_), 0,
                         payload_};
}

// --- NAMED_VALUE_FLOAT

NamedValue::NamedValue(const char* name) {
  typedef mavlink_named_value_float_t Message;
  static_assert(sizeof(payload_) == sizeof(Message), "the payload is the whole message");
  memset(payload_, 0, sizeof(payload_));
  strncpy(reinterpret_cast<char*>(payload_) + offsetof(Message, name), name, sizeof(Message::name));
}

void NamedValue::set(float value) {
  typedef mavlink_named_value_float_t Message;
  put(payload_, offsetof(Message, time_boot_ms), static_cast<uint32_t>(millis()));
  put(payload_, offsetof(Message, value), value);
}

NamedValue::operator OutgoingMessage() const { return MAVMISSION_OUTGOING(NAMED_VALUE_FLOAT, payload_); }

// --- STATUSTEXT

void TextMessage::set(uint8_t severity, FlashText text) {
  typedef mavlink_statustext_t Message;
  static_assert(sizeof(payload_) == MAVLINK_MSG_ID_STATUSTEXT_MIN_LEN && offsetof(Message, text) == 1,
                "extensions are left out: they stay 0");
  memset(payload_, 0, sizeof(payload_));
  payload_[offsetof(Message, severity)] = severity;
  constexpr uint8_t kLength = sizeof(Message::text);
  for (uint8_t i = 0; i < kLength; ++i) {
    const uint8_t c = fromFlash(reinterpret_cast<const uint8_t*>(text) + i);
    if (c == 0) return;
    payload_[offsetof(Message, text) + i] = c;
  }
}

#ifdef ARDUINO
void TextMessage::set(uint8_t severity, const char* text) {
  typedef mavlink_statustext_t Message;
  memset(payload_, 0, sizeof(payload_));
  payload_[offsetof(Message, severity)] = severity;
  strncpy(reinterpret_cast<char*>(payload_) + offsetof(Message, text), text, sizeof(Message::text));
}
#endif

TextMessage::operator OutgoingMessage() const { return MAVMISSION_OUTGOING(STATUSTEXT, payload_); }

}  // namespace mavmission
