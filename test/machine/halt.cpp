// Ends in one of the ways that firmware can end.
#include <Arduino.h>
#include <avr/sleep.h>
#include <avr/wdt.h>

volatile uint8_t how;  // 1: sleep for ever, 2: write beyond RAM, 3: watchdog, 4: jump astray

void setup() {}

void loop() {
  switch (how) {
    case 1:
      noInterrupts();
      sleep_enable();
      sleep_cpu();
      break;
    case 2:
      *reinterpret_cast<volatile uint8_t *>(0xF000) = 1;
      break;
    case 3:
      wdt_enable(WDTO_15MS);
      for (;;) {
      }
    case 4:
      reinterpret_cast<void (*)()>(0x7000)();
  }
}
