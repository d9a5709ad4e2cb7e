#include "mavmission/text/WaypointsText.h"

#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using namespace mavmission;
using namespace mavmission::detail;

namespace {

typedef WaypointsText::Step Step;

const std::string kHeader = "QGC WPL 110\n";
const std::string kHome = "0\t1\t0\t16\t0\t0\t0\t0\t-35.363261\t149.165230\t584.1\t1\n";
const std::string kBegin = kHeader + kHome;

// A line with a command at a place.
std::string line(int number, int command, const char* param1 = "0") {
  return std::to_string(number) + "\t0\t3\t" + std::to_string(command) + "\t" + param1 + "\t0\t0\t0\t-35\t149\t20\t1\n";
}

const char* nameOf(TextError error) {
  static const char* const kNames[] = {
#define NAME(name, text) #name,
      MAVMISSION_TEXT_ERRORS(NAME)
#undef NAME
  };
  return kNames[static_cast<uint8_t>(error)];
}

// Where the text is bad and why, as "3.5 BadTarget": in line 3, field 5; or "None".
std::string errorOf(const WaypointsText& text) {
  if (text.error() == TextError::None) return "None";
  return std::to_string(text.errorLine()) + "." + std::to_string(text.errorField()) + " " + nameOf(text.error());
}

// What a text comes to.
struct Read {
  std::string error;
  uint16_t count = 0;
  uint8_t first = 0;
  PlanType type = PlanType::Mission;
  std::vector<MissionItem> items;
};

// Behind the last of these characters.
Step fed(WaypointsText& text, const std::string& characters) {
  Step step = Step::More;
  for (char c : characters) step = text.take(c);
  return step;
}

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
  CHECK((step == Step::Bad) == (from.error() != TextError::None));
  CHECK(step != Step::Item);
  found.error = errorOf(from);
  found.count = from.count();
  found.first = from.firstNumber();
  found.type = from.type();
  return found;
}

Read read(const std::string& text) {
  WaypointsText from;
  // What is left of another text is forgotten.
  fed(from, std::string("QGC WPL 110\n0 0 0 5100 0 0 0 0 0 0 0 1\n1 0 0 5100 3"));
  from.begin();
  return read(text, from);
}

std::string told(const std::string& text) { return read(text).error; }

// "Fence from 1: 5001 0, 5001 3": the kind of plan, its first number, and each item's command and param1; or the error.
std::string planOf(const std::string& text) {
  const Read found = read(text);
  if (found.error != "None") return found.error;
  CHECK(found.count == found.items.size());
  static const char* const kKinds[] = {"Mission", "Fence", "Rally"};
  std::ostringstream said;
  said << kKinds[static_cast<uint8_t>(found.type)] << " from " << int(found.first);
  const char* before = ": ";
  for (const MissionItem& item : found.items) {
    said << before << item.command << " " << item.param1;
    before = ", ";
  }
  return said.str();
}

// Line 1 of a plan, after the header and home, with this field replaced.
std::string withField(uint8_t field, const std::string& text, const char* command = "16") {
  std::string made = kBegin;
  const char* const fields[] = {"1", "0", "3", command, "0", "0", "0", "0", "-35", "149", "20", "1"};
  for (uint8_t i = 1; i <= 12; ++i) made += (i == field ? text : fields[i - 1]) + (i == 12 ? "\n" : "\t");
  return made;
}

// What each of the texts between blanks comes to in that field: "ok", or its error in line 3.
std::string errors(uint8_t field, const std::string& texts, const char* command = "16") {
  std::string all;
  std::istringstream words(texts);
  for (std::string text; words >> text;) {
    std::string error = told(withField(field, text, command));
    const std::string here = "3." + std::to_string(field) + " ";
    CHECK((error == "None" || error.compare(0, here.size(), here) == 0));
    all += (all.empty() ? "" : " ") + (error == "None" ? "ok" : error.substr(error.find(' ') + 1));
  }
  return all;
}

MissionItem itemWith(uint8_t field, const std::string& text, const char* command = "16") {
  const Read found = read(withField(field, text, command));
  REQUIRE(found.error == "None");
  REQUIRE(found.items.size() == 1);
  return found.items[0];
}

}  // namespace

