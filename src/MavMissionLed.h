// Shows on the board's own LED how an operation ended, without a computer: showOnLed(autopilot.status()) in loop().
// Dark: it has not ended yet. One blink in two seconds: it ended well. Four blinks a second: it failed. If a board's
// LED is lit by LOW, it is lit in place of dark; the blinking is the same. Include this after MavMission.h.
//
// To choose another LED, write this before the #include:
//
//   #define STATUS_LED 5      // another pin
#pragma once

#include <Arduino.h>

// For an ESP32 board whose core defines no LED_BUILTIN: most development boards have an LED on this pin, many others
// have none.
#if !defined(STATUS_LED) && !defined(LED_BUILTIN) && defined(CONFIG_IDF_TARGET_ESP32)
#define STATUS_LED 2
#endif

// The port and the bit of pin 13, on an Arduino Mega, on an Uno or a Nano, and on a Leonardo: writing it takes one
// instruction, while digitalWrite() with its tables takes 600 bytes of a Mega's flash.
#if !defined(STATUS_LED) && defined(__AVR__) && defined(LED_BUILTIN)
#if LED_BUILTIN == 13
#if defined(__AVR_ATmega1280__) || defined(__AVR_ATmega2560__)
#define MAVMISSION_LED(name) name##B, 7
#elif defined(__AVR_ATmega168__) || defined(__AVR_ATmega328__) || defined(__AVR_ATmega328P__)
#define MAVMISSION_LED(name) name##B, 5
#elif defined(__AVR_ATmega32U4__)
#define MAVMISSION_LED(name) name##C, 7
#endif
#endif
#endif

namespace mavmission {

namespace detail {

#ifdef MAVMISSION_LED
inline void writeBit(volatile uint8_t& port, uint8_t bit, bool isOn) {
  if (isOn) {
    port |= _BV(bit);
  } else {
    port &= ~_BV(bit);
  }
}
inline void writeLed(bool isOn) {
  writeBit(MAVMISSION_LED(DDR), true);
  writeBit(MAVMISSION_LED(PORT), isOn);
}
#elif defined(STATUS_LED) || defined(LED_BUILTIN)
inline void writeLed(bool isOn) {
#ifdef STATUS_LED
  const uint8_t pin = STATUS_LED;
#else
  const uint8_t pin = LED_BUILTIN;
#endif
  // Only what changes: on an ESP32 whose LED is a colour one, digitalWrite() waits until the colour has been sent, on a
  // Pico W until the radio has taken it. And some cores make a pin anew, dark for a moment, with each pinMode().
  static uint8_t shown = 0;  // nothing yet
  const uint8_t wanted = isOn ? 2 : 1;
  if (shown == wanted) return;
  if (shown == 0) pinMode(pin, OUTPUT);
  shown = wanted;
  digitalWrite(pin, isOn ? HIGH : LOW);
}
#else
inline void writeLed(bool) {}  // no LED is known
#endif

constexpr bool isGood(Status status) { return status >= Status::Accepted && status <= Status::Done; }

}  // namespace detail

// Call it in loop(), with the status of the client: it blinks without waiting.
inline void showOnLed(Status status) {
  const uint16_t now = static_cast<uint16_t>(millis());
  detail::writeLed(isEnd(status) && (now & (detail::isGood(status) ? 1024 : 128)) != 0);
}

}  // namespace mavmission
