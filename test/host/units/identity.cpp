// Of whom: what was begun for one aircraft, and what was learned of it, stays with that one.
#include <doctest/doctest.h>
#include <string.h>

#include <functional>
#include <vector>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

const MissionItem kPlan[] = {takeoff(-35.3632621_deg, 149.1652374_deg, 20_m),
                             waypoint(-35.3614500_deg, 149.1652374_deg, 20_m), returnToLaunch()};
const MissionItem kFence[] = {
    fenceInside(-35.3632621_deg, 149.1652374_deg, 4), fenceInside(-35.3614500_deg, 149.1652374_deg, 4),
    fenceInside(-35.3614500_deg, 149.1662374_deg, 4), fenceInside(-35.3632621_deg, 149.1662374_deg, 4)};
bool wrong(void*, uint16_t, MissionItem& item) {
  item = waypoint(-35.3632621_deg, 149.1652374_deg, 20_m);
  item.x = 950000000;
  return true;
}
bool right(void*, uint16_t index, MissionItem& item) {
  item = kPlan[index];
  return true;
}

constexpr uint16_t kClearAll = 45, kCommand = 76;

struct Device {
  uint8_t systemId, componentId, type, autopilot, baseMode, state, version;
  constexpr Device(uint8_t system, uint8_t component, uint8_t vehicle, uint8_t firmware, uint8_t base = 0,
                   uint8_t status = 3, uint8_t speaks = 2)
      : systemId(system),
        componentId(component),
        type(vehicle),
        autopilot(firmware),
        baseMode(base),
        state(status),
        version(speaks) {}
};
constexpr Device kOurs = {1, 1, 2, 3};

FrameParts beatOf(const Device& who) {
  FrameParts beat = heartbeatParts(who.autopilot, who.baseMode);
  mavlink_heartbeat_t message;
  memcpy(&message, beat.payload.data(), sizeof(message));
  message.type = who.type;
  message.system_status = who.state;
  memcpy(beat.payload.data(), &message, sizeof(message));
  beat.systemId = who.systemId;
  beat.componentId = who.componentId;
  beat.version = who.version;
  return beat;
}

// The system to which a frame is addressed; 0: to nobody.
uint8_t targetOf(const SentFrame& sent) {
  switch (sent.messageId) {
    case ClientOnLine::kRequestList:
    case kClearAll:
    case ClientOnLine::kAck: return sent.payload[0];
    case ClientOnLine::kRequest:
    case ClientOnLine::kRequestInt:
    case ClientOnLine::kCount: return sent.payload[2];
    case ClientOnLine::kItemInt: return sent.payload[32];
    case kCommand: return sent.payload[30];
    default: return 0;
  }
}

// An autopilot that takes plans, beside whom others may be heard.
struct Line : ClientOnLine {
  Device ours = kOurs;
  std::vector<Device> heard = {kOurs};  // their heartbeats come every second
  uint16_t items = 0;

  Line() : ClientOnLine(kArduPilot) { beats = false; }

  void pass(uint32_t ms) {
    for (; ms != 0; --ms) {
      if (nowMs() % 1000 == 0) beatAll();
      const size_t before = sent.size();
      run(1);
      for (size_t i = before; i < sent.size(); ++i) react(sent[i]);
    }
  }
  void beatAll() {
    for (const Device& one : heard) beat(one);
  }
  void beat(const Device& who) {
    if (who.systemId == ours.systemId && who.componentId == ours.componentId) return hear(beatOf(who));
    FrameParts parts = beatOf(who);
    parts.sequence = othersSequence_++;
    line.bring(packed(parts));
  }
  void answer(uint16_t command, uint8_t result) {
    hear(FrameParts(77, {static_cast<uint8_t>(command), static_cast<uint8_t>(command >> 8), result}, 143));
  }
  Status end(uint32_t limitMs = 20000) {
    ended = Status::Idle;
    for (; limitMs != 0 && ended == Status::Idle; --limitMs) pass(1);
    return ended;
  }
  bool passUntilSent(uint16_t messageId, uint32_t limitMs = 9000) {
    for (; limitMs != 0; --limitMs) {
      const size_t before = sent.size();
      pass(1);
      for (size_t i = before; i < sent.size(); ++i) {
        if (sent[i].messageId == messageId) return true;
      }
    }
    return false;
  }
  // Another system than ours has got something.
  bool reached(uint8_t systemId) const {
    for (const SentFrame& one : sent) {
      if (targetOf(one) == systemId) return true;
    }
    return false;
  }

