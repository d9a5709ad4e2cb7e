// The class that a sketch uses: one autopilot on one Stream.
#pragma once

#include <stdint.h>

#include "ItemSource.h"
#include "Link.h"
#include "OpaqueId.h"
#include "Status.h"
#include "UploadTransfer.h"
#include "WirePlan.h"

namespace mavmission {

// Called from update() when an item more is aboard: `done` of `total`, in the sketch's items. Never goes back within a
// transfer; reaches `total` only when the autopilot has accepted the plan. May call cancel().
typedef void (*ProgressFunction)(void* context, uint16_t done, uint16_t total);

// Called from update() when an operation has ended, with its status. May start the next operation.
typedef void (*EndFunction)(void* context, Status status);

// Speaks the mission protocol with one autopilot, without ever blocking: call update() from loop(), as often as can be.
// At 57600 baud a Mega's receive ring is full after 11 ms: a loop that takes longer loses bytes, and so time, but
// nothing else. Uses no heap. The Stream must be open, and stay, as long as this.
class MissionClient {
 public:
  // What failedItem() is when no item failed.
  static constexpr uint16_t kNoItem = 0xFFFF;
  // The most items that the protocol can count; home is one of them on ArduPilot.
  static constexpr uint16_t kMaxItems = 0xFFFF;
  // How long an earlier transfer may still be answered [ms]: ArduPilot gives one up after 8 s.
  static constexpr uint16_t kLeftoversMs = 10000;

  explicit MissionClient(Stream& stream);

  // --- Operations: one at a time; a second one is refused with Status::Busy, and the running one goes on unharmed.

  // Puts a plan aboard, in the place of what is there. Waits for the autopilot, checks the plan, then transfers. Returns
  // the status that it begins with, or Status::Busy. How it ends is what update() returns. The source must stay until
  // then. (MAVLink guide, Mission Protocol, "Upload a Mission to the Vehicle".)
  Status upload(const ItemSource& plan);

  // Ends the running operation with Status::Cancelled, and tells the autopilot (MISSION_ACK with
  // MAV_MISSION_OPERATION_CANCELLED). Without one it does nothing.
  void cancel();

  // To be called from loop(). Reads what has come, sends what is due and fits, returns. Returns how an operation has
  // ended, once; otherwise how the running one stands, or Status::Idle. Neither waits nor delays.
  Status update();

  // --- What is going on

  Status status() const { return state_.status; }  // of the running operation, or the last one
  bool isBusy() const { return state_.operation != nullptr; }
  // The item that the status is about, counted as the sketch counts, or kNoItem. ArduPilot's home is no item.
  uint16_t failedItem() const { return state_.failedItem; }
  uint16_t itemsDone() const { return state_.itemsDone; }    // of the running or last transfer
  uint16_t itemsTotal() const { return state_.itemsTotal; }
  // The plan that the autopilot holds after the last upload.
  Aboard aboard() const { return state_.aboard; }
  // The autopilot's last MISSION_ACK.type in this operation, or 255: what lies behind Status::Unconfirmed and
  // Status::UnknownResult.
  uint8_t lastResult() const { return state_.lastResult; }

  bool hasAutopilot() const { return link_.finder().isFound(); }
  Firmware firmware() const { return link_.finder().firmware(); }
  uint8_t autopilotSystemId() const { return link_.finder().heartbeat().systemId; }
  uint8_t autopilotComponentId() const { return link_.finder().heartbeat().componentId; }
  bool isArmed() const { return hasAutopilot() && link_.finder().isArmed(); }
  LinkCounters counters() const { return link_.counters(); }

  // --- Callbacks; null, the default, is none. `context` is handed to the function and may be null.

  void onProgress(ProgressFunction function, void* context = nullptr);
  void onEnd(EndFunction function, void* context = nullptr);

  // --- Settings, to be made while no operation runs

