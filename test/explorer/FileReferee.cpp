#include "FileReferee.h"

#include <string.h>

#include <algorithm>

using mavmission::Aboard;
using mavmission::Status;

namespace {

uint8_t bitsOf(uint8_t first, uint8_t count) { return static_cast<uint8_t>(((1u << count) - 1) << first); }

bool isNewer(uint16_t number, uint16_t than) { return static_cast<int16_t>(number - than) > 0; }

}  // namespace

void FileReferee::begin() {
  const FileReferee before = *this;
  *this = FileReferee();
  mayBeOpen = before.mayBeOpen;
  session = before.session;
  closings = before.closings;
  isStorable = before.isStorable;
  latest = before.latest;
  opening = before.opening;
  isRunning = true;
}

void FileReferee::beginBehindReset() {
  const uint8_t storable = isStorable;
  *this = FileReferee();
  isStorable = storable;
  mayBeOpen = true;
}

void FileReferee::pass(uint16_t ms) {
  for (Asked& asked : open) {
    if (asked.what != 0) asked.sinceMs = static_cast<uint16_t>(std::min<int>(asked.sinceMs + ms, kWriteMs));
  }
}

void FileReferee::renumber(uint16_t by) {
  latest = static_cast<uint16_t>(latest - by);
  // An answer so old is none to anything.
  constexpr uint16_t kOld = 48;
  opening = static_cast<uint16_t>(std::max<int>(static_cast<int16_t>(opening - by), -kOld));
  for (Asked& asked : open) {
    if (asked.what != 0) asked.number = static_cast<uint16_t>(asked.number - by);
  }
}

const char* FileReferee::sent(const Message& message, const Referee& referee) {
  const FileWords words = wordsOf(message);
  if (words.session == 0) return "a request has no session";
  if (session != 0 && words.session != session) return "a request is of another session";
  const bool isFirst = session == 0;
  if (isRunning) hasSent = true;
  session = words.session;
  if (isFirst) opening = static_cast<uint16_t>(message.number - 1);
  for (Asked& asked : open) {
    if (asked.what == 0 || asked.number != message.number) continue;
    if (asked.what != message.opaqueId) return "a number is used for two requests";
    const bool isRead = words.opcode == kFileRead;
    const bool isOpening = words.opcode == kFileOpen || words.opcode == kFileCreate;
    const uint16_t waitMs = referee.isHurried ? kHurriedMs : isOpening ? kOpenMs : isRead ? kReadMs : kWriteMs;
    if (asked.sinceMs < waitMs) return "a request is repeated too early";
    asked.sinceMs = 0;
    return nullptr;
  }
  if (!isFirst && !isNewer(message.number, latest)) return "a number is used again";
  const char* const broken = sentAnew(message, words, referee);
  if (broken != nullptr) return broken;
  latest = message.number;
  for (Asked& asked : open) {
    if (asked.what != 0) continue;
    asked = Asked{message.opaqueId, message.number, 0};
    return nullptr;
  }
  return "a third request is sent before an answer to the first";
}

const char* FileReferee::sentAnew(const Message& message, const FileWords& words, const Referee& referee) {
  const bool isUpload = isRunning && referee.task.operation == Operation::FileUpload;
  const bool isWriting = isUpload && !isClosed;
  for (const Asked& asked : open) {
    const bool isOfRunning = isRunning && words.opcode != kFileBurst;
    if (asked.what == message.opaqueId && isOfRunning) return "a request is repeated under a number of its own";
  }
  const bool isWithdrawn = words.opcode == kFileWrite && words.isHeader() && words.count == FileWords::kWithdrawn;
  if (words.opcode != kFileTerminate && !isWithdrawn && !isRunning) return "a request is sent after the end";
  if (words.opcode != kFileWrite || isWithdrawn) memset(static_cast<void*>(open), 0, sizeof(open));
  switch (words.opcode) {
    case kFileCreate:
    case kFileOpen:
      if (isWriting != (words.opcode == kFileCreate)) return "a file is opened in the wrong way";
      if (isOpen) return "a file is opened that is open";
      mayBeOpen = std::max<uint8_t>(mayBeOpen, 1);
      closings = 0;
      opening = message.number;
      return nullptr;

    case kFileWrite:
      if (isWithdrawn) {
        if (closings < kUnsureClosings) ++closings;
        return isRunning ? "a header is withdrawn" : nullptr;
      }
      if (!isOpen || !isWriting) return "it is written to a file that is not open";
      if (words.isHeader()) {
        if (words.count != referee.items) return "the header has a wrong number of items";
        if (written != bitsOf(0, referee.items)) return "the header is written before each item is answered";
        isHeaderSent = isStorable = true;
        return nullptr;
      }
      if (message.item != 0 && message.item != referee.task.plan) return "an item is written that is not the plan's";
      if (words.first + words.count > referee.items) return "an item beyond the plan is written";
      if (isHeaderSent) return "an item is written behind the header";
      // Where the line is seen to lose, several items go one by one.
      for (Asked& asked : open) {
        const FileWords before = wordsOf(::message(Kind::File, 0, 0, asked.what));
        if (asked.what == 0 || before.first != words.first) continue;
        if (before.count == 1 || words.count != 1 || !referee.isHurried) return "an item is written in another way";
        asked = Asked{0, 0, 0};
      }
      return nullptr;

    case kFileRead:
    case kFileBurst:
      if (!isOpen || isWriting) return "it is read from a file that is not open";
      return nullptr;

    default:  // TERMINATE
      if (isWriting && !isHeaderWritten) return "the file is closed before its header is answered";
      if (!isRunning && isStorable) return "a plan is stored after the end";
      if (!mayBeOpen) return "a session is ended that is not known to be open";
      if (closings < kUnsureClosings) ++closings;
      return nullptr;
  }
}

