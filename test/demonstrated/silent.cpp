// A sketch that uploads nothing.
#include <Arduino.h>

void setup() {}
void loop() {}
