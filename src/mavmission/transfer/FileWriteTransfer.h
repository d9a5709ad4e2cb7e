// Writing a plan as a file, as a state machine. MAVLink guide, File Transfer Protocol; ArduPilot's @MISSION files.
//
//             it is open           every item           the header            it is closed
//   Creating ------------> Items ------------> Heading ------------> Closing --------------> done
//    | CreateFile           | WriteFile, each   | WriteFile           | TerminateSession
//    |                      | until answered    |                     |
//    v                      v                   v                     v
//   NoAnswer: no FTP       TimedOut            Unconfirmed           Unconfirmed
//
// The header is written last: a file without one is not stored, whoever closes it. So the old plan is aboard until the
// header has left.
#pragma once

#include <stdint.h>

#include "../base/Pace.h"
#include "../base/RetryRules.h"
#include "../base/Status.h"

namespace mavmission {
namespace detail {

class FileWriteTransfer : public FileRules {
 public:
  enum class State : uint8_t { Creating, Items, Heading, Closing };

  // A request, and for Items the items that it writes.
  struct Request {
    uint16_t sequence;
    uint16_t first;
    uint8_t count;
  };
  static constexpr uint8_t kMostItems = 6;  // in one write: as many as fit

  void begin(uint16_t count);

  // The inputs. onAnswer(): `sequence` is that of the request; true if the file is closed now.
  bool isOpen(uint16_t sequence) const;
  bool onAnswer(uint16_t sequence, uint16_t nowMs, Pace& pace);
  Status onTime(uint16_t nowMs, const Pace& pace);

  // The output: whether a request is due, and which. One that is sent for the first time gets its number from
  // `lastSequence`. onLeft() says that its last byte has been handed over.
  bool isDue() const { return due() < kSlots; }
  const Request& begun(uint16_t& lastSequence);
  bool isLeaving() const { return leaving_ < kSlots; }
  void onLeft(uint16_t nowMs);

  State state() const { return state_; }
  uint16_t itemsWritten() const { return written_; }

 private:
  static constexpr uint8_t kSlots = 2;
  enum class Phase : uint8_t { Idle, Due, Sent };

  // A request that has not been answered; of Items, which go out one by one or all at once, it has `left`.
  struct Slot {
    Request request;
    uint16_t sentMs;
    uint8_t left;
    uint8_t tries;
    Phase phase;
  };

  uint8_t due() const;
  uint8_t slotOf(uint16_t sequence) const;
  void enter(State state);
  void makeDue(Slot& slot);
  void fillSlots(const Pace& pace);

  Slot slots_[kSlots];
  uint16_t count_;
  uint16_t next_;  // the first item that no slot has had
  uint16_t written_;
  uint8_t leaving_;
  bool isQuick_;
  bool isLossy_;
  State state_;
};

}  // namespace detail
}  // namespace mavmission
