#include "mavmission/link/Outbox.h"

#include <doctest/doctest.h>

#include "Frames.h"
#include "MemoryStream.h"
#include "mavmission/link/Messages.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

struct EmptyOutbox : Outbox {
  EmptyOutbox() { memset(static_cast<void*>(this), 0, sizeof(*this)); }
};

// What the outbox makes of a message.
template <typename T>
Bytes sent(const T& message, uint8_t version, uint8_t sequence, uint8_t systemId, uint8_t componentId) {
  EmptyOutbox outbox;
  MemoryStream stream;
  outbox.begin(version == 1, sequence, systemId, componentId);
  outbox.complete(&kKeys[static_cast<uint8_t>(MessageOf<T>::kKey)], reinterpret_cast<const uint8_t*>(&message));
  outbox.release();
  outbox.flush(stream, 0, 255);
  CHECK(outbox.isEmpty());
  return stream.written;
}

// What MAVLink's headers make of it.
template <typename T>
using Encode = uint16_t (*)(uint8_t, uint8_t, mavlink_status_t*, mavlink_message_t*, const T*);
template <typename T>
Bytes stock(Encode<T> encode, const T& message, uint8_t version, uint8_t sequence, uint8_t systemId,
            uint8_t componentId) {
  mavlink_status_t status = mavlink_status_t();
  status.current_tx_seq = sequence;
  if (version == 1) status.flags = MAVLINK_STATUS_FLAG_OUT_MAVLINK1;
  mavlink_message_t frame;
  encode(systemId, componentId, &status, &frame, &message);
  uint8_t bytes[MAVLINK_MAX_PACKET_LEN];
  return Bytes(bytes, bytes + mavlink_msg_to_send_buffer(bytes, &frame));
}

// One field is not the caller's: MAVLink's headers write it themselves.
template <typename T>
void settle(T&) {}
void settle(mavlink_heartbeat_t& message) { message.mavlink_version = 3; }

template <typename T>
void compare(Encode<T> encode, const char* name) {
  uint32_t seed = 12345;
  CAPTURE(name);
  for (int round = 0; round < 400; ++round) {
    T message;
    uint8_t* bytes = reinterpret_cast<uint8_t*>(&message);
    for (size_t i = 0; i < sizeof(T); ++i) {
      seed = seed * 1664525 + 1013904223;
      bytes[i] = static_cast<uint8_t>(seed >> 24);
    }
    // Zeros at the end, down to a message of nothing else.
    const size_t kept = static_cast<size_t>(round) % (sizeof(T) + 1);
    if (round % 2) memset(bytes + kept, 0, sizeof(T) - kept);
    settle(message);
    const uint8_t sequence = static_cast<uint8_t>(seed >> 16), system = static_cast<uint8_t>(1 + round % 255);
    for (uint8_t version = 1; version <= 2; ++version) {
      CAPTURE(version);
      CAPTURE(round);
      CHECK(sent(message, version, sequence, system, 191) == stock(encode, message, version, sequence, system, 191));
    }
  }
}

Outbox& holding(EmptyOutbox& outbox) {
  mavlink_mission_count_t count = mavlink_mission_count_t();
  count.count = 3;
  outbox.begin(false, 0, 1, 191);
  outbox.complete(&kKeys[static_cast<uint8_t>(KeyIndex::MISSION_COUNT)], reinterpret_cast<const uint8_t*>(&count));
  outbox.release();
  return outbox;
}

Bytes whole() {
  EmptyOutbox outbox;
  MemoryStream stream;
  holding(outbox).flush(stream, 0, 255);
  return stream.written;
}

}  // namespace

TEST_CASE("every message goes out byte for byte as MAVLink's own headers pack it, in both versions") {
  compare<mavlink_heartbeat_t>(mavlink_msg_heartbeat_encode_status, "HEARTBEAT");
  compare<mavlink_mission_count_t>(mavlink_msg_mission_count_encode_status, "MISSION_COUNT");
  compare<mavlink_mission_item_int_t>(mavlink_msg_mission_item_int_encode_status, "MISSION_ITEM_INT");
  compare<mavlink_mission_item_t>(mavlink_msg_mission_item_encode_status, "MISSION_ITEM");
  compare<mavlink_mission_ack_t>(mavlink_msg_mission_ack_encode_status, "MISSION_ACK");
}

TEST_CASE("a stream with room takes a frame in one piece") {
  EmptyOutbox outbox;
  MemoryStream stream;
  CHECK(outbox.isEmpty());
  holding(outbox);
  CHECK_FALSE(outbox.isEmpty());
  outbox.flush(stream, 0, 255);
  CHECK(outbox.isEmpty());
  CHECK(stream.writes == 1);
}

