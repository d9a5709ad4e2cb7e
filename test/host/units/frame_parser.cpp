#include <doctest/doctest.h>

#include <string.h>

#include <initializer_list>

#include "Frames.h"
#include "MemoryStream.h"

using mavmission::MessageKey;
using mavmission::detail::FrameParser;
using mavmission::detail::MoreKeys;
using Result = FrameParser::Result;

namespace {

const uint16_t kTunnel = 385;
const uint8_t kTunnelExtra = 147;

// A TUNNEL frame with another frame in its payload.
Bytes tunnelAround(const Bytes& inner) {
  Bytes payload = {0, 0, 1, 191, static_cast<uint8_t>(inner.size())};
  payload = payload + inner;
  return packed(FrameParts(kTunnel, payload, kTunnelExtra));
}

// A frame of a message that carries nothing of others, with another frame in its payload.
Bytes telemetryAround(const Bytes& inner) { return packed(FrameParts(30, inner, 39)); }

Bytes part(const Bytes& bytes, size_t from, size_t to) {
  return Bytes(bytes.begin() + static_cast<long>(from), bytes.begin() + static_cast<long>(to));
}

Bytes without(const Bytes& bytes, size_t from, size_t count) {
  return part(bytes, 0, from) + part(bytes, from + count, bytes.size());
}

// With another byte at this place; with a wrong checksum.
Bytes with(size_t at, unsigned value, Bytes frame) {
  frame[at] = static_cast<uint8_t>(value);
  return frame;
}
Bytes wrong(const Bytes& frame) { return with(frame.size() - 1, frame.back() ^ 1u, frame); }

// With a signature; as MAVLink 1.
Bytes signedOf(FrameParts parts) {
  parts.incompatibility = 1;
  return packed(parts);
}
FrameParts requestOfVersion(uint8_t version, uint16_t item) {
  FrameParts parts = requestParts(item);
  parts.version = version;
  if (version == 1) parts.payload.resize(4);
  return parts;
}

// What a fresh parser finds in these bytes, after "|" in the silence after them, and what it has counted.
std::string told(const Bytes& bytes) {
  ParserUnderTest under;
  std::string text = textOf(under.take(bytes));
  const std::string late = textOf(under.silence());
  if (!late.empty()) text += " | " + late;
  const FrameParser& parser = under.parser();
  if (!parser.isIdle()) text += "; not idle";
  if (parser.badChecksums() != 0) text += "; checksums " + std::to_string(parser.badChecksums());
  if (parser.brokenFrames() != 0) text += "; broken " + std::to_string(parser.brokenFrames());
  if (parser.bytesSkipped() != 0) text += "; skipped " + std::to_string(parser.bytesSkipped());
  return text;
}

// What is wanted there and in two requests after it.
std::string behind(const Bytes& bytes) { return wantedIn(bytes + request(1) + telemetry() + request(2)); }

const char* const kBoth = "request 1, request 2";

// What a parser has found and counted.
struct Told {
  std::vector<uint32_t> numbers;
  uint32_t looks = 0;  // at bytes, those that were looked at again included

