#include "mavmission/text/WaypointsText.h"

#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

using namespace mavmission;
using namespace mavmission::detail;

namespace {

typedef WaypointsText::Step Step;

const char kHeader[] = "QGC WPL 110\n";
const char kHome[] = "0\t1\t0\t16\t0\t0\t0\t0\t-35.363261\t149.165230\t584.1\t1\n";

// A line with a command at a place.
std::string line(int number, int command, const char* param1 = "0") {
  return std::to_string(number) + "\t0\t3\t" + std::to_string(command) + "\t" + param1 + "\t0\t0\t0\t-35\t149\t20\t1\n";
}

// What a text comes to.
struct Read {
  TextError error = TextError::None;
  uint16_t line = 0;
  uint8_t field = 0;
  uint16_t count = 0;
  uint8_t first = 0;
  PlanType type = PlanType::Mission;
  std::vector<MissionItem> items;
};

Read read(const std::string& text, WaypointsText& from) {
  Read found;
  bool isBad = false;
  for (char c : text) {
    const Step step = from.take(c);
    CHECK((!isBad || step == Step::Bad));  // further characters change nothing
    isBad = step == Step::Bad;
    if (step == Step::Item) found.items.push_back(from.item());
  }
  Step step = from.end();
  if (step == Step::Item) {
    found.items.push_back(from.item());
    step = from.end();
  }
  found.error = from.error();
  CHECK((step == Step::Bad) == (found.error != TextError::None));
  CHECK(step != Step::Item);
  found.line = from.errorLine();
  found.field = from.errorField();
  found.count = from.count();
  found.first = from.firstNumber();
  found.type = from.type();
  return found;
}

Read read(const std::string& text) {
  WaypointsText from;
  // What is left of another text is forgotten.
  for (char c : std::string("QGC WPL 110\n0 0 0 5100 0 0 0 0 0 0 0 1\n1 0 0 5100 3")) from.take(c);
  from.begin();
  return read(text, from);
}

bool isRefused(const std::string& text, TextError error, uint16_t line, uint8_t field) {
  const Read found = read(text);
  CHECK((found.error == error));
  CHECK(found.line == line);
  CHECK(found.field == field);
  return found.error == error && found.line == line && found.field == field;
}

// Line 1 of a plan, behind the header and home, with this field replaced.
std::string withField(uint8_t field, const std::string& text, const char* command = "16") {
  std::string made = std::string(kHeader) + kHome;
  const char* const fields[] = {"1", "0", "3", command, "0", "0", "0", "0", "-35", "149", "20", "1"};
  for (uint8_t i = 1; i <= 12; ++i) made += (i == field ? text : fields[i - 1]) + (i == 12 ? "\n" : "\t");
  return made;
}

// The error of the field, in line 3.
TextError errorOf(uint8_t field, const std::string& text, const char* command = "16") {
  const Read found = read(withField(field, text, command));
  if (found.error != TextError::None) {
    CHECK(found.line == 3);
    CHECK(found.field == field);
  }
  return found.error;
}

MissionItem itemWith(uint8_t field, const std::string& text, const char* command = "16") {
  const Read found = read(withField(field, text, command));
  REQUIRE((found.error == TextError::None));
  REQUIRE(found.items.size() == 1);
  return found.items[0];
}

}  // namespace

TEST_CASE("each field of a line comes to its place in the item") {
  const Read found =
      read(std::string(kHeader) + kHome + "1\t1\t10\t16\t1.5\t-2\t1e3\tnan\t-35.3632621\t149.16523740\t-20.5\t0\n");
  CHECK((found.error == TextError::None));
  CHECK(found.field == 0);
  REQUIRE(found.items.size() == 1);
  CHECK(found.count == 1);
  CHECK(found.first == 1);
  CHECK((found.type == PlanType::Mission));
  const MissionItem& item = found.items[0];
  CHECK(item.param1 == 1.5f);
  CHECK(item.param2 == -2);
  CHECK(item.param3 == 1000);
  CHECK(item.param4 != item.param4);
  CHECK(item.x == -353632621);
  CHECK(item.y == 1491652374);
  CHECK(item.z == -20.5f);
  CHECK(item.command == 16);
  CHECK((item.frame == static_cast<CoordinateFrame>(10)));
  CHECK(item.current == 1);
  CHECK(item.autocontinue == 0);
}

