#include "mavmission/text/WaypointsSource.h"

#include <doctest/doctest.h>

#include <initializer_list>
#include <string>
#include <vector>

using namespace mavmission;

namespace {

typedef WaypointsSource::State State;

// A file in memory that can fail, and that counts.
class TextFile : public Stream {
 public:
  std::string text;
  size_t position = 0;
  size_t brokenFrom = ~size_t{0};  // from here on bytes are there, and are not given
  uint32_t bytesRead = 0;
  uint32_t seeks = 0;
  uint32_t seekThatFails = 0;  // the how many-th; 0: none

  explicit TextFile(const std::string& of) : text(of) {}

  bool seek(uint32_t to) {
    position = to;
    return ++seeks != seekThatFails && to <= text.size();
  }
  int available() override { return static_cast<int>(text.size() - position); }
  int peek() override { return position < text.size() ? static_cast<uint8_t>(text[position]) : -1; }
  int read() override {
    if (position >= brokenFrom) return -1;
    const int byte = peek();
    if (byte >= 0) {
      ++position;
      ++bytesRead;
    }
    return byte;
  }
  size_t write(uint8_t) override { return 0; }
};

const char kHeader[] = "QGC WPL 110\n";
const char kHome[] = "0\t1\t0\t16\t0\t0\t0\t0\t-35.363261\t149.165230\t584.1\t1\n";

// With the number as parameter 1, by which an item is known again; lines of many lengths, and comments between them.
std::string line(int number, int command = 22) {
  std::string made = std::string(static_cast<size_t>(number % 4 == 3), ' ') + std::to_string(number) + "\t0\t3\t" +
                     std::to_string(command) + "\t" + std::to_string(number);
  made += "\t0\t0\t0\t-35\t149\t20" + std::string(static_cast<size_t>(number * number % 40), '0').replace(0, 0, ".0") +
          "\t1\n";
  if (number % 3 == 1) made += number % 2 == 0 ? "# 77 0 3 22\n" : "#77 0 3 22\n";
  if (number % 5 == 2) made += "\n";
  return made;
}

std::string plan(int items, bool hasHome = true) {
  std::string made = kHeader;
  if (hasHome) made += kHome;
  for (int i = 0; i < items; ++i) made += line(i + (hasHome ? 1 : 0));
  return made;
}

State readAll(WaypointsSource& source) {
  State state = source.update();
  for (int i = 0; i < 100000 && state == State::Reading; ++i) {
    CHECK(source.count() == 0);  // not before it is known
    state = source.update();
  }
  CHECK((state == source.state()));
  return state;
}

// The item of this index, as it is known by parameter 1; -1 if it was refused.
int itemAt(WaypointsSource& source, uint16_t index) {
  MissionItem item;
  const ItemSource from = source.source();
  return from.read(from.context, index, item) ? static_cast<int>(item.param1) : -1;
}

}  // namespace

TEST_CASE("a plan is counted and checked, and then given item by item, in any order") {
  for (bool hasHome : {true, false}) {
    for (int count : {1, 2, 3, 7, 40}) {
      TextFile file(plan(count, hasHome));
      WaypointsSource source(file);
      CHECK((source.state() == State::Reading));
      REQUIRE((readAll(source) == State::Good));
      CHECK((source.update() == State::Good));
      CHECK(source.count() == count);
      CHECK((source.type() == PlanType::Mission));
      CHECK((source.error() == TextError::None));
      CHECK(source.source().count == count);
      const int first = hasHome ? 1 : 0;
      for (int i = 0; i < count; ++i) CHECK(itemAt(source, static_cast<uint16_t>(i)) == i + first);
      for (int i = count; i-- != 0;) CHECK(itemAt(source, static_cast<uint16_t>(i)) == i + first);
      uint32_t seed = 7;
      for (int i = 0; i < 60; ++i) {
        seed = seed * 1664525 + 1013904223;
        const uint16_t index = static_cast<uint16_t>((seed >> 16) % static_cast<uint32_t>(count));
        CHECK(itemAt(source, index) == index + first);
        if (i % 7 == 3) CHECK(itemAt(source, index) == index + first);  // the same again
      }
      file.seeks = 0;
      CHECK(itemAt(source, static_cast<uint16_t>(count)) == -1);
      CHECK(file.seeks == 0);
      CHECK((source.error() == TextError::None));
      CHECK(itemAt(source, 65535) == -1);
      CHECK(itemAt(source, 0) == first);
    }
  }
}

