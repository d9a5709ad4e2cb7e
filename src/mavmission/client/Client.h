// Behind a MissionClient: the running operation, its state, and what its files (client/*.cpp) share.
#pragma once

#include <stdint.h>

#include "../FlightCommand.h"
#include "../FlightMode.h"
#include "../ItemSink.h"
#include "../ItemSource.h"
#include "../Operations.h"
#include "../PlanType.h"
#include "../Status.h"
#include "../link/Link.h"
#include "../plan/Comparison.h"
#include "../plan/WirePlan.h"
#include "../transfer/CommandTransfer.h"
#include "../transfer/DownloadTransfer.h"
#include "../transfer/OpaqueId.h"
#include "../transfer/UploadTransfer.h"

namespace mavmission {
namespace detail {

// A class with nothing hidden: only the library sees it. MissionClient shows a sketch what it may call.
class Client {
 public:
  // What failedItem() is when no item failed.
  static constexpr uint16_t kNoItem = 0xFFFF;
  // The most items that MISSION_COUNT can say.
  static constexpr uint16_t kMaxItems = 0xFFFF;

  MAVMISSION_APART explicit Client(Stream& stream);
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  Status status() const { return state_.status; }
  Aboard aboard(PlanType type = PlanType::Mission) const { return rest_.aboard[static_cast<uint8_t>(type) & 3]; }
  uint16_t itemsTotal() const { return rest_.itemsTotal; }
  bool isBusy() const { return state_.operation != nullptr; }
  bool hasAutopilot() const { return link_.finder().isFound(); }
  Firmware firmware() const { return link_.finder().firmware(); }
  bool isArmed() const { return hasAutopilot() && link_.finder().isArmed(); }
  uint32_t customMode() const { return link_.finder().heartbeat().customMode; }

  // Seconds, heartbeats and the autopilot's silence are looked at once in that time [ms], and not in each update().
  static constexpr uint8_t kTickMs = 2;
  // The most for a whole operation by default [s]: 2 minutes, and 2 s an item.
  static uint16_t defaultLimitS(uint16_t count) { return count < 32000 ? 120 + 2 * count : 0xFFFF; }
  // What a frame for us takes, in bytes that could be looked at in that time [bytes].
  static constexpr uint8_t kFrameBytes = 16;
  // How long an earlier transfer may still be answered [ms]: ArduPilot gives one up after 8 s.
  static constexpr uint16_t kLeftoversMs = 10000;
  // Bytes of a frame that are written in any case [bytes].
  static constexpr uint8_t kStartBytes = 8;

  // An operation's share of update(): a frame of the autopilot's, or null for time to pass.
  typedef void (*Operation)(Client& client, const FrameParser* frame, uint16_t nowMs);

