#include "TextListener.h"

#include <string.h>

#include "../base/Flash.h"
#include "../link/Messages.h"

namespace mavmission {
using namespace detail;
namespace {

const MessageKey kListened[] PROGMEM = {MAVMISSION_LISTENER_KEY(HEARTBEAT), MAVMISSION_LISTENER_KEY(STATUSTEXT)};

constexpr char kMissing[] = "[...]";
constexpr uint8_t kHeartbeats = 2;

}  // namespace

TextListener::TextListener(MissionClient& client)
    : Listener(client, kListened, sizeof(kListened) / sizeof(kListened[0]), take) {}

void TextListener::onText(TextFunction function, void* context) {
  function_ = function;
  context_ = context;
}

bool TextListener::isNew() {
  const bool wasNew = isNew_;
  isNew_ = false;
  return wasNew;
}

void TextListener::take(Listener& listener, const FrameParser& frame) {
  typedef mavlink_statustext_t Message;
  TextListener& self = static_cast<TextListener&>(listener);
  if (!self.isFromAutopilot(frame)) return;
  if (frame.messageId() == MAVLINK_MSG_ID_HEARTBEAT) {
    if (self.heartbeatsLeft_ == 0 || --self.heartbeatsLeft_ != 0) return;
    if (self.isOpen_) self.give();
    self.number_ = 0;
    return;
  }
  constexpr uint8_t kPiece = sizeof(Message::text);
  char text[kPiece + 1];
  for (uint8_t i = 0; i < kPiece; ++i) {
    text[i] = static_cast<char>(frame.payloadByte(offsetof(Message, text) + i));
  }
  text[kPiece] = 0;
  self.takePiece(frame.payloadWord(offsetof(Message, id)), frame.payloadByte(offsetof(Message, chunk_seq)),
                 frame.payloadByte(offsetof(Message, severity)), text);
}

// `number`: which text it belongs to; 0: to none, it is a whole one. (PX4's first text after its start has number 0,
// too: if it is a long one, its pieces are given one by one.)
void TextListener::takePiece(uint16_t number, uint8_t piece, uint8_t severity, const char* text) {
  const bool isSame = number != 0 && number == number_;
  if (isSame && (!isOpen_ || piece < piece_)) return;  // the line has repeated it, or delayed it
  if (!isSame) {
    if (isOpen_) give();
    number_ = number;
    piece_ = 0;
    length_ = 0;
    text_[0] = 0;
    severity_ = severity;
    isOpen_ = true;
  }
  if (piece != piece_) append(kMissing);
  append(text);
  piece_ = piece + 1;
  heartbeatsLeft_ = kHeartbeats;
  // A piece that is not full is the last one.
  if (number == 0 || text[sizeof(mavlink_statustext_t::text) - 1] == 0) {
    isOpen_ = false;
    give();
  }
}

void TextListener::append(const char* text) {
  const size_t room = kLongest - length_;
  const size_t length = strlen(text);
  const uint8_t taken = static_cast<uint8_t>(length < room ? length : room);
  memcpy(&text_[length_], text, taken);
  length_ += taken;
  text_[length_] = 0;
}

void TextListener::give() {
  if (isOpen_) append(kMissing);
  isOpen_ = false;
  isNew_ = true;
  if (function_ != nullptr) function_(context_, severity_, text_);
}

}  // namespace mavmission
