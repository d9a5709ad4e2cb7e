// The listeners that judge whether an aircraft is fit: at which number the word changes.
#include <doctest/doctest.h>

#include <string>

#include "ToldClient.h"

using namespace mavmission;

namespace {

constexpr uint8_t kArduPilot = ClientOnLine::kArduPilot, kPx4 = ClientOnLine::kPx4;

std::string nameOf(FitReason reason) {
#define MAVMISSION_NAME(name, text) #name,
  static const char* const kNames[] = {MAVMISSION_FIT_REASONS(MAVMISSION_NAME)};
#undef MAVMISSION_NAME
  return kNames[static_cast<uint8_t>(reason)];
}

struct Desk : ToldClient {
  HealthListener health;
  EstimatorListener estimator;
  VibrationListener vibration;
  const std::string estimates;  // the message of its estimator

  explicit Desk(uint8_t autopilot = kArduPilot)
      : ToldClient(autopilot),
        health(client, 0),
        estimator(client, 0),
        vibration(client, 0),
        estimates(autopilot == kArduPilot ? "EKF_STATUS_REPORT" : "ESTIMATOR_STATUS hagl_ratio 5") {
    run(3500);
  }

  // What is said now: "AllWell, 50 %", "Vibration, 3000 cm/s^2", "NotReady, failed 8".
  std::string estimated() const {
    return nameOf(estimator.reason()) + ", " + std::to_string(estimator.worstPercent()) + " %";
  }
  std::string vibrates() const {
    return nameOf(vibration.reason()) + ", " + std::to_string(vibration.worstCmS2()) + " cm/s^2";
  }
  std::string checked() const { return nameOf(health.reason()) + ", failed " + std::to_string(health.failedSensors()); }
  // The same after such a message. All that a place needs is there, unless the flags follow.
  std::string estimated(const std::string& words) {
    tell(estimates + " flags 0x33F " + words);
    return estimated();
  }
  std::string vibrates(const std::string& words) {
    tell("VIBRATION " + words);
    return vibrates();
  }
  std::string checked(uint32_t enabled, uint32_t healthy) {
    tell("SYS_STATUS load 321 onboard_control_sensors_enabled " + std::to_string(enabled) +
         " onboard_control_sensors_health " + std::to_string(healthy));
    return checked();
  }
  void arm() {
    beats = false;
    tell(heartbeatParts(kArduPilot, MAV_MODE_FLAG_SAFETY_ARMED));
  }
};

constexpr uint32_t kChecks = MAV_SYS_STATUS_PREARM_CHECK;

}  // namespace

TEST_CASE("a message says something for 10.000 s, and nothing a millisecond later, or before") {
  Desk desk;
  CHECK(desk.checked() == "NotHeard, failed 0");
  CHECK(desk.estimated() == "NotHeard, 0 %");
  CHECK(desk.vibrates() == "NotHeard, 0 cm/s^2");
  CHECK((desk.vibration.fitness() == Fitness::Unknown));
  desk.estimated("velocity_variance 0.4");
  desk.vibrates("vibration_x 1");
  desk.checked(kChecks, kChecks);
  desk.run(10000 - desk.estimator.ageMs());
  CHECK(desk.estimated() == "AllWell, 50 %");
  CHECK((desk.estimator.fitness() == Fitness::Fit));
  desk.run(1);
  CHECK(desk.estimated() == "NotHeard, 50 %");
  CHECK((desk.estimator.fitness() == Fitness::Unknown));
  CHECK(desk.vibrates() == "AllWell, 100 cm/s^2");
  CHECK(desk.checked() == "AllWell, failed 0");
  desk.run(10000 - desk.vibration.ageMs());
  CHECK(desk.vibrates() == "AllWell, 100 cm/s^2");
  desk.run(1);
  CHECK(desk.vibrates() == "NotHeard, 100 cm/s^2");
  desk.run(10001 - desk.health.ageMs());
  CHECK(desk.checked() == "NotHeard, failed 0");
}

