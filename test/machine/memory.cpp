// What outlives a reset: .noinit and EEPROM do, .data and .bss begin anew.
#include <Arduino.h>
#include <avr/eeprom.h>

uint16_t starts __attribute__((section(".noinit")));
volatile uint16_t counter = 1234;
uint8_t EEMEM stored[4] = {1, 2, 3, 4};
volatile uint8_t storedFirst;
volatile uint8_t causes __attribute__((section(".noinit")));

void noteCauses() __attribute__((naked, used, section(".init3")));
void noteCauses() {
  causes = MCUSR;
  MCUSR = 0;
}

void setup() {
  starts++;
  storedFirst = eeprom_read_byte(&stored[0]);
  eeprom_update_byte(&stored[3], uint8_t(starts));
  Serial1.begin(57600);
}

void loop() {
  counter++;
  Serial1.write('x');
}
