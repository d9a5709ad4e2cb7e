// A LinkDoctor beside a client: what it says of a line, in which second, and what it sends to find that out.
#include "mavmission/service/LinkDoctor.h"

#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>
#include <string>

#include "PlanFrames.h"
#include "ToldClient.h"

using namespace mavmission;

namespace {

constexpr uint32_t kAlways = 0xFFFFFFFF;

// Who sends, and what its heartbeat says of it.
struct Who {
  uint8_t systemId, componentId, autopilot, type;
};
constexpr uint8_t kAutopilot = MAV_AUTOPILOT_GENERIC_MISSION_FULL, kNoAutopilot = MAV_AUTOPILOT_INVALID;
constexpr Who kCopter = {1, 1, kAutopilot, MAV_TYPE_QUADROTOR}, kSecond = {2, 1, kAutopilot, MAV_TYPE_QUADROTOR};
constexpr Who kStation = {255, 190, kNoAutopilot, MAV_TYPE_GCS}, kGimbal = {1, 154, kNoAutopilot, MAV_TYPE_GIMBAL};
constexpr Who kBoard = {1, 191, kNoAutopilot, MAV_TYPE_ONBOARD_CONTROLLER};
constexpr Who kMute = {42, 77, 0, 0};  // sends no heartbeats

const char* nameOf(Verdict verdict) {
#define MAVMISSION_NAME(name, text) #name,
  static const char* const kNames[] = {MAVMISSION_VERDICTS(MAVMISSION_NAME)};
#undef MAVMISSION_NAME
  return kNames[static_cast<uint8_t>(verdict)];
}

void append(std::string& list, uint32_t number, const std::string& word = "") {
  list += (list.empty() ? "" : ", ") + std::to_string(number) + word;
}

// A line on which nobody is, unless the test says who. What happens on it is said word by word:
// Desk().pass(10000).autopilot().pass(10000) is one that stays silent for 10 s, and an autopilot for 10 s.
struct Desk : ToldClient {
  LinkDoctor doctor;
  const uint32_t beganMs;
  std::string history;  // each change of the verdict, after the milliseconds since the beginning
  std::string opened;   // the rates that were opened, in the same way
  std::string own;      // who sends what, of the doctor's own messages: each that is another one than the last

  uint32_t answers = 0;    // so many questions are answered
  uint32_t telemetry = 0;  // so many messages that nobody wants come each second
  bool echoes = false;     // what we send comes back
  Bytes garbage;           // that comes every 100 ms
  uint32_t baud = 57600;   // of the port
  uint32_t goodBaud = 0;   // an autopilot is heard at this one, twice a second

  Desk() : ToldClient(kArduPilot), doctor(client), beganMs(nowMs()) { beats = false; }

  uint32_t sinceMs() const { return nowMs() - beganMs; }

  // As loop() does, every `step` ms. The peer's messages come after that.
  Desk& pass(uint32_t ms, uint32_t step = 1) {
    for (; ms != 0; ms -= step) turn(step);
    return *this;
  }
  Desk& turn(uint32_t step) {
    const Verdict before = doctor.verdict();
    const Verdict verdict = doctor.update();
    if (verdict != before) append(history, sinceMs(), std::string(" ") + nameOf(verdict));
    client.update();
    noteOwn(line.written);
    if (echoes) line.bring(line.written);
    if (!garbage.empty() && sinceMs() % 100 == 0) line.bring(garbage);
    if (sinceMs() % 10 == 0 && sinceMs() % 1000 / 10 < telemetry) hear(partsOf(kCopter));
    if (baud == goodBaud && sinceMs() % 500 == 0) hear(heartbeatParts(kArduPilot));
    const size_t sentBefore = sent.size();
    run(step, step);
    for (size_t i = sentBefore; i < sent.size(); ++i) {
      if (!isQuestion(sent[i]) || answers == 0) continue;
      if (answers != kAlways) --answers;
      answer(MAV_CMD_REQUEST_MESSAGE);
    }
    return *this;
  }

  // From now on...
  Desk& autopilot(uint32_t answered = kAlways) { return is(true, answered, echoes, garbage); }
  Desk& silence() { return is(false, 0, echoes, garbage); }
  Desk& text(const Bytes& bytes = Bytes(7, 'U')) { return is(beats, answers, echoes, bytes); }
  Desk& noText() { return text(Bytes()); }
  Desk& echo(bool isThere = true) { return is(beats, answers, isThere, garbage); }

