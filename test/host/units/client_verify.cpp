// verify() by a whole client: what it asks for, what it takes for an answer, and what it says about the plan aboard.
#include <doctest/doctest.h>

#include "Conversation.h"

using namespace mavmission;

namespace {

constexpr uint8_t kArduPilot = Conversation::kArduPilot, kPx4 = Conversation::kPx4, kOther = Conversation::kOther;
const MissionItem kPlan[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 20_m), changeSpeed(5_mps), returnToLaunch()};
const MissionItem kFence[] = {fenceInsideCircle(-35.36_deg, 149.16_deg, 100_m)};

// A verification that has asked for the list.
struct Verifying : Conversation {
  explicit Verifying(uint8_t autopilot, uint32_t startMs = 65000)
      : Conversation(autopilot, kPlan, PlanType::Mission, startMs) {
    plays("verify, until LIST");
  }
};

bool readTheSame(void*, uint16_t, MissionItem& item) {
  item = kPlan[0];
  return true;
}

// PX4 gives a takeoff the place of the next item that has one: the library looks for it in several steps.
bool readFarPlace(void*, uint16_t index, MissionItem& item) {
  item = index == 0 ? takeoff(20_m) : index == 12 ? kPlan[0] : changeSpeed(5_mps);
  return true;
}

}  // namespace

TEST_CASE("a plan is verified item by item, and is ours then") {
  Verifying copter(kArduPilot);
  CHECK(copter.plays("verify, count, 5 ms | item 0, item 1, item 2 | item 3") ==
        "Busy, REQUEST 0-3 | | -> Verified (OurPlan), ACK accepted");
  for (const uint8_t autopilot : {kPx4, kOther}) {
    Verifying desk(autopilot);
    CHECK(desk.plays("verify, count | item 0 | item 1") == "Busy, REQUEST 0 | REQUEST 1 | REQUEST 2");
    CHECK(desk.client.itemsTotal() == 3);
    CHECK(desk.client.itemsDone() == 2);
    CHECK((desk.client.aboard() == Aboard::NotKnown));
    CHECK(desk.plays("item 2") == "-> Verified (OurPlan), ACK accepted");
    CHECK(desk.client.itemsDone() == 3);
    CHECK(desk.client.lastResult() == 255);
  }
}

TEST_CASE("an item is asked for by its number, however large, and by nothing else") {
  Conversation desk(kPx4);
  desk.isAbout(fromFunction(readTheSame, 700));
  CHECK(desk.plays("verify, until LIST, count") == "LIST, REQUEST 0");
  for (uint16_t seq = 0; seq < 600; ++seq) {
    const Bytes& payload = desk.sent.back().payload;
    REQUIRE(Bytes(payload.begin(), payload.begin() + 5) ==
            Bytes{static_cast<uint8_t>(seq), static_cast<uint8_t>(seq >> 8), 1, 1, 0});
    desk.tell(itemParts(seq, kPlan[0]));
  }
}

TEST_CASE("the first field that differs is named with its item, and what is aboard is not known") {
  const struct {
    uint16_t item;
    MissionItem aboard;
    const char* end;
  } kCases[] = {{0, waypoint(-35.3632621_deg, 149.1652374_deg, 21_m), "-> Differs at 0 in Height (NotKnown)"},
                {0, waypoint(-35.3632622_deg, 149.1652374_deg, 20_m), "-> Differs at 0 in Latitude (NotKnown)"},
                {1, returnToLaunch(), "-> Differs at 1 in Command (NotKnown)"},
                {2, changeSpeed(5_mps), "-> Differs at 2 in Command (NotKnown)"}};
  for (const auto& one : kCases) {
    for (const uint8_t autopilot : {kArduPilot, kPx4}) {
      Verifying desk(autopilot);
      desk.plays("count, items");
      REQUIRE((desk.client.aboard() == Aboard::OurPlan));
      desk.plays("verify, until LIST");
      CHECK((desk.client.aboard() == Aboard::OurPlan));
      const uint16_t wire = static_cast<uint16_t>(one.item + desk.isArduPilot());
      desk.held[wire] = one.aboard;
      if (desk.isArduPilot() && one.aboard.param4 != one.aboard.param4) desk.held[wire].param4 = 0;
      desk.plays("count");
      for (uint16_t seq = 0; seq < wire; ++seq) desk.plays("item " + std::to_string(seq));
      CHECK(desk.plays("item " + std::to_string(wire)) == std::string(one.end) + ", ACK cancelled");
    }
  }
}

