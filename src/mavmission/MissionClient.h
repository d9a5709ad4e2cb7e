// The class that a sketch uses: one autopilot on one Stream.
#pragma once

#include <stdint.h>

#include "CommandTransfer.h"
#include "Comparison.h"
#include "DownloadTransfer.h"
#include "FlightCommand.h"
#include "FlightMode.h"
#include "ItemSink.h"
#include "ItemSource.h"
#include "Link.h"
#include "OpaqueId.h"
#include "PlanType.h"
#include "Status.h"
#include "TimestampStore.h"
#include "UploadTransfer.h"
#include "WirePlan.h"
#if MAVMISSION_SIGNING
#include "Signing.h"
#else
#include "SigningKey.h"
#endif

namespace mavmission {

// Called from update() when an item more is aboard: `done` of `total`, in the sketch's items. Never goes back within a
// transfer; reaches `total` only when the autopilot has accepted the plan. May call cancel().
typedef void (*ProgressFunction)(void* context, uint16_t done, uint16_t total);

// Called from update() when an operation has ended, with its status. May start the next operation.
typedef void (*EndFunction)(void* context, Status status);

// The steps of start(), in their order; a vehicle needs some of them.
enum class StartStep : uint8_t { None, ReadyMode, FirstItem, Arm, AutoMode, Begin, Confirm };

// What start() has done about the arming. Armed: it has armed the aircraft, and left it so. Disarmed: it has armed it,
// could not fly it, and it is disarmed again.
enum class StartArming : uint8_t { Untouched, Armed, Disarmed };

// When an upload is proven by reading the plan back.
enum class Proof : uint8_t { InDoubt = 1, Always };
constexpr Proof WhenInDoubt = Proof::InDoubt;  // what upload(plan) does
constexpr Proof Verified = Proof::Always;      // upload(plan, Verified)

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

  // Talks over this port, which the sketch opens.
  MAVMISSION_APART explicit MissionClient(Stream& stream);

  // --- Operations: one at a time; a second one is refused with Status::Busy, and the running one goes on unharmed.

  // Puts a plan aboard, in the place of what is there. Waits for the autopilot, checks the plan, then transfers.
  // Returns the status that it begins with, or Status::Busy. How it ends is what update() returns: Status::Accepted is
  // said exactly when the plan is aboard. Where the final answer is in doubt, what is aboard is read back and compared:
  // Status::Differs says that it is not the plan, and Status::Unconfirmed remains where it cannot be read either. With
  // Verified it is read back in any case. The source must stay until the end. (MAVLink guide, Mission Protocol, "Upload
  // a Mission to the Vehicle".)
  Status upload(const ItemSource& plan, Proof proof = WhenInDoubt) {
    return uploadProven(plan, PlanType::Mission, proof);
  }
  // The same for a fence or rally points. A fence of up to three items is always read back, 1 s after it was accepted,
  // and sent again if ArduPilot, which has accepted it, has wiped it by then.
  Status upload(const ItemSource& plan, PlanType type, Proof proof = WhenInDoubt);

  // The same without reading back, for a sketch that has to be small (README.md, "Sizes"). Status::Accepted is said
  // when the autopilot has acknowledged the whole plan, and on PX4 with our checksum; when ArduPilot's only answer is
  // lost, it is Status::Unconfirmed.
  Status uploadByAnswer(const ItemSource& plan, PlanType type = PlanType::Mission);

  // Puts the plan of the last upload or verification aboard again: after a failure that left a mixture, for example.
  // Status::SourceRefused if there was none.
  Status uploadAgain();

  // Puts `count` items of a plan aboard, from item `first` on, in the place of those that are there. `plan` is the
  // whole plan, and the rest of it must be aboard already. ArduPilot does this; PX4 does not (Status::WholePlansOnly).
  // (Guide, MISSION_WRITE_PARTIAL_LIST.)
  Status uploadPart(const ItemSource& plan, uint16_t first, uint16_t count);

  // Reads the autopilot's plan, item by item, into a sink, and ends with Status::Downloaded. What a sketch uploaded it
  // gets back: home is kept apart on ArduPilot, jump targets count the sketch's items. The sink must stay until the
  // end. (Guide, "Download a Mission from the Vehicle".)
  Status download(const ItemSink& sink, PlanType type = PlanType::Mission);

