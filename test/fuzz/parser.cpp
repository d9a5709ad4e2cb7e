// Any bytes, to our parser and to the one in MAVLink's headers.
//
// What must hold: each frame of a wanted message that the other parser gives, ours gives too. But for
// - frames longer than ours keeps, or with flags or lengths that ours refuses (a MAVLink 1 frame that is longer or
//   shorter than its message; a MAVLink 2 frame with an id that ours has and an unknown incompatibility flag never gets
//   that far in either);
// - a frame that lies inside another frame that ours gave, or inside a message that carries bytes of others: one of the
//   two is a coincidence of checksums, or data, and the parsers need not choose alike.
// And whatever ours gives must be there, byte for byte, with a right checksum; frames come in the order of the bytes
// and do not overlap, one that was found inside a frame that was stepped over included.
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <initializer_list>
#include <map>
#include <vector>

#include "Evidence.h"
#include "mavmission/base/MavlinkHeaders.h"
#include "mavmission/link/Messages.h"

using mavmission::detail::FrameParser;

namespace {

struct Place {
  size_t begin, end;
};

// The frame as it lies in the bytes, by its length; its end is beyond them if it does not fit.
Place placeAt(const Bytes& bytes, size_t begin) {
  const bool v2 = bytes[begin] == 0xFD;
  const size_t header = v2 ? 10 : 6;
  if (begin + header > bytes.size()) return Place{begin, bytes.size() + 1};
  const size_t signature = v2 && (bytes[begin + 2] & 1) ? 13 : 0;
  return Place{begin, begin + header + bytes[begin + 1] + 2 + signature};
}

// What a parser tells of a frame: its flags are not among that.
Bytes toldAt(const Bytes& bytes, Place place) {
  Bytes frame(bytes.begin() + static_cast<long>(place.begin), bytes.begin() + static_cast<long>(place.end) - 2);
  if (frame[0] == 0xFD) frame[2] = frame[3] = 0;
  return frame;
}

bool isCarrierAt(const Bytes& bytes, size_t begin) {
  const bool v2 = bytes[begin] == 0xFD;
  if (begin + (v2 ? 10 : 6) > bytes.size()) return false;
  const unsigned id = v2 ? static_cast<unsigned>(bytes[begin + 7] | bytes[begin + 8] << 8) : bytes[begin + 5];
  if (v2 && bytes[begin + 9] != 0) return false;
  for (unsigned carrier : {110u, 120u, 123u, 126u, 131u, 233u, 248u, 249u, 266u, 267u, 385u, 386u, 387u}) {
    if (id == carrier) return true;
  }
  return false;
}

// Where the wanted frames lie that ours gives.
std::vector<Place> ours(const Bytes& bytes) {
  ParserUnderTest parser;
  std::vector<Found> found = parser.take(bytes);
  for (const Found& more : parser.silence()) found.push_back(more);
  std::vector<Place> places;
  size_t from = 0;
  for (const Found& frame : wanted(found)) {
    demand(mavmission::detail::wantedKey(frame.messageId) != nullptr,
           "a message that is not wanted was given as wanted");
    Bytes payload = frame.payload;
    payload.resize(255, 0);
    bool there = false;
    for (; from < bytes.size() && !there; ++from) {
      const FrameIn in = frameAt(bytes, from);
      if (!in.isRight || bytes[from + 1] != frame.payload.size()) continue;
      if (in.parts.messageId != frame.messageId || in.parts.payload != payload) continue;
      if (in.parts.version != frame.version || in.parts.sequence != frame.sequence) continue;
      if (in.parts.systemId != frame.systemId || in.parts.componentId != frame.componentId) continue;
      if (frame.version == 2 && bytes[from + 2] > 1) continue;  // with flags that it refuses
      places.push_back(Place{from, from + in.size});
      there = true;
    }
    demand(there, "a frame was given that is not in the bytes, or twice, or not in their order");
    from = places.back().end;
  }
  return places;
}

// Where the wanted frames lie that the other parser gives.
std::vector<Place> stock(const Bytes& bytes) {
  mavlink_status_t status = mavlink_status_t();
  mavlink_message_t buffer = mavlink_message_t();
  *mavlink_get_channel_status(MAVLINK_COMM_0) = status;
  *mavlink_get_channel_buffer(MAVLINK_COMM_0) = buffer;
  std::vector<Place> places;
  for (size_t i = 0; i < bytes.size(); ++i) {
    mavlink_message_t message;
    if (mavlink_parse_char(MAVLINK_COMM_0, bytes[i], &message, &status) == 0) continue;
    if (message.msgid > 65535) continue;
    const mavmission::MessageKey* key = mavmission::detail::wantedKey(static_cast<uint16_t>(message.msgid));
    if (key == nullptr || message.len > MAVMISSION_MAX_PAYLOAD) continue;
    const bool v1 = message.magic == MAVLINK_STX_MAVLINK1;
    if (v1 && message.len != key->lengthV1) continue;
    const size_t signature = !v1 && (message.incompat_flags & 1) ? 13 : 0;
    const size_t size = (v1 ? 6u : 10u) + message.len + 2u + signature;
    demand(size <= i + 1, "the other parser gave a frame longer than what it was fed");
    places.push_back(Place{i + 1 - size, i + 1 - signature});
  }
  return places;
}

// The given frames, and all others that say the same: which of these ours gave cannot be told.
std::vector<Place> withTheirLikes(const Bytes& bytes, const std::vector<Place>& given) {
  std::vector<Place> places = given;
  for (const Place& one : given) {
    const Bytes said = toldAt(bytes, one);
    for (size_t begin = 0; begin < bytes.size(); ++begin) {
      const Place place = {begin, begin + (one.end - one.begin)};
      if (bytes[begin] == said[0] && place.end <= bytes.size() && toldAt(bytes, place) == said) places.push_back(place);
    }
  }
  return places;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const Bytes bytes(data, data + size);
  const std::vector<Place> given = ours(bytes);
  // Where several frames say the same, it cannot be told which of them ours gave: they are counted.
  std::map<Bytes, int> missing;
  const std::vector<Place> maybeGiven = withTheirLikes(bytes, given);
  for (const Place& theirs : stock(bytes)) {
    bool excused = false;
    for (const Place& place : maybeGiven) {
      if (place.begin != theirs.begin && place.begin < theirs.end && theirs.begin < place.end) excused = true;
    }
    for (size_t begin = theirs.begin > 280 ? theirs.begin - 280 : 0; begin < theirs.begin && !excused; ++begin) {
      if (bytes[begin] != 0xFD && bytes[begin] != 0xFE) continue;
      if (isCarrierAt(bytes, begin) && placeAt(bytes, begin).end > theirs.begin) excused = true;
    }
    if (!excused) ++missing[toldAt(bytes, theirs)];
  }
  for (const Place& place : given) --missing[toldAt(bytes, place)];
  for (const auto& one : missing) demand(one.second <= 0, "a frame that MAVLink's own parser gives was lost");
  return 0;
}
