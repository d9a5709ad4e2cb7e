// A MissionFollower beside a client: what it requests, what it tells of the mission, and whose plan it takes it for.
#include "mavmission/service/MissionFollower.h"

#include <doctest/doctest.h>

#include <initializer_list>
#include <sstream>
#include <string>
#include <vector>

#include "PlanFrames.h"
#include "Px4Checksum.h"
#include "ToldClient.h"

using namespace mavmission;

namespace {

constexpr uint16_t kNoItem = MissionClient::kNoItem;
constexpr uint8_t kArduPilot = ClientOnLine::kArduPilot, kPx4 = ClientOnLine::kPx4;
constexpr uint32_t kTheirs = 0x9876;
constexpr uint8_t kNoMission = 1, kActive = 3;
const MissionItem kPlan[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 20_m), returnToLaunch()};

void append(std::string& list, const std::string& word) { list += (list.empty() ? "" : " ") + word; }

struct Desk : ToldClient {
  MissionFollower follower;
  std::string currents, reacheds, texts;  // what the functions were called with
  const bool isPx4;
  uint32_t ours = 0;                              // PX4's name for our plan
  std::vector<mavlink_mission_item_int_t> items;  // of it, as they were sent

  explicit Desk(uint8_t autopilot = kPx4) : ToldClient(autopilot), follower(client), isPx4(autopilot == kPx4) {
    follower.onCurrent(noteNumber, &currents);
    follower.onReached(noteNumber, &reacheds);
    follower.onText(noteText, &texts);
  }

  static void noteNumber(void* list, uint16_t item) { append(*static_cast<std::string*>(list), std::to_string(item)); }
  static void noteText(void* list, uint8_t severity, const char* text) {
    *static_cast<std::string*>(list) += std::to_string(severity) + " " + text + ". ";
  }

  // The items are those on the wire.
  void current(uint16_t item, uint16_t total = 2, uint32_t name = 0, uint8_t state = kActive) {
    tell("MISSION_CURRENT seq " + std::to_string(item) + " total " + std::to_string(total) + " mission_state " +
         std::to_string(state) + " mission_id " + std::to_string(name));
  }
  void reached(uint16_t item) { tell("MISSION_ITEM_REACHED seq " + std::to_string(item)); }
  void say(const std::string& words) { tell("STATUSTEXT severity 6 id 0x4141 text " + words); }
  // Heard alone, armed or not.
  void beat(bool isArmed) {
    beats = false;
    hear(heartbeatParts(kPx4, isArmed ? MAV_MODE_FLAG_SAFETY_ARMED : 0));
  }

  // Our plan is put aboard, from the beginning to the last item...
  void transfer() {
    client.uploadWithoutReadback(inRam(kPlan));
    REQUIRE(runUntilSent(kCount, 3000));
    for (uint16_t item = 0; item < (isPx4 ? 2 : 3); ++item) {
      hear(requestParts(item));
      REQUIRE(runUntilSent(kItemInt, 50));
      items.push_back(messageIn<mavlink_mission_item_int_t>(sent.back().payload));
      if (isPx4) ours = px4Checksum(item == 0 ? 0 : ours, items.back());
    }
  }
  // ... and accepted.
  void upload() {
    run(3500);
    transfer();
    hear(ackParts(MAV_MISSION_ACCEPTED, 1, 191, 0, ours));
    run(1);
    REQUIRE((ended == Status::Accepted));
    REQUIRE(follower.isOurPlan());
  }
  // An ArduPilot has these items, and our client reads them.
  void verify(const std::vector<mavlink_mission_item_int_t>& held) {
    client.verify(inRam(kPlan));
    REQUIRE(runUntilSent(kRequestList, 3000));
    sent.clear();
    tell(countParts(static_cast<uint16_t>(held.size())));
    for (size_t i = 0; client.isBusy() && (i < sent.size() || runUntilSent(kRequestInt, 100)); ++i) {
      if (sent[i].messageId != kRequestInt) continue;
      mavlink_mission_item_int_t item = held.at(sent[i].payload[0]);
      item.target_component = 191;
      if (item.seq == 0) {  // home, which is the autopilot's own
        item.command = MAV_CMD_NAV_WAYPOINT;
        item.frame = MAV_FRAME_GLOBAL;
      }
      tell(FrameParts(MAVLINK_MSG_ID_MISSION_ITEM_INT, item, MAVLINK_MSG_ID_MISSION_ITEM_INT_CRC));
    }
    run(5);
  }
  // Whose plan the follower takes it for: "ours", "another", "not known"; or that the client says "infeasible".
  std::string aboard() const {
    CHECK(follower.isOurPlan() == (client.aboard() == Aboard::OurPlan));
    if (client.status() == Status::Infeasible) return "infeasible";
    return client.aboard() == Aboard::OurPlan ? "ours" : client.aboard() == Aboard::OtherPlan ? "another" : "not known";
  }

