// Ports that take and say what those of other boards do: nothing is written for which they have no room, nothing that
// comes is lost when update() is called each millisecond, and what is sent leaves as fast as the line lets it.
#include <doctest/doctest.h>

#include <deque>
#include <string>

#include "mavmission/client/MissionClient.h"
#include "mavmission/console/PlanConsole.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

// What availableForWrite() says.
enum class Says { Room, OneOrNothing, Nothing };

struct Kind {
  const char* board;
  Says says;
  size_t toSend;    // bytes that write() takes without waiting
  size_t received;  // bytes that wait to be read; what comes then is lost
};

// By the cores' sources; docs/design/parts.md, "Other boards".
const Kind kKinds[] = {
    {"Uno R4", Says::Nothing, 512, 512},      {"Pico", Says::OneOrNothing, 32, 31}, {"ESP32", Says::Room, 128, 256},
    {"Teensy 4", Says::Room, 63, 63},         {"Nano Every", Says::Room, 63, 63},   {"a Mega", Says::Room, 63, 63},
    {"SoftwareSerial", Says::Nothing, 0, 63},
};

// A port between two queues, whose line takes `baud` / 10 bytes a second.
class BoardPort : public Stream {
 public:
  explicit BoardPort(const Kind& kind) : kind_(kind) {}

  size_t sent = 0;    // bytes that the line has taken
  size_t waited = 0;  // bytes that write() would have waited with
  size_t lost = 0;    // bytes that came when there was no room
  uint32_t baud = 57600;

  void pass(uint32_t us) {
    credit_ += uint64_t{baud} * us;
    while (credit_ >= 10000000 && toSend_ != 0) {
      credit_ -= 10000000;
      --toSend_;
      ++sent;
    }
    if (toSend_ == 0 && credit_ > 10000000) credit_ = 10000000;
  }
  void come(uint8_t byte) {
    if (received_.size() < kind_.received) {
      received_.push_back(byte);
    } else {
      ++lost;
    }
  }

  int available() override { return static_cast<int>(received_.size()); }
  int peek() override { return received_.empty() ? -1 : received_.front(); }
  int read() override {
    if (received_.empty()) return -1;
    const uint8_t byte = received_.front();
    received_.pop_front();
    return byte;
  }
  int availableForWrite() override {
    const size_t room = kind_.toSend - toSend_;
    return kind_.says == Says::Nothing ? 0 : static_cast<int>(kind_.says == Says::Room || room == 0 ? room : 1);
  }
  size_t write(uint8_t) override {
    if (toSend_ >= kind_.toSend) ++waited;
    while (toSend_ != 0 && toSend_ >= kind_.toSend) pass(10);
    ++toSend_;
    if (kind_.toSend == 0) {  // it sends it itself, bit by bit
      toSend_ = 0;
      ++sent;
    }
    return 1;
  }
  using Print::write;

 private:
  const Kind& kind_;
  size_t toSend_ = 0;
  uint64_t credit_ = 0;
  std::deque<uint8_t> received_;
};

// A client that sends one long message, update() each millisecond; how long that takes [ms].
uint32_t msToSend(BoardPort& port, uint8_t length) {
  uint8_t payload[255];
  memset(payload, 0x55, sizeof(payload));
  uint32_t nowMs = 1000;
  setMillis(nowMs);
  MissionClient client(port);
  client.setSourceIds(1, 191);
  for (int i = 0; i < 500; ++i) {  // a heartbeat, after which it is known what the port says
    port.pass(1000);
    setMillis(++nowMs);
    client.update();
  }
  const size_t before = port.sent;
  CHECK(before == 21);
  CHECK(client.sendMessage(OutgoingMessage{300, 0, length, length, payload}));
  const uint32_t begunMs = nowMs;
  while (port.sent < before + 12 + length && nowMs < begunMs + 400) {
    client.update();
    port.pass(1000);
    setMillis(++nowMs);
  }
  CHECK(port.sent == before + 12 + length);
  return nowMs - begunMs;
}

}  // namespace

TEST_CASE("no port is made to wait, but one that has no room at all") {
  for (const Kind& kind : kKinds) {
    CAPTURE(kind.board);
    BoardPort port(kind);
    msToSend(port, 255);
    if (kind.toSend != 0) CHECK(port.waited == 0);
  }
}

