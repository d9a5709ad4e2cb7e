// StandardModes by a whole client: what is ordered and asked, and what each answer of the autopilot's means.
#include "mavmission/steering/StandardModes.h"

#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>
#include <new>
#include <string>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

constexpr uint16_t kCommandLong = MAVLINK_MSG_ID_COMMAND_LONG;
constexpr uint16_t kSet = MAV_CMD_DO_SET_STANDARD_MODE, kAsk = MAV_CMD_REQUEST_MESSAGE;
constexpr uint16_t kCurrentMode = MAVLINK_MSG_ID_CURRENT_MODE, kModes = MAVLINK_MSG_ID_AVAILABLE_MODES;
constexpr uint8_t kAccepted = MAV_RESULT_ACCEPTED, kDenied = MAV_RESULT_DENIED, kFailed = MAV_RESULT_FAILED,
                  kSilent = 255;
constexpr uint32_t kPosctl = 3ul << 16, kLand = 4ul << 16 | 6ul << 24, kReturn = 4ul << 16 | 5ul << 24;
constexpr uint8_t kLandMode = static_cast<uint8_t>(StandardMode::Land);
constexpr uint8_t kRecovery = static_cast<uint8_t>(StandardMode::SafeRecovery);

// A PX4 that does what it is told, but for what a test changes of it.
struct Flown : ClientOnLine {
  StandardModes modes;
  uint32_t custom = kPosctl;  // its mode, as heartbeats show it
  uint8_t standard = 0;       // and as CURRENT_MODE does
  uint8_t saysToSet = kAccepted, saysToAsk = kAccepted;
  bool obeys = true, tells = true;
  bool beatsOnRequest = true;
  mavlink_available_modes_t entry;
  std::string commands;  // those that have left, but for requests of heartbeats
  std::string times;     // and when [ms]
  uint32_t fromMs = 0;   // since when
  uint32_t heartbeatMs = 0;

  explicit Flown() : ClientOnLine(kPx4), modes(client), entry() {
    beats = false;
    pass(3500);
    begin();
  }

  void begin() {
    commands.clear();
    times.clear();
    fromMs = nowMs();
    ended = Status::Idle;
  }
  void show(uint32_t mode, uint8_t version = 2) {
    mavlink_heartbeat_t message = mavlink_heartbeat_t();
    message.custom_mode = mode;
    message.type = MAV_TYPE_QUADROTOR;
    message.autopilot = MAV_AUTOPILOT_PX4;
    message.base_mode = MAV_MODE_FLAG_CUSTOM_MODE_ENABLED;
    message.system_status = MAV_STATE_ACTIVE;
    message.mavlink_version = 3;
    tell(MAVLINK_MSG_ID_HEARTBEAT, MAVLINK_MSG_ID_HEARTBEAT_CRC, message, 1, version);
  }
  template <typename Message>
  void tell(uint16_t id, uint8_t crcExtra, const Message& message, uint8_t systemId = 1, uint8_t version = 2) {
    Bytes payload(sizeof(Message));
    memcpy(payload.data(), &message, payload.size());
    FrameParts parts(id, payload, crcExtra);
    parts.systemId = systemId;
    parts.version = version;
    hear(parts);
  }
  void tellCurrent(uint8_t mode, uint8_t systemId = 1) {
    mavlink_current_mode_t message = mavlink_current_mode_t();
    message.standard_mode = mode;
    message.custom_mode = 1;
    tell(kCurrentMode, MAVLINK_MSG_ID_CURRENT_MODE_CRC, message, systemId);
  }
  void tellEntry(uint8_t number, uint8_t systemId = 1) {
    entry.mode_index = number;
    tell(kModes, MAVLINK_MSG_ID_AVAILABLE_MODES_CRC, entry, systemId);
  }
  void answer(uint16_t command, uint8_t result) {
    if (result == kSilent) return;
    const uint8_t low = static_cast<uint8_t>(command), high = static_cast<uint8_t>(command >> 8);
    hear(FrameParts(MAVLINK_MSG_ID_COMMAND_ACK, {low, high, result, 0, 0, 0, 0, 0, 1, 191},
                    MAVLINK_MSG_ID_COMMAND_ACK_CRC));
  }