  // What is heard, one after the other: "ours, theirs of 3, ack theirs fence, says words". Whose plan it is after
  // each.
  std::string hears(const std::string& script) {
    std::string story;
    std::istringstream all(script);
    for (std::string one; std::getline(all, one, ',');) {
      event(one.substr(one.find_first_not_of(' ')));
      append(story, aboard());
    }
    return story;
  }
  // MISSION_CURRENT with the name of a plan, "ours", "theirs", "unnamed" or a number, or ArduPilot's, which has none:
  // "total 3". "of 3" is its total; its state is "active" unless it is "no mission" or "unknown".
  void event(const std::string& text) {
    std::istringstream words(text);
    std::string first, second, third;
    words >> first >> second >> third;
    // To another station's download or upload.
    const auto answer = [&](const std::string& message) {
      tell(message + " target_system 255 target_component 190 opaque_id " + std::to_string(nameOf(second)) +
           (third == "fence"   ? " mission_type 1"
            : third == "error" ? " type 1"
                               : ""));
    };
    const uint8_t state = text.find("no mission") != std::string::npos ? kNoMission
                          : text.find("unknown") != std::string::npos  ? 0
                                                                       : kActive;
    if (first == "wait") return run(static_cast<uint32_t>(std::stoul(second)));
    if (first == "says") return say(text.substr(5));
    if (first == "count") return answer("MISSION_COUNT count 2");
    if (first == "ack") return answer("MISSION_ACK");
    if (first == "total") return current(1, static_cast<uint16_t>(std::stoul(second)), 0, state);
    current(0, second == "of" ? static_cast<uint16_t>(std::stoul(third)) : 2, nameOf(first), state);
  }
  uint32_t nameOf(const std::string& word) const {
    if (word == "ours") return ours;
    if (word == "theirs") return kTheirs;
    return word == "unnamed" ? 0 : static_cast<uint32_t>(std::stoul(word));
  }

  // The mission as the follower has it: "1 of 7 active, reached 0".
  std::string mission() const {
    const auto number = [](uint16_t item) { return item == kNoItem ? "none" : std::to_string(item); };
    static const char* const kStates[] = {"not known", "no mission", "not started", "active", "paused", "complete"};
    return number(follower.currentItem()) + " of " + std::to_string(follower.total()) + " " +
           kStates[static_cast<uint8_t>(follower.state())] + ", reached " + number(follower.reachedItem());
  }
  // MISSION_CURRENT of an item, 100 + one that is reached, or 200: the mission is complete.
  void fly(std::initializer_list<uint16_t> messages) {
    for (uint16_t message : messages) {
      if (message == 200) {
        current(3, 4, 0, 5);
      } else {
        message >= 100 ? reached(static_cast<uint16_t>(message - 100)) : current(message, 4);
      }
    }
  }
};

}  // namespace

// --- The request

TEST_CASE("MISSION_CURRENT is requested when none has come for two seconds, and again after 2, 4, 8 s, up to 64") {
  Desk desk;
  const uint32_t fromMs = desk.nowMs();
  desk.run(260000);
  CHECK(desk.requests(42, 1000, fromMs) == "2002 4002 8002 16002 32002 64002 128002 192002 256002");
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
  CHECK(desk.requests(42, 1000, fromMs) == "21502 23502 27502");
}

TEST_CASE("heartbeats that come more often do not bring a second request before the answer to the first") {
  Desk desk;
  const uint32_t fromMs = desk.nowMs();
  for (int i = 0; i < 18; ++i) {
    desk.beat(false);
    desk.run(100);
  }
  CHECK(desk.requests(42, 1000, fromMs) == "202 1702");
}

