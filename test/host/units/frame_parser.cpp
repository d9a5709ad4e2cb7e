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

TEST_CASE("a frame is given with its last byte, once") {
  ParserUnderTest parser;
  const Bytes frame = request(7, 42);
  CHECK(parser.take(part(frame, 0, frame.size() - 1)).empty());
  const std::vector<Found> found = parser.take({frame.back()});
  REQUIRE(found.size() == 1);
  CHECK(found[0].result == Result::Wanted);
  CHECK(found[0].messageId == 51);
  CHECK(found[0].version == 2);
  CHECK(found[0].sequence == 42);
  CHECK(found[0].systemId == 1);
  CHECK(found[0].componentId == 1);
  CHECK(found[0].payload == requestParts(7).payload);
  CHECK(parser.parser().isIdle());
  CHECK(parser.silence().empty());
}

TEST_CASE("a MAVLink 1 frame is given like one of MAVLink 2") {
  FrameParts parts = requestParts(300);
  parts.version = 1;
  parts.sequence = 9;
  parts.systemId = 17;
  parts.componentId = 3;
  parts.payload.resize(4);
  ParserUnderTest parser;
  const std::vector<Found> found = parser.take(packed(parts));
  REQUIRE(found.size() == 1);
  CHECK(found[0].version == 1);
  CHECK(found[0].sequence == 9);
  CHECK(found[0].systemId == 17);
  CHECK(found[0].componentId == 3);
  CHECK(found[0].payload == parts.payload);
  CHECK(parser.parser().payloadByte(4) == 0);
}

TEST_CASE("a MAVLink 1 frame of another length than its message has is none") {
  for (uint8_t length = 0; length < 60; ++length) {
    FrameParts parts = requestParts(3);
    parts.version = 1;
    parts.payload.resize(length);
    CAPTURE(length);
    CHECK(wantedIn(packed(parts)) == (length == 4 ? "request 3" : ""));
  }
}

TEST_CASE("a wanted MAVLink 2 frame of every length that fits is given whole, and a longer one is stepped over") {
  for (unsigned length = 0; length <= 255; ++length) {
    FrameParts parts = requestParts(0);
    parts.payload.assign(length, 0x11);
    ParserUnderTest parser;
    const std::vector<Found> found = parser.take(packed(parts) + request(5));
    CAPTURE(length);
    REQUIRE(found.size() == 2);
    CHECK(found[0].result == (length <= MAVMISSION_MAX_PAYLOAD ? Result::Wanted : Result::Unwanted));
    if (length <= MAVMISSION_MAX_PAYLOAD) CHECK(found[0].payload == parts.payload);
    CHECK(found[1].result == Result::Wanted);
    CHECK(parser.parser().bytesSkipped() == 0);
  }
}

TEST_CASE("a frame of another message is stepped over whatever its length and version") {
  for (uint8_t version = 1; version <= 2; ++version) {
    for (unsigned length = 0; length <= 255; ++length) {
      ParserUnderTest parser;
      FrameParts parts(30, Bytes(length, 0x11), 39);
      parts.version = version;
      parts.sequence = 77;
      parts.systemId = 8;
      parts.componentId = 9;
      const std::vector<Found> found = parser.take(packed(parts) + request(5));
      CAPTURE(version);
      CAPTURE(length);
      REQUIRE(found.size() == 2);
      CHECK(found[0].result == Result::Unwanted);
      CHECK(found[0].sequence == 77);
      CHECK(found[0].systemId == 8);
      CHECK(found[0].componentId == 9);
      CHECK(found[1].result == Result::Wanted);
      CHECK(parser.parser().brokenFrames() == 0);
      CHECK(parser.parser().bytesSkipped() == 0);
    }
  }
}

