// What OledStatus uses of the library "U8g2", with Serial in place of the display: "@3 12.6 V " is line 3. A line that
// is sent to a display takes some 6 ms at 400 kHz; so long this one waits.
#pragma once

#include <Arduino.h>

#define U8X8_PIN_NONE 255
static const uint8_t u8x8_font_chroma48medium8_r[] = {0};

class U8X8_SSD1306_128X64_NONAME_HW_I2C : public Print {
 public:
  explicit U8X8_SSD1306_128X64_NONAME_HW_I2C(uint8_t) {}
  bool begin() {
    Serial.begin(115200);
    return true;
  }
  void setFont(const uint8_t*) {}
  void clearLine(uint8_t) { delay(6); }
  void setCursor(uint8_t, uint8_t row) {
    Serial.print("\r\n@");
    Serial.print(row);
    Serial.print(' ');
  }
  size_t write(uint8_t byte) override { return Serial.write(byte); }
  using Print::write;
};
