// A MissionFollower beside a client: what it requests, what it tells of the mission, and whose plan it takes it for.
#include "mavmission/service/MissionFollower.h"

#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>
#include <string>
#include <vector>

#include "ClientOnLine.h"
#include "Px4Checksum.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

constexpr uint16_t kNoItem = MissionClient::kNoItem;
constexpr uint8_t kAccepted = MAV_MISSION_ACCEPTED, kError = MAV_MISSION_ERROR;
constexpr uint8_t kMission = MAV_MISSION_TYPE_MISSION, kFence = MAV_MISSION_TYPE_FENCE;
constexpr uint32_t kTheirs = 0x9876;
constexpr uint8_t kNoMission = 1, kActive = 3;
const MissionItem kPlan[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 20_m), returnToLaunch()};

const char* nameOf(Aboard aboard) {
  return aboard == Aboard::OurPlan ? "ours" : aboard == Aboard::OtherPlan ? "another" : "not known";
}

struct Desk : ClientOnLine {
  MissionFollower follower;
  std::string currents, reacheds, texts;  // what the functions were called with
  const bool isPx4;
  uint32_t ours = 0;                              // PX4's name for our plan
  std::vector<mavlink_mission_item_int_t> items;  // of it, as they were sent

  explicit Desk(uint8_t autopilot = kPx4) : ClientOnLine(autopilot), follower(client), isPx4(autopilot == kPx4) {
    follower.onCurrent(noteNumber, &currents);
    follower.onReached(noteNumber, &reacheds);
    follower.onText(noteText, &texts);
  }

  static void noteNumber(void* list, uint16_t item) {
    std::string& text = *static_cast<std::string*>(list);
    text += (text.empty() ? "" : " ") + std::to_string(item);
  }
  static void noteText(void* list, uint8_t severity, const char* text) {
    *static_cast<std::string*>(list) += std::to_string(severity) + " " + text + ". ";
  }

  template <typename Message>
  void tell(uint16_t id, uint8_t crcExtra, const Message& message, uint8_t systemId = 1) {
    Bytes payload(sizeof(Message));
    memcpy(payload.data(), &message, payload.size());
    FrameParts parts(id, payload, crcExtra);
    parts.systemId = systemId;
    hear(parts);
    while (!line.toRead.empty()) run(1);
  }
  // MISSION_CURRENT. The items are those on the wire.
  void current(uint16_t item, uint16_t total = 2, uint32_t name = 0, uint8_t state = kActive, uint8_t systemId = 1) {
    mavlink_mission_current_t message = mavlink_mission_current_t();
    message.seq = item;
    message.total = total;
    message.mission_state = state;
    message.mission_id = name;
    tell(MAVLINK_MSG_ID_MISSION_CURRENT, MAVLINK_MSG_ID_MISSION_CURRENT_CRC, message, systemId);
  }
  void reached(uint16_t item, uint8_t systemId = 1) {
    mavlink_mission_item_reached_t message = mavlink_mission_item_reached_t();
    message.seq = item;
    tell(MAVLINK_MSG_ID_MISSION_ITEM_REACHED, MAVLINK_MSG_ID_MISSION_ITEM_REACHED_CRC, message, systemId);
  }
  void say(const std::string& words, uint8_t severity = 6, uint8_t systemId = 1) {
    mavlink_statustext_t message = mavlink_statustext_t();
    message.severity = severity;
    memcpy(message.text, words.data(), words.size());
    message.id = 0x4141;  // lies behind the text
    tell(MAVLINK_MSG_ID_STATUSTEXT, MAVLINK_MSG_ID_STATUSTEXT_CRC, message, systemId);
  }
  void count(uint32_t name, uint8_t type = kMission) {
    mavlink_mission_count_t message = mavlink_mission_count_t();
    message.count = 2;
    message.target_system = 255;
    message.target_component = 190;
    message.mission_type = type;
    message.opaque_id = name;
    tell(MAVLINK_MSG_ID_MISSION_COUNT, MAVLINK_MSG_ID_MISSION_COUNT_CRC, message);
  }
  // The answer to another station.
  void ack(uint32_t name, uint8_t result = kAccepted, uint8_t type = kMission) {
    mavlink_mission_ack_t message = mavlink_mission_ack_t();
    message.target_system = 255;
    message.target_component = 190;
    message.type = result;
    message.mission_type = type;
    message.opaque_id = name;
    tell(MAVLINK_MSG_ID_MISSION_ACK, MAVLINK_MSG_ID_MISSION_ACK_CRC, message);
  }