TEST_CASE("a request that has no room waits for the next heartbeat after that") {
  Desk desk;
  desk.run(500);
  const uint32_t fromMs = desk.nowMs() - 500;
  desk.line.room = 0;
  desk.run(5000);  // our heartbeat is waiting to go out
  desk.line.room = MemoryStream::kAlwaysRoom;
  desk.run(1500);
  CHECK(desk.requests(42, 1000, fromMs) == "6002");
}

TEST_CASE("the answer to the request lets another listener ask at once") {
  for (bool isAnswered : {true, false}) {
    ToldClient desk(kPx4);
    AttitudeListener attitude(desk.client, 1000);
    MissionFollower follower(desk.client);  // hears before the other
    desk.run(2500);                         // both are due at the third heartbeat
    CHECK(desk.requests(30, 1000) == "65002");
    CHECK(desk.requests(42, 1000) == "67002");
    desk.hear(commandAckParts(isAnswered ? MAV_CMD_SET_MESSAGE_INTERVAL : MAV_CMD_REQUEST_MESSAGE, MAV_RESULT_DENIED));
    desk.run(10);
    CHECK(desk.requests(30, 1000) == (isAnswered ? "65002 67502" : "65002"));
  }
}

// --- The mission

TEST_CASE("the current item, the total and the state are those of the last MISSION_CURRENT") {
  for (uint8_t autopilot : {kArduPilot, kPx4}) {
    const uint16_t home = autopilot == kArduPilot ? 1 : 0;  // counted as an item on the wire
    Desk desk(autopilot);
    CHECK(desk.mission() == "none of 0 not known, reached none");
    CHECK_FALSE(desk.follower.isOurPlan());
    desk.run(3500);
    desk.current(home + 0, 7, 0, 2);
    CHECK(desk.mission() == "0 of 7 not started, reached none");
    desk.current(home + 1, 0xFFFE);
    desk.current(home + 1, 0xFFFE);
    CHECK(desk.mission() == "1 of 65534 active, reached none");
    desk.current(home + 5, 0xFFFF, 0, 4);
    CHECK(desk.mission() == "5 of 0 paused, reached none");
    desk.tell("MISSION_CURRENT seq 3 total 9 mission_state 3", 2);  // another aircraft's
    desk.tell("MISSION_ITEM_REACHED seq 3", 2);
    CHECK(desk.mission() == "5 of 0 paused, reached none");
    CHECK(desk.currents == "0 1 5");
    CHECK(desk.reacheds.empty());
    // As an older autopilot sends it, which has no more than the item.
    desk.tell(messagePartsV1("MISSION_CURRENT seq " + std::to_string(home + 3)));
    CHECK(desk.mission() == "3 of 0 not known, reached none");
  }
}

TEST_CASE("home is no item, and the one after it is told again") {
  Desk desk(kArduPilot);
  desk.run(3500);
  desk.current(1);
  desk.current(0);
  desk.reached(0);
  CHECK(desk.mission() == "none of 2 active, reached none");
  desk.current(1);
  CHECK(desk.currents == "0 0");
  CHECK(desk.reacheds.empty());
}

