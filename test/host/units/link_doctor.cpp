// A LinkDoctor beside a client: what it says of a line, in which second, and what it sends to find that out.
#include "mavmission/service/LinkDoctor.h"

#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>
#include <string>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

constexpr uint16_t kCommandLong = MAVLINK_MSG_ID_COMMAND_LONG;
constexpr uint8_t kCopter = MAV_TYPE_QUADROTOR, kStation = MAV_TYPE_GCS, kBoard = MAV_TYPE_ONBOARD_CONTROLLER;
constexpr uint8_t kAutopilot = MAV_AUTOPILOT_GENERIC_MISSION_FULL, kNoAutopilot = MAV_AUTOPILOT_INVALID;
constexpr uint32_t kAlways = 0xFFFFFFFF;

const char* nameOf(Verdict verdict) {
#define MAVMISSION_NAME(name, text) #name,
  static const char* const kNames[] = {MAVMISSION_VERDICTS(MAVMISSION_NAME)};
#undef MAVMISSION_NAME
  return kNames[static_cast<uint8_t>(verdict)];
}

void append(std::string& list, uint32_t number, const std::string& word = "") {
  list += (list.empty() ? "" : ", ") + std::to_string(number) + word;
}

// A line on which nobody is, unless the test says who.
struct Desk : ClientOnLine {
  LinkDoctor doctor;
  const uint32_t beganMs;
  std::string history;  // each change of the verdict, behind the milliseconds since the beginning
  std::string opened;   // the rates that were opened, in the same way
  std::string own;      // who sends what, of the doctor's own messages: each that is another one than the last

  uint32_t answers = 0;    // so many questions are answered
  uint32_t telemetry = 0;  // so many messages that nobody wants come each second
  bool echoes = false;     // what we send comes back
  Bytes garbage;           // that comes every 100 ms
  uint32_t baud = 57600;   // of the port
  uint32_t goodBaud = 0;   // an autopilot is heard at this one, twice a second

  explicit Desk(uint8_t autopilot = kArduPilot) : ClientOnLine(autopilot), doctor(client), beganMs(nowMs()) {
    beats = false;
  }

  uint32_t sinceMs() const { return nowMs() - beganMs; }

  // As loop() does, each `step` ms. The peer's messages come behind that.
  void pass(uint32_t ms, uint32_t step = 1) {
    for (; ms != 0; ms -= step) turn(step);
  }
  void turn(uint32_t step) {
    const Verdict before = doctor.verdict();
    const Verdict verdict = doctor.update();
    if (verdict != before) append(history, sinceMs(), std::string(" ") + nameOf(verdict));
    client.update();
    noteOwn(line.written);
    if (echoes) line.bring(line.written);
    if (!garbage.empty() && sinceMs() % 100 == 0) line.bring(garbage);
    if (sinceMs() % 10 == 0 && sinceMs() % 1000 / 10 < telemetry) hear(partsOf(1, 1));
    if (baud == goodBaud && sinceMs() % 500 == 0) hear(heartbeatParts(kArduPilot));
    const size_t sentBefore = sent.size();
    run(step, step);
    for (size_t i = sentBefore; i < sent.size(); ++i) {
      if (!isQuestion(sent[i]) || answers == 0) continue;
      if (answers != kAlways) --answers;
      answer(MAV_CMD_REQUEST_MESSAGE);
    }
  }

