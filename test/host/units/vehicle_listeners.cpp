// What the listeners of Vehicle::fitness(), the wind and the texts make of each message; the names of modes.
#include <doctest/doctest.h>
#include <string.h>

#include <string>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"
#include "mavmission/base/Root.h"
#include "mavmission/telemetry/EstimatorListener.h"
#include "mavmission/telemetry/HealthListener.h"
#include "mavmission/telemetry/TextListener.h"
#include "mavmission/telemetry/VibrationListener.h"
#include "mavmission/telemetry/WindListener.h"

using namespace mavmission;

namespace {

struct Ekf {
  float variances[5];
  uint16_t flags;
};

struct Heard : ClientOnLine {
  HealthListener health;
  EstimatorListener estimator;
  VibrationListener vibration;
  WindListener wind;
  TextListener texts;

  explicit Heard(uint8_t autopilot)
      : ClientOnLine(autopilot),
        health(client, 0),
        estimator(client, 0),
        vibration(client, 0),
        wind(client, 0),
        texts(client) {
    run(3000);
  }

  template <typename Message>
  void tell(uint16_t id, uint8_t crcExtra, const Message& message, size_t length = sizeof(Message)) {
    Bytes payload(length);
    memcpy(payload.data(), &message, length);
    hear(FrameParts(id, payload, crcExtra));
    run(5);
  }
  FitReason ofEkf(uint16_t flags, float variance) {
    tell(193, 71, Ekf{{0.1f, variance, 0.1f, 0.1f, 0.1f}, flags}, 22);
    return estimator.reason();
  }
  FitReason ofEstimator(uint16_t flags, float ratio) {
    mavlink_estimator_status_t message = mavlink_estimator_status_t();
    message.flags = flags;
    message.mag_ratio = ratio;
    tell(230, 163, message);
    return estimator.reason();
  }
  FitReason ofVibration(float x, float z, uint32_t clipping) {
    mavlink_vibration_t message = mavlink_vibration_t();
    message.vibration_x = x;
    message.vibration_z = z;
    message.clipping_1 = clipping;
    tell(241, 90, message);
    return vibration.reason();
  }
  FitReason ofHealth(uint32_t enabled, uint32_t healthy) {
    mavlink_sys_status_t message = mavlink_sys_status_t();
    message.onboard_control_sensors_enabled = enabled;
    message.onboard_control_sensors_health = healthy;
    tell(1, 124, message, 31);
    return health.reason();
  }
  uint16_t fromOf(float toNorth, float toEast) {
    mavlink_wind_cov_t message = mavlink_wind_cov_t();
    message.wind_x = toNorth;
    message.wind_y = toEast;
    tell(231, 105, message);
    return wind.fromDeg();
  }
  std::string text(const char* words, uint16_t id, uint8_t piece) {
    mavlink_statustext_t message = mavlink_statustext_t();
    memcpy(message.text, words, strlen(words));
    message.id = id;
    message.chunk_seq = piece;
    tell(253, 83, message);
    return texts.isNew() ? texts.lastText() : "";
  }
};

std::string nameOf(Firmware firmware, uint8_t type, uint32_t mode) {
  return reinterpret_cast<const char*>(modeName(firmware, type, mode));
}

}  // namespace

TEST_CASE("ArduPilot's estimator knows its place, or the word says why not") {
  Heard desk(ClientOnLine::kArduPilot);
  CHECK((desk.estimator.reason() == FitReason::NotHeard));
  CHECK((desk.ofEkf(0x033F, 0.1f) == FitReason::AllWell));
  CHECK((desk.ofEkf(0x00A7, 0.1f) == FitReason::NoPosition));
  CHECK((desk.ofEkf(0x033B, 0.1f) == FitReason::NoPosition));
  CHECK((desk.ofEkf(0x033E, 0.1f) == FitReason::NoAttitude));
  CHECK((desk.ofEkf(0x073F, 0.1f) == FitReason::NoAttitude));
  CHECK((desk.ofEkf(0x833F, 0.1f) == FitReason::GpsGlitch));
  CHECK((desk.ofEkf(0x033F, 0.8f) == FitReason::Disagreement));
  CHECK(desk.estimator.worstPercent() == 100);
  desk.run(11000);
  CHECK((desk.estimator.reason() == FitReason::NotHeard));
}

TEST_CASE("PX4's estimator has flags and limits of its own") {
  Heard desk(ClientOnLine::kPx4);
  CHECK((desk.ofEstimator(0x033F, 0.5f) == FitReason::AllWell));
  CHECK((desk.ofEstimator(0x033F, 1.0f) == FitReason::Disagreement));
  CHECK(desk.estimator.worstPercent() == 100);
  CHECK((desk.ofEstimator(0x033F | ESTIMATOR_ACCEL_ERROR, 0.5f) == FitReason::Disagreement));
  CHECK((desk.ofEstimator(0x033F | ESTIMATOR_GPS_GLITCH, 0.5f) == FitReason::GpsGlitch));
  CHECK((desk.ofEstimator(0x8000 | 0x033F, 0.5f) == FitReason::AllWell));
  CHECK((desk.ofEstimator(0x0027, 0.5f) == FitReason::NoPosition));
  CHECK((desk.ofEstimator(0, 0.5f) == FitReason::NoAttitude));
  CHECK((desk.ofEstimator(0x033F, 1e6f) == FitReason::Disagreement));
  CHECK(desk.estimator.worstPercent() == 0xFFFF);
}

