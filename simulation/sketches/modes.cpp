// The firmware of the tests of StandardModes: it sets and reads what lines on Serial tell it. simulation/modes.py is
// the other end.
#include <Arduino.h>
#include <MavMission.h>

#include "Talk.h"

using namespace mavmission;

#ifndef BENCH_BAUD
#define BENCH_BAUD 57600
#endif

static MissionClient client(Serial1);
static StandardModes modes(client);

static void tellBegun(Status status) {
  tell(F("began"), static_cast<uint8_t>(status));
  Serial.println();
}

ACTION(set) { tellBegun(modes.set(static_cast<StandardMode>(numbers[0]))); }
ACTION(read) { tellBegun(modes.read(numbers[0])); }
ACTION(setmode) { tellBegun(client.setMode(static_cast<FlightMode>(numbers[0]))); }
ACTION(custom) { tellBegun(client.setCustomMode(modes.customMode())); }
ACTION(cancel) { client.cancel(); }
ACTION(entry) {
  tell(F("entry"), static_cast<uint8_t>(modes.mode()));
  tellNumber(F("count"), modes.count());
  tellNumber(F("custom"), modes.customMode());
  tellNumber(F("selectable"), modes.isSelectable());
  tellNumber(F("current"), static_cast<uint8_t>(modes.current()));
  Serial.print(' ');
  Serial.println(modes.name());
}

static const Word words[] = {WORD(set), WORD(read), WORD(setmode), WORD(custom), WORD(cancel), WORD(entry)};

void setup() {
  Serial.begin(500000);
  Serial1.begin(BENCH_BAUD);
  setUpSleep();
  Serial.println(F("ready"));
}

void loop() {
  listen(words);
  const Status status = client.update();
  tellReturned(status);
  sleepIfNothingCame(Serial1);
}
