#include "mavmission/PlanConsole.h"

#include <doctest/doctest.h>

#include <string>

#include "MemoryStream.h"

using namespace mavmission;

namespace {

std::vector<uint8_t> memory;
uint8_t readByte(uint16_t address) { return memory[address]; }
void writeByte(uint16_t address, uint8_t value) { memory[address] = value; }

// A port whose room is taken up by what is written.
class FillingStream : public MemoryStream {
 public:
  using MemoryStream::write;
  size_t write(const uint8_t* bytes, size_t size) override {
    const size_t taken = MemoryStream::write(bytes, size);
    if (room > 0 && room != kAlwaysRoom) room -= static_cast<int>(taken);
    return taken;
  }
};

// A console on a port, with an autopilot that is not there.
struct Desk {
  MemoryStream line;
  FillingStream port;
  MissionClient autopilot;
  EepromPlan plan;
  MissionItem room[4];
  PlanConsole console;
  uint32_t nowMs;

  Desk()
      : autopilot(line),
        plan(Eeprom{readByte, writeByte, nullptr, 400}),
        console(port, autopilot, plan, room),
        nowMs(0) {
    memory.assign(400, 0xFF);
    plan.begin();
    console.offerAll();
  }

  void type(const std::string& text) { port.bring(std::vector<uint8_t>(text.begin(), text.end())); }
  void update() {
    setMillis(++nowMs);
    autopilot.update();
    plan.update();
    console.update();
  }
  std::string said() const { return std::string(port.written.begin(), port.written.end()); }
  std::string answer(const std::string& text, int updates = 3000) {
    port.written.clear();
    type(text);
    for (int i = 0; i < updates; ++i) update();
    return said();
  }
};

const size_t kMost = PlanConsole::kBytesPerUpdate;
const char kHead[] = "QGC WPL 110\n0 1 0 16 0 0 0 0 0 0 0 1\n";

}  // namespace

TEST_CASE("it never writes more than the port takes") {
  Desk desk;
  desk.port.room = 0;
  desk.type("help\nstatus\n");
  for (int i = 0; i < 90; ++i) desk.update();
  CHECK(desk.said().empty());
  std::string whole;
  for (int room = 1; whole.find("stored: items 0\r\n") == std::string::npos; room = room % 70 + 1) {
    REQUIRE(whole.size() < 5000);
    desk.port.room = room;
    const size_t before = desk.port.written.size();
    desk.update();
    const size_t wrote = desk.port.written.size() - before;
    CHECK(wrote <= static_cast<size_t>(room));
    CHECK(wrote <= kMost);
    whole = desk.said();
  }
  Desk freely;
  CHECK(freely.answer("help\nstatus\n") == whole);
}

TEST_CASE("on a port that does not say what it takes it writes a byte each time, after a while") {
  Desk desk;
  desk.port.room = 0;
  const std::string slowly = desk.answer("status\n");
  Desk freely;
  CHECK(freely.answer("status\n") == slowly);
  CHECK(desk.port.largestWrite == 1);
}

TEST_CASE("an item for which there is no room yet is not lost: what comes behind it waits in the port") {
  Desk desk;
  std::string text = std::string("load\n") + kHead;
  for (int n = 1; n <= 9; ++n) text += std::to_string(n) + " 0 3 16 1 0 0 0 1 2 " + std::to_string(n) + " 1\n";
  CHECK(desk.answer(text + "end\n", 6000).find("9\r\nstored: list prints it\r\n") != std::string::npos);
  REQUIRE(desk.plan.count() == 9);
  const ItemSource source = desk.plan.source();
  for (uint16_t i = 0; i < 9; ++i) {
    MissionItem item;
    REQUIRE(source.read(source.context, i, item));
    CHECK(item.z == static_cast<float>(i + 1));
  }
}

TEST_CASE("a text is refused when the port's ring was full in its midst, and only then") {
  Desk desk;
  desk.console.setRing(63);
  std::string row = "1 0 3 16 0 0 0 0 1 2 3 1\n";
  CHECK(desk.answer("load\n").find("send the file") != std::string::npos);
  desk.answer(std::string(kHead).substr(0, 12));
  desk.answer(std::string(kHead).substr(12));
  CHECK(desk.answer(row + "end\n").find("stored: ") != std::string::npos);
  desk.answer("load\n");
  CHECK(desk.answer(std::string(kHead) + row + "end\n").find("line 1: too fast") == 0);
  CHECK(desk.plan.count() == 1);
}

TEST_CASE("an EEPROM that does not keep what it is given is told, and the console goes on") {
  Desk desk;
  const Eeprom deaf{readByte, [](uint16_t, uint8_t) {}, nullptr, 400};
  EepromPlan broken(deaf);
  broken.begin();
  PlanConsole console(desk.port, desk.autopilot, broken);
  desk.type(std::string("load\n") + kHead + "1 0 3 16 0 0 0 0 1 2 3 1\nend\nstatus\n");
  for (int i = 0; i < 3000; ++i) {
    setMillis(++desk.nowMs);
    broken.update();
    console.update();
  }
  CHECK(desk.said().find(": the EEPROM could not store the plan\r\n") != std::string::npos);
  CHECK(desk.said().find("stored: items 0\r\n") != std::string::npos);
}

TEST_CASE("whatever is typed, it goes on") {
  Desk desk;
  uint32_t seed = 5;
  for (int round = 0; round < 300; ++round) {
    std::string text = round % 3 == 0 ? std::string("load\n") + (round % 2 ? kHead : "") : "";
    for (int i = 0; i < 60; ++i) {
      seed = seed * 1664525 + 1013904223;
      const char common[] = "0123456789.-+eE\t \r\nnaQGC#\x7F\bload";
      const uint32_t pick = seed >> 16;
      text += pick % 8 == 0 ? static_cast<char>(pick >> 4) : common[pick % (sizeof(common) - 1)];
    }
    desk.answer(text, 100);
  }
  desk.answer("\ncancel\nend\n");
  CHECK(desk.answer("help\n").find("help: list the commands\r\n") != std::string::npos);
}
