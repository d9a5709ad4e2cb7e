// Messages that a payload has to tell: a distance, a landing target, a value with a name, a text.
#pragma once

#include <stdint.h>

#include "FlashText.h"
#include "OutgoingMessage.h"

namespace mavmission {

// Each is filled by its own function, and then sent:
//
//   NamedValue weight("weight");
//   weight.set(3.25);
//   autopilot.sendMessage(weight);  // false: another frame is still being sent; call it again later
//
// It must live, and stay as it is, until MissionClient::isSent().

// How far something is away (DISTANCE_SENSOR). `orientation`: MAV_SENSOR_ORIENTATION, 25 is downwards. `id`: of the
// sensor, from 0 on. `type`: MAV_DISTANCE_SENSOR, 0 is a laser, 1 ultrasound.
class DistanceSensor {
 public:
  // What the sensor can measure at least and at most [cm].
  DistanceSensor(uint16_t leastCm, uint16_t mostCm, uint8_t orientation = 25, uint8_t id = 0, uint8_t type = 0);
  // The distance [cm].
  void set(uint16_t distanceCm);
  // For MissionClient::sendMessage().
  operator OutgoingMessage() const;

 private:
  uint8_t payload_[14];
};

// Where a landing target is, as a camera sees it (LANDING_TARGET). ArduPilot takes it so, with `PLND_TYPE` 1; PX4 takes
// only positions, which this message does not carry.
class LandingTarget {
 public:
  // `number`: of the target, if there are several.
  explicit LandingTarget(uint8_t number = 0);
  // The angles from the camera's axis to the target, to the right and upwards in the picture [rad], and how far the
  // target is away [m]; 0: not known.
  void set(float rightRad, float upRad, float distanceM = 0);
  // For MissionClient::sendMessage().
  operator OutgoingMessage() const;

 private:
  uint8_t payload_[30];
};

// A number with a name (NAMED_VALUE_FLOAT): ground stations draw it, autopilots log it.
class NamedValue {
 public:
  // A name of up to 10 characters; what is longer is cut off.
  explicit NamedValue(const char* name);
  // The number.
  void set(float value);
  // For MissionClient::sendMessage().
  operator OutgoingMessage() const;

 private:
  uint8_t payload_[18];
};

// A text for the ground station (STATUSTEXT). `severity`: MAV_SEVERITY, 0 (emergency) to 7 (debug); 6 is information.
class TextMessage {
 public:
  TextMessage() : payload_() {}
  // Up to 50 characters; what is longer is cut off.
  void set(uint8_t severity, FlashText text);
#ifdef ARDUINO
  void set(uint8_t severity, const char* text);
#endif
  // For MissionClient::sendMessage().
  operator OutgoingMessage() const;

 private:
  uint8_t payload_[51];
};

}  // namespace mavmission
