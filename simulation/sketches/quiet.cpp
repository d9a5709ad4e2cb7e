// The firmware of the tests of TelemetryPause: a client beside it on Serial1, told by lines on Serial what to do.
// simulation/quiet.py is the other end.
#include <Arduino.h>
#include <MavMission.h>

#include "ClientTalk.h"

using namespace mavmission;

static MissionClient client(Serial1);
#ifdef BENCH_QUIET_LIST
const PausableMessage silent[] PROGMEM = {{0, 0}, {30, 500}, {42, 0}, {253, 0}, {9999, 0}, {24, 0}};
static TelemetryPause quiet(client, silent);
#else
static TelemetryPause quiet(client);
#endif
static bool isUsed = true;

static bool takeItem(void*, uint16_t, const MissionItem&) { return true; }

ACTION(upload) { client.upload(fromFunction(itemOnTheWayNorth, numbers[0])); }
ACTION(verify) { client.verify(fromFunction(itemOnTheWayNorth, numbers[0])); }
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

void setup() { setUpTalk(); }

void loop() {
  listen(words);
  if (isUsed) updateQuiet();
  tellReturned(client.update());
  sleepIfNothingCame(Serial1);
}
