// How many undamaged frames a parser loses after damage: ours and the one in MAVLink's headers.
//
//   measure STREAM
//
// STREAM holds frames, each behind its length (two bytes, little-endian). It is taken as a stream without a beginning
// or an end. Each kind of damage is done at each byte of it, once, by itself; the parser comes to it in step, and is
// fed until it is in step again: between two frames, in the state of a parser that has just begun. What it does from
// there on is what it does without damage, so every frame that the damage costs has been counted.
//
// A frame counts when it is whole, is of a message that our parser keeps, and reaches the parser as it was sent.
// (Where it cannot be told from the bytes that are left which of two frames lost one, neither counts.)
//
// Prints one line for each kind of damage and parser, "none" first (there, in the place of positions, wanted frames):
//   KIND|PARSER|positions|frames lost|positions with a loss|frames that nobody sent|where the first losses are
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <string>
#include <vector>

#include "mavmission/base/MavlinkHeaders.h"
#include "mavmission/link/FrameParser.h"

namespace {

typedef std::vector<uint8_t> Bytes;

struct Frame {
  size_t start;
  Bytes bytes;
  bool isWanted;
};

std::vector<Frame> frames;
Bytes stream;
std::vector<size_t> frameAt;  // for each byte of the stream: its frame
std::vector<bool> findable;   // for each frame: the parser gives it when nothing is damaged

void fail(const char* what) {
  fprintf(stderr, "%s\n", what);
  exit(2);
}

bool isWanted(const Bytes& frame) {
  if (frame[0] == 0xFE) return mavmission::detail::wantedKey(frame[5]) != nullptr;
  return frame[9] == 0 && mavmission::detail::wantedKey(static_cast<uint16_t>(frame[7] | frame[8] << 8)) != nullptr;
}

void read(const char* path) {
  FILE* file = fopen(path, "rb");
  if (file == nullptr) fail("the stream cannot be read");
  int low, high;
  while ((low = fgetc(file)) != EOF && (high = fgetc(file)) != EOF) {
    Bytes bytes(static_cast<size_t>(low | high << 8));
    if (fread(bytes.data(), 1, bytes.size(), file) != bytes.size()) fail("the stream ends within a frame");
    frameAt.insert(frameAt.end(), bytes.size(), frames.size());
    frames.push_back(Frame{stream.size(), bytes, isWanted(bytes)});
    stream.insert(stream.end(), bytes.begin(), bytes.end());
  }
  fclose(file);
  if (frames.size() < 20) fail("the stream is too short");
}

const Frame& frame(size_t number) { return frames[number % frames.size()]; }
uint8_t byteAt(size_t position) { return stream[position % stream.size()]; }

// What a parser gave of a frame: enough to know it again.
Bytes identity(uint32_t id, uint8_t sequence, uint8_t system, const uint8_t* payload, size_t length) {
  Bytes known(4 + length);
  known[0] = static_cast<uint8_t>(id);
  known[1] = static_cast<uint8_t>(id >> 8);
  known[2] = sequence;
  known[3] = system;
  for (size_t i = 0; i < length; ++i) known[4 + i] = payload[i];
  while (known.size() > 5 && known.back() == 0) known.pop_back();
  return known;
}

Bytes identity(const Frame& sent) {
  const Bytes& b = sent.bytes;
  if (b[0] == 0xFE) return identity(b[5], b[2], b[3], &b[6], b[1]);
  return identity(static_cast<uint32_t>(b[7] | b[8] << 8 | b[9] << 16), b[4], b[5], &b[10], b[1]);
}

class Ours {
 public:
  static const char* name() { return "ours"; }
  Ours() { memset(static_cast<void*>(&parser_), 0, sizeof(parser_)); }
  void take(uint8_t byte) {
    note(parser_.take(byte));
    drain();
  }
  void silence() {
    while (!parser_.isIdle()) {
      note(parser_.silence());
      drain();
    }
  }
  bool isInStep() const { return parser_.isIdle(); }
  std::vector<Bytes> found;

