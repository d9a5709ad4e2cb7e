// The firmware of the tests of SensorMessages.h and PayloadMessages.h: lines on Serial fill the messages, and send them
// once or again and again. simulation/sensors.py is the other end.
#include <Arduino.h>
#include <MavMission.h>

#include "ClientTalk.h"

using namespace mavmission;

static MissionClient client(Serial1);
static ObstacleDistance around(20, 1500, 15, 3);
static GpsInput gps(1);
static VisionPosition vision;
static Odometry odometry;
static DistanceSensor distance(20, 700, 25, 3, 1);
static LandingTarget target(2);
static LandingTargetPosition landingPlace(3);
static NamedValue value("more than ten letters");
static TextMessage text;

static const OutgoingMessage messages[] = {around, gps, vision, odometry, distance, target, landingPlace, value, text};

static bool send(uint8_t which) { return client.sendMessage(messages[which]); }

static uint8_t streamed;
static uint16_t everyMs, streamedMs;

ACTION(fill) {
  around.set(0, 345);
  around.set(71, 1500);
  around.setFree(7);
  gps.set({Degrees::fromE7(-353632620), Degrees::fromE7(1491652370)}, Metres(584.25f), GpsFix::RtkFixed, 21);
  gps.setVelocity(1.5f, -2.5f, 0.25f);
  gps.setAccuracy(0.5f, 0.75f, 0.125f);
  gps.setDilution(0.9f, 1.1f);
  gps.setTime(2345, 604799999);
  gps.setHeading(36000);
  vision.set(1.5f, -2.25f, -3.5f, 0.125f, -0.25f, 3);
  vision.setVariance(0.0625f, 0.015625f);
  vision.countReset();
  odometry.setPose(1.5f, -2.25f, -3.5f, 0.5f, -0.5f, 0.5f, 0.5f);
  odometry.setVelocity(0.75f, -0.25f, 0.125f);
  odometry.setRotation(0.03125f, -0.5f, 0.25f);
  odometry.setVariance(0.0625f, 0.015625f, 0.25f);
  odometry.setQuality(-1);
  odometry.countReset();
  distance.set(345);
  target.set(0.25f, -0.5f, 3);
  landingPlace.setFromOrigin(-30.25f, 12, -0.5f);
  value.set(-1.5f);
  text.set(4, F("a text of more than fifty characters, which are the most"));
}
ACTION(send_) {
  tell(F("sent"), send(numbers[0]));
  Serial.println();
}
ACTION(each) {
  streamed = numbers[0];
  everyMs = numbers[1];
}

static const Word words[] = {WORD(fill), {"send", send_}, WORD(each)};

void setup() { setUpTalk(); }

void loop() {
  listen(words);
  tellReturned(client.update());
  const uint16_t nowMs = millis();
  if (everyMs != 0 && static_cast<uint16_t>(nowMs - streamedMs) >= everyMs && send(streamed)) streamedMs = nowMs;
  sleepIfNothingCame(Serial1);
}
