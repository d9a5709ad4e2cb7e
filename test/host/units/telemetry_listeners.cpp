// When a telemetry listener requests its message, and what the listeners make of theirs.
#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>
#include <limits>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"
#include "mavmission/telemetry/AttitudeListener.h"
#include "mavmission/telemetry/BatteryListener.h"
#include "mavmission/telemetry/EstimatorListener.h"
#include "mavmission/telemetry/GpsListener.h"
#include "mavmission/telemetry/HealthListener.h"
#include "mavmission/telemetry/HudListener.h"
#include "mavmission/telemetry/PositionListener.h"
#include "mavmission/telemetry/RadioListener.h"
#include "mavmission/telemetry/RcListener.h"
#include "mavmission/telemetry/VibrationListener.h"
#include "mavmission/telemetry/WaypointListener.h"
#include "mavmission/telemetry/WindListener.h"

using namespace mavmission;

namespace {

typedef std::vector<uint32_t> Times;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr uint8_t kAccepted = 0, kDenied = 2;

struct Desk : ClientOnLine {
  explicit Desk(uint8_t autopilot = kArduPilot) : ClientOnLine(autopilot) {}

  template <typename Message>
  void tell(uint16_t id, uint8_t crcExtra, const Message& message, uint8_t systemId = 1) {
    Bytes payload(sizeof(Message));
    memcpy(payload.data(), &message, sizeof(Message));
    FrameParts parts(id, payload, crcExtra);
    parts.systemId = systemId;
    hear(parts);
    run(5);
  }

  // The answer to a SET_MESSAGE_INTERVAL.
  void answer(uint8_t result) {
    mavlink_command_ack_t ack = mavlink_command_ack_t();
    ack.command = MAV_CMD_SET_MESSAGE_INTERVAL;
    ack.result = result;
    ack.target_system = 1;
    ack.target_component = 191;
    tell(MAVLINK_MSG_ID_COMMAND_ACK, MAVLINK_MSG_ID_COMMAND_ACK_CRC, ack);
  }

  // The seconds at which requests leave in this time, with the message each `everyMs` where that is not 0.
  Times requests(uint32_t seconds) {
    Times times;
    for (uint32_t second = 0; second < seconds; ++second) {
      sent.clear();
      run(1000);
      for (const SentFrame& frame : sent) {
        if (frame.messageId == MAVLINK_MSG_ID_COMMAND_LONG) times.push_back(second);
      }
    }
    return times;
  }
};

mavlink_command_long_t commandOf(const SentFrame& frame) {
  mavlink_command_long_t command;
  memcpy(&command, frame.payload.data(), sizeof(command));
  return command;
}

struct Attitude : Desk {
  AttitudeListener listener;

  explicit Attitude(uint16_t intervalMs, uint8_t autopilot = kArduPilot)
      : Desk(autopilot), listener(client, intervalMs) {}

  void come(float roll = 0.1f, float pitch = 0.2f, float yaw = 0.3f, uint8_t systemId = 1) {
    mavlink_attitude_t message = mavlink_attitude_t();
    message.roll = roll;
    message.pitch = pitch;
    message.yaw = yaw;
    tell(MAVLINK_MSG_ID_ATTITUDE, MAVLINK_MSG_ID_ATTITUDE_CRC, message, systemId);
  }
};

}  // namespace

// --- The request

TEST_CASE("a message is requested at its interval, as soon as the autopilot is known") {
  Attitude desk(250);
  REQUIRE(desk.runUntilSent(MAVLINK_MSG_ID_COMMAND_LONG, 5000));
  const mavlink_command_long_t command = commandOf(desk.sent.back());
  CHECK((command.command == MAV_CMD_SET_MESSAGE_INTERVAL));
  CHECK((command.param1 == MAVLINK_MSG_ID_ATTITUDE));
  CHECK((command.param2 == 250000));
  CHECK((command.confirmation == 0));
  CHECK((command.target_system == 1));
  CHECK((command.target_component == 1));
  CHECK_FALSE(desk.listener.isConfirmed());
  desk.answer(kAccepted);
  CHECK(desk.listener.isConfirmed());
  CHECK_FALSE(desk.listener.isHeard());
}