  // Reads the autopilot's plan and compares it with `plan` while it streams, holding neither in RAM. Ends with
  // Status::Verified, or with Status::Differs: failedItem() and differingField() say where first. The comparison knows
  // what each autopilot rewrites, and is no looser.
  Status verify(const ItemSource& plan, PlanType type = PlanType::Mission);

  // Takes the plan away, or with PlanType::All all three. Ends with Status::Cleared. (Guide, "Clear Missions".)
  Status clear(PlanType type = PlanType::Mission);

  // --- Flying. Each ends with Status::Done, or says how the autopilot refused (MAVLink guide, Command Protocol).
  // Nothing arms but arm() and start(), and arming is never forced.

  // Flies the plan that is aboard from this item on, by the sketch's numbers: does what this autopilot needs, in its
  // order, each step confirmed; startStep() says which one was refused. Done when the autopilot is armed, in its
  // mission mode, and at the first item that can be flown from there on (behind DO_ commands and jumps);
  // Status::OtherItem when it flies another one, Status::Unconfirmed when it does not say. Where it flies its mission
  // already, nothing is sent that would change that. Refused with Status::Unproven unless aboard() is our plan; with
  // Status::Armed while the autopilot is armed, unless that is allowed. The plan's source must still be there.
  //
  // What it has armed and then cannot fly it disarms, on the ground, never by force: the status stays the refusal, and
  // startArming() says so. Not when somebody else has set another mode meanwhile (Status::TakenOver), and not after
  // cancel(). A rover may be armed seconds before AUTO is to be had: there AUTO is tried for 15 s.
  Status start(uint16_t item = 0);

  // Arms or disarms, as the autopilot's own checks allow.
  Status arm();
  Status disarm();
  // The mode by its name, or by the autopilot's own number (HEARTBEAT.custom_mode). Done when a heartbeat shows the
  // mode; Status::Unconfirmed when it was accepted and no heartbeat shows it.
  Status setMode(FlightMode mode);
  Status setCustomMode(uint32_t customMode);
  // Sets an armed aircraft flying its mission, from its current item on; Status::NotArmed otherwise.
  Status startMission();
  // Goes on with this item, counted as the sketch counts: at once when the aircraft flies its mission.
  // Status::NoSuchItem for one that is not in the plan, where that is known; otherwise the autopilot refuses it.
  Status setCurrentItem(uint16_t item);
  // Stays where it is; goes on with the mission.
  Status pause() { return setMode(FlightMode::Hold); }
  Status resume() { return setMode(FlightMode::Auto); }
  // How often the autopilot sends a message [us between two]; 0 is its default, -1 never.
  Status setMessageInterval(uint16_t messageId, int32_t intervalUs);
  // Any command. It must stay until the end. Arming is not forced by it either, and PX4's MISSION_START, which arms, is
  // not sent by it to a disarmed one (Status::NotArmed): that is what start() is for.
  Status send(const FlightCommand& command, Repeat repeat = Repeat::IfHarmless);
  Status send(const FlightCommand&&, Repeat = Repeat::IfHarmless) = delete;  // it would be gone before it is sent

  // Ends the running operation with Status::Cancelled, and tells the autopilot (MISSION_ACK with
  // MAV_MISSION_OPERATION_CANCELLED). Without one it does nothing.
  void cancel();

  // To be called from loop(). Reads what has come, sends what is due and fits, returns. Returns how an operation has
  // ended, once; otherwise how the running one stands, or Status::Idle. Neither waits nor delays.
  Status update();

  // Sends a message of the sketch's own, with the right sequence number. False if another frame is still on its way, or
  // nothing may be sent yet (no autopilot heard, or several): call it again later. The payload must stay until
  // isSent().
  bool sendMessage(const OutgoingMessage& message) { return link_.sendForeign(message); }
  // True when every frame has been handed to the stream.
  bool isSent() const { return link_.isSent(); }

  // --- What is going on