  // The request for AUTOPILOT_VERSION.
  static bool isQuestion(const SentFrame& frame) {
    mavlink_command_long_t command;
    memcpy(&command, frame.payload.data(), sizeof(command));
    return frame.messageId == kCommandLong && command.command == MAV_CMD_REQUEST_MESSAGE &&
           command.param1 == MAVLINK_MSG_ID_AUTOPILOT_VERSION;
  }
  std::string questions() const {
    std::string times;
    for (const SentFrame& frame : sent) {
      if (isQuestion(frame)) append(times, frame.atMs - beganMs);
    }
    return times;
  }
  std::string heartbeats() const {
    std::string times;
    for (uint32_t atMs : timesOf(MAVLINK_MSG_ID_HEARTBEAT, beganMs)) append(times, atMs);
    return times;
  }
  void noteOwn(const Bytes& bytes) {
    for (size_t i = 0; i + 10 < bytes.size() && bytes[i] == 0xFD; i += 10u + bytes[i + 1] + 2u) {
      const std::string one = std::to_string(bytes[i + 5]) + "/" + std::to_string(bytes[i + 6]) +
                              (bytes[i + 7] == MAVLINK_MSG_ID_HEARTBEAT ? " beats" : " asks");
      const bool isSame = own.size() >= one.size() && own.substr(own.size() - one.size()) == one;
      if (!isSame) own += (own.empty() ? "" : ", ") + one;
    }
  }

  void answer(uint16_t command, uint8_t targetSystem = 1, uint8_t targetComponent = 191) {
    const uint8_t low = static_cast<uint8_t>(command), high = static_cast<uint8_t>(command >> 8);
    hear(FrameParts(MAVLINK_MSG_ID_COMMAND_ACK, {low, high, 0, 0, 0, 0, 0, 0, targetSystem, targetComponent},
                    MAVLINK_MSG_ID_COMMAND_ACK_CRC));
  }
  void beat(uint8_t systemId, uint8_t componentId, uint8_t autopilot, uint8_t type, uint32_t customMode = 0,
            bool isSigned = false) {
    mavlink_heartbeat_t message = mavlink_heartbeat_t();
    message.custom_mode = customMode;
    message.type = type;
    message.autopilot = autopilot;
    Bytes payload(sizeof(message));
    memcpy(payload.data(), &message, sizeof(message));
    FrameParts parts(MAVLINK_MSG_ID_HEARTBEAT, payload, MAVLINK_MSG_ID_HEARTBEAT_CRC);
    parts.systemId = systemId;
    parts.componentId = componentId;
    parts.incompatibility = isSigned;
    hear(parts);
  }
  void chatter(uint32_t count, uint8_t systemId = 1, uint8_t componentId = 1) {
    for (; count != 0; --count) {
      hear(partsOf(systemId, componentId));
      pass(10);
    }
  }
  static FrameParts partsOf(uint8_t systemId, uint8_t componentId) {
    FrameParts parts(MAVLINK_MSG_ID_ATTITUDE, Bytes(28, 0x11), MAVLINK_MSG_ID_ATTITUDE_CRC);
    parts.systemId = systemId;
    parts.componentId = componentId;
    return parts;
  }
  // A frame with a checksum that is wrong.
  void damaged() {
    Bytes bytes = packed(heartbeatParts(kArduPilot));
    bytes.back() ^= 0xFF;
    line.bring(bytes);
    pass(10);
  }
  // The beginning of a frame that nobody wants; its end is lost.
  void broken() {
    Bytes bytes = packed(partsOf(1, 1));
    bytes.resize(20);
    line.bring(bytes);
    pass(100);
  }

  void tryBauds(uint32_t rate) {
    baud = rate;
    doctor.tryBauds(open, rate, this);
  }
  static void open(void* context, uint32_t rate) {
    Desk& desk = *static_cast<Desk*>(context);
    desk.baud = rate;
    append(desk.opened, desk.sinceMs(), " " + std::to_string(rate));
  }

  bool isSpeaker(uint8_t systemId, uint8_t componentId, uint8_t type) const {
    const Speaker& it = doctor.speaker();
    return it.systemId == systemId && it.componentId == componentId && it.type == type;
  }
};

// An autopilot that is heard, and answers.
struct Well : Desk {
  Well() {
    beats = true;
    answers = kAlways;
  }
};

const Bytes kText(7, 'U');

}  // namespace

// --- The wire

TEST_CASE("a line without bytes is known as such after 3 s") {
  Desk desk;
  CHECK((desk.doctor.verdict() == Verdict::Listening));
  desk.pass(400000, 10);
  CHECK(desk.history == "3000 NoBytes");
  CHECK(desk.isSpeaker(0, 0, 0));
  CHECK(desk.doctor.baud() == 0);
}