  void pass(uint32_t ms) {
    for (; ms != 0; --ms) {
      if (nowMs() == heartbeatMs || nowMs() % 1000 == 0) show(custom);
      const size_t before = sent.size();
      run(1);
      for (size_t i = before; i < sent.size(); ++i) {
        if (sent[i].messageId == kCommandLong) take(sent[i]);
      }
    }
  }
  void take(const SentFrame& frame) {
    mavlink_command_long_t command;
    memcpy(&command, frame.payload.data(), sizeof(command));
    if (command.command == kAsk && command.param1 == MAVLINK_MSG_ID_HEARTBEAT) {
      if (beatsOnRequest) heartbeatMs = nowMs() + 25;
      return answer(kAsk, kAccepted);
    }
    const auto number = [](float value) { return std::to_string(static_cast<int>(value)); };
    commands += (commands.empty() ? "" : ", ") + std::to_string(command.command) + " " + number(command.param1);
    if (command.param2 != 0) commands += " " + number(command.param2);
    if (command.confirmation != 0) commands += " again";
    times += (times.empty() ? "" : " ") + std::to_string(frame.atMs - fromMs);
    if (command.command == kSet) {
      if (obeys) {
        custom = kLand;
        standard = static_cast<uint8_t>(command.param1);
      }
      return answer(kSet, saysToSet);
    }
    answer(kAsk, saysToAsk);
    if (!tells) return;
    command.param1 == kCurrentMode ? tellCurrent(standard) : tellEntry(static_cast<uint8_t>(command.param2));
  }
  Status end(uint32_t limitMs = 20000) {
    for (; limitMs != 0 && client.isBusy(); --limitMs) pass(1);
    CHECK_FALSE(client.isBusy());
    return ended;
  }
};

}  // namespace

TEST_CASE("before anything was read there is no entry, and the mode is not known") {
  Flown flight;
  flight.entry.number_modes = 9;
  flight.tellEntry(1);  // for another client
  flight.pass(5);
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
    CHECK((flight.modes.set(static_cast<StandardMode>(mode)) != Status::Busy));
    CHECK((flight.end() == Status::Done));
    CHECK(flight.commands == "262 " + std::to_string(mode) + ", 512 436");
    CHECK((flight.modes.current() == static_cast<StandardMode>(mode)));
    CHECK(flight.nowMs() - flight.fromMs < 120);
  }
}

TEST_CASE("it is done behind a heartbeat, so that the next order does not take the mode for somebody else's") {
  Flown flight;
  flight.modes.set(StandardMode::Land);
  while (flight.commands != "262 7, 512 436") flight.pass(1);
  flight.beatsOnRequest = false;
  flight.heartbeatMs = 0;
  flight.pass(300);
  CHECK(flight.client.isBusy());
  CHECK((flight.modes.current() == StandardMode::Land));
  CHECK(flight.commands == "262 7, 512 436");
  flight.show(kLand);
  flight.pass(2);
  CHECK((flight.ended == Status::Done));
  flight.beatsOnRequest = true;
  flight.begin();
  flight.modes.set(StandardMode::Orbit);
  CHECK((flight.end() == Status::Done));
}

TEST_CASE("no heartbeat behind it leaves it unconfirmed") {
  Flown flight;
  flight.modes.set(StandardMode::Land);
  while (flight.commands != "262 7, 512 436") flight.pass(1);
  flight.beatsOnRequest = false;
  flight.heartbeatMs = 0;
  const uint32_t fromMs = flight.nowMs();  // CURRENT_MODE and the answer come in the next millisecond
  for (uint32_t ms = 0; ms < 8000 && flight.client.isBusy(); ++ms) {
    if (flight.nowMs() % 500 == 0) flight.tellCurrent(kLandMode);  // it is still there
    flight.run(1);
  }
  CHECK((flight.ended == Status::Unconfirmed));
  CHECK(flight.nowMs() - fromMs == 5001);
}

TEST_CASE("a mode that is none, or a link of MAVLink 1, is refused before anything is sent") {
  Flown flight;
  flight.modes.set(StandardMode::NonStandard);
  CHECK((flight.end() == Status::NoSuchMode));
  for (bool isSet : {true, false}) {
    Flown old;
    old.client.setMavlinkVersion(MavlinkVersion::Version1);
    isSet ? old.modes.set(StandardMode::Land) : old.modes.read(1);
    CHECK((old.end() == Status::NeedsMavlink2));
    CHECK(old.commands.empty());
  }
  CHECK(flight.commands.empty());
}

TEST_CASE("a refusal is the end, and nothing is asked") {
  const struct {
    uint8_t result;
    Status status;
  } kResults[] = {{kFailed, Status::CommandFailed},
                  {kDenied, Status::CommandDenied},
                  {MAV_RESULT_UNSUPPORTED, Status::CommandUnsupported},
                  {MAV_RESULT_TEMPORARILY_REJECTED, Status::CommandRejected}};
  for (const auto& one : kResults) {
    Flown flight;
    flight.obeys = false;
    flight.saysToSet = one.result;
    flight.modes.set(StandardMode::Land);
    CHECK((flight.end() == one.status));
    CHECK(flight.commands == "262 7");
  }
}

