// The listeners that judge whether an aircraft is fit: at which number the word changes.
#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>
#include <limits>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

constexpr uint16_t kGood = 0x033F;  // all that a place needs
constexpr float kInfinity = std::numeric_limits<float>::infinity(), kNan = std::numeric_limits<float>::quiet_NaN();
constexpr uint8_t kArmed = 128;

// The next smaller float.
float below(float value) {
  uint32_t bits;
  memcpy(&bits, &value, sizeof(bits));
  --bits;
  memcpy(&value, &bits, sizeof(value));
  return value;
}

struct Desk : ClientOnLine {
  HealthListener health;
  EstimatorListener estimator;
  VibrationListener vibration;

  explicit Desk(uint8_t autopilot = kArduPilot)
      : ClientOnLine(autopilot), health(client, 0), estimator(client, 0), vibration(client, 0) {
    run(3500);
  }

  template <typename Message>
  void tell(uint16_t id, uint8_t crcExtra, const Message& message, size_t length = sizeof(Message)) {
    Bytes payload(length);
    memcpy(payload.data(), &message, length);
    hear(FrameParts(id, payload, crcExtra));
    while (!line.toRead.empty()) run(1);
  }
  // EKF_STATUS_REPORT: velocity, place across, height, compass, height of the ground.
  FitReason ekf(std::initializer_list<float> variances, uint16_t flags = kGood) {
    uint8_t payload[22] = {};
    memcpy(payload, variances.begin(), variances.size() * sizeof(float));
    memcpy(payload + 20, &flags, sizeof(flags));
    tell(193, 71, payload);
    return estimator.reason();
  }
  // ESTIMATOR_STATUS: velocity, place, height, compass.
  FitReason status(std::initializer_list<float> ratios, uint16_t flags = kGood) {
    mavlink_estimator_status_t message = mavlink_estimator_status_t();
    float four[4] = {};
    memcpy(four, ratios.begin(), ratios.size() * sizeof(float));
    message.vel_ratio = four[0];
    message.pos_horiz_ratio = four[1];
    message.pos_vert_ratio = four[2];
    message.mag_ratio = four[3];
    message.hagl_ratio = 5;  // over the ground: not what is judged
    message.flags = flags;
    tell(MAVLINK_MSG_ID_ESTIMATOR_STATUS, MAVLINK_MSG_ID_ESTIMATOR_STATUS_CRC, message);
    return estimator.reason();
  }
  FitReason vibrate(float x, float y, float z, uint32_t clipping0 = 0, uint32_t clipping1 = 0, uint32_t clipping2 = 0) {
    mavlink_vibration_t message = mavlink_vibration_t();
    message.vibration_x = x;
    message.vibration_y = y;
    message.vibration_z = z;
    message.clipping_0 = clipping0;
    message.clipping_1 = clipping1;
    message.clipping_2 = clipping2;
    tell(MAVLINK_MSG_ID_VIBRATION, MAVLINK_MSG_ID_VIBRATION_CRC, message);
    return vibration.reason();
  }
  FitReason sensors(uint32_t enabled, uint32_t healthy, uint16_t load = 0) {
    mavlink_sys_status_t message = mavlink_sys_status_t();
    message.onboard_control_sensors_enabled = enabled;
    message.onboard_control_sensors_health = healthy;
    message.load = load;
    tell(MAVLINK_MSG_ID_SYS_STATUS, MAVLINK_MSG_ID_SYS_STATUS_CRC, message, MAVLINK_MSG_ID_SYS_STATUS_MIN_LEN);
    return health.reason();
  }
  void arm() {
    beats = false;
    hear(heartbeatParts(kArduPilot, kArmed));
    run(1);
  }
};

}  // namespace