TEST_CASE("bytes that begin later, or again, are listened to anew") {
  Desk desk;
  desk.pass(10000);
  desk.beats = true;
  desk.answers = kAlways;
  desk.pass(10000);
  desk.beats = false;
  desk.answers = 0;
  desk.pass(10000);
  CHECK(desk.history == "3000 NoBytes, 11000 Listening, 15000 Quiet, 23000 NoBytes");
}

TEST_CASE("our own frames that come back are known by what they say") {
  Desk desk;
  desk.echoes = true;
  desk.pass(10000);
  CHECK(desk.history == "4000 OnlyEcho");
  CHECK(desk.isSpeaker(0, 0, 0));
  desk.echoes = false;
  desk.pass(10000);
  CHECK(desk.history == "4000 OnlyEcho, 13000 NoBytes");
}

TEST_CASE("an echo beside others is no fault of the wire: who sends is told") {
  Desk desk;
  desk.echoes = true;
  for (int second = 0; second < 12; ++second) {
    if (second < 5) desk.beat(255, 190, kNoAutopilot, kStation);
    desk.pass(1000);
  }
  CHECK(desk.history == "4000 NoAutopilot, 8000 OnlyEcho");
  CHECK(desk.isSpeaker(255, 190, kStation));
}

TEST_CASE("an echo that has ended more than 3 s ago is none, while another board's frames come") {
  Desk desk;
  desk.echoes = true;
  desk.pass(5000);
  desk.echoes = false;
  for (int second = 0; second < 8; ++second) {
    desk.beat(1, 191, kNoAutopilot, kBoard, 0x4D4D0000);  // a doctor's, too, but its mark is another one
    desk.pass(1000);
  }
  CHECK(desk.history == "4000 OnlyEcho, 8000 NoAutopilot");
  CHECK(desk.isSpeaker(0, 0, 0));
}

TEST_CASE("bytes that are no frames are told after 3 s, and frames that come then after 4 more") {
  Desk desk;
  desk.garbage = kText;
  desk.pass(10000);
  CHECK(desk.history == "3000 NoFrames");
  desk.garbage.clear();
  desk.beats = true;
  desk.answers = kAlways;
  desk.pass(10000);
  CHECK(desk.history == "3000 NoFrames, 11000 Listening, 15000 Quiet");
}

TEST_CASE("frames that end while bytes still come are missed after 3 s; an end of both is one of the bytes") {
  Well ends;
  ends.pass(10000);
  ends.beats = false;
  ends.answers = 0;
  ends.garbage = kText;
  ends.pass(5000);
  CHECK(ends.history == "4000 Quiet, 13000 NoFrames");
  Well both;
  both.tryBauds(57600);
  both.pass(10000);
  both.beats = false;
  both.answers = 0;
  both.garbage = kText;
  both.pass(900);
  both.garbage.clear();
  both.pass(9100);
  CHECK(both.history == "4000 Quiet, 14000 NoBytes");
  CHECK(both.opened.empty());
}

TEST_CASE("bytes that end 2 s before the frames are missed are none of a wrong rate's, and 1 s less are") {
  for (uint32_t garbageMs : {900u, 1900u, 2900u}) {
    CAPTURE(garbageMs);
    Well desk;
    desk.pass(10000);
    desk.beats = false;
    desk.answers = 0;
    desk.garbage = kText;
    desk.pass(garbageMs);
    desk.garbage.clear();
    desk.pass(8000);
    const char* const kHistories[] = {"4000 Quiet, 14000 NoBytes", "4000 Quiet, 13000 NoFrames, 15000 NoBytes",
                                      "4000 Quiet, 13000 NoFrames, 16000 NoBytes"};
    CHECK(desk.history == kHistories[garbageMs / 1000]);
  }
}