  // Our plan is put aboard, from the beginning to the last item...
  void transfer() {
    client.uploadWithoutReadback(inRam(kPlan));
    REQUIRE(runUntilSent(kCount, 3000));
    for (uint16_t item = 0; item < (isPx4 ? 2 : 3); ++item) {
      hear(requestParts(item));
      REQUIRE(runUntilSent(kItemInt, 50));
      mavlink_mission_item_int_t sentItem;
      memcpy(&sentItem, sent.back().payload.data(), sizeof(sentItem));
      items.push_back(sentItem);
      if (isPx4) ours = px4Checksum(item == 0 ? 0 : ours, sentItem);
    }
  }
  // ... and accepted.
  void upload() {
    run(3500);
    transfer();
    hear(ackParts(kAccepted, 1, 191, 0, ours));
    run(1);
    REQUIRE((ended == Status::Accepted));
    REQUIRE(follower.isOurPlan());
  }
  // An ArduPilot has these items, and our client reads them.
  void verify(const std::vector<mavlink_mission_item_int_t>& held) {
    client.verify(inRam(kPlan));
    REQUIRE(runUntilSent(kRequestList, 3000));
    sent.clear();
    mavlink_mission_count_t message = mavlink_mission_count_t();
    message.count = static_cast<uint16_t>(held.size());
    message.target_system = 1;
    message.target_component = 191;
    tell(MAVLINK_MSG_ID_MISSION_COUNT, MAVLINK_MSG_ID_MISSION_COUNT_CRC, message);
    for (size_t i = 0; client.isBusy() && (i < sent.size() || runUntilSent(kRequestInt, 100)); ++i) {
      if (sent[i].messageId != kRequestInt) continue;
      mavlink_mission_item_int_t item = held.at(sent[i].payload[0]);
      item.target_component = 191;
      if (item.seq == 0) {  // home, which is the autopilot's own
        item.command = MAV_CMD_NAV_WAYPOINT;
        item.frame = MAV_FRAME_GLOBAL;
      }
      tell(MAVLINK_MSG_ID_MISSION_ITEM_INT, MAVLINK_MSG_ID_MISSION_ITEM_INT_CRC, item);
    }
    run(5);
  }
  std::string aboard() const {
    CHECK(follower.isOurPlan() == (client.aboard() == Aboard::OurPlan));
    return nameOf(client.aboard());
  }

  // When MISSION_CURRENT was requested [ms, since then].
  std::string requests(uint32_t fromMs) const {
    std::string times;
    for (const SentFrame& frame : sent) {
      mavlink_command_long_t command;
      memcpy(&command, frame.payload.data(), sizeof(command));
      if (frame.messageId != MAVLINK_MSG_ID_COMMAND_LONG || command.command != MAV_CMD_SET_MESSAGE_INTERVAL) continue;
      if (command.param1 != MAVLINK_MSG_ID_MISSION_CURRENT || frame.atMs < fromMs) continue;
      CHECK((command.param2 == 1000000));
      CHECK((command.confirmation == 0));
      times += (times.empty() ? "" : " ") + std::to_string(frame.atMs - fromMs);
    }
    return times;
  }
};

}  // namespace

// --- The request

TEST_CASE("MISSION_CURRENT is requested when none has come for two seconds, and again after 2, 4, 8 s, up to 64") {
  Desk desk;
  const uint32_t fromMs = desk.nowMs();
  desk.run(260000);
  CHECK(desk.requests(fromMs) == "2002 4002 8002 16002 32002 64002 128002 192002 256002");
}

