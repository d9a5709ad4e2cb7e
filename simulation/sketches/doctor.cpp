// The firmware of the LinkDoctor's tests: a client and its doctor on Serial1, told by lines on Serial what to do.
// simulation/doctor.py is the other end.
#include <Arduino.h>
#include <MavMission.h>

#include "ClientTalk.h"

using namespace mavmission;

static MissionClient client(Serial1);
static LinkDoctor doctor(client);
static uint32_t baud = 57600;
static Verdict lastVerdict = Verdict::Listening;

static void setBaud(void*, uint32_t tried) {
  Serial1.begin(tried);
  Serial.print(millis());
  Serial.print(F(" opened "));
  Serial.println(tried);
}

ACTION(open) {
  baud = numbers[0];
  Serial1.begin(baud);
}
ACTION(bauds) { doctor.tryBauds(setBaud, baud); }
ACTION(stall) { setStall(numbers); }
ACTION(doctor_) {
  tell(F("doctor"), static_cast<uint8_t>(doctor.verdict()));
  tellNumber(F("baud"), doctor.baud());
  Serial.println();
}

static const Word words[] = {WORD(open), WORD(bauds), WORD(stall), {"doctor", doctor_}};

// Apart, so that its calls can be watched.
extern "C" __attribute__((noinline, noclone)) Verdict updateDoctor() { return doctor.update(); }

void setup() { setUpTalk(baud); }

void loop() {
  listen(words);
  stallWhereDue();
  const Verdict verdict = updateDoctor();
  tellReturned(client.update());
  if (verdict != lastVerdict) {
    lastVerdict = verdict;
    tell(F("verdict"), static_cast<uint8_t>(verdict));
    Serial.println();
  }
  sleepIfNothingCame(Serial1);
}
