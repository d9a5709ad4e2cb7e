// The firmware of the tests of a Vehicle: its listeners, made when a line on Serial first asks for them, beside a
// client on Serial1. simulation/vehicle.py is the other end.
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
ACTION(last) {
  TextListener& texts = vehicle.texts();
  tell(F("last"), texts.lastSeverity());
  Serial.print(texts.isNew() ? F(" new ") : F(" old "));
  Serial.println(texts.lastText());
}
ACTION(upload) { client.upload(fromFunction(itemOnTheWayNorth, numbers[0])); }

static const Word words_[] = {WORD(health), WORD(estimator), WORD(vibration), WORD(wind),  {"vehicle", vehicle_},
                              WORD(words),  WORD(texts),     WORD(last),      WORD(upload)};

void setup() { setUpTalk(); }

void loop() {
  listen(words_);
  tellReturned(client.update());
  sleepIfNothingCame(Serial1);
}
