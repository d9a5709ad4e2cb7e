// When a telemetry listener requests its message, and what the listeners make of theirs.
#include <doctest/doctest.h>
#include <stdio.h>
#include <string.h>

#include <initializer_list>
#include <limits>
#include <string>

#include "ClientOnLine.h"
#include "Script.h"
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

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

#define AS(NAME) MAVLINK_MSG_ID_##NAME, MAVLINK_MSG_ID_##NAME##_CRC

mavlink_command_long_t commandOf(const SentFrame& frame) {
  mavlink_command_long_t command;
  memcpy(&command, frame.payload.data(), sizeof(command));
  return command;
}

// A client with a listener that requests its message every `intervalMs`, or not at all where that is 0.
template <typename Listener>
struct Desk : ClientOnLine {
  Listener listener;

  explicit Desk(uint16_t intervalMs = 0, uint8_t autopilot = kArduPilot)
      : ClientOnLine(autopilot), listener(client, intervalMs) {
    if (intervalMs == 0) run(3000);
  }

  template <typename Message>
  void tell(uint16_t id, uint8_t crcExtra, const Message& message, uint8_t systemId = 1) {
    FrameParts parts(id, message, crcExtra);
    parts.systemId = systemId;
    hear(parts);
    run(5);
  }

  // The requests that leave, "30 each 250", a message and its interval in ms, and "2 again", so many seconds after the
  // one before, when this happens:
  // until asked: the next one has left; wait N: N seconds pass; accepted, denied: the answer; comes: the message
  // no room, room: to send
  std::string plays(const std::string& script) {
    Transcript said;
    for (const Event& event : eventsOf(script)) {
      sent.clear();
      if (event.is("until asked")) REQUIRE(runUntilSent(MAVLINK_MSG_ID_COMMAND_LONG, 20000));
      if (event.is("wait")) run(1000 * event.number);
      if (event.is("accepted")) answer(MAV_RESULT_ACCEPTED);
      if (event.is("denied")) answer(MAV_RESULT_DENIED);
      if (event.is("comes")) tell(AS(ATTITUDE), mavlink_attitude_t());
      if (event.is("no room")) line.room = 0;
      if (event.is("room")) line.room = MemoryStream::kAlwaysRoom;
      for (const SentFrame& frame : sent) {
        if (frame.messageId != MAVLINK_MSG_ID_COMMAND_LONG) continue;
        const mavlink_command_long_t command = commandOf(frame);
        CHECK((command.command == MAV_CMD_SET_MESSAGE_INTERVAL));
        CHECK((command.confirmation == 0));
        CHECK((command.target_system == 1));
        CHECK((command.target_component == 1));
        const long ms = static_cast<long>(command.param2 / 1000);
        const uint32_t seconds = askedMs_ == 0 ? 0 : (frame.atMs - askedMs_ + 500) / 1000;
        const std::string asked = std::to_string(static_cast<long>(command.param1)) + " each " + std::to_string(ms);
        said.note(asked == asked_ ? "again" : asked, seconds);
        askedMs_ = frame.atMs;
        asked_ = asked;
      }
    }
    return said.text();
  }

 private:
  uint32_t askedMs_ = 0;
  std::string asked_;

  void answer(uint8_t result) {
    mavlink_command_ack_t ack = mavlink_command_ack_t();
    ack.command = MAV_CMD_SET_MESSAGE_INTERVAL;
    ack.result = result;
    ack.target_system = 1;
    ack.target_component = 191;
    tell(AS(COMMAND_ACK), ack);
  }
};

typedef Desk<AttitudeListener> Attitude;

template <typename... Numbers>
std::string text(const char* format, Numbers... numbers) {
  char line[200];
  snprintf(line, sizeof(line), format, numbers...);
  return line;
}

}  // namespace

// --- The request

TEST_CASE("a message is requested at its interval, as soon as the autopilot is known") {
  Attitude desk(250);
  CHECK(desk.plays("until asked") == "30 each 250");
  CHECK_FALSE(desk.listener.isConfirmed());
  desk.plays("accepted");
  CHECK(desk.listener.isConfirmed());
  CHECK_FALSE(desk.listener.isHeard());
}

TEST_CASE("with an interval of 0 nothing is requested, and what comes is taken") {
  Attitude desk;
  CHECK(desk.plays("wait 200, comes") == "");
  CHECK(desk.listener.isHeard());
}

