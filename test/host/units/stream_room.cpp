#include "mavmission/base/StreamRoom.h"

#include <doctest/doctest.h>

#include "MemoryStream.h"

using namespace mavmission::detail;

namespace {

constexpr uint8_t kBlind = 8;

struct NewRoom : StreamRoom {
  NewRoom() { memset(static_cast<void*>(this), 0, sizeof(*this)); }
};

// A stream of a core whose Print has no availableForWrite() of its own.
class WithoutRoom : public Stream {
 public:
  int available() override { return 0; }
  int peek() override { return -1; }
  int read() override { return -1; }
  size_t write(uint8_t) override { return 1; }
};

}  // namespace

TEST_CASE("a stream that says how much room it has is given that much") {
  NewRoom room;
  MemoryStream stream;
  for (int says : {63, 1, 200, 32767}) {
    stream.room = says;
    CHECK(room.of(stream, 0, kBlind) == says);
  }
}

TEST_CASE("a stream without room is given nothing for 100 ms, and from then on a few bytes a call") {
  NewRoom room;
  MemoryStream stream;
  stream.room = 0;
  for (uint16_t now = 65500; now != 64; ++now) CHECK(room.of(stream, now, kBlind) == 0);  // across the clock's wrap
  CHECK(room.of(stream, 64, kBlind) == 0);  // 100 ms: from the next call on
  for (uint16_t now = 65; now != 400; ++now) CHECK(room.of(stream, now, kBlind) == kBlind);
  CHECK(room.of(stream, 400, 1) == 1);
}

TEST_CASE("99 ms without room do not make a stream one that never says it") {
  NewRoom room;
  MemoryStream stream;
  stream.room = 0;
  room.of(stream, 1000, kBlind);
  CHECK(room.of(stream, 1099, kBlind) == 0);
  CHECK(room.of(stream, 1099, kBlind) == 0);
}

TEST_CASE("a stream whose core has no availableForWrite() is given a few bytes a call after 100 ms") {
  NewRoom room;
  WithoutRoom stream;
  CHECK(room.of(stream, 0, kBlind) == 0);
  CHECK(room.of(stream, 100, kBlind) == 0);
  CHECK(room.of(stream, 101, kBlind) == kBlind);
}

TEST_CASE("times without room are not added up: each begins anew after there was room") {
  NewRoom room;
  MemoryStream stream;
  for (uint16_t round = 0; round < 5; ++round) {
    stream.room = 0;
    for (uint16_t ms = 0; ms < 60; ++ms) CHECK(room.of(stream, static_cast<uint16_t>(round * 100 + ms), kBlind) == 0);
    stream.room = 3;
    CHECK(room.of(stream, static_cast<uint16_t>(round * 100 + 60), kBlind) == 3);
  }
}

TEST_CASE("a stream that was taken for one that never says its room is believed when it does") {
  NewRoom room;
  MemoryStream stream;
  stream.room = 0;
  room.of(stream, 0, kBlind);
  room.of(stream, 100, kBlind);
  CHECK(room.of(stream, 101, kBlind) == kBlind);
  stream.room = 2;
  CHECK(room.of(stream, 102, kBlind) == 2);
  stream.room = 0;
  CHECK(room.of(stream, 103, kBlind) == 0);  // full, and believed
}

TEST_CASE("a stream that has said its room is believed when it has none, however long") {
  NewRoom room;
  MemoryStream stream;
  CHECK(room.of(stream, 0, kBlind) > 0);
  stream.room = 0;
  for (uint16_t now = 1; now < 20000; ++now) CHECK(room.of(stream, now, kBlind) == 0);
}

TEST_CASE("only a stream that says exactly 1 is asked again after each byte") {
  MemoryStream stream;
  for (int says : {0, 1, 2, 63}) {
    stream.room = says;
    CHECK(StreamRoom::saysOne(stream) == (says == 1));
  }
}
