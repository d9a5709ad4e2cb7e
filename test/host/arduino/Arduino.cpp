#include "Arduino.h"

namespace {
uint32_t nowMs_ = 0;
}

uint32_t millis() { return nowMs_; }
void setMillis(uint32_t nowMs) { nowMs_ = nowMs; }
