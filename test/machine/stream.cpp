// Sends COUNT bytes, 0 1 2 ..., as fast as the line takes them, and counts and
// adds up all that arrives on Serial1.
#include <Arduino.h>

#ifndef COUNT
#define COUNT 0
#endif

volatile uint16_t arrived;
volatile uint32_t sum;
volatile uint16_t outOfOrder;

void setup() { Serial1.begin(BAUD); }

void loop() {
  static uint16_t sent;
  static uint8_t expected;
  while (Serial1.available()) {
    const uint8_t byte = Serial1.read();
    if (byte != expected) outOfOrder++;
    expected = byte + 1;
    arrived++;
    sum += byte;
  }
  while (sent != COUNT && Serial1.availableForWrite()) Serial1.write(uint8_t(sent++));
}