  Status status() const { return state_.status; }  // of the running operation, or the last one
  // True while an operation runs.
  bool isBusy() const { return state_.operation != nullptr; }
  // The item that the status is about, counted as the sketch counts, or kNoItem. ArduPilot's home is no item.
  uint16_t failedItem() const { return state_.failedItem; }
  // Of the running or last transfer.
  uint16_t itemsDone() const { return state_.itemsDone; }
  uint16_t itemsTotal() const { return rest_.itemsTotal; }
  // What differs after Status::Differs, or after Status::NotKept would be kept as another value.
  Field differingField() const { return rest_.field; }
  // After Status::NotKept: what the autopilot would make of the value of that field. NaN where that is not known: where
  // it would not take it, or where what it makes of it depends on its board. The plan's source is asked for the item
  // again.
  float keptValue();
  // The plan of a type that the autopilot holds after the last upload, verification or clear of that type.
  Aboard aboard(PlanType type = PlanType::Mission) const { return rest_.aboard[static_cast<uint8_t>(type) & 3]; }
  // The autopilot's last MISSION_ACK.type in this operation, or 255: what lies behind Status::Unconfirmed and
  // Status::UnknownResult.
  uint8_t lastResult() const { return rest_.lastResult; }

  // The step of start() that runs, or that was refused.
  StartStep startStep() const { return static_cast<StartStep>(rest_.startStep); }
  StartArming startArming() const { return static_cast<StartArming>(rest_.startArming); }

  // The autopilot on the line, by its heartbeats.
  bool hasAutopilot() const { return link_.finder().isFound(); }
  Firmware firmware() const { return link_.finder().firmware(); }
  uint8_t autopilotSystemId() const { return link_.finder().heartbeat().systemId; }
  uint8_t autopilotComponentId() const { return link_.finder().heartbeat().componentId; }
  bool isArmed() const { return hasAutopilot() && link_.finder().isArmed(); }
  // The autopilot's own number of the mode that it is in (HEARTBEAT.custom_mode).
  uint32_t customMode() const { return link_.finder().heartbeat().customMode; }
  // By the autopilot's last heartbeat.
  bool isInMode(FlightMode mode) const;
  // What the line does well and badly.
  LinkCounters counters() const { return link_.counters(); }

  // --- Callbacks; null, the default, is none. `context` is handed to the function and may be null.

  // One function each; another call replaces it.
  void onProgress(ProgressFunction function, void* context = nullptr);
  void onEnd(EndFunction function, void* context = nullptr);

  // --- Settings, to be made while no operation runs

  // Our system id (1 to 255) and component id. By default those of a companion of the autopilot: its system id, 191.
  // When they are set, heartbeats go out at once; by default not before an autopilot has been heard. Must not be the
  // autopilot's own pair, which would not hear us.
  void setOwnIds(uint8_t systemId, uint8_t componentId = Link::kComponentId);
  // The autopilot to talk to, where there may be several on the line. System id 0: whichever is alone there.
  void talkTo(uint8_t systemId, uint8_t componentId = 1);
#if MAVMISSION_SIGNING
  // From now on signs what is sent, and refuses what is not signed with the key (MAVLink guide, Message Signing): such
  // a frame is as good as none. Only RADIO_STATUS, which a radio without a key sends, still reaches a MessageListener.
  // All frames are then MAVLink 2. `linkId`: of this link, the sketch's own choice; the same after each reset. `store`:
  // where the time of signatures outlives a reset (EepromTimestamps, or the sketch's own).
  void signWith(const SigningKey& key, uint8_t linkId, const TimestampStore& store) {
    link_.signWith(key, linkId, store);
  }
  // Tells the time, where the sketch has a clock or a GPS [s, Unix]. Without it the time is the autopilot's.
  void setSigningTime(uint32_t unixTimeS) { link_.setSigningTime(SigningTime::atUnixTime(unixTimeS)); }
  // What became of received frames since signWith().
  const SigningCounters& signingCounters() const { return link_.signing().counters(); }
#else
  template <typename... Arguments>
  void signWith(Arguments&&...) {
    static_assert(sizeof...(Arguments) == 255,
                  "signWith() is there if the library is compiled with -DMAVMISSION_SIGNING=1 (Config.h)");
  }
#endif
  // MAVLink 1 or 2; by default what the autopilot speaks.
  void setSpeak(Speak speak) { link_.setSpeak(speak); }
  // Allows operations that change the plan while the autopilot is armed. ArduPilot edits its plan in place: an upload
  // that breaks off leaves a flying aircraft with a mixture.
  void allowWhileArmed(bool allow) { rest_.armedAllowed = allow; }
  // Item numbers and jump targets as the autopilot has them: on ArduPilot item 0 is home, and is given by the plan.
  void useRawNumbering(bool raw) { rest_.raw = raw; }
  // When another ground station is transferring (MISSION_ACK denied, or PX4's error for busy), tries again after 1, 2,
  // 4, then each 8 s, for at most `seconds` after the first refusal; then it ends with the refusal. 0: no retry. Until
  // then the status is WaitingForTurn. Costs flash in a sketch that calls it (README.md, "Sizes").
  void retryWhenDenied(uint16_t seconds);
  // Serves autopilots that do not know MISSION_ITEM_INT: one that is neither ArduPilot nor PX4 and refuses the first
  // item as unsupported gets the plan again as MISSION_ITEM, with coordinates as floats, coarser by metres. `always`:
  // no other is tried. Costs flash in a sketch that calls it (README.md, "Sizes").
  void serveFloatItems(bool always = false);
  // The longest wait for an autopilot [s], after which an operation ends with Status::NoAutopilot; 0, the default, is
  // for ever.
  void limitWaiting(uint16_t seconds) { rest_.waitingLimitS = seconds; }
  // The longest that a transfer or a command may take [s], after which it ends with Status::TookTooLong; 0, the
  // default, is 120 s, and 2 s for each item.
  void limitTransfer(uint16_t seconds) { rest_.transferLimitS = seconds; }