TEST_CASE("a MISSION_CURRENT keeps the request back, and lets the pauses begin anew") {
  Desk desk;
  desk.run(20500);
  desk.sent.clear();
  const uint32_t fromMs = desk.nowMs();
  for (int second = 0; second < 20; ++second) {
    desk.current(0);
    desk.run(1000 - desk.nowMs() % 1000 + 500);
  }
  CHECK(desk.sent.size() == desk.timesOf(MAVLINK_MSG_ID_HEARTBEAT, fromMs).size());
  desk.run(15000);
  CHECK(desk.requests(fromMs) == "21502 23502 27502");
}

TEST_CASE("heartbeats that come more often do not bring a second request before the answer to the first") {
  Desk desk;
  desk.beats = false;
  const auto beat = [&desk]() {
    desk.hear(heartbeatParts(ClientOnLine::kPx4));
    desk.run(100);
  };
  const uint32_t fromMs = desk.nowMs();
  for (int i = 0; i < 18; ++i) beat();
  CHECK(desk.requests(fromMs) == "202 1702");
}

TEST_CASE("a request that has no room waits for the next heartbeat behind that") {
  Desk desk;
  desk.run(500);
  const uint32_t fromMs = desk.nowMs() - 500;
  desk.line.room = 0;
  desk.run(5000);  // our heartbeat is waiting to go out
  desk.line.room = MemoryStream::kAlwaysRoom;
  desk.run(1500);
  CHECK(desk.requests(fromMs) == "6002");
}

TEST_CASE("the answer to the request lets another listener ask at once") {
  for (bool isAnswered : {true, false}) {
    struct Two : ClientOnLine {
      AttitudeListener attitude;
      MissionFollower follower;  // hears before the other
      Two() : ClientOnLine(kPx4), attitude(client, 1000), follower(client) {}
      std::string asked;
      void pass(uint32_t ms) {
        sent.clear();
        run(ms);
        for (const SentFrame& frame : sent) {
          mavlink_command_long_t command;
          memcpy(&command, frame.payload.data(), sizeof(command));
          if (frame.messageId == MAVLINK_MSG_ID_COMMAND_LONG) {
            asked += std::to_string(static_cast<int>(command.param1)) + " ";
          }
        }
      }
    } desk;
    desk.pass(2500);  // both are due at the third heartbeat
    REQUIRE(desk.asked == "30 42 ");
    const uint16_t command = isAnswered ? MAV_CMD_SET_MESSAGE_INTERVAL : MAV_CMD_REQUEST_MESSAGE;
    desk.hear(FrameParts(
        MAVLINK_MSG_ID_COMMAND_ACK,
        {static_cast<uint8_t>(command), static_cast<uint8_t>(command >> 8), MAV_RESULT_DENIED, 0, 0, 0, 0, 0, 1, 191},
        MAVLINK_MSG_ID_COMMAND_ACK_CRC));
    desk.pass(10);
    CHECK(desk.asked == (isAnswered ? "30 42 30 " : "30 42 "));
  }
}

// --- The mission

TEST_CASE("before the autopilot has reported anything nothing is known") {
  Desk desk;
  CHECK(desk.follower.currentItem() == kNoItem);
  CHECK(desk.follower.reachedItem() == kNoItem);
  CHECK(desk.follower.total() == 0);
  CHECK((desk.follower.state() == MissionState::NotKnown));
  CHECK_FALSE(desk.follower.isOurPlan());
}