TEST_CASE("one update() reads one field, and 64 bytes at the most") {
  TextFile file(std::string(kHeader) + "#" + std::string(200, 'x') + "\n" + kHome + line(1) + line(2));
  WaypointsSource source(file);
  State state = State::Reading;
  uint32_t most = 0;
  for (int i = 0; state == State::Reading && i < 1000; ++i) {
    const uint32_t before = file.bytesRead;
    const size_t from = file.position;
    state = source.update();
    const uint32_t read = file.bytesRead - before;
    if (read > most) most = read;
    if (from > 230 && read != 0) {  // after the comment: no two fields end
      uint32_t ends = 0;
      for (size_t at = from + 1; at < file.position; ++at) {
        const bool isEnd = file.text[at] == '\t' || file.text[at] == '\n';
        if (isEnd && file.text[at - 1] != '\t' && file.text[at - 1] != '\n' && file.text[from] != '#') ++ends;
      }
      CHECK(ends <= 1);
    }
  }
  CHECK((state == State::Good));
  CHECK(most == 64);
}

TEST_CASE("items in order take a line each, without a seek between them") {
  TextFile file(plan(40));
  WaypointsSource source(file);
  REQUIRE((readAll(source) == State::Good));
  CHECK(itemAt(source, 0) == 1);
  file.seeks = 0;
  file.bytesRead = 0;
  for (uint16_t i = 1; i < 40; ++i) CHECK(itemAt(source, i) == i + 1);
  CHECK(file.seeks == 0);
  CHECK(file.bytesRead <= file.text.size());
}

TEST_CASE("an item out of order is found by a binary search") {
  TextFile file(plan(1000));
  WaypointsSource source(file);
  REQUIRE((readAll(source) == State::Good));
  uint32_t most = 0;
  for (uint16_t index = 999, i = 0; i < 200; ++i, index = static_cast<uint16_t>((index + 387) % 1000)) {
    file.seeks = 0;
    file.bytesRead = 0;
    CHECK(itemAt(source, index) == index + 1);
    if (file.seeks > most) most = file.seeks;
    CHECK(file.bytesRead < 3500);
  }
  CHECK(most <= 12);  // of 1,000 lines; one is to the line itself
  // The one that was read last narrows the search.
  CHECK(itemAt(source, 500) == 501);
  file.seeks = 0;
  CHECK(itemAt(source, 500) == 501);
  CHECK(file.seeks == 1);
  CHECK(itemAt(source, 996) == 997);
  file.seeks = 0;
  CHECK(itemAt(source, 999) == 1000);
  CHECK(file.seeks <= 10);
  CHECK(itemAt(source, 3) == 4);
  file.seeks = 0;
  CHECK(itemAt(source, 1) == 2);
  CHECK(file.seeks <= 10);
}

TEST_CASE("a text that is bad is no plan, and says where") {
  TextFile file(plan(3) + "9 9\n");
  WaypointsSource source(file);
  CHECK((readAll(source) == State::Bad));
  CHECK((source.update() == State::Bad));
  CHECK((source.error() == TextError::OutOfOrder));
  CHECK(source.errorLine() == 8);  // two of them hold no item
  CHECK(source.errorField() == 1);
  CHECK(source.count() == 0);
  // An empty plan would clear what is aboard: there is one item, which is refused.
  CHECK(source.source().count == 1);
  CHECK(itemAt(source, 0) == -1);
}

TEST_CASE("before the whole text was read there is no plan") {
  TextFile file(plan(3));
  WaypointsSource source(file);
  CHECK(source.source().count == 1);
  CHECK(itemAt(source, 0) == -1);
  for (int i = 0; i < 20; ++i) CHECK((source.update() == State::Reading));
  CHECK(source.source().count == 1);
  CHECK(itemAt(source, 0) == -1);
  CHECK((readAll(source) == State::Good));
}

TEST_CASE("begin() reads another text, from its beginning") {
  TextFile file(plan(30));
  WaypointsSource source(file);
  REQUIRE((readAll(source) == State::Good));
  CHECK(itemAt(source, 17) == 18);
  file.text = kHeader + line(0, 5100) + line(1, 5100);
  source.begin();
  CHECK((source.state() == State::Reading));
  REQUIRE((readAll(source) == State::Good));
  CHECK(source.count() == 2);
  CHECK((source.type() == PlanType::Rally));
  CHECK(itemAt(source, 1) == 1);
  CHECK(itemAt(source, 0) == 0);
  file.text = "none";
  source.begin();
  CHECK((readAll(source) == State::Bad));
  file.text = plan(2);
  source.begin();
  CHECK((readAll(source) == State::Good));
}