 private:
  uint8_t othersSequence_ = 0;

  void react(const SentFrame& frame) {
    if (targetOf(frame) != ours.systemId || heard.empty() || heard[0].systemId != ours.systemId) return;
    const uint8_t type = frame.messageId == kItemInt ? frame.payload[37] : frame.payload[4];
    if (frame.messageId == kCount) {
      items = static_cast<uint16_t>(frame.payload[0] | frame.payload[1] << 8);
      hear(requestParts(0, 1, 191, type));
    } else if (frame.messageId == kItemInt) {
      const uint16_t next = static_cast<uint16_t>((frame.payload[28] | frame.payload[29] << 8) + 1);
      hear(next < items ? requestParts(next, 1, 191, type) : ackParts(0, 1, 191, type));
    } else if (frame.messageId == kClearAll) {
      hear(ackParts(0, 1, 191, frame.payload[2]));
    } else if (frame.messageId == kCommand) {
      const uint16_t command = static_cast<uint16_t>(frame.payload[28] | frame.payload[29] << 8);
      if (command == 400) ours.baseMode = 128;
      for (Device& one : heard) {
        if (one.systemId == ours.systemId && one.componentId == ours.componentId) one = ours;
      }
      answer(command, 0);
      if (command == 512) hear(beatOf(ours));
    }
  }
};

struct Begun {
  const char* name;
  std::function<Status(MissionClient&)> begin;
};
const Begun kOperations[] = {
    {"upload", [](MissionClient& client) { return client.upload(inRam(kPlan)); }},
    {"upload a fence", [](MissionClient& client) { return client.upload(inRam(kFence), PlanType::Fence); }},
    {"ensure", [](MissionClient& client) { return client.ensure(inRam(kPlan)); }},
    {"verify", [](MissionClient& client) { return client.verify(inRam(kPlan)); }},
    {"clear", [](MissionClient& client) { return client.clear(); }},
    {"arm", [](MissionClient& client) { return client.arm(); }},
    {"start", [](MissionClient& client) { return client.start(); }},
    {"verifyAndStart", [](MissionClient& client) { return client.verifyAndStart(inRam(kPlan)); }},
    {"setMode", [](MissionClient& client) { return client.setMode(FlightMode::ReturnToLaunch); }},
    {"setCurrentItem", [](MissionClient& client) { return client.setCurrentItem(1); }},
    {"setMessageInterval", [](MissionClient& client) { return client.setMessageInterval(33, 100000); }},
};

}  // namespace

TEST_CASE("what was begun for an autopilot that falls silent is not carried out on the next one that is heard") {
  for (const Begun& operation : kOperations) {
    for (uint32_t silentAfterMs : {0, 40, 900}) {
      for (const Device& next : {Device{2, 1, 2, 3}, Device{2, 1, 2, 3, 128, 4}, Device{2, 1, 2, 12}}) {
        CAPTURE(operation.name);
        CAPTURE(silentAfterMs);
        CAPTURE(next.baseMode);
        Line line;
        line.pass(3000);
        line.client.upload(inRam(kPlan));
        REQUIRE((line.end() == Status::Accepted));
        line.pass(11300);
        line.sent.clear();
        line.heard.clear();
        operation.begin(line.client);
        line.pass(silentAfterMs);
        line.heard = {next};
        for (int second = 0; second < 40; ++second) line.pass(1000);
        CHECK_FALSE(line.reached(2));
        CHECK_FALSE(line.client.hasAutopilot());
        CHECK_FALSE(line.client.isArmed());
      }
    }
  }
}