TEST_CASE("a text is read with any line ends, blanks, comments, empty lines, and without the last line's end") {
  const std::string one = line(1, 16), two = line(2, 20);
  const auto hasTwo = [](const std::string& text) {
    const Read found = read(text);
    return found.error == TextError::None && found.count == 2 && found.items.size() == 2;
  };
  CHECK(hasTwo(kHeader + (kHome + one) + two));
  CHECK(
      hasTwo((kHeader + (kHome + one) + two).substr(0, strlen(kHeader) + strlen(kHome) + one.size() + two.size() - 1)));
  CHECK(hasTwo("\xEF\xBB\xBF" + (kHeader + (kHome + one)) + two));
  CHECK(hasTwo("QGC WPL 110 \t \r\n" + (kHome + one) + two));
  CHECK(hasTwo(kHeader + (kHome + ("\n\n# 1 2 3\n#\n \t \n" + one)) + "#" + std::string(254, 'x') + "\n" + two +
               "\n# end"));
  std::string blanks = kHeader + (kHome + one) + two;
  for (size_t i = 0; i < blanks.size(); ++i) {
    if (blanks[i] == '\t') blanks.replace(i, 1, " "), ++i;
  }
  CHECK(hasTwo(blanks));
  std::string returns = kHeader + (kHome + one) + two;
  for (size_t i = 0; i < returns.size(); ++i) {
    if (returns[i] == '\n') returns.replace(i++, 1, " \t\r\n"), i += 2;
  }
  CHECK(hasTwo(returns));
  CHECK(hasTwo(kHeader + (kHome + ("  " + one)) + two));
  for (char& c : blanks) c = c == '\n' ? '\r' : c;
  CHECK(hasTwo(blanks));
  CHECK(hasTwo("QGC\t \tWPL\t110\n" + (kHome + one) + two));
  CHECK(hasTwo(kHeader +
               (kHome + (" \t# 7 \xE4\xFF\x01" + std::string(1, '\0') + "\n#" + std::string(999, 'x') + "\r" + one)) +
               two));
}

TEST_CASE("a text that does not begin as it must is no such text, at the first line") {
  for (const char* text :
       {"", "\n", "QGC WPL 11\n", "QGC WPL 1100\n", "QGC WPL 111\n", "qgc WPL 110\n", "QGC WPL 110x\n",
        " QGC WPL 110\n", "\xEF\xBB\xBF\xBFQGC WPL 110\n", "Q\xBBGC WPL 110\n", "QGC WPL 110 110\n", "QGC WPL",
        "\xEF\xBB\xBF\n", "\xEFQGC WPL 110\n", "\xEF\xBB", "QGCWPL 110\n", "#QGC WPL 110\n", "QGC WPL 110\x01\n"}) {
    CHECK(isRefused(text, TextError::NotWaypoints, 1, 0));
  }
  CHECK(isRefused(std::string("QGC WPL 110\0\n", 13), TextError::NotWaypoints, 1, 0));
  CHECK(isRefused(kHeader, TextError::NoItems, 2, 0));
  CHECK(isRefused("QGC WPL 110", TextError::NoItems, 2, 0));
  CHECK(isRefused(kHeader + std::string(kHome), TextError::NoItems, 3, 0));
}

TEST_CASE("a line has 12 fields, and 255 characters at the most") {
  const std::string before = std::string(kHeader) + kHome;
  CHECK(isRefused(before + "1 0 3 16 0 0 0 0 -35 149 20\n", TextError::TooFewFields, 3, 0));
  CHECK(isRefused(before + "1\n", TextError::TooFewFields, 3, 0));
  CHECK(isRefused(before + "1 0 3 16 0 0 0 0 -35 149 20 1 1\n", TextError::TooManyFields, 3, 0));
  CHECK(isRefused(before + "1 0 3 16 0 0 0 0 -35 149 20 1 x", TextError::TooManyFields, 3, 0));
  const std::string fields = "1 0 3 16 0 0 0 0 -35 149 20 1";
  CHECK((read(before + fields + std::string(255 - fields.size(), ' ') + "\n").error == TextError::None));
  CHECK(isRefused(before + fields + std::string(256 - fields.size(), ' ') + "\n", TextError::LineTooLong, 3, 0));
  // A second plan, and what was never written to its end.
  CHECK(isRefused(before + line(1, 16) + kHeader + line(0, 16), TextError::SecondPlan, 4, 0));
  CHECK(isRefused(before + line(1, 16) + std::string(9, '\0'), TextError::Padding, 4, 0));
  CHECK(isRefused(before + fields + std::string(9, '\xFF'), TextError::Padding, 3, 12));
}

