// How an upload ends by a whole client, and what it says about the plan that is aboard then.
#include <doctest/doctest.h>

#include <algorithm>

#include "Conversation.h"

using namespace mavmission;

namespace {

constexpr uint8_t kArduPilot = Conversation::kArduPilot, kPx4 = Conversation::kPx4, kOther = Conversation::kOther;
const MissionItem kPlan[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 20_m), changeSpeed(5_mps), returnToLaunch()};
const MissionItem kFence[] = {fenceInsideCircle(-35.36_deg, 149.16_deg, 100_m)};
const MissionItem kRally[] = {rallyPoint(-35.36_deg, 149.16_deg, 20_m), rallyPoint(-35.37_deg, 149.16_deg, 20_m)};
const MissionItem kNotKept[] = {kPlan[0], kPlan[1], anyCommandAt(kNavWaypoint, -35_deg, 149_deg, 20_m, 2.5f)};

// What follows the COUNT of an upload of the plan.
std::string uploading(uint8_t autopilot, const std::string& events) {
  const std::string all = Conversation(autopilot, kPlan).plays("upload unread, 20 ms | " + events);
  const std::string count = autopilot == kArduPilot ? "COUNT 4 | " : "COUNT 3 | ";
  return all.compare(0, count.size(), count) == 0 ? all.substr(count.size()) : "not announced: " + all;
}

// A source that counts how often it is read, and has nothing any more when it has been read so often.
struct Counted {
  int reads, most;
  ItemSource source(uint32_t items) { return fromFunction(read, items, this); }
  static bool read(void* context, uint16_t index, MissionItem& item) {
    Counted& counted = *static_cast<Counted*>(context);
    item = kPlan[index % 3];
    return ++counted.reads <= counted.most;
  }
};

// PX4 gives a takeoff the place of the next item that has one: the library looks for it in several steps.
bool readFarPlace(void* reads, uint16_t index, MissionItem& item) {
  ++*static_cast<int*>(reads);
  item = index == 0 ? takeoff(20_m) : index == 12 ? kPlan[0] : changeSpeed(5_mps);
  return true;
}

}  // namespace

TEST_CASE("each item is sent as the plan has it, and the number of items before") {
  MissionItem plan[] = {anyCommandAt(kNavWaypoint, -35.3632621_deg, 149.1652374_deg, 20_m, 1, 0, 0, 90),
                        anyCommand(kDoDigicamControl, 1, 2, 3, 4, 5, 6, 7)};
  plan[0].current = 1;
  plan[1].autocontinue = 0;
  Conversation desk(kOther);
  desk.isAbout(inRam(plan));
  for (int upload = 0; upload < 2; ++upload) {  // nothing is left over of the frames before
    CHECK(desk.plays("upload unread, until COUNT") == "COUNT 2");
    const Bytes count = {2, 0, 1, 1, 0, 0, 0, 0, 0};  // to 1/1, a mission, without an opaque_id
    CHECK(std::equal(count.begin(), count.end(), desk.sent.back().payload.begin()));
    for (uint16_t seq = 0; seq < 2; ++seq) {
      desk.plays("asks " + std::to_string(seq));
      Bytes item = itemParts(seq, plan[seq]).payload;
      item[33] = 1;  // to the autopilot
      CHECK(std::equal(item.begin(), item.end(), desk.sent.back().payload.begin()));
    }
    desk.plays("no space");
  }
}

TEST_CASE("progress is told as the autopilot asks on, and the last item is done when all is accepted") {
  for (const uint8_t autopilot : {kArduPilot, kPx4}) {
    const bool hasHome = autopilot == kArduPilot;
    Conversation desk(autopilot, kPlan);
    desk.plays(hasHome ? "upload unread, 20 ms, asks 0-1" : "upload unread, 20 ms, asks 0");
    CHECK(desk.client.itemsTotal() == 3);
    CHECK(desk.progress == "");
    desk.plays(hasHome ? "asks 2" : "asks 1");
    CHECK(desk.client.itemsDone() == 1);
    desk.plays(hasHome ? "asks 3, asks 3, 200 ms" : "asks 2, asks 2, 200 ms");  // the last one twice
    CHECK(desk.progress == "1/3 2/3 ");
    CHECK(desk.plays("accepted") == "-> Accepted (OurPlan)");
    CHECK(desk.client.lastResult() == 0);
    CHECK(desk.progress == "1/3 2/3 3/3 ");
    // In the next one it begins anew.
    desk.plays("upload unread, until COUNT");
    CHECK(desk.client.itemsDone() == 0);
    CHECK(desk.client.lastResult() == 255);
    desk.plays(hasHome ? "asks 0-2" : "asks 0-1");
    CHECK(desk.progress == "1/3 2/3 3/3 1/3 ");
  }
}

