// A recursion of a known depth, with interrupts off: its frames alone set the
// deepest stack. Each frame holds its return address and what it saves.
#include <Arduino.h>

volatile uint16_t depth;
volatile uint16_t spBefore;
volatile uint16_t spDeepest = 0xFFFF;

__attribute__((noinline)) uint8_t recurse(uint16_t left) {
  volatile uint8_t block[40];
  block[0] = left;
  if (SP < spDeepest) spDeepest = SP;
  if (left == 0) return block[0];
  return recurse(left - 1) + block[0];
}

void setup() {}

void loop() {
  if (depth == 0) return;
  noInterrupts();
  spBefore = SP;
  recurse(depth);
  depth = 0;
  interrupts();
}