TEST_CASE("lines are numbered one by one from 0, which comments do not change") {
  const std::string before = std::string(kHeader) + kHome;
  CHECK(isRefused(kHeader + line(1, 16), TextError::OutOfOrder, 2, 1));
  CHECK(isRefused(before + line(2, 16), TextError::OutOfOrder, 3, 1));
  CHECK(isRefused(before + line(0, 16), TextError::OutOfOrder, 3, 1));
  CHECK(isRefused(before + line(1, 16) + "# a\n\n" + line(3, 16), TextError::OutOfOrder, 6, 1));
  CHECK(isRefused(before + line(1, 16) + line(2, 16) + line(2, 16), TextError::OutOfOrder, 5, 1));
  CHECK((errorOf(1, "-1") == TextError::OutOfOrder));
  CHECK((errorOf(1, "65537") == TextError::OutOfOrder));
  CHECK((errorOf(1, "1.0") == TextError::NotWhole));
  CHECK((errorOf(1, "x") == TextError::BadNumber));
  CHECK((errorOf(1, "+1") == TextError::None));
  CHECK((errorOf(1, "99999999999") == TextError::TooLarge));
}

TEST_CASE("current and autocontinue are 0 or 1, and another current means nothing") {
  for (const char* text : {"2", "256", "-1"}) CHECK(itemWith(2, text).current == 0);
  for (uint8_t field : {2, 12}) {
    CHECK((errorOf(field, "0") == TextError::None));
    CHECK((errorOf(field, "-0") == TextError::None));
    CHECK((errorOf(field, "1") == TextError::None));
    if (field == 12) {
      CHECK((errorOf(field, "2") == TextError::NotZeroOrOne));
      CHECK((errorOf(field, "256") == TextError::NotZeroOrOne));
      CHECK((errorOf(field, "-1") == TextError::BadNumber));
    }
    CHECK((errorOf(field, "0.0") == TextError::NotWhole));
    CHECK((errorOf(field, "1e0") == TextError::NotWhole));
    CHECK((errorOf(field, "nan") == TextError::NotWhole));
  }
  CHECK(itemWith(2, "1").current == 1);
  CHECK(itemWith(2, "0").current == 0);
  CHECK(itemWith(12, "1").autocontinue == 1);
  CHECK(itemWith(12, "0").autocontinue == 0);
}

TEST_CASE("of the frames those of MISSION_ITEM and MISSION_ITEM_INT are taken that the library has, as the latter") {
  const struct {
    const char* text;
    uint8_t frame;
  } kTaken[] = {{"0", 0}, {"2", 2}, {"3", 3}, {"5", 0}, {"6", 3}, {"10", 10}, {"11", 10}};
  for (const auto& one : kTaken) {
    const Read found = read(withField(3, one.text, "189"));  // which may be in each
    // Without a place, -35 and 149 are whole numbers.
    REQUIRE((found.error == TextError::None));
    CHECK((found.items[0].frame == static_cast<CoordinateFrame>(one.frame)));
  }
  for (const char* text : {"1", "4", "7", "8", "9", "12", "16", "18", "19", "32", "258"}) {
    CHECK((errorOf(3, text) == TextError::BadTextFrame));
  }
  CHECK((errorOf(3, "-3") == TextError::BadNumber));
  for (const char* command : {"16", "22", "21", "85", "30", "113", "195"}) {
    CHECK((errorOf(3, "2", command) == TextError::NoReference));
  }
  CHECK(isRefused(withField(3, "2").replace(withField(3, "2").rfind("149"), 3, "149.5"), TextError::NoReference, 3, 3));
  // A command without a place has no frame, whatever the file says.
  CHECK((itemWith(3, "3", "20").frame == CoordinateFrame::Mission));
}

