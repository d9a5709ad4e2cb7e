// Reads Serial1 only once `wake` is set, having been deaf in one of two ways.
#include <Arduino.h>

volatile uint8_t deaf;  // 1: interrupts are off until `wake`
volatile uint8_t wake;
volatile uint16_t fetched;
volatile uint8_t kept[256];

void setup() { Serial1.begin(57600); }

void loop() {
  if (deaf) {
    noInterrupts();
    while (!wake) {
    }
    interrupts();
    deaf = 0;
  }
  if (!wake) return;
  while (Serial1.available()) kept[fetched++ & 0xFF] = Serial1.read();
}
