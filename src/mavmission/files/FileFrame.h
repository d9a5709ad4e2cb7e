// The payload of FILE_TRANSFER_PROTOCOL, as far as one item reaches, and the layout of ArduPilot's files of plans.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "../link/Messages.h"
#include "../link/Outbox.h"

namespace mavmission {
namespace detail {

struct __attribute__((packed)) FileFrame {
  uint8_t network, system, component;
  uint16_t sequence;
  uint8_t session;
  uint8_t opcode;     // MAV_FTP_OPCODE
  uint8_t size;       // of the data [bytes]
  uint8_t requested;  // in a reply: the opcode of the request
  uint8_t isBurstComplete;
  uint8_t padding;
  uint32_t offset;   // in the file [bytes]
  uint8_t data[23];  // longer in what is received, and in what is written to a file

  static constexpr uint8_t kHead = 15;                                          // before the data [bytes]
  static constexpr uint8_t kItem = kHead + sizeof(mavlink_mission_item_int_t);  // with an item [bytes]
};
static_assert(offsetof(FileFrame, data) == FileFrame::kHead && sizeof(FileFrame) == Outbox::kMaxPayload,
              "a request is made in the outbox");
static_assert(offsetof(FileFrame, sequence) == offsetof(mavlink_file_transfer_protocol_t, payload),
              "the frame begins with the fields of FILE_TRANSFER_PROTOCOL");

// FILE_TRANSFER_PROTOCOL and HEARTBEAT.
extern const MessageKey kKeysOfFiles[2];

// The first bytes of a file; an item for each of `count` follows, laid out as MISSION_ITEM_INT.
struct __attribute__((packed)) FileHeader {
  uint16_t magic;
  uint16_t type;     // MAV_MISSION_TYPE
  uint16_t options;  // 0: the file takes the place of the whole plan
  uint16_t start;
  uint16_t count;

  static constexpr uint16_t kMagic = 0x763D;
};
constexpr uint8_t kFileHeader = sizeof(FileHeader), kFileItem = sizeof(mavlink_mission_item_int_t);
static_assert(kFileHeader == 10 && kFileItem == 38, "as ArduPilot lays out its files");

}  // namespace detail
}  // namespace mavmission
