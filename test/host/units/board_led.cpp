// The LED of a board whose pin the sketch names: made an output once, and written only when it changes, since a write
// may wait for the LED's own line (an ESP32's colour LED, a Pico W's).
#include <doctest/doctest.h>

#include <Arduino.h>

#include <string>

#include "mavmission/base/Status.h"

#define HIGH 1
#define LOW 0
#define OUTPUT 1
#define STATUS_LED 5

namespace {

std::string gDone;  // what the pin was told, a letter each

void pinMode(int pin, int mode) {
  CHECK(pin == 5);
  CHECK(mode == OUTPUT);
  gDone += 'o';
}

void digitalWrite(int pin, int level) {
  CHECK(pin == 5);
  gDone += level == HIGH ? '1' : '0';
}

}  // namespace

#include "MavMissionLed.h"

using namespace mavmission;

// What a second of loop()s tells the pin, one each millisecond.
static std::string inASecond(Status status) {
  gDone.clear();
  for (int passed = 0; passed < 1024; ++passed) {
    setMillis(millis() + 1);
    showOnLed(status);
  }
  return gDone;
}

TEST_CASE("The pin of an LED is written when the light changes, and not with each loop()") {
  setMillis(0);
  CHECK(inASecond(Status::Transferring) == "o0");
  CHECK(inASecond(Status::Transferring) == "");
  setMillis(2048 - 1);
  CHECK(inASecond(Status::Accepted) == "");
  CHECK(inASecond(Status::Accepted) == "1");
  CHECK(inASecond(Status::Accepted) == "0");
  setMillis(4096 - 1);
  CHECK(inASecond(Status::TimedOut) == "1010101");
  CHECK(inASecond(Status::Transferring) == "0");
}
