// A conversation as two lines of text. In goes a script, "asks 0 to 2, wait 1500, accepted"; out comes what it leads
// to, "count, item 0 to 2, 1500 item 2, Accepted": each word after the milliseconds since the one before it.
#pragma once

#include <stdint.h>

#include <string>
#include <vector>

#include "Names.h"
#include "mavmission/base/Pace.h"

// One event of a script: "wait 1500" has a number, "asks 0 to 2" stands for three events.
struct Event {
  std::string what;
  uint32_t number;

  bool is(const char* word) const { return known(what == word); }
  // The same of a word that is asked for otherwise.
  bool known(bool is) const { return isKnown = isKnown || is, is; }
  // Its words up to the first blank, and after the last.
  std::string first() const { return what.substr(0, what.find(' ')); }
  std::string last() const { return what.substr(what.rfind(' ') + 1); }

  mutable bool isKnown;
};

// The events of a script, for a loop over them. An event that nobody has known when the next one follows ends the case:
// it is none, and what the case says would not be tried.
class Events {
 public:
  explicit Events(const std::vector<Event>& all) : all_(all) {}

  class Iterator {
   public:
    explicit Iterator(const Event* event) : event_(event) {}
    const Event& operator*() const { return *event_; }
    Iterator& operator++();
    bool operator!=(const Iterator& other) const { return event_ != other.event_; }

   private:
    const Event* event_;
  };
  Iterator begin() const { return Iterator(all_.data()); }
  Iterator end() const { return Iterator(all_.data() + all_.size()); }

 private:
  std::vector<Event> all_;
};

Events eventsOf(const std::string& script);

// The script, `count` times, each with a comma after it.
std::string times(unsigned count, const std::string& script);

class Transcript {
 public:
  // `what` happened, `ms` after what was noted before.
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

// What plays scripts against one transfer: its clock, its line, and what has left by it.
class Player {
 public:
  mavmission::detail::Pace pace = mavmission::detail::Pace();

  // `startMs`: of its clock, which wraps soon by default.
  explicit Player(uint16_t startMs = 65000) : startMs_(startMs) {}
  virtual ~Player() = default;

  // What leaves and how it ends, when this happens. Beside the events of each transfer:
  // wait N: so many ms pass, one by one; silence: a minute; sleep N: the clock goes on so far, and nobody looks at it
  // lossy: a loss is noted; line full, line free: what is due stays
  std::string plays(const std::string& script);
  // How it ends, or "goes on".
  std::string ends(const std::string& script);

  uint16_t now() const { return static_cast<uint16_t>(startMs_ + elapsedMs_); }
  void sleep(uint32_t ms) { elapsedMs_ += ms; }

 protected:
  mavmission::Status status_ = mavmission::Status::Transferring;
  bool isFull_ = false;

  virtual void happens(const Event& event) = 0;
  virtual mavmission::Status onTime() = 0;
  // What is due leaves; where one message follows another, as long as the line is free.
  virtual void leave() = 0;
  void note(const std::string& what) { said_.note(what, sinceSpoken()); }
  void note(const std::string& what, uint32_t number) { said_.note(what, sinceSpoken(), number); }

 private:
  Transcript said_;
  uint16_t startMs_;
  uint32_t elapsedMs_ = 0, spokeMs_ = 0;

  void pass(uint32_t ms);
  uint32_t sinceSpoken();
};