TEST_CASE("a message says something for 10.000 s, and nothing a millisecond later") {
  Desk desk;
  CHECK((desk.ekf({0.1f}) == FitReason::AllWell));
  CHECK((desk.vibrate(1, 1, 1) == FitReason::AllWell));
  CHECK((desk.sensors(MAV_SYS_STATUS_PREARM_CHECK, MAV_SYS_STATUS_PREARM_CHECK) == FitReason::AllWell));
  desk.run(9998);
  CHECK(desk.estimator.ageMs() == 10000);
  CHECK((desk.estimator.reason() == FitReason::AllWell));
  CHECK((desk.estimator.fitness() == Fitness::Fit));
  desk.run(1);
  CHECK((desk.estimator.reason() == FitReason::NotHeard));
  CHECK((desk.estimator.fitness() == Fitness::Unknown));
  CHECK((desk.vibration.reason() == FitReason::AllWell));
  desk.run(1);
  CHECK((desk.vibration.reason() == FitReason::NotHeard));
  CHECK((desk.health.reason() == FitReason::AllWell));
  desk.run(1);
  CHECK((desk.health.reason() == FitReason::NotHeard));
}

TEST_CASE("a listener that has heard nothing says so, and judges nothing") {
  Desk desk;
  CHECK((desk.health.reason() == FitReason::NotHeard));
  CHECK((desk.estimator.reason() == FitReason::NotHeard));
  CHECK((desk.vibration.reason() == FitReason::NotHeard));
  CHECK((desk.vibration.fitness() == Fitness::Unknown));
}

TEST_CASE("the limit of a sensor's disagreement is 0.8 on ArduPilot, and 1.0 on PX4, for each of four sensors") {
  for (size_t sensor = 0; sensor < 4; ++sensor) {
    CAPTURE(sensor);
    float variances[4] = {};
    Desk arduPilot, px4(ClientOnLine::kPx4);
    const auto say = [&](bool isPx4, float value) {
      variances[sensor] = value;
      const std::initializer_list<float> all = {variances[0], variances[1], variances[2], variances[3]};
      return isPx4 ? px4.status(all) : arduPilot.ekf(all);
    };
    CHECK((say(false, below(0.8f)) == FitReason::AllWell));
    CHECK((say(false, 0.8f) == FitReason::Disagreement));
    CHECK(arduPilot.estimator.worstPercent() == 100);
    CHECK((say(false, 0.4f) == FitReason::AllWell));
    CHECK(arduPilot.estimator.worstPercent() == 50);
    CHECK((say(true, below(1.0f)) == FitReason::AllWell));
    CHECK((say(true, 1.0f) == FitReason::Disagreement));
    CHECK(px4.estimator.worstPercent() == 100);
    CHECK((say(true, 0.4f) == FitReason::AllWell));
    CHECK(px4.estimator.worstPercent() == 40);
  }
  Desk desk;
  CHECK((desk.ekf({0, 0, 0, 0, 5}) == FitReason::AllWell));  // the height of the ground is not judged
  CHECK(desk.estimator.worstPercent() == 0);
}

TEST_CASE("a disagreement is given up to 65535 %, and one without end is the same") {
  const struct {
    float ratio;
    uint16_t percent;
  } kRatios[] = {{655.33f, 65533}, {655.35f, 65535}, {655.36f, 65535},
                 {655.37f, 65535}, {1e9f, 65535},    {kInfinity, 65535}};
  for (const auto& one : kRatios) {
    CAPTURE(one.ratio);
    Desk desk(ClientOnLine::kPx4);
    CHECK((desk.status({one.ratio}) == FitReason::Disagreement));
    CHECK(desk.estimator.worstPercent() == one.percent);
  }
}

TEST_CASE("a number that is none, or below 0, is left out") {
  Desk desk(ClientOnLine::kPx4);
  uint32_t bits = 0x7F800001;  // the first one after infinity
  float first;
  memcpy(&first, &bits, sizeof(first));
  CHECK((desk.status({first, kNan, -5.0f, 0.25f}) == FitReason::AllWell));
  CHECK(desk.estimator.worstPercent() == 25);
}