TEST_CASE("what is sent takes as long as the line takes for it, at all rates up to 1,000,000 baud") {
  for (const Kind& kind : kKinds) {
    for (uint32_t baud : {57600u, 115200u, 500000u, 921600u, 1000000u}) {
      CAPTURE(kind.board);
      CAPTURE(baud);
      BoardPort port(kind);
      port.baud = baud;
      // At a call each millisecond a port with room for 32 bytes gets so many in each, a blind one 8.
      const uint32_t line = 267 * 10000 / baud + 1;
      const uint32_t calls = kind.says == Says::Nothing ? 267 / Outbox::kBlindBytes + 1 : 267 / 31 + 1;
      CHECK(msToSend(port, 255) <= (line > calls ? line : calls) + 4);
    }
  }
}

TEST_CASE("a line full of telemetry is read without losing a byte, at update() each millisecond") {
  for (const Kind& kind : kKinds) {
    // A Pico's ring is too short for more, until setFIFOSize() makes it longer; a Mega takes 115200.
    for (uint32_t baud : {57600u, 115200u, 230400u, 921600u}) {
      if (baud / 10 / 1000 >= kind.received) continue;
      CAPTURE(kind.board);
      CAPTURE(baud);
      BoardPort port(kind);
      uint32_t nowMs = 1;
      setMillis(nowMs);
      MissionClient client(port);
      const uint32_t bytesAMs = baud / 10000;
      for (int i = 0; i < 1000; ++i) {
        for (uint32_t n = 0; n < bytesAMs; ++n) port.come(static_cast<uint8_t>(i * 31 + n));
        setMillis(++nowMs);
        client.update();
        if (bytesAMs > 60) client.update();  // 64 bytes are looked at in each
      }
      CHECK(port.lost == 0);
    }
  }
}

TEST_CASE("a port that has said how much room it has is believed when it has none, for ever") {
  const Kind kind = {"a port with flow control", Says::Room, 63, 63};
  BoardPort port(kind);
  port.baud = 0;  // nobody takes anything
  setMillis(1);
  MissionClient client(port);
  client.setSourceIds(1, 191);
  for (uint32_t nowMs = 2; nowMs < 30000; ++nowMs) {
    setMillis(nowMs);
    client.update();
  }
  CHECK(port.waited == 0);
}

TEST_CASE("a console on a USB port to which nobody listens waits, and does not write") {
  static uint8_t memory[200];
  const Eeprom eeprom = {[](uint16_t address) { return memory[address]; },
                         [](uint16_t address, uint8_t value) { memory[address] = value; }, nullptr, sizeof(memory)};
  const Kind kind = {"USB", Says::Room, 64, 64};
  BoardPort port(kind), line(kind);
  port.baud = 0;
  MissionClient autopilot(line);
  EepromPlan plan(eeprom);
  PlanConsole console(port, autopilot, plan);
  plan.begin();
  for (char c : std::string("help\n")) port.come(static_cast<uint8_t>(c));
  for (uint32_t nowMs = 1; nowMs < 5000; ++nowMs) {
    setMillis(nowMs);
    console.update();
  }
  CHECK(port.waited == 0);
  CHECK(port.sent == 0);
  port.baud = 1000000;  // somebody does
  for (uint32_t nowMs = 5000; nowMs < 6000; ++nowMs) {
    setMillis(nowMs);
    console.update();
    port.pass(1000);
  }
  CHECK(port.sent > 40);
}

TEST_CASE("a console gives a port as many bytes in a call as it takes without waiting, also one that says 1") {
  static uint8_t memory[200];
  const Eeprom eeprom = {[](uint16_t address) { return memory[address]; },
                         [](uint16_t address, uint8_t value) { memory[address] = value; }, nullptr, sizeof(memory)};
  for (const Kind& kind : kKinds) {
    if (kind.says == Says::Nothing) continue;
    CAPTURE(kind.board);
    BoardPort port(kind), line(kKinds[0]);
    MissionClient autopilot(line);
    EepromPlan plan(eeprom);
    PlanConsole console(port, autopilot, plan);
    plan.begin();
    for (char c : std::string("help\n")) port.come(static_cast<uint8_t>(c));
    size_t most = 0;
    for (uint32_t nowMs = 1; nowMs < 200; ++nowMs) {
      setMillis(nowMs);
      console.update();
      size_t taken = port.sent;
      port.pass(1000000);  // the line takes all that is there
      taken = port.sent - taken;
      if (taken > most) most = taken;
    }
    CHECK(port.waited == 0);
    CHECK(most == +PlanConsole::kBytesPerUpdate);
  }
}