TEST_CASE("frames of which each second one is lost are listened to for 4 s as well") {
  Desk desk;
  desk.garbage = kText;
  desk.pass(10000);
  desk.garbage.clear();
  for (int i = 0; i < 4; ++i) {
    desk.hear(heartbeatParts(ClientOnLine::kArduPilot));
    desk.pass(2000);
  }
  CHECK(desk.history == "3000 NoFrames, 11000 Listening, 15000 NotHeard");
}

TEST_CASE("a fault is forgotten with the line on which it was") {
  Well desk;
  desk.pass(8500);
  for (int i = 0; i < 3; ++i) desk.damaged();
  desk.pass(3600);
  desk.beats = false;
  desk.answers = 0;
  desk.pass(5900);
  desk.beats = true;
  desk.answers = kAlways;
  desk.pass(2500);
  desk.damaged();
  desk.pass(6000);
  CHECK(desk.history == "4000 Quiet, 12000 Damaged, 16000 NoBytes, 20000 Listening, 24000 Quiet");
}

// --- The rates

TEST_CASE("each rate is listened to for 3 s, the own one for 4, and all of them again and again") {
  Desk desk;
  desk.tryBauds(57600);
  CHECK(desk.doctor.baud() == 57600);
  desk.garbage = kText;
  desk.pass(32000);
  CHECK(desk.history == "3000 TryingBauds, 27000 NoFramesAtAnyBaud");
  CHECK(desk.opened ==
        "3000 115200, 6000 921600, 9000 38400, 12000 230400, 15000 460800, 18000 500000, 21000 19200, 24000 9600, "
        "27000 57600, 31000 115200");
  CHECK(desk.doctor.baud() == 115200);
  // Heartbeats leave at the own rate alone: at another one they would be garbage to the other end.
  CHECK(desk.heartbeats() == "1, 1001, 2001, 27001, 28001, 29001, 30001");
}

TEST_CASE("a rate of the sketch's own that no list has comes back behind all nine others") {
  Desk desk;
  desk.tryBauds(100000);
  desk.garbage = kText;
  desk.pass(31000);
  CHECK(desk.opened ==
        "3000 57600, 6000 115200, 9000 921600, 12000 38400, 15000 230400, 18000 460800, 21000 500000, 24000 19200, "
        "27000 9600, 30000 100000");
  CHECK(desk.history == "3000 TryingBauds, 30000 NoFramesAtAnyBaud");
}

TEST_CASE("at the rate at which frames come the port stays, until none have come for more than 5 s") {
  Desk desk;
  desk.tryBauds(57600);
  desk.garbage = kText;
  desk.goodBaud = 921600;
  desk.pass(20000);
  CHECK(desk.history == "3000 TryingBauds, 7000 WrongBaud");
  CHECK(desk.opened == "3000 115200, 6000 921600");
  CHECK(desk.doctor.baud() == 921600);
  CHECK(desk.questions().empty());
  desk.goodBaud = 0;
  desk.pass(10000);
  CHECK(desk.history == "3000 TryingBauds, 7000 WrongBaud, 25000 Listening, 29000 TryingBauds");
  CHECK(desk.opened == "3000 115200, 6000 921600, 25000 57600, 29000 115200");
}

TEST_CASE("what was tried in vain is forgotten when the bytes end, or frames come") {
  Desk desk;
  desk.tryBauds(57600);
  desk.garbage = kText;
  desk.pass(27500);
  desk.garbage.clear();
  desk.pass(12500);
  desk.garbage = kText;
  desk.pass(6000);
  CHECK(desk.history == "3000 TryingBauds, 27000 NoFramesAtAnyBaud, 31000 NoBytes, 41000 Listening, 45000 TryingBauds");
  Desk other;
  other.tryBauds(57600);
  other.garbage = kText;
  other.pass(28000);
  other.beats = true;
  other.garbage.clear();
  other.answers = kAlways;
  other.pass(6000);
  other.beats = false;
  other.garbage = kText;
  other.pass(6000);
  CHECK(other.history == "3000 TryingBauds, 27000 NoFramesAtAnyBaud, 29000 Listening, 33000 Quiet, 38000 TryingBauds");
}