  // A heartbeat.
  Desk& beat(const Who& who, uint32_t customMode = 0, bool isSigned = false) {
    FrameParts parts = messageParts("HEARTBEAT custom_mode " + std::to_string(customMode) + " type " +
                                    std::to_string(who.type) + " autopilot " + std::to_string(who.autopilot));
    parts.systemId = who.systemId;
    parts.componentId = who.componentId;
    parts.incompatibility = isSigned;
    hear(parts);
    return *this;
  }
  // These beat once a second, for so many seconds.
  Desk& beating(std::initializer_list<Who> all, int seconds, uint32_t step = 1) {
    for (; seconds != 0; --seconds) {
      for (const Who& who : all) beat(who);
      pass(1000, step);
    }
    return *this;
  }
  // So many frames that nobody wants, one every 10 ms, or with this pause after each.
  Desk& chatter(uint32_t count, const Who& who = kCopter, uint32_t pauseMs = 0) {
    for (; count != 0; --count) {
      hear(partsOf(who));
      pass(10 + pauseMs);
    }
    return *this;
  }
  static FrameParts partsOf(const Who& who) {
    FrameParts parts(MAVLINK_MSG_ID_ATTITUDE, Bytes(28, 0x11), MAVLINK_MSG_ID_ATTITUDE_CRC);
    parts.systemId = who.systemId;
    parts.componentId = who.componentId;
    return parts;
  }
  // Frames with a checksum that is wrong.
  Desk& damaged(uint32_t count, uint32_t pauseMs = 0) {
    for (; count != 0; --count) {
      Bytes bytes = packed(heartbeatParts(kArduPilot));
      bytes.back() ^= 0xFF;
      bring(bytes).pass(10 + pauseMs);
    }
    return *this;
  }
  // The beginnings of frames that nobody wants; their ends are lost.
  Desk& cut(uint32_t count) {
    for (; count != 0; --count) {
      Bytes bytes = packed(partsOf(kCopter));
      bytes.resize(20);
      bring(bytes).pass(100);
    }
    return *this;
  }
  Desk& bring(const Bytes& bytes) {
    line.bring(bytes);
    return *this;
  }
  Desk& answer(uint16_t command, uint8_t targetSystem = 1, uint8_t targetComponent = 191) {
    FrameParts parts = commandAckParts(command, MAV_RESULT_ACCEPTED);
    parts.payload[8] = targetSystem;
    parts.payload[9] = targetComponent;
    hear(parts);
    return *this;
  }
  // Once a second, in the middle of it, for 8 s.
  template <typename Heard>
  Desk& eachSecond(Heard heard) {
    for (int second = 0; second < 8; ++second) {
      pass(500);
      heard(*this);
      pass(500);
    }
    return *this;
  }

  Desk& tryBauds(uint32_t rate) {
    baud = rate;
    doctor.tryBauds(open, rate, this);
    return *this;
  }

  // The verdicts, and in the end who sends beside the client's autopilot: its ids, and the type of its heartbeat.
  std::string told() const { return history + speaker(); }
  std::string speaker() const {
    const Speaker& it = doctor.speaker();
    if (it.systemId == 0 && it.componentId == 0 && it.type == 0) return "";
    return "; " + std::to_string(it.systemId) + "/" + std::to_string(it.componentId) + " is a " + kindOf(it.type);
  }
  static std::string kindOf(uint8_t type) {
    switch (type) {
      case 0: return "stranger";
      case MAV_TYPE_QUADROTOR: return "copter";
      case MAV_TYPE_GCS: return "station";
      case MAV_TYPE_GIMBAL: return "gimbal";
      default: return std::to_string(type);
    }
  }
  // When AUTOPILOT_VERSION was asked for, and when our heartbeats left [ms].
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

 private:
  Desk& is(bool beating, uint32_t answered, bool echoed, const Bytes& bytes) {
    beats = beating;
    answers = answered;
    echoes = echoed;
    garbage = bytes;
    return *this;
  }
  static void open(void* context, uint32_t rate) {
    Desk& desk = *static_cast<Desk*>(context);
    desk.baud = rate;
    append(desk.opened, desk.sinceMs(), " " + std::to_string(rate));
  }
  static bool isQuestion(const SentFrame& frame) {
    const auto command = messageIn<mavlink_command_long_t>(frame.payload);
    return frame.messageId == MAVLINK_MSG_ID_COMMAND_LONG && command.command == MAV_CMD_REQUEST_MESSAGE &&
           command.param1 == MAVLINK_MSG_ID_AUTOPILOT_VERSION;
  }
  void noteOwn(const Bytes& bytes) {
    for (size_t i = 0; i + 10 < bytes.size() && bytes[i] == 0xFD; i += 10u + bytes[i + 1] + 2u) {
      const std::string one = std::to_string(bytes[i + 5]) + "/" + std::to_string(bytes[i + 6]) +
                              (bytes[i + 7] == MAVLINK_MSG_ID_HEARTBEAT ? " beats" : " asks");
      const bool isSame = own.size() >= one.size() && own.substr(own.size() - one.size()) == one;
      if (!isSame) own += (own.empty() ? "" : ", ") + one;
    }
  }
};

}  // namespace

