// The autopilot's modes: MAVLink's standard modes, which mean the same on every autopilot, and the autopilot's own
// list.
#pragma once

#include <stdint.h>

#include "../base/Status.h"
#include "../client/CommandPort.h"
#include "../service/Listener.h"

namespace mavmission {

// MAV_STANDARD_MODE (MAVLink guide, Standard Modes).
enum class StandardMode : uint8_t {
  NonStandard,   // a mode of the autopilot's own
  PositionHold,  // sticks; stays where it is when they are released (multicopters)
  Orbit,         // circles around a place
  Cruise,        // sticks; keeps its track when they are released (planes)
  AltitudeHold,  // sticks; keeps its altitude when they are released
  SafeRecovery,  // returns, by whatever way, and may land
  Mission,       // flies the mission, from its current item
  Land,          // lands here
  TakeOff,       // takes off
};

// Sets a mode by its standard name, and reads the list of modes. Declare one beside the client:
//
//   MissionClient autopilot(Serial1);
//   StandardModes modes(autopilot);
//
//   modes.set(StandardMode::Land);
//
// Both are operations of the client, of which only one runs at a time: they return the first status of the operation,
// or Status::Busy. Which autopilots have standard modes: PX4 1.16 sets them, and reports and lists them on boards with
// enough flash; ArduPilot 4.6 has none, and later versions list their own modes. MissionClient::setMode() works on
// ArduPilot and PX4 without standard modes.
class StandardModes : public detail::Listener, private detail::StandardModeRules {
 public:
  // The greatest number of characters of a name.
  static constexpr uint8_t kMostCharacters = 35;

  // This object must live as long as the client: declare it next to the client, not in a function.
  template <uint8_t kMaxPayload = MAVMISSION_MAX_PAYLOAD>
  explicit StandardModes(MissionClient& client) : StandardModes(client, Kept()) {
    static_assert(kMaxPayload >= 46, "compile the library with -DMAVMISSION_MAX_PAYLOAD=46 to use StandardModes");
  }

  // Sets a mode (MAV_CMD_DO_SET_STANDARD_MODE). As in MissionClient::setMode(), each command is sent right after a
  // heartbeat, which is requested for this purpose. If that heartbeat shows another mode than at the beginning, nothing
  // is sent: Status::TakenOver. If a command that is on its way replaces a mode that somebody else has just set, that
  // mode is not set again, since a heartbeat does not show which of the two is active. Done: the autopilot reports that
  // it is in this mode (CURRENT_MODE). Status::Unconfirmed: the command was accepted, and the autopilot did not report
  // the mode within 5 s. Status::CommandUnsupported: the autopilot has no standard modes. Status::CommandFailed: this
  // aircraft does not have the mode. Status::CommandRejected: it cannot be set now. Status::NoSuchMode for NonStandard,
  // and Status::NeedsMavlink2 on a MAVLink 1 link: nothing was sent.
  //
  // Steering treats a mode that was set here as one that somebody else has set, except for Mission.
  Status set(StandardMode mode);

  // Reads an entry of the autopilot's list (AVAILABLE_MODES). `number`: 1 to count(), which is known when the first
  // entry was read. Done: the entry was read, and the functions below describe it. Status::CommandDenied: the number is
  // beyond the end of the list, or the autopilot has no list. For the same, ArduPilot 4.6 gives Status::CommandFailed,
  // and later versions, which do not answer, Status::Unconfirmed. Status::NeedsMavlink2 as above.
  Status read(uint8_t number);

  // How many entries the list has; 0 before one has been read.
  uint8_t count() const { return count_; }
  // The name of a NonStandard mode, up to kMostCharacters.
  const char* name() const { return name_; }
  StandardMode mode() const { return mode_; }
  // For MissionClient::setCustomMode().
  uint32_t customMode() const { return customMode_; }
  // True if it can be set now.
  bool isSelectable() const { return isSelectable_; }

  // The autopilot's mode in the last CURRENT_MODE; NonStandard before the first one.
  StandardMode current() const { return current_; }

 private:
  struct Kept {};
  StandardModes(MissionClient& client, Kept);
  static void take(detail::Listener& listener, const detail::FrameParser& frame);
  static void fill(detail::Client& client, FlightCommand& command);
  static Status on(detail::Client& client, detail::CommandEvent event, Status status, const detail::FrameParser* frame,
                   uint16_t nowMs);
  Status begin(StandardMode wanted, uint8_t number);
  void takeEntry(const detail::FrameParser& frame);
  bool isSetting() const { return number_ == 0; }
  Status onEvent(detail::CommandEvent event, Status status, uint16_t nowMs);
  void beginAsking(uint16_t nowMs);
  void askAgain();

  uint32_t customMode_;
  uint16_t before_;  // the mode in which a setting has begun, in the numbers of modeNumber()
  char name_[kMostCharacters + 1];
  StandardMode mode_;
  StandardMode current_;
  StandardMode wanted_;
  uint8_t count_;
  uint8_t number_;  // of the entry that is read; 0: a mode is set
  bool isSelectable_ : 1;
  bool isAsking_ : 1;    // the mode was accepted: the autopilot is asked for its mode
  bool isHeard_ : 1;     // the message that was asked for has come
  bool isAnswered_ : 1;  // and its COMMAND_ACK
  bool isSet_ : 1;       // the autopilot has reported the mode: a heartbeat is waited for
};

}  // namespace mavmission
