// What the bytes of a line prove of an upload, found without the library's parser: frames that are right to the
// checksum, wherever they lie.
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "PlanFrames.h"
#include "mavmission/autopilot/Commands.h"
#include "mavmission/item/MissionItem.h"

constexpr uint8_t kAutopilot = 1;  // its system and component, and the system of the client
constexpr uint8_t kClient = 191;   // the client's component

// Ends the program with what was violated.
inline void demand(bool holds, const char* what) {
  if (holds) return;
  fprintf(stderr, "%s\n", what);
  abort();
}

// The bytes of the input, as far as they go.
struct Input {
  const uint8_t* data;
  size_t size;
  bool isOver() const { return size == 0; }
  uint8_t next() {
    if (size == 0) return 0;
    --size;
    return *data++;
  }
};

// Where the frame at `at` begins: behind the 12 zeros that stand before it on a lossy link, if they are all there.
size_t behindFill(const Bytes& bytes, size_t at);
// The frames that are right to the checksum, wherever they lie.
std::vector<FrameParts> framesIn(const Bytes& bytes);

// A plan as it is to go over the wire.
typedef std::vector<mavmission::MissionItem> WireItems;

// The wire items of the first `count` items of `plan` for an autopilot of this kind.
WireItems wireItems(const mavmission::MissionItem* plan, uint16_t count, mavmission::Firmware firmware);

// True if, in these bytes, item `last` is asked for, and behind that a mission is accepted, both by the autopilot and
// for us; of an empty plan (`isEmpty`) nothing is asked for.
bool holdsAnswer(const Bytes& heard, bool isEmpty, uint16_t last);

// True if `asked`, bytes that were written, asks for what is aboard and for each item, and `heard` gives their right
// number and each of them as `meant` says. ArduPilot's item 0 is its own home.
bool holdsReading(const Bytes& heard, const Bytes& asked, const WireItems& meant, mavmission::Firmware firmware);

// The checksum by which PX4 names a plan.
uint32_t nameOf(const WireItems& items);

// True if `heard` has a MISSION_COUNT for us with the number of these items and their name.
bool holdsName(const Bytes& heard, const WireItems& meant);

// True if these bytes begin an upload: MISSION_COUNT, or MISSION_WRITE_PARTIAL_LIST. `announced`: how many items the
// last MISSION_COUNT announces, if there is one.
bool announces(const Bytes& written, uint16_t& announced);

// True if a frame of this message, right to the checksum, lies among these bytes.
bool holdsMessage(const Bytes& bytes, uint32_t messageId);