TEST_CASE("vibration is measured by the accelerometer, and clipping counts when it grows") {
  Heard arduPilot(ClientOnLine::kArduPilot);
  CHECK((arduPilot.ofVibration(29.0f, 1.0f, 5) == FitReason::AllWell));
  CHECK(arduPilot.vibration.worstCmS2() == 2900);
  CHECK((arduPilot.ofVibration(31.0f, 1.0f, 5) == FitReason::Vibration));
  CHECK((arduPilot.ofVibration(1.0f, 1.0f, 6) == FitReason::Clipping));
  Heard px4(ClientOnLine::kPx4);
  CHECK((px4.ofVibration(31.0f, 1.0f, 0) == FitReason::AllWell));
  CHECK((px4.ofVibration(1.0f, 5.0f, 0) == FitReason::Vibration));
}

TEST_CASE("on the ground the autopilot's own checks count") {
  constexpr uint32_t kChecks = MAV_SYS_STATUS_PREARM_CHECK;
  Heard desk(ClientOnLine::kArduPilot);
  CHECK((desk.ofHealth(kChecks, kChecks) == FitReason::AllWell));
  CHECK((desk.ofHealth(kChecks | 8, 0) == FitReason::NotReady));
  CHECK(desk.health.failedSensors() == 8);
  Heard other(ClientOnLine::kOther);
  CHECK((other.ofHealth(0, 0) == FitReason::NotTold));
  CHECK((other.ofHealth(kChecks, kChecks) == FitReason::AllWell));
  Heard px4(ClientOnLine::kPx4);  // it says whether it can be armed, and not that it has such checks
  CHECK((px4.ofHealth(0, 0) == FitReason::NotReady));
  CHECK((px4.ofHealth(MAV_SYS_STATUS_SENSOR_RC_RECEIVER, kChecks) == FitReason::AllWell));
}

TEST_CASE("the wind comes from where it does not blow to") {
  Heard px4(ClientOnLine::kPx4);
  CHECK(px4.fromOf(-5.0f, 0.0f) == 0);
  CHECK(px4.wind.speedCmS() == 500);
  CHECK(px4.fromOf(0.0f, -5.0f) == 90);
  CHECK(px4.fromOf(5.0f, 0.0f) == 180);
  CHECK(px4.fromOf(0.0f, 5.0f) == 270);
  CHECK(px4.fromOf(3.0f, 3.0f) == 225);
  CHECK(px4.fromOf(-3.0f, 3.0f) == 315);
  CHECK(px4.fromOf(1000.0f, 0.0f) == 0);
  CHECK(px4.wind.speedCmS() == 0);
  Heard arduPilot(ClientOnLine::kArduPilot);
  const float from[3] = {-90.0f, 7.0f, 1.0f};
  arduPilot.tell(168, 1, from);
  CHECK(arduPilot.wind.fromDeg() == 270);
  CHECK(arduPilot.wind.speedCmS() == 700);
  CHECK(arduPilot.wind.downCmS() == 100);
}

TEST_CASE("a text in pieces is put together, and what is missing is marked") {
  const std::string full(50, 'a');
  Heard desk(ClientOnLine::kPx4);
  CHECK(desk.text("short", 0, 0) == "short");
  CHECK(desk.text(full.c_str(), 7, 0) == "");
  CHECK(desk.text("end", 7, 1) == full + "end");
  CHECK(desk.text("end", 7, 1) == "");  // the line has repeated it
  CHECK(desk.text("end", 8, 1) == "[...]end");
  CHECK(desk.text(full.c_str(), 9, 0) == "");
  CHECK(desk.text("another", 10, 0) == "another");
  CHECK(desk.text(full.c_str(), 11, 0) == "");
  desk.run(2500);
  CHECK(desk.texts.isNew());
  CHECK(desk.texts.lastText() == full + "[...]");
}

TEST_CASE("each vehicle's modes have its own names") {
  CHECK(nameOf(Firmware::ArduPilot, MAV_TYPE_QUADROTOR, 4) == "GUIDED");
  CHECK(nameOf(Firmware::ArduPilot, MAV_TYPE_QUADROTOR, 8) == "unknown");
  CHECK(nameOf(Firmware::ArduPilot, MAV_TYPE_QUADROTOR, 300) == "unknown");
  CHECK(nameOf(Firmware::ArduPilot, MAV_TYPE_FIXED_WING, 10) == "AUTO");
  CHECK(nameOf(Firmware::ArduPilot, MAV_TYPE_VTOL_TAILSITTER, 17) == "QSTABILIZE");
  CHECK(nameOf(Firmware::ArduPilot, MAV_TYPE_GROUND_ROVER, 4) == "HOLD");
  CHECK(nameOf(Firmware::ArduPilot, MAV_TYPE_SUBMARINE, 19) == "MANUAL");
  CHECK(nameOf(Firmware::ArduPilot, MAV_TYPE_AIRSHIP, 3) == "LOITER");
  CHECK(nameOf(Firmware::ArduPilot, MAV_TYPE_GCS, 0) == "unknown");
  CHECK(nameOf(Firmware::Px4, MAV_TYPE_QUADROTOR, 3ul << 16) == "POSCTL");
  CHECK(nameOf(Firmware::Px4, MAV_TYPE_QUADROTOR, 4ul << 24 | 4ul << 16) == "MISSION");
  CHECK(nameOf(Firmware::Px4, MAV_TYPE_QUADROTOR, 99ul << 24 | 4ul << 16) == "unknown");
  CHECK(nameOf(Firmware::Px4, MAV_TYPE_QUADROTOR, 0) == "unknown");
  CHECK(nameOf(Firmware::Px4, MAV_TYPE_QUADROTOR, 9ul << 16) == "unknown");
  CHECK(nameOf(Firmware::Other, MAV_TYPE_QUADROTOR, 0) == "unknown");
}

TEST_CASE("a square root is rounded down") {
  for (uint32_t root : {0u, 1u, 2u, 500u, 65535u}) CHECK(detail::rootOf(root * root) == root);
  CHECK(detail::rootOf(24) == 4);
}
