// Ends in one of the ways that firmware can end.
#include <Arduino.h>
#include <avr/pgmspace.h>
#include <avr/sleep.h>
#include <avr/wdt.h>

volatile uint8_t how;  // 1: sleep for ever, 2: write beyond RAM, 3: watchdog, 4: jump to erased flash,
                       // 5: jump out of flash, 6: read beyond flash

void setup() {}

void loop() {
  switch (how) {
    case 1:
      noInterrupts();
      sleep_enable();
      sleep_cpu();
      break;
    case 2: *reinterpret_cast<volatile uint8_t*>(0xF000) = 1; break;
    case 3:
      wdt_enable(WDTO_15MS);
      for (;;) {
      }
    case 4: reinterpret_cast<void (*)()>(0x7000)(); break;
    case 5: asm volatile("ldi r24, 0xFE\n push r24\n push r24\n push r24\n ret" ::: "r24"); break;
    case 6:
#ifdef RAMPZ
      how = pgm_read_byte_far(0xFEFEFE);
#else
      how = pgm_read_byte(0xFEFE);
#endif
  }
}
