// ensure() by a whole client: what the look takes for an answer, how it ends, and what the upload after it says.
#include <doctest/doctest.h>

#include <algorithm>

#include "Conversation.h"

using namespace mavmission;

namespace {

constexpr uint8_t kArduPilot = Conversation::kArduPilot, kPx4 = Conversation::kPx4, kOther = Conversation::kOther;
const MissionItem kPlan[] = {anyCommandAt(kNavWaypoint, -35.5_deg, 149.25_deg, 20_m), returnToLaunch()};
const MissionItem kFence[] = {fenceInsideCircle(-35.36_deg, 149.16_deg, 100_m)};

// A look that has asked for the list.
struct Looking : Conversation {
  explicit Looking(uint8_t autopilot, const std::string& call = "ensure", uint32_t startMs = 65000)
      : Conversation(autopilot, kPlan, PlanType::Mission, startMs) {
    plays(call + ", until LIST");
  }
};

struct Source {
  int left;  // how often it can be read
  ItemSource source() { return fromFunction(read, 2, this); }
  static bool read(void* context, uint16_t index, MissionItem& item) {
    item = kPlan[index];
    return static_cast<Source*>(context)->left-- > 0;
  }
};

// PX4 gives a takeoff the place of the next item that has one: the library looks for it in several steps.
bool readFarPlace(void*, uint16_t index, MissionItem& item) {
  item = index == 0 ? takeoff(20_m) : index == 12 ? kPlan[0] : changeSpeed(5_mps);
  return true;
}

}  // namespace

TEST_CASE("PX4's checksum shows that the plan is aboard, and its reading is closed") {
  Conversation desk(kPx4, kPlan);
  for (int times = 0; times < 2; ++times) {
    desk.progress = "";
    desk.plays("ensure, until LIST");
    CHECK(desk.client.itemsTotal() == 2);
    CHECK(desk.plays("count named ours") == "-> AlreadyAboard (OurPlan), ACK cancelled");
    CHECK(desk.client.itemsDone() == 2);
    CHECK(desk.progress == "2/2 ");
  }
}

TEST_CASE("any other autopilot's plan is read, without progress, and its end is confirmed") {
  for (const uint8_t autopilot : {kArduPilot, kOther}) {
    Looking desk(autopilot);
    desk.plays("count named 7");
    CHECK(desk.progress == "");
    desk.plays("items");
    CHECK((desk.ended == Status::AlreadyAboard));
    CHECK((desk.client.aboard() == Aboard::OurPlan));
    CHECK(desk.progress == "2/2 ");
    CHECK(desk.client.lastResult() == 255);
  }
  Looking desk(kOther);
  desk.plays("count, item 0");
  CHECK(desk.progress == "");
  CHECK(desk.client.itemsDone() == 0);
  CHECK(desk.plays("cancel, 5 ms") == "ACK cancelled, -> Cancelled (NotKnown)");
}

TEST_CASE("an armed autopilot with our plan is fine, and with another one it is left alone, whatever is allowed") {
  for (const bool isAllowed : {true, false}) {
    Looking ours(kOther, "armed, ensure"), other(kOther, "armed, ensure");
    ours.client.allowWhileArmed(isAllowed);
    other.client.allowWhileArmed(isAllowed);
    CHECK(ours.plays("count, items") == "REQUEST 0-1, -> AlreadyAboard (OurPlan), ACK accepted");
    CHECK(other.plays("count 3, 100 ms") == "-> Armed in Count (NotKnown), ACK cancelled");
  }
  // Somebody arms it before the upload has begun: the first MISSION_REQUEST_LIST may still be denied.
  CHECK(Looking(kArduPilot).plays("denied, until LIST 2 s, count 7, armed, 1700 ms") ==
        "LIST, ACK cancelled, -> Armed in Count (NotKnown)");
  Looking desk(kOther, "armed, ensure");
  desk.held[1] = kPlan[0];
  CHECK(desk.plays("count, items") == "REQUEST 0-1, -> Armed at 1 in Command (NotKnown), ACK cancelled");
}

TEST_CASE("a value that the autopilot does not keep ends the look before it is asked") {
  const MissionItem plan[] = {anyCommandAt(kNavWaypoint, -35_deg, 149_deg, 20_m, 2.5f)};
  CHECK(Conversation(kArduPilot, plan).plays("ensure, 100 ms") == "-> NotKept at 0 in Param1 (NotKnown)");
}

TEST_CASE("a source that fails while the look is prepared, or while items are compared, ends it") {
  for (int left = 0; left < 4; ++left) {  // checked, and then added up for PX4's checksum
    Source source = {left};
    Conversation desk(kPx4);
    desk.plan = source.source();
    CHECK(desk.plays("ensure, 100 ms") == "-> SourceRefused at " + std::to_string(left % 2) + " (NotKnown)");
  }
  Source source = {3};
  Conversation desk(kOther, kPlan);
  desk.plan = source.source();
  CHECK(desk.plays("ensure, until LIST, count, items, 20 ms") ==
        "LIST, REQUEST 0-1, -> SourceRefused at 1 (NotKnown), ACK cancelled");
}