TEST_CASE("a command is a number of 16 bits") {
  CHECK(read(withField(4, "0")).items[0].command == 0);
  CHECK(itemWith(4, "65535").command == 65535);
  CHECK((errorOf(4, "65536") == TextError::TooLarge));
  CHECK((errorOf(4, "-16") == TextError::BadNumber));
  CHECK((errorOf(4, "16.") == TextError::NotWhole));
}

TEST_CASE("parameters and the altitude are floats; the altitude is a number") {
  for (uint8_t field : {5, 6, 7, 8, 11}) {
    CHECK((errorOf(field, "3e38") == TextError::None));
    CHECK((errorOf(field, "-4e38") == TextError::TooLarge));
    CHECK((errorOf(field, "1.5x") == TextError::BadNumber));
    CHECK((errorOf(field, "inf") == TextError::BadNumber));
    CHECK((errorOf(field, "nan") == (field == 11 ? TextError::BadNumber : TextError::None)));
  }
}

TEST_CASE("a place is within 90 and 180 degrees") {
  CHECK(itemWith(9, "90").x == 900000000);
  CHECK(itemWith(9, "-90").x == -900000000);
  CHECK(itemWith(10, "180").y == 1800000000);
  CHECK(itemWith(10, "-180").y == -1800000000);
  CHECK(itemWith(10, "90.0000001").y == 900000001);
  CHECK((errorOf(9, "90.0000001") == TextError::BeyondLatitude));
  CHECK((errorOf(9, "-90.0000001") == TextError::BeyondLatitude));
  CHECK((errorOf(10, "180.0000001") == TextError::BeyondLongitude));
  CHECK((errorOf(10, "-180.0000001") == TextError::BeyondLongitude));
  for (uint8_t field : {9, 10}) {
    CHECK((errorOf(field, "300") == TextError::TooLarge));
    CHECK((errorOf(field, "nan") == TextError::BadNumber));
    CHECK((errorOf(field, "35d") == TextError::BadNumber));
  }
}

TEST_CASE("parameters 5 and 6 of a command without a place are whole numbers of any size") {
  CHECK(itemWith(9, "2147483647", "178").x == 2147483647);
  CHECK(itemWith(10, "-2147483648", "178").y == std::numeric_limits<int32_t>::min());
  CHECK(itemWith(9, "0.000", "178").x == 0);
  CHECK(itemWith(9, "47.5", "20").x == 0);  // a place, which a return has not
  for (uint8_t field : {9, 10}) {
    CHECK((errorOf(field, "0.5", "203") == TextError::NotWhole));
    CHECK((errorOf(field, "2147483648", "178") == TextError::TooLarge));
  }
}

TEST_CASE("line 0 is home if it is a waypoint or command 0, and else the first item") {
  for (int command : {16, 0}) {
    const Read found = read(kHeader + line(0, command) + line(1, 22));
    CHECK((found.error == TextError::None));
    CHECK(found.first == 1);
    CHECK(found.count == 1);
    REQUIRE(found.items.size() == 1);
    CHECK(found.items[0].command == 22);
  }
  for (int command : {22, 17, 1}) {
    const Read found = read(kHeader + line(0, command) + line(1, 16));
    CHECK(found.first == 0);
    CHECK(found.count == 2);
    REQUIRE(found.items.size() == 2);
    CHECK(found.items[1].command == 16);
  }
}

TEST_CASE("one item is a plan, without home too") {
  CHECK((read(kHeader + line(0, 22)).error == TextError::None));
  CHECK(read(kHeader + line(0, 22)).count == 1);
}

