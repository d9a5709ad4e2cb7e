// A TextListener: which texts are given, when, and what a text of several pieces is when some are lost or repeated.
#include "mavmission/telemetry/TextListener.h"

#include <doctest/doctest.h>
#include <stdio.h>

#include <sstream>
#include <string>

#include "ToldClient.h"

using namespace mavmission;

namespace {

const std::string kFull(50, 'a');

// Heartbeats come at full seconds; the texts begin half a second after one.
struct Desk : ToldClient {
  TextListener texts;
  std::string given;  // each after its severity and before a |; FULL: a text of 50 letters

  Desk() : ToldClient(kPx4), texts(client) {
    texts.onText(note, &given);
    run(3500);
  }

  // What is given when this is heard, one after the other: "one"; "3: 7/0 one", with this severity (6), piece 0 of text
  // 7; and "wait 1000": so many ms pass.
  std::string hears(const std::string& script) {
    given.clear();
    std::istringstream all(script);
    for (std::string one; std::getline(all >> std::ws, one, ',');) {
      unsigned severity = 6, number = 0, piece = 0, ms = 0;
      int before = 0, words = 0;
      if (sscanf(one.c_str(), "wait %u", &ms) == 1) {
        run(ms);
        continue;
      }
      if (sscanf(one.c_str(), "%u: %n", &severity, &before) != 1 || before == 0) severity = 6, before = 0;
      if (sscanf(one.c_str() + before, "%u/%u %n", &number, &piece, &words) != 2) number = piece = 0;
      const std::string text = one.substr(static_cast<size_t>(before + words));
      tell("STATUSTEXT severity " + std::to_string(severity) + " id " + std::to_string(number) + " chunk_seq " +
           std::to_string(piece) + " text " + (text == "FULL" ? kFull : text));
    }
    return given;
  }
  std::string last() const { return shortened(texts.lastText()); }

 private:
  static std::string shortened(std::string text) {
    for (size_t at; (at = text.find(kFull)) != std::string::npos;) text.replace(at, kFull.size(), "FULL");
    return text;
  }
  static void note(void* given, uint8_t severity, const char* text) {
    *static_cast<std::string*>(given) += std::to_string(severity) + " " + shortened(text) + "|";
  }
};

}  // namespace

TEST_CASE("before the first text there is an empty one, and none is new") {
  Desk desk;
  CHECK(desk.last() == "");
  CHECK(desk.texts.lastSeverity() == 0);
  CHECK_FALSE(desk.texts.isNew());
  CHECK(desk.given.empty());
}

TEST_CASE("a text is given at once, with its severity, and is new once; others' are not") {
  Desk desk;
  CHECK(desk.hears("4: one") == "4 one|");
  CHECK(desk.last() == "one");
  CHECK(desk.texts.lastSeverity() == 4);
  CHECK(desk.texts.isNew());
  CHECK_FALSE(desk.texts.isNew());
  CHECK(desk.hears("0: one, 7: 0/0 ") == "0 one|7 |");  // said twice, and an empty one
  CHECK(desk.last() == "");
  desk.tell("STATUSTEXT text foreign", 2);
  desk.tell("STATUSTEXT text a camera's", 1, 100);
  CHECK(desk.hears("wait 5000") == "");
}

TEST_CASE("a text that belongs to none is a whole one, also with 50 characters, and as MAVLink 1 has it") {
  Desk desk;
  CHECK(desk.hears("FULL, 0/1 FULL") == "6 FULL|6 [...]FULL|");
  desk.tell(messagePartsV1("STATUSTEXT severity 3 text " + std::string(50, 'c')));
  CHECK(desk.given == "6 FULL|6 [...]FULL|3 " + std::string(50, 'c') + "|");
}

TEST_CASE("a piece that is not full is the last one") {
  for (const std::string number : {"1", "2", "4660"}) {
    CAPTURE(number);
    const std::string almost(49, 'b');
    CHECK(Desk().hears(number + "/0 " + almost) == "6 " + almost + "|");
    Desk desk;
    CHECK(desk.hears("3: " + number + "/0 FULL") == "");
    CHECK_FALSE(desk.texts.isNew());
    CHECK(desk.last() == "FULL");
    CHECK(desk.hears("3: " + number + "/1 FULL") == "");
    CHECK(desk.hears("3: " + number + "/2 c") == "3 FULLFULLc|");
    CHECK(desk.texts.isNew());
  }
}

TEST_CASE("the texts have 150 characters at the most") {
  const std::string b(50, 'b'), c(50, 'c');
  Desk desk;
  desk.hears("5/0 FULL, 5/1 " + b + ", 5/2 " + c);
  CHECK(desk.last() == "FULL" + b + c);
  CHECK(desk.given == "");
  CHECK(desk.hears("5/3 more") == "6 FULL" + b + c + "|");
  CHECK(Desk().hears("6/0 FULL, 6/2 FULL, 6/3 FULL, 6/4 end") == "6 FULL[...]FULL" + std::string(45, 'a') + "|");
}

TEST_CASE("pieces that are repeated, or late, are left out, as long as their text may still be repeated") {
  Desk desk;
  CHECK(desk.hears("7/0 FULL, 7/0 FULL, 7/1 FULL, 7/0 FULL, 7/2 end") == "6 FULLFULLend|");
  CHECK(desk.hears("7/2 end, wait 1000, 7/2 end, 7/3 end") == "");  // after a heartbeat
  // After the second one: an autopilot that has restarted counts from the beginning.
  CHECK(desk.hears("wait 1000, 7/0 new") == "6 new|");
}

TEST_CASE("an autopilot's first long text has any number") {
  CHECK(Desk().hears("9/0 first, wait 3000, 1/0 second") == "6 first|6 second|");
}

TEST_CASE("a text without its end is given at the second heartbeat after its last piece") {
  Desk desk;
  CHECK(desk.hears("8/0 FULL, wait 1000, 8/1 FULL, wait 1400") == "");
  CHECK(desk.last() == "FULLFULL");
  CHECK(desk.hears("wait 200") == "6 FULLFULL[...]|");
  CHECK(desk.texts.isNew());
  // What comes then is another one, and gives nothing of the first.
  CHECK(desk.hears("wait 5000, 8/2 late") == "6 [...]late|");
}

TEST_CASE("heartbeats of others do not end a text") {
  Desk desk;
  desk.beats = false;
  desk.hears("8/0 FULL");
  for (int i = 0; i < 3; ++i) desk.tell("HEARTBEAT autopilot 12 type 2 mavlink_version 3", 2);
  CHECK(desk.hears("wait 10") == "");
}

TEST_CASE("a text that begins ends the one before, whose end was lost: the two are never mixed") {
  Desk desk;
  CHECK(desk.hears("2: 8/0 FULL, 5: 9/0 FULL") == "2 FULL[...]|");
  CHECK(desk.hears("5: 9/1 end") == "5 FULLend|");
  CHECK(desk.hears("2: 10/0 FULL, 1: short") == "2 FULL[...]|1 short|");
  CHECK(desk.hears("11/3 lost before") == "6 [...]lost before|");
}

TEST_CASE("texts are kept without a function that is called") {
  Desk desk;
  desk.texts.onText(nullptr);
  CHECK(desk.hears("one") == "");
  CHECK(desk.texts.isNew());
  CHECK(desk.last() == "one");
}
