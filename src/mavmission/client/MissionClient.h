// The class that a sketch uses: one autopilot on one Stream.
#pragma once

#include <stdint.h>

#include "../autopilot/FlightCommand.h"
#include "../autopilot/FlightMode.h"
#include "../base/Status.h"
#include "../item/PlanType.h"
#include "../link/LinkCounters.h"
#include "../link/MavlinkVersion.h"
#include "../plan/ItemSink.h"
#include "../plan/ItemSource.h"
#include "../signing/SigningCounters.h"
#include "../signing/SigningKey.h"
#include "../signing/TimestampStore.h"
#include "../transfer/Operations.h"
#include "Client.h"

namespace mavmission {

// Speaks the mission protocol with one autopilot, and never blocks: call update() from loop(), as often as possible. At
// 57600 baud a Mega's receive buffer is full after 11 ms. A loop that takes longer loses bytes: the transfer then takes
// longer, and still succeeds. The client uses no heap. The Stream must be open, and must live as long as the client.
class MissionClient : private detail::Client {
 public:
  // The value of failedItem() when no item failed.
  static constexpr uint16_t kNoItem = Client::kNoItem;
  // The greatest number of items that the protocol can count, home included on ArduPilot.
  static constexpr uint16_t kMaxItems = Client::kMaxItems;

  // Talks over this port. The sketch opens it.
  explicit MissionClient(Stream& stream) : Client(stream) {}

  // --- Operations: one at a time. A second one is refused with Status::Busy, and the running one continues.

  // Uploads a plan, which replaces the plan that the autopilot holds. It waits for the autopilot, checks the plan, then
  // transfers it. upload() returns the first status of the operation, or Status::Busy; update() returns the status with
  // which it ends. That status is Status::Accepted if, and only if, the plan is aboard. If the final acknowledgement is
  // lost or unclear, the plan aboard is read back and compared: Status::Differs means that another plan is there,
  // Status::Unconfirmed that it could not be read back either. With Readback::Always it is read back in any case, and
  // so it is from an autopilot that is neither ArduPilot nor PX4. The source must live until the operation has ended.
  // (MAVLink guide, Mission Protocol, "Upload a Mission to the Vehicle".)
  Status upload(const ItemSource& plan, Readback proof = Readback::InDoubt) {
    return uploadProven(plan, PlanType::Mission, proof);
  }
  // The same for a fence or rally points. A fence of up to three items is always read back, 1 s after it was accepted,
  // and sent again if ArduPilot has wiped it by then.
  Status upload(const ItemSource& plan, PlanType type, Readback proof = Readback::InDoubt);
  // A bare array is refused: it does not say whether it is in flash or in RAM.
  template <size_t N, typename... More>
  Status upload(const MissionItem (&)[N], More...) {
    static_assert(N == 0, "write upload(inFlash(plan)) for a plan with PROGMEM, upload(inRam(plan)) for one without");
    return Status::Idle;
  }

  // Uploads the plan only if it is not aboard already; meant to be called each time the sketch starts. First it finds
  // out which plan is aboard: on PX4 it compares the checksum, in one exchange whatever the plan's length; on ArduPilot
  // it reads the plan and compares the items, which writes nothing to the autopilot's storage. It ends with
  // Status::AlreadyAboard if the plan was there, with Status::Accepted if it is there now, or as upload() ends. While
  // the autopilot is armed it uploads nothing, even after allowWhileArmed(true): if another plan is aboard it ends with
  // Status::Armed, and nothing has changed.
  Status ensure(const ItemSource& plan, Readback proof = Readback::InDoubt) {
    return ensurePlan(plan, PlanType::Mission, proof);
  }
  Status ensure(const ItemSource& plan, PlanType type, Readback proof = Readback::InDoubt);
  template <size_t N, typename... More>
  Status ensure(const MissionItem (&)[N], More...) {
    static_assert(N == 0, "write ensure(inFlash(plan)) for a plan with PROGMEM, ensure(inRam(plan)) for one without");
    return Status::Idle;
  }