TEST_CASE("what MAVLink 2 leaves out at the end of a payload is zero") {
  const Bytes whole = requestParts(0x0102, 1, 191, 0).payload;
  for (uint8_t length = 1; length <= 5; ++length) {
    FrameParts parts = requestParts(0x0102);
    parts.payload.resize(length);
    ParserUnderTest parser;
    REQUIRE(parser.take(packed(parts)).size() == 1);
    uint8_t copy[7];
    parser.parser().copyPayload(copy, sizeof(copy));
    for (uint8_t i = 0; i < 7; ++i) {
      const uint8_t expected = i < length ? whole[i] : 0;
      CHECK(copy[i] == expected);
      CHECK(parser.parser().payloadByte(i) == expected);
    }
  }
}

TEST_CASE("a payload that is longer than what is asked for is cut off in the copy, no byte written behind it") {
  ParserUnderTest parser;
  REQUIRE(parser.take(request(0x0102)).size() == 1);
  uint8_t copy[3] = {0xAA, 0xAA, 0xAA};
  parser.parser().copyPayload(copy, 2);
  CHECK(copy[0] == 2);
  CHECK(copy[1] == 1);
  CHECK(copy[2] == 0xAA);
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
}

TEST_CASE("a target that MAVLink 2 left out is 0, and so for everyone") {
  FrameParts parts = ackParts(0);
  parts.payload = {0};
  ParserUnderTest parser;
  REQUIRE(parser.take(packed(parts)).size() == 1);
  CHECK(parser.parser().isFor(1, 191));
}

TEST_CASE("a signed frame is given, and its signature stepped over") {
  for (unsigned fill : {0x00u, 0x5Au, 0xFDu, 0xFEu}) {
    FrameParts parts = requestParts(4);
    parts.incompatibility = 1;
    Bytes frame = packed(parts);
    for (size_t i = frame.size() - 13; i < frame.size(); ++i) frame[i] = static_cast<uint8_t>(fill);
    CAPTURE(fill);
    CHECK(wantedIn(frame + frame + request(5)) == "request 4, request 4, request 5");
    ParserUnderTest parser;
    CHECK(parser.take(frame + request(5)).size() == 2);
    CHECK(parser.parser().bytesSkipped() == 0);
  }
}

TEST_CASE("behind a signed frame the next one begins, wanted or not, and a byte between them is counted") {
  FrameParts parts = requestParts(4);
  parts.incompatibility = 1;
  ParserUnderTest parser;
  const std::vector<Found> found = parser.take(packed(parts) + telemetry() + request(5));
  REQUIRE(found.size() == 3);
  CHECK(found[1].result == Result::Unwanted);
  CHECK(found[2].result == Result::Wanted);
  CHECK(parser.parser().bytesSkipped() == 0);
  CHECK(parser.parser().brokenFrames() == 0);
  parser.take(packed(parts) + Bytes{0x11} + request(5));
  CHECK(parser.parser().bytesSkipped() == 1);
}

TEST_CASE("a signed frame of another message is stepped over, signature and all") {
  FrameParts parts(30, Bytes(28, 0x11), 39);
  parts.incompatibility = 1;
  ParserUnderTest parser;
  const std::vector<Found> found = parser.take(packed(parts) + request(5));
  REQUIRE(found.size() == 2);
  CHECK(found[0].result == Result::Unwanted);
  CHECK(found[1].result == Result::Wanted);
  CHECK(parser.parser().brokenFrames() == 0);
}

TEST_CASE("a frame with an incompatibility flag that is not understood is discarded") {
  for (unsigned flags = 0; flags <= 255; ++flags) {
    FrameParts parts = requestParts(4);
    parts.incompatibility = static_cast<uint8_t>(flags);
    CAPTURE(flags);
    CHECK(wantedIn(packed(parts) + request(5)) == (flags <= 1 ? "request 4, request 5" : "request 5"));
  }
}

TEST_CASE("compatibility flags are of no account") {
  for (unsigned flags = 0; flags <= 255; ++flags) {
    FrameParts parts = requestParts(4);
    parts.compatibility = static_cast<uint8_t>(flags);
    CHECK(wantedIn(packed(parts) + request(5)) == "request 4, request 5");
  }
}

