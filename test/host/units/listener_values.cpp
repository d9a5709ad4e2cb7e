// The listeners of telemetry: what each makes of its message, and what it says before that has come.
#include <doctest/doctest.h>
#include <math.h>
#include <stdio.h>

#include <string>

#include "ToldClient.h"
#include "mavmission/base/Root.h"
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

constexpr uint8_t kArduPilot = ClientOnLine::kArduPilot, kPx4 = ClientOnLine::kPx4;
constexpr uint32_t kNeverHeard = 0xFFFFFFFF;  // as the headers say it

std::string list() { return ""; }
template <typename Number, typename... Numbers>
std::string list(Number first, Numbers... others) {
  return std::to_string(first) + (sizeof...(others) != 0 ? " " : "") + list(others...);
}
std::string degrees(Degrees angle) {
  char text[20];
  snprintf(text, sizeof(text), "%.10g", angle.e7() / 1e7);
  return text;
}
std::string place(const LatLon& it) { return degrees(it.latitude) + " " + degrees(it.longitude); }
std::string millimetres(int32_t height) {
  return height == PositionListener::kNoHeight ? "unknown" : std::to_string(height);
}

// All that a listener says.
std::string valuesOf(const AttitudeListener& is) {
  return degrees(is.roll()) + " " + degrees(is.pitch()) + " " + degrees(is.yaw());
}
std::string valuesOf(const BatteryListener& is) {
  return list(is.voltageMv()) + " mV" + (is.hasCurrent() ? ", " + list(is.currentCa()) + " cA" : "") +
         (is.hasConsumed() ? ", " + list(is.consumedMah()) + " mAh" : "") +
         (is.hasRemaining() ? ", " + list(is.remainingPercent()) + " %" : "") +
         (is.hasTemperature() ? ", " + list(is.temperatureCdeg()) + " cdeg" : "");
}
std::string valuesOf(const EstimatorListener& is) { return list(is.flags()) + ", " + list(is.worstPercent()) + " %"; }
std::string valuesOf(const GpsListener& is) {
  return std::string(is.hasFix() ? "in" : "not in") + " three dimensions: " + list(static_cast<uint8_t>(is.fix())) +
         ", " + place(is.place()) + ", " + list(is.aboveSeaLevelMm()) + " mm, hdop " + list(is.hdopHundredths()) +
         ", " + list(is.speedCmS()) + " cm/s to " + list(is.courseCdeg()) + ", within " + list(is.accuracyMm()) +
         " mm" + (is.hasSatellites() ? ", " + list(is.satellites()) + " satellites" : "");
}
std::string valuesOf(const HealthListener& is) { return list(is.failedSensors(), is.loadPermille()); }
std::string valuesOf(const HudListener& is) {
  return list(is.airspeedCmS(), is.groundSpeedCmS(), is.climbCmS()) + " cm/s, " +
         list(is.headingDeg(), is.throttlePercent()) + (is.hasAirspeed() ? "" : ", without airspeed");
}
std::string valuesOf(const PositionListener& is) {
  return (is.hasPlace() ? place(is.place()) : "no place") + ", " + millimetres(is.aboveSeaLevelMm()) + " " +
         millimetres(is.aboveHomeMm()) + " " + millimetres(is.homeAboveSeaLevelMm()) + " mm, " +
         list(is.northCmS(), is.eastCmS(), is.downCmS(), is.speedCmS()) + " cm/s, " +
         (is.hasHeading() ? "to " : "unknown ") + list(is.headingCdeg()) + " " + degrees(is.heading());
}
std::string valuesOf(const RadioListener& is) {
  return list(is.rssi(), is.remoteRssi()) + ", noise " + list(is.noise(), is.remoteNoise()) + ", free " +
         list(is.freeBufferPercent()) + ", errors " + list(is.receiveErrors()) + ", corrected " + list(is.corrected());
}
std::string valuesOf(const VibrationListener& is) { return list(is.worstCmS2(), is.clipping()); }
std::string valuesOf(const WaypointListener& is) {
  return list(is.distanceM()) + " m to " + list(is.bearingDeg()) + ", " + list(is.crossTrackCm()) + " cm off";
}
std::string valuesOf(const WindListener& is) {
  return list(is.speedCmS()) + " from " + list(is.fromDeg()) + ", " + list(is.downCmS()) + " down";
}

