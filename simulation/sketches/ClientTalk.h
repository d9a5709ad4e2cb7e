// What the firmwares with a MissionClient on Serial1 tell of it, and how each begins.
#pragma once

#include <MavMission.h>

#include "Talk.h"

#ifndef BENCH_BAUD
#define BENCH_BAUD 57600
#endif

// Written and read by the test, from outside.
#define FROM_OUTSIDE __attribute__((used, externally_visible))

inline void setUpTalk(uint32_t baud = BENCH_BAUD) {
  Serial.begin(500000);
  Serial1.begin(baud);
  setUpSleep();
  Serial.println(F("ready"));
}

inline void tellBegun(mavmission::Status status) {
  tell(F("began"), static_cast<uint8_t>(status));
  Serial.println();
}

// What update() has returned: each end, and each change.
inline void tellReturned(mavmission::Status status) {
  static mavmission::Status last = mavmission::Status::Idle;
  if (status == last && !isEnd(status)) return;
  last = status;
  tell(F("returned"), static_cast<uint8_t>(status));
  Serial.println();
}

inline void tellCounters(const mavmission::LinkCounters& counters) {
  tell(F("counters"), 0);
  tellNumber(F("bytes"), counters.bytes);
  tellNumber(F("skipped"), counters.bytesSkipped);
  tellNumber(F("frames"), counters.frames);
  tellNumber(F("unknown"), counters.unknownMessages);
  tellNumber(F("bad"), counters.badChecksums);
  tellNumber(F("broken"), counters.brokenFrames);
  tellNumber(F("lost"), counters.framesLost);
  tellNumber(F("sent"), counters.framesSent);
  Serial.println();
}

// A plan of any length, for fromFunction().
inline bool itemOnTheWayNorth(void*, uint16_t index, mavmission::MissionItem& item) {
  using namespace mavmission;
  item = waypoint(47.3977420_deg + Degrees::fromE7(100) * index, 8.5455970_deg, 20_m);
  return true;
}

// Each so many milliseconds, loop() takes so many milliseconds longer.
static uint16_t stallEachMs, stallMs;

inline void setStall(const Numbers& numbers) {
  stallEachMs = numbers[0];
  stallMs = numbers[1];
}

inline void stallWhereDue() {
  static uint16_t stalledMs;
  const uint16_t nowMs = millis();
  if (stallMs == 0 || static_cast<uint16_t>(nowMs - stalledMs) < stallEachMs) return;
  stalledMs = nowMs;
  delay(stallMs);
}