TEST_CASE("each bit that is wrong in a frame of the service makes it none") {
  const Bytes good = request(4);
  for (size_t byte = 0; byte < good.size(); ++byte) {
    for (int bit = 0; bit < 8; ++bit) {
      Bytes damaged = good;
      damaged[byte] = static_cast<uint8_t>(damaged[byte] ^ 1 << bit);
      CAPTURE(byte);
      CAPTURE(bit);
      CHECK(wantedIn(damaged + request(5)) == "request 5");
    }
  }
}

TEST_CASE("what is given up is told as nothing") {
  FrameParts flagged = requestParts(4);
  flagged.incompatibility = 2;
  FrameParts tooLong = requestParts(4);
  tooLong.version = 1;
  Bytes damaged = request(4);
  damaged.back() = static_cast<uint8_t>(damaged.back() ^ 1);
  for (const Bytes& bytes : {packed(flagged), packed(tooLong), damaged}) {
    ParserUnderTest parser;
    CHECK(parser.take(bytes).empty());
    CHECK(parser.silence().empty());
    CHECK(parser.parser().bytesSkipped() == bytes.size());
  }
}

TEST_CASE("a message that carries bytes of others is told once, behind its end") {
  ParserUnderTest parser;
  CHECK(parser.take(telemetry()).empty());
  const std::vector<Found> found = parser.take(tunnelAround(Bytes(9, 0x11) + request(66) + Bytes(30, 0x11)));
  REQUIRE(found.size() == 1);
  CHECK(found[0].result == Result::Unwanted);  // the one before
  REQUIRE(parser.silence().size() == 1);
  CHECK(parser.parser().brokenFrames() == 0);
  CHECK(parser.parser().badChecksums() == 0);
}

TEST_CASE("silence behind a signed frame tells nothing more") {
  FrameParts parts = requestParts(4);
  parts.incompatibility = 1;
  ParserUnderTest parser;
  CHECK(parser.take(packed(parts)).size() == 1);
  CHECK(parser.silence().empty());
  CHECK(parser.parser().brokenFrames() == 0);
}

TEST_CASE("a stepped-over frame behind which none begins is counted as broken, once") {
  Bytes damaged = telemetry(28, 0x33);
  damaged[1] = 20;
  ParserUnderTest parser;
  CHECK(wanted(parser.take(damaged + request(1))).size() == 1);
  CHECK(parser.parser().brokenFrames() == 1);
}

TEST_CASE("frames behind one that ends in what looks like a beginning are stepped over like any") {
  for (uint8_t magic : {0xFD, 0xFE}) {
    for (size_t behind = 0; behind < 8; ++behind) {
      Bytes payload = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
      payload[payload.size() - 1 - behind] = magic;
      ParserUnderTest parser;
      const std::vector<Found> found =
          parser.take(telemetryAround(payload) + telemetry() + telemetry() + request(7) + telemetry() + request(8));
      CAPTURE(int(magic));
      CAPTURE(behind);
      CHECK(found.size() == 6);
      CHECK(parser.parser().bytesSkipped() == 0);
    }
  }
}

TEST_CASE("a wrong checksum is counted, once") {
  ParserUnderTest parser;
  Bytes damaged = request(4);
  damaged.back() = static_cast<uint8_t>(damaged.back() ^ 1);
  parser.take(damaged + request(5));
  CHECK(parser.parser().badChecksums() == 1);
  CHECK(parser.parser().bytesSkipped() == damaged.size());
}

TEST_CASE("the checksum of another edition of a message is wrong") {
  FrameParts parts = requestParts(4);
  parts.crcExtra = 195;
  CHECK(wantedIn(packed(parts) + request(5)) == "request 5");
}

TEST_CASE("bytes between frames are skipped and counted") {
  ParserUnderTest parser;
  const Bytes noise = {'I', 'n', 'i', 't', ' ', 'A', 'r', 'd', 'u', 'P', 'i', 'l', 'o', 't', '\r', '\n'};
  CHECK(wanted(parser.take(noise + request(1) + noise + request(2) + noise)).size() == 2);
  CHECK(parser.parser().bytesSkipped() == 3 * noise.size());
}

