#include "Frames.h"

#include <stdexcept>

#include "mavmission/base/Checksum.h"
#include "mavmission/base/MavlinkHeaders.h"

using mavmission::detail::FrameParser;

Bytes operator+(const Bytes& left, const Bytes& right) {
  Bytes both = left;
  both.insert(both.end(), right.begin(), right.end());
  return both;
}

Bytes packed(const FrameParts& parts) {
  const uint8_t length = static_cast<uint8_t>(parts.payload.size());
  const uint8_t id = static_cast<uint8_t>(parts.messageId);
  Bytes frame;
  if (parts.version == 1) {
    frame = {0xFE, length, parts.sequence, parts.systemId, parts.componentId, id};
  } else {
    frame = {0xFD,
             length,
             parts.incompatibility,
             parts.compatibility,
             parts.sequence,
             parts.systemId,
             parts.componentId,
             id,
             static_cast<uint8_t>(parts.messageId >> 8),
             static_cast<uint8_t>(parts.messageId >> 16)};
  }
  uint16_t crc = mavmission::detail::kChecksumStart;
  crc = mavmission::detail::checksum(crc, &frame[1], static_cast<uint8_t>(frame.size() - 1));
  crc = mavmission::detail::checksum(crc, parts.payload.data(), length);
  crc = mavmission::detail::checksum(crc, &parts.crcExtra, 1);
  frame.insert(frame.end(), parts.payload.begin(), parts.payload.end());
  frame.push_back(static_cast<uint8_t>(crc));
  frame.push_back(static_cast<uint8_t>(crc >> 8));
  if (parts.incompatibility & 1) frame.resize(frame.size() + 13, 0x5A);
  return frame;
}

uint8_t crcExtraOf(uint32_t messageId) {
  const mavlink_msg_entry_t* const entry = mavlink_get_msg_entry(messageId);
  return entry == nullptr ? uint8_t{0} : entry->crc_extra;
}

FrameIn frameAt(const Bytes& bytes, size_t at) {
  FrameIn found;
  if (at >= bytes.size() || (bytes[at] != 0xFD && bytes[at] != 0xFE)) return found;
  const bool isV2 = bytes[at] == 0xFD;
  const size_t header = isV2 ? 10 : 6;
  if (bytes.size() - at < header || bytes.size() - at < header + bytes[at + 1] + 2) return found;
  found.size = header + bytes[at + 1] + 2;
  const uint8_t* const frame = &bytes[at];
  FrameParts& parts = found.parts;
  parts.messageId = isV2 ? static_cast<uint32_t>(frame[7] | frame[8] << 8 | frame[9] << 16) : frame[5];
  parts.version = isV2 ? 2 : 1;
  parts.sequence = frame[isV2 ? 4 : 2];
  parts.systemId = frame[isV2 ? 5 : 3];
  parts.componentId = frame[isV2 ? 6 : 4];
  parts.payload.assign(frame + header, frame + found.size - 2);
  parts.payload.resize(255, 0);
  parts.crcExtra = crcExtraOf(parts.messageId);
  uint16_t crc = X25_INIT_CRC;
  for (size_t i = 1; i < found.size - 2; ++i) crc_accumulate(frame[i], &crc);
  crc_accumulate(parts.crcExtra, &crc);
  found.isRight = mavlink_get_msg_entry(parts.messageId) != nullptr && frame[found.size - 2] == (crc & 0xFF) &&
                  frame[found.size - 1] == crc >> 8;
  return found;
}

std::vector<FrameIn> FrameCutter::take(const Bytes& bytes) {
  std::vector<FrameIn> found;
  const size_t before = unread_.size();
  unread_.insert(unread_.end(), bytes.begin(), bytes.end());
  size_t at = 0;
  for (; at < unread_.size(); ++at) {
    if (unread_[at] == 0) continue;
    FrameIn frame = frameAt(unread_, at);
    if (unread_[at] != 0xFD && unread_[at] != 0xFE) throw std::runtime_error("what is sent is no MAVLink frame");
    if (frame.size == 0) break;
    const auto begin = unread_.begin() + static_cast<long>(at);
    frame.bytes.assign(begin, begin + static_cast<long>(frame.size));
    at += frame.size - 1;
    frame.end = at + 1 - before;
    found.push_back(std::move(frame));
  }
  unread_.erase(unread_.begin(), unread_.begin() + static_cast<long>(at));
  return found;
}

