// How many instructions are executed between the one that enables interrupts and an interrupt that is pending.
#include <Arduino.h>

volatile uint8_t executed;

ISR(TIMER1_COMPA_vect) { executed = GPIOR0; }

// TIMER1_COMPA is pending behind this, and interrupts are disabled.
void makePending() {
  cli();
  GPIOR0 = 0;
  TCNT1 = 0;
  TIFR1 = _BV(OCF1A);
  while (!(TIFR1 & _BV(OCF1A))) {
  }
}

// Two instructions that tell how far the firmware has come, and what they are made of.
#define COUNTED "out %[count], %[one]\n out %[count], %[two]\n"
#define THEM [count] "I"(_SFR_IO_ADDR(GPIOR0)), [one] "r"(1), [two] "r"(2)

void setup() {
  Serial.begin(115200);
  TCCR1A = 0;
  TCCR1B = _BV(CS10);
  OCR1A = 50;
  TIMSK1 = _BV(OCIE1A);
  makePending();
  asm volatile("sei\n" COUNTED ::THEM);
  const uint8_t sei = executed;
  makePending();
  asm volatile("out __SREG__, %[on]\n" COUNTED ::THEM, [on] "r"(0x80));
  const uint8_t out = executed;
  makePending();
  asm volatile("rcall 1f\n" COUNTED "rjmp 2f\n 1: reti\n 2:\n" ::THEM);  // a call that returns as an interrupt does
  const uint8_t reti = executed;
  Serial.print(F("sei "));
  Serial.print(sei);
  Serial.print(F(", out "));
  Serial.print(out);
  Serial.print(F(", reti "));
  Serial.println(reti);
}

void loop() {}