TEST_CASE("with an interval of 0 nothing is requested, and what comes is taken") {
  Attitude desk(0);
  CHECK(desk.requests(200).empty());
  desk.come();
  CHECK(desk.listener.isHeard());
}

TEST_CASE("a request without an answer is repeated after 2, 4, 8 s and so on, at most a minute") {
  Attitude desk(1000);
  REQUIRE(desk.runUntilSent(MAVLINK_MSG_ID_COMMAND_LONG, 5000));
  const Times times = desk.requests(300);
  REQUIRE(times.size() >= 8);
  CHECK(times[0] <= 2);
  const uint32_t pauses[] = {4, 8, 16, 32, 64, 64, 64};
  for (size_t i = 0; i < 7; ++i) CHECK(times[i + 1] - times[i] == pauses[i]);
}

TEST_CASE("a request that is refused is repeated in the same way") {
  Attitude desk(1000);
  REQUIRE(desk.runUntilSent(MAVLINK_MSG_ID_COMMAND_LONG, 5000));
  desk.answer(kDenied);
  CHECK_FALSE(desk.listener.isConfirmed());
  REQUIRE(desk.runUntilSent(MAVLINK_MSG_ID_COMMAND_LONG, 2500));
  desk.answer(kDenied);
  CHECK(desk.requests(3).empty());
  CHECK(desk.requests(2).size() == 1);
}

TEST_CASE("a confirmed message that does not come is requested again when it is twice late, and 3 s more") {
  for (uint16_t intervalMs : {200, 1000, 2500, 5000}) {
    CAPTURE(intervalMs);
    Attitude desk(intervalMs);
    REQUIRE(desk.runUntilSent(MAVLINK_MSG_ID_COMMAND_LONG, 5000));
    desk.answer(kAccepted);
    const uint32_t patience = 2u * (intervalMs / 1000u) + 3u;
    CHECK(desk.requests(patience - 1).empty());
    CHECK(desk.requests(1).size() == 1);
  }
}

TEST_CASE("a message that comes keeps its request from being repeated, and begins the pauses anew") {
  Attitude desk(1000);
  REQUIRE(desk.runUntilSent(MAVLINK_MSG_ID_COMMAND_LONG, 5000));
  desk.requests(16);  // three more, without an answer
  REQUIRE(desk.runUntilSent(MAVLINK_MSG_ID_COMMAND_LONG, 20000));
  desk.answer(kAccepted);
  for (int second = 0; second < 100; ++second) {
    desk.come();
    CHECK(desk.requests(1).empty());
  }
  // It stops: after 5 s it is requested, then 2, 4 s later.
  CHECK(desk.requests(3).empty());
  Times times = desk.requests(12);
  REQUIRE(times.size() >= 3);
  CHECK(times[1] - times[0] == 2);
  CHECK(times[2] - times[1] == 4);
}

TEST_CASE("a message that comes without having been confirmed is requested all the same") {
  Attitude desk(1000);
  REQUIRE(desk.runUntilSent(MAVLINK_MSG_ID_COMMAND_LONG, 5000));
  size_t requests = 0;
  for (int second = 0; second < 8; ++second) {
    desk.come();
    requests += desk.requests(1).size();
  }
  CHECK(requests == 2);
}

TEST_CASE("an autopilot that was silent for 2.5 s may have restarted: the message is requested again") {
  for (uint32_t gapMs : {1400u, 2000u}) {
    CAPTURE(gapMs);
    Attitude desk(1000);
    REQUIRE(desk.runUntilSent(MAVLINK_MSG_ID_COMMAND_LONG, 5000));
    desk.answer(kAccepted);
    desk.come();
    desk.run(1000 - desk.nowMs() % 1000 + 1);  // a heartbeat has just come
    CHECK(desk.listener.isConfirmed());
    desk.beats = false;
    desk.run(1000 + gapMs - 500);
    desk.beats = true;
    desk.sent.clear();
    desk.hear(heartbeatParts(ClientOnLine::kArduPilot));
    desk.run(5);
    const bool hasRestarted = gapMs == 2000;
    CHECK(desk.listener.isConfirmed() == !hasRestarted);
    CHECK(desk.timesOf(MAVLINK_MSG_ID_COMMAND_LONG, 0).empty() == !hasRestarted);
  }
}

