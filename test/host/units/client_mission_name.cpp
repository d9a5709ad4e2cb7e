// Whose mission is aboard, as the autopilot tells between the operations of a whole client: PX4 names its mission,
// ArduPilot counts its items and says in words that an upload has ended.
#include <doctest/doctest.h>
#include <string.h>

#include "ClientOnLine.h"
#include "PlanFrames.h"
#include "Px4Checksum.h"

using namespace mavmission;

namespace {

const MissionItem kPlan[] = {anyCommandAt(kNavWaypoint, -35.3632621_deg, 149.1652374_deg, 20_m), returnToLaunch()};
const MissionItem kFence[] = {fenceInsideCircle(-35.36_deg, 149.16_deg, 100_m)};
constexpr uint32_t kName = 0x12345678, kOtherName = 0x87654321;
constexpr uint8_t kCommandLong = 76;

struct Named : ClientOnLine {
  MissionFollower follower;
  const bool isPx4;
  std::vector<Status> told;

  explicit Named(uint8_t autopilot) : ClientOnLine(autopilot), follower(client), isPx4(autopilot == kPx4) {
    client.onEnd(note, this);
    run(3000);
  }
  static void note(void* context, Status status) { static_cast<Named*>(context)->told.push_back(status); }

  void tell(const FrameParts& parts) {
    hear(parts);
    run(5);
  }
  // The plan is aboard, under this name.
  void verify(uint32_t name, const ItemSource& plan = inRam(kPlan)) {
    client.verify(plan);
    REQUIRE(runUntilSent(kRequestList, 4000));
    const uint16_t home = isPx4 ? 0 : 1;
    tell(countParts(static_cast<uint16_t>(plan.count + home), PlanType::Mission, name));
    if (home != 0) tell(itemParts(0, homeItem()));
    for (uint16_t item = 0; item < plan.count; ++item) {
      tell(itemParts(static_cast<uint16_t>(item + home), kPlan[item]));
    }
    REQUIRE((client.aboard() == Aboard::OurPlan));
    told.clear();
    ended = Status::Idle;
  }
  // The plan is uploaded, and accepted with PX4's checksum, which is returned.
  uint32_t upload(const ItemSource& plan = inRam(kPlan), PlanType type = PlanType::Mission) {
    ended = Status::Idle;
    client.uploadWithoutReadback(plan, type);
    REQUIRE(runUntilSent(kCount, 4000));
    uint32_t sum = 0;
    for (uint16_t item = 0; item < plan.count; ++item) {
      hear(requestParts(item, 1, 191, static_cast<uint8_t>(type)));
      REQUIRE(runUntilSent(kItemInt, 50));
      mavlink_mission_item_int_t message;
      memcpy(&message, sent.back().payload.data(), sizeof(message));
      sum = px4Checksum(sum, message);
    }
    hear(ackParts(0, 1, 191, static_cast<uint8_t>(type), sum));
    run(5);
    REQUIRE((ended == Status::Accepted));
    told.clear();
    ended = Status::Idle;
    return sum;
  }
  void tellCurrent(uint32_t name, uint16_t total = 2, uint8_t state = MISSION_STATE_ACTIVE, int times = 1) {
    mavlink_mission_current_t message = mavlink_mission_current_t();
    message.seq = 1;
    message.total = total;
    message.mission_state = state;
    message.mission_id = name;
    const uint8_t* begin = reinterpret_cast<const uint8_t*>(&message);
    for (int i = 0; i < times; ++i) {
      tell(FrameParts(MAVLINK_MSG_ID_MISSION_CURRENT, Bytes(begin, begin + sizeof(message)),
                      MAVLINK_MSG_ID_MISSION_CURRENT_CRC));
    }
  }
  void say(const char* text) {
    Bytes payload(51);
    payload[0] = 6;
    memcpy(&payload[1], text, strlen(text));
    tell(FrameParts(MAVLINK_MSG_ID_STATUSTEXT, payload, MAVLINK_MSG_ID_STATUSTEXT_CRC));
  }
  // Why start() is refused.
  Status refusal() {
    ended = Status::Idle;
    client.start();
    run(5);
    const Status why = ended;
    if (client.isBusy()) client.cancel();
    run(5);
    told.clear();
    return why;
  }
};

}  // namespace

TEST_CASE("a mission of another name is somebody else's, and ours is back with its name") {
  for (const bool isUploaded : {false, true}) {
    Named desk(ClientOnLine::kPx4);
    uint32_t name = kName;
    if (isUploaded) {
      name = desk.upload();
    } else {
      desk.verify(kName);
    }
    desk.tellCurrent(name, 2, MISSION_STATE_ACTIVE, 5);
    CHECK((desk.client.aboard() == Aboard::OurPlan));
    desk.tellCurrent(kOtherName, 2, MISSION_STATE_ACTIVE, 5);
    CHECK((desk.client.aboard() == Aboard::OtherPlan));
    CHECK_FALSE(desk.follower.isOurPlan());
    CHECK((desk.refusal() == Status::Unproven));
    desk.tellCurrent(name);
    CHECK((desk.client.aboard() == Aboard::OurPlan));
    CHECK(desk.follower.isOurPlan());
  }
}

