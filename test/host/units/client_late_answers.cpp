// What one operation leaves for the next: answers that are still on their way, and what aboard() says.
#include <doctest/doctest.h>

#include "Conversation.h"

using namespace mavmission;

namespace {

constexpr uint8_t kArduPilot = Conversation::kArduPilot;
const MissionItem kPlan[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 20_m)};
const MissionItem kOther[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 40_m), returnToLaunch()};
const MissionItem kRally[] = {rallyPoint(1_deg, 1_deg, 20_m)};

// An upload up to its last item; nothing has answered that.
struct Sent : Conversation {
  explicit Sent(const char* items = "asks all") : Conversation(kArduPilot, kPlan) {
    plays(std::string("8 s, upload unread, until COUNT, ") + items);
  }
};

}  // namespace

TEST_CASE("what follows an upload that has repeated its last item is not ended by the answer to that") {
  for (const std::string next : {"clear", "verify", "upload unread", "arm"}) {
    Sent desk;
    CHECK(desk.plays("until ITEM 2 s, accepted") == "ITEM 1, -> Accepted (OurPlan)");
    if (next != "arm") desk.isAbout(next == "upload unread" ? inRam(kOther) : inRam(kPlan));
    CHECK(desk.plays(next + ", 100 ms, error, 1 s, error, 400 ms | 600 ms") ==
          (next == "clear"    ? "| CLEAR"
           : next == "verify" ? "| LIST"
           : next == "arm"    ? "LONG 400 1 |"  // a command does not wait for answers of the mission protocol
                              : "| COUNT 3"));
    CHECK(desk.client.isBusy());
  }
}

TEST_CASE("after an upload in which a frame came twice it also waits for the copy of that answer") {
  CHECK(Sent().plays("accepted, clear, 700 ms") == "-> Accepted (OurPlan), CLEAR");
  CHECK(Sent().plays("twice, accepted, clear, 700 ms | 200 ms") == "-> Accepted (OurPlan) | CLEAR");
  Conversation before(kArduPilot, kPlan);
  before.plays("8100 ms, twice, beat, upload unread, until COUNT, asks all");
  CHECK(before.plays("accepted, clear, 700 ms") == "-> Accepted (OurPlan), CLEAR");
}

TEST_CASE("ArduPilot gives up an upload that was left open, and the clear or the reading goes on") {
  for (const std::string next : {"clear", "verify"}) {
    Sent desk("asks 0");
    desk.plays("cancel, 2500 ms");
    CHECK(desk.plays(next + ", 10 ms, cancelled") == (next == "clear" ? "CLEAR" : "LIST"));
    CHECK(desk.client.isBusy());
  }
}

TEST_CASE("an empty plan is not accepted while its COUNT waits for room") {
  Conversation desk(kArduPilot, 65000, 0);
  desk.pass(3000);
  REQUIRE(desk.runUntilSent(0, 1100));  // our heartbeat, so that none is due now
  desk.line.room = 4;
  desk.line.takes = 4;
  desk.plays("upload unread, 1 ms");
  desk.line.room = 0;
  CHECK(desk.plays("20 ms, accepted, 15 ms") == "");
  CHECK(desk.client.isBusy());
  desk.line.takes = 1000000;
  CHECK(desk.plays("free, 10 ms, accepted") == "COUNT 0, -> Accepted (OurPlan)");
}

TEST_CASE("aboard() is about the plan that was given last, from its first message on") {
  const struct {
    const char* call;
    ItemSource plan;
    PlanType type;
    Aboard then;
  } kNext[] = {{"verify", inRam(kOther), PlanType::Mission, Aboard::NotKnown},
               {"verify", inRam(kPlan, 2), PlanType::Mission, Aboard::NotKnown},  // a longer part of the same array
               {"upload unread", inRam(kOther), PlanType::Mission, Aboard::NotKnown},
               {"upload unread", inRam(kRally), PlanType::Rally, Aboard::OurPlan}};
  for (const auto& next : kNext) {
    Sent desk;
    CHECK(desk.plays("accepted, verify, cancel, 5 ms") == "-> Accepted (OurPlan), -> Cancelled (OurPlan)");  // the same
    desk.plan = next.plan;
    desk.type = next.type;
    desk.plays(next.call);
    CHECK((desk.client.aboard() == Aboard::OurPlan));
    desk.plays(std::string("until ") + (std::string(next.call) == "verify" ? "LIST" : "COUNT"));
    CHECK((desk.client.aboard() == next.then));
  }
}