  void note(Result result, const FrameParser& parser) {
    if (result == Result::Nothing) return;
    numbers.push_back(static_cast<uint32_t>(result));
    numbers.push_back(parser.sequence());
    numbers.push_back(parser.systemId());
    numbers.push_back(parser.componentId());
    if (result == Result::Wanted) {
      numbers.push_back(parser.messageId());
      numbers.insert(numbers.end(), parser.payload(), parser.payload() + parser.length());
    }
  }
  void end(const FrameParser& parser) {
    numbers.push_back(parser.badChecksums());
    numbers.push_back(parser.brokenFrames());
    numbers.push_back(parser.bytesSkipped());
  }
};

FrameParser emptyParser() {
  FrameParser parser;
  memset(static_cast<void*>(&parser), 0, sizeof(parser));
  return parser;
}

Told takenByteByByte(const Bytes& bytes) {
  Told told;
  FrameParser parser = emptyParser();
  for (uint8_t byte : bytes) {
    told.note(parser.take(byte), parser);
    ++told.looks;
    for (; parser.hasWaiting(); ++told.looks) told.note(parser.takeWaiting(), parser);
  }
  told.end(parser);
  return told;
}

// By pull(), which looks at as many bytes a call as it may, and says how many it read.
Told pulled(const Bytes& bytes, uint8_t budget) {
  Told told;
  FrameParser parser = emptyParser();
  MemoryStream stream;
  stream.bring(bytes);
  for (int calls = 0; stream.available() != 0 || parser.hasWaiting(); ++calls) {
    if (calls == 100000) FAIL("it goes on for ever");
    const size_t read = stream.bytesRead;
    FrameParser::Budget left = {budget, 255};
    const Result result = parser.pull(stream, left);
    const bool isCounted = left.heard == stream.bytesRead - read && budget - left.left >= left.heard;
    const bool isUsedUp = left.left == 0 || stream.available() == 0 || result != Result::Nothing;
    if (!isCounted || !isUsedUp) FAIL("budget ", int(budget), ", left ", int(left.left), ", heard ", int(left.heard));
    told.looks += budget - left.left;
    told.note(result, parser);
  }
  told.end(parser);
  return told;
}

}  // namespace

TEST_CASE("a frame is given with its last byte, once, of MAVLink 1 as of MAVLink 2") {
  for (uint8_t version = 1; version <= 2; ++version) {
    FrameParts parts = requestOfVersion(version, 300);
    parts.sequence = 42;
    parts.systemId = 17;
    parts.componentId = 3;
    const Bytes frame = packed(parts);
    ParserUnderTest parser;
    CHECK(parser.take(part(frame, 0, frame.size() - 1)).empty());
    const std::vector<Found> found = parser.take({frame.back()});
    REQUIRE(textOf(found) == "request 300");
    CHECK(found[0].version == version);
    CHECK(found[0].sequence == 42);
    CHECK(found[0].systemId == 17);
    CHECK(found[0].componentId == 3);
    CHECK(found[0].payload == parts.payload);
    CHECK(parser.parser().payloadByte(4) == 0);
    CHECK(parser.parser().isIdle());
    CHECK(parser.silence().empty());
  }
}

TEST_CASE("a MAVLink 1 frame of another length than its message has is none") {
  for (uint8_t length = 0; length < 60; ++length) {
    FrameParts parts = requestOfVersion(1, 3);
    parts.payload.resize(length);
    CAPTURE(length);
    CHECK(wantedIn(packed(parts)) == (length == 4 ? "request 3" : ""));
  }
}

TEST_CASE("a frame of each length is given whole if it is wanted and fits, any other is stepped over") {
  for (unsigned length = 0; length <= 255; ++length) {
    FrameParts asked = requestParts(0), other(30, Bytes(), 39), old(30, Bytes(), 39);
    old.version = 1;
    for (FrameParts* parts : {&asked, &other, &old}) {
      parts->payload.assign(length, 0x11);
      parts->sequence = 77;
      parts->systemId = 8;
      parts->componentId = 9;
      const bool isGiven = parts == &asked && length <= MAVMISSION_MAX_PAYLOAD;
      ParserUnderTest parser;
      const std::vector<Found> found = parser.take(packed(*parts) + request(5));
      CAPTURE(length);
      REQUIRE(found.size() == 2);
      CHECK(found[0].result == (isGiven ? Result::Wanted : Result::Unwanted));
      if (isGiven) CHECK(found[0].payload == parts->payload);
      CHECK(found[0].sequence == 77);
      CHECK(found[0].systemId == 8);
      CHECK(found[0].componentId == 9);
      CHECK(found[1].result == Result::Wanted);
      CHECK(parser.parser().brokenFrames() == 0);
      CHECK(parser.parser().bytesSkipped() == 0);
    }
  }
}