  static bool takeUpEnd(Client& client, Status status, uint16_t nowMs);
  static bool tryFloats(Client& client, Status refusal, uint16_t nowMs);
  static bool waitForTurn(Client& client, Status refusal);
  static void turnStep(Client& client, const FrameParser* frame, uint16_t nowMs);
  MAVMISSION_ONE_EXIT static void uploadStep(Client& client, const FrameParser* frame, uint16_t nowMs);
  static void readStep(Client& client, const FrameParser* frame, uint16_t nowMs);
  static void clearStep(Client& client, const FrameParser* frame, uint16_t nowMs);
  static Status compareItem(Client& client, uint16_t wireItem, MissionItem& item);
  static void fromFloats(void* itemMessage);
  static Status storeItem(Client& client, uint16_t wireItem, MissionItem& item);
  void takeReadFrame(const FrameParser& frame, uint16_t nowMs);
  void takeReadCount(const FrameParser& frame);
  void takeReadItem(const FrameParser& frame, uint16_t nowMs);
  void sendRead(uint16_t nowMs);
  void endReading(Status status);
  Status startUpload(const ItemSource& plan, PlanType type);  // the autopilot's answer alone
  Status uploadKeptPlan();                                    // of the last upload or verification
  Status uploadProven(const ItemSource& plan, PlanType type, Readback proof);
  static void proveUpload(Client& client, uint16_t nowMs);
  static void proveFence(Client& client, uint16_t nowMs);
  static void proveFenceAgain(Client& client, uint16_t nowMs);
  static void fenceSettleStep(Client& client, const FrameParser* frame, uint16_t nowMs);
  static void fenceSettleAgainStep(Client& client, const FrameParser* frame, uint16_t nowMs);
  static void fenceStep(Client& client, const FrameParser* frame, uint16_t nowMs);
  bool isTypeCarried() const;
  static void commandStep(Client& client, const FrameParser* frame, uint16_t nowMs);
  // What an operation made of commands is told, with the status that it leads to if the operation does nothing about
  // it.
  enum class CommandEvent : uint8_t {
    Ready,      // the autopilot is there, nothing has been sent: Transferring, or Checking to be asked again
    Accepted,   // Done
    Refused,    // why
    Silent,     // NoAnswer, Unconfirmed, TookTooLong
    Heartbeat,  // Transferring, as the rest
    Current,    // a MISSION_CURRENT
    Time,
  };
  // Takes an event: Transferring to go on, or how the operation ends. `frame`: of a message, else null.
  typedef Status (*OnCommand)(Client& client, CommandEvent event, Status status, const FrameParser* frame,
                              uint16_t nowMs);
  typedef void (*FillCommand)(Client& client, FlightCommand& command);
  static void fillOwn(Client& client, FlightCommand& command);
  static void fillArm(Client& client, FlightCommand& command);
  static void fillDisarm(Client& client, FlightCommand& command);
  static void fillMode(Client& client, FlightCommand& command);
  static void fillBegin(Client& client, FlightCommand& command);
  static void fillStart(Client& client, FlightCommand& command);
  static void fillFirst(Client& client, FlightCommand& command);
  static void fillAskCurrent(Client& client, FlightCommand& command);
  static void fillCurrent(Client& client, FlightCommand& command);
  static void fillCurrentMessage(Client& client, FlightCommand& command);
  static void fillInterval(Client& client, FlightCommand& command);
  static Status onOwn(Client&, CommandEvent, Status, const FrameParser*, uint16_t);
  static Status onMode(Client&, CommandEvent, Status, const FrameParser*, uint16_t);
  static Status onCustomMode(Client&, CommandEvent, Status, const FrameParser*, uint16_t);
  static Status onNamedMode(Client&, CommandEvent, Status, const FrameParser*, uint16_t);
  static Status onStartMission(Client&, CommandEvent, Status, const FrameParser*, uint16_t);
  static Status onSetCurrent(Client&, CommandEvent, Status, const FrameParser*, uint16_t);
  static Status onStart(Client&, CommandEvent, Status, const FrameParser*, uint16_t);
  struct Commanding;
  Status beginCommand(FillCommand fill, OnCommand on);
  MAVMISSION_APART void nextCommand(FillCommand fill, uint16_t nowMs);
  void takeCommandFrame(const FrameParser& frame, uint16_t nowMs);
  void sendCommand(uint16_t nowMs);
  void takeCommandEvent(CommandEvent event, Status status, const FrameParser* frame, uint16_t nowMs);
  bool hasItem(uint16_t item);
  uint16_t numberOf(FlightMode mode) const;
  MAVMISSION_APART uint16_t shownMode() const;  // by the last heartbeat, as modeNumber() says it
  StartStep startStep() const { return static_cast<StartStep>(rest_.startStep); }
  StartArming startArming() const { return static_cast<StartArming>(rest_.startArming); }
  void setStartStep(StartStep step) { rest_.startStep = static_cast<uint8_t>(step); }
  void setStartArming(StartArming arming) { rest_.startArming = static_cast<uint8_t>(arming); }
  Status readyToStart(uint16_t nowMs);
  MAVMISSION_APART uint16_t firstItem() const;
  void lookFromFirst();
  Status lookAtItem();
  Status nextStartStep(uint16_t nowMs);
  bool beginStartStep(uint16_t nowMs);
  Status onStartRefused(Status status, uint16_t nowMs);
  Status onStartSilent(Status status, uint16_t nowMs);
  Status onStartHeartbeat(uint16_t nowMs);
  Status onStartCurrent(const FrameParser& frame, uint16_t nowMs);
  bool isArmingStep() const;
  MAVMISSION_APART Status leaveStart(Status status, uint16_t nowMs);
  Status otherItem();
  Status confirmStart();
  Status judgeStart();
  Status updateAt(uint16_t nowMs);
  // Takes the time of this update() for heavy work. False when bytes have taken it: the work then waits for the next
  // one, which looks at half as many.
  MAVMISSION_APART bool claimHeavyWork();
  MAVMISSION_APART void onTick(uint16_t nowMs);
  MAVMISSION_APART Status startOperation(Operation operation);
  void beginSeconds(uint16_t nowMs);
  void unsettle(uint16_t nowMs);
  void tellCancelled();
  void setAboard(Aboard what) { setAboard(state_.type, what); }
  void setAboard(PlanType type, Aboard what) { rest_.aboard[static_cast<uint8_t>(type) & 3] = what; }
  MAVMISSION_APART Aboard aboardAfterUpload(Status status) const;
  void waitForAutopilot();
  MAVMISSION_APART void beginPlan();
  MAVMISSION_APART Status keeping(const MissionItem& item);
  void beginChecking();
  void checkPlan(uint16_t nowMs);
  MAVMISSION_ONE_EXIT void beginUpload(uint16_t nowMs);
  void takeUploadFrame(const FrameParser& frame, uint16_t nowMs);
  void sendUpload(uint16_t nowMs);
  MAVMISSION_APART void sendAnnouncement();
  MAVMISSION_APART Status checkItem(uint16_t wireItem);
  void sendCount(uint16_t items);
  bool isPrepared(uint16_t wireItem) const { return link_.isPrepared() && state_.prepared == wireItem; }
  MAVMISSION_APART void prepareItem(uint16_t wireItem, uint16_t nowMs);
  Status proven(uint32_t opaqueId);
  MAVMISSION_ONE_EXIT void continueUpload(Status status, uint16_t nowMs);
  MAVMISSION_APART uint16_t ownItem(uint16_t wireItem) const;
  void report(uint16_t done);
  void end(Status status);
  void sendRequestList();
  void sendRequest(uint16_t wireItem);
  void sendAck(uint8_t result, PlanType type);
  void endClearing(Status status);
  uint8_t homeBefore() const;
  static Status announcePart(Client& client, bool isBeginning);
  // Items on the wire before the sketch's first.
  uint8_t homeItems() const { return has(firmware(), kHomeIsItem0) && !rest_.raw ? 1 : 0; }
  uint16_t itemFromWire(uint16_t wireItem) const;
  void noteInfeasible();
  void noteAccepted();
  void setPlan(const ItemSource& plan, PlanType type);
  MAVMISSION_APART Status refuseType();
  uint32_t acceptedPlanId() const { return rest_.planId; }

