// ensure() by a whole client: the look, and what follows it.
#include <doctest/doctest.h>

#include "Conversation.h"

using namespace mavmission;

namespace {

constexpr uint8_t kArduPilot = Conversation::kArduPilot, kPx4 = Conversation::kPx4, kOther = Conversation::kOther;
constexpr MissionItem kPlan[] = {takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m)};

// What follows the first question of a look.
std::string looking(uint8_t autopilot, const std::string& events) {
  Conversation desk(autopilot, kPlan);
  const std::string all = desk.plays("ensure, until LIST | " + events);
  return all.compare(0, 7, "LIST | ") == 0 ? all.substr(7) : "not asked: " + all;
}

}  // namespace

TEST_CASE("the look asks every 1500 ms, up to 5 times, and then says NoAnswer") {
  CHECK(Conversation(kArduPilot, kPlan).plays("ensure, until LIST, clock, 9 s") ==
        "LIST @0 1500 3000 4500 6000, -> NoAnswer (NotKnown) @7500, ACK cancelled @7501");
}

TEST_CASE("a refusal of the look is believed when all attempts are used up, unless an older upload of ours ends") {
  CHECK(looking(kArduPilot, "denied, 3 s | 6 s") == "LIST x2 | LIST x2, -> Denied (NotKnown), ACK cancelled");
  CHECK(looking(kArduPilot, "denied, 100 ms | cancelled, 5 ms") == "| LIST");  // it begins anew at once
  // While items are read it ends the look.
  CHECK(looking(kArduPilot, "count 3, denied") == "REQUEST 0-2, -> Denied (NotKnown), ACK cancelled");
}

TEST_CASE("the reading is closed before MISSION_COUNT leaves, and the first denial of that is not believed") {
  CHECK(looking(kArduPilot, "count 7, until COUNT 600 ms, denied, 100 ms | until COUNT 2 s, denied") ==
        "ACK cancelled, COUNT 3 | COUNT 3, -> Denied (NotKnown)");
}

TEST_CASE("PX4's checksum decides by itself, and the same number of items does not") {
  CHECK(looking(kPx4, "count named 7, until COUNT 600 ms") == "ACK cancelled, COUNT 2");
  CHECK(looking(kPx4, "count") == "REQUEST 0");  // without a checksum it is read
}

TEST_CASE("what was known to be aboard is not known from the question on whether another plan is there") {
  Conversation desk(kArduPilot, kPlan);
  CHECK(desk.plays("clear, until CLEAR 3 s, accepted") == "CLEAR, -> Cleared (Nothing)");
  desk.plays("ensure");
  CHECK((desk.client.aboard() == Aboard::Nothing));
  desk.plays("until LIST 9 s");
  CHECK((desk.client.aboard() == Aboard::NotKnown));
}

TEST_CASE("an item that differs begins the upload, and is forgotten then") {
  Conversation desk(kOther, kPlan);
  desk.held[1].x ^= 1;
  CHECK(desk.plays("ensure, until LIST, count, items, 600 ms") == "LIST, REQUEST 0-1, ACK cancelled, COUNT 2");
  CHECK((desk.client.failedItem() == MissionClient::kNoItem));
  CHECK((desk.client.differingField() == ItemField::None));
  CHECK((desk.client.aboard() == Aboard::NotKnown));
}

TEST_CASE("ensure() of a fence looks for a fence, and without a type for a mission") {
  Conversation desk(kOther), mission(kOther, kPlan);
  CHECK((mission.client.ensure(inRam(kPlan)) == Status::WaitingForAutopilot));
  CHECK(mission.plays("until LIST 3 s, count, items") == "LIST, REQUEST 0-1, -> AlreadyAboard (OurPlan), ACK accepted");
  CHECK(desk.isAbout(emptyPlan(), PlanType::Fence).plays("ensure, until LIST 3 s") == "LIST of fence");
}

TEST_CASE("a look that takes too long ends as such") {
  Conversation desk(kArduPilot, kPlan);
  desk.client.setOperationTimeout(3);
  CHECK(desk.plays("ensure, until LIST, 3100 ms") == "LIST x2, -> TookTooLong (NotKnown), ACK cancelled");
}

TEST_CASE("a look that is denied again and again is taken up after the back-off, and so is the upload after it") {
  Conversation desk(kArduPilot, kPlan), replacing(kArduPilot, kPlan);
  desk.client.retryWhenBusy(60);
  desk.plays("ensure, until LIST, denied, 7600 ms");
  CHECK((desk.client.status() == Status::BackingOff));
  CHECK(desk.plays("800 ms | until LIST 2200 ms") == "| LIST");
  replacing.client.retryWhenBusy(60);
  replacing.plays("ensure, until LIST, count 7, until COUNT 2 s, denied, until COUNT 2 s, denied");
  CHECK((replacing.client.status() == Status::BackingOff));
  CHECK(replacing.plays("until LIST 3 s") == "LIST");  // it looks again
}

TEST_CASE("ACCEPTED and INVALID_SEQUENCE, late answers to something earlier, do not end a look") {
  CHECK(looking(kOther, "accepted, invalid sequence, count, accepted, invalid sequence | items") ==
        "REQUEST 0 | REQUEST 1, -> AlreadyAboard (OurPlan), ACK accepted");
}

TEST_CASE(
    "a COUNT of the look that the line repeats is not the one of the read-back, and is believed the second time") {
  // An empty plan is uploaded after the look, and read back.
  const auto proving = [](const std::string& events) {
    Conversation desk(kArduPilot);
    desk.plays("ensure always, until LIST, count 2, until COUNT 600 ms, accepted, count 2");
    CHECK(desk.timesOf(Conversation::kRequestList, 0).size() == 2);
    return desk.plays(events);
  };
  CHECK(proving("count 1") == "REQUEST 0");  // home
  CHECK(proving("until LIST 2 s, count 2") == "LIST, -> Differs in Count (NotKnown), ACK cancelled");
}