// A client with one listener, which requests nothing. The clock wraps half a second later.
template <typename Listener>
struct Heard : Told<Listener> {
  explicit Heard(uint8_t autopilot = kArduPilot) : Told<Listener>(0, autopilot, 0u - 4000u) {}

  std::string says() { return valuesOf(this->listener); }
  // The same after this message.
  std::string hears(const FrameParts& message) {
    this->tell(message);
    return valuesOf(this->listener) + (this->listener.isNew() ? "" : ", as before");
  }
  std::string hears(const std::string& words) { return hears(messageParts(words)); }
};

// A message, whatever it says, is new once, and its age counts from when it came.
template <typename Listener>
bool isNewOnce(const std::string& words) {
  Heard<Listener> desk;
  Listener& is = desk.listener;
  const bool isNothing = !is.isHeard() && !is.isNew() && is.ageMs() == kNeverHeard && !is.isConfirmed();
  desk.tell(words);
  const bool isFirst = is.isHeard() && is.ageMs() == 0 && is.isNew() && !is.isNew();
  desk.run(1234);
  const bool isOld = is.ageMs() == 1234 && !is.isNew();
  desk.tell(words);
  return isNothing && isFirst && isOld && is.ageMs() == 0 && is.isNew();
}

}  // namespace

TEST_CASE("each message is new once, and has an age; before that there is none, and its numbers are 0") {
  CHECK(isNewOnce<AttitudeListener>("ATTITUDE"));
  CHECK(isNewOnce<BatteryListener>("BATTERY_STATUS"));
  CHECK(isNewOnce<EstimatorListener>("ESTIMATOR_STATUS"));
  CHECK(isNewOnce<GpsListener>("GPS_RAW_INT"));
  CHECK(isNewOnce<HealthListener>("SYS_STATUS"));
  CHECK(isNewOnce<HudListener>("VFR_HUD"));
  CHECK(isNewOnce<PositionListener>("GLOBAL_POSITION_INT"));
  CHECK(isNewOnce<RcListener>("RC_CHANNELS"));
  CHECK(isNewOnce<VibrationListener>("VIBRATION"));
  CHECK(isNewOnce<WaypointListener>("NAV_CONTROLLER_OUTPUT"));
  CHECK(isNewOnce<WindListener>("WIND_COV"));
  CHECK(TelemetryListener::kNeverHeard + 0 == kNeverHeard);
  CHECK(Heard<AttitudeListener>().says() == "0 0 0");
  CHECK(Heard<BatteryListener>().says() == "0 mV");
  CHECK(Heard<EstimatorListener>().says() == "0, 0 %");
  CHECK(Heard<GpsListener>().says() ==
        "not in three dimensions: 0, 0 0, 0 mm, hdop 65535, 65535 cm/s to 65535, within 0 mm");
  CHECK(Heard<HealthListener>().says() == "0 0");
  CHECK(Heard<HudListener>().says() == "0 0 0 cm/s, 0 0, without airspeed");
  CHECK(Heard<PositionListener>().says() == "no place, unknown unknown unknown mm, 0 0 0 0 cm/s, unknown 65535 0");
  CHECK(Heard<VibrationListener>().says() == "0 0");
  CHECK(Heard<WaypointListener>().says() == "0 m to 0, 0 cm off");
  CHECK(Heard<WindListener>().says() == "0 from 0, 0 down");
}

TEST_CASE("an attitude is three angles, half a turn is 180 degrees to either side, and one with a NaN is none") {
  Heard<AttitudeListener> desk;
  CHECK(desk.hears("ATTITUDE roll 0.5 pitch -0.25 yaw 3.1") == "28.6478882 -14.3239441 177.6168976");
  CHECK(desk.hears("ATTITUDE roll nan") == "28.6478882 -14.3239441 177.6168976, as before");
  CHECK(desk.hears("ATTITUDE pitch nan") == "28.6478882 -14.3239441 177.6168976, as before");
  CHECK(desk.hears("ATTITUDE yaw inf") == "28.6478882 -14.3239441 177.6168976, as before");
  CHECK(desk.hears("ATTITUDE roll 3.14159265 yaw -3.14159265") == "180 0 -180");
  // How fast the aircraft turns does not matter, and goes nowhere.
  struct Guarded : AttitudeListener {
    uint8_t behind = 0x5A;
    Guarded(MissionClient& client, uint16_t intervalMs) : AttitudeListener(client, intervalMs) {}
  };
  Heard<Guarded> other;
  CHECK(other.hears("ATTITUDE roll 3.14159265 rollspeed nan") == "180 0 0");
  CHECK(other.listener.behind == 0x5A);
}