  // What an update() looks at lies first: avr-gcc reaches 64 bytes of an object cheaply. All zero at the start but for
  // what the constructor sets.
  struct State {
    Operation operation;   // null: idle
    uint16_t secondMs;     // when the last whole second of `seconds` was over
    uint16_t seconds;      // that the operation, or its transfer, has taken [s]
    uint16_t unsettledMs;  // when a transfer was last left without an answer, or a reading ended
    uint16_t next;         // the wire item to be checked, or to be added to opaqueId_
    uint16_t prepared;     // the wire item that the link holds ready, if it holds one
    uint16_t itemsDone;
    uint16_t failedItem;
    uint16_t turnAtS;  // when to try again, and when the transfer's own time began [s]
    // Begins a partial upload, and announces it; null: all of it, by MISSION_COUNT.
    Status (*announce)(Client& client, bool isBeginning);
    Status status;
    uint8_t unsettled;     // UploadTransfer::kAnswers, so after a reset, and kBusy
    PlanType cancelled;    // of the transfer that the autopilot is to be told was cancelled; All: there is none
    PlanType type;         // of the running operation
    bool floatItems;       // items go out as MISSION_ITEM
    bool isLate;           // the operation has taken all the time that it may
    uint8_t bytesAllowed;  // to be looked at in an update()
    uint8_t bytesLeft;     // that this one might look at still; 0 before it has looked
    uint8_t tick;          // when onTick() was called last [kTickMs], its low 8 bits
    void (*toFloats)(void* itemMessage);  // makes MISSION_ITEM of MISSION_ITEM_INT, where the sketch wants that
  };

