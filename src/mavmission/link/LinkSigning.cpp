// The part of Link for signed frames (MAVMISSION_SIGNING).
//
// A received frame is passed on to nobody before its signature has proved right. It is copied, so that the parser can
// go on meanwhile; if a second one is complete before the first is checked, further bytes wait in the stream. A frame
// that goes out waits in the outbox for its signature.
#include "Link.h"

#if MAVMISSION_SIGNING

#include <Arduino.h>

#include "Messages.h"

namespace mavmission {
namespace detail {

void Link::signWith(const SigningKey& key, uint8_t linkId, const TimestampStore& store) {
  signing_.begin(key, linkId, store);
  outbox_.beginSigning();
  check_ = Check::None;
  isWaiting_ = false;
}

bool Link::workOnSignatures() {
  if (!signing_.isOn()) return false;
  signing_.keepTime();
  if (!signing_.isBusy()) {
    if (check_ == Check::Accepted) return false;  // the accepted frame is passed on first
    if (outbox_.isUnsigned() && signing_.maySign()) {
      outbox_.startSigning(signing_);
    } else if (check_ == Check::Due) {
      const bool isTimely = signing_.check(checked_.bytes(), checked_.frameLength(), checked_.systemId(),
                                           checked_.componentId(), checked_.signature());
      check_ = isTimely ? Check::Running : Check::None;
      if (!isTimely) return false;
    } else {
      return false;
    }
  }
  // When many bytes are waiting, every second update() reads them.
  hashedLast_ = !hashedLast_ || stream_->available() < kMayWait;
  if (!hashedLast_) return false;
  switch (signing_.work(kRoundsAtOnce)) {
    case Signing::Done::Nothing: break;
    case Signing::Done::Signed: outbox_.setSigned(); break;
    case Signing::Done::Accepted: check_ = Check::Accepted; break;
    case Signing::Done::Refused: check_ = Check::None; break;
  }
  return true;
}

// True if a frame has been accepted that comes from the autopilot and is addressed to us.
bool Link::takeAccepted(uint16_t nowMs) {
  if (check_ != Check::Accepted) return false;
  check_ = Check::None;
  ++state_.frames;
  if (checked_.messageId() == MAVLINK_MSG_ID_HEARTBEAT) takeHeartbeat(nowMs);
  const MoreKeys* const listeners = parser_.moreKeys();
  if (listeners != nullptr) listeners->tell(listeners, checked_);
  return finder_.isFrom(checked_.systemId(), checked_.componentId()) && checked_.isFor(systemId(), componentId());
}

// False while there is no room for the frame that the parser has found.
bool Link::mayRead() {
  if (!isWaiting_) return true;
  if (check_ != Check::None) return false;
  checked_ = parser_;
  check_ = Check::Collecting;
  isWaiting_ = false;
  return true;
}

void Link::takeUnchecked(FrameParser::Result result, uint16_t nowMs) {
  switch (result) {
    case FrameParser::Result::Nothing: return;
    case FrameParser::Result::Unwanted: takeResult(result, nowMs); return;
    case FrameParser::Result::Signature:
      if (check_ != Check::Collecting) return;
      checked_.takeSignatureOf(parser_);
      check_ = Check::Due;
      return;
    case FrameParser::Result::Wanted: break;
  }
  if (check_ == Check::Collecting) check_ = Check::None;  // the signature was cut off
  const uint8_t left = numbersBefore();
  if (finder_.isFrom(parser_.systemId(), parser_.componentId()) && !isOvertaken(left, nowMs)) noteSequence(left);
  if (!matters()) return;
  if (parser_.hasSignature()) {
    isWaiting_ = true;
    return;
  }
  // A radio on the line has no key. Its message changes nothing here, but a sketch may want to read it (guide,
  // Accepting Unsigned Packets).
  const MoreKeys* const listeners = parser_.moreKeys();
  if (listeners != nullptr && parser_.messageId() == MAVLINK_MSG_ID_RADIO_STATUS) {
    listeners->tell(listeners, parser_);
  } else {
    signing_.noteNotSigned();
  }
}

// True if the library or a listener would use this frame: most frames need not be checked.
bool Link::matters() {
  const MoreKeys* const listeners = parser_.moreKeys();
  if (listeners != nullptr && listeners->search(listeners, parser_.messageId()) != nullptr) return true;
  if (parser_.messageId() == MAVLINK_MSG_ID_HEARTBEAT) {
    return parser_.payloadByte(offsetof(mavlink_heartbeat_t, autopilot)) != MAV_AUTOPILOT_INVALID;
  }
  return finder_.isFrom(parser_.systemId(), parser_.componentId()) && parser_.isFor(systemId(), componentId());
}

}  // namespace detail
}  // namespace mavmission

#endif
