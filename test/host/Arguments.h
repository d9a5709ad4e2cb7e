// What the words of a command line mean.
#pragma once

#include <stddef.h>
#include <stdlib.h>

#include <string>

// Each program says in its own way what is wrong, and ends.
[[noreturn]] void usage(const char* problem);

// Which of the names it is.
template <size_t N>
unsigned nameAmong(const char* const (&names)[N], const std::string& name, const char* problem) {
  for (unsigned i = 0; i < N; ++i) {
    if (name == names[i]) return i;
  }
  usage(problem);
}

inline uint64_t number(const char* text, uint64_t most) {
  char* end;
  const uint64_t value = strtoull(text, &end, 10);
  if (*text == 0 || *end != 0 || value > most) usage("a number is missing or too large");
  return value;
}