TEST_CASE("what MAVLink 2 leaves out at the end of a payload is zero, and what is not asked for is not copied") {
  const Bytes whole = requestParts(0x0102, 1, 191, 0).payload;
  for (uint8_t length = 1; length <= 5; ++length) {
    FrameParts parts = requestParts(0x0102);
    parts.payload.resize(length);
    ParserUnderTest parser;
    REQUIRE(parser.take(packed(parts)).size() == 1);
    for (uint8_t size = 0; size <= 7; ++size) {
      Bytes copy(8, 0xAA), expected(8, 0xAA);
      parser.parser().copyPayload(copy.data(), size);
      for (uint8_t i = 0; i < size; ++i) expected[i] = i < length ? whole[i] : 0;
      CHECK(copy == expected);
    }
    for (uint8_t i = 0; i < 7; ++i) CHECK(parser.parser().payloadByte(i) == (i < length ? whole[i] : 0));
  }
}

TEST_CASE("a frame is for its target, for everyone where a target is 0, and for all where there is none") {
  for (unsigned system : {0u, 1u, 2u}) {
    for (unsigned component : {0u, 1u, 191u}) {
      ParserUnderTest parser;
      parser.take(packed(requestParts(3, static_cast<uint8_t>(system), static_cast<uint8_t>(component))));
      CAPTURE(system);
      CAPTURE(component);
      CHECK(parser.parser().isFor(1, 191) == (system != 2 && component != 1));
    }
  }
  ParserUnderTest parser;
  parser.take(heartbeat());
  CHECK(parser.parser().isFor(77, 77));
  // A target that MAVLink 2 left out is 0.
  FrameParts parts = ackParts(0);
  parts.payload = {0};
  REQUIRE(textOf(parser.take(packed(parts))) == "ack 0");
  CHECK(parser.parser().isFor(1, 191));
}

TEST_CASE("a signed frame is given, wanted or not, its signature is stepped over, and the next one begins after it") {
  const Bytes frame = signedOf(requestParts(4));
  for (unsigned fill : {0x00u, 0x5Au, 0xFDu, 0xFEu}) {
    const Bytes filled = part(frame, 0, frame.size() - 13) + Bytes(13, static_cast<uint8_t>(fill));
    CAPTURE(fill);
    CHECK(told(filled + filled + request(5)) == "request 4, request 4, request 5");
  }
  CHECK(told(frame) == "request 4");
  CHECK(told(frame + telemetry() + request(5)) == "request 4, other, request 5");
  CHECK(told(frame + Bytes{0x11} + request(5)) == "request 4, request 5; skipped 1");
  CHECK(told(signedOf(FrameParts(30, Bytes(28, 0x11), 39)) + request(5)) == "other, request 5");
}

TEST_CASE(
    "a frame with an incompatibility flag that is not understood is discarded, and no compatibility flag counts") {
  for (unsigned flags = 0; flags <= 255; ++flags) {
    FrameParts incompatible = requestParts(4), compatible = requestParts(4);
    incompatible.incompatibility = static_cast<uint8_t>(flags);
    compatible.compatibility = static_cast<uint8_t>(flags);
    CAPTURE(flags);
    CHECK(wantedIn(packed(incompatible) + request(5)) == (flags <= 1 ? "request 4, request 5" : "request 5"));
    CHECK(wantedIn(packed(compatible) + request(5)) == "request 4, request 5");
  }
}

TEST_CASE("what is given up is told as nothing, and counted once") {
  FrameParts flagged = requestParts(4), tooLong = requestParts(4);
  flagged.incompatibility = 2;
  tooLong.version = 1;
  CHECK(told(packed(flagged)) == "; skipped 17");
  CHECK(told(packed(tooLong)) == "; skipped 13");
  CHECK(told(wrong(request(4))) == "; checksums 1; skipped 17");
  CHECK(told(wrong(request(4)) + request(5)) == "request 5; checksums 1; skipped 17");
  const Bytes noise = {'I', 'n', 'i', 't', ' ', 'A', 'r', 'd', 'u', 'P', 'i', 'l', 'o', 't', '\r', '\n'};
  CHECK(told(noise + request(1) + noise + request(2) + noise) == "request 1, request 2; skipped 48");
}

