// Whose mission is aboard, as the autopilot tells between the operations of a whole client: PX4 names its mission,
// ArduPilot counts its items and says in words that an upload has ended.
#include <doctest/doctest.h>
#include <string.h>

#include <memory>

#include "Conversation.h"
#include "Px4Checksum.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

constexpr uint8_t kArduPilot = Conversation::kArduPilot, kPx4 = Conversation::kPx4;
const MissionItem kPlan[] = {anyCommandAt(kNavWaypoint, -35.3632621_deg, 149.1652374_deg, 20_m), returnToLaunch()};
const MissionItem kFence[] = {fenceInsideCircle(-35.36_deg, 149.16_deg, 100_m)};
constexpr uint32_t kName = 0x12345678, kOtherName = 0x87654321;
const char* const kRejected = "Mission rejected: no takeoff";

enum Fresh { kNothingYet };

struct Named : Conversation {
  MissionFollower follower;
  uint32_t name = 0;

  // The plan is aboard, under this name.
  Named(uint8_t autopilot, uint32_t is, uint32_t items = 2) : Conversation(autopilot), follower(client), name(is) {
    isAbout(inRam(kPlan, items)).plays("verify, until LIST, count named " + std::to_string(is) + ", items");
    forgetEnds();
  }
  Named(uint8_t autopilot, Fresh) : Conversation(autopilot, kPlan), follower(client) {}
  // The plan is uploaded, and accepted with PX4's checksum.
  explicit Named(uint8_t autopilot) : Conversation(autopilot, kPlan), follower(client) { upload(); }

  void upload() {
    CHECK(isAbout(inRam(kPlan)).plays("upload unread, until COUNT, asks all, accepted named ours") ==
          "COUNT 2, ITEM 0-1, -> Accepted (OurPlan)");
    name = checksum();
    forgetEnds();
  }
  void uploadFence() {
    isAbout(inRam(kFence), PlanType::Fence).plays("upload unread, until COUNT, asks all");
    mavlink_mission_item_int_t item;
    memcpy(&item, sent.back().payload.data(), sizeof(item));
    CHECK(plays("accepted named " + std::to_string(px4Checksum(0, item))) == "-> Accepted (OurPlan)");
    forgetEnds();
  }
  void forgetEnds() {
    REQUIRE((client.aboard() == Aboard::OurPlan));
    told.clear();
  }
  // What aboard() says after so many of MISSION_CURRENT.
  std::string shown(uint32_t byName, uint16_t total = 2, uint8_t state = MISSION_STATE_ACTIVE, int times = 5) {
    mavlink_mission_current_t message = mavlink_mission_current_t();
    message.seq = 1;
    message.total = total;
    message.mission_state = state;
    message.mission_id = byName;
    for (; times > 0; --times) tell(MAVLINK_MSG_ID_MISSION_CURRENT, MAVLINK_MSG_ID_MISSION_CURRENT_CRC, message);
    return nameOf(client.aboard());
  }
  std::string shownOnce(uint32_t byName, uint16_t total = 2) { return shown(byName, total, MISSION_STATE_ACTIVE, 1); }
  // What onEnd() is told after this text.
  std::string says(const char* text) {
    Bytes payload(51);
    payload[0] = 6;
    memcpy(&payload[1], text, strlen(text));
    told.clear();
    tell(FrameParts(MAVLINK_MSG_ID_STATUSTEXT, payload, MAVLINK_MSG_ID_STATUSTEXT_CRC));
    std::string all;
    for (const Status status : told) all += nameOf(status);
    return all;
  }
  // Why start() is refused.
  std::string refusal() {
    ended = Status::Idle;
    client.start();
    pass(5);
    const std::string why = nameOf(ended);
    if (client.isBusy()) client.cancel();
    pass(5);
    return why;
  }
};

}  // namespace

TEST_CASE("a mission of another name is somebody else's, and ours is back with its name") {
  for (const bool isUploaded : {false, true}) {
    std::unique_ptr<Named> made(isUploaded ? new Named(kPx4) : new Named(kPx4, kName));
    Named& desk = *made;
    CHECK(desk.shown(desk.name) == "OurPlan");
    CHECK(desk.shown(kOtherName) == "OtherPlan");
    CHECK_FALSE(desk.follower.isOurPlan());
    CHECK(desk.refusal() == "Unproven");
    CHECK(desk.shownOnce(desk.name) == "OurPlan");
    CHECK(desk.follower.isOurPlan());
  }
}

TEST_CASE("a name is compared whatever number it is, and no name is none") {
  for (const uint32_t name : {1u, 2u, 0xFFFFFFFFu}) {
    Named desk(kPx4, name);
    CHECK(desk.shown(0) == "OurPlan");
    CHECK(desk.shown(0, 0xFFFE) == "OurPlan");  // PX4's total tells nothing
    CHECK(desk.shown(name == 1 ? 2 : 1) == "OtherPlan");
  }
  for (const uint32_t name : {1u, kName}) {
    Named desk(kPx4, name);
    CHECK(desk.shown(0, 0xFFFF, MISSION_STATE_NO_MISSION) == "OtherPlan");  // without a plan
    CHECK(desk.shown(0, 0xFFFF, MISSION_STATE_NO_MISSION, 1) == "OtherPlan");
    CHECK(desk.shownOnce(name) == "OurPlan");
  }
}

