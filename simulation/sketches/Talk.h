// The firmware's side of a talk over Serial: lines that order something come in, lines that tell what happened go out.
//
// A line is a word and up to four numbers. When it is done, the answer is "ok". What happens is told by lines that
// begin with millis(): "1234 progress 1 10".
#pragma once

#include <Arduino.h>
#ifdef __AVR__
#include <avr/sleep.h>
#endif

typedef uint32_t Numbers[4];
typedef void (*Action)(const Numbers& numbers);

struct Word {
  const char* name;
  Action action;
};

#define ACTION(name) static void name(const Numbers& numbers __attribute__((unused)))
#define WORD(name) {#name, name}

// Begins a line; Serial.println() ends it.
inline void tell(const __FlashStringHelper* word, uint16_t first) {
  Serial.print(millis());
  Serial.print(' ');
  Serial.print(word);
  Serial.print(' ');
  Serial.print(first);
}

inline void tellNumber(const __FlashStringHelper* name, uint32_t value) {
  Serial.print(' ');
  Serial.print(name);
  Serial.print('=');
  Serial.print(value);
}

inline void tellHex(const uint8_t* bytes, uint8_t length) {
  for (; length != 0; --length, ++bytes) {
    if (*bytes < 0x10) Serial.print('0');
    Serial.print(*bytes, HEX);
  }
}

inline void obey(const Word* words, uint8_t count, char* text) {
  Numbers numbers = {0, 0, 0, 0};
  char* rest = text;
  while (*rest != 0 && *rest != ' ') ++rest;
  if (*rest != 0) *rest++ = 0;
  for (uint32_t& number : numbers) number = strtoul(rest, &rest, 10);
  for (; count != 0; --count, ++words) {
    if (strcmp(words->name, text) != 0) continue;
    words->action(numbers);
    Serial.println(F("ok"));
    return;
  }
  Serial.println(F("what?"));
}

template <uint8_t N>
void listen(const Word (&words)[N]) {
  static char text[50];
  static uint8_t length;
  while (Serial.available()) {
    const char c = Serial.read();
    if (c != '\n') {
      if (length + 1u < sizeof(text)) text[length++] = c;
      continue;
    }
    text[length] = 0;
    length = 0;
    obey(words, N, text);
  }
}

inline void setUpSleep() {
#ifdef __AVR__
  set_sleep_mode(SLEEP_MODE_IDLE);
#endif
}

// Until the next interrupt, at the latest that of millis(). The simulator jumps over it.
inline void sleepIfNothingCame(Stream& line) {
  noInterrupts();
  if (Serial.available() == 0 && line.available() == 0) {
#ifdef __AVR__
    sleep_enable();
    interrupts();  // takes effect after the next instruction: nothing is slept through
    sleep_cpu();
    sleep_disable();
#else
    asm volatile("wfi");  // ends with an interrupt that waits, though it is not served yet
#endif
  }
  interrupts();
}