TEST_CASE("the current item, the total and the state are those of the last MISSION_CURRENT") {
  for (uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    const uint16_t home = autopilot == ClientOnLine::kArduPilot ? 1 : 0;  // counted as an item on the wire
    Desk desk(autopilot);
    desk.run(3500);
    desk.current(home + 0, 7, 0, 2);
    CHECK(desk.follower.currentItem() == 0);
    CHECK(desk.follower.total() == 7);
    CHECK((desk.follower.state() == MissionState::NotStarted));
    desk.current(home + 1, 0xFFFE, 0, kActive);
    desk.current(home + 1, 0xFFFE, 0, kActive);
    CHECK(desk.follower.total() == 0xFFFE);
    CHECK((desk.follower.state() == MissionState::Active));
    desk.current(home + 5, 0xFFFF, 0, 4);
    CHECK(desk.follower.currentItem() == 5);
    CHECK(desk.follower.total() == 0);
    CHECK((desk.follower.state() == MissionState::Paused));
    desk.current(home + 2, 9, 0, kActive, 2);  // another aircraft's
    desk.reached(home + 2, 2);
    CHECK(desk.follower.currentItem() == 5);
    CHECK(desk.currents == "0 1 5");
    CHECK(desk.reacheds.empty());
    // As an older autopilot sends it, which has no more than the item.
    const uint8_t item = static_cast<uint8_t>(home + 3);
    FrameParts shorter(MAVLINK_MSG_ID_MISSION_CURRENT, {item, 0}, MAVLINK_MSG_ID_MISSION_CURRENT_CRC);
    shorter.version = 1;
    desk.hear(shorter);
    desk.run(5);
    CHECK(desk.follower.currentItem() == 3);
    CHECK(desk.follower.total() == 0);
    CHECK((desk.follower.state() == MissionState::NotKnown));
  }
}

TEST_CASE("home is no item, and the one behind it is told again") {
  Desk desk(ClientOnLine::kArduPilot);
  desk.run(3500);
  desk.current(1);
  desk.current(0);
  CHECK(desk.follower.currentItem() == kNoItem);
  desk.reached(0);
  CHECK(desk.follower.reachedItem() == kNoItem);
  desk.current(1);
  CHECK(desk.currents == "0 0");
  CHECK(desk.reacheds.empty());
}

TEST_CASE("from each arming on no item is reached until one is, though PX4 repeats the last flight's") {
  Desk desk;
  desk.run(3500);
  desk.beats = false;
  for (int flight = 0; flight < 2; ++flight) {
    desk.hear(heartbeatParts(ClientOnLine::kPx4, MAV_MODE_FLAG_SAFETY_ARMED));
    desk.run(50);
    CHECK(desk.follower.reachedItem() == kNoItem);
    if (flight != 0) desk.reached(1);
    CHECK(desk.follower.reachedItem() == kNoItem);
    desk.current(0);
    desk.current(1);
    desk.reached(1);
    desk.hear(heartbeatParts(ClientOnLine::kPx4));
    desk.run(50);
    CHECK(desk.follower.reachedItem() == 1);
  }
  CHECK(desk.reacheds == "0 1 0 1");
}

TEST_CASE("functions that are taken back, or never given, are not called") {
  Desk desk;
  desk.run(3500);
  desk.follower.onCurrent(nullptr);
  desk.follower.onReached(nullptr);
  desk.follower.onText(nullptr);
  desk.current(1);
  desk.reached(1);
  desk.say("words");
  CHECK(desk.follower.currentItem() == 1);
  CHECK(desk.follower.reachedItem() == 1);
  CHECK(desk.currents.empty());
  CHECK(desk.reacheds.empty());
  CHECK(desk.texts.empty());
}