TEST_CASE("each field of a line comes to its place in the item") {
  const Read found = read(kBegin + "1\t1\t10\t16\t1.5\t-2\t1e3\tnan\t-35.3632621\t149.16523740\t-20.5\t0\n");
  CHECK(found.error == "None");
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
    return found.error == "None" && found.count == 2 && found.items.size() == 2;
  };
  CHECK(hasTwo(kBegin + one + two));
  CHECK(hasTwo(kBegin + one + two.substr(0, two.size() - 1)));
  CHECK(hasTwo("\xEF\xBB\xBF" + kBegin + one + two));
  CHECK(hasTwo("QGC WPL 110 \t \r\n" + (kHome + one) + two));
  CHECK(hasTwo(kBegin + ("\n\n# 1 2 3\n#\n \t \n" + one) + "#" + std::string(254, 'x') + "\n" + two + "\n# end"));
  std::string blanks = kBegin + one + two;
  for (size_t i = 0; i < blanks.size(); ++i) {
    if (blanks[i] == '\t') blanks.replace(i, 1, " "), ++i;
  }
  CHECK(hasTwo(blanks));
  std::string returns = kBegin + one + two;
  for (size_t i = 0; i < returns.size(); ++i) {
    if (returns[i] == '\n') returns.replace(i++, 1, " \t\r\n"), i += 2;
  }
  CHECK(hasTwo(returns));
  CHECK(hasTwo(kBegin + "  " + one + two));
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
    CHECK(told(text) == "1.0 NotWaypoints");
  }
  CHECK(told(std::string("QGC WPL 110\0\n", 13)) == "1.0 NotWaypoints");
  CHECK(told(kHeader) == "2.0 NoItems");
  CHECK(told("QGC WPL 110") == "2.0 NoItems");
  CHECK(told(kBegin) == "3.0 NoItems");
}

TEST_CASE("a line has 12 fields, and 255 characters at the most") {
  CHECK(told(kBegin + "1 0 3 16 0 0 0 0 -35 149 20\n") == "3.0 TooFewFields");
  CHECK(told(kBegin + "1\n") == "3.0 TooFewFields");
  CHECK(told(kBegin + "1 0 3 16 0 0 0 0 -35 149 20 1 1\n") == "3.0 TooManyFields");
  CHECK(told(kBegin + "1 0 3 16 0 0 0 0 -35 149 20 1 x") == "3.0 TooManyFields");
  const std::string fields = "1 0 3 16 0 0 0 0 -35 149 20 1";
  CHECK(told(kBegin + fields + std::string(255 - fields.size(), ' ') + "\n") == "None");
  CHECK(told(kBegin + fields + std::string(256 - fields.size(), ' ') + "\n") == "3.0 LineTooLong");
  // A second plan, and what was never written to its end.
  CHECK(told(kBegin + line(1, 16) + kHeader + line(0, 16)) == "4.0 SecondPlan");
  CHECK(told(kBegin + line(1, 16) + std::string(9, '\0')) == "4.0 Padding");
  CHECK(told(kBegin + fields + std::string(9, '\xFF')) == "3.12 Padding");
}

TEST_CASE("lines are numbered one by one from 0, which comments do not change") {
  CHECK(told(kHeader + line(1, 16)) == "2.1 OutOfOrder");
  CHECK(told(kBegin + line(2, 16)) == "3.1 OutOfOrder");
  CHECK(told(kBegin + line(0, 16)) == "3.1 OutOfOrder");
  CHECK(told(kBegin + line(1, 16) + "# a\n\n" + line(3, 16)) == "6.1 OutOfOrder");
  CHECK(told(kBegin + line(1, 16) + line(2, 16) + line(2, 16)) == "5.1 OutOfOrder");
  CHECK(errors(1, "-1 65537 1.0 x +1 99999999999") == "OutOfOrder OutOfOrder NotWhole BadNumber ok TooLarge");
}

TEST_CASE("current and autocontinue are 0 or 1, and another current means nothing") {
  for (const char* text : {"2", "256", "-1"}) CHECK(itemWith(2, text).current == 0);
  for (uint8_t field : {2, 12}) CHECK(errors(field, "0 -0 1 0.0 1e0 nan") == "ok ok ok NotWhole NotWhole NotWhole");
  CHECK(errors(12, "2 256 -1") == "NotZeroOrOne NotZeroOrOne BadNumber");
  for (int is : {0, 1}) {
    CHECK(itemWith(2, std::to_string(is)).current == is);
    CHECK(itemWith(12, std::to_string(is)).autocontinue == is);
  }
}