// --- The wire

TEST_CASE("a line without bytes is known as such after 3 s, and bytes that begin later, or again, are listened to") {
  Desk desk;
  CHECK((desk.doctor.verdict() == Verdict::Listening));
  CHECK(desk.pass(400000, 10).told() == "3000 NoBytes");
  CHECK(desk.doctor.baud() == 0);
  CHECK(Desk().pass(10000).autopilot().pass(10000).silence().pass(10000).told() ==
        "3000 NoBytes, 11000 Listening, 15000 Quiet, 23000 NoBytes");
}

TEST_CASE("our own frames that come back are known by what they say, unless others send, who are told") {
  CHECK(Desk().echo().pass(10000).told() == "4000 OnlyEcho");
  CHECK(Desk().echo().pass(10000).echo(false).pass(10000).told() == "4000 OnlyEcho, 13000 NoBytes");
  CHECK(Desk().echo().beating({kStation}, 5).pass(7000).told() ==
        "4000 NoAutopilot, 8000 OnlyEcho; 255/190 is a station");
  // An echo that has ended more than 3 s ago is none, while another board's doctor beats, whose mark is another one.
  Desk desk;
  desk.echo().pass(5000).echo(false);
  for (int second = 0; second < 8; ++second) desk.beat(kBoard, 0x4D4D0000).pass(1000);
  CHECK(desk.told() == "4000 OnlyEcho, 8000 NoAutopilot");
}

TEST_CASE("bytes that are no frames are told after 3 s, and frames that come then after 4 more") {
  CHECK(Desk().text().pass(10000).told() == "3000 NoFrames");
  CHECK(Desk().text().pass(10000).noText().autopilot().pass(10000).told() ==
        "3000 NoFrames, 11000 Listening, 15000 Quiet");
  Desk lossy;  // of the heartbeats each second one is lost
  lossy.text().pass(10000).noText();
  for (int i = 0; i < 4; ++i) {
    lossy.hear(heartbeatParts(ClientOnLine::kArduPilot));
    lossy.pass(2000);
  }
  CHECK(lossy.told() == "3000 NoFrames, 11000 Listening, 15000 NotHeard");
}

TEST_CASE("frames that end while bytes still come are missed after 3 s; an end of both is one of the bytes") {
  CHECK(Desk().autopilot().pass(10000).silence().text().pass(5000).told() == "4000 Quiet, 13000 NoFrames");
  Desk both;
  both.tryBauds(57600).autopilot().pass(10000).silence().text().pass(900).noText().pass(9100);
  CHECK(both.told() == "4000 Quiet, 14000 NoBytes");
  CHECK(both.opened.empty());
  // Bytes that end 2 s before the frames are missed are none of a wrong rate's, and 1 s less are.
  const char* const kHistories[] = {"4000 Quiet, 14000 NoBytes", "4000 Quiet, 13000 NoFrames, 15000 NoBytes",
                                    "4000 Quiet, 13000 NoFrames, 16000 NoBytes"};
  for (uint32_t i : {0u, 1u, 2u}) {
    CHECK(Desk().autopilot().pass(10000).silence().text().pass(900 + 1000 * i).noText().pass(8000).told() ==
          kHistories[i]);
  }
}

TEST_CASE("a fault is forgotten with the line on which it was") {
  Desk desk;
  desk.autopilot().pass(8500).damaged(3).pass(3600).silence().pass(5900);
  CHECK(desk.autopilot().pass(2500).damaged(1).pass(6000).told() ==
        "4000 Quiet, 12000 Damaged, 16000 NoBytes, 20000 Listening, 24000 Quiet");
}

// --- The rates

