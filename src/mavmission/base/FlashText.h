// Text in flash, as Serial.print() takes it.
#pragma once

#ifdef ARDUINO
#include <Arduino.h>  // the board's core says which namespace its classes are in
namespace mavmission {
typedef const __FlashStringHelper* FlashText;  // what Serial.print() takes as text in flash
}
#else
namespace mavmission {
typedef const char* FlashText;  // text, where there is no flash of its own
}
#endif
