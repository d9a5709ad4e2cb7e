// verify() by a whole client: what it asks for, what it takes for an answer, and what it says about the plan aboard.
#include <doctest/doctest.h>

#include "ClientOnLine.h"
#include "PlanFrames.h"

using namespace mavmission;

namespace {

constexpr uint8_t kAccepted = 0, kError = 1, kUnsupported = 3, kInvalidSequence = 13, kDenied = 14, kCancelled = 15;
constexpr uint16_t kClearAll = 45;
const MissionItem kPlan[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 20_m), changeSpeed(5_mps), returnToLaunch()};
const MissionItem kOther[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 40_m)};

struct Verifying : ClientOnLine {
  const uint16_t before;  // ArduPilot's home

  explicit Verifying(uint8_t autopilot, uint32_t startMs = 65000)
      : ClientOnLine(autopilot, startMs), before(autopilot == kArduPilot ? 1 : 0) {
    run(3000);
    begin();
  }
  void begin() {
    ended = Status::Idle;
    CHECK((client.verify(inRam(kPlan)) == Status::WaitingForAutopilot));
    REQUIRE(runUntilSent(kRequestList, 3000));
    sent.clear();
  }
  void tell(const FrameParts& parts) {
    hear(parts);
    run(5);
  }
  void tellCount(uint32_t opaqueId = 0) {
    tell(countParts(static_cast<uint16_t>(3 + before), PlanType::Mission, opaqueId));
  }
  // The item of the plan with this number; home is item -1.
  void tellItem(int item) {
    tell(itemParts(static_cast<uint16_t>(item + before), item < 0 ? homeItem() : kept(kPlan[item])));
  }
  // ArduPilot keeps no yaw.
  MissionItem kept(MissionItem item) const {
    if (before != 0 && item.param4 != item.param4) item.param4 = 0;
    return item;
  }
  void tellItems() {
    for (int item = -before; item < 3; ++item) tellItem(item);
  }
  void tellPlan(uint32_t opaqueId = 0) {
    tellCount(opaqueId);
    tellItems();
  }
  // The numbers of the items that were asked for.
  std::vector<int> asked() const {
    std::vector<int> numbers;
    for (const SentFrame& frame : sent) {
      if (frame.messageId == kRequestInt) numbers.push_back(frame.payload[0]);
    }
    return numbers;
  }
  std::vector<uint8_t> acks() const {
    std::vector<uint8_t> results;
    for (const SentFrame& frame : sent) {
      if (frame.messageId == kAck) results.push_back(frame.payload[2]);
    }
    return results;
  }
};

}  // namespace

TEST_CASE("a plan is verified item by item, and is ours then") {
  for (const uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4, ClientOnLine::kOther}) {
    Verifying desk(autopilot);
    CHECK((desk.client.verify(inRam(kPlan)) == Status::Busy));
    CHECK(desk.client.itemsTotal() == 3);
    desk.tellCount();
    CHECK((desk.client.aboard() == Aboard::NotKnown));
    desk.run(5);
    for (int item = -desk.before; item < 3; ++item) {
      const bool isArduPilot = autopilot == ClientOnLine::kArduPilot;
      const std::vector<int> numbers = {0, 1, 2, 3};
      CHECK(desk.asked() == std::vector<int>(numbers.begin(), numbers.begin() + (isArduPilot ? 4 : item + 1)));
      CHECK(desk.client.itemsDone() == (item < 0 ? 0 : item));
      desk.tellItem(item);
    }
    CHECK((desk.ended == Status::Verified));
    CHECK((desk.client.aboard() == Aboard::OurPlan));
    CHECK(desk.client.itemsDone() == 3);
    CHECK(desk.client.lastResult() == 255);
    CHECK(desk.acks() == std::vector<uint8_t>{kAccepted});
  }
}

TEST_CASE("REQUEST_LIST leaves in the update() that follows, and tells its target and type alone") {
  ClientOnLine desk(ClientOnLine::kPx4);
  desk.run(3000);
  desk.sent.clear();
  desk.client.verify(inRam(kPlan), PlanType::Rally);
  desk.run(1);
  REQUIRE(desk.timesOf(ClientOnLine::kRequestList, 0).size() == 1);
  CHECK(desk.sent.back().payload[0] == 1);
  CHECK(desk.sent.back().payload[1] == 1);
  CHECK(desk.sent.back().payload[2] == static_cast<uint8_t>(PlanType::Rally));
}

