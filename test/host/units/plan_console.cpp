#include "mavmission/console/PlanConsole.h"

#include <doctest/doctest.h>

#include <string>

#include "ClientOnLine.h"
#include "MemoryStream.h"
#include "PlanFrames.h"

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
const char kBusy[] = "busy with another operation\r\n";
const char kFailed[] = "the last load or download failed: repeat it, or type cancel\r\n";

// A file with so many items.
std::string fileOf(int items) {
  std::string text = kHead;
  for (int n = 1; n <= items; ++n) text += std::to_string(n) + " 0 3 16 1 0 0 0 1 2 " + std::to_string(n) + " 1\n";
  return text;
}
std::string loading(int items) { return "load\n" + fileOf(items) + "end\n"; }

// A console whose plan has one item, on a client that hears a PX4.
struct Station : ClientOnLine {
  MemoryStream port;
  EepromPlan plan{Eeprom{readByte, writeByte, nullptr, 400}};
  MissionItem room[4];
  PlanConsole console{port, client, plan, room};

  Station() : ClientOnLine(kPx4) {
    memory.assign(400, 0xFF);
    plan.begin();
    console.offerAll();
    type(loading(1));
    go(3000);
  }
  void type(const std::string& text) { port.bring(std::vector<uint8_t>(text.begin(), text.end())); }
  void go(uint32_t ms) {
    for (; ms != 0; --ms) {
      run(1);
      plan.update();
      console.update();
    }
  }
  // The autopilot gives a plan of so many items that is being downloaded.
  void giveItems(uint8_t items) {
    REQUIRE(next(kRequestList) != nullptr);
    hear(countParts(items));
    while (client.isBusy()) {
      go(1);
      if (sent.empty() || sent.back().messageId != kRequestInt) continue;
      hear(itemParts(sent.back().payload[0], waypoint(1_deg, 2_deg, 20_m)));
      sent.clear();
    }
  }
  std::string said() const { return std::string(port.written.begin(), port.written.end()); }
  // The first message of the client with this id; null if it sends none in 3 s.
  const SentFrame* next(uint16_t id) {
    sent.clear();
    for (int ms = 0; ms < 3000; ++ms) {
      go(1);
      if (!sent.empty() && sent.back().messageId == id) return &sent.back();
    }
    return nullptr;
  }
};

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
  CHECK(desk.answer(loading(9), 6000).find("9\r\nstored: list prints it\r\n") != std::string::npos);
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

TEST_CASE("a command behind end or erase waits until the EEPROM is written") {
  for (const char* command : {"upload", "verify", "list", "status"}) {
    Desk desk;
    desk.answer(loading(1));
    desk.type(loading(3) + command + "\n");
    desk.port.written.clear();
    while (!desk.autopilot.isBusy() && desk.nowMs < 9000) desk.update();
    CHECK(desk.plan.count() == 3);
    CHECK(!desk.plan.isBusy());
    CHECK(desk.said().find(command[0] == 's'   ? "stored: items 3"
                           : command[0] == 'l' ? "3\t0\t3\t16"
                                               : "") < std::string::npos);
    desk.autopilot.cancel();
    CHECK(desk.answer("erase\nupload\n").find("erased\r\nno plan is stored: type load\r\n") != std::string::npos);
  }
}

TEST_CASE("an upload behind a download sends what was downloaded, whenever it is typed") {
  for (uint32_t afterMs = 0; afterMs < 60; afterMs += 3) {
    Station station;
    station.type("download\n");
    station.giveItems(3);
    station.go(afterMs);
    station.type("upload\n");
    const SentFrame* count = station.next(ClientOnLine::kCount);
    while (count == nullptr && station.nowMs() < 90000) {
      station.type("upload\n");
      count = station.next(ClientOnLine::kCount);
    }
    REQUIRE(count != nullptr);
    CHECK(count->payload[0] == 3);
    CHECK(station.plan.count() == 3);
  }
}

