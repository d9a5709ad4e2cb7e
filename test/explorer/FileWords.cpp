#include "FileWords.h"

#include <string.h>

#include "Plans.h"
#include "mavmission/files/FileFrame.h"

namespace {

using mavmission::detail::FileFrame;
using mavmission::detail::FileHeader;
using mavmission::detail::kFileHeader;
using mavmission::detail::kFileItem;

constexpr uint8_t kAck = 128, kNak = 129, kOtherComponent = 191;
const char kName[] = "@MISSION/mission.dat";

// The data of a message.
Bytes dataIn(const Bytes& payload, size_t at, size_t size) {
  const auto begin = payload.begin() + static_cast<long>(FileFrame::kHead + at);
  return Bytes(begin, begin + static_cast<long>(size));
}

uint32_t offsetOf(const FileWords& words) {
  return words.isHeader() ? 0 : static_cast<uint32_t>(kFileHeader + words.first * kFileItem);
}

// The plan whose items these are, each at its place; or 255. Home alone is of any plan.
uint8_t planOf(const Bytes& payload, uint8_t first, uint8_t count, Firmwares firmware) {
  uint8_t plan = 0;
  for (uint8_t i = 0; i < count; ++i) {
    const Bytes bytes = dataIn(payload, i * kFileItem, kFileItem);
    const uint8_t item = itemIn(bytes, firmware), place = static_cast<uint8_t>(first + i);
    if (item == kNoItemAtAll || messageIn<mavlink_mission_item_int_t>(bytes).seq != place) return 255;
    if (place == 0 && item == kHome) continue;
    plan = static_cast<uint8_t>(item / 16);
    if (place == 0 || item != itemOf(plan, static_cast<uint8_t>(place - 1))) return 255;
  }
  return plan;
}

const char* decodeWrite(const Bytes& payload, Firmwares firmware, FileWords& words, Message& decoded) {
  const FileFrame frame = messageIn<FileFrame>(payload);
  const uint8_t size = frame.size;
  const uint32_t offset = frame.offset;
  if (offset == 0) {
    words.first = FileWords::kHeader;
    words.count = FileWords::kWithdrawn;
    if (size == kFileHeader && dataIn(payload, 0, size) == Bytes(size, 0)) return nullptr;
    const FileHeader header = messageIn<FileHeader>(dataIn(payload, 0, kFileHeader));
    if (size != kFileHeader || header.magic != FileHeader::kMagic || header.type != 0 || header.options != 0 ||
        header.start != 0 || header.count >= FileWords::kWithdrawn) {
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
  if (hasPlace && words.isHeader() && words.count == FileWords::kWithdrawn)
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
  FileFrame frame = FileFrame();
  frame.system = 1;
  frame.component = kOtherComponent;
  frame.sequence = message.number;
  frame.session = words.session;
  frame.opcode = words.error == 0 ? kAck : kNak;
  frame.requested = words.opcode;
  const bool isRead = words.opcode == kFileRead || words.opcode == kFileBurst;
  Bytes data;
  if (words.error != 0) {
    data.push_back(words.error);
  } else if (isRead && words.isHeader()) {
    FileHeader header = FileHeader();
    header.magic = FileHeader::kMagic;
    header.count = words.count;
    data = bytesOf(header);
  } else if (isRead) {
    data = payloadOf(message.item, words.first, kMission, firmware, true);
  }
  if (words.error == 0 && (isRead || words.opcode == kFileWrite)) frame.offset = offsetOf(words);
  frame.size = static_cast<uint8_t>(data.size());
  Bytes payload = bytesOf(frame);
  payload.resize(FileFrame::kHead);
  payload = payload + data;
  while (payload.size() > 1 && payload.back() == 0) payload.pop_back();
  return payload;
}

const char* decodeFile(const Bytes& payload, Firmwares firmware, Message& decoded) {
  const FileFrame frame = messageIn<FileFrame>(payload);
  const uint8_t size = frame.size;
  const uint32_t offset = frame.offset;
  FileWords words = FileWords();
  words.session = frame.session;
  words.opcode = frame.opcode;
  if (frame.network != 0 || frame.requested != 0 || frame.isBurstComplete != 0 || frame.padding != 0 || offset > 0xFFFF)
    return "a request of FTP is sent with a field that must be 0";
  decoded = message(Kind::File, frame.sequence);
  const char* broken = nullptr;
  switch (words.opcode) {
    case kFileTerminate: break;
    case kFileOpen:
    case kFileCreate:
      if (size != sizeof(kName) - 1 || dataIn(payload, 0, sizeof(kName)) != Bytes(kName, kName + sizeof(kName)) ||
          offset != 0)
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