TEST_CASE("an item is asked for by its number, however large, and by nothing else") {
  ClientOnLine desk(ClientOnLine::kPx4);
  desk.run(3000);
  const auto read = [](void*, uint16_t, MissionItem& item) {
    item = kPlan[0];
    return true;
  };
  desk.client.verify(fromFunction(read, 700));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 20));
  desk.hear(countParts(700));
  for (uint16_t seq = 0; seq < 600; ++seq) {
    REQUIRE(desk.runUntilSent(ClientOnLine::kRequestInt, 20));
    const Bytes& payload = desk.sent.back().payload;
    REQUIRE((payload[0] | payload[1] << 8) == seq);
    REQUIRE((payload[2] == 1 && payload[3] == 1 && payload[4] == 0));
    desk.hear(itemParts(seq, kPlan[0]));
  }
}

TEST_CASE("the first field that differs is named with its item, and what is aboard is not known") {
  const struct {
    int item;
    MissionItem aboard;
    ItemField field;
  } kCases[] = {{0, waypoint(-35.3632621_deg, 149.1652374_deg, 21_m), ItemField::Height},
                {0, waypoint(-35.3632622_deg, 149.1652374_deg, 20_m), ItemField::Latitude},
                {1, returnToLaunch(), ItemField::Command},
                {2, changeSpeed(5_mps), ItemField::Command}};
  for (const auto& one : kCases) {
    for (const uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
      Verifying desk(autopilot);
      desk.tellPlan();
      REQUIRE((desk.client.aboard() == Aboard::OurPlan));
      desk.begin();
      CHECK((desk.client.aboard() == Aboard::OurPlan));
      desk.tellCount();
      for (int item = -desk.before; item < one.item; ++item) desk.tellItem(item);
      desk.tell(itemParts(static_cast<uint16_t>(one.item + desk.before), desk.kept(one.aboard)));
      CHECK((desk.ended == Status::Differs));
      CHECK(desk.client.failedItem() == one.item);
      CHECK((desk.client.differingField() == one.field));
      CHECK((desk.client.aboard() == Aboard::NotKnown));
      desk.run(5);
      CHECK(desk.acks() == std::vector<uint8_t>{kCancelled});
    }
  }
}

TEST_CASE("autocontinue is compared") {
  Verifying desk(ClientOnLine::kPx4);
  desk.tellCount();
  MissionItem item = kPlan[0];
  item.autocontinue = 0;
  desk.tell(itemParts(0, item));
  CHECK((desk.ended == Status::Differs));
  CHECK((desk.client.differingField() == ItemField::Autocontinue));
}

TEST_CASE("ArduPilot's home is a waypoint above sea level, and nothing else is home") {
  MissionItem other = homeItem(), relative = homeItem();
  other.command = kNavLoiterUnlimited;
  relative.frame = CoordinateFrame::GlobalRelative;
  for (const MissionItem& item : {other, relative}) {
    Verifying desk(ClientOnLine::kArduPilot);
    desk.tellCount();
    desk.tell(itemParts(0, item));
    CHECK((desk.ended == Status::Differs));
    CHECK((desk.client.differingField() == ItemField::Command));
    CHECK((desk.client.failedItem() == MissionClient::kNoItem));
  }
}

TEST_CASE("another number of items is another plan, before any item is asked for") {
  Verifying desk(ClientOnLine::kArduPilot);
  desk.tell(countParts(3));
  CHECK((desk.ended == Status::Differs));
  CHECK((desk.client.differingField() == ItemField::Count));
  CHECK((desk.client.failedItem() == MissionClient::kNoItem));
  CHECK(desk.timesOf(ClientOnLine::kRequestInt, 0).empty());
}

TEST_CASE("a value that the autopilot does not keep is told as such, with the one that it keeps") {
  const MissionItem plan[] = {
      anyCommandAt(kNavWaypoint, -35.3632621_deg, 149.1652374_deg, 20_m, 2.5f),
  };
  MissionItem kept = plan[0];
  kept.param1 = 2;
  kept.param4 = 0;
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(11000);
  desk.client.verify(inRam(plan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 3000));
  desk.hear(countParts(2));
  desk.run(5);
  desk.hear(itemParts(0, homeItem()));
  desk.run(5);
  desk.hear(itemParts(1, kept));
  desk.run(5);
  CHECK((desk.ended == Status::NotKept));
  CHECK((desk.client.differingField() == ItemField::Param1));
  CHECK(desk.client.failedItem() == 0);
  CHECK(desk.client.keptValue() == 2);
}

TEST_CASE("what cannot be verified is refused before anything leaves") {
  ClientOnLine desk(ClientOnLine::kPx4);
  desk.run(3000);
  desk.sent.clear();
  CHECK((desk.client.verify(inRam(kPlan), PlanType::All) == Status::BadPlanType));
  CHECK((desk.client.verify(inRam(kPlan, 65536)) == Status::TooManyItems));
  CHECK((desk.client.status() == Status::TooManyItems));
  desk.run(100);
  CHECK(desk.timesOf(ClientOnLine::kRequestList, 0).empty());
}