TEST_CASE("what is pasted behind a file that came during a download is not done with what was downloaded") {
  Station station;
  station.type("download\nload\n" + fileOf(2));
  station.giveItems(3);
  station.port.written.clear();
  station.type("end\nupload\n");
  station.go(1000);
  CHECK(station.said().find("stored: list prints it\r\nnothing was loaded\r\n" + std::string(kFailed)) !=
        std::string::npos);
  CHECK(station.plan.count() == 3);
  CHECK(!station.client.isBusy());
  for (const char* again : {"cancel\n", "download\n"}) {
    station.type(again);
    if (again[0] == 'd') station.giveItems(2);
    station.go(1000);
    station.type("upload\n");
    REQUIRE(station.next(ClientOnLine::kCount) != nullptr);
    station.type("cancel\nload\ncancel\n");
    station.go(5000);
  }
}

TEST_CASE("a plan that is downloaded and empty, or too long, does not take the place of the stored one") {
  for (uint8_t items : {0, 40}) {
    Station station;
    station.port.written.clear();
    station.type("download\n");
    station.giveItems(items);
    station.go(1000);
    CHECK(station.said().find(items == 0 ? "nothing was loaded\r\ndownloaded: "
                                         : "the plan aboard is too large for the sink\r\n") != std::string::npos);
    CHECK(station.plan.count() == 1);
  }
}

TEST_CASE("what is wrong with a file is said with its line, and the stored plan stays") {
  const std::string row1 = "1 0 3 16 0 0 0 0 1 2 3 1\n", row2 = "2 0 3 16 0 0 0 0 1 2 3 1\n";
  const struct {
    std::string file;
    const char* said;
  } kMistakes[] = {
      {"", "line 1: the first line is not QGC WPL 110\r\n"},
      {kHead, "line 3: no item after home\r\n"},
      {kHead + row2, "line 3, field 1: the lines are not numbered 0, 1, 2, ...\r\n"},
      {kHead + row1 + "2 0 3 16 0 0 0 0 95.36 2 3 1\n",
       "line 4, field 9: a latitude beyond 90 degrees\r\nnothing was loaded; further lines are ignored, up to end\r\n"},
      {kHead + row1 + "2 0 3 177 7 2 0 0 0 0 0 1\n", "line 4, field 5: a jump to home, or out of the plan\r\n"},
      {kHead + row1 + "upload\n", "line 4: not a number\r\n"},
      {fileOf(40), "more items than there is room for\r\n"},
      {"cancel\n", "nothing was loaded\r\n"},
  };
  for (const auto& one : kMistakes) {
    CAPTURE(one.said);
    Desk desk;
    desk.answer(loading(1));
    CHECK(desk.answer("load\n" + one.file + "end\n", 9000).find(one.said) != std::string::npos);
    CHECK(desk.plan.count() == 1);
    CHECK(desk.answer("cancel\nstatus\n").find("stored: items 1\r\n") != std::string::npos);
  }
  Desk empty;
  for (const char* command : {"list\n", "upload\n", "Verify\n"}) {
    CHECK(empty.answer(command) == "no plan is stored: type load\r\n");
  }
}

TEST_CASE("help names each command, and status says what the autopilot does and holds") {
  Station station;
  station.port.written.clear();
  station.type("help\n");
  station.go(2000);
  const std::string help = "\n" + station.said();
  size_t at = 0;
  for (const char* name :
       {"help", "status", "load", "end", "upload", "cancel", "erase", "list", "verify", "download", "clear", "start"}) {
    at = help.find("\n" + std::string(name) + ": ", at);
    CHECK(at != std::string::npos);
  }
  station.port.written.clear();
  station.type("status\n");
  station.go(1000);
  CHECK(station.said() == "PX4, disarmed\r\nidle\r\naboard: not known\r\nstored: items 1\r\n");
}

TEST_CASE("what is pasted behind a load that failed is not done with the plan before") {
  const std::string bad = std::string(kHead) + "1 0 3 16 x\n";
  for (const std::string& load : {"load\n" + bad + "end\n", bad + "end\n", std::string("load\nend\n")}) {
    for (const char* command : {"upload\n", "verify\n", "start\n"}) {
      Desk desk;
      desk.answer(loading(1));
      CHECK(desk.answer(load + command + command).find(std::string(kFailed) + kFailed) != std::string::npos);
      CHECK(!desk.autopilot.isBusy());
      CHECK(desk.answer("cancel\n") == "nothing was loaded\r\n");
      CHECK(desk.answer(command).empty());
      CHECK(desk.autopilot.isBusy());
    }
  }
}

