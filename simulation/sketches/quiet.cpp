// The firmware of the tests of TelemetryPause: a client beside it on Serial1, told by lines on Serial what to do.
// simulation/quiet.py is the other end.
#include <Arduino.h>
#include <MavMission.h>

#include "Talk.h"

using namespace mavmission;

#ifndef BENCH_BAUD
#define BENCH_BAUD 57600
#endif

static MissionClient client(Serial1);
#ifdef BENCH_QUIET_LIST
const PausableMessage silent[] PROGMEM = {{0, 0}, {30, 500}, {42, 0}, {253, 0}, {9999, 0}, {24, 0}};
static TelemetryPause quiet(client, silent);
#else
static TelemetryPause quiet(client);
#endif
static bool isUsed = true;

static bool place(void*, uint16_t index, MissionItem& item) {
  item = waypoint(47.3977420_deg + Degrees::fromE7(100) * index, 8.5455970_deg, 20_m);
  return true;
}

static bool takeItem(void*, uint16_t, const MissionItem&) { return true; }

ACTION(upload) { client.upload(fromFunction(place, numbers[0])); }
ACTION(verify) { client.verify(fromFunction(place, numbers[0])); }
ACTION(download) { client.download(toFunction(takeItem)); }
ACTION(clear) { client.clear(); }
ACTION(arm) { client.arm(); }
ACTION(interval) { client.setMessageInterval(numbers[0], numbers[1]); }
ACTION(cancel) { client.cancel(); }
ACTION(used) { isUsed = numbers[0]; }
ACTION(quiet_) {
  tell(F("quiet"), quiet.isPaused());
  tellNumber(F("idle"), quiet.isIdle());
  Serial.println();
}

static const Word words[] = {WORD(upload), WORD(verify),   WORD(download), WORD(clear),      WORD(arm),
                             WORD(cancel), WORD(interval), WORD(used),     {"quiet", quiet_}};

// Apart, so that its calls can be watched.
extern "C" __attribute__((noinline, noclone)) void updateQuiet() { quiet.update(); }

void setup() {
  Serial.begin(500000);
  Serial1.begin(BENCH_BAUD);
  setUpSleep();
  Serial.println(F("ready"));
}

void loop() {
  listen(words);
  if (isUsed) updateQuiet();
  const Status status = client.update();
  tellReturned(status);
  sleepIfNothingCame(Serial1);
}