TEST_CASE("what a refusal leaves aboard depends on the autopilot, the type, and how far the upload was") {
  const struct {
    uint8_t autopilot, result;
    const char *events, *end;
  } kCases[] = {{kArduPilot, 4, "no space", "-> NoSpace (AsBefore)"},
                {kArduPilot, 1, "error", "-> Error (AsBefore)"},
                {kArduPilot, 4, "asks 0, no space", "ITEM 0, -> NoSpace (Mixture)"},  // home
                {kArduPilot, 4, "asks 0-1, no space", "ITEM 0-1, -> NoSpace at 0 (Mixture)"},
                {kArduPilot, 1, "asks 0-2, error", "ITEM 0-2, -> Error at 1 (Mixture)"},
                {kArduPilot, 4, "asks 0-3, no space", "ITEM 0-3, -> NoSpace at 2 (Mixture)"},
                {kArduPilot, 1, "asks 0-3, error", "ITEM 0-3, -> Error at 2 (NotKnown)"},
                {kPx4, 4, "no space", "-> NoSpace (AsBefore)"},
                {kPx4, 4, "asks 0, no space", "ITEM 0, -> NoSpace at 0 (AsBefore)"},
                {kPx4, 4, "asks 0-2, no space", "ITEM 0-2, -> NoSpace at 2 (AsBefore)"},
                {kOther, 14, "denied", "-> Denied (AsBefore)"},
                {kOther, 14, "asks 0, denied", "ITEM 0, -> Denied at 0 (NotKnown)"},
                {kOther, 4, "asks 0-2, no space", "ITEM 0-2, -> NoSpace at 2 (NotKnown)"}};
  for (const auto& one : kCases) {
    Conversation desk(one.autopilot, kPlan);
    desk.plays("upload unread, 20 ms");
    CHECK(desk.plays(std::string(one.events) + ", 50 ms") == one.end);
    CHECK(desk.client.lastResult() == one.result);
  }
  const auto rally = [](const char* events) { return Conversation(kArduPilot, kRally, PlanType::Rally).plays(events); };
  CHECK(rally("upload unread, 20 ms, no space") == "COUNT 2 of rally, -> NoSpace (AsBefore)");
  CHECK(rally("upload unread, 20 ms, asks 0, no space") ==
        "COUNT 2 of rally, ITEM 0 of rally, -> NoSpace at 0 (NotKnown)");
}

TEST_CASE("what silence leaves aboard, and the autopilot is told that we have given up") {
  const struct {
    uint8_t autopilot;
    const char *events, *end;
  } kCases[] = {{kArduPilot, "9100 ms", "COUNT 4 x4, -> NoAnswer (NotKnown), ACK cancelled"},
                {kArduPilot, "asks 0, 9100 ms", "ITEM 0, -> TimedOut (Mixture), ACK cancelled"},
                {kArduPilot, "asks 0-2, 9100 ms", "ITEM 0-2, -> TimedOut at 1 (Mixture), ACK cancelled"},
                {kArduPilot, "asks 0-3, 9100 ms", "ITEM 0-2, ITEM 3 x6, -> Unconfirmed (NotKnown)"},
                {kPx4, "9100 ms", "COUNT 3 x4, -> NoAnswer (AsBefore), ACK cancelled"},
                {kPx4, "asks 0-1, 9100 ms", "ITEM 0-1, -> TimedOut at 1 (AsBefore), ACK cancelled"},
                {kPx4, "asks 0-2, 9100 ms", "ITEM 0-1, ITEM 2 x6, -> Unconfirmed (NotKnown)"},
                {kOther, "9100 ms", "COUNT 3 x4, -> NoAnswer (NotKnown), ACK cancelled"},
                {kOther, "asks 0-1, 9100 ms", "ITEM 0-1, -> TimedOut at 1 (NotKnown), ACK cancelled"}};
  for (const auto& one : kCases) CHECK(uploading(one.autopilot, one.events) == one.end);
}

