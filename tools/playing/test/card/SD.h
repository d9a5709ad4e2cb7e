// What PlanFromSd uses of the SD library: a file in the root of a FAT16 card on the SPI bus is read, and nothing else.
#pragma once

#include <Arduino.h>

namespace card {

constexpr uint16_t kSector = 512;
uint8_t sector[kSector];
uint32_t sectorAt = 0xFFFFFFFF;

inline uint8_t exchange(uint8_t byte) {
  SPDR = byte;
  while (!(SPSR & _BV(SPIF))) {
  }
  return SPDR;
}

// The card's answer to a command; what follows it is still to be read.
inline uint8_t command(uint8_t number, uint32_t value) {
  exchange(0xFF);
  exchange(0x40 | number);
  for (int8_t shift = 24; shift >= 0; shift -= 8) exchange(static_cast<uint8_t>(value >> shift));
  exchange(number == 0 ? 0x95 : 0x87);
  uint8_t answer = 0xFF;
  for (uint8_t turn = 0; turn < 8 && answer & 0x80; ++turn) answer = exchange(0xFF);
  return answer;
}

inline bool read(uint32_t number) {
  if (number == sectorAt) return true;
  if (command(17, number * kSector) != 0) return false;
  for (uint16_t turn = 0; exchange(0xFF) != 0xFE; ++turn) {
    if (turn > 1000) return false;
  }
  for (uint8_t& byte : sector) byte = exchange(0xFF);
  exchange(0xFF);
  exchange(0xFF);
  sectorAt = number;
  return true;
}

inline uint16_t half(uint16_t at) { return static_cast<uint16_t>(sector[at] | sector[at + 1] << 8); }

}  // namespace card

class File : public Stream {
 public:
  File() = default;
  File(uint16_t cluster, uint32_t size, uint32_t data, uint32_t fat)
      : first_(cluster), cluster_(cluster), size_(size), data_(data), fat_(fat) {}
  operator bool() const { return first_ != 0; }
  bool seek(uint32_t position) {
    if (position > size_) return false;
    position_ = position;
    cluster_ = first_;
    for (uint32_t left = position / card::kSector; left > 0; --left) next();
    return true;
  }
  int available() override { return static_cast<int>(size_ - position_); }
  int peek() override {
    if (position_ >= size_ || !card::read(data_ + cluster_ - 2)) return -1;
    return card::sector[position_ % card::kSector];
  }
  int read() override {
    const int byte = peek();
    if (byte >= 0 && ++position_ % card::kSector == 0) next();
    return byte;
  }
  size_t write(uint8_t) override { return 0; }

 private:
  void next() {
    if (card::read(fat_ + cluster_ / 256)) cluster_ = card::half(cluster_ % 256 * 2);
  }

  uint16_t first_ = 0;
  uint16_t cluster_ = 0;
  uint32_t size_ = 0;
  uint32_t position_ = 0;
  uint32_t data_ = 0;
  uint32_t fat_ = 0;
};

class Card {
 public:
  bool begin(uint8_t select) {
    pinMode(select, OUTPUT);
    pinMode(SS, OUTPUT);
    SPCR = _BV(SPE) | _BV(MSTR);
    for (uint8_t turn = 0; turn < 10; ++turn) card::exchange(0xFF);
    if (card::command(0, 0) != 1 || card::command(8, 0x1AA) != 1) return false;
    uint8_t echo = 0;
    for (uint8_t turn = 0; turn < 4; ++turn) echo = card::exchange(0xFF);
    if (echo != 0xAA) return false;
    for (uint8_t turn = 0; turn < 100; ++turn) {
      card::command(55, 0);
      if (card::command(41, 0x40000000) == 0) return true;
    }
    return false;
  }
  File open(const char* name) {
    if (!card::read(0) || card::half(510) != 0xAA55 || card::half(11) != card::kSector) return File();
    const uint32_t fat = card::half(14);
    const uint32_t root = fat + card::sector[16] * card::half(22);
    const uint32_t data = root + card::half(17) / 16;
    if (strcmp(name, "PLAN.TXT") != 0 || !card::read(root)) return File();
    if (memcmp(card::sector, "PLAN    TXT", 11) != 0) return File();
    return File(card::half(26), card::half(28), data, fat);
  }
};
static Card SD;
