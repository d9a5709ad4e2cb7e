// The inside of MissionClient: the running operation and its state, shared by the files client/*.cpp.
#pragma once

#include <stdint.h>

#include "../autopilot/FlightCommand.h"
#include "../autopilot/FlightMode.h"
#include "../base/RetryRules.h"
#include "../base/Status.h"
#include "../item/PlanType.h"
#include "../link/Link.h"
#include "../plan/Areas.h"
#include "../plan/Comparison.h"
#include "../plan/ItemSink.h"
#include "../plan/ItemSource.h"
#include "../plan/WirePlan.h"
#include "../transfer/ClearTransfer.h"
#include "../transfer/CommandLog.h"
#include "../transfer/CommandTransfer.h"
#include "../transfer/DownloadTransfer.h"
#include "../transfer/ModeOrder.h"
#include "../transfer/OpaqueId.h"
#include "../transfer/Operations.h"
#include "../transfer/StartTransfer.h"
#include "../transfer/UploadTransfer.h"
#include "CommandPort.h"
#include "Operation.h"
#include "PlanPort.h"
#include "Port.h"

namespace mavmission {

class PlanFiles;

namespace detail {

enum class KeyIndex : uint8_t;

// What the sketch has chosen for its uploads. Each is null until the sketch calls the function for it, and only that
// function refers to the code: what a sketch does not call is not linked.
struct Options {
  // Begins the read-back.
  void (*readBack)(Client& client, uint16_t nowMs);
  // Continues after the end of an upload, by the options here: true if the operation goes on. Null while none is
  // chosen.
  bool (*continueAfter)(Client& client, Status status, uint16_t nowMs);
  // Begins the back-off after a refusal: true if there is time for it.
  bool (*backOff)(Client& client, Status refusal);
  // Looks first at how an upload has ended, for a back-off or for the MISSION_ITEM fallback, which looks for a back-off
  // too: true if it goes on. (One function, since one test costs an upload that has neither less than two.)
  bool (*goOn)(Client& client, Status status, uint16_t nowMs);
  // Makes a MISSION_ITEM of a MISSION_ITEM_INT.
  void (*toFloats)(void* itemMessage);
};

// Services see its ports alone, and MissionClient shows a sketch what it may call.
class Client : public Port, public CommandPort, public PlanPort, public ClientRules {
 private:
  friend class Port;
  friend class CommandPort;
  friend class mavmission::MissionClient;
  friend class PlanPort;

  // The greatest number of items in MISSION_COUNT.
  static constexpr uint16_t kMaxItems = 0xFFFF;

  MAVMISSION_APART explicit Client(Stream& stream);
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  Status status() const { return state_.status; }
  Aboard aboard(PlanType type = PlanType::Mission) const { return known_.aboard[static_cast<uint8_t>(type) & 3]; }
  uint16_t itemsTotal() const { return state_.itemsTotal; }
  bool isBusy() const { return state_.operation != nullptr; }
  bool hasAutopilot() const { return link_.finder().isFound(); }
  Firmware firmware() const { return link_.finder().firmware(); }
  bool isArmed() const { return link_.finder().isArmed(); }
  uint32_t customMode() const { return link_.finder().heartbeat().customMode; }

  // The time that a frame for us takes, as a number of bytes that could be read in that time [bytes].
  static constexpr uint8_t kFrameBytes = 20;

  // As PlanPort::isShortFence() says [items].
  static constexpr uint8_t kShortFence = 3;