TEST_CASE("autocontinue is compared, ArduPilot's home is a waypoint above sea level, and the number of items counts") {
  Verifying px4(kPx4), other(kArduPilot), relative(kArduPilot), fewer(kArduPilot);
  px4.held[0].autocontinue = 0;
  CHECK(px4.plays("count | item 0") == "REQUEST 0 | -> Differs at 0 in Autocontinue (NotKnown), ACK cancelled");
  other.held[0].command = kNavLoiterUnlimited;
  CHECK(other.plays("count, 5 ms | item 0") == "REQUEST 0-3 | -> Differs in Command (NotKnown), ACK cancelled");
  relative.held[0].frame = CoordinateFrame::GlobalRelative;
  CHECK(relative.plays("count, 5 ms | item 0") == "REQUEST 0-3 | -> Differs in Command (NotKnown), ACK cancelled");
  CHECK(fewer.plays("count 3") == "-> Differs in Count (NotKnown), ACK cancelled");
}

TEST_CASE("a value that the autopilot does not keep is told as such, with the one that it keeps") {
  const MissionItem plan[] = {anyCommandAt(kNavWaypoint, -35.3632621_deg, 149.1652374_deg, 20_m, 2.5f)};
  Conversation desk(kArduPilot, plan);
  desk.held[1].param1 = 2;
  CHECK(desk.plays("verify, until LIST, count | items") ==
        "LIST, REQUEST 0-1 | -> NotKept at 0 in Param1 (NotKnown), ACK cancelled");
  CHECK(desk.client.keptValue() == 2);
}

TEST_CASE("what cannot be verified is refused before anything leaves") {
  Conversation desk(kPx4, kPlan);
  CHECK((desk.client.verify(inRam(kPlan), PlanType::All) == Status::BadPlanType));
  CHECK((desk.client.verify(inRam(kPlan, 65536)) == Status::TooManyItems));
  CHECK((desk.client.status() == Status::TooManyItems));
  CHECK(desk.plays("100 ms") == "-> BadPlanType (NotKnown)");
  // Over MAVLink 1 a mission is verified, and a fence is not.
  desk.client.setMavlinkVersion(MavlinkVersion::Version1);
  desk.pass(3000);
  for (const PlanType type : {PlanType::Fence, PlanType::Rally}) {
    desk.isAbout(inRam(kPlan), type);
    CHECK(desk.plays("verify, 1 s") == "-> NeedsMavlink2 (NotKnown)");
  }
  CHECK(desk.isAbout(inRam(kPlan)).plays("verify, 1 s") == "LIST");
}

TEST_CASE("of an empty autopilot verify() changes nothing before it has asked") {
  Conversation desk(kArduPilot, kPlan);
  CHECK(desk.plays("8 s, clear, until CLEAR, accepted") == "CLEAR, -> Cleared (Nothing)");
  desk.plays("verify");
  CHECK((desk.client.aboard() == Aboard::Nothing));
  CHECK(desk.plays("cancel, 5 ms") == "-> Cancelled (Nothing)");
}

TEST_CASE("a fence is verified as a fence, whatever is said about missions") {
  Conversation desk(kArduPilot, kFence, PlanType::Fence);
  CHECK(
      desk.plays("8 s, verify, until LIST | count of mission, denied of mission | count | item 0 of mission | items") ==
      "LIST of fence | | REQUEST 0 of fence | | -> Verified (OurPlan), ACK accepted of fence");
  CHECK((desk.client.aboard() == Aboard::NotKnown));
}

TEST_CASE("a refusal to be read is the status, and what is aboard is not known then") {
  const struct {
    const char *answer, *end;
    uint8_t result;
  } kRefusals[] = {{"error", "-> Error (NotKnown), ACK cancelled", 1},
                   {"unsupported", "-> Unsupported (NotKnown), ACK cancelled", 3},
                   {"denied", "-> Denied (NotKnown), ACK cancelled", 14},
                   {"cancelled", "-> CancelledByAutopilot (NotKnown), ACK cancelled", 15}};
  for (const auto& one : kRefusals) {
    for (const std::string so : {"verify, until LIST", "verify, until LIST, count"}) {
      if (one.result == 1 && so != "verify, until LIST") continue;  // PX4 has ended the reading, which begins anew
      Verifying desk(kArduPilot);
      desk.plays("count, items, " + so);
      REQUIRE((desk.client.aboard() == Aboard::OurPlan));
      CHECK(desk.plays("accepted, invalid sequence") == "");
      CHECK(desk.plays(one.answer) == one.end);
      CHECK(desk.client.lastResult() == one.result);
    }
  }
}

TEST_CASE("silence, cancel() and a full sink do not change what is known to be aboard") {
  MissionItem one[1];
  Verifying desk(kArduPilot);
  desk.plays("count, items");
  CHECK(desk.plays("verify, until LIST, 8 s") == "LIST x5, -> NoAnswer (OurPlan), ACK cancelled");
  CHECK(desk.plays("verify, until LIST, cancel, 8 s") == "LIST, ACK cancelled, -> Cancelled (OurPlan)");
  desk.client.download(toRam(one));
  CHECK(desk.plays("until LIST, count") == "LIST, -> SinkFull (OurPlan), ACK cancelled");
}