TEST_CASE("the kind of plan is that of its first item, which all others have") {
  const struct {
    int command;
    PlanType type;
  } kKinds[] = {{16, PlanType::Mission}, {4999, PlanType::Mission}, {5000, PlanType::Fence},   {5001, PlanType::Fence},
                {5004, PlanType::Fence}, {5005, PlanType::Fence},   {5099, PlanType::Fence},   {5100, PlanType::Rally},
                {5199, PlanType::Rally}, {5200, PlanType::Mission}, {65535, PlanType::Mission}};
  for (const auto& one : kKinds) {
    for (const auto& other : kKinds) {
      CAPTURE(one.command);
      CAPTURE(other.command);
      const Read behindHome = read(kHeader + std::string(kHome) + line(1, one.command) + line(2, other.command));
      CHECK((behindHome.error == (one.type == other.type ? TextError::None : TextError::MixedKinds)));
      CHECK((behindHome.type == one.type));
      if (behindHome.error != TextError::None) {
        CHECK(behindHome.line == 4);
        CHECK(behindHome.field == 4);
      }
    }
  }
  const Read alone = read(kHeader + line(0, 5100) + line(1, 5100));
  CHECK((alone.type == PlanType::Rally));
  CHECK(alone.count == 2);
  CHECK(isRefused(kHeader + line(0, 5100) + line(1, 5001), TextError::MixedKinds, 3, 4));
}

TEST_CASE("a jump's target is the sketch's number of an item that is there") {
  const std::string before = std::string(kHeader) + kHome;
  const Read found = read(before + line(1, 177, "1") + line(2, 177, "3") + line(3, 16, "7"));
  CHECK((found.error == TextError::None));
  REQUIRE(found.items.size() == 3);
  CHECK(found.items[0].param1 == 0);
  CHECK(found.items[1].param1 == 2);
  CHECK(found.items[2].param1 == 7);  // no jump
  CHECK(isRefused(before + line(1, 177, "0") + line(2, 16), TextError::BadTarget, 3, 5));
  CHECK(isRefused(before + line(1, 177, "-1") + line(2, 16), TextError::BadTarget, 3, 5));
  CHECK(isRefused(before + line(1, 177, "1.5") + line(2, 16), TextError::BadTarget, 3, 5));
  CHECK(isRefused(before + line(1, 177, "nan") + line(2, 16), TextError::BadTarget, 3, 5));
  // Whether it is there is known at the end; what is told is the line of the farthest jump.
  CHECK(isRefused(before + line(1, 16) + line(2, 177, "3"), TextError::BadTarget, 4, 5));
  CHECK(isRefused(before + line(1, 177, "9") + line(2, 177, "9") + line(3, 177, "4"), TextError::BadTarget, 3, 5));
  CHECK(isRefused(before + line(1, 177, "8") + line(2, 177, "9") + line(3, 177, "4"), TextError::BadTarget, 4, 5));
  // Without home, items are counted from 0 in the file too.
  const Read alone = read(kHeader + line(0, 177, "0") + line(1, 177, "1"));
  CHECK((alone.error == TextError::None));
  REQUIRE(alone.items.size() == 2);
  CHECK(alone.items[0].param1 == 0);
  CHECK(alone.items[1].param1 == 1);
  CHECK(isRefused(kHeader + line(0, 177, "2") + line(1, 16), TextError::BadTarget, 2, 5));
}

TEST_CASE("a jump in line 0 that is home counts for nothing") {
  // (Home is a waypoint: there is none. What is looked at are targets that a text before had.)
  WaypointsText text;
  for (char c : std::string(kHeader) + kHome + line(1, 177, "9")) text.take(c);
  text.begin();
  CHECK((read(std::string(kHeader) + kHome + line(1, 16), text).error == TextError::None));
}

TEST_CASE("a line in the middle is read by its number, and has no line number") {
  WaypointsText text;
  Read whole = read(std::string(kHeader) + kHome + line(1, 16) + line(2, 17), text);
  REQUIRE(whole.count == 2);
  text.beginAt(2);
  CHECK(text.isAtLineStart());
  Step step = Step::More;
  for (char c : line(2, 177, "2")) {
    CHECK(step == Step::More);
    step = text.take(c);
  }
  CHECK(step == Step::Item);
  CHECK(text.item().command == 177);
  CHECK(text.item().param1 == 1);  // home is remembered
  CHECK(text.isAtLineStart());
  text.beginAt(1);
  for (char c : line(2, 16)) step = text.take(c);
  CHECK(step == Step::Bad);
  CHECK((text.error() == TextError::OutOfOrder));
  CHECK(text.errorLine() == 0);
  CHECK(text.errorField() == 1);
  // And the kind of plan is.
  text.beginAt(2);
  CHECK((text.error() == TextError::None));
  for (char c : line(2, 5100)) step = text.take(c);
  CHECK(step == Step::Bad);
  CHECK((text.error() == TextError::MixedKinds));
}