TEST_CASE("another autopilot, or a restart, ends what runs, and all that was known is forgotten") {
  const std::vector<std::function<void(Line&)>> changes = {
      [](Line& line) { line.client.setTargetIds(2, 1); },
      [](Line& line) { line.hear(beatOf({1, 1, 2, 12})), line.hear(beatOf({1, 1, 2, 12})); },  // PX4 by the same ids
      [](Line& line) { line.hear(beatOf({1, 1, 10, 3})), line.hear(beatOf({1, 1, 10, 3})); },  // a rover
      [](Line& line) { line.hear(beatOf({1, 1, 2, 3, 0, 1})); },                               // it boots
      [](Line& line) { line.hear(beatOf({1, 1, 2, 3, 0, 1, 1})); },                            // the same, in MAVLink 1
      // Behind a silence.
      [](Line& line) { line.pass(5500), line.hear(beatOf({1, 1, 10, 3})), line.hear(beatOf({1, 1, 10, 3})); },
  };
  for (size_t i = 0; i < changes.size(); ++i) {
    CAPTURE(i);
    Line line;
    line.pass(3000);
    line.client.upload(inRam(kPlan));
    REQUIRE((line.end() == Status::Accepted));
    CHECK((line.client.aboard() == Aboard::OurPlan));
    line.pass(11500);
    line.client.upload(inRam(kPlan));
    REQUIRE(line.passUntilSent(ClientOnLine::kCount));
    line.sent.clear();
    line.heard.clear();
    changes[i](line);
    CHECK((line.end(10) == Status::NoAutopilot));
    CHECK((line.client.aboard() == Aboard::NotKnown));
    line.heard = {kOurs};
    line.client.setTargetIds(1, 1);
    line.pass(3000);
    line.sent.clear();
    line.client.start();
    CHECK((line.end() == Status::Unproven));
    CHECK(line.sent.size() <= 2);  // our heartbeat
  }
}

TEST_CASE("after one heartbeat that shows another vehicle nothing is sent until the next one, and then it goes on") {
  Line line;
  line.pass(3000);
  line.client.upload(inRam(kPlan));
  REQUIRE(line.passUntilSent(ClientOnLine::kCount));
  line.hear(beatOf({1, 1, 13, 3}));
  line.heard.clear();
  line.sent.clear();
  line.pass(4000);
  CHECK(line.sent.empty());
  line.heard = {kOurs};
  CHECK((line.end() == Status::Accepted));
}

TEST_CASE("no heartbeat of another device changes what is done, to whom, or what is known") {
  const Device kinds[] = {
      {1, 156, 27, 8},      {1, 156, 0, 0},  {1, 158, 2, 0}, {1, 100, 30, 8},   {1, 154, 26, 8},
      {255, 190, 6, 8},     {1, 191, 18, 8}, {7, 1, 5, 3},   {51, 68, 0, 8},    {2, 1, 2, 3},
      {2, 1, 2, 3, 128, 4}, {2, 1, 2, 12},   {1, 2, 2, 3},   {9, 9, 2, 7, 128}, {1, 1, 6, 8, 128},
  };
  for (const Device& stranger : kinds) {
    for (uint8_t version : {1, 2}) {
      CAPTURE(int{stranger.systemId});
      CAPTURE(int{stranger.type});
      CAPTURE(int{stranger.autopilot});
      Device other = stranger;
      other.version = version;
      Line line;
      line.pass(3000);
      line.heard = {kOurs, other};
      line.client.upload(inRam(kPlan));
      CHECK((line.end() == Status::Accepted));
      line.pass(700);
      line.client.upload(inRam(kPlan));
      CHECK(line.passUntilSent(ClientOnLine::kItemInt));
      line.beat(other);
      CHECK((line.end() == Status::Accepted));
      line.client.setMessageInterval(33, 100000);
      CHECK((line.end() == Status::Done));
      line.client.arm();
      CHECK((line.end() == Status::Done));
      CHECK((line.client.aboard() == Aboard::OurPlan));
      CHECK((line.client.firmware() == Firmware::ArduPilot));
      CHECK(line.client.isArmed());
      if (other.systemId != 1) CHECK_FALSE(line.reached(other.systemId));
      for (const SentFrame& one : line.sent) CHECK(one.frame[0] == 0xFD);
    }
  }
}