TEST_CASE("an empty plan that nobody answers may have cleared the plan, and one that is refused has not") {
  for (const uint8_t autopilot : {kArduPilot, kPx4}) {
    const auto empty = [&](const char* events) { return Conversation(autopilot).plays(events); };
    CHECK(empty("upload unread, 8 s") == "COUNT 0 x5, -> NoAnswer (NotKnown), ACK cancelled");
    CHECK(empty("upload unread, 20 ms, no space") == "COUNT 0, -> NoSpace (AsBefore)");
    CHECK(empty("upload unread, 20 ms, accepted") == "COUNT 0, -> Accepted (OurPlan)");
  }
  // A plan of one item leaves a PX4 with one of the two.
  Conversation desk(kPx4);
  desk.isAbout(inRam(kPlan, 1));
  CHECK(desk.plays("upload unread, 8 s") == "COUNT 1 x5, -> NoAnswer (AsBefore), ACK cancelled");
}

TEST_CASE("an acceptance before all items were asked for, or with another checksum, is none") {
  CHECK(uploading(kPx4, "asks 0-1, accepted") == "ITEM 0-1, -> AcceptedEarly at 1 (NotKnown)");
  CHECK(uploading(kPx4, "asks 0-2, accepted named 7") == "ITEM 0-2, -> OtherPlanAboard at 2 (NotKnown)");
  CHECK(uploading(kPx4, "asks 0-2, accepted") == "ITEM 0-2, -> Accepted (OurPlan)");
}

TEST_CASE("an ArduPilot that asks as no ArduPilot does is not believed") {
  Conversation desk(kArduPilot, kPlan);
  desk.plays("upload unread, 20 ms");
  for (uint16_t item = 0; item < 4; ++item) {
    FrameParts parts = requestParts(item);
    parts.sequence = static_cast<uint8_t>(100 + item);
    desk.line.bring(packed(parts));  // MISSION_REQUEST_INT
    desk.pass(50);
  }
  CHECK(desk.plays("accepted") == "-> Unconfirmed (NotKnown)");
}

TEST_CASE("a request for the first item before COUNT has left may be of another transfer, which is then accepted") {
  const std::string accepted = ", until COUNT, asks all, accepted";
  const auto early = [&](const char* request) {
    return Conversation(kArduPilot, kPlan).plays("upload unread, 1 ms, " + (request + accepted));
  };
  CHECK(early("ask 0") == "COUNT 4, ITEM 0-3, -> Unconfirmed (NotKnown)");
  Conversation desk(kArduPilot, kPlan);
  desk.plays("upload unread, 1 ms, ask 0, until -> Unconfirmed");
  CHECK(desk.plays("upload unread" + accepted) == "COUNT 4, ITEM 0-3, -> Accepted (OurPlan)");  // the next one is not
  CHECK(early("ask 1") == "COUNT 4, ITEM 0-3, -> Accepted (OurPlan)");
  CHECK(early("count") == "COUNT 4, ITEM 0-3, -> Accepted (OurPlan)");
  // What was left open is known of, and waited for.
  CHECK(Conversation(kArduPilot, kPlan)
            .plays("upload unread, until COUNT, asks 0, cancel | upload unread, 5 ms, ask 0" + accepted) ==
        "COUNT 4, ITEM 0 | ACK cancelled, -> Cancelled (Mixture), COUNT 4, ITEM 0-3, -> Accepted (OurPlan)");
}