  static void fromFloats(void* itemMessage);
  bool isOurCount(uint16_t count) const;
  Status compareCount(uint16_t count);
  bool hasRoom(uint16_t count);
  Status startUpload(const ItemSource& plan, PlanType type);  // the autopilot's answer alone
  Status uploadKeptPlan();                                    // of the last upload or verification
  Status uploadProven(const ItemSource& plan, PlanType type, Readback proof);
  Status ensurePlan(const ItemSource& plan, PlanType type, Readback proof);
  void beginEnsuring();
  struct Commanding;
  Status beginCommand(FillCommand fill, OnCommand on);
  MAVMISSION_APART void nextCommand(FillCommand fill);
  bool hasItem(uint16_t item);
  uint8_t vehicleType() const { return link_.finder().vehicleType(); }
  bool isVehicleAsked() const;
  StartStep startStep() const { return static_cast<StartStep>(session_.startStep); }
  StartArming startArming() const { return static_cast<StartArming>(session_.startArming); }
  Status updateAt(uint32_t exactMs);
  MAVMISSION_APART void forgetAutopilot();
  MAVMISSION_APART MAVMISSION_ONE_EXIT void onTick(uint16_t nowMs);
  MAVMISSION_APART Status startOperation(Step operation);
  // The transfer is left open.
  void unsettle() { expectAnswers(kFromOpen | kFromBusy | kFromBefore | kOfRepeats); }
  void settle() { state_.unsettled &= static_cast<uint8_t>(~(kFromOpen | kFromBusy)); }
  // To be called when a message of the mission protocol has been sent, with how often it has been sent by now. Each may
  // be answered, and an operation waits for one answer: the others come late.
  void noteSent(uint8_t tries) {
    if (tries > 1) state_.unsettled |= kOfRepeats;
  }
  MAVMISSION_APART void expectAnswers(uint8_t what);
  // True while the next operation must not begin.
  bool awaitsCopies();
  // What may still be answered, beside UploadEvidence's kFromOpen, kFromBusy and kFromBefore: repeats of ours. They are
  // counted down, and so forgotten after 2 to 3 s.
  static constexpr uint8_t kOneSecond = 64, kOfRepeats = 3 * kOneSecond;
  void tellCancelled() { tellCancelled(state_.type); }
  void tellCancelled(PlanType type);
  void setAboard(Aboard what) { setAboard(state_.type, what); }
  void setAboard(PlanType type, Aboard what) { known_.aboard[static_cast<uint8_t>(type) & 3] = what; }
  // True if the mission that aboard() is about is plan_: a plan that was refused is not.
  bool isMissionInPlan() const { return session_.planType == PlanType::Mission && isOfPlan(); }
  bool isOfPlan() const { return known_.aboard[kOfPlan] != Aboard::NotKnown; }
  void setOfPlan(bool isOf) { known_.aboard[kOfPlan] = isOf ? Aboard::OurPlan : Aboard::NotKnown; }
  MAVMISSION_APART void beginPlan();
  MAVMISSION_APART Status keeping(const MissionItem& item);
  MAVMISSION_APART MAVMISSION_ONE_EXIT Status checkItem(uint16_t wireItem);
  bool isPrepared(uint16_t wireItem) const { return link_.isPrepared() && session_.prepared == wireItem; }
  uint16_t ownItem(uint16_t wireItem) const { return plan_.numbers().toOwn(wireItem); }
  MAVMISSION_ONE_EXIT void report(uint16_t done);
  // Ends an operation that has just been begun. (Its end may have begun another one: status() is then about that.)
  Status refuse(Status why) {
    end(why);
    return why;
  }
  static void tellEnd(Client& client, Status status);
  static void tellLaterStep(Client& client, const FrameParser* frame, uint16_t nowMs);
  void cancelNow();
  static void doNothing(Client&) {}
  static void cancelAtEnd(Client& client);
  static void cancelSecond(Client& client);
  void sendAck(uint8_t result, PlanType type);
  MAVMISSION_APART void sendShort(KeyIndex message, uint16_t number, PlanType type);
  // Of the mission aboard, whatever plan_ is.
  ItemNumbers numbersAboard() const {
    ItemNumbers numbers;
    numbers.begin(firmware(), PlanType::Mission, session_.raw);
    return numbers;
  }
  void noteAccepted();
  void setPlan(const ItemSource& plan, PlanType type);
  void setPlanToVerify(const ItemSource& plan, PlanType type);
  MAVMISSION_APART Status refuseType();

  // The operations, and what goes with them: their functions are in the files of client/ that are named after them.
  struct Uploading;
  struct BackingOff;
  struct CheckingAreas;
  struct EnsuringAreas;
  struct ShortFence;
  struct ReadingPlan;
  struct Ensuring;
  struct Clearing;
  struct Command;
  struct OwnCommand;
  struct Arming;
  struct SettingMode;
  struct SettingCurrent;
  struct SettingInterval;
  struct AskingVehicle;
  struct BeginningMission;
  struct Starting;
  struct VerifiedStart;

  // The members that every update() uses lie first, since avr-gcc reaches 64 bytes of an object cheaply. All zero at
  // the start except for those that the constructor sets.
  struct State {
    Step operation;        // null: idle
    uint16_t secondMs;     // when `seconds` was last counted up
    uint16_t seconds;      // the time of the operation, or of its transfer [s]
    uint16_t unsettledMs;  // when the last transfer ended
    uint16_t next;         // the wire item to be checked, or to be added to opaqueId_; of commands: see firstMode()
    uint16_t itemsDone;
    uint16_t failedItem;
    uint16_t limitFromS;  // from when on the limit counts: in a back-off its end [s]
    uint16_t itemsTotal;
    uint8_t lastResult;
    Status status;
    PlanType type;  // of the running operation
    // Bits, for RAM, which cost a little flash.
    bool floatItems : 1;    // items go out as MISSION_ITEM
    bool isCompared : 1;    // of a plan that is read; false: it is stored
    bool proving : 1;       // an upload is being read back
    bool infeasible : 1;    // the autopilot has reported that it cannot fly the accepted plan
    bool mayBeRefused : 1;  // the read-back follows an error that may have been a refusal
    bool armedAllowed : 1;
    bool tooLong : 1;       // the source has more items than the protocol can count
    bool isCommanding : 1;  // the running or last operation is a command: commanding_ is in use
    bool isTelling : 1;     // onEnd()'s function runs
    bool isDoubtful : 1;    // another transfer of ours may be open: neither a refusal nor an acceptance tells what is
                            // aboard
    bool isLate : 1;        // the operation has reached its time limit
    bool readsHalf : 1;     // an update() reads half as many bytes as it may
    bool isTimeLeft : 1;    // this update() has read, and few bytes: there is time for heavy work
    bool isPlanless : 1;    // the running or last operation transfers no plan
    uint8_t cancelled;      // the plan type whose cancelling is still to be sent, plus 1; 0: none
    uint8_t unsettled;      // kFromOpen (also after a reset), kFromBusy, kFromBefore, kOfRepeats
    uint16_t tickMs;        // when onTick() was called last: within an update() this is now, to kTickMs
    // What a running update() does at its end: nothing, or the cancel() of a callback. Null while none runs.
    void (*atEnd)(Client& client);
  };

