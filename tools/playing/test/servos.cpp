// Three servos, each moved in another way: pulses by delays, by the interrupts of a timer as the library "Servo" makes
// them, and by the output of a timer; and two lights.
#include <Arduino.h>

constexpr uint8_t kByDelay = 9, kByInterrupt = 40, kByTimer = 11;
constexpr uint8_t kLight = 13, kDimmed = 6;
constexpr uint16_t kTicksPerUs = 2, kEveryUs = 20000;

volatile uint16_t widthUs = 2000;
bool isHigh;

ISR(TIMER5_COMPA_vect) {
  isHigh = !isHigh;
  digitalWrite(kByInterrupt, isHigh);
  OCR5A = TCNT5 + (isHigh ? widthUs : kEveryUs - widthUs) * kTicksPerUs;
}

void setup() {
  pinMode(kByDelay, OUTPUT);
  pinMode(kByInterrupt, OUTPUT);
  pinMode(kByTimer, OUTPUT);
  pinMode(kLight, OUTPUT);
  analogWrite(kDimmed, 128);
  TCCR5A = 0;
  TCCR5B = _BV(CS51);
  OCR5A = TCNT5 + 1000;
  TIMSK5 = _BV(OCIE5A);
  ICR1 = kEveryUs * kTicksPerUs - 1;
  OCR1A = 1000 * kTicksPerUs - 1;
  TCCR1A = _BV(COM1A1) | _BV(WGM11);
  TCCR1B = _BV(WGM13) | _BV(WGM12) | _BV(CS11);
}

void loop() {
  digitalWrite(kLight, millis() / 100 % 2 == 0);
  digitalWrite(kByDelay, HIGH);
  delayMicroseconds(1472);
  digitalWrite(kByDelay, LOW);
  delay(18);
  if (millis() > 3000) widthUs = 600;
}
