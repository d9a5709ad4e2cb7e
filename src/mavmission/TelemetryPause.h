// A quiet line while a plan is transferred: telemetry is switched off meanwhile, and on again afterwards.
#pragma once

#include "autopilot/AutopilotFinder.h"
#include "service/MessageIntervals.h"

namespace mavmission {

// A message that is to be silent during transfers. In flash.
struct PausableMessage {
  uint16_t id;          // of the message
  uint16_t intervalMs;  // between two of them afterwards [ms]; 0: as often as the autopilot sends it by default
};

// Asks the autopilot to stop its telemetry (MAV_CMD_SET_MESSAGE_INTERVAL) while items of a plan are transferred by
// upload(), download(), verify() and their like, and gives every message its interval back when that has ended, however
// it ended. Declare one beside the client:
//
//   MissionClient autopilot(Serial1);
//   TelemetryPause quiet(autopilot);
//
// It switches off what makes up nine tenths of the telemetry of ArduPilot with all its streams, or of PX4, or the
// sketch's own list. Each message is a command of its own, of which one is under way at a time, beside the transfer:
// that pays for long plans and full or slow lines (DESIGN.md, "Quiet transfers").
//
// Nothing stays silent: intervals are given back until each was confirmed by COMMAND_ACK, and once when the sketch
// starts and the autopilot has been heard, in case that a reset came in the middle of a transfer. So an interval that
// the sketch has set by setMessageInterval() for a message of the list is lost: name it in a list instead.
//
// COMMAND_ACK does not say which message it is about: call setMessageInterval() only while isIdle(), or its answer may
// be one that was meant for this.
class TelemetryPause : public detail::MessageIntervals {
 public:
  // The most messages of a list.
  static constexpr uint8_t kMostMessages = 32;

  // For the telemetry of ArduPilot or PX4, whichever is heard; of another autopilot, what PX4 sends. The client must
  // stay as long as this.
  explicit TelemetryPause(MissionClient& client);

  // For messages of the sketch's own choice, the loudest first; they must lie in flash, and stay. Those without which a
  // transfer cannot be followed are not silenced even so: HEARTBEAT, STATUSTEXT, those of missions and of commands.
  template <uint8_t N>
  TelemetryPause(MissionClient& client, const PausableMessage (&messages)[N])
      : TelemetryPause(client, List{messages, N}, List{messages, N}) {
    static_assert(N <= kMostMessages, "TelemetryPause takes at most 32 messages");
  }

  // To be called from loop(), before the client's update(). Neither waits nor delays.
  void update();

  // True when each message of the list has been switched off, or refused to be, and none has its interval back.
  bool isPaused() const { return isHushing_ && index_ == list().count; }
  // True when every message has its interval back, and nothing is being asked. False before an autopilot was heard.
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
  uint32_t muted_ = 0xFFFFFFFF;  // a bit for each message that may be silent: after a reset, all of them
  uint8_t index_ = 0;            // of the message that is asked for, or next
  uint8_t tries_ = 0;
  uint8_t sequence_ = 0;  // of the last answer's frame
  bool isHushing_ : 1;    // or giving intervals back
  bool isAnswered_ : 1;
};

}  // namespace mavmission