TEST_CASE("of two listeners each gets its own answer, one behind the other") {
  struct Two : Attitude {
    GpsListener gps;
    Two() : Attitude(1000), gps(client, 500) {}
  } desk;
  REQUIRE(desk.runUntilSent(MAVLINK_MSG_ID_COMMAND_LONG, 5000));
  const float first = commandOf(desk.sent.back()).param1;
  desk.sent.clear();
  desk.run(50);
  CHECK(desk.timesOf(MAVLINK_MSG_ID_COMMAND_LONG, 0).empty());  // no second one while the answer may come
  desk.sent.clear();
  desk.answer(kAccepted);
  CHECK(desk.listener.isConfirmed() != desk.gps.isConfirmed());
  // The answer lets the other one ask.
  REQUIRE(desk.sent.size() == 1);
  const mavlink_command_long_t second = commandOf(desk.sent.back());
  CHECK(first + second.param1 == MAVLINK_MSG_ID_ATTITUDE + MAVLINK_MSG_ID_GPS_RAW_INT);
  CHECK((second.param2 == (second.param1 == MAVLINK_MSG_ID_GPS_RAW_INT ? 500000 : 1000000)));
  desk.answer(kDenied);
  CHECK(desk.listener.isConfirmed() != desk.gps.isConfirmed());
}

TEST_CASE("nothing is requested while a command of the client's runs, nor without room to send") {
  Attitude desk(1000);
  desk.run(500);
  desk.line.room = 0;
  CHECK(desk.requests(4).empty());
  desk.line.room = MemoryStream::kAlwaysRoom;
  CHECK(desk.requests(2).size() == 1);
}

TEST_CASE("it is told whether and when a message came, and whether it is new") {
  Attitude desk(0);
  desk.run(3000);
  CHECK_FALSE(desk.listener.isHeard());
  CHECK_FALSE(desk.listener.isNew());
  CHECK(desk.listener.ageMs() == TelemetryListener::kNeverHeard + 0);
  desk.come();
  CHECK(desk.listener.isHeard());
  CHECK(desk.listener.isNew());
  CHECK_FALSE(desk.listener.isNew());
  desk.run(700);
  CHECK(desk.listener.ageMs() >= 700);
  CHECK(desk.listener.ageMs() <= 706);
  desk.come(1, 1, 1, 7);  // of another vehicle
  CHECK_FALSE(desk.listener.isNew());
  CHECK(desk.listener.ageMs() >= 700);
}

// --- The messages

TEST_CASE("an attitude is three angles in degrees, and one with a NaN is none") {
  Attitude desk(0);
  desk.run(3000);
  CHECK(desk.listener.roll().e7() == 0);
  const auto isAbout = [](Degrees angle, double degrees) {
    const double off = angle.e7() / 1e7 - degrees;
    return off < 1e-4 && off > -1e-4;
  };
  desk.come(0.5f, -0.25f, 3.1f);
  CHECK(isAbout(desk.listener.roll(), 28.647890));
  CHECK(isAbout(desk.listener.pitch(), -14.323945));
  CHECK(isAbout(desk.listener.yaw(), 177.616917));
  CHECK(desk.listener.isNew());
  const float odd[3][3] = {{kNan, 0, 0}, {0, kNan, 0}, {0, 0, std::numeric_limits<float>::infinity()}};
  for (const auto& angles : odd) {
    desk.come(angles[0], angles[1], angles[2]);
    CHECK_FALSE(desk.listener.isNew());
    CHECK(isAbout(desk.listener.roll(), 28.647890));
  }
}