void FileReferee::heard(const Message& message) {
  const FileWords words = wordsOf(message);
  if (words.session != session || !isNewer(message.number, opening)) return;
  const bool isAck = words.error == 0;
  bool isAnswer = false;
  FileWords request = words;
  for (Asked& asked : open) {
    if (asked.what == 0 || static_cast<uint16_t>(asked.number + 1) != message.number) continue;
    isAnswer = true;
    request = wordsOf(::message(Kind::File, 0, 0, asked.what));
    if (words.opcode != kFileBurst) asked = Asked{0, 0, 0};
  }
  if (!isAck && (words.error == kFileInvalidSession || words.error == kFileNotFound)) mayBeOpen = isStorable = false;
  switch (words.opcode) {
    case kFileCreate:
    case kFileOpen:
      if (isAck && isAnswer) {
        isOpen = true;
        isStorable = false;  // one of before is closed by now
      }
      if (isAck) mayBeOpen = kKnown;
      return;
    case kFileWrite:
      if (!isAnswer) return;
      if (request.isHeader() && request.count == FileWords::kWithdrawn) {
        isStorable = false;  // refused: it is open for reading
      } else if (isAck && request.isHeader()) {
        isHeaderWritten = true;
      } else if (isAck) {
        written = static_cast<uint8_t>(written | bitsOf(request.first, request.count));
      }
      return;
    case kFileTerminate:
      mayBeOpen = isStorable = false;
      if (!isAnswer || !isRunning) return;
      isOpen = false;
      if (isHeaderWritten) isClosed = true;
      return;
    default:
      if (!isAck || !isOpen) return;
      if (words.isHeader()) {
        isCounted = true;
      } else {
        read = static_cast<uint8_t>(read | bitsOf(words.first, 1));
      }
      return;
  }
}

const char* FileReferee::untrue(Status status, Aboard said, const Task& task, const Autopilot& autopilot,
                                const Autopilot* before) const {
  const bool isMeant = autopilot.holds(task.plan, task.items);
  const bool isUpload = task.operation == Operation::FileUpload;
  const bool isAboutThis = isUpload ? hasSent != 0 : status == Status::Verified;  // something was sent
  if (said == Aboard::OurPlan && isAboutThis && !isMeant) return "aboard() says our plan, and it is not";
  if (!isUpload || !isAboutThis) return nullptr;
  const bool isOld = before == nullptr || autopilot.holdsAs(*before);
  switch (said) {
    case Aboard::OurPlan: return nullptr;
    case Aboard::AsBefore: return isOld ? nullptr : "aboard() says as before, and it is not";
    case Aboard::NotKnown:
      return isHeaderSent || isMeant ? nullptr : "aboard() does not know the old plan, which must be there";
    default: return "aboard() says what a file cannot leave";
  }
}

const char* FileReferee::end(Status status, Aboard said, const Referee& referee, const Autopilot& autopilot,
                             const Autopilot* before) {
  const Task& task = referee.task;
  const bool isMeant = autopilot.holds(task.plan, task.items);
  const bool isUpload = task.operation == Operation::FileUpload;
  isRunning = false;
  mayCancel = status == Status::Cancelled && isClosed;
  const char* const broken = untrue(status, said, task, autopilot, before);
  if (broken != nullptr) return broken;
  const bool isRead = isCounted && read == bitsOf(0, referee.items);
  switch (status) {
    case Status::Accepted:
      if (!isUpload) return "an end that this operation does not have";
      if (!isClosed) return "Accepted, and the file was not closed";
      if (!isRead) return "Accepted, and not read back";
      return isMeant ? nullptr : "Accepted, and the plan aboard is not the plan meant";
    case Status::Verified:
      if (isUpload) return "an end that this operation does not have";
      if (!isRead) return "Verified, and not read to the end";
      return isMeant ? nullptr : "Verified, and the plan aboard is not the plan meant";
    case Status::Differs:
      if (isUpload && !isClosed) return "Differs, and the file was not closed";
      return isMeant ? "Differs, and the plan aboard is the plan meant" : nullptr;
    case Status::Unconfirmed:
      if (!isUpload) return "an end that this operation does not have";
      return isHeaderSent ? nullptr : "Unconfirmed before the header was sent";
    case Status::TimedOut: return isHeaderSent ? "TimedOut behind the header" : nullptr;
    case Status::Cancelled: return nullptr;
    default: return "an end that has no place in these operations";
  }
}
