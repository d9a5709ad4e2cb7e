// What a request of MAVLink FTP or its answer says, as far as plans go; it lies in a Message's `opaqueId`.
#pragma once

#include <stdint.h>

#include "Message.h"

enum FileOpcode : uint8_t {
  kFileTerminate = 1,
  kFileOpen = 4,
  kFileRead = 5,
  kFileCreate = 6,
  kFileWrite = 7,
  kFileBurst = 15,
};
enum FileError : uint8_t { kFileFail = 1, kFileInvalidSession = 4, kFileEnd = 6, kFileNotFound = 10 };

struct FileWords {
  static constexpr uint8_t kHeader = 15;     // as `first`: the header of the file
  static constexpr uint8_t kWithdrawn = 14;  // as `count` of a header that is written: zeros, which no plan has

  uint8_t opcode;   // of the request
  uint8_t session;  // of the request
  uint8_t first;    // the item that the piece of the file begins with
  uint8_t count;    // items in the piece; of a header: items that it announces
  uint8_t error;    // of an answer: 0 is ACK

  bool isHeader() const { return first == kHeader; }
  uint32_t packed() const {
    return static_cast<uint32_t>(opcode | session << 4 | first << 12 | count << 16 | error << 20);
  }
};

inline FileWords wordsOf(const Message& message) {
  const uint32_t bits = message.opaqueId;
  return FileWords{static_cast<uint8_t>(bits & 15), static_cast<uint8_t>(bits >> 4),
                   static_cast<uint8_t>(bits >> 12 & 15), static_cast<uint8_t>(bits >> 16 & 15),
                   static_cast<uint8_t>(bits >> 20 & 15)};
}

inline bool isOfFiles(const Message& message) { return message.kind == Kind::File || message.kind == Kind::FileReply; }

// "WRITE 2 items from 0 on, #3 of session 90" and the like.
std::string fileInWords(const Message& message);

// The payload of the answer `message`, zeros at its end left out.
Bytes fileReplyPayload(const Message& message, Firmwares firmware);

// The request in a payload of FILE_TRANSFER_PROTOCOL. Null, or what is wrong with it.
const char* decodeFile(const Bytes& payload, Firmwares firmware, Message& decoded);
