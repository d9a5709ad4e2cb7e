// The firmware of the tests of StandardModes: it sets and reads what lines on Serial tell it. simulation/modes.py is
// the other end.
#include <Arduino.h>
#include <MavMission.h>

#include "ClientTalk.h"

using namespace mavmission;

static MissionClient client(Serial1);
static StandardModes modes(client);

ACTION(set) { tellBegun(modes.set(static_cast<StandardMode>(numbers[0]))); }
ACTION(read) { tellBegun(modes.read(numbers[0])); }
ACTION(custom) { tellBegun(client.setCustomMode(modes.customMode())); }
ACTION(entry) {
  tell(F("entry"), static_cast<uint8_t>(modes.mode()));
  tellNumber(F("count"), modes.count());
  tellNumber(F("custom"), modes.customMode());
  tellNumber(F("selectable"), modes.isSelectable());
  tellNumber(F("current"), static_cast<uint8_t>(modes.current()));
  Serial.print(' ');
  Serial.println(modes.name());
}

static const Word words[] = {WORD(set), WORD(read), WORD(custom), WORD(entry)};

void setup() { setUpTalk(); }

void loop() {
  listen(words);
  tellReturned(client.update());
  sleepIfNothingCame(Serial1);
}
