// Making an aircraft fly the plan that is aboard, as a pure state machine: its inputs are the answers to commands,
// heartbeats, MISSION_CURRENT and the items of the plan, its outputs are the next message and the item to look at. A
// CommandTransfer repeats each message until it is answered. docs/design/flying.md has the diagram.
#pragma once

#include <stdint.h>

#include "../autopilot/Personality.h"
#include "../base/Config.h"
#include "../base/RetryRules.h"
#include "../base/Status.h"
#include "../item/MissionItem.h"
#include "CommandTransfer.h"
#include "ModeOrder.h"
#include "Operations.h"

namespace mavmission {
namespace detail {

// The aircraft, as its last heartbeat shows it, and the time.
struct Aircraft {
  Firmware firmware;
  uint8_t vehicleType;  // MAV_TYPE
  bool isArmed;
  uint16_t mode;      // in the numbers of modeNumber()
  uint16_t autoMode;  // its number for FlightMode::Auto; kNoMode: it has none
  uint16_t seconds;   // of the operation [s]
  uint16_t nowMs;
};

// All zero at the start. Items have wire numbers. Status::Transferring means that it goes on.
class StartTransfer : public StartRules {
 public:
  static constexpr uint16_t kNoItem = 0xFFFF;

  // New: before begin(). Looking: searches for the item that will be flown first. Steps: a step is under way. Asking:
  // the first item was set, and the autopilot is asked for its current item. Shown: a heartbeat shows that the aircraft
  // flies. Judging, JudgingNext: compares its current item with the one that will be flown first, or with the next.
  // Leaving: a step failed; waits for a heartbeat that shows whether to disarm. Disarming: the command was sent.
  // Restoring: sets a mode again that a step has undone.
  enum class State : uint8_t {
    New,
    Looking,
    Steps,
    Asking,
    Shown,
    Judging,
    JudgingNext,
    Leaving,
    Disarming,
    Restoring,
    Yielding
  };

  // DO_SET_MODE, MISSION_SET_CURRENT, COMPONENT_ARM_DISARM, MISSION_START, REQUEST_MESSAGE for MISSION_CURRENT.
  enum class Message : uint8_t { Mode, FirstItem, Arm, Start, AskCurrent, Disarm };

  // The item to begin with, as the sketch numbers it, until begin() replaces it by its wire number.
  void setFirst(uint16_t item) { first_ = item; }
  uint16_t first() const { return first_; }

  // `isMission`: the plan whose items can be looked at is the mission that is aboard.
  void begin(uint16_t first, bool isMission, Firmware firmware);

  bool isLooking() const { return state() == State::Looking; }
  bool isJudging() const { return state() == State::Judging || state() == State::JudgingNext; }
  // While isLooking() or isJudging(): Accepted if onItem() wants item next() of a plan with `items` items; Done if
  // start() has succeeded without a further look; otherwise what onItem() is to be told in the place of an item.
  Status wantsItem(uint16_t items, Firmware firmware) const;
  uint16_t next() const { return next_; }
  // Takes this item of the plan, where `read` is Accepted; otherwise it cannot be had, for the reason `read`.
  Status onItem(Status read, const MissionItem* item, const Aircraft& aircraft, CommandTransfer& sending);

  // The answer to a step's command, or the lack of one: NoAnswer, Unconfirmed, TookTooLong.
  MAVMISSION_APART Status onAccepted(const Aircraft& aircraft, CommandTransfer& sending);
  Status onRefused(Status refusal, const Aircraft& aircraft, CommandTransfer& sending);
  Status onSilent(Status silence, const Aircraft& aircraft, CommandTransfer& sending);
  Status onHeartbeat(const Aircraft& aircraft, CommandTransfer& sending);
  // `isUnderWay`: MISSION_CURRENT.mission_state does not deny that the mission is flown.
  Status onCurrent(uint16_t item, bool isUnderWay, const Aircraft& aircraft, CommandTransfer& sending);

