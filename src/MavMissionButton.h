// A button that begins something dangerous: it has to be held.
#pragma once

#include <Arduino.h>
#include <stdint.h>

namespace mavmission {

// A button that joins its pin to GND. It counts as pressed, once, when it has been held without a break; then it must
// be released before it counts again. So neither a bounce nor a short touch, a second press nor a button that is stuck,
// or held down at power-on, does anything.
//
//   HoldButton button(2);
//   ...
//   if (button.isPressed()) start();
class HoldButton {
 public:
  // `pin`: with its pull-up, which isPressed() switches on. `holdMs`: for so long it has to be held.
  explicit HoldButton(uint8_t pin, uint16_t holdMs = 1000) : holdMs_(holdMs), pin_(pin) {}

  // True once for each time that it was held. To be called from loop().
  bool isPressed() {
    if (!isSet_) pinMode(pin_, INPUT_PULLUP);
    isSet_ = true;
    const uint32_t nowMs = millis();
    if (digitalRead(pin_) == HIGH) {
      if (isDown_) changedMs_ = nowMs;
      isDown_ = false;
      if (nowMs - changedMs_ >= kBounceMs) isArmed_ = true;
      return false;
    }
    if (!isDown_) changedMs_ = nowMs;
    isDown_ = true;
    if (!isArmed_ || nowMs - changedMs_ < holdMs_) return false;
    isArmed_ = false;
    return true;
  }

 private:
  static constexpr uint8_t kBounceMs = 50;

  uint32_t changedMs_ = 0;
  uint16_t holdMs_;
  uint8_t pin_;
  bool isSet_ = false;
  bool isDown_ = true;
  bool isArmed_ = false;  // it has been seen released
};

}  // namespace mavmission