TEST_CASE("another mode that is shown before the order leaves is somebody else's") {
  Flown flight;
  flight.modes.set(StandardMode::Land);
  flight.pass(3);
  flight.custom = kReturn;
  CHECK((flight.end() == Status::TakenOver));
  CHECK(flight.commands.empty());
}

TEST_CASE("another mode that is shown before the answer: the order does not leave again, and the mode is asked for") {
  for (bool isOurs : {true, false}) {
    Flown flight;
    flight.saysToSet = kSilent;
    flight.modes.set(StandardMode::Land);
    while (flight.commands.empty()) flight.pass(1);
    if (!isOurs) {
      flight.custom = kReturn;
      flight.standard = kRecovery;
    }
    flight.show(flight.custom);
    CHECK((flight.end() == (isOurs ? Status::Done : Status::Unconfirmed)));
    CHECK(flight.commands.substr(0, 14) == "262 7, 512 436");
    CHECK(flight.commands.find("262", 5) == std::string::npos);
    CHECK((flight.modes.current() == static_cast<StandardMode>(flight.standard)));
  }
}

TEST_CASE("an order without an answer, and without another mode, is given up after 5 attempts") {
  Flown flight;
  flight.obeys = false;
  flight.saysToSet = kSilent;
  flight.modes.set(StandardMode::Land);
  CHECK((flight.end() == Status::NoAnswer));
  CHECK(flight.commands == "262 7, 262 7 again, 262 7 again, 262 7 again, 262 7 again");
}

TEST_CASE("a mode that is not shown is asked for every 250 ms, up to 5 s") {
  Flown flight;
  flight.obeys = false;
  flight.standard = kRecovery;
  flight.modes.set(StandardMode::Land);
  CHECK((flight.end() == Status::Unconfirmed));
  CHECK((flight.modes.current() == StandardMode::SafeRecovery));
  CHECK(flight.commands.substr(0, 41) == "262 7, 512 436, 512 436, 512 436, 512 436");
  const size_t first = flight.times.find(' ');
  const unsigned long asked = std::stoul(flight.times.substr(first));
  size_t end;
  std::stoul(flight.times.substr(first), &end);
  const unsigned long again = std::stoul(flight.times.substr(first + end));
  CHECK(again - asked >= 250);
  CHECK(again - asked <= 256);
  CHECK(flight.nowMs() - flight.fromMs >= 5000);
  CHECK(flight.nowMs() - flight.fromMs <= 5400);
  // One that comes to it meanwhile is done.
  Flown late;
  late.obeys = false;
  late.modes.set(StandardMode::Land);
  late.pass(2000);
  late.standard = kLandMode;
  CHECK((late.end() == Status::Done));
  CHECK(late.nowMs() - late.fromMs <= 2400);
}

TEST_CASE("the 5 s count from the acceptance of the order") {
  Flown flight;
  flight.obeys = false;
  flight.saysToSet = MAV_RESULT_IN_PROGRESS;
  flight.modes.set(StandardMode::Land);
  flight.pass(3000);
  CHECK(flight.commands == "262 7");
  flight.answer(kSet, kAccepted);
  CHECK((flight.end() == Status::Unconfirmed));
  CHECK(flight.nowMs() - flight.fromMs >= 8000);
  CHECK(flight.nowMs() - flight.fromMs <= 8400);
}

TEST_CASE("an autopilot that does not tell its mode leaves it unconfirmed") {
  for (uint8_t result : {kDenied, kSilent, kAccepted}) {
    CAPTURE(int{result});
    Flown flight;
    flight.saysToAsk = result;
    flight.tells = false;
    flight.modes.set(StandardMode::Land);
    CHECK((flight.end() == Status::Unconfirmed));
    const uint32_t tookMs = flight.nowMs() - flight.fromMs;
    CHECK((result == kDenied ? tookMs < 200 : tookMs > 6000));
  }
}

TEST_CASE("a mode that is told without the answer to the question is not enough: it may be older") {
  Flown flight;
  flight.saysToAsk = kSilent;
  flight.modes.set(StandardMode::Land);
  flight.pass(1000);
  CHECK(flight.client.isBusy());
  CHECK((flight.modes.current() == StandardMode::Land));
  flight.answer(kAsk, kAccepted);
  flight.pass(100);
  CHECK((flight.ended == Status::Done));
}

