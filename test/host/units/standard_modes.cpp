// StandardModes by a whole client: what is ordered and asked, and what each answer of the autopilot's means.
#include "mavmission/steering/StandardModes.h"

#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>
#include <new>
#include <string>

#include "PlanFrames.h"
#include "Script.h"
#include "ToldClient.h"

using namespace mavmission;

namespace {

constexpr uint16_t kCommandLong = MAVLINK_MSG_ID_COMMAND_LONG;
constexpr uint16_t kSet = MAV_CMD_DO_SET_STANDARD_MODE, kAsk = MAV_CMD_REQUEST_MESSAGE;
constexpr uint16_t kCurrentMode = MAVLINK_MSG_ID_CURRENT_MODE, kModes = MAVLINK_MSG_ID_AVAILABLE_MODES;
constexpr uint8_t kAccepted = MAV_RESULT_ACCEPTED, kDenied = MAV_RESULT_DENIED, kSilent = 255;
constexpr uint32_t kPosctl = 3ul << 16, kLand = 4ul << 16 | 6ul << 24, kReturn = 4ul << 16 | 5ul << 24;
constexpr uint8_t kLandMode = static_cast<uint8_t>(StandardMode::Land);
constexpr uint8_t kRecovery = static_cast<uint8_t>(StandardMode::SafeRecovery);

// A PX4 that does what it is told, but for what a test changes of it.
struct Flown : ToldClient {
  StandardModes modes;
  uint32_t custom = kPosctl;  // its mode, as heartbeats show it
  uint8_t standard = 0;       // and as CURRENT_MODE does
  uint8_t saysToSet = kAccepted, saysToAsk = kAccepted;
  bool obeys = true, tells = true;
  bool beatsOnRequest = true;
  std::string entry = "number_modes 9";  // of its list, as AVAILABLE_MODES has it
  uint32_t tookMs = 0;                   // of the last script

  Flown() : ToldClient(kPx4), modes(client) {
    beats = false;
    plays("wait 3500");
  }
  Flown& thatSays(uint8_t toSet, uint8_t toAsk) {
    saysToSet = toSet;
    saysToAsk = toAsk;
    return *this;
  }
  Flown& thatDoesNot(bool& one) {
    one = false;
    return *this;
  }

  // What leaves but for requests of heartbeats, "order 7, ask mode, ask entry 3", each after the milliseconds (to 10)
  // since the one before if they are many, and how it ends, when this happens:
  // set N, read N: the operation begins; wait N: N ms pass; until order, until ask: that has left; end: it has ended
  // shows: a heartbeat; mode N, foreign N: CURRENT_MODE, of it or of another; entry N, strange N: the same of the list
  // accepts: its answer to the order, answers: to the question
  std::string plays(const std::string& script) {
    said_ = Transcript();
    spokeMs_ = nowMs();
    const uint32_t fromMs = nowMs();
    ends.clear();
    for (const Event& event : eventsOf(script)) happens(event, static_cast<uint8_t>(event.number));
    for (Status status : ends) said_.note(nameOf(status));
    tookMs = nowMs() - fromMs;
    return said_.text();
  }
  bool isIn(uint8_t mode) const { return modes.current() == static_cast<StandardMode>(mode); }

 private:
  Transcript said_;
  uint32_t spokeMs_ = 0, heartbeatMs_ = 0;
  bool hasOrdered_ = false, hasAsked_ = false;

