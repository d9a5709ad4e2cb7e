// The class that a sketch uses: one autopilot on one Stream.
#pragma once

#include <stdint.h>

#include "FlightCommand.h"
#include "FlightMode.h"
#include "ItemSink.h"
#include "ItemSource.h"
#include "LinkCounters.h"
#include "MavlinkVersion.h"
#include "Operations.h"
#include "PlanType.h"
#include "SigningCounters.h"
#include "SigningKey.h"
#include "Status.h"
#include "TimestampStore.h"
#include "client/Client.h"

namespace mavmission {

namespace detail {
class Listener;
}  // namespace detail

// Speaks the mission protocol with one autopilot, without ever blocking: call update() from loop(), as often as can be.
// At 57600 baud a Mega's receive ring is full after 11 ms: a loop that takes longer loses bytes, and so time, but
// nothing else. Uses no heap. The Stream must be open, and stay, as long as this.
class MissionClient : private detail::Client {
 public:
  // What failedItem() is when no item failed.
  static constexpr uint16_t kNoItem = Client::kNoItem;
  // The most items that the protocol can count; home is one of them on ArduPilot.
  static constexpr uint16_t kMaxItems = Client::kMaxItems;

  // Talks over this port, which the sketch opens.
  explicit MissionClient(Stream& stream) : Client(stream) {}

  // --- Operations: one at a time; a second one is refused with Status::Busy, and the running one goes on unharmed.

  // Puts a plan aboard, in the place of what is there. Waits for the autopilot, checks the plan, then transfers.
  // Returns the status that it begins with, or Status::Busy. How it ends is what update() returns: Status::Accepted is
  // said exactly when the plan is aboard. Where the final answer is in doubt, what is aboard is read back and compared:
  // Status::Differs says that it is not the plan, and Status::Unconfirmed remains where it cannot be read either. With
  // Readback::Always it is read back in any case. The source must stay until the end. (MAVLink guide, Mission Protocol,
  // "Upload a Mission to the Vehicle".)
  Status upload(const ItemSource& plan, Readback proof = Readback::InDoubt) {
    return uploadProven(plan, PlanType::Mission, proof);
  }
  // The same for a fence or rally points. A fence of up to three items is always read back, 1 s after it was accepted,
  // and sent again if ArduPilot, which has accepted it, has wiped it by then.
  Status upload(const ItemSource& plan, PlanType type, Readback proof = Readback::InDoubt);

  // The same without reading back, for a sketch that has to be small (docs/measurements.md). Status::Accepted is said
  // when the autopilot has acknowledged the whole plan, and on PX4 with our checksum; when ArduPilot's only answer is
  // lost, it is Status::Unconfirmed.
  Status uploadWithoutReadback(const ItemSource& plan, PlanType type = PlanType::Mission) {
    return startUpload(plan, type);
  }

  // Puts the plan of the last upload or verification aboard again: after a failure that left a mixture, for example.
  // Status::SourceRefused if there was none.
  Status uploadAgain() { return uploadKeptPlan(); }

  // Puts `count` items of a plan aboard, from item `first` on, in the place of those that are there. `plan` is the
  // whole plan, and the rest of it must be aboard already. ArduPilot does this; PX4 does not (Status::WholePlansOnly).
  // (Guide, MISSION_WRITE_PARTIAL_LIST.)
  Status uploadPartial(const ItemSource& plan, uint16_t first, uint16_t count);

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
  Status send(const FlightCommand& command, CommandRepeat repeat = CommandRepeat::IfHarmless);
  Status send(const FlightCommand&&,
              CommandRepeat = CommandRepeat::IfHarmless) = delete;  // it would be gone before it is sent

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

  Status status() const { return Client::status(); }  // of the running operation, or the last one
  // True while an operation runs.
  bool isBusy() const { return Client::isBusy(); }
  // The item that the status is about, counted as the sketch counts, or kNoItem. ArduPilot's home is no item.
  uint16_t failedItem() const { return state_.failedItem; }
  // Of the running or last transfer.
  uint16_t itemsDone() const { return state_.itemsDone; }
  uint16_t itemsTotal() const { return Client::itemsTotal(); }
  // What differs after Status::Differs, or after Status::NotKept would be kept as another value.
  ItemField differingField() const { return rest_.field; }
  // After Status::NotKept: what the autopilot would make of the value of that field. NaN where that is not known: where
  // it would not take it, or where what it makes of it depends on its board. The plan's source is asked for the item
  // again.
  float keptValue();
  // The plan of a type that the autopilot holds after the last upload, verification or clear of that type.
  Aboard aboard(PlanType type = PlanType::Mission) const { return Client::aboard(type); }
  // The autopilot's last MISSION_ACK.type in this operation, or 255: what lies behind Status::Unconfirmed and
  // Status::UnknownResult.
  uint8_t lastResult() const { return rest_.lastResult; }