  // Upload without the read-back, for a sketch that has to be small (docs/measurements.md). Ends with Status::Accepted
  // when the autopilot has acknowledged the whole plan, on PX4 with our checksum. If ArduPilot's only acknowledgement
  // is lost, it ends with Status::Unconfirmed; and so it does, whatever is acknowledged, with an autopilot that is
  // neither ArduPilot nor PX4.
  Status uploadWithoutReadback(const ItemSource& plan) { return startUpload(plan, PlanType::Mission); }
  Status uploadWithoutReadback(const ItemSource& plan, PlanType type);

  // Uploads the plan of the last upload or verification again, for example after a failure that left a mixture.
  // Status::SourceRefused if there was no such plan.
  Status uploadAgain();

  // Replaces `count` items of the plan aboard, from item `first` on. `plan` is the whole plan, and its other items must
  // be aboard already. ArduPilot does this; PX4 does not (Status::WholePlansOnly). (Guide, MISSION_WRITE_PARTIAL_LIST.)
  Status uploadPartial(const ItemSource& plan, uint16_t first, uint16_t count);

  // Reads the autopilot's plan, item by item, into a sink, and ends with Status::Downloaded. The items have the numbers
  // that the sketch uses for an upload: on ArduPilot home is given apart, and jump targets count the sketch's items.
  // The sink must live until the operation has ended. (Guide, "Download a Mission from the Vehicle".)
  Status download(const ItemSink& sink, PlanType type = PlanType::Mission);

  // Reads the autopilot's plan and compares it with `plan`, item by item, holding neither in RAM. Ends with
  // Status::Verified, or with Status::Differs: failedItem() and differingField() name the first difference. The
  // comparison allows exactly what each autopilot is known to rewrite.
  Status verify(const ItemSource& plan, PlanType type = PlanType::Mission);

  // Deletes the autopilot's plan, or with PlanType::All all three plans. Ends with Status::Cleared. (Guide, "Clear
  // Missions".)
  Status clear(PlanType type = PlanType::Mission);

  // --- Flying. Each ends with Status::Done, or with the autopilot's refusal (MAVLink guide, Command Protocol). Only
  // arm(), start(), verifyAndStart(), Steering::takeOff(), and send() with a command that arms, can arm the aircraft.
  // Arming is never forced. Read docs/in_control.md before the first flight.

  // Arms the aircraft, and flies the plan that is aboard, beginning with `item`, in the sketch's numbers. start() takes
  // the steps that this autopilot needs, and each step is confirmed; startStep() says which one was refused.
  // Status::Done: the autopilot is armed, in its mission mode, and flies to the first item from there on that can be
  // flown to (DO_ commands and jumps are skipped). Status::OtherItem: it flies to another item. Status::Unconfirmed: it
  // does not report its item. If it flies its mission already, nothing is sent that would change that. start() is
  // refused with Status::Unproven unless aboard() is our plan, and with Status::Armed while the autopilot is armed,
  // unless allowWhileArmed() allows it. It also ends with Unproven as soon as it detects that somebody has replaced the
  // plan meanwhile. On ArduPilot it cannot detect a plan of the same length that arrived over another link:
  // verifyAndStart() can. The plan's source must still exist.
  //
  // If a step after arming is refused, the aircraft is disarmed again, on the ground and never by force: the status is
  // that of the refused step, and startArming() says whether the aircraft was disarmed. It is not disarmed if somebody
  // else has set another mode meanwhile (Status::TakenOver), nor after cancel(). A mode that somebody else sets stays:
  // each command is sent right after a heartbeat that shows no other mode, and if a command that was already on its way
  // replaces that mode, the mode is set again at once (Status::Overruled if the autopilot refuses it).
  // Status::NotArmed: somebody has disarmed the aircraft meanwhile. A rover may be armed seconds before it accepts
  // AUTO: on a rover AUTO is tried for 15 s.
  Status start(uint16_t item = 0);