 private:
  // Seconds, heartbeats and the autopilot's silence are looked at once in that time [ms], and not in each update().
  static constexpr uint8_t kTickMs = 2;
  // The most for a whole operation by default [s]: 2 minutes, and 2 s an item.
  static uint16_t defaultLimitS(uint16_t count) { return count < 32000 ? 120 + 2 * count : 0xFFFF; }
  // What a frame for us takes, in bytes that could be looked at in that time [bytes].
  static constexpr uint8_t kFrameBytes = 16;
  // In turnPauseS, which each operation sets anew: the running or last one is a command, which waits for no turn.
  static constexpr uint8_t kCommand = 255;
  // Bytes of a frame that are written in any case [bytes].
  static constexpr uint8_t kStartBytes = 8;

  friend class LinkDoctor;
  friend class Listener;
  friend class MessageIntervals;
  friend class MissionFollower;
  friend class QuietTransfers;

  // An operation's share of update(): a frame of the autopilot's, or null for time to pass.
  typedef void (*Operation)(MissionClient& client, const FrameParser* frame, uint16_t nowMs);

  static bool takeUpEnd(MissionClient& client, Status status, uint16_t nowMs);
  static bool tryFloats(MissionClient& client, Status refusal, uint16_t nowMs);
  static bool waitForTurn(MissionClient& client, Status refusal);
  static void turnStep(MissionClient& client, const FrameParser* frame, uint16_t nowMs);
  MAVMISSION_ONE_EXIT static void uploadStep(MissionClient& client, const FrameParser* frame, uint16_t nowMs);
  static void readStep(MissionClient& client, const FrameParser* frame, uint16_t nowMs);
  static void clearStep(MissionClient& client, const FrameParser* frame, uint16_t nowMs);
  static Status compareItem(MissionClient& client, uint16_t wireItem, MissionItem& item);
  static void fromFloats(void* itemMessage);
  static Status storeItem(MissionClient& client, uint16_t wireItem, MissionItem& item);
  Status beginReading(uint16_t nowMs);
  void takeReadFrame(const FrameParser& frame, uint16_t nowMs);
  void takeReadCount(const FrameParser& frame);
  void takeReadItem(const FrameParser& frame, uint16_t nowMs);
  void sendRead(uint16_t nowMs);
  void endReading(Status status);
  Status uploadProven(const ItemSource& plan, PlanType type, Proof proof);
  static void proveUpload(MissionClient& client, uint16_t nowMs);
  static void proveFence(MissionClient& client, uint16_t nowMs);
  static void proveFenceAgain(MissionClient& client, uint16_t nowMs);
  static void fenceSettleStep(MissionClient& client, const FrameParser* frame, uint16_t nowMs);
  static void fenceSettleAgainStep(MissionClient& client, const FrameParser* frame, uint16_t nowMs);
  static void fenceStep(MissionClient& client, const FrameParser* frame, uint16_t nowMs);
  bool isTypeCarried() const;
  static void commandStep(MissionClient& client, const FrameParser* frame, uint16_t nowMs);
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
  typedef Status (*OnCommand)(MissionClient& client, CommandEvent event, Status status, const FrameParser* frame,
                              uint16_t nowMs);
  typedef void (*FillCommand)(MissionClient& client, FlightCommand& command);
  static void fillOwn(MissionClient& client, FlightCommand& command);
  static void fillArm(MissionClient& client, FlightCommand& command);
  static void fillDisarm(MissionClient& client, FlightCommand& command);
  static void fillMode(MissionClient& client, FlightCommand& command);
  static void fillBegin(MissionClient& client, FlightCommand& command);
  static void fillStart(MissionClient& client, FlightCommand& command);
  static void fillFirst(MissionClient& client, FlightCommand& command);
  static void fillAskCurrent(MissionClient& client, FlightCommand& command);
  static void fillCurrent(MissionClient& client, FlightCommand& command);
  static void fillCurrentMessage(MissionClient& client, FlightCommand& command);
  static void fillInterval(MissionClient& client, FlightCommand& command);
  static Status onOwn(MissionClient&, CommandEvent, Status, const FrameParser*, uint16_t);
  static Status onMode(MissionClient&, CommandEvent, Status, const FrameParser*, uint16_t);
  static Status onCustomMode(MissionClient&, CommandEvent, Status, const FrameParser*, uint16_t);
  static Status onNamedMode(MissionClient&, CommandEvent, Status, const FrameParser*, uint16_t);
  static Status onStartMission(MissionClient&, CommandEvent, Status, const FrameParser*, uint16_t);
  static Status onSetCurrent(MissionClient&, CommandEvent, Status, const FrameParser*, uint16_t);
  static Status onStart(MissionClient&, CommandEvent, Status, const FrameParser*, uint16_t);
  struct Commanding;
  Status beginCommand(FillCommand fill, OnCommand on);
  MAVMISSION_APART void nextCommand(FillCommand fill, uint16_t nowMs);
  void takeCommandFrame(const FrameParser& frame, uint16_t nowMs);
  void sendCommand(uint16_t nowMs);
  void takeCommandEvent(CommandEvent event, Status status, const FrameParser* frame, uint16_t nowMs);
  bool hasItem(uint16_t item);
  uint16_t numberOf(FlightMode mode) const;
  MAVMISSION_APART uint16_t shownMode() const;  // by the last heartbeat, as modeNumber() says it
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
  MAVMISSION_APART bool isHeavyAllowed();
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
  static Status announcePart(MissionClient& client, bool isBeginning);
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
    Status (*announce)(MissionClient& client, bool isBeginning);
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
    void (*prove)(MissionClient& client, uint16_t nowMs);                  // where the sketch wants a proof
    bool (*takeUp)(MissionClient& client, Status status, uint16_t nowMs);  // null until one of these is set
    bool (*denied)(MissionClient& client, Status refusal);  // takes a refusal up, where the sketch wants that
    bool (*unsupported)(MissionClient& client, Status refusal, uint16_t nowMs);  // the same, of an item
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
    uint8_t turnPauseS;  // the pause before the next try; 0 before the first; kCommand: commanding_ is in use
    Status toReturn;
    Aboard aboard[4];  // by PlanType; the last is nobody's
    uint8_t lastResult;
    PlanType planType;        // of the plan that uploadAgain() takes; All before there is one
    uint32_t planId;          // the autopilot's own name for the mission that was accepted or verified last; 0: none
    uint8_t startStep : 4;    // StartStep
    uint8_t startArming : 4;  // StartArming
    Proof proof;
    Field field;            // that differs
    bool armedAllowed : 1;  // bits, for RAM: they cost a little flash
    bool raw : 1;
    bool tooLong : 1;       // the source has more items than the protocol can count
    bool infeasible : 1;    // the autopilot has said so of the plan that it accepted
    bool proving : 1;       // an upload is being read back
    bool mayBeRefused : 1;  // because of an error that may have been a refusal
  };

  // Reading a plan: by download(), verify(), or to prove an upload.
  struct Reading {
    DownloadTransfer transfer;
    // Takes an item: Transferring, Checking (not yet: ask for it again), or why the operation ends.
    Status (*take)(MissionClient& client, uint16_t wireItem, MissionItem& item);
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

}  // namespace mavmission
