// Opens Serial1, and nothing else.
#include <Arduino.h>

void setup() { Serial1.begin(57600); }
void loop() { Serial1.read(); }