TEST_CASE("a message that carries bytes of others is told once, after its end, and a frame among its data is data") {
  CHECK(told(telemetry() + tunnelAround(Bytes(9, 0x11) + request(66) + Bytes(30, 0x11))) == "other | other");
  for (size_t filled = 0; filled < 60; ++filled) {
    const Bytes carrier = tunnelAround(Bytes(filled, 0x11) + request(66) + Bytes(7, 0x11));
    CHECK(wantedIn(telemetry() + carrier + request(1)) == "request 1");
  }
  CHECK(wantedIn(request(1) + tunnelAround(Bytes(9, 0x11) + request(66)) + request(2)) == kBoth);
  // A frame among the data of any other message could only be there by damage, and is taken.
  const Bytes inner = Bytes(9, 0x11) + request(66);
  CHECK(wantedIn(telemetry() + telemetryAround(inner) + request(1)) == "request 66, request 1");
  // A carrier with an id of more than 16 bits is none.
  CHECK(wantedIn(telemetry() + packed(FrameParts(0x10000 + kTunnel, inner, 0)) + request(1)) ==
        "request 66, request 1");
}

TEST_CASE("a stepped-over frame after which none begins is counted as broken, once") {
  const Bytes telemetry33 = telemetry(28, 0x33);
  CHECK(told(with(1, 20, telemetry33) + request(1)) == "request 1; broken 1; skipped 8");
  // A wanted frame that is found inside another ends that one.
  CHECK(told(with(1, 255, telemetry33) + request(1) + telemetry() + request(2)) ==
        "request 1, other, request 2; broken 1");
}