TEST_CASE("a mission that was accepted without a name is not told from another one by names or by PX4's total") {
  Named desk(kPx4, 0);
  desk.shown(kOtherName);
  desk.shown(0, 9);
  desk.shown(0, 9, MISSION_STATE_UNKNOWN);
  CHECK(desk.shown(0, 0xFFFF, MISSION_STATE_NO_MISSION) == "OurPlan");
}

TEST_CASE("what was not known to be ours is not somebody else's by its name, nor ours") {
  Named desk(kPx4, kName);
  desk.plays("upload unread, until COUNT");
  CHECK(desk.shown(kOtherName) == "NotKnown");
  CHECK(desk.shown(kName) == "NotKnown");
}

TEST_CASE("ArduPilot's mission of another length is somebody else's, unless its state is not known, or of a fence") {
  Named desk(kArduPilot, 0), fence(kArduPilot, 0);
  desk.shown(0);
  CHECK(desk.shown(0, 3, MISSION_STATE_UNKNOWN) == "OurPlan");
  CHECK(desk.shown(0, 3) == "OtherPlan");
  fence.isAbout(inRam(kFence), PlanType::Fence).plays("verify, cancel");
  CHECK(fence.shown(0, 3) == "OurPlan");
}

TEST_CASE(
    "ArduPilot's text about an upload that is not ours tells of another plan, and beside a transfer it does not") {
  for (const std::string then : {"5 ms", "arm"}) {
    Named desk(kArduPilot, 0, 1);
    desk.plays("verify, until LIST");
    desk.says("Flight plan received");
    CHECK((desk.client.aboard() == Aboard::OurPlan));
    desk.plays("cancel, " + then);
    desk.says("Flight plan received");
    CHECK((desk.client.aboard() == Aboard::OtherPlan));
  }
}

TEST_CASE("a mission that PX4 rejects in words after its acceptance is infeasible, and that is told once") {
  Named other(kPx4, kNothingYet);
  CHECK(other.says(kRejected) == "");  // none of ours
  Named desk(kPx4);
  CHECK(desk.says(kRejected) == "Infeasible");
  CHECK((desk.ends.back() == Status::Infeasible));
  CHECK((desk.client.status() == Status::Infeasible));
  CHECK(desk.says(kRejected) == "");
  CHECK(desk.refusal() == "Infeasible");
  // A fence does not change that, and the next mission does.
  desk.uploadFence();
  CHECK(desk.refusal() == "Infeasible");
  desk.upload();
  CHECK(desk.refusal() != "Infeasible");
}

TEST_CASE("beside an operation that transfers, an infeasible mission is not told, and it ends a command") {
  Named desk(kPx4);
  desk.plays("verify, until LIST");
  CHECK(desk.says(kRejected) == "");
  CHECK((desk.client.status() == Status::Transferring));
  desk.plays("cancel, arm, until LONG 100 ms");
  CHECK(desk.says(kRejected) == "Infeasible");
  CHECK_FALSE(desk.client.isBusy());
  CHECK(desk.refusal() == "Infeasible");
}

TEST_CASE("ensure() that finds the mission aboard keeps what PX4 has said about it, and forgets it of another one") {
  Named desk(kPx4);
  desk.says(kRejected);
  desk.plays("ensure, until LIST, count named ours");
  REQUIRE((desk.client.status() == Status::AlreadyAboard));
  CHECK(desk.refusal() == "Infeasible");
  desk.isAbout(inRam(kPlan, 1)).plays("ensure, until LIST, count named ours");
  REQUIRE((desk.client.status() == Status::AlreadyAboard));
  CHECK(desk.refusal() != "Infeasible");
  // And its name is the one that is compared from now on.
  CHECK(desk.shown(desk.name) == "OtherPlan");
  CHECK(desk.shownOnce(desk.checksum(), 1) == "OurPlan");
}

TEST_CASE("ensure() that finds a fence aboard leaves the mission's name, and what was said about it") {
  Named desk(kPx4);
  desk.says(kRejected);
  desk.isAbout(inRam(kFence), PlanType::Fence).plays("ensure, until LIST, count, items");
  REQUIRE((desk.client.status() == Status::AlreadyAboard));
  CHECK((desk.client.aboard(PlanType::Fence) == Aboard::OurPlan));
  CHECK((desk.client.aboard() == Aboard::OurPlan));
  CHECK(desk.refusal() == "Infeasible");
  CHECK(desk.shown(kOtherName) == "OtherPlan");
}
