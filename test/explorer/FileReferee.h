// What PlanFiles may send, and what it may say at the end, while a plan goes by file: kept apart from the code under
// test, by what was heard (undamaged) and sent alone. Every breach has its sentence.
#pragma once

#include <type_traits>

#include "FileWords.h"
#include "Referee.h"

struct FileReferee {
  // A request that has not been answered.
  struct Asked {
    uint32_t what;  // FileWords; 0: none
    uint16_t number;
    uint16_t sinceMs;  // since it was sent last, kWriteMs at most
  };
  static constexpr uint16_t kOpenMs = 600, kWriteMs = 1000,
                            kReadMs = 250,  // Twice the way there and back, which the client may just have measured.
      kHurriedMs = 2 * 20;
  static constexpr int kMostOpen = 2;
  static constexpr uint8_t kKnown = 2, kUnsureClosings = 5;

  Asked open[kMostOpen];
  uint16_t latest;   // the number of the newest request
  uint16_t opening;  // the number of the request that opened the file
  uint8_t session;
  uint8_t isRunning;  // an operation goes by file
  uint8_t mayBeOpen;  // the file, by us; kKnown: that was answered
  uint8_t isOpen;     // the operation has opened it
  uint8_t written;    // bit i: the writing of item i was answered
  uint8_t isHeaderSent;
  uint8_t isHeaderWritten;
  uint8_t isClosed;    // behind the header
  uint8_t isCounted;   // the header of the plan aboard was read, in verifying or behind the closing
  uint8_t read;        // bit i: item i was
  uint8_t mayCancel;   // the sketch has broken the read-back off
  uint8_t isStorable;  // the file that may be open has its header
  uint8_t hasSent;     // a request of this operation
  uint8_t even[2];     // always 0: without a hole, states can be compared by their bytes
  uint8_t closings;    // TERMINATEs, and headers withdrawn after the end, since it was opened, kUnsureClosings at most

  void begin();
  // What was open before is to be closed, if it has its header, not as it is.
  void beginBehindReset();
  void pass(uint16_t ms);
  void renumber(uint16_t by);
  // Each: null, or what was broken.
  const char* sent(const Message& message, const Referee& referee);
  void heard(const Message& message);
  // A file that was never known to be open need not be closed for ever; and one whose opening the line has delayed past
  // its closing is known to nobody.
  bool mayLeaveOpen() const { return mayBeOpen == 0 || (mayBeOpen != kKnown && closings == kUnsureClosings); }
  // As Referee::end(). `before` is null where an earlier operation's file may have been open.
  const char* end(mavmission::Status status, mavmission::Aboard said, const Referee& referee,
                  const Autopilot& autopilot, const Autopilot* before);

 private:
  const char* sentAnew(const Message& message, const FileWords& words, const Referee& referee);
  const char* untrue(mavmission::Status status, mavmission::Aboard said, const Task& task, const Autopilot& autopilot,
                     const Autopilot* before) const;
};
static_assert(std::has_unique_object_representations<FileReferee>::value, "folded by its bytes");
