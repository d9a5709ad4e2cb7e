// The progress of the mission in flight: the current item, the items reached, the mission's state, and the autopilot's
// texts.
#pragma once

#include "../base/RetryRules.h"
#include "MessageIntervals.h"

namespace mavmission {

// MISSION_STATE (MAVLink common messages, MISSION_CURRENT.mission_state).
enum class MissionState : uint8_t { NotKnown = 0, NoMission = 1, NotStarted = 2, Active = 3, Paused = 4, Complete = 5 };

// `item` is in the sketch's numbers. The function is called from update(). It may begin an operation if none runs, and
// may call cancel().
typedef void (*ItemNumberFunction)(void* context, uint16_t item);
// `text` ends with a zero, has at most 50 characters, and is valid during the call. `severity`: MAV_SEVERITY, 0
// (emergency) to 7 (debug). The function is called from update(), and may call the same functions as an
// ItemNumberFunction.
typedef void (*TextFunction)(void* context, uint8_t severity, const char* text);

// Follows the mission of the client's autopilot. Declare one beside the client:
//
//   MissionClient autopilot(Serial1);
//   MissionFollower mission(autopilot);
//
// PX4 sends MISSION_CURRENT every second without a request, ArduPilot only on a port whose streams include it. If none
// has come for two seconds, the autopilot is asked to send it every second (MAV_CMD_SET_MESSAGE_INTERVAL), during the
// client's transfers and between its commands. The request is repeated after 2, 4, 8 s and so on, at last once a
// minute, until a MISSION_CURRENT comes.
class MissionFollower : public detail::MessageIntervals {
 public:
  // This object must live as long as the client: declare it next to the client, not in a function.
  explicit MissionFollower(MissionClient& client);

  // The item being flown, or MissionClient::kNoItem if the autopilot has not reported one yet, or if the item is home.
  uint16_t currentItem() const { return current_; }
  // The item reached last, or MissionClient::kNoItem: from each arming on until one is reached.
  uint16_t reachedItem() const { return isReachedBefore_ ? 0xFFFF : reached_; }
  // The number of items aboard, in the sketch's numbers, or 0 when the autopilot does not report it.
  uint16_t total() const { return total_; }
  // The state of the mission as a whole, as the autopilot reports it.
  MissionState state() const { return state_; }
  // True while the client's aboard() is our plan. The follower sets aboard() to Aboard::OtherPlan, and start() is then
  // refused, when somebody else puts a plan there. PX4 names its plan by a checksum, in MISSION_CURRENT, MISSION_COUNT
  // and an upload's MISSION_ACK; if our plan comes back, so does Aboard::OurPlan. On ArduPilot another plan is detected
  // by the number of items in MISSION_CURRENT, and by ArduPilot's text about an upload over our own link. A plan of the
  // same length that reaches ArduPilot over another link or as a file is not detected: use verify() or ensure(), which
  // read the plan itself.
  bool isOurPlan() const;

  // Called when the current item changes.
  void onCurrent(ItemNumberFunction function, void* context = nullptr);
  // Called once for each item that is behind, in order; again if it is flown again. MISSION_ITEM_REACHED says so, which
  // PX4 repeats, and ArduPilot sends once: where it was lost, a MISSION_CURRENT that has moved on says the same, about
  // a second later. More than 8 at once are a jump that somebody has made, and are not told of; where the plan itself
  // has jumped back, it is told of waypoints alone, not of the commands between them. A waypoint counts as reached
  // within the autopilot's own radius: PX4's (NAV_ACC_RAD) is 10 m, so it says so 9 m before the place, while it flies
  // past; with a hold both say so at its end. For work at a place see Flight.
  void onReached(ItemNumberFunction function, void* context = nullptr);
  // Called with each STATUSTEXT of the autopilot. ArduPilot's texts count home: its "Reached command #2" is item 1.
  void onText(TextFunction function, void* context = nullptr);

 private:
  // Of the item reached last.
  enum class Leg : uint8_t {
    Flown,
    Early,  // it was reported as reached before it was reported as the current item
    Again   // it has become the current item again
  };

  static void take(detail::Listener& listener, const detail::FrameParser& frame);
  void takeHeartbeat();
  MAVMISSION_APART void takeName(uint32_t planId);
  void takeAcceptance(const detail::FrameParser& frame);
  void takePlanText(const char* text);
  void takeCurrent(const detail::FrameParser& frame);
  void takeReached(const detail::FrameParser& frame);
  MAVMISSION_APART void tellUpTo(uint16_t end, uint16_t left);
  MAVMISSION_APART void tell(uint16_t item);
  void takeText(const detail::FrameParser& frame);

  ItemNumberFunction currentFunction_ = nullptr;
  void* currentContext_ = nullptr;
  ItemNumberFunction reachedFunction_ = nullptr;
  void* reachedContext_ = nullptr;
  TextFunction textFunction_ = nullptr;
  void* textContext_ = nullptr;
  uint32_t planId_ = 0;
  uint16_t current_ = 0xFFFF;
  uint16_t reached_ = 0xFFFF;
  uint16_t next_ = 0;  // the first item that may still be told of as behind
  uint16_t total_ = 0;
  MissionState state_ = MissionState::NotKnown;
  uint8_t textDue_ = 0;  // heartbeats left in which ArduPilot's text about an upload of ours is expected
  Leg leg_ = Leg::Flown;
  bool isDoubted_ : 1;        // the autopilot has once reported the plan with planId_ as no mission
  bool wasArmed_ : 1;         // at its last heartbeat
  bool hasJumped_ : 1;        // in this flight the plan has gone back to an earlier item
  bool isReachedBefore_ : 1;  // reached_ was reached before it was armed; PX4 repeats it for some time all the same
  uint8_t patience_ = 0;
  uint8_t heartbeatsLeft_ = detail::FollowRules::kSilence;  // before MISSION_CURRENT is requested
  uint8_t pause_ = detail::FollowRules::kFirstPause;        // the next one
};

}  // namespace mavmission