TEST_CASE("with a loop that is late no rate is tried: bytes are lost at each") {
  for (uint8_t waiting : {62, 63}) {
    CAPTURE(waiting);
    Desk desk;
    desk.tryBauds(57600);
    for (int second = 0; second < 10; ++second) {
      if (second < 6) desk.line.bring(Bytes(waiting, 'U'));
      desk.turn(1);
      desk.garbage = kText;
      desk.pass(999);
    }
    CHECK(desk.history == (waiting == 63 ? "3000 LoopLate, 8000 TryingBauds" : "3000 TryingBauds"));
  }
}

// --- Damage

TEST_CASE("three damaged frames within 4 s are a fault, and two are none") {
  for (uint32_t count : {1u, 2u, 3u}) {
    CAPTURE(count);
    Well desk;
    desk.pass(8500);
    for (uint32_t i = 0; i < count; ++i) {
      desk.damaged();
      desk.pass(1000);
    }
    desk.pass(8000);
    CHECK(desk.history == (count == 3 ? "4000 Quiet, 12000 Damaged, 16000 Quiet" : "4000 Quiet"));
  }
}

TEST_CASE("the fault lasts until nothing is damaged for 4 s") {
  Well desk;
  desk.pass(8500);
  for (int i = 0; i < 3; ++i) desk.damaged();
  desk.pass(5000);
  desk.damaged();
  desk.pass(4000);
  desk.damaged();
  desk.pass(10000);
  CHECK(desk.history == "4000 Quiet, 12000 Damaged, 24000 Quiet");
}

TEST_CASE("frames that are cut short are damaged, too") {
  Well desk;
  desk.pass(8500);
  for (int i = 0; i < 3; ++i) desk.broken();
  desk.pass(8000);
  CHECK(desk.history == "4000 Quiet, 12000 Damaged, 16000 Quiet");
}

TEST_CASE("what came before the first frame is no damage: another rate, or a boot loader's text") {
  Well desk;
  desk.beats = false;
  for (int i = 0; i < 5; ++i) desk.damaged();
  desk.pass(500);
  desk.beats = true;
  desk.pass(10000);
  CHECK(desk.history == "5000 Quiet");
}

TEST_CASE("frames that are damaged while the loop is late are its fault") {
  for (uint32_t lateMs : {8001u, 8000u}) {
    CAPTURE(lateMs);
    Well desk;
    desk.pass(lateMs);
    desk.line.bring(Bytes(63, 'U'));
    desk.pass(8500 - lateMs);
    for (int i = 0; i < 3; ++i) desk.damaged();
    desk.pass(5000);
    CHECK(desk.history == (lateMs == 8000 ? "4000 Quiet, 12000 Damaged" : "4000 Quiet, 12000 LoopLate"));
  }
}

// --- Who sends

TEST_CASE("a station alone is no autopilot; who it is is told") {
  Desk desk;
  for (int second = 0; second < 400; ++second) {
    desk.beat(255, 190, kNoAutopilot, kStation);
    desk.pass(1000, 10);
  }
  CHECK(desk.history == "4000 NoAutopilot");
  CHECK(desk.isSpeaker(255, 190, kStation));
  CHECK(desk.questions().empty());
}

TEST_CASE("a sender without heartbeats is believed when eight of its frames come within 4 s") {
  for (uint32_t count : {7u, 8u}) {
    Desk desk;
    desk.pass(10);
    desk.chatter(count, 42, 77);
    desk.pass(4990);
    CHECK(desk.history == (count == 8 ? "3000 NoAutopilot, 4000 NoBytes" : "4000 NoBytes"));
    CHECK(desk.isSpeaker(count == 8 ? 42 : 0, count == 8 ? 77 : 0, 0));
  }
}

