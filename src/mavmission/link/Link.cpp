#include "Link.h"

#include <Arduino.h>

#include "../base/Clock.h"
#include "../base/Flash.h"
#include "Messages.h"
#include "OwnHeartbeat.h"
#include "Sending.h"

namespace mavmission {
namespace detail {
void Link::setSourceIds(uint8_t systemId, uint8_t componentId) {
  state_.ownSystemId = systemId;
  state_.ownComponentId = componentId != 0 ? componentId : kComponentId;
}

uint8_t Link::systemId() const { return state_.ownSystemId != 0 ? state_.ownSystemId : finder_.heartbeat().systemId; }

uint8_t Link::componentId() const { return state_.ownComponentId; }

bool Link::speaksV1() const {
#if MAVMISSION_SIGNING
  if (signing_.isOn()) return false;
#endif
  return state_.speaksV1;
}

void Link::setMavlinkVersion(MavlinkVersion speak) {
  state_.isVersionSet = speak != MavlinkVersion::AsAutopilot;
  state_.speaksV1 = state_.isVersionSet ? speak == MavlinkVersion::Version1 : state_.hearsV1;
}

bool Link::maySpeak() const {
  if (finder_.severalHeard()) return false;
  return finder_.isFound() || state_.ownSystemId != 0;
}

void Link::look(uint32_t nowMs) {
  const uint32_t gapMs = nowMs - state_.emptyMs;
  const uint16_t upper = static_cast<uint16_t>(gapMs >> 16);
  if (upper != 0) finder_.forget();
  state_.gap = upper != 0 || static_cast<uint16_t>(gapMs) >= 255 * kGapMs
                   ? 255
                   : static_cast<uint8_t>(static_cast<uint16_t>(gapMs) / kGapMs);
  if (isBlind()) state_.isCurrent = false;
}

void Link::noteEmpty(uint32_t nowMs) { state_.emptyMs = nowMs; }

bool Link::canSend() const { return isSent() && !finder_.isDoubted(); }

void Link::add(MoreKeys& listener) {
  MoreKeys*& first = parser_.moreKeys();
  listener.next = first;
  first = &listener;
}

bool Link::takeHeartbeat(uint16_t nowMs) {
  static_assert(offsetof(Heartbeat, vehicleType) == offsetof(mavlink_heartbeat_t, type) &&
                    offsetof(Heartbeat, autopilot) == offsetof(mavlink_heartbeat_t, autopilot) &&
                    offsetof(Heartbeat, baseMode) == offsetof(mavlink_heartbeat_t, base_mode) &&
                    offsetof(Heartbeat, state) == offsetof(mavlink_heartbeat_t, system_status) &&
                    offsetof(Heartbeat, systemId) == offsetof(mavlink_heartbeat_t, mavlink_version),
                "Heartbeat begins with the message, without mavlink_version, which is a constant");
  const FrameParser& given = frame();
  const uint8_t systemId = given.systemId();
  const uint8_t componentId = given.componentId();
  const uint16_t typeAndAutopilot = given.payloadWord(offsetof(mavlink_heartbeat_t, type));
  const uint8_t vehicleType = static_cast<uint8_t>(typeAndAutopilot);
  const uint8_t autopilot = static_cast<uint8_t>(typeAndAutopilot >> 8);
  if (!finder_.onHeartbeat(systemId, componentId, autopilot, vehicleType, nowMs)) return false;
  if (!isBlind()) state_.isCurrent = true;
  if (isPrepared()) outbox_.drop();
  Heartbeat& heartbeat = finder_.toFill();
  const uint8_t before = heartbeat.state;
  given.copyPayload(&heartbeat, offsetof(mavlink_heartbeat_t, mavlink_version));
  finder_.noteState(before);
  const bool isV1 = !given.isV2();
  state_.hearsV1 = isV1;
  if (!state_.isVersionSet) state_.speaksV1 = isV1;
  heartbeat.systemId = systemId;
  heartbeat.componentId = componentId;
  return true;
}

bool Link::receive(FrameParser::Budget& budget, uint16_t nowMs) {
#if MAVMISSION_SIGNING
  if (takeAccepted(nowMs)) {
    budget.left = 0;  // no more bytes in this update(): handling the frame takes time, too
    return true;
  }
#endif
  for (;;) {
#if MAVMISSION_SIGNING
    if (!mayRead()) return false;
#endif
    FrameParser::Result result = parser_.pull(*stream_, budget);
    if (budget.heard != 0) {
      state_.bytes += budget.heard;
      state_.heardByteMs = nowMs;
    }
    if (result == FrameParser::Result::Nothing) {
      if (budget.left == 0 || parser_.isIdle() || since(state_.heardByteMs, nowMs) < FrameParser::kSilenceMs)
        return false;
      result = parser_.silence();
    }
#if MAVMISSION_SIGNING
    if (signing_.isOn() || result == FrameParser::Result::Signature) {
      takeUnchecked(result, nowMs);
      continue;
    }
#endif
    if (result != FrameParser::Result::Nothing && takeResult(result, nowMs)) return true;
  }
}

// Counts a frame; true if it comes from the autopilot, is wanted, and is addressed to us.
bool Link::takeResult(FrameParser::Result result, uint16_t nowMs) {
  const bool isWanted = result == FrameParser::Result::Wanted;
  bool isAutopilots = finder_.isFrom(parser_.systemId(), parser_.componentId());
  const uint8_t left = numbersBefore();
  const bool isLate = isAutopilots && isOvertaken(left, nowMs);
  if (isWanted) {
    ++state_.frames;
    if (parser_.messageId() == MAVLINK_MSG_ID_HEARTBEAT) {
      // It shows a mode that is over, unless it is the last frame that comes twice.
      if (isLate && left != 255) return false;
      if (takeHeartbeat(nowMs)) isAutopilots = true;
    }
    const MoreKeys* const listeners = parser_.moreKeys();
    if (listeners != nullptr) listeners->tell(listeners, parser_);
  } else {
    ++state_.unknownMessages;
  }
  if (!isAutopilots) return false;
  if (isLate) {
    state_.hasTwoWays = true;
  } else {
    noteSequence(left);
    if (isWanted) finder_.onFrame(nowMs);
  }
  return isWanted && maySpeak() && parser_.isFor(systemId(), componentId());
}

// (When nothing newer has come for a while, the autopilot has restarted.)
bool Link::isOvertaken(uint8_t left, uint16_t nowMs) const {
  return left >= 255 - kLateFrames && finder_.quietMs(nowMs) < kLateMs;
}

void Link::noteSequence(uint8_t left) {
  if (state_.sequenceKnown && left < 255 - kLateFrames) state_.framesLost += left;
  state_.heardSequence = parser_.sequence();
  state_.sequenceKnown = true;
}

void Link::release() {
  if (!maySpeak()) return outbox_.drop();
  outbox_.release(pace_.isLossy());
  ++state_.framesSent;
}

void Link::sendMessage(uint8_t* payload, const MessageKey* key) {
  pack(payload, key);
  release();
}

void Link::pack(uint8_t* payload, const MessageKey* key) {
  const uint8_t target = fromFlash(&key->target);
  if (target != MessageKey::kNoTarget) {
    payload[target] = finder_.heartbeat().systemId;
    payload[target + 1] = finder_.heartbeat().componentId;
  }
  // A type of plan that MAVLink 1 would cut off would be another plan's: a frame says all of it, or waits for nobody.
  const uint8_t lengthV1 = fromFlash(&key->lengthV1);
  const bool isCut = lengthV1 < fromFlash(&key->length) && payload[lengthV1] != 0;
  outbox_.begin(speaksV1() && !isCut, sequence(), systemId(), componentId());
  outbox_.complete(key, payload);
}

bool Link::sendForeign(const OutgoingMessage& message) {
  const bool isV1 = speaksV1();
  if (!isSent() || !maySpeak() || (isV1 && (message.id > 0xFF || message.lengthV1 == 0))) {
    return false;
  }
  outbox_.begin(speaksV1(), sequence(), systemId(), componentId());
  outbox_.completeForeign(message);
  release();
  return true;
}

void Link::onTime(uint16_t nowMs) {
  // What was skipped before the first heartbeat was the rest of a frame in whose middle our listening began.
  const uint8_t damage = static_cast<uint8_t>(parser_.bytesSkipped() + state_.framesLost);
  if (damage != damage_ && finder_.isHeard()) pace_.noteLoss();
  damage_ = damage;
  pace_.noteBusy(outbox_.busyMs(*stream_, nowMs));
  finder_.onTime(nowMs);
  if (state_.heartbeatSent && since(state_.heartbeatMs, nowMs) < kHeartbeatMs) return;
  if (!canSend() || !maySpeak()) return;
  // The next heartbeat is due one period after this one was due, so that late calls do not make heartbeats rarer.
  state_.heartbeatMs += kHeartbeatMs;
  if (!state_.heartbeatSent || since(state_.heartbeatMs, nowMs) >= kHeartbeatMs) state_.heartbeatMs = nowMs;
  state_.heartbeatSent = true;
  sendHeartbeat();
}

void Link::sendHeartbeat() {
  mavlink_heartbeat_t& heartbeat = *static_cast<mavlink_heartbeat_t*>(outbox_.draft());
  makeOwnHeartbeat(heartbeat);
  send(heartbeat);
}

LinkCounters Link::counters() const {
  return LinkCounters{state_.bytes,           parser_.bytesSkipped(), state_.frames,     state_.unknownMessages,
                      parser_.badChecksums(), parser_.brokenFrames(), state_.framesLost, state_.framesSent};
}

}  // namespace detail
}  // namespace mavmission
