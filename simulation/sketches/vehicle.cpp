// The firmware of the tests of a Vehicle and of the listeners beside it: each is made when a line on Serial first asks
// for it, beside a client on Serial1. simulation/vehicle.py is the other end.
#include <Arduino.h>
#include <MavMission.h>

#include "ClientTalk.h"

using namespace mavmission;

MissionClient client(Serial1);  // not static: see Vehicle
static Vehicle<client, 500> vehicle;

template <typename T>
static void tellHeard(T& listener) {
  tellNumber(F("heard"), listener.isHeard());
  tellNumber(F("age"), listener.ageMs());
  tellNumber(F("confirmed"), listener.isConfirmed());
  tellNumber(F("new"), listener.isNew());
}

static void tellLatLon(const LatLon& where) {
  tellNumber(F("lat"), where.latitude.e7());
  tellNumber(F("lon"), where.longitude.e7());
}

// A verdict: its reason, the word for it.
static void tellReason(FitReason reason, Fitness fitness) {
  tellNumber(F("reason"), static_cast<uint8_t>(reason));
  tellNumber(F("fitness"), static_cast<uint8_t>(fitness));
}

ACTION(health) {
  HealthListener& health = vehicle.health();
  tell(F("health"), 0);
  tellHeard(health);
  tellReason(health.reason(), health.fitness());
  tellNumber(F("failed"), health.failedSensors());
  tellNumber(F("load"), health.loadPermille());
  Serial.println();
}
ACTION(estimator) {
  EstimatorListener& estimator = vehicle.estimator();
  tell(F("estimator"), 0);
  tellHeard(estimator);
  tellReason(estimator.reason(), estimator.fitness());
  tellNumber(F("worst"), estimator.worstPercent());
  tellNumber(F("flags"), estimator.flags());
  Serial.println();
}
ACTION(vibration) {
  VibrationListener& vibration = vehicle.vibration();
  tell(F("vibration"), 0);
  tellHeard(vibration);
  tellReason(vibration.reason(), vibration.fitness());
  tellNumber(F("worst"), vibration.worstCmS2());
  tellNumber(F("clipping"), vibration.clipping());
  Serial.println();
}
ACTION(wind) {
  WindListener& wind = vehicle.wind();
  tell(F("wind"), 0);
  tellHeard(wind);
  tellNumber(F("speed"), wind.speedCmS());
  tellNumber(F("from"), wind.fromDeg());
  tellNumber(F("down"), wind.downCmS());
  Serial.println();
}
ACTION(position_) {
  PositionListener& position = vehicle.position();
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
  AttitudeListener& attitude = vehicle.attitude();
  tell(F("attitude"), 0);
  tellHeard(attitude);
  tellNumber(F("roll"), attitude.roll().e7());
  tellNumber(F("pitch"), attitude.pitch().e7());
  tellNumber(F("yaw"), attitude.yaw().e7());
  Serial.println();
}
ACTION(battery_) {
  BatteryListener& battery = vehicle.battery();
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
  GpsListener& gps = vehicle.gps();
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
  static RcListener rc(client, 500);
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
  HudListener& hud = vehicle.hud();
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
  static RadioListener radio(client);
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
ACTION(target_) {
  WaypointListener& waypoint = vehicle.waypoint();
  tell(F("waypoint"), 0);
  tellHeard(waypoint);
  tellNumber(F("distance"), waypoint.distanceM());
  tellNumber(F("bearing"), waypoint.bearingDeg());
  tellNumber(F("track"), waypoint.crossTrackCm());
  Serial.println();
}
ACTION(home_) {
  static HomeListener home(client, 500);
  tell(F("home"), 0);
  tellHeard(home);
  tellLatLon(home.place());
  tellNumber(F("sea"), home.aboveSeaLevelMm());
  Serial.println();
}
ACTION(vehicle_) {
  tell(F("vehicle"), 0);
  tellReason(vehicle.whyNotFit(), vehicle.fitness());
  tellNumber(F("heard"), vehicle.isHeard());
  tellNumber(F("armed"), vehicle.isArmed());
  tellNumber(F("auto"), vehicle.isInMode(FlightMode::Auto));
  tellNumber(F("lat"), vehicle.position().place().latitude.e7());
  tellNumber(F("yaw"), vehicle.attitude().yaw().e7());
  tellNumber(F("mv"), vehicle.battery().voltageMv());
  tellNumber(F("satellites"), vehicle.gps().satellites());
  tellNumber(F("throttle"), vehicle.hud().throttlePercent());
  tellNumber(F("distance"), vehicle.waypoint().distanceM());
  Serial.println();
}
ACTION(words) {
  tell(F("words"), 0);
  Serial.print(' ');
  Serial.print(vehicle.modeName());
  Serial.print('|');
  Serial.print(toString(vehicle.fitness()));
  Serial.print('|');
  Serial.println(toString(vehicle.whyNotFit()));
}
static void tellText(void*, uint8_t severity, const char* text) {
  tell(F("text"), severity);
  Serial.print(' ');
  Serial.println(text);
}
ACTION(texts) { vehicle.texts().onText(tellText); }

static const Word words_[] = {{"position", position_},
                              {"attitude", attitude_},
                              {"battery", battery_},
                              {"gps", gps_},
                              {"rc", rc_},
                              {"hud", hud_},
                              {"radio", radio_},
                              {"waypoint", target_},
                              {"home", home_},
                              WORD(health),
                              WORD(estimator),
                              WORD(vibration),
                              WORD(wind),
                              {"vehicle", vehicle_},
                              WORD(words),
                              WORD(texts)};

void setup() { setUpTalk(); }

void loop() {
  listen(words_);
  tellReturned(client.update());
  sleepIfNothingCame(Serial1);
}