TEST_CASE("a request without an answer is repeated after 2, 4, 8 s and so on, at most a minute") {
  CHECK(Attitude(1000).plays("until asked, wait 300") ==
        "30 each 1000, 2 again, 4 again, 8 again, 16 again, 32 again, "
        "64 again (3 times)");
  CHECK(Attitude(1000).plays("until asked, denied, until asked, denied, wait 5") == "30 each 1000, 2 again, 4 again");
  // A message that comes without having been confirmed is requested all the same.
  CHECK(Attitude(1000).plays("until asked, " + times(8, "comes, wait 1")) == "30 each 1000, 2 again, 4 again");
}

TEST_CASE("a confirmed message that does not come is requested again when it is twice late, and 3 s more") {
  CHECK(Attitude(200).plays("until asked, accepted, wait 4") == "30 each 200, 3 again");
  CHECK(Attitude(1000).plays("until asked, accepted, wait 6") == "30 each 1000, 5 again");
  CHECK(Attitude(2500).plays("until asked, accepted, wait 8") == "30 each 2500, 7 again");
  CHECK(Attitude(5000).plays("until asked, accepted, wait 14") == "30 each 5000, 13 again");
}

TEST_CASE("a message that comes keeps its request from being repeated, and begins the pauses anew") {
  Attitude desk(1000);
  desk.plays("until asked, wait 16, until asked, accepted");  // three more, without an answer
  CHECK(desk.plays(times(100, "comes, wait 1")) == "");
  CHECK(desk.plays("wait 12") == "104 again, 2 again, 4 again");
}

TEST_CASE("of two listeners each gets its own answer, one after the other") {
  Attitude desk(1000);
  GpsListener gps(desk.client, 500);
  const std::string first = desk.plays("until asked");
  desk.run(50);
  CHECK(desk.plays("wait 0") == "");                  // no second one while the answer may come
  const std::string second = desk.plays("accepted");  // now the other one may ask
  CHECK(desk.listener.isConfirmed() != gps.isConfirmed());
  CHECK((first == "24 each 500" && second == "30 each 1000"));
  desk.plays("denied");
  CHECK(desk.listener.isConfirmed() != gps.isConfirmed());
}

TEST_CASE("nothing is requested without room to send") {
  CHECK(Attitude(1000).plays("until asked, no room, wait 5, room, wait 2") == "30 each 1000, 6 again");
}

TEST_CASE("a message of another vehicle is none") {
  Attitude desk;
  desk.plays("comes");
  CHECK(desk.listener.isNew());
  desk.run(700);
  desk.tell(AS(ATTITUDE), mavlink_attitude_t(), 7);
  CHECK_FALSE(desk.listener.isNew());
  CHECK(desk.listener.ageMs() >= 700);
}

TEST_CASE("of two messages the one of the autopilot is requested") {
  const struct {
    uint8_t autopilot, other;
    const char *wind, *estimator, *otherWind;
  } kRows[] = {
      {ClientOnLine::kArduPilot, ClientOnLine::kPx4, "168 each 1000", "193 each 2000", "231 each 1000"},
      {ClientOnLine::kPx4, ClientOnLine::kArduPilot, "231 each 1000", "230 each 2000", "168 each 1000"},
  };
  for (const auto& row : kRows) {
    Desk<WindListener> desk(1000, row.autopilot);
    CHECK(desk.plays("until asked") == row.wind);
    CHECK(Desk<EstimatorListener>(2000, row.autopilot).plays("until asked") == row.estimator);
    // Another autopilot, in the place of that one.
    desk.beats = false;
    std::string asked;
    for (int second = 0; second < 8; ++second) {
      desk.hear(heartbeatParts(row.other));
      const std::string said = desk.plays("wait 1");
      if (!said.empty()) asked += said + ", ";
    }
    CHECK(asked == "1 " + std::string(row.otherWind) + ", 4 again, ");
  }
}

// --- The messages

TEST_CASE("an attitude is three angles in degrees, and one with a NaN is none") {
  Attitude desk;
  const auto told = [&desk](float roll, float pitch, float yaw) {
    mavlink_attitude_t message = mavlink_attitude_t();
    message.roll = roll;
    message.pitch = pitch;
    message.yaw = yaw;
    desk.tell(AS(ATTITUDE), message);
    const AttitudeListener& is = desk.listener;
    return text("%.4f %.4f %.4f", is.roll().e7() / 1e7, is.pitch().e7() / 1e7, is.yaw().e7() / 1e7) +
           (desk.listener.isNew() ? "" : " as before");
  };
  CHECK(desk.listener.roll().e7() == 0);
  CHECK(told(0.5f, -0.25f, 3.1f) == "28.6479 -14.3239 177.6169");
  CHECK(told(kNan, 0, 0) == "28.6479 -14.3239 177.6169 as before");
  CHECK(told(0, kNan, 0) == "28.6479 -14.3239 177.6169 as before");
  CHECK(told(0, 0, kInfinity) == "28.6479 -14.3239 177.6169 as before");
}

