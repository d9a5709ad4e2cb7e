// Never sleeps: counts rounds of the loop.
#include <Arduino.h>

volatile uint32_t rounds;

void setup() {}

void loop() { rounds++; }