TEST_CASE("frames of which a quarter does not end where it should are garbage") {
  const struct {
    uint32_t whole, cut;
    bool isBelieved;
  } kCases[] = {{8, 1, true},   {8, 2, false}, {8, 3, false}, {12, 2, true},
                {12, 3, false}, {16, 3, true}, {16, 4, false}};
  for (const auto& one : kCases) {
    Desk desk;
    desk.pass(10);
    for (uint32_t i = 0; i < one.cut; ++i) desk.broken();
    desk.chatter(one.whole, 42, 77);
    desk.pass(2900 - 100 * one.cut);
    CHECK(desk.isSpeaker(one.isBelieved ? 42 : 0, one.isBelieved ? 77 : 0, 0));
  }
  // What was broken more than 4 s ago does not count.
  Desk later;
  for (int i = 0; i < 3; ++i) later.broken();
  later.garbage = kText;
  later.pass(3800);
  later.garbage.clear();
  later.chatter(8, 42, 77);
  later.pass(1500);
  CHECK(later.isSpeaker(42, 77, 0));
}

TEST_CASE("a sender without heartbeats is believed for as long as one with them") {
  Desk desk;
  desk.chatter(8, 42, 77);
  desk.garbage = kText;
  desk.pass(8000);
  CHECK(desk.history == "3000 NoAutopilot, 6000 NoFrames");
}

TEST_CASE("a sender without heartbeats is told when autopilot and others have been silent for more than 5 s") {
  for (bool isAutopilot : {true, false}) {
    CAPTURE(isAutopilot);
    Desk desk;
    for (int tenths = 0; tenths < 148; ++tenths) {
      if (tenths % 10 == 0 && tenths <= 90) {
        isAutopilot ? desk.beat(1, 1, kAutopilot, kCopter) : desk.beat(255, 190, kNoAutopilot, kStation);
      }
      desk.chatter(1, 42, 77);
      desk.pass(90);
    }
    CHECK(desk.isSpeaker(isAutopilot ? 0 : 255, isAutopilot ? 0 : 190, isAutopilot ? 0 : uint8_t{kStation}));
    desk.chatter(1, 42, 77);
    desk.pass(300);
    CHECK(desk.isSpeaker(42, 77, 0));
  }
  // Our own frames that come back are nobody's.
  Desk echo;
  for (int tenths = 0; tenths < 60; ++tenths) {
    echo.chatter(1, 1, 191);
    echo.pass(90);
  }
  CHECK(echo.isSpeaker(0, 0, 0));
}

TEST_CASE("the last sender but the client's autopilot is told, and is no fault beside it") {
  Well desk;
  for (int second = 0; second < 10; ++second) {
    desk.beat(255, 190, kNoAutopilot, kStation);
    desk.chatter(1, 42, 77);
    desk.pass(1000);
  }
  CHECK(desk.history == "4000 Quiet");
  CHECK(desk.isSpeaker(255, 190, kStation));
  desk.beat(1, 154, kNoAutopilot, MAV_TYPE_GIMBAL);
  desk.pass(10);
  CHECK(desk.isSpeaker(1, 154, MAV_TYPE_GIMBAL));
}

TEST_CASE("two autopilots are told, and nothing is sent to either; named ones are one") {
  Desk desk;
  const auto both = [&desk](int seconds) {
    for (; seconds != 0; --seconds) {
      desk.beat(1, 1, kAutopilot, kCopter);
      desk.beat(2, 1, kAutopilot, kCopter);
      desk.pass(1000);
    }
  };
  both(8);
  CHECK(desk.history == "4000 SeveralAutopilots");
  CHECK(desk.isSpeaker(2, 1, kCopter));
  CHECK(desk.questions().empty());
  const std::string before = desk.heartbeats();
  both(2);
  CHECK(desk.heartbeats() == before);
  desk.client.setTargetIds(2);
  desk.answers = 0;
  both(3);
  CHECK(desk.isSpeaker(1, 1, kCopter));
  CHECK_FALSE(desk.questions().empty());
}

