// Text in flash, as Serial.print() takes it.
#pragma once

#ifdef ARDUINO
class __FlashStringHelper;
namespace mavmission {
typedef const __FlashStringHelper* FlashText;  // what Serial.print() takes as text in flash
}
#else
namespace mavmission {
typedef const char* FlashText;
}
#endif