TEST_CASE("of the frames those of MISSION_ITEM and MISSION_ITEM_INT are taken that the library has, as the latter") {
  const struct {
    const char* text;
    uint8_t frame;
  } kTaken[] = {{"0", 0}, {"2", 2}, {"3", 3}, {"5", 0}, {"6", 3}, {"10", 10}, {"11", 10}};
  for (const auto& one : kTaken) {  // 189 may be in each; without a place, -35 and 149 are whole numbers
    CHECK((itemWith(3, one.text, "189").frame == static_cast<CoordinateFrame>(one.frame)));
  }
  for (const char* text : {"1", "4", "7", "8", "9", "12", "16", "18", "19", "32", "258"}) {
    CHECK(errors(3, text) == "BadTextFrame");
  }
  CHECK(errors(3, "-3") == "BadNumber");
  for (const char* command : {"16", "22", "21", "85", "30", "113", "195"}) {
    CHECK(errors(3, "2", command) == "NoReference");
  }
  CHECK(told(withField(3, "2").replace(withField(3, "2").rfind("149"), 3, "149.5")) == "3.3 NoReference");
  // A command without a place has no frame, whatever the file says.
  CHECK((itemWith(3, "3", "20").frame == CoordinateFrame::Mission));
}

TEST_CASE("a command is a number of 16 bits") {
  CHECK(read(withField(4, "0")).items[0].command == 0);
  CHECK(itemWith(4, "65535").command == 65535);
  CHECK(errors(4, "65536 -16 16.") == "TooLarge BadNumber NotWhole");
}

TEST_CASE("parameters and the altitude are floats; the altitude is a number") {
  for (uint8_t field : {5, 6, 7, 8, 11}) {
    CHECK(errors(field, "3e38 -4e38 1.5x inf") == "ok TooLarge BadNumber BadNumber");
    CHECK(errors(field, "nan") == (field == 11 ? "BadNumber" : "ok"));
  }
}

TEST_CASE("a place is within 90 and 180 degrees") {
  CHECK(itemWith(9, "90").x == 900000000);
  CHECK(itemWith(9, "-90").x == -900000000);
  CHECK(itemWith(10, "180").y == 1800000000);
  CHECK(itemWith(10, "-180").y == -1800000000);
  CHECK(itemWith(10, "90.0000001").y == 900000001);
  CHECK(errors(9, "90.0000001 -90.0000001") == "BeyondLatitude BeyondLatitude");
  CHECK(errors(10, "180.0000001 -180.0000001") == "BeyondLongitude BeyondLongitude");
  for (uint8_t field : {9, 10}) CHECK(errors(field, "300 nan 35d") == "TooLarge BadNumber BadNumber");
}

TEST_CASE("parameters 5 and 6 of a command without a place are whole numbers of any size") {
  CHECK(itemWith(9, "2147483647", "178").x == 2147483647);
  CHECK(itemWith(10, "-2147483648", "178").y == std::numeric_limits<int32_t>::min());
  CHECK(itemWith(9, "0.000", "178").x == 0);
  CHECK(itemWith(9, "47.5", "20").x == 0);  // a place, which a return has not
  for (uint8_t field : {9, 10}) {
    CHECK(errors(field, "0.5", "203") == "NotWhole");
    CHECK(errors(field, "2147483648", "178") == "TooLarge");
  }
}

TEST_CASE("line 0 is home if it is a waypoint or command 0, and else the first item, which alone is a plan") {
  for (int command : {16, 0}) CHECK(planOf(kHeader + line(0, command) + line(1, 22)) == "Mission from 1: 22 0");
  for (int command : {22, 17, 1}) {
    const std::string first = "Mission from 0: " + std::to_string(command) + " 0";
    CHECK(planOf(kHeader + line(0, command) + line(1, 16)) == first + ", 16 0");
    CHECK(planOf(kHeader + line(0, command)) == first);
  }
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
      const Read behindHome = read(kBegin + line(1, one.command) + line(2, other.command));
      CHECK(behindHome.error == (one.type == other.type ? "None" : "4.4 MixedKinds"));
      CHECK((behindHome.type == one.type));
    }
  }
  CHECK(planOf(kHeader + line(0, 5100) + line(1, 5100)) == "Rally from 0: 5100 0, 5100 0");
  CHECK(told(kHeader + line(0, 5100) + line(1, 5001)) == "3.4 MixedKinds");
}

