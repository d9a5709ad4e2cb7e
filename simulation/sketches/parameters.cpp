// The firmware of the tests of Parameters: it reads and sets what lines on Serial tell it. simulation/parameters.py is
// the other end; it writes names and floats into the arrays below.
#include <Arduino.h>
#include <MavMission.h>

#include "ClientTalk.h"

using namespace mavmission;

extern "C" {
char benchName[20] FROM_OUTSIDE;
float benchNumber FROM_OUTSIDE;
}

static MissionClient client(Serial1);
static Parameters parameters(client);

ACTION(read) { tellBegun(parameters.read(benchName)); }
ACTION(readflash) { tellBegun(parameters.read(F("FENCE_ENABLE"))); }
ACTION(set) { tellBegun(parameters.set(benchName, benchNumber)); }
ACTION(setflash) { tellBegun(parameters.set(F("WPNAV_SPEED"), 750.5f)); }
ACTION(setwhole) {
  tellBegun(parameters.setWhole(benchName, numbers[0] == 1 ? -static_cast<int32_t>(numbers[1]) : numbers[1]));
}
ACTION(setwholeflash) { tellBegun(parameters.setWhole(F("MIS_RESTART"), 1)); }
ACTION(value) {
  tell(F("value"), 0);
  uint32_t bits;
  const float number = parameters.value();
  memcpy(&bits, &number, sizeof(bits));
  tellNumber(F("bits"), bits);
  tellNumber(F("whole"), parameters.whole());
  tellNumber(F("iswhole"), parameters.isWhole());
  Serial.println();
}

static const Word words[] = {WORD(read),     WORD(readflash),     WORD(set),  WORD(setflash),
                             WORD(setwhole), WORD(setwholeflash), WORD(value)};

void setup() {
  asm volatile("" : : "r"(&benchName), "r"(&benchNumber) : "memory");
  setUpTalk();
}

void loop() {
  listen(words);
  tellReturned(client.update());
  sleepIfNothingCame(Serial1);
}
