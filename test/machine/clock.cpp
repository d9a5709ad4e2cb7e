// Reads micros() as fast as it can and watches that it does not run backwards.
#include <Arduino.h>

volatile uint32_t readings;
volatile uint32_t backwards;
volatile uint32_t longestStepUs;
volatile uint32_t lastUs;

void setup() { lastUs = micros(); }

void loop() {
  const uint32_t nowUs = micros();
  const int32_t stepUs = int32_t(nowUs - lastUs);
  if (stepUs < 0)
    backwards++;
  else if (uint32_t(stepUs) > longestStepUs)
    longestStepUs = stepUs;
  noInterrupts();
  lastUs = nowUs;
  interrupts();
  readings++;
}