  // Does verify(plan), then start(item). If the autopilot has no checksum for its plan (ArduPilot), it does
  // verify(plan) a second time when the aircraft flies. So it also detects another station's plan that has as many
  // items as ours, and Done means that each item aboard was compared while the aircraft flew. If the first verify()
  // does not end with Verified, that is the status, and nothing was sent that arms. Otherwise it ends as start() does.
  // It ends with Unproven if the second verify() finds another plan (aboard() is OtherPlan, and the aircraft is
  // disarmed if the autopilot allows it), or could not be finished (aboard() is as before or NotKnown, and the aircraft
  // flies on). If somebody sets another mode during a verify(), that mode stays: TakenOver. No other operation can
  // begin before it has ended; each verify() takes about as long as the upload did. Call onEnd() before you call this.
  Status verifyAndStart(const ItemSource& plan, uint16_t item = 0);

  // Arms or disarms, as the autopilot's own checks allow. Done when a heartbeat shows it, so isArmed() says the same.
  Status arm();
  Status disarm();
  // Sets the mode, by its name or by the autopilot's own number (HEARTBEAT.custom_mode). Done: a heartbeat shows the
  // mode; if it shows the mode already, nothing is sent. Status::Unconfirmed: the command was accepted, and no
  // heartbeat shows the mode. If somebody else has changed the mode since the last heartbeat, or does so meanwhile,
  // that mode stays: Status::TakenOver, or Overruled as with start(). The sketch may then call setMode() again.
  // Status::NoSuchMode: the vehicle has no mode of this name, or its type is not known (docs/modes.md); nothing was
  // sent.
  Status setMode(FlightMode mode);
  Status setCustomMode(uint32_t customMode);
  // Makes an armed aircraft fly its mission from its current item on. Status::NotArmed if it is not armed; otherwise as
  // setMode().
  Status startMission();
  // Makes this item, in the sketch's numbers, the current one: an aircraft that flies its mission goes there at once.
  // Status::NoSuchItem for a number that is not in the plan, where the plan is known; otherwise the autopilot refuses
  // it.
  Status setCurrentItem(uint16_t item);
  // Sets the interval at which the autopilot sends a message [us]; 0 is its default, -1 never.
  Status setMessageInterval(uint16_t messageId, int32_t intervalUs);
  // Sends any command; the FlightCommand must live until the operation has ended. send() does not force arming either,
  // and does not send MISSION_START, which arms a PX4, to a disarmed aircraft (Status::NotArmed): use start(). If the
  // autopilot takes the command in the other form only (COMMAND_LONG or COMMAND_INT), it is sent again in that form, if
  // each value fits into it.
  Status send(const FlightCommand& command, CommandRepeat repeat = CommandRepeat::IfHarmless);
  Status send(const FlightCommand&&,
              CommandRepeat = CommandRepeat::IfHarmless) = delete;  // a temporary would be gone before it is sent

  // Ends the running operation with Status::Cancelled, and tells the autopilot (MISSION_ACK with
  // MAV_MISSION_OPERATION_CANCELLED). If no operation runs, it does nothing. Called in a callback of update(), it takes
  // effect when that update() ends, unless the operation has ended by itself before.
  void cancel();

  // To be called from loop(). Reads the received bytes, sends what is due and fits, and returns without waiting.
  // Returns the status with which an operation has ended, once; otherwise the status of the running one, or
  // Status::Idle. Called from one of its own callbacks, it does nothing and returns Status::Busy.
  Status update();

  // Sends a message of the sketch's own, with the right sequence number. False if another frame is still being sent, or
  // nothing may be sent yet (no autopilot heard, or several): call it again later. It is also false for a message that
  // cannot be sent on a MAVLink 1 link: an id above 255, or a lengthV1 of 0. The payload must live until isSent().
  bool sendMessage(const OutgoingMessage& message) { return link_.sendForeign(message); }
  // True when every frame has been handed to the stream.
  bool isSent() const { return link_.isSent(); }

