// Reads a word that lies at UNALIGNED_BY from where words lie.
#include <Arduino.h>

alignas(4) static uint8_t bytes[8] = {1, 2, 3, 4, 5, 6, 7, 8};

void setup() {
  Serial.begin(500000);
  const uint32_t* volatile place = reinterpret_cast<const uint32_t*>(bytes + UNALIGNED_BY);
  Serial.println(static_cast<unsigned long>(*place));
}

void loop() { yield(); }