TEST_CASE("two frames are found behind each number of lost bytes at each position of a telemetry frame") {
  const Bytes before = telemetry(28, 0x33);
  for (size_t count = 1; count < before.size(); ++count) {
    for (size_t from = 0; from + count <= before.size(); ++from) {
      CAPTURE(count);
      CAPTURE(from);
      CHECK(wantedIn(without(before, from, count) + request(1) + telemetry() + request(2)) == "request 1, request 2");
    }
  }
}

TEST_CASE("a frame that begins inside one with a damaged length is found, however long that says to be") {
  for (unsigned length = 0; length <= 255; ++length) {
    Bytes damaged = telemetry(28, 0x33);
    damaged[1] = static_cast<uint8_t>(length);
    CAPTURE(length);
    CHECK(wantedIn(damaged + request(1) + telemetry() + request(2) + telemetry() + request(3)) ==
          "request 1, request 2, request 3");
  }
}

TEST_CASE("a frame of any sequence, version and length that begins inside one with a damaged length is found") {
  Bytes damaged = telemetry(28, 0x33);
  damaged[1] = 255;
  for (uint8_t version = 1; version <= 2; ++version) {
    for (unsigned sequence = 0; sequence <= 255; ++sequence) {
      FrameParts parts = requestParts(7);
      parts.version = version;
      parts.sequence = static_cast<uint8_t>(sequence);
      if (version == 1) parts.payload.resize(4);
      CAPTURE(int(version));
      CAPTURE(sequence);
      CHECK(wantedIn(damaged + packed(parts) + telemetry() + request(2)) == "request 7, request 2");
    }
  }
  for (unsigned length = 5; length <= MAVMISSION_MAX_PAYLOAD; ++length) {
    FrameParts parts = requestParts(7);
    parts.payload.resize(length, 0x11);
    CAPTURE(length);
    CHECK(wantedIn(damaged + packed(parts) + telemetry() + request(2)) == "request 7, request 2");
  }
}

TEST_CASE("a frame behind a wanted one with a damaged length is found") {
  for (unsigned length = 0; length <= 255; ++length) {
    if (length == 5) continue;
    Bytes damaged = request(9);
    damaged[1] = static_cast<uint8_t>(length);
    CAPTURE(length);
    CHECK(wantedIn(damaged + request(1) + telemetry() + request(2)) == "request 1, request 2");
  }
}

TEST_CASE("a frame is found behind bytes that begin like one, at the end of a telemetry frame") {
  // Each tail of a header, complete with the bytes of the real frame behind it, could swallow that frame's first bytes.
  const Bytes heads[] = {{0xFD, 0xFF, 0, 0, 0x36, 1, 1, 0x6A, 0, 0}, {0xFE, 0xFF, 0x36, 1, 1, 0x1E}};
  for (const Bytes& head : heads) {
    for (size_t shown = 1; shown < head.size(); ++shown) {
      const Bytes last = telemetryAround(Bytes(20, 0x11) + part(head, 0, shown));
      CAPTURE(shown);
      CHECK(wantedIn(last + request(1) + telemetry() + request(2)) == "request 1, request 2");
      // The same with the checksum among the bytes that deceive.
      for (uint8_t behind = 1; behind < 3; ++behind) {
        Bytes deceiving = telemetry(20, 0x11);
        deceiving[deceiving.size() - behind] = head[0];
        CHECK(wantedIn(deceiving + request(1) + telemetry() + request(2)) == "request 1, request 2");
      }
    }
  }
}

TEST_CASE("a wanted header that is only data, across the end of a telemetry frame, hides no frame") {
  for (unsigned length = 0; length <= MAVMISSION_MAX_PAYLOAD; ++length) {
    const Bytes last =
        telemetryAround(Bytes(20, 0x11) + Bytes{0xFD, static_cast<uint8_t>(length), 0, 0, 0, 1, 1, 51, 0, 0});
    CAPTURE(length);
    CHECK(wantedIn(last + request(1) + telemetry() + request(2)) == "request 1, request 2");
  }
}

TEST_CASE("a frame among the data of a message that carries bytes of others is data") {
  for (size_t filled = 0; filled < 60; ++filled) {
    const Bytes carrier = tunnelAround(Bytes(filled, 0x11) + request(66) + Bytes(7, 0x11));
    CHECK(wantedIn(telemetry() + carrier + request(1)) == "request 1");
  }
}