TEST_CASE("the limit of a sensor's disagreement is 0.8 on ArduPilot, and 1.0 on PX4, for each of four sensors") {
  const char* const kSensors[][2] = {{"velocity_variance", "vel_ratio"},
                                     {"pos_horiz_variance", "pos_horiz_ratio"},
                                     {"pos_vert_variance", "pos_vert_ratio"},
                                     {"compass_variance", "mag_ratio"}};
  for (const auto& sensor : kSensors) {
    const std::string arduPilots = std::string(sensor[0]) + " ", px4s = std::string(sensor[1]) + " ";
    Desk arduPilot, px4(kPx4);
    CHECK(arduPilot.estimated(arduPilots + "0.79999995") == "AllWell, 100 %");  // the next smaller float
    CHECK(arduPilot.estimated(arduPilots + "0.8") == "Disagreement, 100 %");
    CHECK(arduPilot.estimated(arduPilots + "0.4") == "AllWell, 50 %");
    CHECK(px4.estimated(px4s + "0.99999994") == "AllWell, 100 %");
    CHECK(px4.estimated(px4s + "1") == "Disagreement, 100 %");
    CHECK(px4.estimated(px4s + "0.4") == "AllWell, 40 %");
  }
}

TEST_CASE("an estimator knows its place, or the word says why not, by flags and limits of each autopilot") {
  const struct {
    uint8_t autopilot;
    const char *words, *says;
  } kRows[] = {
      {kArduPilot, "terrain_alt_variance 5", "AllWell, 0 %"},  // the height of the ground is not judged
      {kArduPilot, "flags 0x00A7", "NoPosition, 0 %"},
      {kArduPilot, "flags 0x033B", "NoPosition, 0 %"},
      {kArduPilot, "flags 0x033E", "NoAttitude, 0 %"},
      {kArduPilot, "flags 0x073F", "NoAttitude, 0 %"},
      {kArduPilot, "flags 0x833F", "GpsGlitch, 0 %"},
      {kPx4, "flags 0x0B3F", "Disagreement, 0 %"},  // ESTIMATOR_ACCEL_ERROR
      {kPx4, "flags 0x073F", "GpsGlitch, 0 %"},
      {kPx4, "flags 0x833F", "AllWell, 0 %"},
      {kPx4, "flags 0x0027", "NoPosition, 0 %"},
      {kPx4, "flags 0", "NoAttitude, 0 %"},
      // Up to 65535 %, and one without end is the same.
      {kPx4, "vel_ratio 655.33", "Disagreement, 65533 %"},
      {kPx4, "vel_ratio 655.35", "Disagreement, 65535 %"},
      {kPx4, "vel_ratio 655.36", "Disagreement, 65535 %"},
      {kPx4, "vel_ratio 655.37", "Disagreement, 65535 %"},
      {kPx4, "vel_ratio 1e9", "Disagreement, 65535 %"},
      {kPx4, "vel_ratio inf", "Disagreement, 65535 %"},
      // A number that is none, or below 0, is left out.
      {kPx4, "vel_ratio nan pos_horiz_ratio -nan pos_vert_ratio -5 mag_ratio 0.25", "AllWell, 25 %"},
  };
  for (const auto& row : kRows) CHECK(Desk(row.autopilot).estimated(row.words) == row.says);
  // The first one after infinity is none, either.
  Desk desk(kPx4);
  FrameParts parts = messageParts("ESTIMATOR_STATUS vel_ratio inf mag_ratio 0.25 flags 0x33F");
  parts.payload[offsetof(mavlink_estimator_status_t, vel_ratio)] = 1;
  desk.tell(parts);
  CHECK(desk.estimated() == "AllWell, 25 %");
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
    const std::string failed = ", failed " + std::to_string(bit == kChecks ? 0 : bit);
    CHECK(desk.checked(bit, ~bit) == (isNeeded ? "SensorFailed" : "AllWell") + failed);
    CHECK((desk.health.fitness() == (isNeeded ? Fitness::Unfit : Fitness::Fit)));
    CHECK(desk.checked(bit, bit) == "AllWell, failed 0");
    CHECK(desk.checked(0, ~bit) == "AllWell, failed 0");  // it is not in use
  }
}

