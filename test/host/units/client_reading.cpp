// Downloads and verifications by a whole client.
#include <doctest/doctest.h>

#include "Conversation.h"

using namespace mavmission;

namespace {

constexpr uint8_t kArduPilot = Conversation::kArduPilot, kPx4 = Conversation::kPx4, kOther = Conversation::kOther;

// A reading of a plan of eight items, each of which has its number in it.
struct Reading : Conversation {
  std::vector<uint16_t> taken;

  explicit Reading(uint8_t autopilot, const std::string& before = "") : Conversation(autopilot) {
    held.assign(8, waypoint(-35_deg, 149_deg, 20_m));
    for (uint16_t seq = 0; seq < 8; ++seq) held[seq].param1 = seq;
    client.download(toFunction(take, this));
    plays("until LIST, 5 ms, " + before);
  }
  static bool take(void* context, uint16_t index, const MissionItem& item) {
    Reading& reading = *static_cast<Reading*>(context);
    CHECK(item.param1 == static_cast<uint16_t>(index + (reading.isArduPilot() ? 1 : 0)));
    reading.taken.push_back(index);
    return true;
  }
  // These come at once.
  void give(const std::vector<uint16_t>& items) {
    for (const uint16_t seq : items) hear(itemParts(seq, held[seq]));
  }
  // Each of ArduPilot's items has been taken once, home first.
  void checkAllTaken() {
    CHECK((ended == Status::Downloaded));
    CHECK(client.itemsDone() == 7);
    CHECK(taken == std::vector<uint16_t>{0xFFFF, 0, 1, 2, 3, 4, 5, 6});
  }
};

}  // namespace

TEST_CASE("an autopilot that is neither is asked for an item twice by the new request, then by both in turns") {
  const std::string inTurns = ", OLD REQUEST 0, REQUEST 0";
  CHECK(Reading(kOther).plays("count 3, 3 s") ==
        "REQUEST 0 x2" + inTurns + inTurns + inTurns + ", -> TimedOut (NotKnown), ACK cancelled");
  CHECK(Reading(kPx4).plays("count 3, 3 s") == "REQUEST 0 x8, -> TimedOut (NotKnown), ACK cancelled");
  const std::string ofCopter = Reading(kArduPilot).plays("count 3, 3 s");
  CHECK(ofCopter.compare(0, 11, "REQUEST 0-2") == 0);
  CHECK(ofCopter.find("OLD") == std::string::npos);
}

TEST_CASE("of ArduPilot's items five are asked for, and another one with each that comes") {
  Reading desk(kArduPilot);
  CHECK(desk.plays("count, 15 ms | item 0, 15 ms | item 1, 15 ms | item 2, 15 ms | item 3, item 4, item 5, item 6") ==
        "REQUEST 0-4 | REQUEST 5 | REQUEST 6 | REQUEST 7 |");
  CHECK(desk.plays("item 7") == "-> Downloaded (NotKnown), ACK accepted");
  desk.checkAllTaken();
}

TEST_CASE("several of ArduPilot's items come at once") {
  Reading desk(kArduPilot);
  desk.plays("count, 15 ms");
  desk.give({0, 1, 2, 3, 4});
  CHECK(desk.plays("20 ms") == "REQUEST 5-7");
  desk.give({5, 6, 7});
  desk.pass(20);
  desk.checkAllTaken();
}

TEST_CASE("PX4's items, and those of one that is not known, are asked for one by one") {
  for (const uint8_t autopilot : {kPx4, kOther}) {
    CHECK(Reading(autopilot).plays("count, 15 ms | item 1, 15 ms | item 0, 15 ms") == "REQUEST 0 | | REQUEST 1");
  }
}

TEST_CASE("ArduPilot's items are asked for one by one where update() is called seldom, and the buffer would overflow") {
  Reading desk(kArduPilot);
  desk.hear(countParts(8));
  desk.run(40, 10);
  CHECK(desk.timesOf(Conversation::kRequestInt, 0).size() == 1);
  desk.give({0});
  desk.run(40, 10);
  CHECK(desk.timesOf(Conversation::kRequestInt, 0).size() == 2);
  CHECK(desk.sent.back().payload[0] == 1);
}

TEST_CASE("ArduPilot's items are asked for one by one on a line that has lost something") {
  CHECK(Reading(kArduPilot, "lost").plays("count, 45 ms").compare(0, 11, "REQUEST 0 x") == 0);  // it is not answered
}

TEST_CASE("what comes ahead of a lost item is asked for anew after it, and each is taken once") {
  Reading desk(kArduPilot);
  CHECK(desk.plays("count, 15 ms") == "REQUEST 0-4");
  desk.give({0, 2, 3});  // the request for item 1 is lost
  CHECK(desk.plays("100 ms") == "REQUEST 5");
  desk.give({4, 5});
  CHECK(desk.plays("1 ms | 300 ms") == "| REQUEST 1-5");
  for (uint16_t seq = 1; seq < 8; ++seq) {
    desk.give({seq, seq});  // the line brings it again
    desk.pass(20);
  }
  desk.checkAllTaken();
}

TEST_CASE("an item that was not asked for yet is not taken, whatever has been asked for before it") {
  Reading desk(kArduPilot);
  desk.plays("count, 15 ms");
  desk.give({5, 6, 1, 4, 0, 0});
  CHECK(desk.plays("20 ms") == "REQUEST 5");
  CHECK(desk.taken.size() == 1);
}

TEST_CASE("each of ArduPilot's refusals of several requests is an answer to the same reading") {
  const MissionItem plan[] = {waypoint(-35_deg, 149_deg, 20_m), waypoint(-35_deg, 149_deg, 20_m)};
  Conversation desk(kArduPilot, plan);
  desk.plays("verify, until LIST, count, 15 ms");
  for (int i = 0; i < 3; ++i) desk.hear(ackParts(1));  // somebody has made the plan shorter
  CHECK(desk.plays("100 ms | until LIST 1 s, count 1") == "| LIST, -> Differs in Count (NotKnown), ACK cancelled");
}