TEST_CASE("each rate is listened to for 3 s, the own one for 4, and all of them again and again") {
  Desk desk;
  desk.tryBauds(57600).text();
  CHECK(desk.doctor.baud() == 57600);
  CHECK(desk.pass(32000).told() == "3000 TryingBauds, 27000 NoFramesAtAnyBaud");
  CHECK(desk.opened ==
        "3000 115200, 6000 921600, 9000 38400, 12000 230400, 15000 460800, 18000 500000, 21000 19200, 24000 9600, "
        "27000 57600, 31000 115200");
  CHECK(desk.doctor.baud() == 115200);
  // Heartbeats leave at the own rate alone: at another one they would be garbage to the other end.
  CHECK(desk.heartbeats() == "1, 1001, 2001, 27001, 28001, 29001, 30001");
  Desk own;  // one that no list has comes back after all nine others
  CHECK(own.tryBauds(100000).text().pass(31000).told() == "3000 TryingBauds, 30000 NoFramesAtAnyBaud");
  CHECK(own.opened ==
        "3000 57600, 6000 115200, 9000 921600, 12000 38400, 15000 230400, 18000 460800, 21000 500000, 24000 19200, "
        "27000 9600, 30000 100000");
}

TEST_CASE("at the rate at which frames come the port stays, until none have come for more than 5 s") {
  Desk desk;
  desk.goodBaud = 921600;
  CHECK(desk.tryBauds(57600).text().pass(20000).told() == "3000 TryingBauds, 7000 WrongBaud");
  CHECK(desk.opened == "3000 115200, 6000 921600");
  CHECK(desk.doctor.baud() == 921600);
  CHECK(desk.questions().empty());
  desk.goodBaud = 0;
  CHECK(desk.pass(10000).told() == "3000 TryingBauds, 7000 WrongBaud, 25000 Listening, 29000 TryingBauds");
  CHECK(desk.opened == "3000 115200, 6000 921600, 25000 57600, 29000 115200");
}

TEST_CASE("what was tried in vain is forgotten when the bytes end, or frames come") {
  CHECK(Desk().tryBauds(57600).text().pass(27500).noText().pass(12500).text().pass(6000).told() ==
        "3000 TryingBauds, 27000 NoFramesAtAnyBaud, 31000 NoBytes, 41000 Listening, 45000 TryingBauds");
  Desk other;
  other.tryBauds(57600).text().pass(28000).noText().autopilot().pass(6000).beats = false;
  CHECK(other.text().pass(6000).told() ==
        "3000 TryingBauds, 27000 NoFramesAtAnyBaud, 29000 Listening, 33000 Quiet, 38000 TryingBauds");
}

TEST_CASE("with a loop that is late no rate is tried: bytes are lost at each") {
  for (uint8_t waiting : {62, 63}) {
    CAPTURE(waiting);
    Desk desk;
    desk.tryBauds(57600);
    for (int second = 0; second < 10; ++second) {
      if (second < 6) desk.bring(Bytes(waiting, 'U'));
      desk.turn(1).text().pass(999);
    }
    CHECK(desk.told() == (waiting == 63 ? "3000 LoopLate, 8000 TryingBauds" : "3000 TryingBauds"));
  }
}

// --- Damage

TEST_CASE("three damaged frames within 4 s are a fault, which lasts until nothing is damaged for 4 s") {
  const auto damaged = [](uint32_t count) {
    return Desk().autopilot().pass(8500).damaged(count, 1000).pass(8000).told();
  };
  CHECK(damaged(1) == "4000 Quiet");
  CHECK(damaged(2) == "4000 Quiet");
  CHECK(damaged(3) == "4000 Quiet, 12000 Damaged, 16000 Quiet");
  CHECK(Desk().autopilot().pass(8500).damaged(3).pass(5000).damaged(1).pass(4000).damaged(1).pass(10000).told() ==
        "4000 Quiet, 12000 Damaged, 24000 Quiet");
  // Frames that are cut short are damaged, too.
  CHECK(Desk().autopilot().pass(8500).cut(3).pass(8000).told() == "4000 Quiet, 12000 Damaged, 16000 Quiet");
  // What came before the first frame is no damage: another rate, or a boot loader's text.
  CHECK(Desk().silence().damaged(5).pass(500).autopilot().pass(10000).told() == "5000 Quiet");
}

TEST_CASE("frames that are damaged while the loop is late are its fault") {
  for (uint32_t lateMs : {8001u, 8000u}) {
    CAPTURE(lateMs);
    CHECK(Desk().autopilot().pass(lateMs).bring(Bytes(63, 'U')).pass(8500 - lateMs).damaged(3).pass(5000).told() ==
          (lateMs == 8000 ? "4000 Quiet, 12000 Damaged" : "4000 Quiet, 12000 LoopLate"));
  }
}

