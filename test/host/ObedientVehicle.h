// A vehicle on the line of a whole client: it obeys commands, gives its plan, and shows its mode in heartbeats.
#pragma once

#include <doctest/doctest.h>
#include <string.h>

#include <vector>

#include "ClientOnLine.h"
#include "Conversation.h"
#include "PlanFrames.h"

namespace obedient {

using namespace mavmission;

constexpr uint8_t kDisarmed = 1, kArmed = 1 | 128;  // HEARTBEAT.base_mode
constexpr uint32_t kStabilize = 0, kAuto = 3;
constexpr uint32_t kPx4Mission = 4ul << 24 | 4ul << 16, kPx4Position = 3ul << 16;
constexpr uint16_t kSetCurrent = MAVLINK_MSG_ID_MISSION_SET_CURRENT, kCommand = MAVLINK_MSG_ID_COMMAND_LONG;
const MissionItem kFlownPlan[] = {takeoff(20_m), changeSpeed(5_mps), waypoint(-35.5_deg, 149.25_deg, 20_m),
                                  returnToLaunch()};

// A vehicle that obeys, and holds and flies a plan; the test says what it does otherwise.
struct Flown : ClientOnLine {
  const bool isPx4;
  uint8_t type = MAV_TYPE_QUADROTOR;
  uint8_t baseMode = kDisarmed;
  uint32_t mode = kStabilize;
  uint16_t flown = 1;                    // the item that it says it flies, in its own numbers
  uint16_t refusedOn = 0, silentOn = 0;  // the command that it refuses, or does not hear
  uint8_t state = MISSION_STATE_ACTIVE;  // of the mission that it flies
  std::vector<MissionItem> held;         // the plan that it gives, as it counts
  uint32_t name = 0;                     // of that plan
  bool givesFloats = false;              // as MISSION_ITEM
  bool isMute = false;                   // it gives none
  std::string ordered;                   // what moves something, until it is emptied: "item 3, mode, arm, begin"

  explicit Flown(uint8_t autopilot = kArduPilot, uint8_t is = MAV_TYPE_QUADROTOR)
      : ClientOnLine(autopilot), isPx4(autopilot == kPx4), type(is) {
    beats = false;
    if (!isPx4) held.push_back(homeItem());
    for (const MissionItem& item : kFlownPlan) held.push_back(item);
    if (isPx4) mode = kPx4Position;
    fly(3000);
  }