  // What lasts from one operation to the next: what the sketch has set, and results that it may ask for.
  struct Session {
    Options options;
    // Announces a part of the plan, and limits the upload to it; null: the whole plan, announced by MISSION_COUNT.
    void (*announcePart)(Client& client);
    ProgressFunction progress;
    void* progressContext;
    void (*tellEnd)(Client& client, Status status);  // calls `ended`; null: the sketch has none
    EndFunction ended;
    void* endedContext;
    uint16_t prepared;  // the wire item that the link holds packed, if it holds one
    uint16_t waitingLimitS;
    uint16_t transferLimitS;
    uint16_t backOffLimitS;  // the limit of all back-offs [s]
    uint8_t backOffPauseS;   // the pause before the next try; 0 before the first
    Status toReturn;
    PlanType planType;        // of the plan that uploadAgain() takes; All before there is one
    uint8_t startStep : 3;    // StartStep
    uint8_t startArming : 2;  // StartArming
    uint8_t proof : 2;        // Readback
    bool raw : 1;
    ItemField field;  // the one that differs, or is not kept
  };

  static constexpr uint8_t kOfPlan = 3;

  // What was learned of the autopilot, all of which forgetAutopilot() forgets.
  struct Known {
    // By PlanType. At kOfPlan: not NotKnown when the last upload or verification has sent something, so that the others
    // are about plan_, and not about a plan before it.
    Aboard aboard[4];
    uint32_t planId;  // the autopilot's name (opaque_id) of the mission accepted or verified last; 0: none
    CommandLog log;   // whose answers may still come
    Status takenBy;   // PilotHasIt, FailsafeHasIt: who has taken the aircraft from this sketch; Idle: nobody
  };

// The struct within the union is an extension that both compilers have; clang warns of it in spite of __extension__.
#ifdef __clang__
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wnested-anon-types"
#endif
  // Reading a plan: for download(), verify(), or the read-back after an upload.
  struct Reading {
    DownloadTransfer transfer;
    TakeItem take;
    PlanFiles* files;  // while the plan is transferred as a file
    union {
      ItemSink sink;    // of what is stored
      uint16_t summed;  // ensure(), before it looks: how many items are in the checksum
      __extension__ struct {
        uint32_t planId;    // MISSION_COUNT.opaque_id, where the plan is compared
        PlanFiles* prover;  // while an upload by file is read back item by item
      };
    };
  };

  // A mode to be set.
  struct Modes {
    uint16_t number;  // of modeNumber()
    ModeOrder order;
    FlightMode named;
    bool isLarge;  // a custom mode beyond one byte
  };

  // SET_MESSAGE_INTERVAL.
  struct Interval {
    int32_t us;
    uint16_t message;
  };

  // The state of an operation that consists of commands.
  struct Commanding {
    FillCommand fill;  // makes the command to be sent
    OnCommand on;      // takes the events; null: the answer decides
    CommandTransfer transfer;
    uint8_t modeFlags;  // MAV_MODE_FLAG that the last heartbeat before the operation has shown, or one since
    union {
      const FlightCommand* own;
      void* owner;  // the object of a service whose operation it is
      Modes mode;
      uint16_t item;  // to be set as current; a wire number
      Interval interval;
      StartTransfer start;
    };
  };

  State state_;
  WirePlan plan_;  // here avr-gcc reaches it cheaply
  union {          // one operation at a time
    __extension__ struct {
      union {
        Areas areas_;  // before the transfer, while the plan is checked
        UploadTransfer transfer_;
        Reading reading_;
      };
      OpaqueId opaqueId_;
      union {
        __extension__ struct {
          uint16_t partFirst_;  // the items of a partial upload, in the sketch's numbers
          uint16_t partCount_;
        };
        __extension__ struct {       // of verifyAndStart(), while it reads
          uint16_t startItem_;       // the item to begin with
          uint8_t modeFlagsBefore_;  // as Commanding::modeFlags
        };
      };
    };
    ClearTransfer clearing_;
    Commanding commanding_;
  };
#ifdef __clang__
#pragma clang diagnostic pop
#endif
  Session session_;
  Known known_;
  Link link_;
};

}  // namespace detail
}  // namespace mavmission
