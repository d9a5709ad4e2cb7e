// From power-on to loop(), and the clock. Each millisecond of the clock the timer's interrupt exchanges what the ports
// have sent and what has come for them with the computer, over the emulated UART, and the clock stands still meanwhile:
// the board's time is that of its instructions, however long the computer takes.
//
//   board:     'T', then for Serial and for Serial1: the number of bytes, the bytes
//              'F': the processor could not go on, as with a word that is not aligned; nothing follows
//   computer:  'R', then for Serial and for Serial1 as above: go on
//              'P', address, length, the bytes: put them there. 'G', address, length: give them. (32 and 16 bits)
#include "Arduino.h"
#include "nrf51.h"

extern "C" {
extern uint32_t dataInFlash, dataBegin, dataEnd, bssBegin, bssEnd, stackTop;
extern void (*initBegin[])();
extern void (*initEnd[])();
void reset();
void fault();
void onTimer();
}

namespace {

volatile uint32_t nowMs;

void say(uint8_t byte) {
  UART_TXDRDY = 0;
  UART_TXD = byte;
  while (UART_TXDRDY == 0) {
  }
}

// With interrupts off: the UART's only ends the sleep, and is then taken back.
uint8_t hear() {
  while (UART_RXDRDY == 0) {
    asm volatile("wfi");
    NVIC_CLEAR = 1u << UART_IRQ;
  }
  UART_RXDRDY = 0;  // first: the register is refilled, and this set again, as soon as it is read
  return static_cast<uint8_t>(UART_RXD);
}

uint32_t hearNumber(uint8_t bytes) {
  uint32_t number = 0;
  for (uint8_t i = 0; i < bytes; ++i) number |= static_cast<uint32_t>(hear()) << (8 * i);
  return number;
}

void sayWhatLeaves(UART& port) {
  static uint8_t bytes[255];
  const uint8_t count = port.leaving(bytes);
  say(count);
  for (uint8_t i = 0; i < count; ++i) say(bytes[i]);
}

void hearWhatArrives(UART& port) {
  for (uint8_t left = hear(); left != 0; --left) port.arrive(hear());
}

void exchange() {
  say('T');
  sayWhatLeaves(Serial);
  sayWhatLeaves(Serial1);
  for (;;) {
    const uint8_t order = hear();
    if (order == 'R') break;
    uint8_t* place = reinterpret_cast<uint8_t*>(hearNumber(4));
    for (uint32_t left = hearNumber(2); left != 0; --left, ++place) {
      if (order == 'P') {
        *place = hear();
      } else {
        say(*place);
      }
    }
  }
  hearWhatArrives(Serial);
  hearWhatArrives(Serial1);
}

}  // namespace

unsigned long millis() { return nowMs; }

void yield() { asm volatile("wfi"); }

void delay(unsigned long ms) {
  const unsigned long begin = millis();
  while (millis() - begin < ms) yield();
}

void onTimer() {
  TIMER_COMPARE0 = 0;
  TIMER_STOP = 1;
  nowMs = nowMs + 1;
  asm volatile("cpsid i" : : : "memory");
  exchange();
  NVIC_CLEAR = 1u << UART_IRQ;
  asm volatile("cpsie i" : : : "memory");
  TIMER_START = 1;
}

void fault() {
  say('F');
  for (;;) asm volatile("wfi");
}

void reset() {
  const uint32_t* from = &dataInFlash;
  for (uint32_t* to = &dataBegin; to < &dataEnd; ++to) *to = *from++;
  for (uint32_t* to = &bssBegin; to < &bssEnd; ++to) *to = 0;
  for (void (**init)() = initBegin; init < initEnd; ++init) (*init)();

  UART_ENABLE = 4;
  UART_STARTTX = 1;
  UART_STARTRX = 1;
  UART_INTENSET = UART_RXDRDY_BIT;
  TIMER_BITMODE = 3;    // 32 bits
  TIMER_PRESCALER = 4;  // 1 MHz
  TIMER_CC0 = 1000;
  TIMER_SHORTS = 1;  // begins again at 0
  TIMER_INTENSET = 1u << TIMER_COMPARE0_BIT;
  NVIC_PRIORITIES_OF_TIMER = 0xC0;  // below the UART's, or that would not end a sleep in the timer's
  NVIC_ENABLE = 1u << UART_IRQ | 1u << TIMER_IRQ;
  TIMER_START = 1;

  setup();
  for (;;) loop();
}

typedef void (*Vector)();
extern "C" const Vector vectors[48];
__attribute__((section(".vectors"), used)) const Vector vectors[48] = {
    reinterpret_cast<Vector>(&stackTop),
    reset,
    fault,
    fault,
    nullptr,
    nullptr,
    nullptr,
    nullptr,
    nullptr,
    nullptr,
    nullptr,
    fault,
    nullptr,
    nullptr,
    fault,
    fault,
    nullptr,
    nullptr,
    fault,
    nullptr,
    nullptr,
    nullptr,
    nullptr,
    nullptr,
    onTimer,
};
