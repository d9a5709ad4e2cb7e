// A PlanConsole on a port: what is typed, what it says to that, and what the autopilot is told.
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

const size_t kMost = PlanConsole::kBytesPerUpdate;
const std::string kHead = "QGC WPL 110\n0 1 0 16 0 0 0 0 0 0 0 1\n";
const std::string kBusy = "busy with another operation\r\n";
const std::string kFailed = "the last load or download failed: repeat it, or type cancel\r\n";
const std::string kIgnored = "too much at once: the rest was ignored\r\n";

// A file with so many items.
std::string fileOf(int items) {
  std::string text = kHead;
  for (int n = 1; n <= items; ++n) text += std::to_string(n) + " 0 3 16 1 0 0 0 1 2 " + std::to_string(n) + " 1\n";
  return text;
}
std::string loading(int items) { return "load\n" + fileOf(items) + "end\n"; }

bool has(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

// A console on a port, with a plan of so many items; a PX4 is heard or none.
struct Desk : ClientOnLine {
  FillingStream port;
  EepromPlan plan{Eeprom{readByte, writeByte, nullptr, 400}};
  MissionItem room[4];
  PlanConsole console{port, client, plan, room};

  explicit Desk(int items = 0, bool isHeard = false) : ClientOnLine(kPx4, 0) {
    beats = isHeard;
    memory.assign(400, 0xFF);
    plan.begin();
    console.offerAll();
    if (items != 0) answer(loading(items));
  }

  void type(const std::string& text) { port.bring(std::vector<uint8_t>(text.begin(), text.end())); }
  void go(uint32_t ms) {
    for (; ms != 0; --ms) {
      run(1);
      plan.update();
      console.update();
    }
  }
  std::string said() const { return std::string(port.written.begin(), port.written.end()); }
  std::string answer(const std::string& text, uint32_t ms = 3000) {
    port.written.clear();
    type(text);
    go(ms);
    return said();
  }
  // The first message of the client with this id; null if it sends none in 3 s.
  const SentFrame* next(uint16_t id) {
    sent.clear();
    for (int ms = 0; ms < 3000; ++ms) {
      go(1);
      if (!sent.empty() && sent.back().messageId == id) return &sent.back();
    }
    return nullptr;
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
};

}  // namespace

TEST_CASE("it never writes more than the port takes, and a byte each time, after a while, if that does not say so") {
  Desk desk, slow;
  desk.port.room = slow.port.room = 0;
  CHECK(desk.answer("help\nstatus\n", 90).empty());
  std::string whole;
  for (int room = 1; !has(whole, "stored: items 0\r\n"); room = room % 70 + 1) {
    REQUIRE(whole.size() < 5000);
    desk.port.room = room;
    desk.go(1);
    const size_t wrote = desk.said().size() - whole.size();
    CHECK(wrote <= static_cast<size_t>(room));
    CHECK(wrote <= kMost);
    whole = desk.said();
  }
  CHECK(Desk().answer("help\nstatus\n") == whole);
  CHECK(slow.answer("status\n") == Desk().answer("status\n"));
  CHECK(slow.port.largestWrite == 1);
}

TEST_CASE("an item for which there is no room yet is not lost: what comes after it waits in the port") {
  Desk desk;
  CHECK(has(desk.answer(loading(9), 6000), "9\r\nstored: list prints it\r\n"));
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
  const std::string row = "1 0 3 16 0 0 0 0 1 2 3 1\n";
  CHECK(has(desk.answer("load\n"), "send the file"));
  desk.answer(kHead.substr(0, 12));
  desk.answer(kHead.substr(12));
  CHECK(has(desk.answer(row + "end\n"), "stored: "));
  desk.answer("load\n");
  CHECK(desk.answer(kHead + row + "end\n").find("line 1: too fast") == 0);
  CHECK(desk.plan.count() == 1);
}

TEST_CASE("a command after end or erase waits until the EEPROM is written") {
  const struct {
    const char *command, *said;
  } kCases[] = {{"upload", ""}, {"verify", ""}, {"list", "3\t0\t3\t16"}, {"status", "stored: items 3"}};
  for (const auto& one : kCases) {
    Desk desk(1);
    desk.port.written.clear();
    desk.type(loading(3) + one.command + "\n");
    for (int ms = 0; ms < 6000 && !desk.client.isBusy(); ++ms) desk.go(1);
    CHECK(desk.plan.count() == 3);
    CHECK(!desk.plan.isBusy());
    CHECK(has(desk.said(), one.said));
    desk.client.cancel();
    CHECK(has(desk.answer("erase\nupload\n"), "erased\r\nno plan is stored: type load\r\n"));
  }
}

TEST_CASE("an upload after a download sends what was downloaded, whenever it is typed") {
  for (uint32_t afterMs = 0; afterMs < 60; afterMs += 3) {
    Desk desk(1, true);
    desk.type("download\n");
    desk.giveItems(3);
    desk.go(afterMs);
    const SentFrame* count = nullptr;
    for (int times = 0; times < 30 && count == nullptr; ++times) {
      desk.type("upload\n");
      count = desk.next(ClientOnLine::kCount);
    }
    REQUIRE(count != nullptr);
    CHECK(count->payload[0] == 3);
    CHECK(desk.plan.count() == 3);
  }
}

TEST_CASE("what is pasted after a file that came during a download is not done with what was downloaded") {
  Desk desk(1, true);
  desk.type("download\nload\n" + fileOf(2));
  desk.giveItems(3);
  CHECK(has(desk.answer("end\nupload\n", 1000), "stored: list prints it\r\nnothing was loaded\r\n" + kFailed));
  CHECK(desk.plan.count() == 3);
  CHECK(!desk.client.isBusy());
  for (bool isDownload : {false, true}) {
    desk.type(isDownload ? "download\n" : "cancel\n");
    if (isDownload) desk.giveItems(2);
    desk.go(1000);
    desk.type("upload\n");
    REQUIRE(desk.next(ClientOnLine::kCount) != nullptr);
    desk.answer("cancel\nload\ncancel\n", 5000);
  }
}

TEST_CASE("a plan that is downloaded and empty, or too long, does not take the place of the stored one") {
  for (uint8_t items : {0, 40}) {
    Desk desk(1, true);
    desk.type("download\n");
    desk.giveItems(items);
    desk.go(1000);
    CHECK(has(desk.said(),
              items == 0 ? "nothing was loaded\r\ndownloaded: " : "the plan aboard is too large for the sink\r\n"));
    CHECK(desk.plan.count() == 1);
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
    Desk desk(1);
    CHECK(has(desk.answer("load\n" + one.file + "end\n", 9000), one.said));
    CHECK(desk.plan.count() == 1);
    CHECK(has(desk.answer("cancel\nstatus\n"), "stored: items 1\r\n"));
  }
  Desk empty;
  for (const char* command : {"list\n", "upload\n", "Verify\n"}) {
    CHECK(empty.answer(command) == "no plan is stored: type load\r\n");
  }
}

TEST_CASE("help names each command, and status says what the autopilot does and holds") {
  Desk desk(1, true);
  const std::string help = "\n" + desk.answer("help\n");
  size_t at = 0;
  for (const char* name :
       {"help", "status", "load", "end", "upload", "cancel", "erase", "list", "verify", "download", "clear", "start"}) {
    at = help.find("\n" + std::string(name) + ": ", at);
    CHECK(at != std::string::npos);
  }
  CHECK(desk.answer("status\n") == "PX4, disarmed\r\nidle\r\naboard: not known\r\nstored: items 1\r\n");
}

TEST_CASE("what is pasted after a load that failed is not done with the plan before") {
  const std::string bad = kHead + "1 0 3 16 x\n";
  for (const std::string& load : {"load\n" + bad + "end\n", bad + "end\n", std::string("load\nend\n")}) {
    for (const char* command : {"upload\n", "verify\n", "start\n"}) {
      Desk desk(1);
      CHECK(has(desk.answer(load + command + command), kFailed + kFailed));
      CHECK(!desk.client.isBusy());
      CHECK(desk.answer("cancel\n") == "nothing was loaded\r\n");
      CHECK(desk.answer(command).empty());
      CHECK(desk.client.isBusy());
    }
  }
}

TEST_CASE("a file without load, or one that comes during an operation, is refused once") {
  CHECK(Desk().answer(fileOf(9) + "end\n") == "nothing is being loaded: type load first\r\nnothing was loaded\r\n");
  Desk desk(1);
  desk.answer("upload\n");
  CHECK(desk.answer(loading(3) + "erase\ndownload\nstart\nclear\n") ==
        kBusy + "nothing was loaded\r\n" + kBusy + kBusy + kBusy + kBusy);
  CHECK(desk.plan.count() == 1);
  CHECK(has(desk.answer("load\ncancel\n"), "cancelled by the sketch"));
}

TEST_CASE("a plan is not exchanged, nor mixed with another one, while the sketch uses it") {
  Desk desk(1);
  desk.answer("load\n" + fileOf(2));
  desk.client.upload(desk.plan.source());
  desk.answer("end\n");
  CHECK(desk.plan.count() == 1);
  desk.client.cancel();
  CHECK(has(desk.answer("status\n"), "stored: items 2"));
  for (bool isErased : {false, true}) {
    desk.answer("load\n" + fileOf(2));
    if (isErased) {
      desk.plan.erase();
    } else {
      desk.plan.sink();
    }
    CHECK(has(desk.answer("end\n"), "the EEPROM could not store the plan"));
    if (!isErased) CHECK(desk.plan.count() == 2);
  }
}

TEST_CASE("start does not fly the plan before one that was loaded") {
  Desk desk(1, true);
  desk.type("upload\n");
  REQUIRE(desk.next(ClientOnLine::kCount) != nullptr);
  desk.hear(requestParts(0));
  REQUIRE(desk.next(ClientOnLine::kItemInt) != nullptr);
  desk.hear(ackParts(0));
  desk.go(100);
  REQUIRE((desk.client.aboard() == Aboard::OurPlan));
  const std::string said = desk.answer(loading(2) + "start\nstatus\n");
  CHECK(has(said, "the stored plan is not aboard: type upload\r\n"));
  CHECK(has(said, "aboard: an earlier plan of ours, whole\r\n"));
  CHECK(!desk.client.isBusy());
}

TEST_CASE("a command is what is seen on the line when it ends, and one that is too long stays refused") {
  Desk desk;
  for (const char* line : {"startxxxxx\b\b\b\b", "startxxxxxxxxxxxxx\b\b\b\b\b\b\b\b\b\b\b\b\b", "starts \b", "st art",
                           "helps\x7F \x7F\x7F", "\x1B[Astart"}) {
    CHECK(desk.answer(std::string(line) + "\n") == "unknown command: type help\r\n");
    CHECK(!desk.client.isBusy());
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
  CHECK(desk.answer(many, 90).empty());
  CHECK(desk.answer("rt\n", 90).empty());
  CHECK(desk.answer("", 20) == kIgnored);
  CHECK(desk.answer("end\n", 90) == "nothing is being loaded: type load first\r\n");
  desk.answer("help\n", 3);
  CHECK(has(desk.answer(many), kIgnored));
  CHECK(!has(desk.said(), "stored: items"));
  desk.answer("load\nQ\n", 90);
  CHECK(desk.answer(std::string(70, '7') + "\nhelp\n") == kIgnored);
}

TEST_CASE("an EEPROM that does not keep what it is given is told, and the console goes on") {
  Desk desk;
  EepromPlan broken(Eeprom{readByte, [](uint16_t, uint8_t) {}, nullptr, 400});
  broken.begin();
  PlanConsole console(desk.port, desk.client, broken);
  desk.type(loading(1) + "status\n");
  for (int ms = 0; ms < 3000; ++ms) {
    desk.run(1);
    broken.update();
    console.update();
  }
  CHECK(has(desk.said(), ": the EEPROM could not store the plan\r\n"));
  CHECK(has(desk.said(), "stored: items 0\r\n"));
}
