// The firmware of the tests of telemetry: its listeners beside a client on Serial1, told by lines on Serial what to do.
// simulation/telemetry.py is the other end.
#include <Arduino.h>
#include <MavMission.h>

#include "ClientTalk.h"

using namespace mavmission;

#ifndef BENCH_INTERVAL_MS
#define BENCH_INTERVAL_MS 500
#endif

static MissionClient client(Serial1);
static PositionListener position(client, BENCH_INTERVAL_MS);
static AttitudeListener attitude(client, BENCH_INTERVAL_MS);
static BatteryListener battery(client, BENCH_INTERVAL_MS);
static GpsListener gps(client, BENCH_INTERVAL_MS);
static RcListener rc(client, BENCH_INTERVAL_MS);
static HudListener hud(client, BENCH_INTERVAL_MS);
static RadioListener radio(client);
#ifdef BENCH_WAYPOINT
static WaypointListener waypoint_(client, BENCH_INTERVAL_MS);
#endif
#if MAVMISSION_MAX_PAYLOAD >= 60
static HomeListener home(client, BENCH_INTERVAL_MS);
#endif
#ifdef BENCH_FOLLOWER
static MissionFollower follower(client);
#endif

static void tellLatLon(const LatLon& where) {
  tellNumber(F("lat"), where.latitude.e7());
  tellNumber(F("lon"), where.longitude.e7());
}

template <typename T>
static void tellHeard(T& listener) {
  tellNumber(F("heard"), listener.isHeard());
  tellNumber(F("age"), listener.ageMs());
  tellNumber(F("confirmed"), listener.isConfirmed());
  tellNumber(F("new"), listener.isNew());
}

ACTION(position_) {
  tell(F("position"), 0);
  tellHeard(position);
  tellNumber(F("place"), position.hasPlace());
  tellLatLon(position.place());
  tellNumber(F("hasheights"), position.hasHeights());
  tellNumber(F("sea"), position.aboveSeaLevelMm());
  tellNumber(F("above"), position.aboveHomeMm());
  tellNumber(F("homesea"), position.homeAboveSeaLevelMm());
  uint32_t bits;
  const float metres = position.altitude().metres();
  memcpy(&bits, &metres, sizeof(bits));
  tellNumber(F("altitude"), bits);
  tellNumber(F("north"), position.northCmS());
  tellNumber(F("east"), position.eastCmS());
  tellNumber(F("down"), position.downCmS());
  tellNumber(F("speed"), position.speedCmS());
  tellNumber(F("hasheading"), position.hasHeading());
  tellNumber(F("heading"), position.heading().e7());
  tellNumber(F("cdeg"), position.headingCdeg());
  Serial.println();
}
ACTION(attitude_) {
  tell(F("attitude"), 0);
  tellHeard(attitude);
  tellNumber(F("roll"), attitude.roll().e7());
  tellNumber(F("pitch"), attitude.pitch().e7());
  tellNumber(F("yaw"), attitude.yaw().e7());
  Serial.println();
}
ACTION(battery_) {
  tell(F("battery"), 0);
  tellHeard(battery);
  tellNumber(F("mv"), battery.voltageMv());
  tellNumber(F("hascurrent"), battery.hasCurrent());
  tellNumber(F("ca"), battery.currentCa());
  tellNumber(F("hasconsumed"), battery.hasConsumed());
  tellNumber(F("mah"), battery.consumedMah());
  tellNumber(F("hasremaining"), battery.hasRemaining());
  tellNumber(F("percent"), battery.remainingPercent());
  tellNumber(F("hastemperature"), battery.hasTemperature());
  tellNumber(F("cdeg"), battery.temperatureCdeg());
  Serial.println();
}
ACTION(gps_) {
  tell(F("gps"), 0);
  tellHeard(gps);
  tellNumber(F("fix"), static_cast<uint8_t>(gps.fix()));
  tellNumber(F("hasfix"), gps.hasFix());
  tellNumber(F("hassatellites"), gps.hasSatellites());
  tellNumber(F("satellites"), gps.satellites());
  tellLatLon(gps.place());
  tellNumber(F("sea"), gps.aboveSeaLevelMm());
  tellNumber(F("hdop"), gps.hdopHundredths());
  tellNumber(F("accuracy"), gps.accuracyMm());
  tellNumber(F("speed"), gps.speedCmS());
  tellNumber(F("course"), gps.courseCdeg());
  Serial.println();
}
ACTION(rc_) {
  tell(F("rc"), 0);
  tellHeard(rc);
  tellNumber(F("count"), rc.count());
  tellNumber(F("hasrssi"), rc.hasRssi());
  tellNumber(F("rssi"), rc.rssi());
  for (uint8_t number = 0; number <= 19; ++number) {
    Serial.print(F(" ch"));
    Serial.print(number);
    Serial.print('=');
    Serial.print(rc.channelUs(number));
  }
  Serial.println();
}
ACTION(hud_) {
  tell(F("hud"), 0);
  tellHeard(hud);
  tellNumber(F("hasairspeed"), hud.hasAirspeed());
  tellNumber(F("air"), hud.airspeedCmS());
  tellNumber(F("ground"), hud.groundSpeedCmS());
  tellNumber(F("climb"), hud.climbCmS());
  tellNumber(F("throttle"), hud.throttlePercent());
  tellNumber(F("heading"), hud.headingDeg());
  Serial.println();
}
ACTION(radio_) {
  tell(F("radio"), 0);
  tellNumber(F("heard"), radio.isHeard());
  tellNumber(F("age"), radio.ageMs());
  tellNumber(F("new"), radio.isNew());
  tellNumber(F("rssi"), radio.rssi());
  tellNumber(F("remote"), radio.remoteRssi());
  tellNumber(F("noise"), radio.noise());
  tellNumber(F("remotenoise"), radio.remoteNoise());
  tellNumber(F("free"), radio.freeBufferPercent());
  tellNumber(F("errors"), radio.receiveErrors());
  tellNumber(F("corrected"), radio.corrected());
  Serial.println();
}
#ifdef BENCH_WAYPOINT
ACTION(target_) {
  tell(F("waypoint"), 0);
  tellHeard(waypoint_);
  tellNumber(F("distance"), waypoint_.distanceM());
  tellNumber(F("bearing"), waypoint_.bearingDeg());
  tellNumber(F("track"), waypoint_.crossTrackCm());
  Serial.println();
}
#endif
#if MAVMISSION_MAX_PAYLOAD >= 60
ACTION(home_) {
  tell(F("home"), 0);
  tellHeard(home);
  tellLatLon(home.place());
  tellNumber(F("sea"), home.aboveSeaLevelMm());
  Serial.println();
}
#endif
ACTION(upload) { client.upload(fromFunction(itemOnTheWayNorth, numbers[0])); }
ACTION(interval) { client.setMessageInterval(numbers[0], numbers[1]); }

static const Word words[] = {
    {"position", position_}, {"attitude", attitude_}, {"battery", battery_}, {"gps", gps_}, {"rc", rc_}, WORD(upload),
    WORD(interval),          {"hud", hud_},           {"radio", radio_},
#ifdef BENCH_WAYPOINT
    {"waypoint", target_},
#endif
#if MAVMISSION_MAX_PAYLOAD >= 60
    {"home", home_},
#endif
};

void setup() { setUpTalk(); }

void loop() {
  listen(words);
  tellReturned(client.update());
  sleepIfNothingCame(Serial1);
}
