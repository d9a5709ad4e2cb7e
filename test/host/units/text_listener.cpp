// A TextListener: which texts are given, when, and what a text of several pieces is when some are lost or repeated.
#include "mavmission/telemetry/TextListener.h"

#include <doctest/doctest.h>
#include <string.h>

#include <string>
#include <vector>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

typedef std::vector<std::string> Texts;

const std::string kFull(50, 'a'), kAlmost(49, 'b');

// Heartbeats come at full seconds; the texts begin half a second after one.
struct Desk : ClientOnLine {
  TextListener texts;
  Texts given;  // each after its severity

  Desk() : ClientOnLine(kPx4), texts(client) {
    texts.onText(note, &given);
    run(3500);
  }

  static void note(void* given, uint8_t severity, const char* text) {
    static_cast<Texts*>(given)->push_back(std::to_string(severity) + " " + text);
  }

  void tell(const std::string& words, uint16_t id = 0, uint8_t piece = 0, uint8_t severity = 6, uint8_t systemId = 1,
            uint8_t componentId = 1) {
    mavlink_statustext_t message = mavlink_statustext_t();
    memcpy(message.text, words.data(), words.size());
    message.id = id;
    message.chunk_seq = piece;
    message.severity = severity;
    FrameParts parts(MAVLINK_MSG_ID_STATUSTEXT, message, MAVLINK_MSG_ID_STATUSTEXT_CRC);
    parts.systemId = systemId;
    parts.componentId = componentId;
    hear(parts);
    while (!line.toRead.empty()) run(1);
  }
};

}  // namespace

TEST_CASE("before the first text there is an empty one, and none is new") {
  Desk desk;
  CHECK(std::string(desk.texts.lastText()).empty());
  CHECK(desk.texts.lastSeverity() == 0);
  CHECK_FALSE(desk.texts.isNew());
  CHECK(desk.given.empty());
}

TEST_CASE("a text is given at once, with its severity, and is new once") {
  Desk desk;
  desk.tell("one", 0, 0, 4);
  CHECK(desk.given == Texts{"4 one"});
  CHECK(std::string(desk.texts.lastText()) == "one");
  CHECK(desk.texts.lastSeverity() == 4);
  CHECK(desk.texts.isNew());
  CHECK_FALSE(desk.texts.isNew());
  desk.tell("one", 0, 0, 0);  // said twice
  desk.tell("", 0, 0, 7);
  CHECK(desk.given == Texts{"4 one", "0 one", "7 "});
  CHECK(std::string(desk.texts.lastText()).empty());
  desk.tell("foreign", 0, 0, 1, 2);
  desk.tell("a camera's", 0, 0, 1, 1, 100);
  CHECK(desk.given.size() == 3);
  desk.run(5000);
  CHECK(desk.given.size() == 3);
}

TEST_CASE("a text that belongs to none is a whole one, also with 50 characters") {
  Desk desk;
  desk.tell(kFull);
  CHECK(desk.given == Texts{"6 " + kFull});
  desk.tell(kFull, 0, 1);
  CHECK(desk.given.size() == 2);
  Bytes payload(51, 'c');  // as in MAVLink 1, which has no pieces
  payload[0] = 3;
  FrameParts parts(MAVLINK_MSG_ID_STATUSTEXT, payload, MAVLINK_MSG_ID_STATUSTEXT_CRC);
  parts.version = 1;
  desk.hear(parts);
  desk.run(5);
  CHECK(desk.given.back() == "3 " + std::string(50, 'c'));
}

TEST_CASE("a piece that is not full is the last one") {
  for (uint16_t number : {1, 2, 0x1234}) {
    CAPTURE(number);
    Desk desk;
    desk.tell(kAlmost, number);
    CHECK(desk.given == Texts{"6 " + kAlmost});
    Desk other;
    other.tell(kFull, number, 0, 3);
    CHECK(other.given.empty());
    CHECK_FALSE(other.texts.isNew());
    CHECK(std::string(other.texts.lastText()) == kFull);
    other.tell(kFull, number, 1, 3);
    CHECK(other.given.empty());
    other.tell("c", number, 2, 3);
    CHECK(other.given == Texts{"3 " + kFull + kFull + "c"});
    CHECK(other.texts.isNew());
  }
}