TEST_CASE("an item is reached once, however often PX4 says so, and again when it is flown again") {
  const struct {
    std::initializer_list<int> messages;  // a current item, or 100 + one that is reached
    const char* reached;
  } kFlights[] = {
      {{100}, "0"},
      {{0, 100, 100, 100}, "0"},
      {{0, 100, 1, 101, 2, 102}, "0 1 2"},
      {{0, 100, 1, 101, 101, 2, 101, 102}, "0 1 2"},
      {{0, 100, 0, 100}, "0"},
      // It was reached before it was current: seen with PX4 1.17.0.
      {{6, 105, 108, 8, 108, 108}, "5 8"},
      {{6, 108, 8, 108, 6, 108, 8, 108}, "8 8"},
      {{108, 8, 108}, "8"},
      {{7, 108, 8, 108, 9, 8, 108}, "8 8"},
      // It is flown again.
      {{0, 100, 1, 101, 2, 102, 1, 102, 101, 2, 101, 102}, "0 1 2 1 2"},
      {{2, 102, 1, 2, 102}, "2 2"},
      {{2, 102, 3, 2, 102, 102}, "2 2"},
      {{2, 102, 1, 102}, "2"},
      {{2, 102, 3, 102}, "2"},
      // Early, then another item beyond it is current: it was that one's turn.
      {{1, 105, 6, 105, 5, 105}, "5 5"},
  };
  for (const auto& flight : kFlights) {
    CAPTURE(flight.reached);
    Desk desk;
    desk.run(3500);
    for (int message : flight.messages) {
      message >= 100 ? desk.reached(static_cast<uint16_t>(message - 100))
                     : desk.current(static_cast<uint16_t>(message));
    }
    CHECK(desk.reacheds == flight.reached);
    CHECK(std::to_string(desk.follower.reachedItem()) == desk.reacheds.substr(desk.reacheds.rfind(' ') + 1));
  }
}

TEST_CASE("in flight an item that is behind is told once, in order, whatever was lost") {
  const struct {
    bool isArmed;
    std::initializer_list<int> messages;  // a current item, 100 + one that is reached, or 200: the mission is complete
    const char* reached;
  } kFlights[] = {
      {true, {0, 1, 2, 3}, "0 1 2"},
      {true, {0, 100, 1, 101, 2, 102, 102}, "0 1 2"},
      {true, {0, 1, 100, 2, 101, 101}, "0 1"},  // told of late, and again and again
      {true, {0, 3, 102}, "0 1 2"},
      {true, {0, 102, 3}, "0 1 2"},
      {true, {1, 102, 3, 105}, "1 2 3 4 5"},  // PX4: of a waypoint and two speeds only the last
      {true, {0, 1, 2, 200}, "0 1 2 3"},
      {true, {2, 102, 1, 2, 3}, "2 1 2"},                 // a jump back
      {true, {3, 4}, "3"},                                // it began there
      {true, {0, 8, 9, 18, 19}, "0 1 2 3 4 5 6 7 8 18"},  // more than eight: somebody has made it jump
      {false, {0, 3, 2, 200}, ""},                        // somebody sets the current item on the ground
  };
  for (const auto& flight : kFlights) {
    CAPTURE(flight.reached);
    Desk desk;
    desk.beats = false;
    desk.hear(heartbeatParts(ClientOnLine::kPx4, flight.isArmed ? 128 : 0));
    desk.run(2000);
    for (int message : flight.messages) {
      if (message == 200) {
        desk.current(3, 4, 0, 5);
      } else if (message >= 100) {
        desk.reached(static_cast<uint16_t>(message - 100));
      } else {
        desk.current(static_cast<uint16_t>(message), 4);
      }
    }
    CHECK(desk.reacheds == flight.reached);
  }
}

TEST_CASE("items that a command of the client's leaves out are not told of as reached") {
  Desk desk;
  desk.beats = false;
  desk.hear(heartbeatParts(ClientOnLine::kPx4, 128));
  desk.run(2000);
  desk.hear(heartbeatParts(ClientOnLine::kPx4, 128));
  desk.current(0, 9);
  desk.client.setCurrentItem(5);
  desk.run(20);
  desk.current(5, 9);
  desk.hear(FrameParts(MAVLINK_MSG_ID_COMMAND_ACK, {224, 0, 0, 0, 0, 0, 0, 0, 1, 191}, MAVLINK_MSG_ID_COMMAND_ACK_CRC));
  desk.run(20);
  REQUIRE((desk.ended == Status::Done));
  desk.current(6, 9);
  CHECK(desk.reacheds == "5");
}