TEST_CASE("over MAVLink 1 a mission is verified, and a fence is not") {
  for (const PlanType type : {PlanType::Mission, PlanType::Fence, PlanType::Rally}) {
    ClientOnLine desk(ClientOnLine::kPx4);
    desk.client.setMavlinkVersion(MavlinkVersion::Version1);
    desk.run(3000);
    desk.sent.clear();
    desk.client.verify(inRam(kPlan), type);
    desk.run(2000);
    CHECK(desk.timesOf(ClientOnLine::kRequestList, 0).empty() == (type != PlanType::Mission));
    CHECK((desk.ended == (type == PlanType::Mission ? Status::Idle : Status::NeedsMavlink2)));
  }
}

TEST_CASE("what verify() says of another plan is not about ours, and of an empty autopilot nothing changes") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(11000);
  desk.client.clear();
  REQUIRE(desk.runUntilSent(kClearAll, 3000));
  desk.hear(ackParts(kAccepted));
  desk.run(5);
  REQUIRE((desk.client.aboard() == Aboard::Nothing));
  desk.client.verify(inRam(kOther));
  CHECK((desk.client.aboard() == Aboard::Nothing));
  desk.client.cancel();
  CHECK((desk.client.aboard() == Aboard::Nothing));
}

TEST_CASE("a fence is verified as a fence") {
  const MissionItem fence[] = {fenceInsideCircle(-35.36_deg, 149.16_deg, 100_m)};
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(11000);
  desk.client.verify(inRam(fence), PlanType::Fence);
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 10));
  CHECK(desk.sent.back().payload[2] == 1);
  desk.hear(countParts(1));
  desk.hear(ackParts(kDenied));  // about missions
  desk.run(5);
  CHECK(desk.client.isBusy());
  desk.hear(countParts(1, PlanType::Fence));
  desk.run(5);
  desk.hear(itemParts(0, fence[0]));
  desk.run(5);
  CHECK(desk.client.isBusy());
  desk.hear(itemParts(0, fence[0], PlanType::Fence));
  desk.run(5);
  CHECK((desk.ended == Status::Verified));
  CHECK((desk.client.aboard(PlanType::Fence) == Aboard::OurPlan));
  CHECK((desk.client.aboard() == Aboard::NotKnown));
}

TEST_CASE("a refusal to be read is the status, and what is aboard is not known then") {
  for (const uint8_t result : {kError, kUnsupported, kDenied, kCancelled}) {
    for (const bool isListing : {true, false}) {
      Verifying desk(ClientOnLine::kArduPilot);
      desk.tellPlan();
      desk.begin();
      if (!isListing) desk.tellCount();
      desk.tell(ackParts(kAccepted));
      desk.tell(ackParts(kInvalidSequence));
      CHECK(desk.client.isBusy());
      if (!isListing && result == kError) continue;  // PX4 has ended the reading, which begins anew
      desk.tell(ackParts(result));
      CHECK((desk.ended == fromMissionResult(result)));
      CHECK(desk.client.lastResult() == result);
      CHECK((desk.client.aboard() == Aboard::NotKnown));
      CHECK(desk.acks() == std::vector<uint8_t>{kCancelled});
    }
  }
}

TEST_CASE("silence, cancel() and a full sink do not change what is known to be aboard") {
  MissionItem one[1];
  for (const Status end : {Status::NoAnswer, Status::Cancelled, Status::SinkFull}) {
    Verifying desk(ClientOnLine::kArduPilot);
    desk.tellPlan();
    desk.begin();
    if (end != Status::NoAnswer) desk.client.cancel();
    if (end == Status::SinkFull) {
      desk.run(3000);
      desk.client.download(toRam(one));
      REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 3000));
      desk.tellCount();
    }
    desk.run(8000);
    CHECK((desk.ended == end));
    CHECK((desk.client.aboard() == Aboard::OurPlan));
  }
}

TEST_CASE("behind a reset an error or a cancelling may be about what was before, and a denial is not") {
  for (const uint8_t result : {kError, kCancelled, kDenied}) {
    for (const bool isListing : {true, false}) {
      Verifying desk(ClientOnLine::kArduPilot, 0);
      if (!isListing) desk.tellCount();
      desk.tell(ackParts(result));
      CHECK(desk.client.isBusy() == (result != kDenied));
      CHECK((desk.ended == (result == kDenied ? Status::Denied : Status::Idle)));
    }
  }
}

