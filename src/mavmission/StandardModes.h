// The autopilot's modes: by their standard names, which mean the same on every autopilot, and as it lists them.
#pragma once

#include <stdint.h>

#include "MissionClient.h"
#include "service/Listener.h"

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
// Both are operations of the client, one at a time as all of them: they return its first status, or Status::Busy. For
// autopilots that have standard modes: PX4 1.16 sets them, and tells and lists them on boards that have the room;
// ArduPilot 4.6 does neither, and later ones list their own modes. MissionClient::setMode() serves ArduPilot and PX4
// without them.
class StandardModes : public detail::Listener, private detail::StandardModeRules {
 public:
  // The characters of the longest name.
  static constexpr uint8_t kMostCharacters = 35;

  // This object must live as long as the client: declare it beside it, not in a function.
  template <uint8_t kMaxPayload = MAVMISSION_MAX_PAYLOAD>
  explicit StandardModes(MissionClient& client) : StandardModes(client, Kept()) {
    static_assert(kMaxPayload >= 46, "compile the library with -DMAVMISSION_MAX_PAYLOAD=46 to use StandardModes");
  }

  // Sets a mode (MAV_CMD_DO_SET_STANDARD_MODE). As with MissionClient::setMode() each order leaves right behind a
  // heartbeat, which is asked for, and none behind one that shows another mode than at the beginning:
  // Status::TakenOver. A mode that an order on its way undoes is not set again, since a heartbeat does not tell which
  // of the two flies. Done when the autopilot says that it is in this mode (CURRENT_MODE); Status::Unconfirmed when it
  // was accepted, and the autopilot does not say so within 5 s. Status::CommandUnsupported from an autopilot without
  // standard modes, Status::CommandFailed for a mode that this aircraft does not have, Status::CommandRejected while it
  // cannot be set; Status::NoSuchMode for NonStandard, and Status::NeedsMavlink2 on a MAVLink 1 link: nothing is sent
  // then.
  //
  // Steering takes such a mode for somebody else's, except for Mission.
  Status set(StandardMode mode);

  // Reads an entry of the autopilot's list (AVAILABLE_MODES). `number`: 1 to count(), which the first entry tells. Done
  // when it has come: the functions below then are about it. Status::CommandDenied after the end of the list, and from
  // an autopilot that has none; ArduPilot 4.6 says Status::CommandFailed, and later ones nothing after the end of their
  // list: Status::Unconfirmed. Status::NeedsMavlink2 as above.
  Status read(uint8_t number);

  // How many entries the list has; 0 before one has been read.
  uint8_t count() const { return count_; }
  // What the mode is called if it is NonStandard: a text of up to kMostCharacters.
  const char* name() const { return name_; }
  StandardMode mode() const { return mode_; }
  // For MissionClient::setCustomMode().
  uint32_t customMode() const { return customMode_; }
  // True if it can be set now.
  bool isSelectable() const { return isSelectable_; }

  // The mode in which the autopilot is, as CURRENT_MODE has told it last; NonStandard before that.
  StandardMode current() const { return current_; }

 private:
  struct Kept {};
  StandardModes(MissionClient& client, Kept);
  static void take(detail::Listener& listener, const detail::FrameParser& frame);
  static void fill(detail::Client& client, FlightCommand& command);
  static Status on(detail::Client& client, detail::Client::CommandEvent event, Status status,
                   const detail::FrameParser* frame, uint16_t nowMs);
  Status begin(StandardMode wanted, uint8_t number);
  void takeEntry(const detail::FrameParser& frame);
  bool isSetting() const { return number_ == 0; }
  Status onEvent(detail::Client::CommandEvent event, Status status, uint16_t nowMs);
  void beginAsking(uint16_t nowMs);
  void askAgain(uint16_t nowMs);

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
};

}  // namespace mavmission