// --- Who sends

TEST_CASE("a station alone is no autopilot; who it is is told, and it is asked nothing") {
  Desk desk;
  CHECK(desk.beating({kStation}, 400, 10).told() == "4000 NoAutopilot; 255/190 is a station");
  CHECK(desk.questions().empty());
}

TEST_CASE("a sender without heartbeats is believed when eight of its frames come within 4 s, as long as any other") {
  CHECK(Desk().pass(10).chatter(7, kMute).pass(4990).told() == "4000 NoBytes");
  CHECK(Desk().pass(10).chatter(8, kMute).pass(4990).told() == "3000 NoAutopilot, 4000 NoBytes; 42/77 is a stranger");
  CHECK(Desk().chatter(8, kMute).text().pass(8000).told() == "3000 NoAutopilot, 6000 NoFrames; 42/77 is a stranger");
}

TEST_CASE("frames of which a quarter does not end where it should are garbage") {
  const struct {
    uint32_t whole, cut;
    bool isBelieved;
  } kCases[] = {{8, 1, true},   {8, 2, false}, {8, 3, false}, {12, 2, true},
                {12, 3, false}, {16, 3, true}, {16, 4, false}};
  for (const auto& one : kCases) {
    CHECK(Desk().pass(10).cut(one.cut).chatter(one.whole, kMute).pass(2900 - 100 * one.cut).speaker() ==
          (one.isBelieved ? "; 42/77 is a stranger" : ""));
  }
  // What was cut more than 4 s ago does not count.
  CHECK(Desk().cut(3).text().pass(3800).noText().chatter(8, kMute).pass(1500).speaker() == "; 42/77 is a stranger");
}

TEST_CASE("a sender without heartbeats is told when autopilot and others have been silent for more than 5 s") {
  for (const Who& other : {kCopter, kStation}) {
    Desk desk;
    for (int tenths = 0; tenths < 148; ++tenths) {
      if (tenths % 10 == 0 && tenths <= 90) desk.beat(other);
      desk.chatter(1, kMute, 90);
    }
    CHECK(desk.speaker() == (other.type == kCopter.type ? "" : "; 255/190 is a station"));
    CHECK(desk.chatter(1, kMute, 300).speaker() == "; 42/77 is a stranger");
  }
  CHECK(Desk().chatter(60, kBoard, 90).speaker() == "");  // our own frames that come back are nobody's
}

TEST_CASE("the last sender but the client's autopilot is told, and is no fault beside it") {
  Desk desk;
  desk.autopilot();
  for (int second = 0; second < 10; ++second) desk.beat(kStation).chatter(1, kMute, 1000);
  CHECK(desk.told() == "4000 Quiet; 255/190 is a station");
  CHECK(desk.beat(kGimbal).pass(10).told() == "4000 Quiet; 1/154 is a gimbal");
}

TEST_CASE("two autopilots are told, and nothing is sent to either; named ones are one") {
  Desk desk;
  CHECK(desk.beating({kCopter, kSecond}, 8).told() == "4000 SeveralAutopilots; 2/1 is a copter");
  CHECK(desk.questions().empty());
  const std::string before = desk.heartbeats();
  CHECK(desk.beating({kCopter, kSecond}, 2).heartbeats() == before);
  desk.client.setTargetIds(2);
  CHECK(desk.beating({kCopter, kSecond}, 3).speaker() == "; 1/1 is a copter");
  CHECK_FALSE(desk.questions().empty());
}

TEST_CASE("an autopilot that is not the one named is another one, and none when it is gone for 3 s") {
  Desk desk;
  desk.client.setTargetIds(9, 1);
  CHECK(desk.beating({kCopter}, 8).told() == "4000 OtherAutopilot; 1/1 is a copter");
  CHECK(desk.beating({kStation}, 8).told() == "4000 OtherAutopilot, 13000 NoAutopilot; 255/190 is a station");
  for (uint32_t heardMs : {900u, 1100u}) {
    Desk other;
    other.client.setTargetIds(9, 1);
    for (uint32_t ms = 0; ms < 4500; ms += 100) {
      if (ms % 1000 == 0) other.beat(kStation);
      if (ms == heardMs) other.beat(kCopter);
      other.pass(100);
    }
    CHECK((other.doctor.verdict() == (heardMs == 1100 ? Verdict::OtherAutopilot : Verdict::Listening)));
  }
}