  void beat() {
    const uint8_t autopilot = isPx4 ? MAV_AUTOPILOT_PX4 : MAV_AUTOPILOT_ARDUPILOTMEGA;
    hear(heartbeatParts(autopilot, baseMode, mode, type, MAV_STATE_ACTIVE));
  }
  template <typename Message>
  void tell(uint16_t id, uint8_t crcExtra, const Message& message) {
    hear(FrameParts(id, message, crcExtra));
  }
  // It beats once a second, and when it is asked to, and it obeys.
  void fly(uint32_t ms) {
    for (uint32_t at = 0; at < ms; at += 5) {
      if (nowMs() % 1000 < 5) beat();
      const size_t before = sent.size();
      run(5);
      for (size_t i = before; i < sent.size(); ++i) obey(SentFrame(sent[i]));
    }
  }
  void obey(const SentFrame& frame) {
    if (isForHeartbeat(frame)) return beat();
    if (frame.messageId == kSetCurrent) {
      const int item = frame.payload[0] | frame.payload[1] << 8;
      note("item " + std::to_string(item));
      current_ = static_cast<uint16_t>(item == 0 && !isPx4 ? 1 : item);
      return tellCurrent(current_, MISSION_STATE_NOT_STARTED);
    }
    if (frame.messageId == kRequestList && !isMute) return tellCount();
    if (frame.messageId == kRequestInt && !isMute) return give(frame.payload[0]);
    if (frame.messageId != kCommand) return;
    const uint16_t command = commandOf(frame);
    if (command == MAV_CMD_DO_VTOL_TRANSITION) return;
    if (command == MAV_CMD_REQUEST_MESSAGE)
      return tellCurrent(mode == kAuto ? flown : current_, mode == kAuto ? state : uint8_t{MISSION_STATE_ACTIVE});
    note(wordFor(command, static_cast<int>(paramOf(frame, 0))));
    if (command == silentOn) return;
    const bool isRefused = command == refusedOn;
    if (!isRefused && command == MAV_CMD_DO_SET_MODE && !isPx4) mode = static_cast<uint32_t>(paramOf(frame, 1));
    if (!isRefused && command == MAV_CMD_DO_SET_MODE && isPx4) mode = kPx4Mission;
    if (!isRefused && command == MAV_CMD_MISSION_START) mode = isPx4 ? kPx4Mission : kAuto;
    if (!isRefused && command == MAV_CMD_MISSION_START && isPx4) baseMode = kArmed;
    if (!isRefused && command == MAV_CMD_COMPONENT_ARM_DISARM) baseMode = paramOf(frame, 0) == 1 ? kArmed : kDisarmed;
    answer(command, isRefused ? 4 : 0);
    beat();
  }
  void tellCount() { hear(countParts(static_cast<uint16_t>(held.size()), PlanType::Mission, name)); }
  // ArduPilot keeps no yaw.
  void give(uint8_t seq) {
    MissionItem item = held[seq];
    if (!isPx4 && item.param4 != item.param4) item.param4 = 0;
    if (!givesFloats) return hear(itemParts(seq, item));
    const float x = static_cast<float>(item.x) / 1e7f, y = static_cast<float>(item.y) / 1e7f;
    hear(floatItemParts(seq, item, x, y));
  }
  static uint16_t commandOf(const SentFrame& frame) {
    return static_cast<uint16_t>(frame.payload[28] | frame.payload[29] << 8);
  }
  static float paramOf(const SentFrame& frame, size_t index) {
    float value;
    memcpy(&value, &frame.payload[4 * index], sizeof(value));
    return value;
  }
  static bool isForHeartbeat(const SentFrame& frame) {
    return frame.messageId == kCommand && commandOf(frame) == MAV_CMD_REQUEST_MESSAGE && paramOf(frame, 0) == 0;
  }
  void answer(uint16_t command, uint8_t result) { hear(commandAckParts(command, result)); }
  void tellCurrent(uint16_t item, uint8_t state = MISSION_STATE_ACTIVE, uint16_t total = 4) {
    hear(currentParts(item, total, state));
  }
  void upload() {
    client.upload(inRam(kFlownPlan));
    fly(100);
    const uint16_t items = isPx4 ? 4 : 5;
    for (uint16_t item = 0; item < items; ++item) {
      hear(requestParts(item));
      fly(10);
    }
    hear(ackParts(0));
    fly(10);
    REQUIRE((client.aboard() == Aboard::OurPlan));
    sent.clear();
    ended = Status::Idle;
  }
  // What is ordered in that time, and how the operation ends: "mode, arm, begin -> OtherItem at 2".
  std::string flies(uint32_t ms) {
    ordered.clear();
    ended = Status::Idle;
    fly(ms);
    if (ended == Status::Idle) return ordered;
    const bool hasItem = client.failedItem() != MissionClient::kNoItem;
    return ordered + (ordered.empty() ? "-> " : " -> ") + nameOf(ended) +
           (hasItem ? " at " + std::to_string(client.failedItem()) : "");
  }

 private:
  void note(const std::string& word) { ordered += (ordered.empty() ? "" : ", ") + word; }
  static std::string wordFor(uint16_t command, int param) {
    if (command == MAV_CMD_DO_SET_MODE) return "mode";
    if (command == MAV_CMD_COMPONENT_ARM_DISARM) return param == 1 ? "arm" : "disarm";
    return (command == MAV_CMD_MISSION_START ? "begin " : std::to_string(command) + " ") + std::to_string(param);
  }

  uint16_t current_ = 1;
};

}  // namespace obedient