TEST_CASE("a file without load, or one that comes during an operation, is refused once") {
  Desk desk;
  CHECK(desk.answer(fileOf(9) + "end\n") == "nothing is being loaded: type load first\r\nnothing was loaded\r\n");
  desk.answer(loading(1));
  desk.answer("upload\n");
  CHECK(desk.answer(loading(3) + "erase\ndownload\nstart\nclear\n") ==
        std::string(kBusy) + "nothing was loaded\r\n" + kBusy + kBusy + kBusy + kBusy);
  CHECK(desk.plan.count() == 1);
  CHECK(desk.answer("load\ncancel\n").find("cancelled by the sketch") != std::string::npos);
}

TEST_CASE("a plan is not exchanged, nor mixed with another one, while the sketch uses it") {
  Desk desk;
  desk.answer(loading(1));
  desk.answer("load\n" + fileOf(2));
  desk.autopilot.upload(desk.plan.source());
  desk.answer("end\n");
  CHECK(desk.plan.count() == 1);
  desk.autopilot.cancel();
  CHECK(desk.answer("status\n").find("stored: items 2") != std::string::npos);
  desk.answer("load\n" + fileOf(2));
  desk.plan.sink();
  CHECK(desk.answer("end\n").find("the EEPROM could not store the plan") != std::string::npos);
  CHECK(desk.plan.count() == 2);
  desk.answer("load\n" + fileOf(2));
  desk.plan.erase();
  CHECK(desk.answer("end\n").find("the EEPROM could not store the plan") != std::string::npos);
}

TEST_CASE("start does not fly the plan before one that was loaded") {
  Station station;
  station.type("upload\n");
  REQUIRE(station.next(ClientOnLine::kCount) != nullptr);
  station.hear(requestParts(0));
  const SentFrame* item = station.next(ClientOnLine::kItemInt);
  REQUIRE(item != nullptr);
  station.hear(ackParts(0));
  station.go(100);
  REQUIRE((station.client.aboard() == Aboard::OurPlan));
  station.port.written.clear();
  station.type(loading(2) + "start\nstatus\n");
  station.go(2000);
  CHECK(station.said().find("the stored plan is not aboard: type upload\r\n") != std::string::npos);
  CHECK(station.said().find("aboard: an earlier plan of ours, whole\r\n") != std::string::npos);
  CHECK(!station.client.isBusy());
}

TEST_CASE("a command is what is seen on the line when it ends, and one that is too long stays refused") {
  const char kUnknown[] = "unknown command: type help\r\n";
  Desk desk;
  for (const char* line : {"startxxxxx\b\b\b\b", "startxxxxxxxxxxxxx\b\b\b\b\b\b\b\b\b\b\b\b\b", "starts \b", "st art",
                           "helps\x7F \x7F\x7F", "\x1B[Astart"}) {
    CHECK(desk.answer(std::string(line) + "\n") == kUnknown);
    CHECK(!desk.autopilot.isBusy());
  }
  for (const char* line : {"end", " END\t ",
                           "enf\x7F"
                           "d",
                           "\bend", "ende\b\r"}) {
    CHECK(desk.answer(std::string(line) + "\n") == "nothing is being loaded: type load first\r\n");
  }
}

TEST_CASE("when the port's ring was full, no command that was on its way is done, and the console says so") {
  Desk desk;
  desk.console.setRing(63);
  const std::string many = "help\nstatus\nlist\nverify\nupload\nhelp\nstatus\nlist\nverify\nupload\nhelp\nsta";
  const std::string ignored = "too much at once: the rest was ignored\r\n";
  CHECK(desk.answer(many, 90).empty());
  CHECK(desk.answer("rt\n", 90).empty());
  CHECK(desk.answer("", 20) == ignored);
  CHECK(desk.answer("end\n", 90) == "nothing is being loaded: type load first\r\n");
  desk.type("help\n");
  for (int i = 0; i < 3; ++i) desk.update();
  CHECK(desk.answer(many).find(ignored) != std::string::npos);
  CHECK(desk.said().find("stored: items") == std::string::npos);
  desk.answer("load\nQ\n", 90);
  CHECK(desk.answer(std::string(70, '7') + "\nhelp\n") == ignored);
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