TEST_CASE("a battery's voltage is the sum of its cells, and what is not measured is not known") {
  Desk<BatteryListener> desk;
  BatteryListener second(desk.client, 0, 1);
  const auto says = [](const BatteryListener& is) {
    return text("%lu mV", static_cast<unsigned long>(is.voltageMv())) +
           (is.hasCurrent() ? text(" %ld cA", static_cast<long>(is.currentCa())) : "") +
           (is.hasConsumed() ? text(" %ld mAh", static_cast<long>(is.consumedMah())) : "") +
           (is.hasRemaining() ? text(" %d %%", int(is.remainingPercent())) : "") +
           (is.hasTemperature() ? text(" %d cdeg", int(is.temperatureCdeg())) : "");
  };
  CHECK(says(desk.listener) == "0 mV");
  mavlink_battery_status_t message = mavlink_battery_status_t();
  for (uint8_t i = 0; i < 10; ++i) message.voltages[i] = 0xFFFF;
  message.voltages[0] = 4200;
  message.voltages[1] = 4100;
  message.voltages[9] = 4000;
  message.current_battery = 1234;
  message.current_consumed = 567;
  message.temperature = 2150;
  message.battery_remaining = 77;
  desk.tell(AS(BATTERY_STATUS), message);
  CHECK(says(desk.listener) == "12300 mV 1234 cA 567 mAh 77 % 2150 cdeg");
  CHECK_FALSE(second.isHeard());
  message.id = 1;
  message.voltages_ext[0] = 3000;
  message.voltages_ext[2] = 0xFFFF;
  message.voltages_ext[3] = 500;
  message.current_battery = message.current_consumed = message.battery_remaining = 0;
  message.temperature = INT16_MAX;
  desk.listener.isNew();
  desk.tell(AS(BATTERY_STATUS), message);
  CHECK(says(second) == "15800 mV 0 cA 0 mAh 0 %");
  CHECK_FALSE(desk.listener.isNew());
  // More than 65.534 V without cells.
  message.voltages[0] = message.voltages[1] = 0xFFFE;
  message.voltages[9] = 0xFFFF;
  message.voltages_ext[0] = message.voltages_ext[2] = message.voltages_ext[3] = 0;
  message.current_battery = -1;
  desk.tell(AS(BATTERY_STATUS), message);
  CHECK(says(second) == "131068 mV 0 mAh 0 %");
}

TEST_CASE("a GPS receiver's fix, place and accuracies are as they came") {
  Desk<GpsListener> desk;
  const GpsListener& is = desk.listener;
  const auto says = [&is] {
    return text("%ld %ld, %ld mm, hdop %u, %u cm/s to %u, within %lu mm", long(is.place().latitude.e7()),
                long(is.place().longitude.e7()), long(is.aboveSeaLevelMm()), is.hdopHundredths(), is.speedCmS(),
                is.courseCdeg(), static_cast<unsigned long>(is.accuracyMm())) +
           (is.hasSatellites() ? text(", %u satellites", is.satellites()) : "");
  };
  CHECK_FALSE(is.hasFix());
  CHECK(says() == "0 0, 0 mm, hdop 65535, 65535 cm/s to 65535, within 0 mm");
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
    desk.tell(AS(GPS_RAW_INT), message);
    CHECK(static_cast<uint8_t>(is.fix()) == fix);
    CHECK(is.hasFix() == (fix >= 3));
  }
  CHECK(says() == "-353632621 1491652374, 584000 mm, hdop 121, 345 cm/s to 27000, within 900 mm, 11 satellites");
}

