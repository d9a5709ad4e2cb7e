// What PlanFromSd uses of the SD library, with a card that lies in RAM: test_plan_from_sd.py puts the text there.
#pragma once

#include <Arduino.h>

// Not cleared when the program starts.
#define CARD_NOINIT __attribute__((section(".noinit"), used))
CARD_NOINIT char cardText[4000];
CARD_NOINIT uint16_t cardSize;      // 0xFFFF: there is no such file
CARD_NOINIT uint16_t cardReadable;  // of it, as long as the card is in [bytes]

class File : public Stream {
 public:
  explicit File(bool isOpen = false) : isOpen_(isOpen) {}
  operator bool() const { return isOpen_; }
  bool seek(uint32_t position) {
    if (!isOpen_ || position > cardSize) return false;
    position_ = static_cast<uint16_t>(position);
    return true;
  }
  int available() override { return isOpen_ ? cardSize - position_ : 0; }
  int peek() override { return available() > 0 && position_ < cardReadable ? cardText[position_] : -1; }
  int read() override {
    const int byte = peek();
    if (byte >= 0) ++position_;
    return byte;
  }
  size_t write(uint8_t) override { return 0; }

 private:
  uint16_t position_ = 0;
  bool isOpen_;
};

class Card {
 public:
  bool begin(uint8_t) { return true; }
  File open(const char* name) { return File(strcmp(name, "PLAN.TXT") == 0 && cardSize != 0xFFFF); }
};
static Card SD;