TEST_CASE("the mode is that of the last CURRENT_MODE, asked for or not, and of nobody else's") {
  Flown flight;
  flight.tellCurrent(kRecovery);
  flight.pass(5);
  CHECK((flight.modes.current() == StandardMode::SafeRecovery));
  flight.tellCurrent(kLandMode, 2);
  flight.pass(5);
  CHECK((flight.modes.current() == StandardMode::SafeRecovery));
}

// --- Reading

TEST_CASE("an entry of the list is read by its number, and described") {
  Flown flight;
  flight.entry.number_modes = 9;
  flight.entry.standard_mode = kLandMode;
  flight.entry.custom_mode = 0x01020304;
  flight.entry.properties = MAV_MODE_PROPERTY_NOT_USER_SELECTABLE;
  const std::string name(35, 'n');
  memcpy(flight.entry.mode_name, name.data(), name.size());
  flight.modes.read(3);
  CHECK((flight.end() == Status::Done));
  CHECK(flight.commands == "512 435 3");
  CHECK(flight.modes.count() == 9);
  CHECK((flight.modes.mode() == StandardMode::Land));
  CHECK(flight.modes.customMode() == 0x01020304);
  CHECK_FALSE(flight.modes.isSelectable());
  CHECK(flight.modes.name() == name);
  flight.begin();
  flight.entry.properties = MAV_MODE_PROPERTY_ADVANCED;
  memset(flight.entry.mode_name, 0, sizeof(flight.entry.mode_name));
  memcpy(flight.entry.mode_name, "Hold", 4);
  flight.modes.read(255);
  CHECK((flight.end() == Status::Done));
  CHECK(flight.commands == "512 435 255");
  CHECK(flight.modes.isSelectable());
  CHECK(std::string(flight.modes.name()) == "Hold");
  flight.begin();
  flight.saysToAsk = kDenied;
  flight.tells = false;
  flight.modes.read(0);  // there is none: it is asked for the last number, which no list has
  CHECK((flight.end() == Status::CommandDenied));
  CHECK(flight.commands == "512 435 255");
  CHECK(flight.modes.count() == 9);
}

TEST_CASE("an entry that another client has asked for, or another autopilot's, is not taken") {
  Flown flight;
  flight.tells = false;
  flight.entry.number_modes = 9;
  flight.modes.read(3);
  flight.pass(50);
  flight.tellEntry(4);
  flight.tellEntry(2);
  flight.tellEntry(3, 2);
  flight.pass(50);
  CHECK(flight.client.isBusy());
  CHECK(flight.modes.count() == 0);
  flight.tellEntry(3);
  flight.pass(5);
  CHECK((flight.ended == Status::Done));
  CHECK(flight.modes.count() == 9);
}

TEST_CASE("an entry without an answer, or an answer without an entry, is not done") {
  Flown silent;
  silent.saysToAsk = kSilent;
  silent.modes.read(3);
  silent.pass(500);
  CHECK(silent.client.isBusy());
  silent.answer(kAsk, kAccepted);
  silent.pass(5);
  CHECK((silent.ended == Status::Done));
  Flown empty;
  empty.tells = false;
  empty.modes.read(3);
  CHECK((empty.end() == Status::Unconfirmed));
  CHECK(empty.nowMs() - empty.fromMs > 6000);
  Flown nobody;
  nobody.tells = false;
  nobody.saysToAsk = kSilent;
  nobody.modes.read(3);
  CHECK((nobody.end() == Status::NoAnswer));
}

TEST_CASE("what has come for an operation before counts for no other") {
  Flown flight;
  flight.modes.read(3);
  CHECK((flight.end() == Status::Done));
  flight.begin();
  flight.tells = false;
  flight.modes.read(3);
  flight.pass(3000);
  CHECK(flight.client.isBusy());
  flight.client.cancel();
  flight.pass(25000);
  flight.tells = true;
  flight.begin();
  flight.modes.set(StandardMode::Land);
  CHECK((flight.end() == Status::Done));
  flight.begin();
  flight.saysToAsk = kSilent;
  flight.tells = false;
  flight.modes.set(StandardMode::Orbit);
  CHECK((flight.end() == Status::Unconfirmed));
}

TEST_CASE("while another operation runs none begins, and what runs is not changed") {
  Flown flight;
  flight.modes.read(3);
  CHECK((flight.modes.read(5) == Status::Busy));
  CHECK((flight.modes.set(StandardMode::Orbit) == Status::Busy));
  CHECK((flight.end() == Status::Done));
  CHECK(flight.commands == "512 435 3");
}