TEST_CASE("each text is given with its severity, and ends behind 50 characters") {
  Desk desk;
  desk.run(3500);
  desk.say("first", 2);
  desk.say(std::string(50, 'x'), 7);
  desk.say("foreign", 0, 2);
  desk.say("", 5);
  CHECK(desk.texts == "2 first. 7 " + std::string(50, 'x') + ". 5 . ");
}

// --- Whose plan it is, on PX4

TEST_CASE("PX4 names our plan, and another name is another plan's") {
  Desk desk;
  desk.upload();
  for (int i = 0; i < 5; ++i) desk.current(0, 2, desk.ours);
  CHECK(desk.aboard() == "ours");
  desk.current(0, 2, kTheirs);
  CHECK(desk.aboard() == "another");
  desk.current(0, 2, kTheirs);
  CHECK(desk.aboard() == "another");
  desk.current(0, 2, desk.ours);
  CHECK(desk.aboard() == "ours");
}

TEST_CASE("another name behind a report without one is another plan's at once") {
  Desk desk;
  desk.upload();
  desk.current(0, 2, desk.ours);
  desk.current(0, 2, 0);
  CHECK(desk.aboard() == "ours");
  desk.current(0, 2, kTheirs);
  CHECK(desk.aboard() == "another");
}

TEST_CASE("an older name that comes up to three times behind the acceptance is no other plan") {
  for (int times : {1, 3, 4}) {
    CAPTURE(times);
    Desk desk;
    desk.run(3500);
    desk.current(0, 2, kTheirs);
    desk.upload();
    for (int i = 0; i < times; ++i) desk.current(0, 2, kTheirs);
    CHECK(desk.aboard() == (times == 4 ? "another" : "ours"));
    desk.current(0, 2, desk.ours);
    CHECK(desk.aboard() == "ours");
    desk.current(0, 2, kTheirs);
    CHECK(desk.aboard() == "another");
  }
}

TEST_CASE("an older name with another total is somebody else's: it is believed when it comes twice") {
  for (int times : {1, 2}) {
    CAPTURE(times);
    Desk desk;
    desk.run(3500);
    desk.current(0, 2, kTheirs);
    desk.upload();
    for (int i = 0; i < times; ++i) desk.current(0, 3, kTheirs);
    CHECK(desk.aboard() == (times == 2 ? "another" : "ours"));
  }
}

TEST_CASE("the answer to another station's upload or download names the plan at once") {
  for (bool isCount : {true, false}) {
    CAPTURE(isCount);
    Desk desk;
    desk.upload();
    desk.current(0, 2, desk.ours);
    isCount ? desk.count(0) : desk.ack(0);  // an older firmware names none
    isCount ? desk.count(kTheirs, kFence) : desk.ack(kTheirs, kAccepted, kFence);
    if (!isCount) desk.ack(kTheirs, kError);
    CHECK(desk.aboard() == "ours");
    isCount ? desk.count(desk.ours) : desk.ack(desk.ours);
    CHECK(desk.aboard() == "ours");
    for (uint32_t name : {kTheirs, uint32_t{1}}) {
      isCount ? desk.count(name) : desk.ack(name);
      CHECK(desk.aboard() == "another");
      isCount ? desk.count(desk.ours) : desk.ack(desk.ours);
      CHECK(desk.aboard() == "ours");
    }
    isCount ? desk.count(kTheirs) : desk.ack(kTheirs);
    CHECK(desk.aboard() == "another");
    isCount ? desk.count(desk.ours) : desk.ack(desk.ours);
    CHECK(desk.aboard() == "ours");
  }
}

TEST_CASE("a PX4 that has no plan, and names none, has not ours") {
  Desk desk;
  desk.upload();
  desk.current(0, 2, desk.ours);
  desk.current(0, 0xFFFF, 0, kNoMission);
  CHECK(desk.aboard() == "another");
  Desk fresh;
  fresh.upload();
  std::string story;
  for (int i = 0; i < 4; ++i) {
    fresh.current(0, 0xFFFF, 0, kNoMission);
    story += fresh.aboard() + " ";
  }
  CHECK(story == "ours ours ours another ");
}