TEST_CASE("the texts have 150 characters at the most") {
  Desk desk;
  for (uint8_t piece = 0; piece < 3; ++piece) desk.tell(std::string(50, static_cast<char>('a' + piece)), 5, piece);
  const std::string longest = std::string(50, 'a') + std::string(50, 'b') + std::string(50, 'c');
  CHECK(std::string(desk.texts.lastText()) == longest);
  desk.tell("more", 5, 3);
  CHECK(desk.given == Texts{"6 " + longest});
  Desk other;
  other.tell(kFull, 6, 0);
  other.tell(kFull, 6, 2);
  other.tell(kFull, 6, 3);
  other.tell("end", 6, 4);
  CHECK(other.given == Texts{"6 " + kFull + "[...]" + kFull + std::string(45, 'a')});
}

TEST_CASE("pieces that are repeated, or late, are left out, as long as their text may still be repeated") {
  Desk desk;
  desk.tell(kFull, 7, 0);
  desk.tell(kFull, 7, 0);
  desk.tell(kFull, 7, 1);
  desk.tell(kFull, 7, 0);
  desk.tell("end", 7, 2);
  CHECK(desk.given == Texts{"6 " + kFull + kFull + "end"});
  desk.tell("end", 7, 2);
  desk.run(1000);  // a heartbeat
  desk.tell("end", 7, 2);
  desk.tell("end", 7, 3);
  CHECK(desk.given.size() == 1);
  desk.run(1000);  // and the second one: an autopilot that has restarted counts from the beginning
  desk.tell("new", 7, 0);
  CHECK(desk.given.size() == 2);
  CHECK(desk.given.back() == "6 new");
}

TEST_CASE("an autopilot's first long text has any number") {
  Desk desk;
  desk.tell("first", 9);
  desk.run(3000);
  desk.tell("second", 1);
  CHECK(desk.given == Texts{"6 first", "6 second"});
}

TEST_CASE("a text without its end is given at the second heartbeat after its last piece") {
  Desk desk;
  desk.tell(kFull, 8, 0);
  desk.run(1000);
  desk.tell(kFull, 8, 1);
  desk.run(1400);
  CHECK(desk.given.empty());
  CHECK(std::string(desk.texts.lastText()) == kFull + kFull);
  desk.run(200);
  CHECK(desk.given == Texts{"6 " + kFull + kFull + "[...]"});
  CHECK(desk.texts.isNew());
  desk.run(5000);
  CHECK(desk.given.size() == 1);
  // What comes then is another one, and gives nothing of the first.
  desk.tell("late", 8, 2);
  CHECK(desk.given.size() == 2);
  CHECK(desk.given.back() == "6 [...]late");
}

TEST_CASE("heartbeats of others do not end a text") {
  Desk desk;
  desk.beats = false;
  desk.tell(kFull, 8, 0);
  FrameParts other = heartbeatParts(ClientOnLine::kPx4);
  other.systemId = 2;
  for (int i = 0; i < 3; ++i) desk.hear(other);
  desk.run(10);
  CHECK(desk.given.empty());
}

TEST_CASE("a text that begins ends the one before, whose end was lost: the two are never mixed") {
  Desk desk;
  desk.tell(kFull, 8, 0, 2);
  desk.tell(kFull, 9, 0, 5);
  CHECK(desk.given == Texts{"2 " + kFull + "[...]"});
  desk.tell("end", 9, 1, 5);
  CHECK(desk.given == Texts{"2 " + kFull + "[...]", "5 " + kFull + "end"});
  desk.tell(kFull, 10, 0, 2);
  desk.tell("short", 0, 0, 1);
  CHECK(desk.given.size() == 4);
  CHECK(desk.given[2] == "2 " + kFull + "[...]");
  CHECK(desk.given[3] == "1 short");
  desk.tell("lost before", 11, 3);
  CHECK(desk.given.back() == "6 [...]lost before");
}

TEST_CASE("texts are kept without a function that is called") {
  Desk desk;
  desk.texts.onText(nullptr);
  desk.tell("one");
  CHECK(desk.given.empty());
  CHECK(desk.texts.isNew());
  CHECK(std::string(desk.texts.lastText()) == "one");
}