TEST_CASE("a battery's voltage is the sum of its cells, and what is not measured is not known") {
  Heard<BatteryListener> desk;
  BatteryListener second(desk.client, 0, 1);
  const std::string noCells = "voltages[0-9] 65535 ";
  CHECK(desk.hears("BATTERY_STATUS " + noCells +
                   "voltages[0] 4200 voltages[1] 4100 voltages[9] 4000 current_battery 1234 current_consumed 567 "
                   "temperature 2150 battery_remaining 77") == "12300 mV, 1234 cA, 567 mAh, 77 %, 2150 cdeg");
  CHECK_FALSE(second.isHeard());
  CHECK(desk.hears("BATTERY_STATUS id 1 " + noCells +
                   "voltages[0] 4200 voltages[1] 4100 voltages[9] 4000 voltages_ext[0] 3000 voltages_ext[2] 65535 "
                   "voltages_ext[3] 500 temperature 32767") ==
        "12300 mV, 1234 cA, 567 mAh, 77 %, 2150 cdeg, as before");
  CHECK(valuesOf(second) == "15800 mV, 0 cA, 0 mAh, 0 %");
  // More than 65.534 V without cells.
  desk.tell("BATTERY_STATUS id 1 " + noCells +
            "voltages[0] 65534 voltages[1] 65534 temperature 32767 current_battery -1");
  CHECK(valuesOf(second) == "131068 mV, 0 mAh, 0 %");
  // What follows the cells is no voltage.
  CHECK(desk.hears("BATTERY_STATUS voltages_ext[3] 1000 mode 2 fault_bitmask 0x55555555") ==
        "1000 mV, 0 cA, 0 mAh, 0 %, 0 cdeg");
}

TEST_CASE("a GPS receiver's fix, place and accuracies are as they came") {
  Heard<GpsListener> desk;
  for (int fix = 0; fix <= 8; ++fix) {
    CHECK(desk.hears("GPS_RAW_INT lat -353632621 lon 1491652374 alt 584000 eph 121 vel 345 cog 27000 h_acc 900 "
                     "satellites_visible 11 fix_type " +
                     list(fix)) ==
          (fix >= 3 ? "in three dimensions: " : "not in three dimensions: ") + list(fix) +
              ", -35.3632621 149.1652374, 584000 mm, hdop 121, 345 cm/s to 27000, within 900 mm, 11 satellites");
  }
}

TEST_CASE("a pilot's display is given in centimetres and whole degrees") {
  Heard<HudListener> desk;
  CHECK(desk.hears("VFR_HUD airspeed 12.34 groundspeed 10.5 climb -1.25 heading 359 throttle 42") ==
        "1234 1050 -125 cm/s, 359 42");
  CHECK(desk.hears("VFR_HUD airspeed nan groundspeed 10.5") == "0 1050 0 cm/s, 0 0, without airspeed");
}

TEST_CASE("a position has its place, its velocity and its heading") {
  Heard<PositionListener> desk;
  const std::string placed = "GLOBAL_POSITION_INT lat -353632621 lon 1491652374 alt 600000 relative_alt 12345 ";
  const std::string there = "-35.3632621 149.1652374, 600000 12345 587655 mm, ";
  CHECK(desk.hears(placed + "vx 300 vy -400 vz -7 hdg 9000") == there + "300 -400 -7 500 cm/s, to 9000 90");
  CHECK(desk.hears(placed + "vx -32768 vy 32767 hdg 18000") == there + "-32768 32767 0 46340 cm/s, to 18000 180");
  CHECK(desk.hears(placed + "hdg 18001") == there + "0 0 0 0 cm/s, to 18001 -179.99");
  CHECK(desk.hears(placed + "hdg 27000") == there + "0 0 0 0 cm/s, to 27000 -90");
  CHECK(desk.hears(placed + "hdg 36000") == there + "0 0 0 0 cm/s, to 36000 0");
  CHECK(desk.hears(placed + "hdg 36001") == there + "0 0 0 0 cm/s, unknown 36001 0");
  CHECK(desk.hears(placed + "hdg 65535") == there + "0 0 0 0 cm/s, unknown 65535 0");
}