TEST_CASE("an armed aircraft is unfit with a failed sensor that it needs, and only then") {
  for (uint32_t bit = 1; bit != 0; bit <<= 1) {
    CAPTURE(bit);
    constexpr uint32_t kNeeded = MAV_SYS_STATUS_SENSOR_3D_GYRO | MAV_SYS_STATUS_SENSOR_3D_ACCEL |
                                 MAV_SYS_STATUS_SENSOR_3D_MAG | MAV_SYS_STATUS_SENSOR_ABSOLUTE_PRESSURE |
                                 MAV_SYS_STATUS_SENSOR_GPS | MAV_SYS_STATUS_AHRS | MAV_SYS_STATUS_SENSOR_BATTERY |
                                 MAV_SYS_STATUS_SENSOR_MOTOR_OUTPUTS | MAV_SYS_STATUS_SENSOR_PROPULSION;
    Desk desk;
    desk.arm();
    const bool isNeeded = (bit & kNeeded) != 0;
    CHECK((desk.sensors(bit, ~bit) == (isNeeded ? FitReason::SensorFailed : FitReason::AllWell)));
    CHECK((desk.health.fitness() == (isNeeded ? Fitness::Unfit : Fitness::Fit)));
    CHECK((desk.health.failedSensors() == (bit == MAV_SYS_STATUS_PREARM_CHECK ? 0 : bit)));
    CHECK((desk.sensors(bit, bit) == FitReason::AllWell));
    CHECK((desk.sensors(0, ~bit) == FitReason::AllWell));  // it is not in use
  }
}

TEST_CASE("a disarmed aircraft's failed sensor is a matter of its checks, and arming is seen at once") {
  Desk desk;
  CHECK((desk.sensors(MAV_SYS_STATUS_SENSOR_GPS, MAV_SYS_STATUS_PREARM_CHECK, 321) == FitReason::AllWell));
  CHECK(desk.health.loadPermille() == 321);
  desk.arm();
  CHECK((desk.health.reason() == FitReason::SensorFailed));
  CHECK((desk.sensors(MAV_SYS_STATUS_SENSOR_GPS, MAV_SYS_STATUS_SENSOR_GPS) == FitReason::AllWell));
}

TEST_CASE("ArduPilot's limit of the vibration is 30 m/s^2 on each axis, PX4's 4.9 m/s^2 on one") {
  for (size_t axis = 0; axis < 3; ++axis) {
    CAPTURE(axis);
    const auto vibrate = [axis](Desk& desk, float value) {
      return desk.vibrate(axis == 0 ? value : 1, axis == 1 ? value : 1, axis == 2 ? value : 1);
    };
    Desk arduPilot, px4(ClientOnLine::kPx4);
    CHECK((vibrate(arduPilot, below(30.0f)) == FitReason::AllWell));
    CHECK((vibrate(arduPilot, 30.0f) == FitReason::Vibration));
    CHECK(arduPilot.vibration.worstCmS2() == 3000);
    CHECK((arduPilot.vibration.fitness() == Fitness::Unfit));
    CHECK((vibrate(px4, below(4.9f)) == FitReason::AllWell));
    CHECK((vibrate(px4, 4.9f) == (axis == 2 ? FitReason::Vibration : FitReason::AllWell)));
    CHECK(px4.vibration.worstCmS2() == (axis == 2 ? 490 : 100));
    vibrate(arduPilot, 21474836.0f);
    CHECK(arduPilot.vibration.worstCmS2() == 2147483600);
    for (const float endless : {21474838.0f, kInfinity}) {
      CHECK((vibrate(arduPilot, endless) == FitReason::Vibration));
      CHECK(arduPilot.vibration.worstCmS2() == INT32_MAX);
    }
  }
}

TEST_CASE("a count of clipping is no vibration, and counts where it grows") {
  for (uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    Desk desk(autopilot);
    CHECK((desk.vibrate(1, 1, 1, 0x42000000, 7, 2) == FitReason::AllWell));  // as a float it would be 32
    CHECK(desk.vibration.worstCmS2() == 100);
    CHECK(desk.vibration.clipping() == 0x42000000u + 9);
    CHECK((desk.vibrate(1, 1, 1, 0x42000000, 7, 2) == FitReason::AllWell));
    CHECK((desk.vibrate(1, 1, 1, 0x42000000, 7, 3) == FitReason::Clipping));
    CHECK((desk.vibrate(1, 1, 1, 0x42000000, 7, 3) == FitReason::AllWell));
    CHECK((desk.vibrate(1, 1, 1, 0, 1, 0) == FitReason::AllWell));  // it has restarted
    CHECK((desk.vibrate(40, 1, 40, 0, 2, 0) == FitReason::Clipping));
  }
}
