// A button that has to be held: what its pin shows, millisecond by millisecond, and when it counts as pressed.
#include <doctest/doctest.h>

#include <Arduino.h>

#include <initializer_list>
#include <string>

#define HIGH 1
#define LOW 0
#define INPUT_PULLUP 2

namespace {

int gLevel;
std::string gModes;

void pinMode(int pin, int mode) { gModes += std::to_string(pin) + ":" + std::to_string(mode); }
int digitalRead(int) { return gLevel; }

}  // namespace

#include "MavMissionButton.h"

using namespace mavmission;

TEST_CASE("a button counts once each time that it is held without a break, and only after a release") {
  const struct {
    std::initializer_list<int> levelsMs;  // from the first moment on: so long up, so long down, and so on
    const char* pressedMs;
  } kHands[] = {
      {{100, 999, 100}, ""},
      {{100, 1000, 100}, ""},  // it shows down for 1000 ms: from the first of them to the last pass 999
      {{100, 5000, 100}, "1100 "},
      {{100, 1500, 60, 1500, 60}, "1100 2660 "},
      {{100, 1500, 40, 1500, 60}, "1100 "},  // a bounce is no release
      {{100, 600, 1, 600, 1, 600, 60}, ""},  // nor is it held
      {{0, 9000}, ""},                       // stuck, or held down at power-on
      {{0, 9000, 60, 1100, 60}, "10060 "},
      {{0, 500, 20, 3000, 51, 1100}, "4571 "},
  };
  for (const auto& hand : kHands) {
    gModes.clear();
    HoldButton button(7);
    std::string pressed;
    int ms = 0;
    gLevel = HIGH;
    for (int length : hand.levelsMs) {
      for (int i = 0; i < length; ++i, ++ms) {
        setMillis(static_cast<uint32_t>(ms) + 0xFFFFFC00);
        if (button.isPressed()) pressed += std::to_string(ms) + " ";
      }
      gLevel = gLevel == HIGH ? LOW : HIGH;
    }
    CHECK(pressed == hand.pressedMs);
    CHECK(gModes == "7:2");
  }
}