TEST_CASE(
    "a height is not known before a place is, nor above PX4's home before it has one, nor where it does not fit") {
  const struct {
    uint8_t autopilot;
    const char *words, *says;
  } kRows[] = {
      {kArduPilot, "", "no place, 0 unknown unknown mm"},
      // On the equator, on the meridian of Greenwich.
      {kArduPilot, "lat 1", "1e-07 0, 0 0 0 mm"},
      {kArduPilot, "lon 1", "0 1e-07, 0 0 0 mm"},
      {kArduPilot, "lat 1 alt 20000 relative_alt 20000", "1e-07 0, 20000 20000 0 mm"},
      {kPx4, "lat 1 alt 489500 relative_alt 489500", "1e-07 0, 489500 unknown unknown mm"},
      {kPx4, "lat 1 alt 489500 relative_alt 1500", "1e-07 0, 489500 1500 488000 mm"},
      {kArduPilot, "lat 1 alt 2147483647 relative_alt -1", "1e-07 0, 2147483647 -1 unknown mm"},
      {kArduPilot, "lat 1 alt 2147483647", "1e-07 0, 2147483647 0 2147483647 mm"},
      {kArduPilot, "lat 1 alt 2147483647 relative_alt 1", "1e-07 0, 2147483647 1 2147483646 mm"},
      {kArduPilot, "lat 1 alt -1 relative_alt 2147483647", "1e-07 0, -1 2147483647 unknown mm"},
      {kArduPilot, "lat 1 relative_alt 2147483647", "1e-07 0, 0 2147483647 -2147483647 mm"},
      {kArduPilot, "lat 1 alt -2147483648 relative_alt 1", "1e-07 0, unknown 1 unknown mm"},
      {kArduPilot, "lat 1 relative_alt -2147483647", "1e-07 0, 0 -2147483647 2147483647 mm"},
      {kArduPilot, "lat 1 alt -2147483648 relative_alt -1", "1e-07 0, unknown -1 -2147483647 mm"},
  };
  for (const auto& row : kRows) {
    Heard<PositionListener> desk(row.autopilot);
    CHECK(desk.hears(std::string("GLOBAL_POSITION_INT ") + row.words) ==
          std::string(row.says) + ", 0 0 0 0 cm/s, to 0 0");
  }
  Heard<PositionListener> desk;
  desk.tell("GLOBAL_POSITION_INT lat 1 alt 20000 relative_alt 20000");
  CHECK(desk.listener.hasHeights());
  CHECK(desk.listener.altitude().metres() == 20);
}

TEST_CASE("a radio's state is taken from whoever sends it, is new once, and has an age") {
  ToldClient desk;
  RadioListener is(desk.client);
  CHECK_FALSE(is.isHeard());
  CHECK_FALSE(is.isNew());
  CHECK(is.ageMs() == kNeverHeard);
  CHECK(RadioListener::kNeverHeard + 0 == kNeverHeard);
  CHECK(RadioListener::kUnknown + 0 == 255);
  CHECK(valuesOf(is) == "255 255, noise 255 255, free 0, errors 0, corrected 0");
  desk.tell(messagePartsV1("RADIO_STATUS rssi 1"));
  CHECK(is.ageMs() == 0);
  CHECK(is.isNew());
  desk.run(777);
  CHECK(is.ageMs() == 777);
  CHECK_FALSE(is.isNew());
  desk.tell("RADIO_STATUS rssi 201 remrssi 190 txbuf 87 noise 44 remnoise 55 rxerrors 321 fixed 12", 51);
  CHECK(is.isHeard());
  CHECK(is.isNew());
  CHECK(valuesOf(is) == "201 190, noise 44 55, free 87, errors 321, corrected 12");
}

