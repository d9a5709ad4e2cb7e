// The listeners of telemetry: what they say before their message has come, and at the edges of its fields.
#include <doctest/doctest.h>
#include <math.h>
#include <string.h>

#include <initializer_list>
#include <limits>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

constexpr uint32_t kNeverHeard = 0xFFFFFFFF;  // as the headers say it

// A client with one listener, which requests nothing.
template <typename Listener>
struct With : ClientOnLine {
  Listener listener;

  // The clock wraps half a second later.
  explicit With(uint8_t autopilot = kArduPilot) : ClientOnLine(autopilot, 0u - 4000u), listener(client, 0) {
    run(3500);
  }

  // As a frame of MAVLink 1 it has `lengthV1` bytes.
  template <typename Message>
  void tell(uint16_t id, uint8_t crcExtra, const Message& message, size_t lengthV1 = 0) {
    Bytes payload(lengthV1 != 0 ? lengthV1 : sizeof(Message));
    memcpy(payload.data(), &message, payload.size());
    FrameParts parts(id, payload, crcExtra);
    parts.version = lengthV1 != 0 ? 1 : 2;
    hear(parts);
    while (!line.toRead.empty()) run(1);  // an update() reads 64 bytes
  }
};

// A message, whatever it says, is new once, and its age counts from when it came.
template <typename Listener, typename Message>
void checkNews(uint16_t id, uint8_t crcExtra, const Message& message, uint8_t autopilot = ClientOnLine::kArduPilot) {
  CAPTURE(id);
  With<Listener> desk(autopilot);
  CHECK_FALSE(desk.listener.isHeard());
  CHECK_FALSE(desk.listener.isNew());
  CHECK(desk.listener.ageMs() == kNeverHeard);
  desk.tell(id, crcExtra, message);
  CHECK(desk.listener.isHeard());
  CHECK(desk.listener.ageMs() == 0);
  CHECK(desk.listener.isNew());
  CHECK_FALSE(desk.listener.isNew());
  desk.run(1234);
  CHECK(desk.listener.ageMs() == 1234);
  CHECK_FALSE(desk.listener.isNew());
  desk.tell(id, crcExtra, message);
  CHECK(desk.listener.ageMs() == 0);
  CHECK(desk.listener.isNew());
}

#define CHECK_NEWS(Listener, NAME, message) \
  checkNews<Listener, message>(MAVLINK_MSG_ID_##NAME, MAVLINK_MSG_ID_##NAME##_CRC, message())

template <typename Listener>
void checkBeginning() {
  ClientOnLine line(ClientOnLine::kArduPilot);
  Listener listener(line.client, 1000);
  CHECK_FALSE(listener.isHeard());
  CHECK_FALSE(listener.isNew());
  CHECK_FALSE(listener.isConfirmed());
  CHECK(listener.ageMs() == kNeverHeard);
}

}  // namespace

TEST_CASE("before anything is heard nothing is, nor is it new, or confirmed") {
  checkBeginning<AttitudeListener>();
  checkBeginning<EstimatorListener>();
  checkBeginning<WindListener>();
}

TEST_CASE("each message is new once, and has an age") {
  CHECK_NEWS(AttitudeListener, ATTITUDE, mavlink_attitude_t);
  CHECK_NEWS(BatteryListener, BATTERY_STATUS, mavlink_battery_status_t);
  CHECK_NEWS(GpsListener, GPS_RAW_INT, mavlink_gps_raw_int_t);
  CHECK_NEWS(HealthListener, SYS_STATUS, mavlink_sys_status_t);
  CHECK_NEWS(HudListener, VFR_HUD, mavlink_vfr_hud_t);
  CHECK_NEWS(PositionListener, GLOBAL_POSITION_INT, mavlink_global_position_int_t);
  CHECK_NEWS(RcListener, RC_CHANNELS, mavlink_rc_channels_t);
  CHECK_NEWS(VibrationListener, VIBRATION, mavlink_vibration_t);
  CHECK_NEWS(WaypointListener, NAV_CONTROLLER_OUTPUT, mavlink_nav_controller_output_t);
  CHECK_NEWS(EstimatorListener, ESTIMATOR_STATUS, mavlink_estimator_status_t);
  CHECK_NEWS(WindListener, WIND_COV, mavlink_wind_cov_t);
}