  // --- State

  Status status() const { return Client::status(); }  // of the running operation, or of the last one
  // True while an operation runs.
  bool isBusy() const { return Client::isBusy(); }
  // The item that the status is about, in the sketch's numbers, or kNoItem. ArduPilot's home does not count as an item.
  uint16_t failedItem() const { return state_.failedItem; }
  // Items transferred, and items in all, of the running or last transfer.
  uint16_t itemsDone() const { return state_.itemsDone; }
  uint16_t itemsTotal() const { return Client::itemsTotal(); }
  // After Status::Differs the field that differs; after Status::NotKept the field that would be stored as another
  // value; after the refusal of a fence or of rally points as such (BadFence) the field that is wrong.
  ItemField differingField() const { return session_.field; }
  // After an operation with a plan has ended with Status::NotKept: the value that the autopilot would store in that
  // field. keptValue() reads the item from the plan's source again. It returns NaN if the value is not known (the
  // autopilot would refuse it, or the result depends on its board), and after any other status.
  float keptValue();
  // The plan of a type that the autopilot holds after the last upload, verification or clear of that type.
  Aboard aboard(PlanType type = PlanType::Mission) const { return Client::aboard(type); }
  // The autopilot's last MISSION_ACK.type in this operation, or 255 if there was none: the cause of Status::Unconfirmed
  // and Status::UnknownResult.
  uint8_t lastResult() const { return state_.lastResult; }

  // Who has taken the aircraft from this sketch: Status::PilotHasIt (a pilot, or another station, has set another mode
  // or has disarmed it) or Status::FailsafeHasIt; Status::Idle: nobody. It is seen by start() and takeOff() while they
  // run, and by Steering, MissionFollower and Flight at any time. It is remembered, also after the landing: arm(),
  // start(), takeOff(), and send() with a command that lets motors start, then end with that status, until
  // requestControl().
  Status takenBy() const { return known_.takenBy; }
  // Asks for the aircraft again. To be called when a person wants it so. Nothing is sent.
  void requestControl() { known_.takenBy = Status::Idle; }

  // The step of start() that is running, or that was refused; toString() says it in words.
  StartStep startStep() const { return Client::startStep(); }
  StartArming startArming() const { return Client::startArming(); }

  // The autopilot on the line, as its heartbeats tell.
  bool hasAutopilot() const { return Client::hasAutopilot(); }
  Firmware firmware() const { return Client::firmware(); }
  uint8_t autopilotSystemId() const { return link_.finder().heartbeat().systemId; }
  uint8_t autopilotComponentId() const { return link_.finder().heartbeat().componentId; }
  // As the autopilot's last heartbeat has shown it, even if it is no longer heard: an aircraft in the air stays armed.
  bool isArmed() const { return Client::isArmed(); }
  // The autopilot's own number of its mode (HEARTBEAT.custom_mode).
  uint32_t customMode() const { return Client::customMode(); }
  // True if the autopilot's last heartbeat shows this mode.
  bool isInMode(FlightMode mode) const;
  // The autopilot's own name of its mode, such as "GUIDED" on ArduPilot or "POSCTL" on PX4, for Serial.print(). Flash
  // text; "unknown" if it is not known (docs/modes.md).
  FlashText modeName() const;
  // Counters of frames and of faults on the line.
  LinkCounters counters() const { return link_.counters(); }

  // --- Callbacks. Null, the default, means none. `context` is handed to the function and may be null. What a callback
  // may call is in docs/callbacks.md.

  // One function each: another call replaces it.
  void onProgress(ProgressFunction function, void* context = nullptr);
  void onEnd(EndFunction function, void* context = nullptr);

  // --- Settings, to be made while no operation runs