  // A MISSION_CURRENT is about another plan than ours.
  Status onOtherNamed(const Aircraft& aircraft, CommandTransfer& sending);
  // The autopilot is known to have another plan than ours. What start() has armed is disarmed; in the air the autopilot
  // refuses that.
  Status onOther(const Aircraft& aircraft, CommandTransfer& sending);
  // The same for a StartTransfer of before begin(), of an aircraft that a start() with this `arming` has made fly.
  Status leaveFlying(StartArming arming, const Aircraft& aircraft, CommandTransfer& sending);
  bool isLeaving() const { return state() >= State::Leaving; }

  // The message that `sending` sends when it is due. Of no use before the first step.
  Message message() const;
  // The mode of Message::Mode, in the numbers of modeNumber().
  uint16_t modeToSet() const { return order_.wanted(); }

  State state() const { return state_; }
  StartStep step() const { return static_cast<StartStep>(step_); }
  StartArming arming() const { return static_cast<StartArming>(arming_); }
  // The current item that the autopilot named last; kNoItem: none yet. With Status::OtherItem it is that item.
  uint16_t seen() const { return seen_; }

 private:
  static constexpr uint8_t kCannotLook = 100;  // of items looked at: that many, or they cannot be had

  MAVMISSION_APART uint16_t firstItem(Firmware firmware) const;
  MAVMISSION_APART void lookFromFirst(Firmware firmware);
  Status follow(const MissionItem& item);
  Status nextStep(const Aircraft& aircraft, CommandTransfer& sending);
  bool beginStep(const Aircraft& aircraft, CommandTransfer& sending);
  bool isArmingStep(Firmware firmware) const;
  MAVMISSION_APART Status leave(Status refusal, const Aircraft& aircraft, CommandTransfer& sending);
  MAVMISSION_APART Status restore(Status refusal, CommandTransfer& sending);
  MAVMISSION_APART Status notRestored() const;
  Status onHeartbeatLeaving(const Aircraft& aircraft, CommandTransfer& sending);
  Status giveWay(const Aircraft& aircraft, CommandTransfer& sending);
  Status onHeartbeatYielding(const Aircraft& aircraft, CommandTransfer& sending);
  MAVMISSION_APART Status onOwnMode(bool isWanted, const Aircraft& aircraft, CommandTransfer& sending);
  uint16_t readyMode(const Aircraft& aircraft) const;
  Status confirm(Firmware firmware);
  void setState(State state) { state_ = state; }
  void setStep(StartStep step) { step_ = static_cast<uint8_t>(step); }
  void setArming(StartArming arming) { arming_ = static_cast<uint8_t>(arming); }

  // What the code asks for most often comes first, where avr-gcc reaches it cheaply in the client.
  uint8_t looked_ : 7;     // how many items were looked at on the way to the one that will be flown
  uint8_t wasFlying_ : 1;  // its mission, before start()
  State state_;
  uint8_t step_ : 3;         // StartStep
  uint8_t isSent_ : 1;       // the order of order_ has left
  uint8_t isArmedSeen_ : 1;  // a heartbeat has shown it armed
  uint8_t arming_ : 2;       // StartArming
  uint8_t isDoubted_ : 1;    // the last MISSION_CURRENT was about another plan
  uint16_t first_;           // the item to begin with
  uint16_t next_;            // the item to look at, and then the one that will be flown first; kNoItem: not known
  uint16_t seen_;            // the autopilot's current item; kNoItem: not reported yet
  ModeOrder order_;          // the mode in which the aircraft is to be: any other one was set by somebody else
  union {
    uint16_t jump_;    // Looking, Judging, JudgingNext: the last jump followed
    uint16_t beganS_;  // AutoMode: when AUTO was first requested [s]
    Status refusal_;   // Leaving, Disarming, Restoring, Yielding: the status with which it will end
  };
};

}  // namespace detail
}  // namespace mavmission