TEST_CASE("after a reset an error or a cancelling may be about what was before, and a denial is not") {
  for (const std::string count : {"", "count, "}) {
    Verifying error(kArduPilot, 0), cancelled(kArduPilot, 0), denied(kArduPilot, 0);
    error.plays(count + "error");
    CHECK(error.client.isBusy());
    cancelled.plays(count + "cancelled");
    CHECK(cancelled.client.isBusy());
    denied.plays(count + "denied");
    CHECK((denied.client.status() == Status::Denied));
  }
}

TEST_CASE("an autopilot that does not know the older request is not taken to refuse the plan") {
  for (const uint8_t autopilot : {kOther, kPx4}) {
    for (int requests = 1; requests <= 4; ++requests) {
      for (const std::string answer : {"unsupported", "denied"}) {
        Verifying desk(autopilot);
        desk.hear(countParts(3));
        const auto asked = [&] {
          return desk.timesOf(Conversation::kRequestInt, 0).size() + desk.timesOf(Conversation::kRequest, 0).size();
        };
        while (asked() < static_cast<size_t>(requests)) desk.pass(1);
        desk.plays(answer);
        CHECK(desk.client.isBusy() == (autopilot == kOther && requests > 2 && answer == "unsupported"));
      }
    }
  }
}

TEST_CASE("items that come as floats are compared as well") {
  MissionItem plan[] = {waypoint(-35.5_deg, 149.25_deg, 20_m)};
  Conversation desk(kOther);
  CHECK(desk.isAbout(inRam(plan)).plays("verify, until LIST, count, float item 0") ==
        "LIST, REQUEST 0, -> Verified (OurPlan), ACK accepted");
}

TEST_CASE("a verification that takes too long ends as such") {
  Conversation desk(kArduPilot, kPlan);
  desk.client.setOperationTimeout(3);
  CHECK(desk.plays("verify, until LIST, 2990 ms | 20 ms") ==
        "LIST x2 | LIST, -> TookTooLong (NotKnown), ACK cancelled");
}

TEST_CASE("an item whose place has to be searched is asked for again at once, as often as that takes") {
  Conversation desk(kPx4);
  desk.isAbout(fromFunction(readFarPlace, 13));
  desk.held[0].x = kPlan[0].x;
  desk.held[0].y = kPlan[0].y;
  desk.plays("8 s, verify, until LIST, count");
  int asked = 0;
  for (; asked < 50 && desk.client.itemsDone() == 0; ++asked) {
    desk.hear(itemParts(0, desk.held[0]));
    CHECK(desk.plays("until REQUEST 20 ms") == (desk.client.itemsDone() == 0 ? "REQUEST 0" : "REQUEST 1"));
  }
  CHECK(asked > 10);
  CHECK(desk.client.itemsDone() == 1);
}

TEST_CASE(
    "what follows a reading that has repeated its question waits for late answers, and is not delayed otherwise") {
  CHECK(Verifying(kArduPilot).plays("count, items, clear, until CLEAR 1 s") ==
        "REQUEST 0-3, -> Verified (OurPlan), ACK accepted, CLEAR");
  CHECK(Verifying(kArduPilot).plays("until LIST 2 s, count, items, clear, 1 s | until CLEAR 3 s") ==
        "LIST, REQUEST 0-3, -> Verified (OurPlan), ACK accepted | CLEAR");
}

TEST_CASE("after a reading PX4 may still be busy with it, for some time") {
  const std::string refused = "upload unread, until COUNT | error | error, 20 ms";
  Verifying soon(kPx4, 30000), later(kPx4, 30000);
  soon.plays("count, items");
  CHECK(soon.plays(refused) == "COUNT 3 | ACK cancelled, COUNT 3 |");
  later.plays("count, items, 11 s");
  CHECK(later.plays(refused) == "COUNT 3 | ACK cancelled, COUNT 3 | -> Error (AsBefore)");
}

TEST_CASE("while a plan is read an update() takes half as many bytes, so that the comparison has its time") {
  Verifying desk(kPx4);
  const size_t whileReading = desk.readInOne();
  CHECK(whileReading > 16);
  CHECK(whileReading <= MAVMISSION_BYTES_PER_UPDATE / 2);
  CHECK(desk.plays("cancel, 50 ms, verify, until LIST, count 7") ==
        "ACK cancelled, -> Cancelled (NotKnown), LIST, -> Differs in Count (NotKnown), ACK cancelled");
  CHECK(desk.readInOne() > MAVMISSION_BYTES_PER_UPDATE / 2);
}