TEST_CASE("an upload that takes too long ends as such, and leaves what a silent autopilot leaves") {
  Conversation desk(kArduPilot, kPlan);
  desk.client.setOperationTimeout(3);
  CHECK(desk.plays("upload unread, 20 ms, asks 0-1 | 2 s | 1 s") ==
        "COUNT 4, ITEM 0-1 | | -> TookTooLong (Mixture), ACK cancelled");
  // The next one has its own time.
  CHECK(desk.plays("3 s, upload unread, until COUNT, asks 0-1 | 2 s") == "COUNT 4, ITEM 0-1 |");
  CHECK(desk.client.isBusy());
}

TEST_CASE("an upload that is refused here says so at once, and the running one goes on") {
  Conversation desk(kPx4, kPlan);
  CHECK((desk.client.uploadAgain() == Status::SourceRefused));
  CHECK((desk.client.uploadWithoutReadback(inRam(kPlan), PlanType::All) == Status::BadPlanType));
  CHECK((desk.client.status() == Status::BadPlanType));
  CHECK((desk.client.uploadWithoutReadback(inRam(kPlan, 65536)) == Status::TooManyItems));
  CHECK((desk.client.uploadAgain() == Status::TooManyItems));
  desk.pass(5);
  CHECK(desk.plays("upload unread, 20 ms, upload unread, again, 20 ms") == "COUNT 3, Busy x2");
  CHECK((desk.client.status() == Status::Transferring));
}

TEST_CASE("65535 items are the most, home included") {
  const auto checked = [](uint8_t autopilot, uint32_t items) {
    Counted counted = {0, 1000000};
    Conversation desk(autopilot);
    CHECK((desk.client.uploadWithoutReadback(counted.source(items)) == Status::WaitingForAutopilot));
    desk.pass(50);
    return std::string(nameOf(desk.client.status()));
  };
  CHECK(checked(kPx4, 65535) == "Checking");
  CHECK(checked(kArduPilot, 65535) == "TooManyItems");
  CHECK(checked(kArduPilot, 65534) == "Checking");
}

TEST_CASE("a plan with an item that cannot be right, or is not kept, is not begun, and that is forgotten then") {
  const MissionItem bad[] = {kPlan[0], waypoint(91_deg, 0_deg, 20_m)};
  Conversation desk(kArduPilot);
  desk.isAbout(inRam(bad));
  CHECK(desk.plays("upload unread, 50 ms") == "-> BadLatitude at 1 (NotKnown)");
  desk.isAbout(inRam(kNotKept));
  CHECK(desk.plays("upload unread, 50 ms") == "-> NotKept at 2 in Param1 (NotKnown)");
  desk.isAbout(inRam(kPlan));
  CHECK(desk.plays("upload unread, 20 ms") == "COUNT 4");
  CHECK((desk.client.failedItem() == MissionClient::kNoItem));
  CHECK((desk.client.differingField() == ItemField::None));
  // Also when the next one is refused at once.
  Conversation other(kArduPilot);
  other.isAbout(inRam(kNotKept)).plays("upload unread, 50 ms");
  other.isAbout(inRam(kPlan), PlanType::All);
  CHECK(other.plays("upload unread, 5 ms") == "-> BadPlanType (NotKnown)");
  CHECK(other.client.itemsTotal() == 0);
}

TEST_CASE("a plan is checked item by item, one in an update(), and a place that is far away is found") {
  int reads = 0;
  Conversation desk(kPx4);
  desk.plan = fromFunction(readFarPlace, 13, &reads);
  desk.plays("upload unread");
  for (int update = 0; desk.timesOf(Conversation::kCount, 0).empty(); ++update) {
    const int before = reads;
    desk.pass(1);
    CHECK(reads - before <= 3);  // the item, one where its place may be, and the item again
    REQUIRE(update < 100);
  }
  CHECK(reads >= 26);
  desk.plays("asks 0");
  const Bytes wanted = itemParts(0, kPlan[0]).payload;  // its place
  CHECK(std::equal(wanted.begin() + 16, wanted.begin() + 24, desk.sent.back().payload.begin() + 16));

  Counted counted = {0, 1000};
  Conversation copter(kArduPilot);
  copter.plan = counted.source(200);
  copter.plays("upload unread, 20 ms");
  CHECK(counted.reads > 15);
  CHECK(counted.reads <= 20 * MAVMISSION_ITEMS_PER_UPDATE);
}