FrameParts heartbeatParts(uint8_t autopilot, uint8_t baseMode, uint32_t mode, uint8_t type, uint8_t state) {
  mavlink_heartbeat_t message = mavlink_heartbeat_t();
  message.custom_mode = mode;
  message.type = type;
  message.autopilot = autopilot;
  message.base_mode = baseMode;
  message.system_status = state;
  message.mavlink_version = 3;
  return FrameParts(MAVLINK_MSG_ID_HEARTBEAT, message);
}

FrameParts requestParts(uint16_t item, uint8_t targetSystem, uint8_t targetComponent, uint8_t type) {
  return FrameParts(
      51, {static_cast<uint8_t>(item), static_cast<uint8_t>(item >> 8), targetSystem, targetComponent, type}, 196);
}

FrameParts ackParts(uint8_t result, uint8_t targetSystem, uint8_t targetComponent, uint8_t type, uint32_t opaqueId) {
  return FrameParts(
      47,
      {targetSystem, targetComponent, result, type, static_cast<uint8_t>(opaqueId), static_cast<uint8_t>(opaqueId >> 8),
       static_cast<uint8_t>(opaqueId >> 16), static_cast<uint8_t>(opaqueId >> 24)},
      153);
}

namespace {
Bytes numbered(FrameParts parts, uint8_t sequence) {
  parts.sequence = sequence;
  return packed(parts);
}
}  // namespace

Bytes heartbeat(uint8_t sequence) { return numbered(heartbeatParts(), sequence); }
Bytes request(uint16_t item, uint8_t sequence) { return numbered(requestParts(item), sequence); }
Bytes ack(uint8_t result, uint8_t sequence) { return numbered(ackParts(result), sequence); }

Bytes telemetry(uint8_t length, uint8_t fill, uint8_t version) {
  FrameParts parts(30, Bytes(length, fill), 39);
  parts.version = version;
  return packed(parts);
}

ParserUnderTest::ParserUnderTest() { memset(static_cast<void*>(&parser_), 0, sizeof(parser_)); }

void ParserUnderTest::note(FrameParser::Result result, std::vector<Found>& found) {
  if (result == FrameParser::Result::Nothing || result == FrameParser::Result::Signature) return;
  Found frame = {result, 0, 0, parser_.sequence(), parser_.systemId(), parser_.componentId(), Bytes()};
  if (result == FrameParser::Result::Wanted) {
    frame.messageId = parser_.messageId();
    frame.version = parser_.version();
    frame.payload.assign(parser_.payload(), parser_.payload() + parser_.length());
  }
  found.push_back(frame);
}

std::vector<Found> ParserUnderTest::take(const Bytes& bytes) {
  std::vector<Found> found;
  for (uint8_t byte : bytes) {
    note(parser_.take(byte), found);
    while (parser_.hasWaiting()) note(parser_.takeWaiting(), found);
  }
  return found;
}

std::vector<Found> ParserUnderTest::silence() {
  std::vector<Found> found;
  while (!parser_.isIdle()) {
    note(parser_.silence(), found);
    while (parser_.hasWaiting()) note(parser_.takeWaiting(), found);
  }
  return found;
}

std::vector<Found> wanted(const std::vector<Found>& found) {
  std::vector<Found> kept;
  for (const Found& frame : found) {
    if (frame.result == FrameParser::Result::Wanted) kept.push_back(frame);
  }
  return kept;
}

std::string textOf(const std::vector<Found>& found) {
  std::string text;
  for (const Found& frame : found) {
    if (!text.empty()) text += ", ";
    const Bytes payload = frame.payload + Bytes(8, 0);
    if (frame.result != FrameParser::Result::Wanted) {
      text += "other";
    } else if (frame.messageId == 0) {
      text += "heartbeat";
    } else if (frame.messageId == 40 || frame.messageId == 51) {
      text += "request " + std::to_string(payload[0] | payload[1] << 8);
    } else if (frame.messageId == 47) {
      text += "ack " + std::to_string(payload[2]);
    } else {
      text += "message " + std::to_string(frame.messageId);
    }
  }
  return text;
}

std::string wantedIn(const Bytes& bytes) {
  ParserUnderTest parser;
  std::vector<Found> found = parser.take(bytes);
  for (const Found& frame : parser.silence()) found.push_back(frame);
  return textOf(wanted(found));
}