TEST_CASE("a plan that PX4 accepts and then reports twice as no mission is not feasible") {
  const struct {
    std::initializer_list<int> states;
    bool isFeasible;
  } kCases[] = {
      {{1}, true}, {{1, 1}, false}, {{1, 3, 1}, true}, {{3, 3, 3}, true}, {{1, 3, 1, 1}, false}, {{3, 1, 1}, false},
  };
  for (const auto& one : kCases) {
    Desk desk;
    desk.upload();
    for (int state : one.states) desk.current(0, 2, desk.ours, static_cast<uint8_t>(state));
    desk.run(5);
    CHECK((desk.client.status() == Status::Infeasible) == !one.isFeasible);
  }
  // An older name between is no report of ours, and an answer without a name says nothing about it.
  Desk older;
  older.upload();
  older.current(0, 2, kTheirs);
  older.current(0, 2, older.ours, kNoMission);
  CHECK((older.client.status() != Status::Infeasible));
  older.ack(0);
  older.current(0, 2, older.ours, kNoMission);
  CHECK((older.client.status() == Status::Infeasible));
  Desk arduPilot(ClientOnLine::kArduPilot);
  arduPilot.upload();
  for (int i = 0; i < 3; ++i) arduPilot.current(1, 2, 0, kNoMission);
  CHECK((arduPilot.client.status() != Status::Infeasible));
  // The name is another one's, or an answer has named the plan between the two.
  Desk other;
  other.upload();
  other.current(0, 2, other.ours);
  other.current(0, 2, kTheirs, kNoMission);
  other.current(0, 2, kTheirs, kNoMission);
  CHECK((other.client.status() != Status::Infeasible));
  Desk between;
  between.upload();
  between.current(0, 2, between.ours, kNoMission);
  between.count(between.ours);
  between.current(0, 2, between.ours, kNoMission);
  CHECK((between.client.status() != Status::Infeasible));
  between.current(0, 2, between.ours, kNoMission);
  CHECK((between.client.status() == Status::Infeasible));
}

TEST_CASE("a plan that PX4 rejects in words is not feasible") {
  const struct {
    const char* words;
    bool isRejected;
  } kTexts[] = {{"Mission rejected: no takeoff", true},
                {"Mission rejected", true},
                {"Mission rejecte", false},
                {"Mission rejectex", false},
                {" Mission rejected", false},
                {"Mission accepted", false}};
  for (const auto& text : kTexts) {
    for (uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
      CAPTURE(text.words);
      Desk desk(autopilot);
      desk.upload();
      desk.say(text.words);
      const bool isRejected = text.isRejected && autopilot == ClientOnLine::kPx4;
      CHECK((desk.client.status() == Status::Infeasible) == isRejected);
      CHECK(desk.texts == "6 " + std::string(text.words) + ". ");
    }
  }
}

// --- Whose plan it is, on ArduPilot

TEST_CASE("ArduPilot's total is that of our plan, or it is another one when it says so twice") {
  const struct {
    uint16_t before;  // our plan: 0: nothing is heard
    std::initializer_list<uint16_t> totals;
    const char* story;
  } kCases[] = {
      {0, {2, 2, 2, 2}, "ours ours ours ours "},
      {0, {2, 3, 3, 3, 2, 2}, "ours ours another another another another "},  // a total is no name: it is not back
      {0, {2, 3, 2, 3, 3}, "ours ours ours ours another "},
      {0, {2, 0, 0}, "ours ours another "},
      {0, {2, 0xFFFF, 0xFFFF}, "ours ours another "},
      {0, {3, 3, 3, 3}, "ours another another another "},
      {5, {5, 5, 5, 5, 5}, "ours ours ours another another "},
      {5, {5, 3, 3, 3}, "ours ours another another "},
      {5, {5, 2, 3, 3}, "ours ours ours another "},
      {5, {5, 5, 5, 3, 3}, "ours ours ours another another "},
  };
  for (const auto& one : kCases) {
    Desk desk(ClientOnLine::kArduPilot);
    desk.run(3500);
    if (one.before != 0) desk.current(1, one.before);
    desk.upload();
    std::string story;
    for (uint16_t total : one.totals) {
      desk.current(1, total);
      story += desk.aboard() + " ";
    }
    CHECK(story == one.story);
  }
}

