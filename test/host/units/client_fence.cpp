// Short fences by a whole client: ArduPilot accepts one, and may wipe it after the acceptance.
#include <doctest/doctest.h>

#include "Conversation.h"

using namespace mavmission;

namespace {

constexpr uint8_t kArduPilot = Conversation::kArduPilot;
const MissionItem kCircles[] = {
    fenceInsideCircle(-35.36_deg, 149.16_deg, 100_m), fenceInsideCircle(-35.36_deg, 149.17_deg, 100_m),
    fenceInsideCircle(-35.37_deg, 149.16_deg, 100_m), fenceInsideCircle(-35.37_deg, 149.17_deg, 100_m)};
const MissionItem kRally[] = {rallyPoint(-35.36_deg, 149.16_deg, 20_m)};

// A fence of so many circles that is asked for, sent and accepted.
struct Fencing : Conversation {
  explicit Fencing(uint16_t items, uint8_t autopilot = kArduPilot) : Conversation(autopilot) {
    isAbout(inRam(kCircles, items), PlanType::Fence);
    pass(8000);  // what came before can be answered no more
    plays("upload, until COUNT, asks all");
    clockMs = nowMs();
    said = plays("accepted");
  }
  uint32_t clockMs = 0;
  std::string said;
};

}  // namespace

TEST_CASE("a fence of up to three items is read back a second after its acceptance, and a longer one is not") {
  CHECK(Fencing(4).said == "-> Accepted (OurPlan)");
  for (uint16_t items = 1; items <= 3; ++items) {
    Fencing desk(items);
    CHECK(desk.said == "");
    CHECK((desk.client.aboard(PlanType::Fence) == Aboard::NotKnown));
    CHECK(desk.plays("990 ms | until LIST 1 s") == "| LIST of fence");
    desk.plays("count");
    CHECK(desk.plays("items").find("-> Accepted (OurPlan), ACK accepted of fence") != std::string::npos);
  }
}

TEST_CASE("a short fence settles for a second, in its second upload too, whether anything is heard or not") {
  Fencing desk(2);
  desk.plays("silence, until LIST");
  const uint32_t first = desk.nowMs() - desk.clockMs;
  CHECK(desk.plays("count 0") == "COUNT 2 of fence");
  desk.plays("heartbeats, 1200 ms, asks all, silence");
  const uint32_t acceptedMs = desk.nowMs();
  CHECK(desk.plays("accepted, until LIST") == "LIST of fence");
  for (const uint32_t tookMs : {first, desk.nowMs() - acceptedMs}) {
    CHECK(tookMs >= 1000);
    CHECK(tookMs <= 1010);
  }
}

TEST_CASE("a fence that is no short one, and other plans, are read back at once where that is asked for") {
  const std::string always = "upload always, until COUNT, asks all | accepted";
  CHECK(Conversation(kArduPilot, kCircles, PlanType::Fence).plays(always).find("| LIST of fence") != std::string::npos);
  CHECK(Conversation(kArduPilot, kRally, PlanType::Rally).plays(always) ==
        "COUNT 1 of rally, ITEM 0 of rally | LIST of rally");
}

TEST_CASE(
    "while a short fence settles it is not known what is aboard, and a cancel() says nothing, the second time too") {
  Conversation desk(kArduPilot);
  desk.isAbout(inRam(kCircles, 2), PlanType::Fence);
  CHECK(desk.plays("clear, until CLEAR, accepted") == "CLEAR of fence, -> Cleared (Nothing)");
  desk.plays("upload, until COUNT, asks all, accepted");
  CHECK((desk.client.aboard(PlanType::Fence) == Aboard::NotKnown));
  desk.plays("until LIST, count 0, asks all, accepted");
  CHECK((desk.client.aboard(PlanType::Fence) == Aboard::NotKnown));
  CHECK(desk.plays("300 ms, cancel, 5 ms") == "-> Cancelled (NotKnown)");
}

TEST_CASE("an empty fence is accepted after one that lacked a corner, and ensure() of a fence looks for it") {
  const MissionItem corner = anyCommandAt(kFencePolygonInclusion, -35_deg, 149_deg, aboveSeaLevel(0_m), 3);
  const MissionItem unclosed[] = {corner, corner};
  Conversation desk(kArduPilot, unclosed, PlanType::Fence);
  CHECK(desk.plays("upload, 20 ms") == "-> BadFence at 0 in Param1 (NotKnown)");
  CHECK(desk.isAbout(emptyPlan(), PlanType::Fence).plays("upload, until COUNT, accepted") ==
        "COUNT 0 of fence, -> Accepted (OurPlan)");
  CHECK(desk.isAbout(inRam(kCircles), PlanType::Fence).plays("ensure, until LIST, count, items") ==
        "LIST of fence, REQUEST 0 of fence, REQUEST 1 of fence, REQUEST 2 of fence, REQUEST 3 of fence, "
        "-> AlreadyAboard (OurPlan), ACK accepted of fence");
  // In the upload after a look the first denial is not believed, and in the next upload it is.
  CHECK(desk.plays("ensure, until LIST, count 0, until COUNT, denied, cancel, 3 s") ==
        "LIST of fence, ACK cancelled of fence, COUNT 4 of fence, ACK cancelled of fence, -> Cancelled (NotKnown)");
  CHECK(desk.plays("again, until COUNT, denied") == "COUNT 4 of fence, -> Denied (AsBefore)");
}

TEST_CASE("a short fence that was wiped is uploaded once more, and no third time") {
  Fencing desk(2);
  desk.plays("until LIST");
  CHECK(desk.plays("count 0, asks all, accepted | 990 ms | until LIST 1 s") ==
        "COUNT 2 of fence, ITEM 0 of fence, ITEM 1 of fence | | LIST of fence");
  CHECK(desk.plays("count 0, 100 ms") == "-> Differs in Count (NotKnown), ACK cancelled of fence");
  // The next upload has its two tries again.
  CHECK(desk.plays("again, until COUNT, asks all, accepted, until LIST | count 0, 100 ms") ==
        "COUNT 2 of fence, ITEM 0 of fence, ITEM 1 of fence, LIST of fence | COUNT 2 of fence");
}

TEST_CASE("a short fence that was wiped, and is refused then, is not what was aboard before") {
  Fencing desk(2);
  desk.plays("until LIST, count 0");
  CHECK(desk.plays("no space") == "-> NoSpace (NotKnown)");
}

TEST_CASE(
    "a short fence that was wiped is not sent again to an autopilot that is armed by now, unless that is allowed") {
  Fencing desk(2), allowed(2);
  allowed.client.allowWhileArmed(true);
  desk.plays("until LIST, armed");
  allowed.plays("until LIST, armed");
  CHECK(desk.plays("count 0, 100 ms") == "-> Armed (NotKnown)");
  CHECK(allowed.plays("count 0, 100 ms") == "COUNT 2 of fence");
  CHECK((allowed.client.aboard(PlanType::Fence) == Aboard::NotKnown));
}