TEST_CASE("of a remote control there are as many channels as the receiver has, and 18 at the most") {
  Told<RcListener> desk;
  const RcListener& is = desk.listener;
  CHECK(is.count() == 0);
  CHECK(is.channelUs(1) == 0);
  CHECK_FALSE(is.hasRssi());
  std::string words = "RC_CHANNELS rssi 99";
  for (int channel = 1; channel <= 18; ++channel) {
    words += " chan" + list(channel) + "_raw " + list(channel == 5 ? 0xFFFF : 1000 + channel);  // one is not known
  }
  for (int count : {8, 18, 19, 255}) {
    desk.tell(words + " chancount " + list(count));
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
  Heard<WaypointListener> desk;
  const int kBearings[][2] = {{-90, 270}, {0, 0}, {1, 1}, {180, 180}, {360, 360}, {-1, 359}};
  for (const auto& bearing : kBearings) {
    CHECK(desk.hears("NAV_CONTROLLER_OUTPUT wp_dist 1234 xtrack_error -2.5 target_bearing " + list(bearing[0])) ==
          "1234 m to " + list(bearing[1]) + ", -250 cm off");
  }
}

TEST_CASE("a wind from components has its direction to within a degree, and its speed") {
  Heard<WindListener> desk(kPx4);
  for (int tenths = 0; tenths < 3600; ++tenths) {
    const double from = tenths / 10.0, radians = from * 3.14159265358979 / 180;
    desk.tell("WIND_COV wind_x " + std::to_string(-20 * cos(radians)) + " wind_y " +
              std::to_string(-20 * sin(radians)) + " wind_z 1.5");
    const WindListener& is = desk.listener;
    const double off = fabs(is.fromDeg() - from);
    CAPTURE(from);
    CHECK(is.fromDeg() < 360);
    CHECK((off > 180 ? 360 - off : off) <= 1);
    CHECK((is.speedCmS() >= 1998 && is.speedCmS() <= 2000));
    CHECK(is.downCmS() == 150);
  }
}

TEST_CASE("a wind comes from where it does not blow to, the faintest too, and a component beyond 300 m/s is none") {
  const struct {
    uint8_t autopilot;
    const char *words, *says;
  } kWinds[] = {
      {kPx4, "WIND_COV wind_x -5", "500 from 0, 0 down"},
      {kPx4, "WIND_COV wind_x 3 wind_y 3", "424 from 225, 0 down"},
      {kPx4, "WIND_COV wind_x 0.01", "1 from 180, 0 down"},
      {kPx4, "WIND_COV wind_x -0.01", "1 from 0, 0 down"},
      {kPx4, "WIND_COV wind_y 0.01", "1 from 270, 0 down"},
      {kPx4, "WIND_COV wind_y -0.01", "1 from 90, 0 down"},
      {kPx4, "WIND_COV", "0 from 0, 0 down"},
      {kPx4, "WIND_COV wind_x nan wind_y 1e30 wind_z nan", "0 from 0, 0 down"},
      {kPx4, "WIND_COV wind_x -300", "30000 from 0, 0 down"},
      {kPx4, "WIND_COV wind_x 300", "30000 from 180, 0 down"},
      {kPx4, "WIND_COV wind_x -300.01", "0 from 0, 0 down"},
      {kPx4, "WIND_COV wind_y 300.01", "0 from 0, 0 down"},
      // ArduPilot's has a direction of any turn, and a speed that is not below 0.
      {kArduPilot, "WIND speed 3.5 speed_z -0.5", "350 from 0, -50 down"},
      {kArduPilot, "WIND direction 359 speed 3.5", "350 from 359, 0 down"},
      {kArduPilot, "WIND direction 360 speed 3.5", "350 from 0, 0 down"},
      {kArduPilot, "WIND direction 361 speed 3.5", "350 from 1, 0 down"},
      {kArduPilot, "WIND direction -1 speed 3.5", "350 from 359, 0 down"},
      {kArduPilot, "WIND direction -90 speed 7 speed_z 1", "700 from 270, 100 down"},
      {kArduPilot, "WIND direction -180 speed 3.5", "350 from 180, 0 down"},
      {kArduPilot, "WIND direction -360 speed 3.5", "350 from 0, 0 down"},
      {kArduPilot, "WIND direction 725 speed 3.5", "350 from 5, 0 down"},
      {kArduPilot, "WIND speed -1", "0 from 0, 0 down"},
      {kArduPilot, "WIND speed 0.01", "1 from 0, 0 down"},
  };
  for (const auto& wind : kWinds) {
    Heard<WindListener> desk(wind.autopilot);
    CHECK(desk.hears(wind.words) == wind.says);
  }
}

TEST_CASE("a square root is rounded down") {
  for (uint32_t root : {0u, 1u, 2u, 500u, 65535u}) CHECK(detail::rootOf(root * root) == root);
  CHECK(detail::rootOf(24) == 4);
}

TEST_CASE("the dialect's messages come over MAVLink 1 as well") {
  CHECK(Heard<WindListener>().hears(messagePartsV1("WIND direction 90 speed 7 speed_z 1")) == "700 from 90, 100 down");
  CHECK(Heard<EstimatorListener>().hears(messagePartsV1("EKF_STATUS_REPORT pos_horiz_variance 0.4 flags 0x33F")) ==
        "831, 50 %");
}