TEST_CASE("an autopilot that is another one while the plan is checked gets the plan as it wants it") {
  Counted counted = {0, 100000};
  Conversation desk(kPx4);
  desk.plan = counted.source(300);
  CHECK(desk.plays("upload unread, 100 ms") == "");
  REQUIRE((desk.client.status() == Status::Checking));
  for (int i = 0; i < 2; ++i) desk.hear(heartbeatParts(kArduPilot));
  CHECK(desk.plays("silence, until COUNT 1 s") == "COUNT 301");
}

TEST_CASE("a plan that is refused when an item is to be sent ends there, and the autopilot is told") {
  Counted counted = {0, 100};
  Conversation desk(kOther);
  desk.plan = counted.source(3);
  desk.plays("upload unread, 20 ms, asks 0, 20 ms");  // the next one is packed already
  counted.most = 0;
  CHECK(desk.plays("asks 1, 20 ms") == "ITEM 1, -> SourceRefused at 2 (NotKnown), ACK cancelled");
}

TEST_CASE("an armed autopilot is left alone unless the sketch allows it, and MAVLink 1 carries missions alone") {
  Conversation armed(kPx4, kPlan);
  CHECK(armed.plays("armed, upload unread, 100 ms") == "-> Armed (NotKnown)");
  armed.client.allowWhileArmed(true);
  CHECK(armed.plays("upload unread, 100 ms") == "COUNT 3");
  Conversation old(kPx4, kFence, PlanType::Fence);
  old.client.setMavlinkVersion(MavlinkVersion::Version1);
  CHECK(old.plays("3 s, upload unread, 100 ms") == "-> NeedsMavlink2 (NotKnown)");
  old.isAbout(inRam(kPlan));
  CHECK(old.plays("upload unread, 100 ms") == "COUNT 3");
}

TEST_CASE("an autopilot that is lost while the plan is checked is waited for, and the check begins anew") {
  Conversation desk(kPx4, kPlan);
  CHECK(desk.plays("full, upload unread, 100 ms") == "");
  CHECK((desk.client.status() == Status::Checking));
  CHECK(desk.plays("silence, 6 s, free, 1 s") == "");
  CHECK((desk.client.status() == Status::WaitingForAutopilot));
  CHECK(desk.plays("heartbeats, until COUNT 3 s") == "COUNT 3");
}

TEST_CASE("after an upload that ended well, or with a refusal, nothing is waited for, and after another one it is") {
  for (const std::string answer : {"accepted", "no space", "cancelled"}) {
    Conversation desk(kArduPilot, kPlan, PlanType::Mission, 0);
    desk.plays("upload unread, until COUNT, asks 0-3, " + answer);
    REQUIRE_FALSE(desk.client.isBusy());
    CHECK(desk.plays("upload unread, 1 s | cancelled") == "COUNT 4 | -> CancelledByAutopilot (AsBefore)");
  }
  // ArduPilot gives up what was left open: that does not end the next one.
  for (const std::string open : {"asks 0-3, until -> Unconfirmed", "asks 0-1, until -> TimedOut, 5 ms"}) {
    Conversation desk(kArduPilot, kPlan, PlanType::Mission, 0);
    desk.plays("upload unread, until COUNT, " + open);
    REQUIRE_FALSE(desk.client.isBusy());
    CHECK(desk.plays("upload unread, 1 s | until COUNT 3 s, cancelled") == "| COUNT 4");
    CHECK(desk.client.isBusy());
  }
}

TEST_CASE("an item leaves in the second update() from the request for it on") {
  for (const uint8_t autopilot : {kArduPilot, kOther}) {
    Conversation desk(autopilot, kPlan);
    desk.plays("upload unread, 20 ms, asks 0, 20 ms");
    for (uint16_t item = 1; item < desk.held.size(); ++item) {
      desk.hear(requestParts(item));
      CHECK(desk.plays("clock, 20 ms") == "ITEM " + std::to_string(item) + " @2");
    }
  }
}

TEST_CASE("PX4, busy with something older of ours, is told that it is over") {
  CHECK(uploading(kPx4, "error, 100 ms") == "ACK cancelled, COUNT 3");
}