TEST_CASE("on the ground the autopilot's own checks count, and arming is seen at once") {
  Desk desk;
  CHECK(desk.checked(kChecks, kChecks) == "AllWell, failed 0");
  CHECK(desk.checked(kChecks | 8, 0) == "NotReady, failed 8");
  CHECK(desk.checked(MAV_SYS_STATUS_SENSOR_GPS, kChecks) == "AllWell, failed 32");
  CHECK(desk.health.loadPermille() == 321);
  desk.arm();
  CHECK(desk.checked() == "SensorFailed, failed 32");
  CHECK(desk.checked(MAV_SYS_STATUS_SENSOR_GPS, MAV_SYS_STATUS_SENSOR_GPS) == "AllWell, failed 0");
  Desk other(ClientOnLine::kOther);
  CHECK(other.checked(0, 0) == "NotTold, failed 0");
  CHECK(other.checked(kChecks, kChecks) == "AllWell, failed 0");
  Desk px4(kPx4);  // it says whether it can be armed, and not that it has such checks
  CHECK(px4.checked(0, 0) == "NotReady, failed 0");
  CHECK(px4.checked(MAV_SYS_STATUS_SENSOR_RC_RECEIVER, kChecks) == "AllWell, failed 65536");
}

TEST_CASE("ArduPilot's limit of the vibration is 30 m/s^2 on each axis, PX4's 4.9 m/s^2 on one") {
  for (const std::string axis : {"vibration_x", "vibration_y", "vibration_z"}) {
    const std::string is = "vibration_x 1 vibration_y 1 vibration_z 1 " + axis + " ";
    Desk arduPilot, px4(kPx4);
    CHECK(arduPilot.vibrates(is + "29.999998") == "AllWell, 3000 cm/s^2");
    CHECK(arduPilot.vibrates(is + "30") == "Vibration, 3000 cm/s^2");
    CHECK((arduPilot.vibration.fitness() == Fitness::Unfit));
    const bool isJudged = axis == "vibration_z";
    CHECK(px4.vibrates(is + "4.8999996") == (isJudged ? "AllWell, 490 cm/s^2" : "AllWell, 100 cm/s^2"));
    CHECK(px4.vibrates(is + "4.9") == (isJudged ? "Vibration, 490 cm/s^2" : "AllWell, 100 cm/s^2"));
    CHECK(arduPilot.vibrates(is + "21474836") == "Vibration, 2147483600 cm/s^2");
    CHECK(arduPilot.vibrates(is + "21474838") == "Vibration, 2147483647 cm/s^2");
    CHECK(arduPilot.vibrates(is + "inf") == "Vibration, 2147483647 cm/s^2");
  }
}

TEST_CASE("a count of clipping is no vibration, and counts where it grows") {
  for (uint8_t autopilot : {kArduPilot, kPx4}) {
    Desk desk(autopilot);
    const std::string shakes = "vibration_x 1 vibration_y 1 vibration_z 1 ";
    const std::string big = shakes + "clipping_0 0x42000000 clipping_1 7 clipping_2 ";  // as a float it would be 32
    CHECK(desk.vibrates(big + "2") == "AllWell, 100 cm/s^2");
    CHECK(desk.vibration.clipping() == 0x42000000u + 9);
    CHECK(desk.vibrates(big + "2") == "AllWell, 100 cm/s^2");
    CHECK(desk.vibrates(big + "3") == "Clipping, 100 cm/s^2");
    CHECK(desk.vibrates(big + "3") == "AllWell, 100 cm/s^2");
    CHECK(desk.vibrates(shakes + "clipping_1 1") == "AllWell, 100 cm/s^2");  // it has restarted
    CHECK(desk.vibrates("vibration_z 40 clipping_1 2") == "Clipping, 4000 cm/s^2");
  }
}