TEST_CASE("a line in the middle is read whatever was being read before") {
  for (const char* before : {"", "QGC", "QGC WPL 110\n# comme", "QGC WPL 110\n0 0 3 16 0 0 0 0 0 0", "none"}) {
    WaypointsText text;
    for (const char* c = before; *c != 0; ++c) text.take(*c);
    text.beginAt(5);
    CHECK(text.errorField() == 0);
    Step step = Step::More;
    for (char c : line(5, 22)) step = text.take(c);
    CHECK(step == Step::Item);
    // Nor is it known which line is bad behind it.
    for (char c : line(7, 22)) step = text.take(c);
    CHECK(step == Step::Bad);
    CHECK(text.errorLine() == 0);
    CHECK(text.errorField() == 1);
  }
}

TEST_CASE("a text that is cut off anywhere never gives half an item") {
  const std::string text = std::string(kHeader) + kHome + line(1, 22) + line(2, 177, "1") + line(3, 16, "7.25");
  const Read whole = read(text);
  REQUIRE(whole.items.size() == 3);
  for (size_t length = 0; length < text.size(); ++length) {
    const Read cut = read(text.substr(0, length));
    for (size_t i = 0; i < cut.items.size(); ++i) {
      CHECK(cut.items[i].command == whole.items[i].command);
      CHECK(cut.items[i].param1 == whole.items[i].param1);
      CHECK(cut.items[i].autocontinue == 1);
    }
  }
}

TEST_CASE("a line whose last field is bad is so at its end") {
  WaypointsText text;
  for (char c : std::string(kHeader) + "0 0 3 16 0 0 0 0 0 0 0 x") CHECK(text.take(c) == Step::More);
  CHECK(text.take('\n') == Step::Bad);
  CHECK(text.errorField() == 12);
}

TEST_CASE("it is known whether a line, or a field of it, has begun") {
  WaypointsText text;
  CHECK(text.isAtLineStart());
  CHECK_FALSE(text.isInField());
  for (const char* c = kHeader; *c != '\n'; ++c) text.take(*c);
  CHECK_FALSE(text.isAtLineStart());
  CHECK_FALSE(text.isInField());
  text.take('\n');
  CHECK(text.isAtLineStart());
  text.take(' ');
  CHECK_FALSE(text.isAtLineStart());
  CHECK_FALSE(text.isInField());
  text.take('0');
  CHECK(text.isInField());
  text.take('\t');
  CHECK_FALSE(text.isInField());
  // A line that breaks off within a field is one with too few.
  text.take('0');
  CHECK(text.take('\n') == Step::Bad);
  CHECK((text.error() == TextError::TooFewFields));
}

TEST_CASE("what a caller finds wrong ends the text") {
  WaypointsText text;
  for (char c : std::string(kHeader) + kHome) text.take(c);
  CHECK(text.fail(TextError::Unreadable) == Step::Bad);
  CHECK((text.error() == TextError::Unreadable));
  CHECK(text.take('1') == Step::Bad);
  CHECK(text.take('\n') == Step::Bad);
  CHECK(text.end() == Step::Bad);
  CHECK((text.error() == TextError::Unreadable));
}

TEST_CASE("a plan has 65534 items at the most, behind home and without it") {
  for (int first : {1, 0}) {
    WaypointsText text;
    for (char c : kHeader + ((first == 1 ? kHome : "") + line(first, 22))) text.take(c);
    text.beginAt(static_cast<uint16_t>(65532 + first));  // as if all up to there had been read
    Step step = Step::More;
    for (int number : {65532 + first, 65533 + first}) {
      for (char c : line(number, 22)) step = text.take(c);
      CHECK(step == Step::Item);
    }
    CHECK(text.count() == WaypointsText::kMostItems + 0);
    for (char c : line(65534 + first, 22)) step = text.take(c);
    CHECK(step == Step::Bad);
    CHECK((text.error() == TextError::NoRoom));
  }
}
