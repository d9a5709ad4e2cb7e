// The firmware of the tests of SensorMessages.h: lines on Serial fill the messages, and send them once or again and
// again. simulation/sensors.py is the other end.
#include <Arduino.h>
#include <MavMission.h>

#include "ClientTalk.h"

using namespace mavmission;

static MissionClient client(Serial1);
static ObstacleDistance around(20, 1500, 15, 3);
static ObstacleDistance dense(20, 1500, 2);
static GpsInput gps(1), first;
static GpsInput* const receivers[] = {&gps, &first};
static VisionPosition vision;
static Odometry odometry, northern(1);
static Odometry* const odometries[] = {&odometry, &northern};

// A float comes as its bits.
static float real(uint32_t bits) {
  float number;
  memcpy(&number, &bits, sizeof(number));
  return number;
}

static bool send(uint8_t which) {
  switch (which) {
    case 0: return client.sendMessage(around);
    case 1: return client.sendMessage(gps);
    case 2: return client.sendMessage(vision);
    case 3: return client.sendMessage(odometry);
    case 4: return client.sendMessage(dense);
    case 5: return client.sendMessage(first);
    default: return client.sendMessage(northern);
  }
}

static uint8_t streamed;
static uint16_t everyMs, streamedMs;

ACTION(obstacle) { around.set(numbers[0], numbers[1]); }
ACTION(nothing) { around.setFree(numbers[0]); }
ACTION(unknown) { around.setUnknown(numbers[0]); }
ACTION(forget) { around.setUnknown(); }

ACTION(place) {
  const LatLon at = {Degrees::fromE7(numbers[0]), Degrees::fromE7(numbers[1])};
  const GpsFix fix = static_cast<GpsFix>(numbers[3] & 0xFF);
  for (GpsInput* one : receivers) one->set(at, Metres(real(numbers[2])), fix, numbers[3] >> 8);
}
ACTION(moves) {
  for (GpsInput* one : receivers) one->setVelocity(real(numbers[0]), real(numbers[1]), real(numbers[2]));
}
ACTION(accuracy) {
  for (GpsInput* one : receivers) one->setAccuracy(real(numbers[0]), real(numbers[1]), real(numbers[2]));
}
ACTION(dilution) {
  for (GpsInput* one : receivers) one->setDilution(real(numbers[0]), real(numbers[1]));
}
ACTION(week) {
  for (GpsInput* one : receivers) one->setTime(numbers[0], numbers[1]);
}
ACTION(heading) { gps.setHeading(numbers[0]); }

static float roll, pitch;
ACTION(tilt) {
  roll = real(numbers[0]);
  pitch = real(numbers[1]);
}
ACTION(seen) { vision.set(real(numbers[0]), real(numbers[1]), real(numbers[2]), roll, pitch, real(numbers[3])); }
ACTION(seenVariance) { vision.setVariance(real(numbers[0]), real(numbers[1])); }
ACTION(seenReset) { vision.countReset(); }

static float turned[4] = {1, 0, 0, 0};
ACTION(turn) {
  for (uint8_t i = 0; i < 4; ++i) turned[i] = real(numbers[i]);
}
ACTION(pose) {
  for (Odometry* one : odometries) {
    one->setPose(real(numbers[0]), real(numbers[1]), real(numbers[2]), turned[0], turned[1], turned[2], turned[3]);
  }
}
ACTION(speed) {
  for (Odometry* one : odometries) one->setVelocity(real(numbers[0]), real(numbers[1]), real(numbers[2]));
}
ACTION(rotation) { odometry.setRotation(real(numbers[0]), real(numbers[1]), real(numbers[2])); }
ACTION(variance) { odometry.setVariance(real(numbers[0]), real(numbers[1]), real(numbers[2])); }
ACTION(quality) { odometry.setQuality(static_cast<int8_t>(numbers[0])); }
ACTION(reset) { odometry.countReset(); }

ACTION(send_) {
  tell(F("sent"), send(numbers[0]));
  Serial.println();
}
ACTION(each) {
  streamed = numbers[0];
  everyMs = numbers[1];
}

static const Word words[] = {
    WORD(obstacle), WORD(nothing),  WORD(unknown), WORD(forget),    WORD(place),        WORD(moves),
    WORD(accuracy), WORD(dilution), WORD(week),    WORD(heading),   WORD(tilt),         WORD(seen),
    WORD(turn),     WORD(pose),     WORD(speed),   WORD(rotation),  WORD(seenVariance), WORD(seenReset),
    WORD(variance), WORD(quality),  WORD(reset),   {"send", send_}, WORD(each),
};

void setup() { setUpTalk(); }

void loop() {
  listen(words);
  tellReturned(client.update());
  const uint16_t nowMs = millis();
  if (everyMs != 0 && static_cast<uint16_t>(nowMs - streamedMs) >= everyMs && send(streamed)) streamedMs = nowMs;
  sleepIfNothingCame(Serial1);
}