TEST_CASE("numbers of a message that has not come are 0") {
  CHECK(With<AttitudeListener>().listener.pitch().e7() == 0);
  CHECK(With<AttitudeListener>().listener.yaw().e7() == 0);
  CHECK(With<GpsListener>().listener.aboveSeaLevelMm() == 0);
  CHECK(With<HealthListener>().listener.failedSensors() == 0);
  CHECK(With<HealthListener>().listener.loadPermille() == 0);
  CHECK(With<WaypointListener>().listener.bearingDeg() == 0);
  CHECK(With<WaypointListener>().listener.crossTrackCm() == 0);
  CHECK(With<EstimatorListener>().listener.flags() == 0);
  CHECK(With<EstimatorListener>().listener.worstPercent() == 0);
  CHECK(With<VibrationListener>().listener.clipping() == 0);
  CHECK(With<VibrationListener>().listener.worstCmS2() == 0);
  With<HudListener> hud;
  CHECK(hud.listener.airspeedCmS() == 0);
  CHECK(hud.listener.groundSpeedCmS() == 0);
  CHECK(hud.listener.headingDeg() == 0);
  CHECK(hud.listener.throttlePercent() == 0);
  With<PositionListener> position;
  CHECK(position.listener.northCmS() == 0);
  CHECK(position.listener.eastCmS() == 0);
  CHECK(position.listener.downCmS() == 0);
  With<WindListener> wind;
  CHECK(wind.listener.speedCmS() == 0);
  CHECK(wind.listener.fromDeg() == 0);
  CHECK(wind.listener.downCmS() == 0);
}

TEST_CASE("half a turn is 180 degrees to the last digit, to either side") {
  With<AttitudeListener> desk;
  mavlink_attitude_t message = mavlink_attitude_t();
  message.roll = 3.14159265f;
  message.yaw = -3.14159265f;
  desk.tell(MAVLINK_MSG_ID_ATTITUDE, MAVLINK_MSG_ID_ATTITUDE_CRC, message);
  CHECK(desk.listener.roll().e7() == 1800000000);
  CHECK(desk.listener.yaw().e7() == -1800000000);
}

TEST_CASE("how fast an aircraft turns does not matter to its attitude") {
  // What lies after the listener's own bytes stays as it is.
  struct Guarded : AttitudeListener {
    uint8_t behind = 0x5A;
    Guarded(MissionClient& client, uint16_t intervalMs) : AttitudeListener(client, intervalMs) {}
  };
  With<Guarded> desk;
  mavlink_attitude_t message = mavlink_attitude_t();
  message.roll = 3.14159265f;
  message.rollspeed = std::numeric_limits<float>::quiet_NaN();
  const uint32_t odd = 0x7FC00011;  // no number, either
  memcpy(&message.rollspeed, &odd, sizeof(odd));
  desk.tell(MAVLINK_MSG_ID_ATTITUDE, MAVLINK_MSG_ID_ATTITUDE_CRC, message);
  CHECK(desk.listener.isNew());
  CHECK(desk.listener.roll().e7() == 1800000000);
  CHECK(desk.listener.behind == 0x5A);
}

TEST_CASE("what follows the cells of a battery is no voltage") {
  With<BatteryListener> desk;
  mavlink_battery_status_t message = mavlink_battery_status_t();
  message.voltages_ext[3] = 1000;
  message.mode = 2;
  message.fault_bitmask = 0x55555555;
  desk.tell(MAVLINK_MSG_ID_BATTERY_STATUS, MAVLINK_MSG_ID_BATTERY_STATUS_CRC, message);
  CHECK(desk.listener.voltageMv() == 1000);
}