  // The step of start() that runs, or that was refused.
  StartStep startStep() const { return Client::startStep(); }
  StartArming startArming() const { return Client::startArming(); }

  // The autopilot on the line, by its heartbeats.
  bool hasAutopilot() const { return Client::hasAutopilot(); }
  Firmware firmware() const { return Client::firmware(); }
  uint8_t autopilotSystemId() const { return link_.finder().heartbeat().systemId; }
  uint8_t autopilotComponentId() const { return link_.finder().heartbeat().componentId; }
  bool isArmed() const { return Client::isArmed(); }
  // The autopilot's own number of the mode that it is in (HEARTBEAT.custom_mode).
  uint32_t customMode() const { return Client::customMode(); }
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
  void setSourceIds(uint8_t systemId, uint8_t componentId = detail::Link::kComponentId);
  // The autopilot to talk to, where there may be several on the line. System id 0: whichever is alone there.
  void setTargetIds(uint8_t systemId, uint8_t componentId = 1);
#if MAVMISSION_SIGNING
  // From now on signs what is sent, and refuses what is not signed with the key (MAVLink guide, Message Signing): such
  // a frame is as good as none. Only RADIO_STATUS, which a radio without a key sends, still reaches a MessageListener.
  // All frames are then MAVLink 2. `linkId`: of this link, the sketch's own choice; the same after each reset. `store`:
  // where the time of signatures outlives a reset (EepromTimestamps, or the sketch's own).
  void signWith(const SigningKey& key, uint8_t linkId, const TimestampStore& store) {
    link_.signWith(key, linkId, store);
  }
  // Tells the time, where the sketch has a clock or a GPS [s, Unix]. Without it the time is the autopilot's.
  void setSigningTime(uint32_t unixTimeS) { link_.setSigningTime(detail::SigningTime::atUnixTime(unixTimeS)); }
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
  void setMavlinkVersion(MavlinkVersion speak) { link_.setMavlinkVersion(speak); }
  // Allows operations that change the plan while the autopilot is armed. ArduPilot edits its plan in place: an upload
  // that breaks off leaves a flying aircraft with a mixture.
  void allowWhileArmed(bool allow) { rest_.armedAllowed = allow; }
  // Item numbers and jump targets as the autopilot has them: on ArduPilot item 0 is home, and is given by the plan.
  void useRawNumbering(bool raw) { rest_.raw = raw; }
  // When another ground station is transferring (MISSION_ACK denied, or PX4's error for busy), tries again after 1, 2,
  // 4, then each 8 s, for at most `seconds` after the first refusal; then it ends with the refusal. 0: no retry. Until
  // then the status is BackingOff. Costs flash in a sketch that calls it (docs/measurements.md).
  void retryWhenBusy(uint16_t seconds);
  // Serves autopilots that do not know MISSION_ITEM_INT: one that is neither ArduPilot nor PX4 and refuses the first
  // item as unsupported gets the plan again as MISSION_ITEM, with coordinates as floats, coarser by metres. `always`:
  // no other is tried. Costs flash in a sketch that calls it (docs/measurements.md).
  void useMissionItemFallback(bool always = false);
  // The longest wait for an autopilot [s], after which an operation ends with Status::NoAutopilot; 0, the default, is
  // for ever.
  void setAutopilotTimeout(uint16_t seconds) { rest_.waitingLimitS = seconds; }
  // The longest that a transfer or a command may take [s], after which it ends with Status::TookTooLong; 0, the
  // default, is 120 s, and 2 s for each item.
  void setOperationTimeout(uint16_t seconds) { rest_.transferLimitS = seconds; }

 private:
  friend class detail::Listener;
};

}  // namespace mavmission