TEST_CASE("an autopilot with our own ids does not hear us") {
  Desk desk;
  desk.client.setSourceIds(1, 1);
  CHECK(desk.autopilot(0).pass(8000).told() == "4000 SameIds");
}

// --- Whether we are heard

TEST_CASE("all is well: every 4 s it is judged anew whether much telemetry comes") {
  for (uint32_t telemetry : {3u, 4u}) {
    Desk desk;
    desk.telemetry = telemetry;
    // With 4 heartbeats, an answer, and 12 or 16 others; not all of the first 4 s were counted.
    CHECK(desk.autopilot().pass(9000).told() == (telemetry == 4 ? "4000 Quiet, 8000 Well" : "4000 Quiet"));
    CHECK(isWell(desk.doctor.verdict()));
  }
  CHECK(Desk().autopilot().pass(12500).chatter(15).pass(8000).told() == "4000 Quiet");
  CHECK(Desk().autopilot().pass(12500).chatter(16).pass(8000).told() == "4000 Quiet, 16000 Well, 20000 Quiet");
}

TEST_CASE("an autopilot that answers is asked every 5 s, and one that does not every second") {
  Desk desk;
  CHECK(desk.autopilot(2).pass(15500).told() == "4000 Quiet, 15000 NotHeard");
  CHECK(desk.questions() == "1001, 6001, 11001, 12001, 13001, 14001, 15001");
  CHECK(desk.autopilot().pass(6500).told() == "4000 Quiet, 15000 NotHeard, 17000 Quiet");
  CHECK(desk.questions() == "1001, 6001, 11001, 12001, 13001, 14001, 15001, 16001, 21001");
}

TEST_CASE("one that never answers does not hear us, however long that lasts; if it signs it takes signed ones alone") {
  CHECK(Desk().autopilot(0).pass(4500).told() == "");
  CHECK(Desk().autopilot(0).pass(4500).pass(300000, 10).told() == "5000 NotHeard");
  Desk desk;
  for (int second = 0; second < 12; ++second) desk.beat(kCopter, 0, second < 8).pass(1000);
  CHECK(desk.told() == "5000 Signing, 11000 NotHeard");
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
    const auto answer = [&one](Desk& desk) { desk.answer(one.command, one.system, one.component); };
    CHECK(Desk().autopilot(0).eachSecond(answer).told() == (one.isAnswer ? "4000 Quiet" : "5000 NotHeard"));
  }
  // Of the mission's messages those for us show that we are heard.
  CHECK(Desk().autopilot(0).eachSecond([](Desk& desk) { desk.hear(ackParts(0)); }).told() == "4000 Quiet");
  const auto current = [](Desk& desk) { desk.hear(messageParts("MISSION_CURRENT")); };
  CHECK(Desk().autopilot(0).eachSecond(current).told() == "5000 NotHeard");
}

// --- What is sent

TEST_CASE("before an autopilot is heard a heartbeat leaves each second, with the ids of an onboard computer") {
  Desk desk;
  CHECK(desk.pass(3500).heartbeats() == "1, 1001, 2001, 3001");
  CHECK(desk.own == "1/191 beats");
  CHECK(desk.beat({7, 1, kAutopilot, MAV_TYPE_QUADROTOR}).pass(1000).own == "1/191 beats, 7/191 asks");
  Desk named;
  named.client.setSourceIds(33, 44);
  CHECK(named.pass(2000).own == "33/44 beats");
}

// --- Time

TEST_CASE("seconds that a late loop has missed are not counted") {
  CHECK(Desk().pass(30000, 3000).told() == "9000 NoBytes");
  CHECK(Desk().turn(1300).pass(5200, 1300).told() == "3900 NoBytes");
  CHECK(Desk().turn(1999).pass(5000).told() == "3000 NoBytes");
  CHECK(Desk().turn(2000).pass(5000).told() == "4000 NoBytes");
}

TEST_CASE("each verdict has its text") {
#define MAVMISSION_NAME(name, text) CHECK(strcmp(reinterpret_cast<const char*>(toString(Verdict::name)), text) == 0);
  MAVMISSION_VERDICTS(MAVMISSION_NAME)
#undef MAVMISSION_NAME
  CHECK(toString(static_cast<Verdict>(static_cast<uint8_t>(Verdict::Well) + 1)) == nullptr);
}