TEST_CASE("an autopilot that is not the one named is another one, and none when it is gone") {
  Desk desk;
  desk.client.setTargetIds(9, 1);
  for (int second = 0; second < 8; ++second) {
    desk.beat(1, 1, kAutopilot, kCopter);
    desk.pass(1000);
  }
  CHECK(desk.history == "4000 OtherAutopilot");
  CHECK(desk.isSpeaker(1, 1, kCopter));
  for (int second = 0; second < 8; ++second) {
    desk.beat(255, 190, kNoAutopilot, kStation);
    desk.pass(1000);
  }
  CHECK(desk.history == "4000 OtherAutopilot, 13000 NoAutopilot");
  CHECK(desk.isSpeaker(255, 190, kStation));
}

TEST_CASE("another autopilot than the one named counts as heard for 3 s") {
  for (uint32_t heardMs : {900u, 1100u}) {
    Desk desk;
    desk.client.setTargetIds(9, 1);
    for (uint32_t ms = 0; ms < 4500; ms += 100) {
      if (ms % 1000 == 0) desk.beat(255, 190, kNoAutopilot, kStation);
      if (ms == heardMs) desk.beat(1, 1, kAutopilot, kCopter);
      desk.pass(100);
    }
    CHECK((desk.doctor.verdict() == (heardMs == 1100 ? Verdict::OtherAutopilot : Verdict::Listening)));
  }
}

TEST_CASE("an autopilot with our own ids does not hear us") {
  Desk desk;
  desk.client.setSourceIds(1, 1);
  desk.beats = true;
  desk.pass(8000);
  CHECK(desk.history == "4000 SameIds");
  CHECK(desk.isSpeaker(0, 0, 0));
}

// --- Whether we are heard

TEST_CASE("all is well: every 4 s it is judged anew whether much telemetry comes") {
  for (uint32_t telemetry : {3u, 4u}) {
    Well desk;
    desk.telemetry = telemetry;
    desk.pass(9000);
    // With 4 heartbeats, an answer, and 12 or 16 others; not all of the first 4 s were counted.
    CHECK(desk.history == (telemetry == 4 ? "4000 Quiet, 8000 Well" : "4000 Quiet"));
    CHECK(isWell(desk.doctor.verdict()));
  }
  for (uint32_t count : {15u, 16u}) {
    Well desk;
    desk.pass(12500);
    desk.chatter(count);
    desk.pass(8000);
    CHECK(desk.history == (count == 16 ? "4000 Quiet, 16000 Well, 20000 Quiet" : "4000 Quiet"));
  }
}

TEST_CASE("an autopilot that answers is asked every 5 s, and one that does not every second") {
  Well desk;
  desk.answers = 2;
  desk.pass(15500);
  CHECK(desk.questions() == "1001, 6001, 11001, 12001, 13001, 14001, 15001");
  CHECK(desk.history == "4000 Quiet, 15000 NotHeard");
  desk.answers = kAlways;
  desk.pass(6500);
  CHECK(desk.history == "4000 Quiet, 15000 NotHeard, 17000 Quiet");
  CHECK(desk.questions() == "1001, 6001, 11001, 12001, 13001, 14001, 15001, 16001, 21001");
}

TEST_CASE("an autopilot that never answers does not hear us, however long that lasts") {
  Desk desk;
  desk.beats = true;
  desk.pass(4500);
  CHECK((desk.doctor.verdict() == Verdict::Listening));
  desk.pass(300000, 10);
  CHECK(desk.history == "5000 NotHeard");
}

TEST_CASE("one that signs and does not answer takes signed messages alone") {
  Desk desk;
  for (int second = 0; second < 12; ++second) {
    desk.beat(1, 1, kAutopilot, kCopter, 0, second < 8);
    desk.pass(1000);
  }
  CHECK(desk.history == "5000 Signing, 11000 NotHeard");
}