TEST_CASE("from each arming on no item is reached until one is, though PX4 repeats the last flight's") {
  Desk desk;
  desk.run(3500);
  for (int flight = 0; flight < 2; ++flight) {
    desk.beat(true);
    desk.run(50);
    CHECK(desk.follower.reachedItem() == kNoItem);
    if (flight != 0) desk.reached(1);
    CHECK(desk.follower.reachedItem() == kNoItem);
    desk.fly({0, 1, 101});
    desk.beat(false);
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
  CHECK(desk.mission() == "1 of 2 active, reached 1");
  CHECK(desk.currents.empty());
  CHECK(desk.reacheds.empty());
  CHECK(desk.texts.empty());
}

TEST_CASE("an item is reached once, however often PX4 says so, and again when it is flown again") {
  const struct {
    std::initializer_list<uint16_t> messages;
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
    desk.fly(flight.messages);
    CHECK(desk.reacheds == flight.reached);
    CHECK(std::to_string(desk.follower.reachedItem()) == desk.reacheds.substr(desk.reacheds.rfind(' ') + 1));
  }
}

TEST_CASE("in flight an item that lies behind is told once, in order, whatever was lost") {
  const struct {
    bool isArmed;
    std::initializer_list<uint16_t> messages;
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
    desk.beat(flight.isArmed);
    desk.run(2000);
    desk.fly(flight.messages);
    CHECK(desk.reacheds == flight.reached);
  }
}

TEST_CASE("items that a command of the client's leaves out are not told of as reached") {
  Desk desk;
  desk.beat(true);
  desk.run(2000);
  desk.beat(true);
  desk.current(0, 9);
  desk.client.setCurrentItem(5);
  desk.run(20);
  desk.current(5, 9);
  desk.hear(commandAckParts(MAV_CMD_DO_SET_MISSION_CURRENT, MAV_RESULT_ACCEPTED));
  desk.run(20);
  REQUIRE((desk.ended == Status::Done));
  desk.current(6, 9);
  CHECK(desk.reacheds == "5");
}

TEST_CASE("each text is given with its severity, and ends after 50 characters") {
  Desk desk;
  desk.run(3500);
  desk.tell("STATUSTEXT severity 2 text first");
  desk.tell("STATUSTEXT severity 7 id 0x4141 text " + std::string(50, 'x'));  // its id lies after the text
  desk.tell("STATUSTEXT text foreign", 2);
  desk.tell("STATUSTEXT severity 5");
  CHECK(desk.texts == "2 first. 7 " + std::string(50, 'x') + ". 5 . ");
}

// --- Whose plan it is: our own was accepted, and then somebody speaks

TEST_CASE("PX4 names our plan, and another name is another plan's") {
  const struct {
    const char *before, *heard, *story;  // before our upload, and after it
  } kCases[] = {
      {"", "ours, ours, ours, ours, ours, theirs, theirs, ours", "ours ours ours ours ours another another ours"},
      {"", "ours, unnamed, theirs", "ours ours another"},
      // An older name may come up to three times after the acceptance...
      {"theirs", "theirs, ours, theirs", "ours ours another"},
      {"theirs", "theirs, theirs, theirs, ours, theirs", "ours ours ours ours another"},
      {"theirs", "theirs, theirs, theirs, theirs, ours, theirs", "ours ours ours another ours another"},
      // ... and with another total it is somebody else's, which is believed when it comes twice.
      {"theirs", "theirs of 3, theirs of 3", "ours another"},
      // A PX4 that has no plan, and names none, has not ours.
      {"", "ours, unnamed of 65535 no mission", "ours another"},
      {"",
       "unnamed of 65535 no mission, unnamed of 65535 no mission, unnamed of 65535 no mission, "
       "unnamed of 65535 no mission",
       "ours ours ours another"},
      // The answer to another station names the plan at once. An older firmware names none, and a fence is no mission.
      {"", "ours, ack unnamed, ack theirs fence, ack theirs error, ack ours", "ours ours ours ours ours"},
      {"", "ours, ack theirs, ack ours, ack 1, ack ours, ack theirs, ack ours",
       "ours another ours another ours another ours"},
      {"", "ours, count unnamed, count theirs fence, count ours", "ours ours ours ours"},
      {"", "ours, count theirs, count ours, count 1, count ours, count theirs, count ours",
       "ours another ours another ours another ours"},
      // A plan that PX4 accepts and then reports twice as no mission is not feasible...
      {"", "ours no mission, ours no mission", "ours infeasible"},
      {"", "ours no mission, ours, ours no mission, ours no mission", "ours ours ours infeasible"},
      {"", "ours, ours, ours, ours no mission, ours no mission", "ours ours ours ours infeasible"},
      // ... where neither an older name between, nor an answer without a name, says anything about it, ...
      {"", "theirs, ours no mission, ack unnamed, ours no mission", "ours ours ours infeasible"},
      // ... unless the name is another one's, or an answer has named the plan between the two.
      {"", "ours, theirs no mission, theirs no mission", "ours another another"},
      {"", "ours no mission, count ours, ours no mission, ours no mission", "ours ours ours infeasible"},
  };
  for (const auto& one : kCases) {
    CAPTURE(one.heard);
    Desk desk;
    desk.run(3500);
    desk.hears(one.before);
    desk.upload();
    CHECK(desk.hears(one.heard) == one.story);
  }
}

TEST_CASE("ArduPilot's total is that of our plan, or it is another one when it says so twice") {
  const struct {
    const char *before, *heard, *story;
  } kCases[] = {
      {"", "total 2, total 2, total 2, total 2", "ours ours ours ours"},
      {"", "total 2, total 3, total 3, total 3, total 2, total 2",  // a total is no name: it is not back
       "ours ours another another another another"},
      {"", "total 2, total 3, total 2, total 3, total 3", "ours ours ours ours another"},
      {"", "total 2, total 0, total 0", "ours ours another"},
      {"", "total 2, total 65535, total 65535", "ours ours another"},
      {"", "total 3, total 3, total 3, total 3", "ours another another another"},
      {"total 5", "total 5, total 5, total 5, total 5, total 5", "ours ours ours another another"},
      {"total 5", "total 5, total 3, total 3, total 3", "ours ours another another"},
      {"total 5", "total 5, total 2, total 3, total 3", "ours ours ours another"},
      {"total 5", "total 5, total 5, total 5, total 3, total 3", "ours ours ours another another"},
      // One that comes before the state is known counts when it comes twice after that.
      {"", "total 2, total 3 unknown, total 3, total 3", "ours ours ours another"},
      // Nothing is infeasible here.
      {"", "total 2 no mission, total 2 no mission, total 2 no mission", "ours ours ours"},
      // One text about an upload belongs to our own, within three heartbeats of its acceptance.
      {"", "says Flight plan received, says Flight plan received", "ours another"},
      {"", "wait 2000, says Flight plan received, says Flight plan received", "ours ours another"},
      {"", "wait 3000, says Flight plan received, says Flight plan received", "ours another another"},
      // The acceptance of another station's item gives no words of ours to come.
      {"", "wait 5000, ack unnamed, says Flight plan received", "ours ours another"},
  };
  for (const auto& one : kCases) {
    CAPTURE(one.heard);
    Desk desk(kArduPilot);
    desk.run(3500);
    desk.hears(one.before);
    desk.upload();
    CHECK(desk.hears(one.heard) == one.story);
  }
}

TEST_CASE("ArduPilot's words about an upload that is not ours tell of another plan, and PX4's of a rejected one") {
  const struct {
    const char *words, *onArduPilot, *onPx4;
  } kTexts[] = {
      {"Flight plan received", "another", "ours"},
      {"Mission upload timeout", "another", "ours"},
      {"Flight pl", "another", "ours"},
      {"Flight p", "ours", "ours"},
      {"Flight px", "ours", "ours"},
      {"Mission up", "another", "ours"},
      {"Mission u", "ours", "ours"},
      {"Mission uq", "ours", "ours"},
      {"Mission: 3 WP", "ours", "ours"},
      {"Flight mode", "ours", "ours"},
      {"A Flight plan", "ours", "ours"},
      {"Mission rejected: no takeoff", "ours", "infeasible"},
      {"Mission rejected", "ours", "infeasible"},
      {"Mission rejecte", "ours", "ours"},
      {"Mission rejectex", "ours", "ours"},
      {" Mission rejected", "ours", "ours"},
      {"Mission accepted", "ours", "ours"},
  };
  for (const auto& text : kTexts) {
    for (uint8_t autopilot : {kArduPilot, kPx4}) {
      CAPTURE(text.words);
      Desk desk(autopilot);
      desk.upload();
      desk.run(5000);
      desk.say(text.words);
      CHECK(desk.aboard() == (autopilot == kPx4 ? text.onPx4 : text.onArduPilot));
      CHECK(desk.texts == "6 " + std::string(text.words) + ". ");
    }
  }
}

TEST_CASE("a plan that was verified is another one at the first report of another total") {
  Desk first(kArduPilot);
  first.upload();
  for (uint16_t total : {2, 3}) {
    Desk desk(kArduPilot);
    desk.run(3500);
    desk.verify(first.items);
    REQUIRE((desk.ended == Status::Verified));
    REQUIRE(desk.aboard() == "ours");
    desk.current(1, total);
    CHECK(desk.aboard() == (total == 2 ? "ours" : "another"));
  }
}

TEST_CASE("while we transfer a plan the words are about that, and during a command they are not") {
  Desk desk(kArduPilot);
  desk.upload();
  desk.run(5000);
  desk.client.arm();
  desk.run(20);
  REQUIRE((desk.client.status() == Status::Transferring));
  desk.say("Mission upload timeout");
  CHECK(desk.aboard() == "another");
  Desk verifying(kArduPilot);
  verifying.upload();
  verifying.run(5000);
  verifying.client.verify(inRam(kPlan));
  REQUIRE(verifying.runUntilSent(ClientOnLine::kRequestList, 100));
  verifying.say("Mission upload timeout");
  CHECK(verifying.aboard() == "ours");
}