TEST_CASE("a name is compared whatever number it is, and no name is none") {
  for (const uint32_t name : {1u, 2u, 0xFFFFFFFFu}) {
    Named desk(ClientOnLine::kPx4);
    desk.verify(name);
    desk.tellCurrent(0, 2, MISSION_STATE_ACTIVE, 5);
    desk.tellCurrent(0, 0xFFFE, MISSION_STATE_ACTIVE, 5);  // PX4's total tells nothing
    CHECK((desk.client.aboard() == Aboard::OurPlan));
    desk.tellCurrent(name == 1 ? 2 : 1, 2, MISSION_STATE_ACTIVE, 5);
    CHECK((desk.client.aboard() == Aboard::OtherPlan));
  }
  for (const uint32_t name : {1u, kName}) {
    Named desk(ClientOnLine::kPx4);
    desk.verify(name);
    desk.tellCurrent(0, 0xFFFF, MISSION_STATE_NO_MISSION, 5);  // without a plan
    CHECK((desk.client.aboard() == Aboard::OtherPlan));
    desk.tellCurrent(0, 0xFFFF, MISSION_STATE_NO_MISSION);
    CHECK((desk.client.aboard() == Aboard::OtherPlan));
    desk.tellCurrent(name);
    CHECK((desk.client.aboard() == Aboard::OurPlan));
  }
}

TEST_CASE("a mission that was accepted without a name is not told from another one by names or by PX4's total") {
  Named desk(ClientOnLine::kPx4);
  desk.verify(0);
  desk.tellCurrent(kOtherName, 2, MISSION_STATE_ACTIVE, 5);
  desk.tellCurrent(0, 9, MISSION_STATE_ACTIVE, 5);
  desk.tellCurrent(0, 9, MISSION_STATE_UNKNOWN, 5);
  desk.tellCurrent(0, 0xFFFF, MISSION_STATE_NO_MISSION, 5);
  CHECK((desk.client.aboard() == Aboard::OurPlan));
}

TEST_CASE("the name of a fence is not the mission's") {
  Named desk(ClientOnLine::kPx4);
  desk.verify(kName);
  desk.upload(inRam(kFence), PlanType::Fence);
  desk.tellCurrent(kName, 2, MISSION_STATE_ACTIVE, 5);
  CHECK((desk.client.aboard() == Aboard::OurPlan));
  desk.tellCurrent(kOtherName, 2, MISSION_STATE_ACTIVE, 5);
  CHECK((desk.client.aboard() == Aboard::OtherPlan));

  desk.client.verify(inRam(kFence), PlanType::Fence);
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 4000));
  desk.tell(countParts(1, PlanType::Fence, kOtherName));
  desk.tell(itemParts(0, kFence[0], PlanType::Fence));
  REQUIRE((desk.ended == Status::Verified));
  desk.tellCurrent(kName);
  CHECK((desk.client.aboard() == Aboard::OurPlan));
}

TEST_CASE("what was not known to be ours is not somebody else's by its name, nor ours") {
  Named desk(ClientOnLine::kPx4);
  desk.verify(kName);
  desk.client.uploadWithoutReadback(inRam(kPlan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 9000));
  REQUIRE((desk.client.aboard() == Aboard::NotKnown));
  desk.tellCurrent(kOtherName, 2, MISSION_STATE_ACTIVE, 5);
  CHECK((desk.client.aboard() == Aboard::NotKnown));
  desk.tellCurrent(kName, 2, MISSION_STATE_ACTIVE, 5);
  CHECK((desk.client.aboard() == Aboard::NotKnown));
}

TEST_CASE("ArduPilot's mission of another length is somebody else's, unless its state is not known") {
  Named desk(ClientOnLine::kArduPilot);
  desk.verify(0);
  desk.tellCurrent(0, 2, MISSION_STATE_ACTIVE, 5);
  desk.tellCurrent(0, 3, MISSION_STATE_UNKNOWN, 5);
  CHECK((desk.client.aboard() == Aboard::OurPlan));
  desk.tellCurrent(0, 3, MISSION_STATE_ACTIVE, 5);
  CHECK((desk.client.aboard() == Aboard::OtherPlan));
}

TEST_CASE("ArduPilot's length tells nothing where the last plan was a fence") {
  Named desk(ClientOnLine::kArduPilot);
  desk.verify(0);
  desk.client.verify(inRam(kFence), PlanType::Fence);
  desk.client.cancel();
  desk.tellCurrent(0, 3, MISSION_STATE_ACTIVE, 5);
  CHECK((desk.client.aboard() == Aboard::OurPlan));
}

