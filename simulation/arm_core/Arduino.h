// The headers of an Arduino core for a Cortex-M0, in the shape that ArduinoCore-API gives to the cores of today: its
// classes are in namespace arduino, flash is memory like any other. Names and macros are those that sketches and
// libraries meet there. It is for compiling alone.
#pragma once

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "HardwareSerial.h"
#include "pgmspace.h"

#ifndef F_CPU
#define F_CPU 16000000L
#endif

// Words that such a core takes away from everybody.
#define HIGH 0x1
#define LOW 0x0
#define INPUT 0x0
#define OUTPUT 0x1
#define INPUT_PULLUP 0x2
#define CHANGE 2
#define FALLING 3
#define RISING 4
#define DEFAULT 1
#define EXTERNAL 0
#define DISPLAY 0x1
#define SERIAL 0x0
#define LSBFIRST 0
#define MSBFIRST 1
#define PI 3.1415926535897932384626433832795
#define HALF_PI 1.5707963267948966192313216916398
#define TWO_PI 6.283185307179586476925286766559
#define DEG_TO_RAD 0.017453292519943295769236907684886
#define RAD_TO_DEG 57.295779513082320876798154814105
#define EULER 2.718281828459045235360287471352
#define abs(x) ((x) > 0 ? (x) : -(x))
#define round(x) ((x) >= 0 ? (long)((x) + 0.5) : (long)((x) - 0.5))
#define radians(deg) ((deg) * DEG_TO_RAD)
#define degrees(rad) ((rad) * RAD_TO_DEG)
#define sq(x) ((x) * (x))
#define constrain(x, low, high) ((x) < (low) ? (low) : ((x) > (high) ? (high) : (x)))
#define lowByte(w) ((uint8_t)((w) & 0xff))
#define highByte(w) ((uint8_t)((w) >> 8))
#define bitRead(value, bit) (((value) >> (bit)) & 0x01)
#define bitSet(value, bit) ((value) |= (1UL << (bit)))
#define bitClear(value, bit) ((value) &= ~(1UL << (bit)))
#define bit(b) (1UL << (b))
#define B0 0
#define B1 1
#define B10 2
#define B11 3

template <class T, class U>
auto min(const T& a, const U& b) -> decltype(b < a ? b : a) {
  return b < a ? b : a;
}
template <class T, class U>
auto max(const T& a, const U& b) -> decltype(b < a ? b : a) {
  return a < b ? b : a;
}

#define F(text) (reinterpret_cast<const __FlashStringHelper*>(PSTR(text)))

typedef bool boolean;
typedef uint8_t byte;
typedef uint16_t word;

inline void interrupts() { asm volatile("cpsie i" : : : "memory"); }
inline void noInterrupts() { asm volatile("cpsid i" : : : "memory"); }

// Pins that nothing is connected to.
static const uint8_t A0 = 14;
#define LED_BUILTIN 13
inline void pinMode(uint8_t, uint8_t) {}
inline void digitalWrite(uint8_t, uint8_t) {}
inline int digitalRead(uint8_t) { return LOW; }
inline int analogRead(uint8_t) { return 0; }

unsigned long millis();
void delay(unsigned long ms);
void yield();

void setup();
void loop();

using namespace arduino;

extern UART Serial;
extern UART Serial1;