  // Sets our system id (1 to 255) and component id. By default we are a companion computer of the autopilot: its system
  // id, and component 191. With ids that the sketch has set, heartbeats are sent at once; with the default ids they are
  // sent only after an autopilot has been heard. Do not set the autopilot's own two ids: it would ignore us.
  void setSourceIds(uint8_t systemId, uint8_t componentId = detail::Link::kComponentId);
  // Names the autopilot to talk to, if there may be several on the line. With system id 0, the default, it is the only
  // one.
  void setTargetIds(uint8_t systemId, uint8_t componentId = 1);
#if MAVMISSION_SIGNING
  // From now on signs every frame that is sent, and ignores every received frame that is not signed with the key
  // (MAVLink guide, Message Signing). Only RADIO_STATUS, which a radio without a key sends, still reaches a
  // MessageListener. All frames are then MAVLink 2. `linkId`: a number that the sketch chooses for this link, the same
  // after each reset. `store`: keeps the time of signatures across a reset (EepromTimestamps, or one that the sketch
  // provides).
  void signWith(const SigningKey& key, uint8_t linkId, const TimestampStore& store) {
    link_.signWith(key, linkId, store);
  }
  // Sets the time of signatures, where the sketch has a clock or a GPS [s, Unix]. Without it the autopilot's time is
  // used.
  void setSigningTime(uint32_t unixTimeS) { link_.setSigningTime(detail::SigningTime::atUnixTime(unixTimeS)); }
  // Received frames since signWith(): how many were accepted, and how many were refused for which reason.
  const SigningCounters& signingCounters() const { return link_.signing().counters(); }
#else
  template <typename... Arguments>
  void signWith(Arguments&&...) {
    static_assert(sizeof...(Arguments) == 255,
                  "compile the library with -DMAVMISSION_SIGNING=1 to use signWith(): see Config.h");
  }
#endif
  // MAVLink 1 or 2; by default the autopilot's own version.
  void setMavlinkVersion(MavlinkVersion speak) { link_.setMavlinkVersion(speak); }
  // Allows operations that change the plan, start() and Steering while the autopilot is armed. ArduPilot replaces its
  // plan item by item: an upload that breaks off leaves a flying aircraft with a mixture of two plans.
  void allowWhileArmed(bool allow) { state_.armedAllowed = allow; }
  // With true, item numbers and jump targets are those of the autopilot: on ArduPilot item 0 is home, and the plan has
  // to contain it.
  void useRawNumbering(bool raw) { session_.raw = raw; }
  // If another ground station is transferring (MISSION_ACK denied, or PX4's error for busy), an upload is tried again
  // after 1, 2, 4, then every 8 s, for at most `seconds` after the first refusal; then it ends with the status of the
  // refusal. While it waits, the status is BackingOff. 0: no retry. A sketch that calls it takes more flash
  // (docs/measurements.md).
  void retryWhenBusy(uint16_t seconds);
  // For autopilots that do not know MISSION_ITEM_INT: an autopilot that is neither ArduPilot nor PX4, and refuses the
  // first item as unsupported, gets the plan again as MISSION_ITEM, whose float coordinates are rounded by up to some
  // metres. `always`: MISSION_ITEM_INT is not tried at all. A sketch that calls it takes more flash
  // (docs/measurements.md).
  void useMissionItemFallback(bool always = false);
  // The longest wait for an autopilot [s]; an operation then ends with Status::NoAutopilot. 0, the default: 10 s for
  // commands, but for setMessageInterval(); no limit for anything else.
  void setAutopilotTimeout(uint16_t seconds) { session_.waitingLimitS = seconds; }
  // The longest time for a transfer or a command [s], from when the autopilot was found; it then ends with
  // Status::TookTooLong. 0, the default: 120 s, and 2 s for each item.
  void setOperationTimeout(uint16_t seconds) { session_.transferLimitS = seconds; }

 private:
  friend class detail::Port;
};

}  // namespace mavmission
