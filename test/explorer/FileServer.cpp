#include "FileServer.h"

#include <string.h>

#include <algorithm>

#include "Plans.h"

void FileServer::reboot() { memset(static_cast<void*>(this), 0, sizeof(*this)); }

void FileServer::hear(const Message& request, Autopilot& autopilot, Answers& answers) {
  const FileWords words = wordsOf(request);
  const bool isRepeat = last.kind == Kind::FileReply && wordsOf(last).session == words.session &&
                        last.number == static_cast<uint16_t>(request.number + 1);
  if (isRepeat) return answers.add(last);
  Message reply = message(Kind::FileReply, static_cast<uint16_t>(request.number + 1));
  FileWords said = words;
  said.count = 0;
  if (words.opcode == kFileTerminate) {
    if (isOpen && session == words.session) close(autopilot);
    idleInMs = 0;  // any session's end lets the next one in
  } else if (isOpen && session != words.session && idleInMs != 0) {
    said.error = kFileInvalidSession;
    idleInMs = kIdleMs;
  } else {
    if (isOpen && session != words.session) close(autopilot);
    said = done(request, said, autopilot, reply, answers);
    idleInMs = kIdleMs;
  }
  reply.opaqueId = said.packed();
  last = reply;
  answers.add(reply);
}

FileWords FileServer::done(const Message& request, const FileWords& words, const Autopilot& autopilot, Message& reply,
                           Answers& before) {
  FileWords said = words;
  const FileWords asked = wordsOf(request);
  const bool isOpening = asked.opcode == kFileOpen || asked.opcode == kFileCreate;
  const bool isWriting = asked.opcode == kFileWrite;
  if (isOpening ? isOpen : !isOpen || isWritten != isWriting) {
    said.error = isOpen ? kFileFail : kFileNotFound;
    return said;
  }
  if (isOpening) {
    isOpen = true;
    session = asked.session;
    isWritten = asked.opcode == kFileCreate;
    header = extent = 0;
    memset(items, kNoItemAtAll, sizeof(items));
    return said;
  }
  if (isWriting && asked.isHeader()) {
    const bool isWithdrawn = asked.count == FileWords::kWithdrawn;
    header = static_cast<uint8_t>(isWithdrawn ? 0 : asked.count + 1);
    if (!isWithdrawn) extent = std::max(extent, asked.count);
    return said;
  }
  if (isWriting) {
    for (uint8_t i = asked.first; i < asked.first + asked.count; ++i) {
      items[i] = i == 0 ? kHome : itemOf(request.item, static_cast<uint8_t>(i - 1));
      extent = std::max(extent, static_cast<uint8_t>(i + 1));
    }
    return said;
  }
  if (asked.isHeader()) {
    said.count = autopilot.heldCount;
    return said;
  }
  for (uint8_t i = asked.first; i < autopilot.heldCount; ++i) {
    said.first = i;
    said.count = 1;
    reply.item = autopilot.held[i];
    if (asked.opcode == kFileRead) return said;
    reply.opaqueId = said.packed();
    before.add(reply);
    ++reply.number;
  }
  reply.item = 0;
  said.count = 0;
  said.error = kFileEnd;
  return said;
}

// Nobody learns what becomes of it but by looking.
void FileServer::close(Autopilot& autopilot) {
  const bool isComplete = isWritten && header != 0 && extent + 1 == header &&
                          std::find(items, items + extent, kNoItemAtAll) == items + extent;
  if (isComplete) {
    const bool isRefused = autopilot.refused != 0 && autopilot.refused < extent;
    const uint8_t stored = isRefused ? autopilot.refused : extent;
    autopilot.heldCount = stored;
    for (uint8_t i = 0; i < kMostHeld; ++i) autopilot.held[i] = i < stored ? items[i] : kNoItemAtAll;
  }
  isOpen = isWritten = session = header = extent = 0;
  memset(items, kNoItemAtAll, sizeof(items));
}