TEST_CASE(
    "what looks like a beginning in the last bytes of a telemetry frame is no lost byte, silence after it or not") {
  for (uint8_t magic : {0xFD, 0xFE}) {
    for (size_t fromEnd = 0; fromEnd < 8; ++fromEnd) {
      const Bytes frame = telemetryAround(with(11 - fromEnd, magic, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
      CAPTURE(int(magic));
      CAPTURE(fromEnd);
      CHECK(told(frame + telemetry() + telemetry() + request(7) + telemetry() + request(8)) ==
            "other, other, other, request 7, other, request 8");
      ParserUnderTest parser;
      parser.take(frame);
      parser.silence();
      CHECK(textOf(parser.take(request(7, 42))) == "request 7");
      CHECK(parser.parser().bytesSkipped() == 0);
      CHECK(parser.parser().brokenFrames() == 0);
    }
  }
}

TEST_CASE("a frame of any sequence, version and length that begins inside one with a damaged length is found") {
  const Bytes damaged = with(1, 255, telemetry(28, 0x33));
  const auto found = [&damaged](const FrameParts& parts) {
    return wantedIn(damaged + packed(parts) + telemetry() + request(2));
  };
  for (uint8_t version = 1; version <= 2; ++version) {
    for (unsigned sequence = 0; sequence <= 255; ++sequence) {
      FrameParts parts = requestOfVersion(version, 7);
      parts.sequence = static_cast<uint8_t>(sequence);
      CAPTURE(int(version));
      CAPTURE(sequence);
      CHECK(found(parts) == "request 7, request 2");
    }
  }
  for (unsigned length = 5; length <= MAVMISSION_MAX_PAYLOAD; ++length) {
    FrameParts parts = requestParts(7);
    parts.payload.resize(length, 0x11);
    CAPTURE(length);
    CHECK(found(parts) == "request 7, request 2");
  }
}

TEST_CASE("a frame that lacks its first byte is none, wherever it lies") {
  const Bytes headless = part(request(66), 1, request(66).size());
  CHECK(wantedIn(telemetry() + telemetryAround(headless) + request(1)) == "request 1");
  CHECK(wantedIn(telemetry() + tunnelAround(request(67) + headless) + request(1)) == "request 1");
  CHECK(wantedIn(request(5) + headless + request(1)) == "request 5, request 1");
  // Its header is the last data of a message that carries bytes of others, the rest lies after that one.
  const Bytes carrier = tunnelAround(request(67) + part(request(66, 8), 1, 10));
  FrameParts across = requestParts(0);
  across.sequence = 8;
  across.payload[0] = carrier[carrier.size() - 2];
  across.payload[1] = carrier[carrier.size() - 1];
  const Bytes rest = part(packed(across), 12, packed(across).size());
  CHECK(wantedIn(telemetry() + carrier + rest + request(1)) == "request 1");
}

TEST_CASE("a frame is found after stray bytes that look like the beginning of one, each of which is given up in turn") {
  for (uint8_t magic : {0xFD, 0xFE}) {
    for (size_t count = 1; count < 300; ++count) {
      CAPTURE(int(magic));
      CAPTURE(count);
      CHECK(behind(Bytes(count, magic)) == kBoth);
      if (count > 3) continue;
      CHECK(wantedIn(Bytes(count, magic) + packed(requestOfVersion(1, 3)) + telemetry() + request(2)) ==
            "request 3, request 2");
    }
  }
}

TEST_CASE("a frame after what looks like a carrier only because of damage is taken") {
  // Between frames, but not where one is due: these are the last bytes of a frame whose first were lost.
  const Bytes data = {0x12, 0xFE, 0x7F, 0x3F, 0x51, 0x5C, 123};
  CHECK(behind(telemetry() + data) == kBoth);
  CHECK(behind(request(3) + data) == "request 3, request 1, request 2");
}

TEST_CASE("silence gives what lies after damage, and a whole telemetry frame; a part of one is counted as broken") {
  // A wanted header promises 38 bytes; only a request follows.
  CHECK(told(Bytes{0xFD, 38, 0, 0, 0, 1, 1, 51, 0, 0} + request(1)) == " | request 1; skipped 10");
  CHECK(told(telemetry()) == " | other");
  for (size_t shown = 10; shown < telemetry().size(); ++shown) {
    CAPTURE(shown);
    CHECK(told(part(telemetry(), 0, shown)) == "; broken 1");
  }
}

TEST_CASE("a rescan takes one byte a call, so that its time can be shared out") {
  FrameParser parser = emptyParser();
  const Bytes damaged = wrong(request(4));
  for (uint8_t byte : damaged) CHECK(parser.take(byte) == Result::Nothing);
  unsigned calls = 0;
  for (; parser.hasWaiting(); ++calls) CHECK(parser.takeWaiting() == Result::Nothing);
  CHECK(calls == damaged.size() - 1);
  CHECK(parser.isIdle());
}

TEST_CASE("random bytes lead to no frame that was not there, and to no harm") {
  uint32_t seed = 1;
  for (int round = 0; round < 200; ++round) {
    Bytes noise(1 + round % 90);
    for (uint8_t& byte : noise) {
      seed = seed * 1664525 + 1013904223;
      byte = static_cast<uint8_t>(seed >> 24);
      if (seed % 7 == 0) byte = seed % 2 ? 0xFD : 0xFE;
    }
    CAPTURE(round);
    CHECK(wantedIn(noise + request(1) + telemetry() + request(2) + Bytes(300, 0) + request(3)) ==
          "request 1, request 2, request 3");
  }
}

TEST_CASE("what is pulled from a stream is what its bytes are one by one, however few are looked at each time") {
  uint32_t seed = 7;
  const auto dice = [&seed](uint32_t sides) {
    seed = seed * 1664525 + 1013904223;
    return (seed >> 16) % sides;
  };
  for (int round = 0; round < 400; ++round) {
    Bytes bytes;
    for (int frames = 0; frames < 8; ++frames) {
      Bytes frame;
      switch (dice(6)) {
        case 0: frame = request(static_cast<uint16_t>(dice(600)), static_cast<uint8_t>(frames)); break;
        case 1:
          frame = telemetry(static_cast<uint8_t>(dice(256)), static_cast<uint8_t>(dice(3) == 0 ? 0xFD : dice(256)),
                            static_cast<uint8_t>(1 + dice(2)));
          break;
        case 2: frame = tunnelAround(Bytes(dice(9), 0x11) + request(66)); break;
        case 3: frame = telemetryAround(Bytes(dice(9), 0x11) + request(67)); break;
        case 4: frame = signedOf(requestParts(static_cast<uint16_t>(dice(600)))); break;
        default: frame = Bytes(dice(12), static_cast<uint8_t>(dice(2) ? 0xFE : dice(256))); break;
      }
      const uint32_t harm = dice(8);
      const uint32_t size = static_cast<uint32_t>(frame.size());
      if (harm == 0 && size != 0) frame[dice(size)] ^= static_cast<uint8_t>(1 << dice(8));
      if (harm == 1 && size > 3) frame = without(frame, dice(size - 2), 2);
      bytes = bytes + frame;
    }
    bytes = bytes + request(1);
    const Told expected = takenByteByByte(bytes);
    CAPTURE(round);
    for (uint8_t budget : {uint8_t(1), uint8_t(2), uint8_t(7), uint8_t(64), uint8_t(255)}) {
      CAPTURE(int(budget));
      const Told told = pulled(bytes, budget);
      REQUIRE(told.numbers == expected.numbers);
      REQUIRE(told.looks == expected.looks);
    }
  }
}

TEST_CASE("a listener's messages are wanted too, wherever in its list they are, and no others") {
  struct Lists {
    static const MessageKey* search(const MoreKeys* list, uint16_t messageId) { return list->find(messageId); }
  };
  const MessageKey keys[] = {{30, 39, 28, 28, MessageKey::kNoTarget}, {33, 104, 28, 28, MessageKey::kNoTarget}};
  MoreKeys list = {keys, 2, nullptr, Lists::search, nullptr};
  FrameParser parser = emptyParser();
  parser.moreKeys() = &list;
  const auto last = [&parser](const Bytes& bytes) {
    Result result = Result::Nothing;
    for (uint8_t byte : bytes) result = parser.take(byte);
    return result;
  };
  CHECK(list.find(30) == &keys[0]);
  CHECK(list.find(33) == &keys[1]);
  CHECK(list.find(31) == nullptr);
  CHECK(last(telemetry(28, 0x11)) == Result::Wanted);
  CHECK(parser.messageId() == 30);
  CHECK(last(packed(FrameParts(33, Bytes(28, 0x22), 104))) == Result::Wanted);
  CHECK(parser.messageId() == 33);
  CHECK(parser.isFor(9, 9));
  CHECK(last(request(3)) == Result::Wanted);
  CHECK(parser.messageId() == 51);
  list.count = 1;
  CHECK(list.find(33) == nullptr);
}

TEST_CASE("a number of a payload is made of its bytes, the first being the lowest, and of 0 where they were left out") {
  FrameParts parts = ackParts(0);
  parts.payload = {0x01, 0x82, 0x03, 0xF4, 0x05, 0x96};
  ParserUnderTest parser;
  REQUIRE(parser.take(packed(parts)).size() == 1);
  CHECK(parser.parser().payloadWord(0) == 0x8201);
  CHECK(parser.parser().payloadWord(3) == 0x05F4);
  CHECK(parser.parser().payloadWord(5) == 0x0096);
  CHECK(parser.parser().payloadWord(6) == 0);
  CHECK(parser.parser().payloadLong(0) == 0xF4038201);
  CHECK(parser.parser().payloadLong(2) == 0x9605F403);
  CHECK(parser.parser().payloadLong(4) == 0x9605);
  CHECK(parser.parser().payloadLong(6) == 0);
}
