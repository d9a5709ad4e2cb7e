// An upload of 24 items whose update() can be watched, in a loop that can be made to stall.
#include <Arduino.h>
#include <MavMission.h>

#include "items.h"

using namespace mavmission;

MissionClient autopilot(Serial1);
volatile uint16_t stallMs;
volatile uint8_t ended;

extern "C" __attribute__((noinline)) Status measured_update() { return autopilot.update(); }

void setup() {
  Serial1.begin(BAUD);
  autopilot.upload(inFlash(plan));
}

void loop() {
  if (stallMs != 0) delay(stallMs);
  const Status status = measured_update();
  if (isEnd(status)) ended = static_cast<uint8_t>(status);
}