  void happens(const Event& event, uint8_t number) {
    if (event.is("set")) modes.set(static_cast<StandardMode>(number));
    if (event.is("read")) modes.read(number);
    if (event.is("wait")) pass(event.number);
    if (event.is("until order")) passUntil(hasOrdered_);
    if (event.is("until ask")) passUntil(hasAsked_);
    if (event.is("end")) {
      for (uint32_t ms = 0; ms < 20000 && client.isBusy(); ++ms) pass(1);
      CHECK_FALSE(client.isBusy());
    }
    if (event.is("shows")) show();
    if (event.is("mode") || event.is("foreign")) tellCurrent(number, event.is("mode") ? 1 : 2);
    if (event.is("entry") || event.is("strange")) tellEntry(number, event.is("entry") ? 1 : 2);
    if (event.is("accepts")) answer(kSet, kAccepted);
    if (event.is("answers")) answer(kAsk, kAccepted);
  }
  void passUntil(bool& isDone) {
    isDone = false;
    for (int ms = 0; ms < 5000 && !isDone; ++ms) pass(1);
    REQUIRE(isDone);
  }
  void show() {
    hear(messageParts("HEARTBEAT type 2 autopilot 12 base_mode 1 system_status 4 mavlink_version 3 custom_mode " +
                      std::to_string(custom)));
  }
  void tellOf(uint8_t systemId, const std::string& words) {
    FrameParts parts = messageParts(words);
    parts.systemId = systemId;
    hear(parts);
  }
  void tellCurrent(uint8_t mode, uint8_t systemId = 1) {
    tellOf(systemId, "CURRENT_MODE custom_mode 1 standard_mode " + std::to_string(mode));
  }
  void tellEntry(uint8_t number, uint8_t systemId = 1) {
    tellOf(systemId, "AVAILABLE_MODES mode_index " + std::to_string(number) + " " + entry);
  }
  void answer(uint16_t command, uint8_t result) {
    if (result != kSilent) hear(commandAckParts(command, result));
  }
  void pass(uint32_t ms) {
    for (; ms != 0; --ms) {
      if ((nowMs() == heartbeatMs_ && beatsOnRequest) || nowMs() % 1000 == 0) show();
      const size_t before = sent.size();
      run(1);
      for (size_t i = before; i < sent.size(); ++i) {
        if (sent[i].messageId == kCommandLong) take(sent[i]);
      }
    }
  }
  void take(const SentFrame& frame) {
    const auto command = messageIn<mavlink_command_long_t>(frame.payload);
    if (command.command == kAsk && command.param1 == MAVLINK_MSG_ID_HEARTBEAT) {
      heartbeatMs_ = nowMs() + 25;
      return answer(kAsk, kAccepted);
    }
    const uint32_t ms = frame.atMs - spokeMs_;
    const std::string again = command.confirmation != 0 ? " again" : "";
    const auto note = [&](const std::string& said) { said_.note(said + again, ms < 200 ? 0 : (ms + 5) / 10 * 10); };
    spokeMs_ = frame.atMs;
    if (command.command == kSet) {
      note("order " + std::to_string(static_cast<int>(command.param1)));
      hasOrdered_ = true;
      if (obeys) {
        custom = kLand;
        standard = static_cast<uint8_t>(command.param1);
      }
      return answer(kSet, saysToSet);
    }
    REQUIRE(command.command == kAsk);
    const bool isOfMode = command.param1 == kCurrentMode;
    CHECK((isOfMode ? command.param2 == 0 : command.param1 == kModes));
    note(isOfMode ? "ask mode" : "ask entry " + std::to_string(static_cast<int>(command.param2)));
    hasAsked_ = true;
    answer(kAsk, saysToAsk);
    if (!tells) return;
    isOfMode ? tellCurrent(standard) : tellEntry(static_cast<uint8_t>(command.param2));
  }
};

}  // namespace

TEST_CASE("before anything was read there is no entry, and the mode is not known") {
  Flown flight;
  flight.plays("entry 1, wait 5");  // for another client
  CHECK(flight.modes.count() == 0);
  CHECK(std::string(flight.modes.name()).empty());
  CHECK((flight.modes.mode() == StandardMode::NonStandard));
  CHECK(flight.modes.customMode() == 0);
  CHECK_FALSE(flight.modes.isSelectable());
  CHECK((flight.modes.current() == StandardMode::NonStandard));
  // Also where it does not lie in memory that is zero.
  ClientOnLine other(ClientOnLine::kPx4);
  alignas(StandardModes) unsigned char room[sizeof(StandardModes)];
  memset(room, 0xEE, sizeof(room));
  const StandardModes* const modes = new (room) StandardModes(other.client);
  CHECK(std::string(modes->name(), 1) == std::string(1, '\0'));
}