TEST_CASE(
    "a frame that is held goes out when it is released, and not at all when another one is begun or it is dropped") {
  const Bytes expected = whole();
  for (const char* fate : {"released", "dropped", "another"}) {
    CAPTURE(fate);
    EmptyOutbox outbox;
    MemoryStream stream;
    mavlink_mission_count_t count = mavlink_mission_count_t();
    count.count = 3;
    outbox.begin(false, 0, 1, 191);
    outbox.complete(&kKeys[static_cast<uint8_t>(KeyIndex::MISSION_COUNT)], reinterpret_cast<const uint8_t*>(&count));
    CHECK(outbox.isHeld());
    CHECK(outbox.isEmpty());
    if (fate[0] == 'd') {
      outbox.drop();
      CHECK_FALSE(outbox.isHeld());
      continue;
    }
    if (fate[0] == 'a') holding(outbox);
    if (fate[0] == 'r') outbox.release();
    CHECK_FALSE(outbox.isHeld());
    outbox.flush(stream, 0, 255);
    CHECK(stream.written == expected);
  }
}

TEST_CASE("a stream is given no more than it says it takes, and the frame arrives whole") {
  for (int room = 1; room < 70; ++room) {
    EmptyOutbox outbox;
    MemoryStream stream;
    stream.room = room;
    holding(outbox);
    for (uint16_t now = 0; now < 100 && !outbox.isEmpty(); ++now) outbox.flush(stream, now, 255);
    CHECK(outbox.isEmpty());
    CHECK(stream.largestWrite <= static_cast<size_t>(room));
    CHECK(stream.written == whole());
  }
}

TEST_CASE("a stream that takes less than it said gets the rest later, each byte once") {
  for (size_t takes = 1; takes < 20; ++takes) {
    EmptyOutbox outbox;
    MemoryStream stream;
    stream.takes = takes;
    holding(outbox);
    for (uint16_t now = 0; now < 100 && !outbox.isEmpty(); ++now) outbox.flush(stream, now, 255);
    CHECK(stream.written == whole());
  }
}

TEST_CASE("a ring that is full for less than 100 ms is waited for, not written to") {
  EmptyOutbox outbox;
  MemoryStream stream;
  stream.room = 0;
  holding(outbox);
  for (uint16_t now = 65500; now != 63; ++now) {  // across the wrap of the clock
    outbox.flush(stream, now, 255);
    CHECK(stream.writes == 0);
  }
  stream.room = 63;
  outbox.flush(stream, 63, 255);
  CHECK(stream.written == whole());
}

TEST_CASE("a stream that always says 0 is given a few bytes a call after 100 ms") {
  EmptyOutbox outbox;
  MemoryStream stream;
  stream.room = 0;
  holding(outbox);
  outbox.flush(stream, 1000, 255);
  outbox.flush(stream, 1099, 255);
  CHECK(stream.writes == 0);
  for (uint16_t now = 1100; now < 1200 && !outbox.isEmpty(); ++now) outbox.flush(stream, now, 255);
  CHECK(outbox.isEmpty());
  CHECK(stream.written == whole());
  CHECK(stream.largestWrite <= +Outbox::kBlindBytes);

  // The next frame need not wait again...
  stream.takeWritten();
  holding(outbox);
  outbox.flush(stream, 5000, 255);
  CHECK(stream.written.size() == +Outbox::kBlindBytes);
  // ... and a stream that says after all what it takes is believed.
  stream.room = 1;
  stream.largestWrite = 0;
  while (!outbox.isEmpty()) outbox.flush(stream, 5001, 255);
  CHECK(stream.largestWrite == 1);
  CHECK(stream.written == whole());
}

TEST_CASE("a ring that fills up twice for a while each time is never written to blindly") {
  EmptyOutbox outbox;
  MemoryStream stream;
  holding(outbox);
  stream.room = 0;
  outbox.flush(stream, 0, 255);
  outbox.flush(stream, 90, 255);
  stream.room = 5;
  outbox.flush(stream, 95, 255);
  stream.room = 0;
  outbox.flush(stream, 100, 255);
  outbox.flush(stream, 190, 255);
  CHECK(stream.written.size() == 5);
}

TEST_CASE("a frame on a lossy link goes out after zeros, however little room there is at a time") {
  mavlink_mission_count_t message = mavlink_mission_count_t();
  message.count = 5;
  const Bytes frame = sent(message, 2, 7, 1, 191);
  for (int room : {1, 5, 11, 12, 13, 63}) {
    CAPTURE(room);
    EmptyOutbox outbox;
    MemoryStream stream;
    stream.room = room;
    outbox.begin(false, 7, 1, 191);
    outbox.complete(&kKeys[static_cast<uint8_t>(MessageOf<mavlink_mission_count_t>::kKey)],
                    reinterpret_cast<const uint8_t*>(&message));
    outbox.release(true);
    for (int calls = 0; calls < 100 && !outbox.isEmpty(); ++calls) {
      const size_t before = stream.written.size();
      stream.room = room;
      outbox.flush(stream, 0, 255);
      CHECK(stream.written.size() - before <= static_cast<size_t>(room));
    }
    CHECK(stream.written == Bytes(Outbox::kFill, 0) + frame);
  }
}
