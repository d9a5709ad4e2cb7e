#include "Message.h"

#include <stdexcept>

Bytes frameOf(const Message& message, uint8_t sequence, uint8_t systemId, uint8_t componentId) {
  const mavlink_msg_entry_t* const entry = mavlink_get_msg_entry(message.id);
  FrameParts parts(message.id, message.payload, entry->crc_extra);
  parts.sequence = sequence;
  parts.systemId = systemId;
  parts.componentId = componentId;
  return packed(parts);
}

uint8_t targetOf(const Message& message) {
  const mavlink_msg_entry_t* const entry = mavlink_get_msg_entry(message.id);
  const bool hasTarget = (entry->flags & MAV_MSG_ENTRY_FLAG_HAVE_TARGET_SYSTEM) != 0;
  return hasTarget ? message.payload[entry->target_system_ofs] : uint8_t{0};
}

std::vector<Unpacker::Found> Unpacker::take(const Bytes& bytes) {
  std::vector<Found> found;
  const size_t before = unread_.size();
  unread_ = unread_ + bytes;
  size_t used = 0;
  while (unread_.size() > 2) {
    if (unread_[0] == 0) {  // a zero byte fills the space before a repeat
      unread_.erase(unread_.begin());
      ++used;
      continue;
    }
    if (unread_[0] != MAVLINK_STX) throw std::runtime_error("what is sent is no MAVLink 2 frame");
    const size_t length = unread_[1] + 12u;
    if (unread_.size() < length) break;
    const uint32_t id = unread_[7] | unread_[8] << 8 | static_cast<uint32_t>(unread_[9]) << 16;
    const mavlink_msg_entry_t* const entry = mavlink_get_msg_entry(id);
    if (entry == nullptr) throw std::runtime_error("a frame of an unknown message is sent");
    uint16_t crc = X25_INIT_CRC;
    for (size_t i = 1; i < length - 2; ++i) crc_accumulate(unread_[i], &crc);
    crc_accumulate(entry->crc_extra, &crc);
    const bool isRight = unread_[length - 2] == (crc & 0xFF) && unread_[length - 1] == crc >> 8;
    Bytes payload(unread_.begin() + 10, unread_.begin() + static_cast<long>(length) - 2);
    payload.resize(entry->max_msg_len, 0);
    used += length;
    found.push_back(Found{Message{id, payload}, isRight, length, used - before});
    unread_.erase(unread_.begin(), unread_.begin() + static_cast<long>(length));
  }
  return found;
}
