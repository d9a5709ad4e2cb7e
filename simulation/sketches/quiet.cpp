// The firmware of the tests of TelemetryPause: a client beside it on Serial1, told by lines on Serial what to do.
// simulation/quiet.py is the other end.
#include <Arduino.h>
#include <MavMission.h>

#include "ClientTalk.h"

using namespace mavmission;

static MissionClient client(Serial1);
static TelemetryPause quiet(client);
static bool isUsed = true;

ACTION(upload) { client.upload(fromFunction(itemOnTheWayNorth, numbers[0])); }
ACTION(verify) { client.verify(fromFunction(itemOnTheWayNorth, numbers[0])); }
ACTION(used) { isUsed = numbers[0]; }
ACTION(quiet_) {
  tell(F("quiet"), quiet.isPaused());
  tellNumber(F("idle"), quiet.isIdle());
  Serial.println();
}

static const Word words[] = {WORD(upload), WORD(verify), WORD(used), {"quiet", quiet_}};

// Apart, so that its calls can be watched.
extern "C" __attribute__((noinline, noclone)) void updateQuiet() { quiet.update(); }

void setup() { setUpTalk(); }

void loop() {
  listen(words);
  if (isUsed) updateQuiet();
  tellReturned(client.update());
  sleepIfNothingCame(Serial1);
}