TEST_CASE("a message that carries bytes of others is known as one behind a wanted frame too") {
  CHECK(wantedIn(request(1) + tunnelAround(Bytes(9, 0x11) + request(66)) + request(2)) == "request 1, request 2");
}

TEST_CASE("a frame that lacks its first byte is none, wherever it lies") {
  const Bytes headless = part(request(66), 1, request(66).size());
  CHECK(wantedIn(telemetry() + telemetryAround(headless) + request(1)) == "request 1");
  CHECK(wantedIn(telemetry() + tunnelAround(request(67) + headless) + request(1)) == "request 1");
  CHECK(wantedIn(request(5) + headless + request(1)) == "request 5, request 1");
  // Its header is the last data of a message that carries bytes of others, the rest lies behind that one.
  const Bytes carrier = tunnelAround(request(67) + part(request(66, 8), 1, 10));
  FrameParts across = requestParts(0);
  across.sequence = 8;
  across.payload[0] = carrier[carrier.size() - 2];
  across.payload[1] = carrier[carrier.size() - 1];
  const Bytes rest = part(packed(across), 12, packed(across).size());
  CHECK(wantedIn(telemetry() + carrier + rest + request(1)) == "request 1");
}

TEST_CASE("a frame is found behind stray bytes that look like the beginning of one") {
  for (uint8_t magic : {0xFD, 0xFE}) {
    for (uint8_t version = 1; version <= 2; ++version) {
      for (size_t count = 1; count <= 3; ++count) {
        FrameParts parts = requestParts(3);
        parts.version = version;
        if (version == 1) parts.payload.resize(4);
        CAPTURE(int(magic));
        CAPTURE(int(version));
        CAPTURE(count);
        CHECK(wantedIn(Bytes(count, magic) + packed(parts) + telemetry() + request(2)) == "request 3, request 2");
      }
    }
  }
}

TEST_CASE("a frame among the data of any other message could only be there by damage, and is taken") {
  CHECK(wantedIn(telemetry() + telemetryAround(Bytes(9, 0x11) + request(66)) + request(1)) == "request 66, request 1");
}

TEST_CASE("a frame behind what looks like a carrier only because of damage is taken") {
  // Between frames, but not where one is due: these are the last bytes of a frame whose first were lost.
  const Bytes data = {0x12, 0xFE, 0x7F, 0x3F, 0x51, 0x5C, 123};
  CHECK(wantedIn(telemetry() + data + request(1) + telemetry() + request(2)) == "request 1, request 2");
  CHECK(wantedIn(request(3) + data + request(1) + telemetry() + request(2)) == "request 3, request 1, request 2");
}

TEST_CASE("a wanted frame that is found inside another ends that one, which is counted as broken") {
  Bytes damaged = telemetry(28, 0x33);
  damaged[1] = 255;
  ParserUnderTest parser;
  const std::vector<Found> found = parser.take(damaged + request(1) + telemetry() + request(2));
  REQUIRE(found.size() == 3);
  CHECK(found[0].result == Result::Wanted);
  CHECK(found[1].result == Result::Unwanted);
  CHECK(found[2].result == Result::Wanted);
  CHECK(parser.parser().brokenFrames() == 1);
}

TEST_CASE("a carrier with an id of more than 16 bits is none") {
  const Bytes inner = Bytes(9, 0x11) + request(66);
  CHECK(wantedIn(telemetry() + packed(FrameParts(0x10000 + kTunnel, inner, 0)) + request(1)) ==
        "request 66, request 1");
}

TEST_CASE("an id of more than 16 bits is not that of a wanted message") {
  FrameParts parts = requestParts(4);
  parts.messageId = 0x10000 + 51;
  ParserUnderTest parser;
  const std::vector<Found> found = parser.take(packed(parts) + request(5));
  REQUIRE(found.size() == 2);
  CHECK(found[0].result == Result::Unwanted);
}