  // Our system id (1 to 255) and component id. By default those of a companion of the autopilot: its system id, 191.
  // When they are set, heartbeats go out at once; by default not before an autopilot has been heard. Must not be the
  // autopilot's own pair, which would not hear us.
  void setOwnIds(uint8_t systemId, uint8_t componentId = Link::kComponentId);
  // The autopilot to talk to, where there may be several on the line. System id 0: whichever is alone there.
  void talkTo(uint8_t systemId, uint8_t componentId = 1);
  // MAVLink 1 or 2; by default what the autopilot speaks.
  void setSpeak(Speak speak) { link_.setSpeak(speak); }
  // Allows operations that change the plan while the autopilot is armed. ArduPilot edits its plan in place: an upload
  // that breaks off leaves a flying aircraft with a mixture.
  void allowWhileArmed(bool allow) { state_.armedAllowed = allow; }
  // Item numbers and jump targets as the autopilot has them: on ArduPilot item 0 is home, and is given by the plan.
  void useRawNumbering(bool raw) { state_.raw = raw; }
  // When another ground station is transferring (MISSION_ACK denied, or PX4's error for busy), tries again after 1, 2, 4,
  // then each 8 s, for at most `seconds` after the first refusal; then it ends with the refusal. 0: no retry. Until then
  // the status is WaitingForTurn. Costs 150 bytes of flash in a sketch that calls it.
  void retryWhenDenied(uint16_t seconds);
  // Serves autopilots that do not know MISSION_ITEM_INT: one that is neither ArduPilot nor PX4 and refuses the first
  // item as unsupported gets the plan again as MISSION_ITEM, with coordinates as floats, coarser by metres. `always`: no
  // other is tried. Costs 450 bytes of flash in a sketch that calls it.
  void serveFloatItems(bool always = false);
  // The longest wait for an autopilot [s], after which an operation ends with Status::NoAutopilot; 0, the default, is
  // for ever.
  void limitWaiting(uint16_t seconds) { state_.waitingLimitS = seconds; }
  // The longest that a transfer may take [s], after which it ends with Status::TookTooLong; 0, the default, is
  // 120 s and 2 s for each item.
  void limitTransfer(uint16_t seconds) { state_.transferLimitS = seconds; }

 private:
  // An operation's share of update(): a frame of the autopilot's, or null for time to pass.
  typedef void (*Operation)(MissionClient& client, const FrameParser* frame, uint16_t nowMs);

  static bool waitForTurn(MissionClient& client, Status refusal);
  static void turnStep(MissionClient& client, const FrameParser* frame, uint16_t nowMs);
  static void uploadStep(MissionClient& client, const FrameParser* frame, uint16_t nowMs);
  Status updateAt(uint16_t nowMs);
  Status startOperation(Operation operation);
  void beginSeconds(uint16_t nowMs);
  void unsettle(uint16_t nowMs);
  void waitForAutopilot();
  void beginChecking();
  MAVMISSION_APART void checkPlan(uint16_t nowMs);
  void beginUpload(uint16_t nowMs);
  void takeUploadFrame(const FrameParser& frame, uint16_t nowMs);
  void sendUpload(uint16_t nowMs);
  Status checkItem(uint16_t wireItem);
  void sendCount(uint16_t items);
  bool sendItem(uint16_t nowMs);
  Status proven(Status status, uint32_t opaqueId) const;
  void continueUpload(Status status, uint16_t nowMs);
  Aboard aboardAfterUpload(Status status) const;
  MAVMISSION_APART uint16_t ownItem(uint16_t wireItem) const;
  void report(uint16_t done);
  void end(Status status);
  void sendCancelled();

  // All zero at the start but for what the constructor sets.
  struct State {
    Operation operation;       // null: idle
    ProgressFunction progress;
    void* progressContext;
    EndFunction ended;
    void* endedContext;
    uint16_t secondMs;         // when the last whole second of `seconds` was over
    uint16_t seconds;          // that the operation, or its transfer, has taken [s]
    uint16_t unsettledMs;      // when a transfer was last left without an answer
    uint16_t next;             // the wire item to be checked, or to be added to opaqueId_
    uint16_t failedItem;
    uint16_t itemsDone;
    uint16_t itemsTotal;
    uint16_t waitingLimitS;
    uint16_t transferLimitS;
    uint16_t turnLimitS;       // how long to wait for another ground station's transfer [s]
    uint16_t turnAtS;          // when to try again, and when the transfer's own time began [s]
    bool (*denied)(MissionClient& client, Status refusal);  // takes a refusal up, where the sketch wants that
    uint8_t turnPauseS;        // the pause before the next try; 0 before the first
    Status status;
    Status toReturn;
    Aboard aboard;
    uint8_t lastResult;
    bool unsettled;            // so after a reset: what ran before it may still be answered
    bool cancelDue;            // the autopilot is to be told that a transfer was cancelled
    bool armedAllowed;
    bool raw;
    bool floatItems;           // items go out as MISSION_ITEM
    void (*toFloats)(void* itemMessage);  // makes MISSION_ITEM of MISSION_ITEM_INT, where the sketch wants that
  };

  State state_;
  UploadTransfer transfer_;
  WirePlan plan_;
  OpaqueId opaqueId_;
  Link link_;
};

}  // namespace mavmission
