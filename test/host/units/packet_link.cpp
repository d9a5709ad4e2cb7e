#include "mavmission/link/PacketLink.h"

#include <doctest/doctest.h>

#include "Frames.h"

using namespace mavmission;

namespace {

// A radio that keeps its packets, and is busy or deaf as the test says.
template <uint16_t kSize>
class Radio : public PacketLink {
 public:
  Radio() : PacketLink(buffer_, kSize) {}
  std::vector<Bytes> packets;
  bool isBusy = false, refuses = false;

  int available() override { return 0; }
  int peek() override { return -1; }
  int read() override { return -1; }

 private:
  bool sendPacket(const uint8_t* bytes, uint16_t size) override {
    if (refuses) return false;
    packets.push_back(Bytes(bytes, bytes + size));
    return true;
  }
  bool isFree() override { return !isBusy; }

  uint8_t buffer_[kSize];
};

typedef std::vector<Bytes> Packets;

size_t put(Print& radio, const Bytes& bytes) { return radio.write(bytes.data(), bytes.size()); }

Bytes requestOf(uint8_t version, uint8_t incompatibility) {
  FrameParts parts = requestParts(7);
  parts.version = version;
  parts.incompatibility = incompatibility;
  return packed(parts);
}

}  // namespace

TEST_CASE("each frame leaves as a packet with its last byte, however it is written") {
  for (const Bytes& frame : {heartbeat(), request(7), requestOf(1, 0), requestOf(2, 1), telemetry(255)}) {
    Radio<280> radio;
    for (size_t i = 0; i < frame.size(); ++i) {
      CHECK(radio.packets.empty());
      CHECK(radio.availableForWrite() == static_cast<int>(280 - i));
      CHECK(radio.write(frame[i]) == 1);
    }
    CHECK(radio.packets == Packets{frame});
    CHECK(radio.availableForWrite() == 280);
    CHECK(put(radio, frame + frame) == 2 * frame.size());
    CHECK(radio.packets == Packets(3, frame));
    CHECK(radio.packetsSent() == 3);
    CHECK(radio.unsent() == 0);
  }
}

TEST_CASE("what stands between frames is left out, and a frame that holds such bytes is not") {
  Radio<280> radio;
  const Bytes zeros(12, 0), text = {'A', 'T', '\r', '\n'}, frame = telemetry(28, 0);
  CHECK(put(radio, zeros + frame + text + zeros + request(1)) == 12 + frame.size() + 16 + request(1).size());
  CHECK(radio.packets == Packets{frame, request(1)});
}

TEST_CASE("frames gather while the radio is busy, as many as a packet takes, and none is split") {
  Radio<50> radio;
  radio.isBusy = true;
  const Bytes frame = request(1);  // 17 bytes
  CHECK(put(radio, frame + frame) == 2 * frame.size());
  CHECK(radio.availableForWrite() == static_cast<int>(50 - 2 * frame.size()));
  CHECK(put(radio, frame) == 50 - 2 * frame.size());  // there is no room for its end
  CHECK(radio.availableForWrite() == 0);
  CHECK(radio.packets.empty());
  radio.isBusy = false;
  CHECK(radio.availableForWrite() == static_cast<int>(2 * frame.size()));
  CHECK(radio.packets == Packets{frame + frame});
  CHECK(put(radio, Bytes(frame.end() - 1, frame.end())) == 1);
  CHECK(radio.packets == Packets{frame + frame, frame});
}

TEST_CASE("a frame that waited leaves with flush(), and flush() does not wait for a busy radio") {
  Radio<50> radio;
  radio.isBusy = true;
  put(radio, request(1));
  radio.flush();
  CHECK(radio.packets.empty());
  radio.isBusy = false;
  radio.flush();
  radio.flush();
  CHECK(radio.packets == Packets{request(1)});
}

TEST_CASE("a frame that just fits a packet leaves, and one that is longer is left out, alone and whole") {
  Radio<40> radio;
  const Bytes fits = telemetry(28), longer = telemetry(29), next = request(2);
  REQUIRE(fits.size() == 40);
  // The flag of a signed frame that was there before makes it no longer.
  const Bytes before = requestOf(2, 1);
  CHECK(put(radio, before + fits) == before.size() + 40);
  CHECK(put(radio, longer + next) == longer.size() + next.size());
  CHECK(radio.packets == Packets{before, fits, next});
  CHECK(radio.unsent() == 1);
}

TEST_CASE("a frame that is longer than a packet is left out after one that waits, too") {
  Radio<40> radio;
  radio.isBusy = true;
  CHECK(put(radio, request(1) + telemetry(60) + request(2)) == 2 * request(1).size() + telemetry(60).size());
  radio.isBusy = false;
  radio.flush();
  CHECK(radio.packets == Packets{request(1) + request(2)});
}

TEST_CASE("a packet that the radio does not take is lost, and the next one is not") {
  Radio<280> radio;
  radio.refuses = true;
  CHECK(put(radio, request(1)) == request(1).size());
  radio.refuses = false;
  CHECK(put(radio, request(2)) == request(2).size());
  CHECK(radio.packets == Packets{request(2)});
  CHECK(radio.unsent() == 1);
  CHECK(radio.packetsSent() == 1);
}

TEST_CASE("a full buffer is sent by write() itself, once the radio is free, and what has begun moves to its front") {
  Radio<50> radio;
  radio.isBusy = true;
  const Bytes last = heartbeat(), begun(last.begin(), last.begin() + 16);
  CHECK(put(radio, request(1) + request(2) + begun) == 50);
  CHECK(put(radio, Bytes(1, 0x77)) == 0);
  radio.isBusy = false;
  CHECK(put(radio, Bytes(last.begin() + 16, last.end())) == last.size() - 16);
  CHECK(radio.packets == Packets{request(1) + request(2), last});
}

TEST_CASE("a frame that is longer than a packet is passed over by its length, whatever it holds") {
  Radio<40> radio;
  CHECK(put(radio, telemetry(60, 0xFD) + request(2)) == telemetry(60).size() + request(2).size());
  CHECK(radio.packets == Packets{request(2)});
  CHECK(radio.unsent() == 1);
}
