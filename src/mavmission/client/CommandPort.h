// What a service sees of the client whose operation consists of commands, each confirmed by an answer.
#pragma once

#include <stdint.h>

#include "../autopilot/FlightCommand.h"
#include "../autopilot/FlightMode.h"
#include "../transfer/CommandTransfer.h"
#include "Port.h"

namespace mavmission {
namespace detail {

// The events of an operation that consists of commands. Each comes with the status to which it leads unless the
// operation decides otherwise.
enum class CommandEvent : uint8_t {
  Ready,      // the autopilot is found, nothing was sent: Transferring, or Checking to get this event again
  Accepted,   // Done
  Refused,    // why
  Silent,     // NoAnswer, Unconfirmed, TookTooLong
  Heartbeat,  // Transferring, as the rest
  Current,    // a MISSION_CURRENT
  Time,
};

class CommandPort {
 public:
  // Takes an event. Returns Transferring to continue, or the status with which the operation ends. `frame`: the message
  // of the event, else null.
  typedef Status (*OnCommand)(Client& client, CommandEvent event, Status status, const FrameParser* frame,
                              uint16_t nowMs);
  // Makes the command to be sent, which is all zero before.
  typedef void (*FillCommand)(Client& client, FlightCommand& command);

  static CommandPort& of(Client& client);
  // The object whose operation runs: what these functions are called for.
  static void* ownerOf(const Client& client);
  void* owner() const;

  // --- Beginning

  // Begins an operation of commands: its first status, or Status::Busy.
  Status beginCommands(FillCommand fill, OnCommand on, void* owner);
  // Begins an operation that sends messages of its own, each answered by another message. It takes the frames and the
  // time itself; sending() counts its attempts. To be called only while none runs.
  Status beginOwn(Port::Step operation, void* owner);
  // Takes over an operation of commands that has just been begun.
  void takeOver(FillCommand fill, OnCommand on, void* owner);

  // --- While it runs

  // True while it is this operation that runs.
  bool runs(OnCommand on) const;
  bool runs(Port::Step operation, const void* owner) const;
  // True if the running or last operation consists of commands.
  bool isCommanding() const;
  // When the command leaves, and what is waited for.
  CommandTransfer& sending();
  // To be called before anything is made of what is read, by whoever hears before the operation does.
  MAVMISSION_APART void lookAtClock(uint16_t nowMs);

  // --- Modes, in the numbers of modeNumber()

  // The mode of the last heartbeat.
  MAVMISSION_APART uint16_t shownMode() const;
  // True for this vehicle's RTL, and for its QRTL or SMART_RTL.
  bool isReturn(uint16_t mode) const;
  // This mode; RTL for a plane's QRTL, to which its return may go over by itself (Q_RTL_MODE).
  uint16_t counted(uint16_t mode) const;
  // True if the aircraft was armed when the running command began, or since, and is armed no more: somebody has
  // disarmed it, and wants it so.
  MAVMISSION_APART bool hasBeenDisarmed() const;
  // The mode when the running command began. Another one that is shown since, also while the vehicle is asked, or while
  // start() looks at the plan, was set meanwhile.
  uint16_t firstMode() const;
  // This autopilot's number; kNoMode: it has no such mode, or its type is not known.
  uint16_t numberOf(FlightMode mode) const;
  // True while the sketch's own setMode() orders this mode, and does not set a mode again.
  bool isSetting(uint16_t mode) const;
  // The commands that set a mode, arm and disarm. Arming is never forced.
  static void fillModeNumber(FlightCommand& command, uint16_t number);
  static void fillArming(FlightCommand& command, bool arms);

  // What orders a mode by its number calls this in CommandEvent::Ready. True: the vehicle is asked first. While it
  // isAskingVehicle(), the events are for onVehicle(); then CommandEvent::Ready comes again, with fill function `then`.
  bool asksVehicle();
  bool isAskingVehicle() const;
  MAVMISSION_APART Status onVehicle(CommandEvent event, Status status, FillCommand then);
};

}  // namespace detail
}  // namespace mavmission
