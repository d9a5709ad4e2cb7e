// Writes three bytes of EEPROM one behind the other, and notes how long each call took.
#include <Arduino.h>
#include <avr/eeprom.h>

volatile uint16_t tookUs[3];
volatile bool wasReady;
volatile bool isDone;

void setup() {
  for (uint8_t i = 0; i < 3; ++i) {
    const uint32_t began = micros();
    eeprom_write_byte(reinterpret_cast<uint8_t*>(100 + i), 0x51 + i);
    tookUs[i] = static_cast<uint16_t>(micros() - began);
  }
  wasReady = eeprom_is_ready();
  isDone = true;
}

void loop() {}
