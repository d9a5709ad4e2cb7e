// What the protocol allows a client to send, and what it may say at the end: kept apart from the code under test, by
// what the client has heard (undamaged) and sent alone. Every breach has its sentence.
#pragma once

#include <stdint.h>

#include <type_traits>

#include "Autopilot.h"
#include "mavmission/base/Status.h"

enum class Operation : uint8_t {
  Upload,
  UploadInDoubt,
  UploadVerified,
  Ensure,
  Download,
  Verify,
  Clear,
  FileUpload,  // PlanFiles': a FileReferee judges them for as long as they go by file
  FileVerify,
};

constexpr const char* kOperations[] = {"upload", "upload-in-doubt", "upload-verified", "ensure",     "download",
                                       "verify", "clear",           "file-upload",     "file-verify"};

inline bool isByFiles(Operation operation) { return operation >= Operation::FileUpload; }

// Plan `plan` with `items` items, or what is to be read.
struct Task {
  Operation operation;
  uint8_t plan;
  uint8_t items;
  uint8_t type;  // MAV_MISSION_TYPE
};

struct Referee {
  static constexpr uint8_t kHurriedBefore = 2;
  static constexpr uint8_t kTries = 5, kItemTries = 8, kMostUnderWay = 5, kJustNow = 1, kBefore = 2;
  static constexpr uint16_t kAnswerMs = 1500, kItemMs = 250, kSilenceMs = 8500, kCountingMs = 7500,
                            kConfirmingMs = 9000;
  // From a message to its repeat on a line that has been seen to lose.
  static constexpr uint16_t kHurriedMs = 5 * 80;
  // A round trip: a request that is repeated sooner was sent before its answer arrived.
  static constexpr uint16_t kSameRequestMs = 200;
  // An autopilot that asks for an older item so long behind a newer one has begun again.
  static constexpr uint16_t kLateRequestMs = 500;
  // PX4's error so long behind the newest request answers an item of this transfer, which is over.
  static constexpr uint16_t kLateErrorMs = 2600;
  // From the first sending of an item to the last answer to what was sent before.
  static constexpr uint16_t kLastAnswerMs = 250;

  Task task;
  uint8_t items;  // of the plan on the wire
  uint8_t isRunning;
  mavmission::Status ended;
  uint8_t counts;     // COUNTs in a row, since an older transfer was cancelled first
  uint8_t asked;      // items asked for, or presumed to be waited for, in their order
  uint8_t current;    // the item that was asked for last, or is presumed to be waited for, one more
  uint8_t heardLast;  // the item that was asked for last, one more
  uint8_t open;       // bit i: item i was asked for, and has not been sent since
  uint8_t sentItem;   // the item sent last, one more
  uint8_t isLastSent : 2;
  uint8_t hasSent : 2;     // a frame of this operation
  uint8_t isPresumed : 4;  // the autopilot has the current item, by its INVALID_SEQUENCE
  uint8_t hasFreed;        // an older transfer was cancelled last: never (0), kJustNow, or kBefore the last COUNT
  uint8_t isReading : 4;
  uint8_t isLooking : 4;   // ensure() reads, and has not begun to upload
  uint8_t lists;           // REQUEST_LISTs sent
  uint8_t isCounted;       // COUNT was heard
  uint8_t announced;       // how many items
  uint8_t received;        // items heard in their order
  uint8_t requests : 4;    // for the next item
  uint8_t underWay : 4;    // items that are asked for, from the next one on
  uint8_t isClosed;        // our final ACK was sent
  uint8_t clears;          // CLEAR_ALLs sent
  uint8_t owesCancel;      // the autopilot is to be told that it is over: 1 + the plan's type
  uint8_t wasRefused;      // ERROR was heard before the plan was read back
  uint8_t mayFree : 4;     // what shows that an older transfer is open was heard
  uint8_t hasOther : 4;    // it requests items that the plan does not have
  uint8_t hasEndedOne;     // an operation of this client has ended, since the Arduino was reset
  uint8_t hasEndedBefore;  // before this one
  uint8_t isHurried;       // the client takes the line for one that loses: 1, or kHurriedBefore this step
  uint8_t copies;          // of the current item, since it is current; 2 at most
  uint8_t mayGoOn;         // what was written as a file is read back, and may be uploaded item by item
  uint8_t isUnasked : 4;   // the current item was sent again without being asked for
  uint8_t isOver : 4;      // PX4's error to that was heard
  uint16_t heardAcks;      // bit r: ACK r was heard
  uint16_t sinceFirstMs;   // since the first of `copies`, kLastAnswerMs at most
  uint16_t sinceSentMs;    // since the last frame of ours, 1500 at most
  uint16_t sinceNewMs;  // since the first COUNT, or since an item was asked for that had not been before, 9000 at most

  void begin(const Task& task, Firmwares firmware);
  // What went by file goes on by the mission protocol. `isProof`: to read back what was written.
  void goOnByItems(bool isProof);
  void pass(uint16_t ms);
  // Each: null, or what was broken.
  const char* sent(const Message& message, Firmwares firmware);
  void heard(const Message& message, Firmwares firmware);
  // `said`: aboard(). `before`: the autopilot as it was when the operation began; null where an earlier operation's
  // frames may still have been on their way to it. `lineRepeats`: frames are repeated or delayed.
  const char* end(mavmission::Status status, mavmission::Aboard said, const Autopilot& autopilot,
                  const Autopilot* before, bool lineRepeats);
  bool isUpload() const { return task.operation <= Operation::Ensure; }
  bool isUploading() const { return isUpload() && !isReading; }  // and not reading what is aboard

 private:
  // An ACK with this result.
  bool hasHeard(uint8_t result) const { return (heardAcks & (1u << result)) != 0; }
  // By what was heard, or by the silence: an unknown server has no transfer any more.
  bool isGivenUp() const { return hasHeard(kInvalidSequence) || hasHeard(kCancelled) || sinceNewMs >= kSilenceMs; }
  uint16_t againMs(uint16_t otherwiseMs) const { return isHurried ? kHurriedMs : otherwiseMs; }
  const char* untrueAboard(mavmission::Status status, mavmission::Aboard said, const Autopilot& autopilot,
                           const Autopilot* before) const;
  void goOn();
  const char* sentWhile(const Message& message, Firmwares firmware);
  const char* sentInUpload(const Message& message);
  const char* sentInReading(const Message& message, Firmwares firmware);
};
static_assert(std::has_unique_object_representations<Referee>::value, "folded by its bytes");
