// What the aircraft does with its mission: the current item, items reached, state, and what the autopilot says in words.
#pragma once

#include "Listener.h"

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
class MissionFollower : public Listener {
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
  // (PX4: MISSION_CURRENT.mission_id.) True when the autopilot does not say.
  bool isOurPlan() const;

  // Called when another item is flown.
  void onCurrent(ItemNumberFunction function, void* context = nullptr);
  // Called once for each item reached, though PX4 repeats it; again if the item is flown again.
  void onReached(ItemNumberFunction function, void* context = nullptr);
  // Called with each STATUSTEXT of the autopilot's, whole.
  void onText(TextFunction function, void* context = nullptr);

 private:
  static void take(Listener& listener, const FrameParser& frame);
  void takeCurrent(const FrameParser& frame);
  void takeReached(const FrameParser& frame);
  void takeText(const FrameParser& frame);

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
};

}  // namespace mavmission