TEST_CASE("a pilot's display is given in centimetres and whole degrees") {
  Desk<HudListener> desk;
  const HudListener& is = desk.listener;
  CHECK_FALSE(is.hasAirspeed());
  CHECK(is.climbCmS() == 0);
  mavlink_vfr_hud_t message = mavlink_vfr_hud_t();
  message.airspeed = 12.34f;
  message.groundspeed = 10.5f;
  message.climb = -1.25f;
  message.heading = 359;
  message.throttle = 42;
  desk.tell(AS(VFR_HUD), message);
  CHECK(is.hasAirspeed());
  CHECK(text("%d %d %d, %d, %d", is.airspeedCmS(), is.groundSpeedCmS(), is.climbCmS(), is.headingDeg(),
             is.throttlePercent()) == "1234 1050 -125, 359, 42");
  message.airspeed = kNan;
  desk.tell(AS(VFR_HUD), message);
  CHECK_FALSE(is.hasAirspeed());
  CHECK(is.airspeedCmS() == 0);
}

TEST_CASE("a radio's state is taken from whoever sends it") {
  Desk<HudListener> desk;
  RadioListener is(desk.client);
  const auto says = [&is] {
    return text("%u %u, noise %u %u, free %u, errors %u, corrected %u", is.rssi(), is.remoteRssi(), is.noise(),
                is.remoteNoise(), is.freeBufferPercent(), is.receiveErrors(), is.corrected());
  };
  CHECK_FALSE(is.isHeard());
  CHECK_FALSE(is.isNew());
  CHECK(says() == "255 255, noise 255 255, free 0, errors 0, corrected 0");
  CHECK(RadioListener::kUnknown + 0 == 255);
  mavlink_radio_status_t message = mavlink_radio_status_t();
  message.rssi = 201;
  message.remrssi = 190;
  message.txbuf = 87;
  message.noise = 44;
  message.remnoise = 55;
  message.rxerrors = 321;
  message.fixed = 12;
  desk.tell(AS(RADIO_STATUS), message, 51);
  CHECK(is.isHeard());
  CHECK(is.isNew());
  CHECK_FALSE(is.isNew());
  CHECK(says() == "201 190, noise 44 55, free 87, errors 321, corrected 12");
}

TEST_CASE("of a remote control there are as many channels as the receiver has, and 18 at the most") {
  Desk<RcListener> desk;
  const RcListener& is = desk.listener;
  CHECK(is.count() == 0);
  CHECK(is.channelUs(1) == 0);
  CHECK_FALSE(is.hasRssi());
  mavlink_rc_channels_t message = mavlink_rc_channels_t();
  uint16_t channels[18];
  for (uint16_t i = 0; i < 18; ++i) channels[i] = static_cast<uint16_t>(1001 + i);
  channels[4] = 0xFFFF;  // not known
  memcpy(&message.chan1_raw, channels, sizeof(channels));
  message.rssi = 99;
  for (int count : {8, 18, 19, 255}) {
    message.chancount = static_cast<uint8_t>(count);
    desk.tell(AS(RC_CHANNELS), message);
    const int last = count > 18 ? 18 : count;
    CHECK(is.count() == last);
    for (int number = 0; number <= 20; ++number) {
      const bool isKnown = number >= 1 && number <= last && number != 5;
      CHECK(is.channelUs(static_cast<uint8_t>(number)) == (isKnown ? 1000 + number : 0));
    }
  }
  CHECK(is.hasRssi());
  CHECK(is.rssi() == 99);
}

TEST_CASE("a waypoint is so far away, in a direction from 0 to 360") {
  Desk<WaypointListener> desk;
  const WaypointListener& is = desk.listener;
  CHECK(is.distanceM() == 0);
  const int kBearings[][2] = {{-90, 270}, {0, 0}, {1, 1}, {180, 180}, {360, 360}, {-1, 359}};
  for (const auto& bearing : kBearings) {
    mavlink_nav_controller_output_t message = mavlink_nav_controller_output_t();
    message.target_bearing = static_cast<int16_t>(bearing[0]);
    message.wp_dist = 1234;
    message.xtrack_error = -2.5f;
    desk.tell(AS(NAV_CONTROLLER_OUTPUT), message);
    CHECK(is.bearingDeg() == bearing[1]);
    CHECK(is.distanceM() == 1234);
    CHECK(is.crossTrackCm() == -250);
  }
}