// --- Setting

TEST_CASE("each mode is ordered by its number, asked for, and done when it is shown") {
  for (uint8_t mode = 1; mode <= 8; ++mode) {
    Flown flight;
    const std::string number = std::to_string(mode);
    CHECK(flight.plays("set " + number + ", end") == "order " + number + ", ask mode, Done");
    CHECK(flight.isIn(mode));
    CHECK(flight.tookMs < 120);
  }
}

TEST_CASE("it is done after a heartbeat, so that the next order does not take the mode for somebody else's") {
  Flown flight;
  CHECK(flight.plays("set 7, until ask") == "order 7, ask mode");
  flight.beatsOnRequest = false;
  CHECK(flight.plays("wait 300") == "");
  CHECK(flight.client.isBusy());
  CHECK(flight.isIn(kLandMode));
  CHECK(flight.plays("shows, wait 2") == "Done");
  flight.beatsOnRequest = true;
  CHECK(flight.plays("set 2, end") == "order 2, ask mode, Done");
}

TEST_CASE("no heartbeat after it leaves it unconfirmed") {
  Flown flight;
  flight.plays("set 7, until ask");
  const uint32_t fromMs = flight.nowMs();  // CURRENT_MODE and the answer come in the next millisecond
  for (uint32_t ms = 0; ms < 8000 && flight.client.isBusy(); ++ms) {
    if (flight.nowMs() % 500 == 0) flight.plays("mode 7");  // it is still there
    flight.run(1);
  }
  CHECK((flight.ended == Status::Unconfirmed));
  CHECK(flight.nowMs() - fromMs == 5001);
}

TEST_CASE("a mode that is none, or a link of MAVLink 1, is refused before anything is sent") {
  CHECK(Flown().plays("set 0, end") == "NoSuchMode");
  for (const char* script : {"set 7, end", "read 1, end"}) {
    Flown old;
    old.client.setMavlinkVersion(MavlinkVersion::Version1);
    CHECK(old.plays(script) == "NeedsMavlink2");
  }
}

TEST_CASE("another mode that is shown before the order leaves is somebody else's") {
  Flown flight;
  CHECK(flight.plays("set 7, wait 3") == "");
  flight.custom = kReturn;
  CHECK(flight.plays("end") == "TakenOver");
}

TEST_CASE("another mode that is shown before the answer: the order does not leave again, and the mode is asked for") {
  Flown flight, taken;
  CHECK(flight.thatSays(kSilent, kAccepted).plays("set 7, until order, shows, end") == "order 7, ask mode, Done");
  taken.thatSays(kSilent, kAccepted).plays("set 7, until order");
  taken.custom = kReturn;
  taken.standard = kRecovery;
  CHECK(taken.plays("shows, end") == "ask mode, 250 ask mode (20 times), Unconfirmed");
  CHECK(taken.isIn(kRecovery));
}

TEST_CASE("an order without an answer, and without another mode, is given up after 5 attempts") {
  Flown flight;
  CHECK(flight.thatDoesNot(flight.obeys).thatSays(kSilent, kAccepted).plays("set 7, end") ==
        "order 7, 1530 order 7 again (4 times), NoAnswer");
}

TEST_CASE("a mode that is not shown is asked for every 250 ms, up to 5 s from the acceptance of the order") {
  Flown flight;
  flight.standard = kRecovery;
  CHECK(flight.thatDoesNot(flight.obeys).plays("set 7, end") ==
        "order 7, ask mode, 250 ask mode (20 times), Unconfirmed");
  CHECK(flight.isIn(kRecovery));
  // One that comes to it meanwhile is done.
  Flown late;
  late.thatDoesNot(late.obeys).plays("set 7, wait 2000");
  late.standard = kLandMode;
  CHECK(late.plays("end") == "ask mode, Done");
  Flown slow;
  CHECK(slow.thatDoesNot(slow.obeys).thatSays(MAV_RESULT_IN_PROGRESS, kAccepted).plays("set 7, wait 3000") ==
        "order 7");
  CHECK(slow.plays("accepts, end") == "ask mode, 250 ask mode (20 times), Unconfirmed");
}

