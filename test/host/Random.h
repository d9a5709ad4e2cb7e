// Numbers by lot, the same for each seed.
#pragma once

#include <stdint.h>

#include <random>

class Random {
 public:
  explicit Random(uint32_t seed = 5489) : random_(seed) {}
  uint32_t below(uint32_t n) { return static_cast<uint32_t>(random_() % n); }
  bool oneIn(uint32_t n) { return below(n) == 0; }

 private:
  std::mt19937 random_;
};