TEST_CASE("a position has its place, its velocity and its heading") {
  Desk<PositionListener> desk;
  const PositionListener& is = desk.listener;
  const auto come = [&desk](int16_t vx, int16_t vy, uint16_t heading) {
    mavlink_global_position_int_t message = mavlink_global_position_int_t();
    message.lat = -353632621;
    message.lon = 1491652374;
    message.alt = 600000;
    message.relative_alt = 12345;
    message.vx = vx;
    message.vy = vy;
    message.vz = -7;
    message.hdg = heading;
    desk.tell(AS(GLOBAL_POSITION_INT), message);
  };
  CHECK_FALSE(is.hasPlace());
  CHECK(is.aboveSeaLevelMm() == PositionListener::kNoHeight + 0);
  CHECK(is.headingCdeg() == 65535);
  come(300, -400, 9000);
  CHECK(is.hasPlace());
  CHECK(text("%ld %ld, %ld %ld %ld mm", long(is.place().latitude.e7()), long(is.place().longitude.e7()),
             long(is.aboveSeaLevelMm()), long(is.aboveHomeMm()),
             long(is.homeAboveSeaLevelMm())) == "-353632621 1491652374, 600000 12345 587655 mm");
  CHECK(text("%d %d %d, %u cm/s", is.northCmS(), is.eastCmS(), is.downCmS(), unsigned(is.speedCmS())) ==
        "300 -400 -7, 500 cm/s");
  CHECK(is.headingCdeg() == 9000);
  CHECK(is.heading().e7() == 900000000);
  come(-32768, 32767, 18000);
  CHECK(is.speedCmS() == 46340);
  CHECK(is.heading().e7() == 1800000000);
  come(0, 0, 18001);
  CHECK(is.heading().e7() == -1799900000);
  come(0, 0, 36000);
  CHECK(is.hasHeading());
  CHECK(is.heading().e7() == 0);
}

TEST_CASE("a wind from components has its direction to within a degree, and its speed") {
  Desk<WindListener> desk(0, ClientOnLine::kPx4);
  const WindListener& is = desk.listener;
  const auto come = [&desk](float north, float east, float down) {
    mavlink_wind_cov_t message = mavlink_wind_cov_t();
    message.wind_x = north;
    message.wind_y = east;
    message.wind_z = down;
    desk.tell(AS(WIND_COV), message);
  };
  for (int from = 0; from < 360; ++from) {
    const double radians = from * 3.14159265358979 / 180;
    // By a series: sines without a library.
    double sine = 0, cosine = 0, term = 1;
    for (int n = 0; n < 40; ++n) {
      (n % 2 == 0 ? cosine : sine) += (n / 2 % 2 == 0 ? term : -term);
      term *= radians / (n + 1);
    }
    come(static_cast<float>(-20 * cosine), static_cast<float>(-20 * sine), 1.5f);
    const int off = (is.fromDeg() - from + 540) % 360 - 180;
    CAPTURE(from);
    CHECK(is.fromDeg() < 360);
    CHECK((off >= -1 && off <= 1));
    CHECK((is.speedCmS() >= 1998 && is.speedCmS() <= 2000));
    CHECK(is.downCmS() == 150);
  }
  const struct {
    float north, east, down;
    uint16_t speedCmS;
  } kWinds[] = {
      {0, 0, 0, 0},
      {kNan, 1e30f, kNan, 0},
      // A component of 300 m/s is one, and more is none.
      {-300, 0, 0, 30000},
      {300, 0, 0, 30000},
      {-300.01f, 0, 0, 0},
      {0, 300.01f, 0, 0},
  };
  for (const auto& wind : kWinds) {
    come(-5, 0, 0);
    come(wind.north, wind.east, wind.down);
    CHECK(is.speedCmS() == wind.speedCmS);
    CHECK(is.downCmS() == 0);
    if (wind.north == 0 && wind.east == 0) CHECK(is.fromDeg() == 0);
  }
}

TEST_CASE("ArduPilot's wind has a direction of any turn, and a speed that is not below 0") {
  Desk<WindListener> desk;
  const WindListener& is = desk.listener;
  const struct {
    float from, speed;
    const char* says;
  } kWinds[] = {{0, 3.5f, "0 350"},    {359, 3.5f, "359 350"}, {360, 3.5f, "0 350"},    {361, 3.5f, "1 350"},
                {-1, 3.5f, "359 350"}, {-360, 3.5f, "0 350"},  {-180, 3.5f, "180 350"}, {725, 3.5f, "5 350"},
                {0, -1, "0 0"},        {0, 0.01f, "0 1"}};
  for (const auto& wind : kWinds) {
    const float message[3] = {wind.from, wind.speed, -0.5f};
    desk.tell(168, 1, message);
    CHECK(text("%u %u", is.fromDeg(), is.speedCmS()) == wind.says);
    CHECK(is.downCmS() == -50);
  }
}
