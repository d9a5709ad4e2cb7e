// The Arduino as a payload: it carries out commands that the autopilot, a plan or a ground station gives it, and
// answers them.
#pragma once

#include <stdint.h>

#include "../base/RetryRules.h"
#include "../service/Listener.h"

namespace mavmission {

// A command that was received (COMMAND_LONG, MAVLink guide, Command Protocol).
struct PayloadCommand {
  float param[7];       // param[0] is parameter 1
  uint16_t id;          // MAV_CMD
  uint8_t systemId;     // of the sender
  uint8_t componentId;  // of the sender
  bool isForAll;        // it is addressed to every component, and not to us alone
};

// MAV_RESULT of COMMAND_ACK.
enum class PayloadAnswer : uint8_t {
  Accepted = 0,
  Rejected = 1,     // not now: it may succeed later
  Denied = 2,       // a parameter is not valid
  Unsupported = 3,  // this payload has no such command
  Failed = 4,
  InProgress = 5,  // it has begun: call Payload::finish() when it has ended
};

// Called from Payload::update() once for each command, even if the sender repeats it. While a command is in progress,
// another one may come: the function can carry it out at the same time, or refuse it; if it returns InProgress, the
// sender gets Rejected. The function may begin an operation of the client if none runs, and may call cancel().
typedef PayloadAnswer (*PayloadFunction)(void* context, const PayloadCommand& command);

// Declare one beside the client:
//
//   PayloadAnswer carryOut(void*, const PayloadCommand& command) {
//     if (command.id != 42600) return PayloadAnswer::Unsupported;  // DO_WINCH
//     startWinch(command.param[2]);
//     return PayloadAnswer::InProgress;
//   }
//   Payload payload(autopilot, carryOut);
//
// docs/payload.md says which commands of a plan arrive. A command with coordinates (COMMAND_INT) is ignored. If the
// function returns Unsupported for a command to all components, no answer is sent: it is meant for another component.
class Payload : public detail::Listener {
 public:
  // This object must live as long as the client: declare it next to the client, not in a function.
  Payload(MissionClient& client, PayloadFunction function, void* context = nullptr);

  // To be called from loop(). It returns without waiting.
  void update();

  // Sets how much of the command in progress is done, 0 to 100 [%]; this is sent with the answer, once a second.
  void progress(uint8_t percent) { percent_ = percent; }
  // Ends the command that is in progress. If there is none, it does nothing.
  void finish(PayloadAnswer answer);
  // True while a command is in progress.
  bool isBusy() const;

 private:
  // Come: the function has not seen the command yet. Answered: a repeat of it gets the same answer.
  enum class State : uint8_t { None, Come, InProgress, Answered };

  // What has become of a command.
  struct Record {
    uint16_t id;
    uint16_t sum;        // of its parameters: tells whether a command is the same
    uint16_t changedMs;  // when the state changed, or the progress was told [ms]
    uint8_t systemId;
    uint8_t componentId;
    State state;
    PayloadAnswer answer;
    bool isForAll;
    bool isDue;  // the answer must be sent
  };

  static void take(detail::Listener& listener, const detail::FrameParser& frame);
  void put(bool isRepeat, uint16_t nowMs);
  void work(Record& record, uint16_t nowMs);
  Record* find(State state);
  void answer(const Record& record);

  PayloadFunction const function_;
  void* const context_;
  PayloadCommand command_;  // the one whose record says Come
  Record records_[4];       // so many commands may be repeated without being carried out again
  uint8_t percent_ = 0;
};

}  // namespace mavmission