  // Settings and results.
  struct Rest {
    void (*prove)(Client& client, uint16_t nowMs);                  // where the sketch wants a proof
    bool (*takeUp)(Client& client, Status status, uint16_t nowMs);  // null until one of these is set
    bool (*denied)(Client& client, Status refusal);                 // takes a refusal up, where the sketch wants that
    bool (*unsupported)(Client& client, Status refusal, uint16_t nowMs);  // the same, of an item
    ProgressFunction progress;
    void* progressContext;
    EndFunction ended;
    void* endedContext;
    uint16_t itemsTotal;
    uint16_t waitingLimitS;
    uint16_t transferLimitS;
    uint16_t turnLimitS;  // how long to wait for another ground station's transfer [s]
    uint16_t partFirst;   // the items of a partial upload, as the sketch counts
    uint16_t partCount;
    uint8_t turnPauseS;  // the pause before the next try; 0 before the first
    Status toReturn;
    Aboard aboard[4];  // by PlanType; the last is nobody's
    uint8_t lastResult;
    PlanType planType;        // of the plan that uploadAgain() takes; All before there is one
    uint32_t planId;          // the autopilot's own name for the mission that was accepted or verified last; 0: none
    uint8_t startStep : 4;    // StartStep
    uint8_t startArming : 4;  // StartArming
    Readback proof;
    ItemField field;        // that differs
    bool armedAllowed : 1;  // bits, for RAM: they cost a little flash
    bool raw : 1;
    bool tooLong : 1;       // the source has more items than the protocol can count
    bool infeasible : 1;    // the autopilot has said so of the plan that it accepted
    bool proving : 1;       // an upload is being read back
    bool isCommanding : 1;  // the running or last operation is a command: commanding_ is in use
    bool mayBeRefused : 1;  // because of an error that may have been a refusal
  };

  // Reading a plan: by download(), verify(), or to prove an upload.
  struct Reading {
    DownloadTransfer transfer;
    // Takes an item: Transferring, Checking (not yet: ask for it again), or why the operation ends.
    Status (*take)(Client& client, uint16_t wireItem, MissionItem& item);
    // MISSION_ITEM to MISSION_ITEM_INT, where a sketch reads plans.
    void (*fromFloats)(void* itemMessage);
    ItemSink sink;
    bool isCompared;  // or stored
    uint32_t planId;  // MISSION_COUNT.opaque_id
  };

  // Clearing a plan.
  struct Clearing {
    uint16_t sentMs;
    uint8_t tries;
    bool isDue;
    PlanType type;  // that is being cleared now
    PlanType last;  // after which it ends
  };

  // What start() keeps in mind. Items are the wire's.
  struct Start {
    // Looking: for the item that will be flown first. Shown: a heartbeat shows that it flies. Judging: is it at the
    // right item, or at the next one? Leaving: it cannot be flown, and a heartbeat is to say what there is to disarm.
    enum class Phase : uint8_t { New, Looking, Steps, Shown, Judging, JudgingNext, Leaving, Disarming };

    uint16_t first;      // that it is to begin with
    uint16_t seen;       // that the autopilot is at, kNoItem before it has said
    uint16_t mode;       // in which the aircraft was behind ReadyMode: another one, but for AUTO, is somebody else's
    uint16_t jump;       // the last one that was followed on the way to the item that will be flown
    uint8_t looked : 7;  // items on that way
    uint8_t isAutoSeen : 1;  // a heartbeat has shown the mission mode that was asked for
    uint8_t beganS;          // when AUTO was asked for first [s], its low 8 bits
    Status refusal;          // why it cannot be flown: how it will end
    Phase phase;
  };

  // SET_MESSAGE_INTERVAL.
  struct Interval {
    int32_t us;
    uint16_t message;
  };

  // A command, or several.
  struct Commanding {
    FillCommand fill;  // what is to be sent
    OnCommand on;      // what comes of it; null: what the answer says
    CommandTransfer transfer;
    uint16_t mode;  // that is to be set
    union {
      const FlightCommand* own;
      FlightMode named;
      bool isLargeMode;  // a custom mode beyond one byte
      uint16_t item;     // to be set as current, on the wire
      Interval interval;
      Start start;
    };
  };

  State state_;
  union {  // one operation at a time
    UploadTransfer transfer_;
    Reading reading_;
    Clearing clearing_;
    Commanding commanding_;
  };
  WirePlan plan_;  // here, and not behind rest_, within cheap reach
  Rest rest_;
  OpaqueId opaqueId_;
  Link link_;
};

}  // namespace detail
}  // namespace mavmission
