// Measurements that the autopilot flies by: obstacles around it, a position like a GPS receiver's, a pose.
#pragma once

#include <stdint.h>

#include "../item/LatLon.h"
#include "../item/Units.h"
#include "../link/OutgoingMessage.h"
#include "../telemetry/GpsListener.h"

namespace mavmission {

// Each is filled by its own functions, and then sent with MissionClient::sendMessage(), as those of PayloadMessages.h:
//
//   ObstacleDistance around(20, 600, 45);
//   for (uint8_t i = 0; i < 8; ++i) around.set(i, measuredCm[i]);
//   autopilot.sendMessage(around);  // false: another frame is still being sent; call it again later
//
// The object must live, and must not be changed, until MissionClient::isSent(). Each autopilot uses such a message only
// if its parameters say so: docs/payload.md has them, and how often the message has to be sent. Numbers are sent as
// they are: a wrong position, or one that stops, is as bad as a broken GPS receiver.

// Distances to obstacles around the aircraft (OBSTACLE_DISTANCE), MAVLink 2 only. Index 0 is straight ahead, and the
// indices go clockwise as seen from above.
class ObstacleDistance {
 public:
  // How many distances there are.
  static constexpr uint8_t kCount = 72;

  // The shortest and the longest distance that the sensor can measure [cm], the longest below 65534. `stepDeg`: from
  // one index to the next [degrees], 5 to 180; less counts as 5, since PX4 reads past the last distance with less.
  // `type`: MAV_DISTANCE_SENSOR, 0 is a laser, 1 ultrasound, 3 radar. At first nothing is known.
  ObstacleDistance(uint16_t leastCm, uint16_t mostCm, uint8_t stepDeg = 5, uint8_t type = 0);
  // The distance [cm] in this direction. An index of kCount or more is ignored.
  void set(uint8_t index, uint16_t distanceCm);
  // It was measured in this direction, and there is no obstacle within reach.
  void setFree(uint8_t index);
  // Nothing is known about this direction; about any of them.
  void setUnknown(uint8_t index);
  void setUnknown();
  // For MissionClient::sendMessage().
  operator OutgoingMessage() const;

 private:
  uint8_t payload_[167];
};

// What a GPS receiver would report (GPS_INPUT): for an indoor positioning system, or a receiver of the sketch's own.
// ArduPilot only. What was not set is marked as not known.
class GpsInput {
 public:
  // `id`: which of the autopilot's receivers it is, from 0 on.
  explicit GpsInput(uint8_t id = 0);
  // Where it is, with its altitude above mean sea level, the kind of fix, and how many satellites are used. ArduPilot
  // flies with ThreeDimensional or better and, by its checks before arming, with 6 satellites or more.
  void set(const LatLon& place, Metres aboveSea, GpsFix fix, uint8_t satellites);
  // The speed over the ground [m/s].
  void setVelocity(float north, float east, float down);
  // The standard deviations: of the place, of the altitude [m], of the speed [m/s].
  void setAccuracy(float place, float altitude, float speed);
  // The dilutions of precision, such as 0.9.
  void setDilution(float horizontal, float vertical);
  // The time of GPS: the week, and the time since its beginning [ms]. Without it, ArduPilot has no date.
  void setTime(uint16_t week, uint32_t msOfWeek);
  // The heading from north, clockwise [1/100 degree], 1 to 36000, which is north; 0: not known. MAVLink 2 only.
  void setHeading(uint16_t cdeg);
  // For MissionClient::sendMessage().
  operator OutgoingMessage() const;

 private:
  void know(uint8_t fields);

  uint8_t payload_[65];
};

// Where the aircraft is by a camera or by another system outside of the autopilot, seen from a fixed origin
// (VISION_POSITION_ESTIMATE).
class VisionPosition {
 public:
  VisionPosition();
  // The position from the origin to the north, the east and downwards [m], and the attitude as Euler angles [rad]: roll
  // to the right, nose up, clockwise from north.
  void set(float north, float east, float down, float roll, float pitch, float yaw);
  // The variances of each coordinate [m2] and of each angle [rad2]; at first they are not known. MAVLink 2 only.
  void setVariance(float position, float angle);
  // Counts one further: to be called when the system outside has jumped to another estimate. MAVLink 2 only.
  void countReset();
  // For MissionClient::sendMessage().
  operator OutgoingMessage() const;

 private:
  uint8_t payload_[117];
};

// The same with velocities, and the attitude as a quaternion (ODOMETRY), MAVLink 2 only.
class Odometry {
 public:
  // `frame`: MAV_FRAME of the position. 20 (LOCAL_FRD): x points wherever the aircraft pointed at the start, y to the
  // right of that, z downwards; ArduPilot takes this one alone, and with its yaw from here treats x as north. 1
  // (LOCAL_NED): north, east, down; PX4 takes both.
  explicit Odometry(uint8_t frame = 20);
  // The position from the origin [m], and the rotation from the aircraft to the frame as a quaternion of length 1.
  void setPose(float x, float y, float z, float qw, float qx, float qy, float qz);
  // The speed forward, to the right and downwards, as seen from the aircraft [m/s]. At first it is not known.
  void setVelocity(float forward, float right, float down);
  // How fast it rolls, pitches and yaws [rad/s]. At first this is not known.
  void setRotation(float roll, float pitch, float yaw);
  // The variances of each coordinate [m2], of each angle [rad2], of each speed [m2/s2]. At first they are not known.
  void setVariance(float position, float angle, float velocity);
  // How good the estimate is [%]: 1 the worst, 100 the best, 0 not known, -1 it has failed. ArduPilot does not use one
  // below `VISO_QUAL_MIN`, PX4 none below `EKF2_EV_QMIN`.
  void setQuality(int8_t percent);
  // Counts one further: to be called when the estimate has jumped.
  void countReset();
  // For MissionClient::sendMessage().
  operator OutgoingMessage() const;

 private:
  uint8_t payload_[233];
};

}  // namespace mavmission
