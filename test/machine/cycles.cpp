// Delay loops of known length, alone and with interrupts breaking in.
#include <Arduino.h>
#include <util/delay_basic.h>

volatile uint8_t go;
volatile uint16_t rounds;

// ldi, ldi; 4 cycles a round less 1 for the last branch; ret.
extern "C" __attribute__((noinline)) void waitFourThousand() { _delay_loop_2(1000); }

extern "C" __attribute__((noinline)) uint16_t factorial(uint8_t n) {
  rounds++;
  return n < 2 ? 1 : uint16_t(n * factorial(n - 1) + rounds - rounds);
}

void setup() {}

void loop() {
  if (!go) return;
  if (go == 1) noInterrupts();
  waitFourThousand();
  interrupts();
  if (go == 3) factorial(6);
  go = 0;
}