TEST_CASE("an autopilot that does not know the older request is not taken to refuse the plan") {
  for (const uint8_t autopilot : {ClientOnLine::kOther, ClientOnLine::kPx4}) {
    for (int requests = 1; requests <= 4; ++requests) {
      for (const uint8_t result : {kUnsupported, kDenied}) {
        Verifying desk(autopilot);
        desk.tellCount();
        while (desk.timesOf(ClientOnLine::kRequestInt, 0).size() + desk.timesOf(ClientOnLine::kRequest, 0).size() <
               static_cast<size_t>(requests)) {
          desk.run(1);
        }
        desk.tell(ackParts(result));
        const bool goesOn = autopilot == ClientOnLine::kOther && requests > 2 && result == kUnsupported;
        CHECK(desk.client.isBusy() == goesOn);
      }
    }
  }
}

TEST_CASE("items that come as floats are compared as well") {
  Verifying desk(ClientOnLine::kOther);
  MissionItem plan[] = {waypoint(-35.5_deg, 149.25_deg, 20_m)};
  desk.client.cancel();
  desk.run(3000);
  desk.ended = Status::Idle;
  desk.client.verify(inRam(plan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 3000));
  desk.tell(countParts(1));
  desk.tell(floatItemParts(0, plan[0], -35.5f, 149.25f));
  CHECK((desk.ended == Status::Verified));
}

TEST_CASE("a verification that takes too long ends as such") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(11000);
  desk.client.setOperationTimeout(3);
  desk.client.verify(inRam(kPlan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 3000));
  desk.run(2990);
  CHECK(desk.client.isBusy());
  desk.run(20);
  CHECK((desk.ended == Status::TookTooLong));
}

namespace {

// PX4 gives a takeoff the place of the next item that has one: the library looks for it in several steps.
bool readFarPlace(void*, uint16_t index, MissionItem& item) {
  item = index == 0 ? takeoff(20_m) : index == 12 ? kPlan[0] : changeSpeed(5_mps);
  return true;
}

}  // namespace

TEST_CASE("an item whose place has to be searched is asked for again at once, as often as that takes") {
  ClientOnLine desk(ClientOnLine::kPx4);
  desk.run(11000);
  desk.client.verify(fromFunction(readFarPlace, 13));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 3000));
  desk.hear(countParts(13));
  desk.run(5);
  MissionItem aboard;
  readFarPlace(nullptr, 0, aboard);
  aboard.x = kPlan[0].x;
  aboard.y = kPlan[0].y;
  desk.sent.clear();
  int asked = 0;
  for (; asked < 50 && desk.client.itemsDone() == 0; ++asked) {
    desk.hear(itemParts(0, aboard));
    REQUIRE(desk.runUntilSent(ClientOnLine::kRequestInt, 20));
  }
  CHECK(asked > 10);
  CHECK(desk.client.itemsDone() == 1);
  CHECK(desk.sent.back().payload[0] == 1);
}

TEST_CASE(
    "what follows a reading that has repeated its question waits for late answers, and is not delayed otherwise") {
  for (const bool repeats : {false, true}) {
    Verifying desk(ClientOnLine::kArduPilot);
    if (repeats) REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 2000));
    desk.tellPlan();
    REQUIRE((desk.ended == Status::Verified));
    desk.client.clear();
    CHECK(desk.runUntilSent(kClearAll, 1000) != repeats);
    CHECK(desk.runUntilSent(kClearAll, 3000));
  }
}

TEST_CASE("behind a reading PX4 may still be busy with it, for some time") {
  for (const uint32_t pauseMs : {0, 11000}) {
    Verifying desk(ClientOnLine::kPx4, 30000);
    desk.tellPlan();
    REQUIRE((desk.ended == Status::Verified));
    desk.run(pauseMs);
    desk.ended = Status::Idle;
    desk.client.uploadWithoutReadback(inRam(kPlan));
    REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 3000));
    desk.hear(ackParts(kError));
    REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 2000));
    desk.hear(ackParts(kError));
    desk.run(20);
    CHECK((desk.ended == (pauseMs == 0 ? Status::Idle : Status::Error)));
  }
}

TEST_CASE("while a plan is read an update() takes half as many bytes, so that the comparison has its time") {
  Verifying desk(ClientOnLine::kPx4);
  const Bytes noise(600, 0x11);
  const auto readInOne = [&] {
    desk.line.bring(noise);
    const size_t before = desk.line.bytesRead;
    desk.run(1);
    const size_t read = desk.line.bytesRead - before;
    desk.run(50);
    return read;
  };
  const size_t whileReading = readInOne();
  CHECK(whileReading > 16);
  CHECK(whileReading <= MAVMISSION_BYTES_PER_UPDATE / 2);
  desk.client.cancel();
  desk.run(50);
  desk.client.verify(inRam(kPlan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 3000));
  desk.tell(countParts(7));
  REQUIRE((desk.ended == Status::Differs));
  CHECK(readInOne() > MAVMISSION_BYTES_PER_UPDATE / 2);
}
