// Switches telemetry off while a plan is transferred, and on again afterwards.
#pragma once

#include "../autopilot/AutopilotFinder.h"
#include "../service/MessageIntervals.h"

namespace mavmission {

// A message to be switched off during transfers. The list is in flash.
struct PausableMessage {
  uint16_t id;          // of the message
  uint16_t intervalMs;  // afterwards [ms]; 0: the autopilot's default
};

// Asks the autopilot to stop its telemetry (MAV_CMD_SET_MESSAGE_INTERVAL) while upload(), download() or verify()
// transfers items of a plan, and restores the interval of every message when the transfer has ended, however it ended.
// Declare one beside the client:
//
//   MissionClient autopilot(Serial1);
//   TelemetryPause quiet(autopilot);
//
// It switches off the messages that make up nine tenths of the telemetry of ArduPilot with all its streams, or of PX4,
// or the messages of a list that the sketch gives. Each message needs a command, and the commands are sent one at a
// time, during the transfer: this is worth it for long plans and for full or slow links (docs/design/parts.md).
//
// Nothing stays switched off: the command that restores an interval is repeated until COMMAND_ACK has confirmed it.
// Every interval is also restored once when the sketch starts and the autopilot has been heard, in case a reset came in
// the middle of a transfer. So an interval that the sketch has set by setMessageInterval() for a message of the list is
// lost: give that interval in a list of your own instead.
//
// COMMAND_ACK does not say to which message it belongs: so setMessageInterval() waits for the answer to the last
// command of this object.
class TelemetryPause : public detail::MessageIntervals {
 public:
  // The greatest length of a list.
  static constexpr uint8_t kMostMessages = 32;

  // For the telemetry of ArduPilot or PX4, whichever is heard; for another autopilot PX4's list is used. This object
  // must live as long as the client: declare it next to the client, not in a function.
  explicit TelemetryPause(MissionClient& client);

  // For messages that the sketch chooses, those with the most bytes a second first; the list must be in flash. Messages
  // that a transfer needs are never switched off: HEARTBEAT, STATUSTEXT, and those of missions and commands.
  template <uint8_t N>
  TelemetryPause(MissionClient& client, const PausableMessage (&messages)[N])
      : TelemetryPause(client, List{messages, N}, List{messages, N}) {
    static_assert(N <= kMostMessages, "TelemetryPause takes at most 32 messages");
  }

  // To be called from loop(), before the client's update(). It returns without waiting.
  void update();

  // True while each message of the list is switched off, or the autopilot has refused to switch it off.
  bool isPaused() const { return isHushing_ && index_ == list().count; }
  // True when every interval is restored, and no command is under way. False before an autopilot was heard.
  bool isIdle() const { return muted_ == 0 && !isWaiting_; }

 private:
  struct List {
    const PausableMessage* messages;
    uint8_t count;
  };

  TelemetryPause(MissionClient& client, const List& forArduPilot, const List& forOthers);
  static void take(detail::Listener& listener, const detail::FrameParser& frame);
  void takeResult(uint8_t result, uint16_t nowMs);
  const List& list() const;
  bool isTransferring() const;
  bool findNext();
  void askNext(uint16_t nowMs);

  List forArduPilot_;
  List forOthers_;
  uint32_t muted_ = 0xFFFFFFFF;  // a bit for each message that may be switched off: after a reset, all
  uint8_t index_ = 0;            // of the message whose command is under way, or next
  uint8_t tries_ = 0;
  bool isHushing_ : 1;  // true: switching off; false: restoring
  bool isWaiting_ : 1;  // for an answer, or for late ones
  bool isAnswered_ : 1;
};

}  // namespace mavmission
