// Messages that a payload sends: a distance, a landing target, a value with a name, a text.
#pragma once

#include <stdint.h>

#include "../base/FlashText.h"
#include "../link/OutgoingMessage.h"

namespace mavmission {

// Each is filled by its own function, and then sent:
//
//   NamedValue weight("weight");
//   weight.set(3.25);
//   autopilot.sendMessage(weight);  // false: another frame is still being sent; call it again later
//
// The object must live, and must not be changed, until MissionClient::isSent().

// The distance to something (DISTANCE_SENSOR). `orientation`: MAV_SENSOR_ORIENTATION, 25 is downwards. `id`: of the
// sensor, from 0 on. `type`: MAV_DISTANCE_SENSOR, 0 is a laser, 1 ultrasound.
class DistanceSensor {
 public:
  // The shortest and the longest distance that the sensor can measure [cm].
  DistanceSensor(uint16_t leastCm, uint16_t mostCm, uint8_t orientation = 25, uint8_t id = 0, uint8_t type = 0);
  // The distance [cm].
  void set(uint16_t distanceCm);
  // For MissionClient::sendMessage().
  operator OutgoingMessage() const;

 private:
  uint8_t payload_[14];
};

// Where a landing target is, as a camera sees it that looks down, with the top of its picture forwards
// (LANDING_TARGET). ArduPilot takes this form, with `PLND_TYPE` 1. PX4 passes it to its landing target estimator, a
// module that PX4 does not start by itself: add it to PX4's start-up script.
class LandingTarget {
 public:
  // `number`: of the target, if there are several.
  explicit LandingTarget(uint8_t number = 0);
  // The angles from the camera's axis to the target, to the right and downwards in the picture [rad]: a target behind
  // the aircraft is below the middle of the picture, and `downRad` is positive. How far the target is away [m]; 0: not
  // known.
  void set(float rightRad, float downRad, float distanceM = 0);
  // For MissionClient::sendMessage().
  operator OutgoingMessage() const;

 private:
  uint8_t payload_[30];
};

// Where a landing target is, as a position (LANDING_TARGET). Each autopilot takes only one of the two functions below.
// MAVLink 1 has no field for the position: sendMessage() returns false on such a link.
class LandingTargetPosition {
 public:
  // `number`: of the target, if there are several.
  explicit LandingTargetPosition(uint8_t number = 0);
  // For ArduPilot with `PLND_TYPE` 1: seen from the aircraft (MAV_FRAME_BODY_FRD), and the distance, which is the
  // length of these three [m]. ArduPilot ignores a message whose distance is 0.
  void setFromAircraft(float forwardM, float rightM, float downM, float distanceM);
  // For PX4: seen from the origin of its local positions (MAV_FRAME_LOCAL_NED, as LOCAL_POSITION_NED) [m].
  void setFromOrigin(float northM, float eastM, float downM);
  // For MissionClient::sendMessage().
  operator OutgoingMessage() const;

 private:
  void set(uint8_t frame, float x, float y, float z, float distanceM);

  uint8_t payload_[60];
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