 private:
  void drain() {
    while (parser_.hasWaiting()) note(parser_.takeWaiting());
  }
  void note(mavmission::detail::FrameParser::Result result) {
    if (result != mavmission::detail::FrameParser::Result::Wanted) return;
    found.push_back(
        identity(parser_.messageId(), parser_.sequence(), parser_.systemId(), parser_.payload(), parser_.length()));
  }
  mavmission::detail::FrameParser parser_;
};

class Stock {
 public:
  static const char* name() { return "stock"; }
  Stock() {
    memset(mavlink_get_channel_status(MAVLINK_COMM_0), 0, sizeof(mavlink_status_t));
    memset(mavlink_get_channel_buffer(MAVLINK_COMM_0), 0, sizeof(mavlink_message_t));
  }
  void take(uint8_t byte) {
    mavlink_message_t message;
    mavlink_status_t status;
    if (mavlink_parse_char(MAVLINK_COMM_0, byte, &message, &status) == 0 ||
        mavmission::detail::wantedKey(message.msgid) == nullptr)
      return;
    const uint8_t* payload = reinterpret_cast<const uint8_t*>(&message.payload64[0]);
    found.push_back(identity(message.msgid, message.seq, message.sysid, payload, message.len));
  }
  void silence() {}
  bool isInStep() const {
    const mavlink_parse_state_t state = mavlink_get_channel_status(MAVLINK_COMM_0)->parse_state;
    return state == MAVLINK_PARSE_STATE_UNINIT || state == MAVLINK_PARSE_STATE_IDLE;
  }
  std::vector<Bytes> found;
};

struct Damage {
  const char* name;
  enum { Lost, Flipped, CutShort } kind;
  size_t bytes;
  uint8_t mask;
};

const Damage kDamages[] = {
    {"1 byte lost", Damage::Lost, 1, 0},
    {"2 bytes lost", Damage::Lost, 2, 0},
    {"3 bytes lost", Damage::Lost, 3, 0},
    {"5 bytes lost", Damage::Lost, 5, 0},
    {"8 bytes lost", Damage::Lost, 8, 0},
    {"16 bytes lost", Damage::Lost, 16, 0},
    {"32 bytes lost", Damage::Lost, 32, 0},
    {"63 bytes lost", Damage::Lost, 63, 0},
    {"lowest bit flipped", Damage::Flipped, 1, 0x01},
    {"bit 4 flipped", Damage::Flipped, 1, 0x10},
    {"highest bit flipped", Damage::Flipped, 1, 0x80},
    {"all bits flipped", Damage::Flipped, 1, 0xFF},
    {"frame cut short, then silence", Damage::CutShort, 0, 0},
};

struct Loss {
  size_t frames = 0;
  size_t falseFrames = 0;
};

// Damages the stream at `position`. Positions count on past the end of the stream, so that nothing wraps within a run.
template <typename Parser>
Loss lossesAt(const Damage& damage, size_t position) {
  position += stream.size();  // there is always something before it
  const size_t struck = frames.size() + frameAt[position - stream.size()];
  size_t begin = position, end = position + damage.bytes;
  bool silent = false;
  switch (damage.kind) {
    case Damage::Lost:
    case Damage::Flipped: break;
    case Damage::CutShort:
      end = frame(struck).start + frame(struck).bytes.size() + stream.size();
      silent = true;
      break;
  }
  // Losing other bytes nearby may leave the very same bytes: whose they were is then not known.
  size_t firstTouched = begin, lastTouched = end - 1;
  if (damage.kind != Damage::Flipped) {
    while (byteAt(firstTouched - 1) == byteAt(firstTouched - 1 + (end - begin))) --firstTouched;
    while (byteAt(lastTouched + 1) == byteAt(lastTouched + 1 - (end - begin))) ++lastTouched;
  }

  Parser parser;
  std::vector<Bytes> expected;
  std::vector<bool> certain;
  size_t number = struck - 4;  // the frame at whose end we are
  for (;; ++number) {
    const Frame& now = frame(number);
    const size_t start = now.start + number / frames.size() * stream.size();
    const size_t behind = start + now.bytes.size();
    for (size_t at = start; at < behind; ++at) {
      const bool isStruck = at >= begin && at < end;
      if (!isStruck) parser.take(byteAt(at));
      if (isStruck && damage.kind == Damage::Flipped) parser.take(byteAt(at) ^ damage.mask);
    }
    if (now.isWanted) {
      expected.push_back(identity(now));
      certain.push_back(findable[number % frames.size()] && (behind <= firstTouched || start > lastTouched));
    }
    if (silent && behind == end) parser.silence();
    if (start > lastTouched && parser.isInStep()) break;
    if (number > struck + 300) fail("the parser does not come into step again");
  }

  Loss loss;
  size_t next = 0;
  for (const Bytes& found : parser.found) {
    size_t match = next;
    while (match < expected.size() && expected[match] != found) ++match;
    if (match == expected.size()) {
      ++loss.falseFrames;
      continue;
    }
    for (; next < match; ++next) loss.frames += certain[next];
    next = match + 1;
  }
  for (; next < expected.size(); ++next) loss.frames += certain[next];
  return loss;
}

template <typename Parser>
void measure(const Damage& damage) {
  size_t positions = 0, lost = 0, struck = 0, falseFrames = 0;
  std::string where;
  for (size_t position = 0; position < stream.size(); ++position) {
    if (damage.kind == Damage::CutShort && position == frames[frameAt[position]].start) continue;  // nothing of it came
    const Loss loss = lossesAt<Parser>(damage, position);
    ++positions;
    lost += loss.frames;
    falseFrames += loss.falseFrames;
    if (loss.frames == 0) continue;
    if (++struck <= 10) where += " " + std::to_string(position) + ":" + std::to_string(loss.frames);
  }
  printf("%s|%s|%zu|%zu|%zu|%zu|%s\n", damage.name, Parser::name(), positions, lost, struck, falseFrames,
         where.c_str());
}

// Notes which frames the parser finds where nothing is damaged: the others cannot be lost by damage.
template <typename Parser>
std::vector<bool> foundUndamaged() {
  Parser parser;
  std::vector<Bytes> sent;
  for (const Frame& one : frames) {
    for (uint8_t byte : one.bytes) parser.take(byte);
  }
  parser.silence();
  std::vector<bool> isFound(frames.size());
  size_t next = 0;
  for (size_t i = 0; i < frames.size(); ++i) {
    if (!frames[i].isWanted || next == parser.found.size() || parser.found[next] != identity(frames[i])) continue;
    isFound[i] = true;
    ++next;
  }
  if (next != parser.found.size()) fail("frames are found in the undamaged stream that nobody sent");
  return isFound;
}

template <typename Parser>
void measureAll() {
  findable = foundUndamaged<Parser>();
  size_t wanted = 0, lost = 0;
  for (size_t i = 0; i < frames.size(); ++i) {
    wanted += frames[i].isWanted;
    lost += frames[i].isWanted && !findable[i];
  }
  printf("none|%s|%zu|%zu|0|0|\n", Parser::name(), wanted, lost);
  for (const Damage& damage : kDamages) measure<Parser>(damage);
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) fail("usage: measure STREAM");
  read(words[1]);
  measureAll<Stock>();
  measureAll<Ours>();
}