TEST_CASE("an answer is a message for us, or that to our own question where it has no target") {
  const struct {
    uint16_t command;
    uint8_t system, component;
    bool isAnswer;
  } kCases[] = {
      {MAV_CMD_REQUEST_MESSAGE, 1, 191, true},       {MAV_CMD_REQUEST_MESSAGE, 0, 0, true},
      {MAV_CMD_REQUEST_MESSAGE, 255, 190, false},    {MAV_CMD_REQUEST_MESSAGE, 1, 192, false},
      {MAV_CMD_SET_MESSAGE_INTERVAL, 1, 191, false}, {MAV_CMD_REQUEST_MESSAGE + 1, 1, 191, false},
  };
  for (const auto& one : kCases) {
    CAPTURE(one.command);
    CAPTURE(int{one.system});
    Desk desk;
    desk.beats = true;
    for (int second = 0; second < 8; ++second) {
      desk.pass(500);
      desk.answer(one.command, one.system, one.component);
      desk.pass(500);
    }
    CHECK(desk.history == (one.isAnswer ? "4000 Quiet" : "5000 NotHeard"));
  }
}

TEST_CASE("of the mission's messages those for us show that we are heard, and a MISSION_CURRENT does not") {
  for (bool isAck : {true, false}) {
    Desk desk;
    desk.beats = true;
    for (int second = 0; second < 8; ++second) {
      desk.pass(500);
      desk.hear(isAck ? ackParts(0) : FrameParts(MAVLINK_MSG_ID_MISSION_CURRENT, Bytes(6, 0), 28));
      desk.pass(500);
    }
    CHECK(desk.history == (isAck ? "4000 Quiet" : "5000 NotHeard"));
  }
}

TEST_CASE("nothing is asked while an operation of the client's transfers") {
  Well desk;
  desk.pass(5500);
  desk.client.setMessageInterval(30, 100000);
  desk.pass(7000);
  REQUIRE((desk.client.status() == Status::Transferring));
  CHECK(desk.questions() == "1001");
  desk.pass(2000);
  CHECK(desk.questions() == "1001, 14001");
}

TEST_CASE("without room to send a question waits, and is asked only once") {
  Well desk;
  desk.pass(5500);
  desk.line.room = 0;
  desk.pass(4000);
  CHECK(desk.questions() == "1001");
  desk.line.room = MemoryStream::kAlwaysRoom;
  desk.pass(1000);
  CHECK(desk.history == "4000 Quiet");
}

// --- What is sent

TEST_CASE("before an autopilot is heard a heartbeat leaves each second, with the ids of an onboard computer") {
  Desk desk;
  desk.pass(3500);
  CHECK(desk.heartbeats() == "1, 1001, 2001, 3001");
  CHECK(desk.own == "1/191 beats");
  desk.beat(7, 1, kAutopilot, kCopter);
  desk.pass(1000);
  CHECK(desk.own == "1/191 beats, 7/191 asks");
  Desk named;
  named.client.setSourceIds(33, 44);
  named.pass(2000);
  CHECK(named.own == "33/44 beats");
}

// --- Time

TEST_CASE("seconds that a late loop has missed are not counted") {
  Desk slow;
  slow.pass(30000, 3000);
  CHECK(slow.history == "9000 NoBytes");
  Desk late;
  late.turn(1300);
  late.pass(5200, 1300);
  CHECK(late.history == "3900 NoBytes");
  for (uint32_t gapMs : {1999u, 2000u}) {
    Desk desk;
    desk.turn(gapMs);
    desk.pass(5000);
    CHECK(desk.history == (gapMs == 1999 ? "3000 NoBytes" : "4000 NoBytes"));
  }
}

TEST_CASE("each verdict has its text") {
#define MAVMISSION_NAME(name, text) CHECK(strcmp(reinterpret_cast<const char*>(toString(Verdict::name)), text) == 0);
  MAVMISSION_VERDICTS(MAVMISSION_NAME)
#undef MAVMISSION_NAME
  CHECK(toString(static_cast<Verdict>(static_cast<uint8_t>(Verdict::Well) + 1)) == nullptr);
}