TEST_CASE("a battery's voltage is the sum of its cells, and what is not measured is not known") {
  struct Battery : Desk {
    BatteryListener first, second;
    Battery() : first(client, 0), second(client, 0, 1) { run(3000); }
    void come(const mavlink_battery_status_t& message) {
      tell(MAVLINK_MSG_ID_BATTERY_STATUS, MAVLINK_MSG_ID_BATTERY_STATUS_CRC, message);
    }
  } desk;
  CHECK(desk.first.voltageMv() == 0);
  CHECK_FALSE(desk.first.hasCurrent());
  CHECK_FALSE(desk.first.hasConsumed());
  CHECK_FALSE(desk.first.hasRemaining());
  CHECK_FALSE(desk.first.hasTemperature());
  mavlink_battery_status_t message = mavlink_battery_status_t();
  for (uint8_t i = 0; i < 10; ++i) message.voltages[i] = 0xFFFF;
  message.voltages[0] = 4200;
  message.voltages[1] = 4100;
  message.voltages[9] = 4000;
  message.current_battery = 1234;
  message.current_consumed = 567;
  message.temperature = 2150;
  message.battery_remaining = 77;
  desk.come(message);
  CHECK(desk.first.voltageMv() == 12300);
  CHECK(desk.first.currentCa() == 1234);
  CHECK(desk.first.consumedMah() == 567);
  CHECK(desk.first.remainingPercent() == 77);
  CHECK(desk.first.temperatureCdeg() == 2150);
  CHECK(desk.first.hasCurrent());
  CHECK(desk.first.hasConsumed());
  CHECK(desk.first.hasRemaining());
  CHECK(desk.first.hasTemperature());
  CHECK_FALSE(desk.second.isHeard());
  message.id = 1;
  message.voltages_ext[0] = 3000;
  message.voltages_ext[2] = 0xFFFF;
  message.voltages_ext[3] = 500;
  message.current_battery = 0;
  message.current_consumed = 0;
  message.battery_remaining = 0;
  message.temperature = INT16_MAX;
  desk.first.isNew();
  desk.come(message);
  CHECK(desk.second.voltageMv() == 15800);
  CHECK(desk.second.hasCurrent());
  CHECK(desk.second.hasConsumed());
  CHECK(desk.second.hasRemaining());
  CHECK_FALSE(desk.second.hasTemperature());
  CHECK_FALSE(desk.first.isNew());
  // More than 65.534 V without cells.
  message.voltages[0] = message.voltages[1] = 0xFFFE;
  message.voltages[9] = 0xFFFF;
  message.voltages_ext[0] = message.voltages_ext[2] = message.voltages_ext[3] = 0;
  message.current_battery = -1;
  desk.come(message);
  CHECK(desk.second.voltageMv() == 2 * 0xFFFEu);
  CHECK_FALSE(desk.second.hasCurrent());
}

TEST_CASE("a GPS receiver's fix, place and accuracies are as they came") {
  struct Gps : Desk {
    GpsListener gps;
    Gps() : gps(client, 0) { run(3000); }
  } desk;
  CHECK_FALSE(desk.gps.hasFix());
  CHECK_FALSE(desk.gps.hasSatellites());
  CHECK(desk.gps.hdopHundredths() == 65535);
  CHECK(desk.gps.speedCmS() == 65535);
  CHECK(desk.gps.courseCdeg() == 65535);
  CHECK(desk.gps.accuracyMm() == 0);
  mavlink_gps_raw_int_t message = mavlink_gps_raw_int_t();
  message.lat = -353632621;
  message.lon = 1491652374;
  message.alt = 584000;
  message.eph = 121;
  message.vel = 345;
  message.cog = 27000;
  message.h_acc = 900;
  message.satellites_visible = 11;
  for (uint8_t fix = 0; fix <= 8; ++fix) {
    message.fix_type = fix;
    desk.tell(MAVLINK_MSG_ID_GPS_RAW_INT, MAVLINK_MSG_ID_GPS_RAW_INT_CRC, message);
    CHECK(static_cast<uint8_t>(desk.gps.fix()) == fix);
    CHECK(desk.gps.hasFix() == (fix >= 3));
  }
  CHECK(desk.gps.place().latitude.e7() == -353632621);
  CHECK(desk.gps.place().longitude.e7() == 1491652374);
  CHECK(desk.gps.aboveSeaLevelMm() == 584000);
  CHECK(desk.gps.hdopHundredths() == 121);
  CHECK(desk.gps.speedCmS() == 345);
  CHECK(desk.gps.courseCdeg() == 27000);
  CHECK(desk.gps.accuracyMm() == 900);
  CHECK(desk.gps.hasSatellites());
  CHECK(desk.gps.satellites() == 11);
}

