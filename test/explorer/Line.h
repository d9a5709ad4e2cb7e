// One direction of the line: frames on their way, and what may become of each.
#pragma once

#include <stdint.h>
#include <string.h>

#include <type_traits>

#include "Message.h"

// What becomes of a frame that is due. A frame suffers one of these.
enum class Fate : uint8_t {
  Delivered,
  Lost,
  Repeated,      // a second one follows within 1 ms
  RepeatedLate,  // a second one follows the next frame of this direction
  Delayed,       // it comes behind the next frame of this direction, if there ever is one
  Damaged,       // a byte of its payload is wrong
  Cut,           // its last bytes are missing: the parser waits for them
  Copied30,      // a second one follows so many ms later, over a second link or a radio that repeats
  Copied120,
  Copied300,
  Late30,  // it comes so many ms later alone, over a second link, since the first one has dropped out
  Late120,
  Late300,
};
constexpr int kFates = 13;

struct InFlight {
  Message message;
  uint16_t dueMs;    // what is left of its way [ms]
  uint8_t isHeld;    // it waits for the next one to pass; dueMs counts for nothing
  uint8_t isSpared;  // it suffers nothing more
};

struct Line {
  static constexpr uint16_t kWayMs = 10;    // a frame's time on the line, and to be read
  static constexpr uint16_t kBehindMs = 1;  // from a frame to the one that follows it directly
  static constexpr int kMost = 12;

  InFlight frames[kMost];  // the rest is zero
  uint16_t count;
  uint16_t latencyMs;  // beside kWayMs: a radio, or a line that keeps frames back

  // The frame that is due first, or -1.
  int first() const {
    int found = -1;
    for (int i = 0; i < static_cast<int>(count); ++i) {
      if (!frames[i].isHeld && (found < 0 || frames[i].dueMs < frames[found].dueMs)) found = i;
    }
    return found;
  }

  void pass(uint16_t ms) {
    for (uint32_t i = 0; i < count; ++i) {
      if (!frames[i].isHeld) frames[i].dueMs = static_cast<uint16_t>(frames[i].dueMs > ms ? frames[i].dueMs - ms : 0);
    }
  }

  // False if the line is fuller than the exploration foresees.
  bool send(const Message& message) {
    return put(InFlight{message, static_cast<uint16_t>(kWayMs + latencyMs), false, false});
  }

  // Takes the frame out; those that waited for it follow.
  Message take(int which, Fate fate) {
    const Message message = frames[which].message;
    --count;
    memmove(&frames[which], &frames[which + 1], static_cast<size_t>(count - which) * sizeof(InFlight));
    memset(static_cast<void*>(&frames[count]), 0, sizeof(InFlight));
    for (uint32_t i = 0; i < count; ++i) {
      if (!frames[i].isHeld) continue;
      frames[i].isHeld = false;
      frames[i].isSpared = true;
      frames[i].dueMs = kBehindMs;
    }
    if (fate >= Fate::Copied30) {
      const uint16_t laterMs[] = {30, 120, 300};
      put(InFlight{message, laterMs[(static_cast<int>(fate) - static_cast<int>(Fate::Copied30)) % 3], false, true});
    }
    if (fate == Fate::Repeated) put(InFlight{message, kBehindMs, false, true});
    if (fate == Fate::RepeatedLate || fate == Fate::Delayed) put(InFlight{message, 0, true, true});
    return message;
  }

 private:
  bool put(const InFlight& frame) {
    if (count == kMost) return false;
    frames[count++] = frame;
    return true;
  }
};
static_assert(std::has_unique_object_representations<Line>::value, "folded by its bytes");
