// Waits for the line to be silent, then sends with interrupts off, where
// write() must poll the port.
#include <Arduino.h>

volatile uint8_t flushed;

void setup() {
  Serial1.begin(57600);
  Serial1.write("abc", 3);
  Serial1.flush();
  flushed = 1;
  noInterrupts();
  for (uint8_t n = 0; n < 200; n++) Serial1.write(n);
  interrupts();
}

void loop() {}