TEST_CASE("a pilot's display is given in centimetres and whole degrees") {
  struct Hud : Desk {
    HudListener hud;
    Hud() : hud(client, 0) { run(3000); }
  } desk;
  CHECK_FALSE(desk.hud.hasAirspeed());
  CHECK(desk.hud.climbCmS() == 0);
  mavlink_vfr_hud_t message = mavlink_vfr_hud_t();
  message.airspeed = 12.34f;
  message.groundspeed = 10.5f;
  message.climb = -1.25f;
  message.heading = 359;
  message.throttle = 42;
  desk.tell(MAVLINK_MSG_ID_VFR_HUD, MAVLINK_MSG_ID_VFR_HUD_CRC, message);
  CHECK(desk.hud.hasAirspeed());
  CHECK(desk.hud.airspeedCmS() == 1234);
  CHECK(desk.hud.groundSpeedCmS() == 1050);
  CHECK(desk.hud.climbCmS() == -125);
  CHECK(desk.hud.headingDeg() == 359);
  CHECK(desk.hud.throttlePercent() == 42);
  message.airspeed = kNan;
  desk.tell(MAVLINK_MSG_ID_VFR_HUD, MAVLINK_MSG_ID_VFR_HUD_CRC, message);
  CHECK_FALSE(desk.hud.hasAirspeed());
  CHECK(desk.hud.airspeedCmS() == 0);
}

TEST_CASE("a radio's state is taken from whoever sends it") {
  struct Radio : Desk {
    RadioListener radio;
    Radio() : radio(client) { run(3000); }
  } desk;
  CHECK_FALSE(desk.radio.isHeard());
  CHECK_FALSE(desk.radio.isNew());
  CHECK(desk.radio.ageMs() == RadioListener::kNeverHeard + 0);
  CHECK(desk.radio.rssi() == RadioListener::kUnknown + 0);
  CHECK(desk.radio.remoteRssi() == 255);
  CHECK(desk.radio.noise() == 255);
  CHECK(desk.radio.remoteNoise() == 255);
  CHECK(desk.radio.freeBufferPercent() == 0);
  CHECK(desk.radio.receiveErrors() == 0);
  CHECK(desk.radio.corrected() == 0);
  mavlink_radio_status_t message = mavlink_radio_status_t();
  message.rssi = 201;
  message.remrssi = 190;
  message.txbuf = 87;
  message.noise = 44;
  message.remnoise = 55;
  message.rxerrors = 321;
  message.fixed = 12;
  desk.tell(MAVLINK_MSG_ID_RADIO_STATUS, MAVLINK_MSG_ID_RADIO_STATUS_CRC, message, 51);
  CHECK(desk.radio.isHeard());
  CHECK(desk.radio.isNew());
  CHECK_FALSE(desk.radio.isNew());
  CHECK(desk.radio.rssi() == 201);
  CHECK(desk.radio.remoteRssi() == 190);
  CHECK(desk.radio.freeBufferPercent() == 87);
  CHECK(desk.radio.noise() == 44);
  CHECK(desk.radio.remoteNoise() == 55);
  CHECK(desk.radio.receiveErrors() == 321);
  CHECK(desk.radio.corrected() == 12);
  desk.run(400);
  CHECK(desk.radio.ageMs() >= 400);
  CHECK(desk.radio.ageMs() <= 406);
}

TEST_CASE("of a remote control there are as many channels as the receiver has, and 18 at the most") {
  struct Rc : Desk {
    RcListener rc;
    Rc() : rc(client, 0) { run(3000); }
    void come(uint8_t count) {
      mavlink_rc_channels_t message = mavlink_rc_channels_t();
      uint16_t channels[18];
      for (uint16_t i = 0; i < 18; ++i) channels[i] = static_cast<uint16_t>(1001 + i);
      channels[4] = 0xFFFF;
      memcpy(&message.chan1_raw, channels, sizeof(channels));
      message.chancount = count;
      message.rssi = 99;
      tell(MAVLINK_MSG_ID_RC_CHANNELS, MAVLINK_MSG_ID_RC_CHANNELS_CRC, message);
    }
  } desk;
  CHECK(desk.rc.count() == 0);
  CHECK(desk.rc.channelUs(1) == 0);
  CHECK_FALSE(desk.rc.hasRssi());
  desk.come(8);
  CHECK(desk.rc.count() == 8);
  CHECK(desk.rc.channelUs(0) == 0);
  CHECK(desk.rc.channelUs(1) == 1001);
  CHECK(desk.rc.channelUs(5) == 0);  // not known
  CHECK(desk.rc.channelUs(8) == 1008);
  CHECK(desk.rc.channelUs(9) == 0);
  CHECK(desk.rc.hasRssi());
  CHECK(desk.rc.rssi() == 99);
  for (uint8_t count : {18, 19, 255}) {
    desk.come(count);
    CHECK(desk.rc.count() == 18);
    CHECK(desk.rc.channelUs(18) == 1018);
    CHECK(desk.rc.channelUs(19) == 0);
  }
}