TEST_CASE("a plan that was verified is another one at the first report of another total") {
  Desk first(ClientOnLine::kArduPilot);
  first.upload();
  for (uint16_t total : {2, 3}) {
    Desk desk(ClientOnLine::kArduPilot);
    desk.run(3500);
    desk.verify(first.items);
    REQUIRE((desk.ended == Status::Verified));
    REQUIRE(desk.aboard() == "ours");
    desk.current(1, total);
    CHECK(desk.aboard() == (total == 2 ? "ours" : "another"));
  }
}

TEST_CASE("a total that comes before the state is known counts when it comes twice behind that") {
  Desk desk(ClientOnLine::kArduPilot);
  desk.upload();
  desk.current(1, 2);
  desk.current(1, 3, 0, 0);
  desk.current(1, 3);
  CHECK(desk.aboard() == "ours");
  desk.current(1, 3);
  CHECK(desk.aboard() == "another");
}

TEST_CASE("ArduPilot's words about an upload that is not ours tell of another plan") {
  const struct {
    const char* words;
    bool isAboutPlan;
  } kTexts[] = {{"Flight plan received", true},
                {"Mission upload timeout", true},
                {"Flight pl", true},
                {"Flight p", false},
                {"Flight px", false},
                {"Mission up", true},
                {"Mission u", false},
                {"Mission uq", false},
                {"Mission: 3 WP", false},
                {"Flight mode", false},
                {"A Flight plan", false}};
  for (const auto& text : kTexts) {
    CAPTURE(text.words);
    for (uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
      Desk desk(autopilot);
      desk.upload();
      desk.run(5000);
      desk.say(text.words);
      const bool isAnother = text.isAboutPlan && autopilot == ClientOnLine::kArduPilot;
      CHECK(desk.aboard() == (isAnother ? "another" : "ours"));
    }
  }
}

TEST_CASE("one such text belongs to our own upload, within three heartbeats of its acceptance") {
  for (uint32_t seconds : {0u, 1u, 2u, 3u}) {
    CAPTURE(seconds);
    Desk desk(ClientOnLine::kArduPilot);
    desk.upload();
    desk.run(1000 * seconds);
    desk.say("Flight plan received");
    CHECK(desk.aboard() == (seconds == 3 ? "another" : "ours"));
    desk.say("Flight plan received");
    CHECK(desk.aboard() == "another");
  }
}

TEST_CASE("while we transfer a plan the words are about that, and during a command they are not") {
  Desk desk(ClientOnLine::kArduPilot);
  desk.upload();
  desk.run(5000);
  desk.client.arm();
  desk.run(20);
  REQUIRE((desk.client.status() == Status::Transferring));
  desk.say("Mission upload timeout");
  CHECK(desk.aboard() == "another");
  Desk verifying(ClientOnLine::kArduPilot);
  verifying.upload();
  verifying.run(5000);
  verifying.client.verify(inRam(kPlan));
  REQUIRE(verifying.runUntilSent(ClientOnLine::kRequestList, 100));
  verifying.say("Mission upload timeout");
  CHECK(verifying.aboard() == "ours");
}

TEST_CASE("the acceptance of another station's item gives no words of ours to come") {
  Desk desk(ClientOnLine::kArduPilot);
  desk.upload();
  desk.run(5000);
  desk.ack(0);
  CHECK(desk.aboard() == "ours");
  desk.say("Flight plan received");
  CHECK(desk.aboard() == "another");
}