TEST_CASE("a frame cut short is given up in silence, and the next one taken") {
  for (const Bytes& frame : {request(9), telemetry(), telemetry(255), packed(requestParts(0xFDFD, 0xFD, 0xFD))}) {
    for (size_t shown = 1; shown < frame.size(); ++shown) {
      ParserUnderTest parser;
      parser.take(part(frame, 0, shown));
      CHECK(wanted(parser.silence()).empty());
      CHECK(parser.parser().isIdle());
      CAPTURE(shown);
      CHECK(wanted(parser.take(request(1))).size() == 1);
    }
  }
}

TEST_CASE("silence gives the frame that damage before it had made part of another") {
  // A wanted header promises 38 bytes; only a request follows.
  const Bytes head = {0xFD, 38, 0, 0, 0, 1, 1, 51, 0, 0};
  ParserUnderTest parser;
  CHECK(wanted(parser.take(head + request(1))).empty());
  CHECK(wanted(parser.silence()).size() == 1);
  CHECK(parser.parser().isIdle());
}

TEST_CASE("silence behind a whole telemetry frame gives it, and behind a part of one counts it as broken") {
  ParserUnderTest whole;
  CHECK(whole.take(telemetry()).empty());
  const std::vector<Found> found = whole.silence();
  REQUIRE(found.size() == 1);
  CHECK(found[0].result == Result::Unwanted);
  CHECK(whole.parser().brokenFrames() == 0);

  for (size_t shown = 10; shown < telemetry().size(); ++shown) {
    ParserUnderTest cut;
    cut.take(part(telemetry(), 0, shown));
    CAPTURE(shown);
    CHECK(cut.silence().empty());
    CHECK(cut.parser().brokenFrames() == 1);
  }
}

TEST_CASE(
    "what looks like a beginning in the last bytes of a telemetry frame is no lost byte, silence behind it or not") {
  for (uint8_t magic : {0xFD, 0xFE}) {
    for (size_t behind = 0; behind < 8; ++behind) {
      CAPTURE(int(magic));
      CAPTURE(behind);
      Bytes payload = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
      payload[payload.size() - 1 - behind] = magic;
      ParserUnderTest parser;
      parser.take(telemetryAround(payload));
      parser.silence();
      CHECK(parser.take(request(7, 42)).size() == 1);
      CHECK(parser.parser().bytesSkipped() == 0);
      CHECK(parser.parser().brokenFrames() == 0);
    }
  }
}

TEST_CASE("a buffer full of beginnings is looked through to its end") {
  // Each byte could begin a frame: every one is given up in turn.
  for (unsigned magic : {0xFDu, 0xFEu}) {
    for (size_t count = 1; count < 300; ++count) {
      CAPTURE(count);
      CHECK(wantedIn(Bytes(count, static_cast<uint8_t>(magic)) + request(1) + telemetry() + request(2)) ==
            "request 1, request 2");
    }
  }
}

TEST_CASE("the longest frame that is kept fills the buffer, and what waits behind it fits") {
  // A wanted header with the greatest length, a wrong checksum, and beginnings of more of them inside.
  Bytes nested;
  while (nested.size() < MAVMISSION_MAX_PAYLOAD)
    nested = nested + Bytes{0xFD, MAVMISSION_MAX_PAYLOAD, 0, 0, 0, 1, 1, 51, 0, 0};
  nested.resize(MAVMISSION_MAX_PAYLOAD);
  FrameParts parts = requestParts(0);
  parts.payload = nested;
  Bytes frame = packed(parts);
  frame.back() = static_cast<uint8_t>(~frame.back());
  CHECK(wantedIn(frame + frame + frame + request(1) + Bytes(80, 0x11)) == "request 1");
}

TEST_CASE("a rescan takes one byte a call, so that its time can be shared out") {
  ParserUnderTest fed;
  Bytes damaged = request(4);
  damaged.back() = static_cast<uint8_t>(~damaged.back());
  FrameParser parser = fed.parser();
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
        case 4: {
          FrameParts parts = requestParts(static_cast<uint16_t>(dice(600)));
          parts.incompatibility = 1;
          frame = packed(parts);
          break;
        }
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