TEST_CASE("a device that is no autopilot gets nothing, also where it is heard first and alone") {
  for (const Device& first : {Device{1, 156, 27, 8}, Device{1, 156, 0, 0}, Device{1, 158, 2, 0}, Device{255, 190, 6, 8},
                              Device{1, 191, 18, 8}, Device{51, 68, 0, 0}}) {
    CAPTURE(int{first.type});
    Line line;
    line.heard = {first};
    line.ours = first;
    line.client.upload(inRam(kPlan));
    line.pass(8000);
    CHECK(line.sent.empty());
    CHECK((line.client.status() == Status::WaitingForAutopilot));
    line.ours = kOurs;
    line.heard = {kOurs, first};
    CHECK((line.end() == Status::Accepted));
  }
}

TEST_CASE("a frame about a fence does not become one about the mission when the autopilot turns to MAVLink 1") {
  for (bool isClear : {false, true}) {
    CAPTURE(isClear);
    Line line;
    line.pass(3000);
    if (isClear) {
      line.client.clear(PlanType::Fence);
    } else {
      line.client.upload(inRam(kFence), PlanType::Fence);
    }
    REQUIRE(line.runUntilSent(isClear ? kClearAll : uint16_t{ClientOnLine::kCount}, 5000));
    line.sent.clear();
    line.heard[0].version = line.ours.version = 1;
    line.beatAll();
    line.runUntilSent(isClear ? kClearAll : uint16_t{ClientOnLine::kCount}, 5000);
    for (const SentFrame& one : line.sent) {
      const bool isOfPlan = one.messageId == kClearAll || one.messageId == ClientOnLine::kCount;
      if (isOfPlan) CHECK(one.frame[0] == 0xFD);
    }
  }
}

TEST_CASE("what was refused before anything was sent leaves aboard() as it was, and start() flies the plan aboard") {
  struct Refused {
    Status status;
    std::function<Status(MissionClient&)> begin;
  };
  const Refused kinds[] = {
      {Status::BadLatitude, [](MissionClient& client) { return client.upload(fromFunction(wrong, 2)); }},
      {Status::BadLatitude, [](MissionClient& client) { return client.ensure(fromFunction(wrong, 2)); }},
      {Status::BadLatitude, [](MissionClient& client) { return client.uploadWithoutReadback(fromFunction(wrong, 2)); }},
      {Status::TooManyItems, [](MissionClient& client) { return client.upload(fromFunction(right, 70000)); }},
      {Status::TooManyItems, [](MissionClient& client) { return client.verify(fromFunction(right, 70000)); }},
      {Status::BadPlanType, [](MissionClient& client) { return client.upload(inRam(kPlan), PlanType::All); }},
      {Status::BadRange, [](MissionClient& client) { return client.uploadPartial(fromFunction(right, 2), 1, 2); }},
      {Status::Armed, [](MissionClient& client) { return client.upload(inRam(kPlan)); }},
      {Status::Armed, [](MissionClient& client) { return client.uploadAgain(); }},
      {Status::NoAutopilot, [](MissionClient& client) { return client.upload(fromFunction(right, 2)); }},
      {Status::NoAutopilot, [](MissionClient& client) { return client.verify(fromFunction(right, 2)); }},
      {Status::NoAutopilot, [](MissionClient& client) { return client.ensure(fromFunction(right, 2)); }},
      {Status::Cancelled, [](MissionClient& client) { return client.upload(fromFunction(right, 2)); }},
  };
  for (const Refused& kind : kinds) {
    CAPTURE(toString(kind.status));
    CAPTURE(&kind - kinds);
    Line line;
    line.pass(3000);
    line.client.upload(inRam(kPlan));
    REQUIRE((line.end() == Status::Accepted));
    line.client.setAutopilotTimeout(3);
    line.ours.baseMode = line.heard[0].baseMode = kind.status == Status::Armed ? 128 : 0;
    if (kind.status == Status::NoAutopilot) line.heard.clear();
    line.pass(6500);
    line.sent.clear();
    kind.begin(line.client);
    if (kind.status == Status::Cancelled) line.client.cancel();
    CHECK((line.end() == kind.status));
    for (const SentFrame& one : line.sent) CHECK(one.messageId == 0);
    CHECK((line.client.aboard() == Aboard::OurPlan));
    line.ours.baseMode = 0;
    line.heard = {kOurs};
    line.pass(3000);
    line.sent.clear();
    line.client.start();
    CHECK(line.passUntilSent(kCommand));
    CHECK((line.client.status() != Status::Unproven));
  }
}