TEST_CASE("a jump's target is the sketch's number of an item that is there") {
  CHECK(planOf(kBegin + line(1, 177, "1") + line(2, 177, "3") + line(3, 16, "7")) ==
        "Mission from 1: 177 0, 177 2, 16 7");
  for (const char* target : {"0", "-1", "1.5", "nan"}) {
    CHECK(told(kBegin + line(1, 177, target) + line(2, 16)) == "3.5 BadTarget");
  }
  // Whether it is there is known at the end; what is told is the line of the farthest jump.
  CHECK(told(kBegin + line(1, 16) + line(2, 177, "3")) == "4.5 BadTarget");
  CHECK(told(kBegin + line(1, 177, "9") + line(2, 177, "9") + line(3, 177, "4")) == "3.5 BadTarget");
  CHECK(told(kBegin + line(1, 177, "8") + line(2, 177, "9") + line(3, 177, "4")) == "4.5 BadTarget");
  // Without home, items are counted from 0 in the file too.
  CHECK(planOf(kHeader + line(0, 177, "0") + line(1, 177, "1")) == "Mission from 0: 177 0, 177 1");
  CHECK(told(kHeader + line(0, 177, "2") + line(1, 16)) == "2.5 BadTarget");
}

TEST_CASE("a line in the middle is read by its number, and has no line number") {
  WaypointsText text;
  Read whole = read(kBegin + line(1, 16) + line(2, 17), text);
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
  CHECK(fed(text, line(2, 16)) == Step::Bad);
  CHECK(errorOf(text) == "0.1 OutOfOrder");
  // And the kind of plan is.
  text.beginAt(2);
  CHECK((text.error() == TextError::None));
  CHECK(fed(text, line(2, 5100)) == Step::Bad);
  CHECK((text.error() == TextError::MixedKinds));
}

TEST_CASE("a line in the middle is read whatever was being read before") {
  for (const char* before : {"", "QGC", "QGC WPL 110\n# comme", "QGC WPL 110\n0 0 3 16 0 0 0 0 0 0", "none"}) {
    WaypointsText text;
    fed(text, before);
    text.beginAt(5);
    CHECK(text.errorField() == 0);
    CHECK(fed(text, line(5, 22)) == Step::Item);
    // Nor is it known which line is bad after it.
    CHECK(fed(text, line(7, 22)) == Step::Bad);
    CHECK(errorOf(text) == "0.1 OutOfOrder");
  }
}

TEST_CASE("a text that is cut off anywhere never gives half an item") {
  const std::string text = kBegin + line(1, 22) + line(2, 177, "1") + line(3, 16, "7.25");
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
  for (char c : kHeader + "0 0 3 16 0 0 0 0 0 0 0 x") CHECK(text.take(c) == Step::More);
  CHECK(text.take('\n') == Step::Bad);
  CHECK(text.errorField() == 12);
}

TEST_CASE("it is known whether a line, or a field of it, has begun") {
  WaypointsText text;
  const auto after = [&text](const std::string& characters) {
    fed(text, characters);
    return std::string(text.isAtLineStart() ? "line start" : "within") + (text.isInField() ? ", in a field" : "");
  };
  CHECK(after("") == "line start");
  CHECK(after(kHeader.substr(0, kHeader.size() - 1)) == "within");
  CHECK(after("\n") == "line start");
  CHECK(after(" ") == "within");
  CHECK(after("0") == "within, in a field");
  CHECK(after("\t") == "within");
  // A line that breaks off within a field is one with too few.
  CHECK(fed(text, "0\n") == Step::Bad);
  CHECK((text.error() == TextError::TooFewFields));
}

TEST_CASE("what a caller finds wrong ends the text") {
  WaypointsText text;
  fed(text, kBegin);
  CHECK(text.fail(TextError::Unreadable) == Step::Bad);
  CHECK((text.error() == TextError::Unreadable));
  CHECK(text.take('1') == Step::Bad);
  CHECK(text.take('\n') == Step::Bad);
  CHECK(text.end() == Step::Bad);
  CHECK((text.error() == TextError::Unreadable));
}

TEST_CASE("a plan has 65534 items at the most, after home and without it") {
  for (int first : {1, 0}) {
    WaypointsText text;
    fed(text, kHeader + ((first == 1 ? kHome : "") + line(first, 22)));
    text.beginAt(static_cast<uint16_t>(65532 + first));  // as if all up to there had been read
    for (int number : {65532 + first, 65533 + first}) {
      CHECK(fed(text, line(number, 22)) == Step::Item);
    }
    CHECK(text.count() == WaypointsText::kMostItems + 0);
    CHECK(fed(text, line(65534 + first, 22)) == Step::Bad);
    CHECK((text.error() == TextError::NoRoom));
  }
}
