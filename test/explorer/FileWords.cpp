#include "FileWords.h"

#include <string.h>

#include "Plans.h"
#include "mavmission/files/FileFrame.h"

namespace {

using mavmission::detail::FileHeader;
using mavmission::detail::kFileHeader;
using mavmission::detail::kFileItem;

// The payload: target_network, target_system, target_component, then the fields of the request.
constexpr size_t kSequence = 3, kSession = 5, kOpcode = 6, kSize = 7, kRequested = 8, kOffset = 11, kData = 15;
constexpr uint8_t kAck = 128, kNak = 129, kOtherComponent = 191;
const char kName[] = "@MISSION/mission.dat";

void put(Bytes& bytes, size_t at, uint32_t value, int count) {
  for (int i = 0; i < count; ++i) bytes[at + static_cast<size_t>(i)] = static_cast<uint8_t>(value >> 8 * i);
}

uint16_t wordAt(const Bytes& bytes, size_t at) { return static_cast<uint16_t>(bytes[at] | bytes[at + 1] << 8); }

uint32_t offsetOf(const FileWords& words) {
  return words.isHeader() ? 0 : static_cast<uint32_t>(kFileHeader + words.first * kFileItem);
}

// The plan whose items these are, each at its place; or 255. Home alone is of any plan.
uint8_t planOf(const Bytes& payload, uint8_t first, uint8_t count, Firmwares firmware) {
  uint8_t plan = 0;
  for (uint8_t i = 0; i < count; ++i) {
    const auto begin = payload.begin() + static_cast<long>(kData + i * kFileItem);
    const Bytes bytes(begin, begin + kFileItem);
    const uint8_t item = itemIn(bytes, firmware), place = static_cast<uint8_t>(first + i);
    if (item == kNoItemAtAll || wordAt(bytes, 28) != place) return 255;
    if (place == 0 && item == kHome) continue;
    plan = static_cast<uint8_t>(item / 16);
    if (place == 0 || item != itemOf(plan, static_cast<uint8_t>(place - 1))) return 255;
  }
  return plan;
}

const char* decodeWrite(const Bytes& payload, Firmwares firmware, FileWords& words, Message& decoded) {
  const uint8_t size = payload[kSize];
  const uint32_t offset = wordAt(payload, kOffset);
  if (offset == 0) {
    FileHeader header;
    words.first = FileWords::kHeader;
    words.count = FileWords::kSpoilt;
    if (size == kFileHeader && Bytes(payload.begin() + kData, payload.begin() + kData + kFileHeader) == Bytes(size, 0))
      return nullptr;
    memcpy(&header, payload.data() + kData, sizeof(header));
    if (size != kFileHeader || header.magic != FileHeader::kMagic || header.type != 0 || header.options != 0 ||
        header.start != 0 || header.count >= FileWords::kSpoilt) {
      return "a wrong header is written";
    }
    words.count = static_cast<uint8_t>(header.count);
    return nullptr;
  }
  if (size == 0 || size % kFileItem != 0 || offset < kFileHeader || (offset - kFileHeader) % kFileItem != 0)
    return "what is written is not whole items";
  words.first = static_cast<uint8_t>((offset - kFileHeader) / kFileItem);
  words.count = size / kFileItem;
  decoded.item = planOf(payload, words.first, words.count, firmware);
  return decoded.item == 255 ? "what is written is no plan's" : nullptr;
}

}  // namespace

std::string fileInWords(const Message& message) {
  const FileWords words = wordsOf(message);
  std::string text = message.kind == Kind::FileReply ? (words.error == 0 ? "ACK of " : "NAK of ") : "";
  switch (words.opcode) {
    case kFileTerminate: text += "TERMINATE"; break;
    case kFileOpen: text += "OPEN"; break;
    case kFileRead: text += "READ"; break;
    case kFileCreate: text += "CREATE"; break;
    case kFileWrite: text += "WRITE"; break;
    default: text += "BURST"; break;
  }
  const bool hasPlace = words.opcode == kFileRead || words.opcode == kFileWrite || words.opcode == kFileBurst;
  if (hasPlace && words.isHeader() && words.count == FileWords::kSpoilt)
    text += " of zeros in the place of the header,";
  else if (hasPlace && words.isHeader())
    text += " of the header, " + std::to_string(words.count) + " items,";
  if (hasPlace && !words.isHeader())
    text += " of " + std::to_string(words.count) + " items from " + std::to_string(words.first) + " on,";
  if (words.error != 0) text += " error " + std::to_string(words.error) + ",";
  return text + " #" + std::to_string(message.number) + " of session " + std::to_string(words.session);
}

Bytes fileReplyPayload(const Message& message, Firmwares firmware) {
  const FileWords words = wordsOf(message);
  Bytes payload(kData, 0);
  payload[1] = 1;
  payload[2] = kOtherComponent;
  put(payload, kSequence, message.number, 2);
  payload[kSession] = words.session;
  payload[kOpcode] = words.error == 0 ? kAck : kNak;
  payload[kRequested] = words.opcode;
  Bytes data;
  if (words.error != 0) {
    data.push_back(words.error);
  } else if (words.opcode == kFileRead || words.opcode == kFileBurst) {
    if (words.isHeader()) {
      data.resize(kFileHeader);
      put(data, 0, FileHeader::kMagic, 2);
      put(data, 8, words.count, 2);
    } else {
      data = payloadOf(message.item, words.first, kMission, firmware, true);
    }
    put(payload, kOffset, offsetOf(words), 4);
  } else if (words.opcode == kFileWrite) {
    put(payload, kOffset, offsetOf(words), 4);
  }
  payload[kSize] = static_cast<uint8_t>(data.size());
  payload.insert(payload.end(), data.begin(), data.end());
  while (payload.size() > 1 && payload.back() == 0) payload.pop_back();
  return payload;
}

const char* decodeFile(const Bytes& payload, Firmwares firmware, Message& decoded) {
  FileWords words = FileWords();
  words.session = payload[kSession];
  words.opcode = payload[kOpcode];
  const uint8_t size = payload[kSize];
  const uint32_t offset = wordAt(payload, kOffset);
  if (payload[0] != 0 || payload[kRequested] != 0 || payload[9] != 0 || payload[10] != 0 || wordAt(payload, 13) != 0)
    return "a request of FTP is sent with a field that must be 0";
  decoded = message(Kind::File, wordAt(payload, kSequence));
  const char* broken = nullptr;
  switch (words.opcode) {
    case kFileTerminate: break;
    case kFileOpen:
    case kFileCreate:
      if (size != sizeof(kName) - 1 || memcmp(payload.data() + kData, kName, sizeof(kName)) != 0 || offset != 0)
        broken = "a file with a wrong name is opened";
      break;
    case kFileWrite: broken = decodeWrite(payload, firmware, words, decoded); break;
    case kFileRead:
    case kFileBurst:
      words.first = offset == 0 ? FileWords::kHeader : static_cast<uint8_t>((offset - kFileHeader) / kFileItem);
      if (offset != offsetOf(words) || size != (words.isHeader() ? kFileHeader : kFileItem))
        broken = "what is read is not an item";
      break;
    default: return "a request of FTP is sent that has no place in these operations";
  }
  decoded.opaqueId = words.packed();
  return broken;
}
