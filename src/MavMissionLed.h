// Shows on the board's own LED how an operation ended, without a computer: showOnLed(autopilot.status()) in loop().
// Dark: it has not ended yet. Once in two seconds: it ended well. Four times a second: it failed. On a board whose LED
// is lit by LOW it shines in place of dark; the blinking is the same. Include it after MavMission.h.
//
// A sketch that knows better says so before it includes this:
//
//   #define STATUS_LED 5      // another pin
#pragma once

#include <Arduino.h>

// An ESP32 whose board names no LED: most of its development boards have one there, many others none.
#if !defined(STATUS_LED) && !defined(LED_BUILTIN) && defined(CONFIG_IDF_TARGET_ESP32)
#define STATUS_LED 2
#endif

// Pin 13 by the processor's own name for it, on an Arduino Mega, on an Uno or a Nano, and on a Leonardo: a write is one
// instruction there, and digitalWrite() with its tables 600 bytes of a Mega's flash.
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
  static bool isOutput = false;  // some cores make a pin anew, dark for a moment, with each pinMode()
  if (!isOutput) pinMode(pin, OUTPUT);
  isOutput = true;
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
