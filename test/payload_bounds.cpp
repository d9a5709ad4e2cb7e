// Feeds the vendored parser every message of the dialect with every payload
// length, in both wire versions, while MAVLINK_MAX_PAYLOAD_LEN is as low as the
// command line sets it. Exit status 1, or AddressSanitizer's, if it wrote past
// the payload buffer.

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>

#include "common/mavlink.h"

namespace {

const mavlink_msg_entry_t kEntries[] = MAVLINK_MESSAGE_CRCS;
const uint8_t kUntouched = 0xA5;

struct Parser {
  // Of its exact size on the heap, so that AddressSanitizer sees the end of it.
  mavlink_message_t* message = static_cast<mavlink_message_t*>(std::calloc(1, sizeof *message));
  mavlink_status_t status = {};

  ~Parser() { std::free(message); }

  void feed(uint8_t byte) { mavlink_frame_char_buffer(message, &status, byte, nullptr, nullptr); }
};

// An unsigned frame never touches the signature, which follows the payload.
bool staysInside(uint32_t id, int length, bool v1) {
  Parser parser;
  std::memset(parser.message->signature, kUntouched, sizeof parser.message->signature);
  const uint8_t ids[] = {static_cast<uint8_t>(id), static_cast<uint8_t>(id >> 8), static_cast<uint8_t>(id >> 16)};
  parser.feed(v1 ? MAVLINK_STX_MAVLINK1 : MAVLINK_STX);
  parser.feed(static_cast<uint8_t>(length));
  for (int i = 0; i < (v1 ? 0 : 2); i++) parser.feed(0);
  for (int i = 0; i < 3; i++) parser.feed(1);
  for (int i = 0; i < (v1 ? 1 : 3); i++) parser.feed(ids[i]);
  for (int i = 0; i < length; i++) parser.feed(0x11);
  for (int i = 0; i < 2; i++) parser.feed(0x22);
  for (uint8_t byte : parser.message->signature) {
    if (byte != kUntouched) return false;
  }
  return true;
}

}  // namespace

int main() {
  int written = 0;
  for (const mavlink_msg_entry_t& entry : kEntries) {
    for (int length = 0; length <= 255; length++) {
      for (bool v1 : {true, false}) {
        if (v1 && entry.msgid > 255) continue;
        if (staysInside(entry.msgid, length, v1)) continue;
        std::printf("message %u, payload %d: wrote past the buffer\n", static_cast<unsigned>(entry.msgid), length);
        written = 1;
      }
    }
  }
  return written;
}
