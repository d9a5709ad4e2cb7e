// What the aircraft does with its mission: the current item, items reached, state, and what the autopilot says in
// words.
#pragma once

#include "service/MessageIntervals.h"

namespace mavmission {

// MISSION_STATE (MAVLink common messages, MISSION_CURRENT.mission_state).
enum class MissionState : uint8_t { NotKnown = 0, NoMission = 1, NotStarted = 2, Active = 3, Paused = 4, Complete = 5 };

// `item` in the sketch's numbering. Called from update(); may start operations.
typedef void (*ItemNumberFunction)(void* context, uint16_t item);
// `text` ends with a zero, has at most 50 characters, and is valid during the call. `severity`: MAV_SEVERITY, 0
// (emergency) to 7 (debug).
typedef void (*TextFunction)(void* context, uint8_t severity, const char* text);

// Follows the mission of the client's autopilot. Declare one beside the client:
//
//   MissionClient autopilot(Serial1);
//   MissionFollower mission(autopilot);
//
// PX4 sends MISSION_CURRENT every second by itself, ArduPilot only where its port's streams are set so. An autopilot
// that has not sent one for two seconds is asked to send it every second (MAV_CMD_SET_MESSAGE_INTERVAL), beside the
// transfers of the client and between its commands: again after 2, 4, 8 s and so on, at the most once a minute, until
// one comes.
class MissionFollower : public detail::MessageIntervals {
 public:
  // The client must stay as long as this.
  explicit MissionFollower(MissionClient& client);

  // The item being flown, or MissionClient::kNoItem before the autopilot has said, and while it is home.
  uint16_t currentItem() const { return current_; }
  // The item reached last, or MissionClient::kNoItem.
  uint16_t reachedItem() const { return reached_; }
  // Items aboard, as the sketch counts them, or 0 when the autopilot does not say.
  uint16_t total() const { return total_; }
  // What the autopilot says of its mission as a whole.
  MissionState state() const { return state_; }
  // False when the autopilot names its plan and it is not the one that was accepted last: someone has changed it.
  // (PX4: the checksum in MISSION_CURRENT and MISSION_COUNT, and in the MISSION_ACK of an upload.) True when the
  // autopilot does not say.
  bool isOurPlan() const;

  // Called when another item is flown.
  void onCurrent(ItemNumberFunction function, void* context = nullptr);
  // Called once for each item reached, though PX4 repeats it; again if the item is flown again.
  void onReached(ItemNumberFunction function, void* context = nullptr);
  // Called with each STATUSTEXT of the autopilot's, whole.
  void onText(TextFunction function, void* context = nullptr);

 private:
  // How often another plan may be named behind an answer to the client before that is believed: what was sent before
  // the answer may come after it.
  static constexpr uint8_t kPatience = 3;
  // Heartbeats of the autopilot's, which come every second: without MISSION_CURRENT before that is asked for, and the
  // pause before it is asked for again.
  static constexpr uint8_t kSilence = 3, kFirstPause = 2, kLongestPause = 64;

  static void take(detail::Listener& listener, const detail::FrameParser& frame);
  void takeHeartbeat();
  void takeName(uint8_t missionType, uint32_t planId);
  void takeCurrent(const detail::FrameParser& frame);
  void takeReached(const detail::FrameParser& frame);
  void takeText(const detail::FrameParser& frame);

  ItemNumberFunction currentFunction_ = nullptr;
  void* currentContext_ = nullptr;
  ItemNumberFunction reachedFunction_ = nullptr;
  void* reachedContext_ = nullptr;
  TextFunction textFunction_ = nullptr;
  void* textContext_ = nullptr;
  uint32_t planId_ = 0;
  uint32_t doubtedId_ = 0;  // of a plan that the autopilot has once called none
  uint16_t current_ = 0xFFFF;
  uint16_t reached_ = 0xFFFF;
  uint16_t total_ = 0;
  MissionState state_ = MissionState::NotKnown;
  bool isNewLeg_ = false;  // the item that was reached last is being flown again
  uint8_t patience_ = 0;
  uint8_t heartbeatsLeft_ = kSilence;  // before MISSION_CURRENT is asked for
  uint8_t pause_ = kFirstPause;        // the next one
};

}  // namespace mavmission