TEST_CASE("an autopilot that does not tell its mode leaves it unconfirmed") {
  for (uint8_t result : {kDenied, kSilent, kAccepted}) {
    CAPTURE(int{result});
    Flown flight;
    flight.thatDoesNot(flight.tells).thatSays(kAccepted, result).plays("set 7, end");
    CHECK((flight.ended == Status::Unconfirmed));
    CHECK((result == kDenied ? flight.tookMs < 200 : flight.tookMs > 6000));
  }
}

TEST_CASE("a mode that is told without the answer to the question is not enough: it may be older") {
  Flown flight;
  CHECK(flight.thatSays(kAccepted, kSilent).plays("set 7, wait 1000") == "order 7, ask mode");
  CHECK(flight.isIn(kLandMode));
  CHECK(flight.plays("answers, wait 100") == "Done");
}

TEST_CASE("the mode is that of the last CURRENT_MODE, asked for or not, and of nobody else's") {
  Flown flight;
  flight.plays("mode 5, wait 5");
  CHECK(flight.isIn(kRecovery));
  flight.plays("foreign 7, wait 5");
  CHECK(flight.isIn(kRecovery));
}

// --- Reading

TEST_CASE("an entry of the list is read by its number, and described") {
  Flown flight;
  const std::string name(35, 'n');
  // MAV_MODE_PROPERTY_NOT_USER_SELECTABLE; then MAV_MODE_PROPERTY_ADVANCED alone.
  flight.entry = "number_modes 9 standard_mode 7 custom_mode 0x01020304 properties 2 mode_name " + name;
  CHECK(flight.plays("read 3, end") == "ask entry 3, Done");
  CHECK(flight.modes.count() == 9);
  CHECK((flight.modes.mode() == StandardMode::Land));
  CHECK(flight.modes.customMode() == 0x01020304);
  CHECK_FALSE(flight.modes.isSelectable());
  CHECK(flight.modes.name() == name);
  flight.entry = "number_modes 9 properties 1 mode_name Hold";
  CHECK(flight.plays("read 255, end") == "ask entry 255, Done");
  CHECK(flight.modes.isSelectable());
  CHECK(std::string(flight.modes.name()) == "Hold");
  // There is none 0: it is asked for the last number, which no list has.
  CHECK(flight.thatDoesNot(flight.tells).thatSays(kAccepted, kDenied).plays("read 0, end") ==
        "ask entry 255, CommandDenied");
  CHECK(flight.modes.count() == 9);
}

TEST_CASE("an entry that another client has asked for, or another autopilot's, is not taken") {
  Flown flight;
  CHECK(flight.thatDoesNot(flight.tells).plays("read 3, wait 50, entry 4, entry 2, strange 3, wait 50") ==
        "ask entry 3");
  CHECK(flight.modes.count() == 0);
  CHECK(flight.plays("entry 3, wait 5") == "Done");
  CHECK(flight.modes.count() == 9);
}

TEST_CASE("an entry without an answer, or an answer without an entry, is not done") {
  Flown silent, empty, nobody;
  CHECK(silent.thatSays(kAccepted, kSilent).plays("read 3, wait 500") == "ask entry 3");
  CHECK(silent.plays("answers, wait 5") == "Done");
  CHECK(empty.thatDoesNot(empty.tells).plays("read 3, end") ==
        "ask entry 3, 1500 ask entry 3 again (4 times), Unconfirmed");
  CHECK(nobody.thatDoesNot(nobody.tells).thatSays(kAccepted, kSilent).plays("read 3, end") ==
        "ask entry 3, 1500 ask entry 3 again (4 times), NoAnswer");
}

TEST_CASE("while another operation runs none begins, and what runs is not changed") {
  Flown flight;
  flight.plays("read 3");
  CHECK((flight.modes.read(5) == Status::Busy));
  CHECK((flight.modes.set(StandardMode::Orbit) == Status::Busy));
  CHECK(flight.plays("end") == "ask entry 3, Done");
}