TEST_CASE("an item whose place has to be searched is compared when that is found") {
  Conversation desk(kPx4);
  desk.isAbout(fromFunction(readFarPlace, 13));
  desk.held[0].x = kPlan[0].x;
  desk.held[0].y = kPlan[0].y;
  desk.plays("ensure, until LIST, count");
  std::string asked;
  for (int i = 0; i < 50 && asked != "REQUEST 1"; ++i) asked = desk.plays("item 0");
  CHECK(asked == "REQUEST 1");
}

TEST_CASE("the look leaves after an update() for each item, and has its whole time when it waited") {
  CHECK(Conversation(kArduPilot, kPlan).plays("10 ms, clock, ensure, 10 ms") == "LIST @5");
  CHECK(Conversation(kOther, kPlan).plays("10 ms, clock, ensure, 10 ms") == "LIST @4");
  Conversation desk(kPx4, 65000, 0);
  desk.isAbout(inRam(kPlan)).client.setOperationTimeout(3);
  CHECK(desk.plays("silence, ensure, 5500 ms") == "");
  CHECK((desk.client.status() == Status::WaitingForAutopilot));
  desk.plays("heartbeats, until LIST, 2980 ms");
  CHECK(desk.client.isBusy());
  CHECK(desk.plays("1040 ms") == "LIST, -> TookTooLong (NotKnown), ACK cancelled");  // it is counted in whole seconds
}

TEST_CASE("the time that is allowed for back-offs begins with the first refusal of the look") {
  Conversation desk(kArduPilot, kPlan);
  desk.client.retryWhenBusy(20);
  desk.plays("ensure, until LIST");
  const uint32_t firstMs = desk.nowMs();
  for (int times = 0; times < 60 && desk.client.isBusy(); ++times) {
    desk.hear(ackParts(14));
    desk.pass(1000);
  }
  CHECK((desk.ended == Status::Denied));
  // Each look is believed to be denied 7.5 s after its beginning, and the pauses are 1 s and 2 s.
  const std::vector<uint32_t> times = desk.timesOf(Conversation::kRequestList, firstMs);
  CHECK(times.size() == 15);
  CHECK(times.back() >= 23000);
  CHECK(times.back() <= 25000);
}

TEST_CASE("a look is taken up at the second at which the back-off ends, whether anything is heard or not") {
  Conversation desk(kArduPilot, kPlan);
  desk.client.retryWhenBusy(60);
  desk.plays("ensure, until LIST, denied");
  while (desk.client.isBusy() && desk.client.status() != Status::BackingOff) desk.pass(1);
  // What was sent again may still be answered, for up to 700 ms.
  CHECK(desk.plays("silence, 999 ms | until LIST 701 ms") == "ACK cancelled | LIST");
  // It begins anew, with the autopilot and the check of the plan.
  const std::vector<Status> expected = {Status::BackingOff, Status::WaitingForAutopilot, Status::Checking,
                                        Status::Transferring};
  REQUIRE(desk.returned.size() >= expected.size());
  CHECK(std::equal(expected.rbegin(), expected.rend(), desk.returned.rbegin()));
}

TEST_CASE("an autopilot that fell silent during the back-off of a look is waited for first") {
  Conversation desk(kOther, kPlan);
  desk.client.retryWhenBusy(60);
  const std::string denied = "until LIST 9 s, count, denied, ";  // 1, 2, 4 and 8 s
  CHECK(desk.plays("ensure, " + denied + denied + denied + denied + "| silence, 10 s") ==
        "LIST, REQUEST 0, ACK cancelled, LIST, REQUEST 0, ACK cancelled, LIST, REQUEST 0, ACK cancelled, LIST, REQUEST "
        "0, "
        "ACK cancelled |");
  CHECK((desk.client.status() == Status::WaitingForAutopilot));
}

TEST_CASE("while a plan is looked at an update() takes half as many bytes, and the whole again after that") {
  Looking looking(kOther), replacing(kOther), ended(kOther, "armed, ensure");
  looking.pass(5);
  const size_t half = looking.readInOne();
  CHECK(half > 16);
  CHECK(half <= MAVMISSION_BYTES_PER_UPDATE / 2);
  replacing.pass(5);
  replacing.hear(countParts(7));
  replacing.pass(1);
  CHECK(replacing.readInOne() > MAVMISSION_BYTES_PER_UPDATE / 2);
  CHECK(ended.plays("count 7") == "-> Armed in Count (NotKnown), ACK cancelled");
  CHECK(ended.readInOne() > MAVMISSION_BYTES_PER_UPDATE / 2);
}