TEST_CASE("a file that cannot be sought, or that stops to give its bytes, is unreadable") {
  TextFile unsought(plan(3));
  unsought.seekThatFails = 1;
  WaypointsSource never(unsought);
  CHECK((never.update() == State::Bad));
  CHECK((never.error() == TextError::Unreadable));
  for (size_t from : {size_t{0}, size_t{5}, plan(3).size() - 1}) {
    TextFile broken(plan(3));
    broken.brokenFrom = from;
    WaypointsSource source(broken);
    CHECK((readAll(source) == State::Bad));
    CHECK((source.error() == TextError::Unreadable));
  }
}

TEST_CASE("an item that cannot be read again is refused, and can be read when the file is good again") {
  const std::string text = plan(40);
  TextFile file(text);
  WaypointsSource source(file);
  REQUIRE((readAll(source) == State::Good));
  for (uint32_t seek = 1; seek < 8; ++seek) {
    CHECK(itemAt(source, 39) == 40);
    file.seeks = 0;
    file.seekThatFails = seek;
    const int found = itemAt(source, 5);
    if (file.seeks >= seek) {
      CHECK(found == -1);
      CHECK((source.error() == TextError::Unreadable));
    }
    file.seekThatFails = 0;
    CHECK(itemAt(source, 5) == 6);
    CHECK((source.error() == TextError::None));
    CHECK(itemAt(source, 6) == 7);
  }
  for (size_t from = 0; from < text.size(); from += 37) {
    CHECK(itemAt(source, 0) == 1);
    file.brokenFrom = from;
    const int found = itemAt(source, 39);
    CHECK((found == -1 || found == 40));
    if (found == -1) CHECK((source.error() == TextError::Unreadable));
    file.brokenFrom = ~size_t{0};
    CHECK(itemAt(source, 39) == 40);
  }
  // In order too, where no seek tells of it.
  CHECK(itemAt(source, 10) == 11);
  file.brokenFrom = file.position + 5;
  CHECK(itemAt(source, 11) == -1);
  CHECK((source.error() == TextError::Unreadable));
  file.brokenFrom = ~size_t{0};
  CHECK(itemAt(source, 11) == 12);
  // A file that has become shorter since it was counted.
  CHECK(itemAt(source, 37) == 38);
  file.text = text.substr(0, file.position);
  CHECK(itemAt(source, 38) == -1);
  CHECK((source.error() == TextError::Unreadable));
  file.text = text;
  CHECK(itemAt(source, 38) == 39);
  // One that has changed: the line is not the one that was asked for.
  file.text.replace(file.text.find("\n40\t") + 1, 2, "41");
  CHECK(itemAt(source, 39) == -1);
  CHECK((source.error() == TextError::OutOfOrder));
  CHECK(itemAt(source, 0) == 1);
  CHECK(itemAt(source, 39) == -1);  // and it is not looked for without end
  file.text[file.text.find("\n5\t") + 3] = '\0';
  CHECK(itemAt(source, 4) == -1);
  CHECK((source.error() == TextError::Padding));
}

TEST_CASE("a byte of 0 does not end a text") {
  TextFile file(plan(3) + std::string(1, '\0') + "\n");
  WaypointsSource source(file);
  CHECK((readAll(source) == State::Bad));
  CHECK((source.error() == TextError::Padding));
}

TEST_CASE("a text without the last line's end, with any line ends, and comments, is found through too") {
  for (const std::string& end :
       std::vector<std::string>{"\r\n", "\r", "\n  # 17 is no item\n", "\r\n\t#" + std::string(300, '9') + "\r\n"}) {
    std::string text = plan(20);
    while (text.back() == '\n') text.pop_back();
    for (size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += end.size()) text.replace(at, 1, end);
    TextFile file(text);
    WaypointsSource source(file);
    REQUIRE((readAll(source) == State::Good));
    CHECK(source.count() == 20);
    for (uint16_t i = 0; i < 20; ++i) {
      CHECK(itemAt(source, 19) == 20);
      CHECK(itemAt(source, i) == i + 1);
    }
  }
}
