// A conversation as two lines of text. In goes a script, "asks 0 to 2, wait 1500, accepted"; out comes what it leads
// to, "count, item 0 to 2, 1500 item 2, Accepted": each word behind the milliseconds since the one before it.
#pragma once

#include <stdint.h>

#include <string>
#include <vector>

#include "Names.h"

// One event of a script: "wait 1500" has a number, "asks 0 to 2" stands for three events.
struct Event {
  std::string what;
  uint32_t number;

  bool is(const char* word) const { return what == word; }
};

std::vector<Event> eventsOf(const std::string& script);

// The script, `count` times, each with a comma behind it.
std::string times(unsigned count, const std::string& script);

class Transcript {
 public:
  // `what` happened, `ms` behind what was noted before.
  void note(const std::string& what, uint32_t ms = 0);
  // The same with a number: "item 0 to 2" when one follows the other at the same moment.
  void note(const std::string& what, uint32_t ms, uint32_t number);
  // All of it, as one text. What comes several times in a row is written once: "1500 count (4 times)".
  std::string text() const;

 private:
  struct Entry {
    std::string what;
    uint32_t ms;
    bool isNumbered;
    uint32_t first, last;

    std::string text() const;
  };
  std::vector<Entry> entries_;
};