TEST_CASE("a waypoint is so far away, in a direction from 0 to 360") {
  struct Waypoint : Desk {
    WaypointListener waypoint;
    Waypoint() : waypoint(client, 0) { run(3000); }
    void come(int16_t bearing) {
      mavlink_nav_controller_output_t message = mavlink_nav_controller_output_t();
      message.target_bearing = bearing;
      message.wp_dist = 1234;
      message.xtrack_error = -2.5f;
      tell(MAVLINK_MSG_ID_NAV_CONTROLLER_OUTPUT, MAVLINK_MSG_ID_NAV_CONTROLLER_OUTPUT_CRC, message);
    }
  } desk;
  CHECK(desk.waypoint.distanceM() == 0);
  desk.come(-90);
  CHECK(desk.waypoint.bearingDeg() == 270);
  CHECK(desk.waypoint.distanceM() == 1234);
  CHECK(desk.waypoint.crossTrackCm() == -250);
  for (int16_t bearing : {0, 1, 180, 360}) {
    desk.come(bearing);
    CHECK(desk.waypoint.bearingDeg() == bearing);
  }
  desk.come(-1);
  CHECK(desk.waypoint.bearingDeg() == 359);
}

TEST_CASE("a position has its place, its velocity and its heading") {
  struct Position : Desk {
    PositionListener position;
    Position() : position(client, 0) { run(3000); }
    void come(int16_t vx, int16_t vy, uint16_t heading) {
      mavlink_global_position_int_t message = mavlink_global_position_int_t();
      message.lat = -353632621;
      message.lon = 1491652374;
      message.alt = 600000;
      message.relative_alt = 12345;
      message.vx = vx;
      message.vy = vy;
      message.vz = -7;
      message.hdg = heading;
      tell(MAVLINK_MSG_ID_GLOBAL_POSITION_INT, MAVLINK_MSG_ID_GLOBAL_POSITION_INT_CRC, message);
    }
  } desk;
  CHECK_FALSE(desk.position.hasPlace());
  CHECK(desk.position.aboveSeaLevelMm() == PositionListener::kNoHeight + 0);
  CHECK(desk.position.headingCdeg() == 65535);
  desk.come(300, -400, 9000);
  CHECK(desk.position.hasPlace());
  CHECK(desk.position.place().latitude.e7() == -353632621);
  CHECK(desk.position.place().longitude.e7() == 1491652374);
  CHECK(desk.position.aboveSeaLevelMm() == 600000);
  CHECK(desk.position.aboveHomeMm() == 12345);
  CHECK(desk.position.homeAboveSeaLevelMm() == 587655);
  CHECK(desk.position.northCmS() == 300);
  CHECK(desk.position.eastCmS() == -400);
  CHECK(desk.position.downCmS() == -7);
  CHECK(desk.position.speedCmS() == 500);
  CHECK(desk.position.headingCdeg() == 9000);
  CHECK(desk.position.heading().e7() == 900000000);
  desk.come(-32768, 32767, 18000);
  CHECK(desk.position.speedCmS() == 46340);
  CHECK(desk.position.heading().e7() == 1800000000);
  desk.come(0, 0, 18001);
  CHECK(desk.position.heading().e7() == -1799900000);
  desk.come(0, 0, 36000);
  CHECK(desk.position.hasHeading());
  CHECK(desk.position.heading().e7() == 0);
}

