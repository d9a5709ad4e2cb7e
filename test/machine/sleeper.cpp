// Sleeps (idle) until an interrupt, answers each byte on Serial1 by the next.
#include <Arduino.h>
#include <avr/sleep.h>

volatile uint32_t wakings;
volatile uint32_t seenMs;

void setup() {
  Serial1.begin(115200);
  set_sleep_mode(SLEEP_MODE_IDLE);
}

void loop() {
  seenMs = millis();
  while (Serial1.available()) Serial1.write(Serial1.read() + 1);
  noInterrupts();
  if (!Serial1.available()) {
    sleep_enable();
    interrupts();
    sleep_cpu();
    sleep_disable();
  }
  interrupts();
  wakings++;
}
