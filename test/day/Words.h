// The words of a line that the client is told, and bytes in hexadecimal, "-" for none.
#pragma once

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <string>
#include <vector>

typedef std::vector<uint8_t> Bytes;

inline Bytes bytesOf(const std::string& text) {
  Bytes found;
  for (size_t i = 0; i + 1 < text.size(); i += 2) {
    found.push_back(static_cast<uint8_t>(strtoul(text.substr(i, 2).c_str(), nullptr, 16)));
  }
  return found;
}

struct Words {
  explicit Words(char* line) : rest(line) {}
  char* rest;
  std::string word() {
    char* found = strtok_r(rest, " \n", &rest);
    return found == nullptr ? "" : found;
  }
  unsigned long long number() { return strtoull(word().c_str(), nullptr, 10); }
  Bytes bytes() { return bytesOf(word()); }
};

inline void say(const uint8_t* bytes, size_t count) {
  if (count == 0) putchar('-');
  for (size_t i = 0; i < count; ++i) printf("%02x", bytes[i]);
}