TEST_CASE("while items are looked at an error may be about what was before, and no other refusal is") {
  for (const uint32_t startMs : {0, 65000}) {
    Looking error(kOther, "ensure", startMs);
    error.plays("count, error");
    CHECK(error.client.isBusy());
    CHECK(Looking(kOther, "ensure", startMs).plays("count, denied") ==
          "REQUEST 0, -> Denied (NotKnown), ACK cancelled");
    CHECK(Looking(kOther, "ensure", startMs).plays("count, cancelled") ==
          "REQUEST 0, -> CancelledByAutopilot (NotKnown), ACK cancelled");
  }
}

TEST_CASE(
    "after a reset a denial of the look begins it anew when its attempts are used up, for as long as that may be "
    "ours") {
  Conversation desk(kArduPilot, 0, 0);
  desk.isAbout(inRam(kPlan)).client.setTargetIds(1, 1);
  CHECK(desk.plays("10 ms, ensure, until LIST, denied | 8 s") == "LIST | LIST x5");
  CHECK(desk.client.lastResult() == 255);  // of the look that is under way
  CHECK(desk.plays("9 s") == "LIST x4, -> NoAnswer (NotKnown), ACK cancelled");
}

TEST_CASE("the reading is closed in the frame that is free, before the upload begins") {
  Looking desk(kOther);
  desk.plays("full");
  desk.sent.clear();
  CHECK(desk.plays("count 7, 20 ms | free, until COUNT 600 ms") == "| ACK cancelled, COUNT 2");
  CHECK(desk.sent[0].messageId == 0);
  CHECK(desk.sent[0].payload[6] == 0);   // HEARTBEAT.base_mode
  CHECK(desk.sent[0].payload[4] == 18);  // MAV_TYPE_ONBOARD_CONTROLLER
}

TEST_CASE("what was said of the look is forgotten in the upload after it") {
  Looking desk(kArduPilot);
  desk.plays("denied");
  CHECK(desk.client.lastResult() == 14);
  // The first MISSION_REQUEST_LIST may still be denied.
  CHECK(desk.plays("until LIST 2 s, count 7, 1495 ms | until COUNT 200 ms") == "LIST, ACK cancelled | COUNT 3");
  CHECK(desk.client.lastResult() == 255);
  CHECK((desk.client.differingField() == ItemField::None));
  desk.plays("asks 0, ask 1, ask 2, 10 ms");
  CHECK(desk.client.itemsDone() == 1);
  CHECK(desk.progress == "1/2 ");
}

TEST_CASE("after a look PX4 may still be busy with it, also after one whose upload was denied") {
  const std::string busy = "error, 20 ms, error, 20 ms";
  CHECK(Looking(kPx4, "ensure", 30000).plays("count named ours, upload unread, until COUNT 2 s | " + busy) ==
        "-> AlreadyAboard (OurPlan), ACK cancelled, COUNT 2 | ACK cancelled, COUNT 2");
  CHECK(Looking(kPx4, "ensure", 30000).plays("count named 1, until COUNT 2 s | " + busy) ==
        "ACK cancelled, COUNT 2 | ACK cancelled, COUNT 2");
  CHECK(Looking(kPx4, "ensure", 30000)
            .plays("count named 1, until COUNT 600 ms, denied | until COUNT 2 s, denied | "
                   "upload unread, until COUNT 4 s, " +
                   busy) == "ACK cancelled, COUNT 2 | COUNT 2, -> Denied (NotKnown) | COUNT 2, ACK cancelled, COUNT 2");
}

TEST_CASE("a short fence that settles after a look is cancelled without a word") {
  Conversation desk(kArduPilot, kFence, PlanType::Fence);
  desk.plays("ensure, until LIST, count 0, until COUNT 600 ms, asks 0, accepted, 300 ms");
  CHECK(desk.plays("cancel, 20 ms") == "-> Cancelled (NotKnown)");
}

TEST_CASE(
    "a refusal of the upload after a look says what that leaves, and one that may be about the look says nothing") {
  const auto behind = [](const std::string& events) {
    Looking desk(kArduPilot);
    desk.plays("count 7, until COUNT 600 ms");
    return desk.plays(events);
  };
  CHECK(behind("no space") == "-> NoSpace (AsBefore)");
  CHECK(behind("error") == "-> Error (NotKnown)");
  CHECK(behind("asks 0-1, denied") == "ITEM 0-1, -> Denied at 0 (Mixture)");
  CHECK(behind("asks 0-1, no space") == "ITEM 0-1, -> NoSpace at 0 (Mixture)");
}

TEST_CASE("the read-back after a look takes no COUNT that comes before it has asked") {
  Looking desk(kArduPilot, "ensure always");
  desk.plays("count 7, until COUNT 600 ms, asks all, full");
  CHECK(desk.plays("accepted, count | free, until LIST 50 ms") == "| LIST");
  CHECK(desk.plays("count of fence, count 7 | count, items") ==  // the second is the look's, once more
        "| REQUEST 0-2, -> Accepted (OurPlan), ACK accepted");
}
