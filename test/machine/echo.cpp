// Says "ready", then sends back what arrives on Serial.
#include <Arduino.h>

void setup() {
  Serial.begin(115200);
  Serial.println(F("ready"));
}

void loop() {
  if (Serial.available()) Serial.write(Serial.read());
}