TEST_CASE("a wind from components has its direction to within a degree, and its speed") {
  struct Wind : Desk {
    WindListener wind;
    explicit Wind(uint8_t autopilot) : Desk(autopilot), wind(client, 0) { run(3000); }
    void come(float north, float east, float down = 0) {
      mavlink_wind_cov_t message = mavlink_wind_cov_t();
      message.wind_x = north;
      message.wind_y = east;
      message.wind_z = down;
      tell(MAVLINK_MSG_ID_WIND_COV, MAVLINK_MSG_ID_WIND_COV_CRC, message);
    }
  } desk(ClientOnLine::kPx4);
  for (int from = 0; from < 360; ++from) {
    const double radians = from * 3.14159265358979 / 180;
    // By a series: sines without a library.
    double sine = 0, cosine = 0, term = 1;
    for (int n = 0; n < 40; ++n) {
      (n % 2 == 0 ? cosine : sine) += (n / 2 % 2 == 0 ? term : -term);
      term *= radians / (n + 1);
    }
    desk.come(static_cast<float>(-20 * cosine), static_cast<float>(-20 * sine), 1.5f);
    const int off = (desk.wind.fromDeg() - from + 540) % 360 - 180;
    CAPTURE(from);
    CHECK(desk.wind.fromDeg() < 360);
    CHECK((off >= -1 && off <= 1));
    CHECK((desk.wind.speedCmS() >= 1998 && desk.wind.speedCmS() <= 2000));
    CHECK(desk.wind.downCmS() == 150);
  }
  desk.come(0, 0);
  CHECK(desk.wind.fromDeg() == 0);
  CHECK(desk.wind.speedCmS() == 0);
  desk.come(-5, 0);
  desk.come(kNan, 1e30f, kNan);
  CHECK(desk.wind.speedCmS() == 0);
  CHECK(desk.wind.downCmS() == 0);
  // A component of 300 m/s is one, and more is none.
  desk.come(-300, 0);
  CHECK(desk.wind.speedCmS() == 30000);
  desk.come(300, 0);
  CHECK(desk.wind.speedCmS() == 30000);
  desk.come(-300.01f, 0);
  CHECK(desk.wind.speedCmS() == 0);
  desk.come(0, 300.01f);
  CHECK(desk.wind.speedCmS() == 0);
}

TEST_CASE("ArduPilot's wind has a direction of any turn, and a speed that is not below 0") {
  struct Wind : Desk {
    WindListener wind;
    Wind() : wind(client, 0) { run(3000); }
    void come(float from, float speed) {
      const float message[3] = {from, speed, -0.5f};
      tell(168, 1, message);
    }
  } desk;
  const struct {
    float from;
    uint16_t degrees;
  } kTurns[] = {{0, 0}, {359, 359}, {360, 0}, {361, 1}, {-1, 359}, {-360, 0}, {-180, 180}, {725, 5}};
  for (const auto& one : kTurns) {
    desk.come(one.from, 3.5f);
    CHECK(desk.wind.fromDeg() == one.degrees);
    CHECK(desk.wind.speedCmS() == 350);
    CHECK(desk.wind.downCmS() == -50);
  }
  desk.come(0, -1);
  CHECK(desk.wind.speedCmS() == 0);
  desk.come(0, 0.01f);
  CHECK(desk.wind.speedCmS() == 1);
}

TEST_CASE("of two messages the one of the autopilot is requested") {
  for (uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    const bool isArduPilot = autopilot == ClientOnLine::kArduPilot;
    Desk desk(autopilot);
    WindListener wind(desk.client, 1000);
    REQUIRE(desk.runUntilSent(MAVLINK_MSG_ID_COMMAND_LONG, 5000));
    CHECK((commandOf(desk.sent.back()).param1 == (isArduPilot ? 168 : 231)));
    CHECK((commandOf(desk.sent.back()).param2 == 1000000));
    // Another autopilot, in the place of that one.
    desk.beats = false;
    float requested = 0;
    for (int second = 0; second < 8; ++second) {
      desk.hear(heartbeatParts(isArduPilot ? ClientOnLine::kPx4 : ClientOnLine::kArduPilot));
      if (desk.runUntilSent(MAVLINK_MSG_ID_COMMAND_LONG, 1000)) requested = commandOf(desk.sent.back()).param1;
    }
    CHECK((requested == (isArduPilot ? 231 : 168)));
    Desk other(autopilot);
    EstimatorListener estimator(other.client, 2000);
    REQUIRE(other.runUntilSent(MAVLINK_MSG_ID_COMMAND_LONG, 5000));
    CHECK((commandOf(other.sent.back()).param1 == (isArduPilot ? 193 : 230)));
    CHECK((commandOf(other.sent.back()).param2 == 2000000));
  }
}