TEST_CASE(
    "ArduPilot's text about an upload that is not ours tells of another plan, and beside a transfer it does not") {
  const ItemSource one = inRam(kPlan, 1);
  Named desk(ClientOnLine::kArduPilot);
  desk.verify(0, one);
  desk.client.verify(one);
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 4000));
  desk.say("Flight plan received");
  CHECK((desk.client.aboard() == Aboard::OurPlan));
  desk.client.cancel();
  SUBCASE("idle") { desk.run(5); }
  SUBCASE("beside a command") { desk.client.arm(); }
  desk.say("Flight plan received");
  CHECK((desk.client.aboard() == Aboard::OtherPlan));
}

TEST_CASE("a mission that PX4 rejects in words behind its acceptance is infeasible, and that is told once") {
  Named desk(ClientOnLine::kPx4);
  desk.say("Mission rejected: no takeoff");  // none of ours
  CHECK(desk.told.empty());
  desk.upload();
  desk.say("Mission rejected: no takeoff");
  CHECK(desk.told == std::vector<Status>{Status::Infeasible});
  CHECK((desk.ends.back() == Status::Infeasible));
  CHECK((desk.client.status() == Status::Infeasible));
  desk.say("Mission rejected: no takeoff");
  CHECK(desk.told.size() == 1);
  CHECK((desk.refusal() == Status::Infeasible));
  // A fence does not change that, and the next mission does.
  desk.upload(inRam(kFence), PlanType::Fence);
  CHECK((desk.refusal() == Status::Infeasible));
  desk.upload();
  CHECK((desk.refusal() != Status::Infeasible));
}

TEST_CASE("a mission that PX4 names and does not have is infeasible when it says so twice") {
  Named desk(ClientOnLine::kPx4);
  const uint32_t name = desk.upload();
  desk.tellCurrent(name, 2, MISSION_STATE_NO_MISSION);
  CHECK(desk.told.empty());
  desk.tellCurrent(name, 2, MISSION_STATE_NO_MISSION);
  CHECK(desk.told == std::vector<Status>{Status::Infeasible});
}

TEST_CASE("beside an operation that transfers, an infeasible mission is not told, and it ends a command") {
  Named desk(ClientOnLine::kPx4);
  desk.upload();
  desk.client.verify(inRam(kPlan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 4000));
  desk.say("Mission rejected: no takeoff");
  CHECK(desk.told.empty());
  CHECK((desk.client.status() == Status::Transferring));
  desk.client.cancel();
  desk.told.clear();
  desk.client.arm();
  REQUIRE(desk.runUntilSent(kCommandLong, 100));
  desk.say("Mission rejected: no takeoff");
  CHECK(desk.told == std::vector<Status>{Status::Infeasible});
  CHECK_FALSE(desk.client.isBusy());
  CHECK((desk.refusal() == Status::Infeasible));
}

TEST_CASE("ensure() that finds the mission aboard keeps what PX4 has said about it, and forgets it of another one") {
  Named desk(ClientOnLine::kPx4);
  const uint32_t name = desk.upload();
  desk.say("Mission rejected: no takeoff");
  desk.client.ensure(inRam(kPlan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 4000));
  desk.tell(countParts(2, PlanType::Mission, name));
  REQUIRE((desk.client.status() == Status::AlreadyAboard));
  CHECK((desk.refusal() == Status::Infeasible));
  const MissionItem other[] = {kPlan[0]};
  mavlink_mission_item_int_t message;
  memcpy(&message, itemParts(0, other[0]).payload.data(), sizeof(message));
  const uint32_t otherName = px4Checksum(0, message);
  desk.client.ensure(inRam(other));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 4000));
  desk.tell(countParts(1, PlanType::Mission, otherName));
  REQUIRE((desk.client.status() == Status::AlreadyAboard));
  CHECK((desk.refusal() != Status::Infeasible));
  // And its name is the one that is compared from now on.
  desk.tellCurrent(name, 2, MISSION_STATE_ACTIVE, 5);
  CHECK((desk.client.aboard() == Aboard::OtherPlan));
  desk.tellCurrent(otherName, 1);
  CHECK((desk.client.aboard() == Aboard::OurPlan));
}

TEST_CASE("ensure() that finds a fence aboard leaves the mission's name, and what was said about it") {
  Named desk(ClientOnLine::kPx4);
  desk.upload();
  desk.say("Mission rejected: no takeoff");
  desk.client.ensure(inRam(kFence), PlanType::Fence);
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 4000));
  desk.tell(countParts(1, PlanType::Fence));
  desk.tell(itemParts(0, kFence[0], PlanType::Fence));
  REQUIRE((desk.client.status() == Status::AlreadyAboard));
  CHECK((desk.client.aboard(PlanType::Fence) == Aboard::OurPlan));
  CHECK((desk.client.aboard() == Aboard::OurPlan));
  CHECK((desk.refusal() == Status::Infeasible));
  desk.tellCurrent(kOtherName, 2, MISSION_STATE_ACTIVE, 5);
  CHECK((desk.client.aboard() == Aboard::OtherPlan));
}