TEST_CASE("a place on the equator, or on the meridian of Greenwich, is one") {
  for (bool isOnEquator : {true, false}) {
    With<PositionListener> desk;
    mavlink_global_position_int_t message = mavlink_global_position_int_t();
    (isOnEquator ? message.lon : message.lat) = 1;
    desk.tell(MAVLINK_MSG_ID_GLOBAL_POSITION_INT, MAVLINK_MSG_ID_GLOBAL_POSITION_INT_CRC, message);
    CHECK(desk.listener.hasPlace());
  }
}

TEST_CASE("the dialect's messages come over MAVLink 1 as well") {
  With<WindListener> wind;
  const float message[3] = {90.0f, 7.0f, 1.0f};
  wind.tell(168, 1, message, sizeof(message));
  CHECK(wind.listener.fromDeg() == 90);
  CHECK(wind.listener.speedCmS() == 700);
  With<EstimatorListener> estimator;
  struct {
    float variances[5];
    uint16_t flags;
  } report = {{0.1f, 0.4f, 0.1f, 0.1f, 0.1f}, 0x033F};
  estimator.tell(193, 71, report, 22);
  CHECK(estimator.listener.isHeard());
  CHECK(estimator.listener.flags() == 0x033F);
  CHECK(estimator.listener.worstPercent() == 50);
}

TEST_CASE("the faintest wind has a direction, too") {
  With<WindListener> desk(ClientOnLine::kPx4);
  const struct {
    float toNorth, toEast;
    uint16_t from;
  } kWinds[] = {{0.01f, 0, 180}, {-0.01f, 0, 0}, {0, 0.01f, 270}, {0, -0.01f, 90}};
  for (const auto& one : kWinds) {
    mavlink_wind_cov_t message = mavlink_wind_cov_t();
    message.wind_x = one.toNorth;
    message.wind_y = one.toEast;
    desk.tell(MAVLINK_MSG_ID_WIND_COV, MAVLINK_MSG_ID_WIND_COV_CRC, message);
    CHECK(desk.listener.fromDeg() == one.from);
    CHECK(desk.listener.speedCmS() == 1);
  }
}

TEST_CASE("a wind's direction is right to within a degree, wherever it comes from") {
  With<WindListener> desk(ClientOnLine::kPx4);
  for (int tenths = 0; tenths < 3600; ++tenths) {
    const double from = tenths / 10.0, radians = from * 3.14159265358979 / 180;
    mavlink_wind_cov_t message = mavlink_wind_cov_t();
    message.wind_x = static_cast<float>(-200 * cos(radians));
    message.wind_y = static_cast<float>(-200 * sin(radians));
    desk.tell(MAVLINK_MSG_ID_WIND_COV, MAVLINK_MSG_ID_WIND_COV_CRC, message);
    const double off = fabs(desk.listener.fromDeg() - from);
    CAPTURE(from);
    CHECK((off > 180 ? 360 - off : off) <= 1);
  }
}

TEST_CASE("a radio's status is new once, and has an age") {
  ClientOnLine line(ClientOnLine::kArduPilot);
  RadioListener radio(line.client);
  CHECK(radio.ageMs() == kNeverHeard);
  CHECK(RadioListener::kNeverHeard + 0 == kNeverHeard);
  CHECK(TelemetryListener::kNeverHeard + 0 == kNeverHeard);
  FrameParts parts(MAVLINK_MSG_ID_RADIO_STATUS, Bytes(9, 1), MAVLINK_MSG_ID_RADIO_STATUS_CRC);
  parts.version = 1;
  line.hear(parts);
  line.run(1);
  CHECK(radio.ageMs() == 0);
  CHECK(radio.isNew());
  line.run(777);
  CHECK(radio.ageMs() == 777);
  CHECK_FALSE(radio.isNew());
}
