#include "MessageIntervals.h"

#include "../MissionClient.h"
#include "../base/Clock.h"
#include "../link/Messages.h"
#include "../link/Sending.h"

namespace mavmission {
namespace detail {

void MessageIntervals::hear(Listener& listener, const FrameParser& frame) {
  static_cast<MessageIntervals&>(listener).hear_(listener, frame);
}

bool MessageIntervals::mayAsk(uint16_t nowMs) const {
  // Commands and clear() have no items, nor has a download before its MISSION_COUNT.
  const bool isCommanding = client_.isBusy() && client_.itemsTotal() == 0;
  if (isCommanding || !client_.hasAutopilot()) return false;
  // Late answers to the client's own command.
  const bool isBehindOne =
      !client_.isBusy() && client_.rest_.isCommanding && client_.state_.seconds < CommandRules::kLateAnswersS;
  if (isBehindOne && client_.commanding_.transfer.awaitsLate(MAV_CMD_SET_MESSAGE_INTERVAL, nowMs)) return false;
  for (const Listener* other = nextAlike(nullptr); other != nullptr; other = nextAlike(other)) {
    const MessageIntervals& asker = static_cast<const MessageIntervals&>(*other);
    if (&asker != this && asker.isWaiting_ && since(asker.askedMs_, nowMs) < IntervalRules::kAnswerMs) return false;
  }
  return true;
}

void MessageIntervals::ask(float messageId, float intervalUs, uint8_t tries, uint16_t nowMs) {
  mavlink_command_long_t command = mavlink_command_long_t();
  command.command = MAV_CMD_SET_MESSAGE_INTERVAL;
  command.param1 = messageId;
  command.param2 = intervalUs;
  command.confirmation = tries;
  client_.link_.send(command);
  isWaiting_ = true;
  await(nowMs);
}

void MessageIntervals::await(uint16_t nowMs) {
  askedMs_ = nowMs;
  client_.rest_.intervalMs = nowMs;
  client_.rest_.isIntervalOpen = true;
}

bool MessageIntervals::isAnswer(const FrameParser& frame) const {
  typedef mavlink_command_ack_t Ack;
  const Link& link = client_.link_;
  return isWaiting_ && isFromAutopilot(frame) && frame.isFor(link.systemId(), link.componentId()) &&
         frame.payloadWord(offsetof(Ack, command)) == MAV_CMD_SET_MESSAGE_INTERVAL;
}

void MessageIntervals::settle() {
  isWaiting_ = false;
  client_.rest_.isIntervalOpen = false;
}

void MessageIntervals::giveUpWaiting(uint16_t nowMs) {
  if (since(askedMs_, nowMs) < IntervalRules::kAnswerMs) return;
  isWaiting_ = false;
  // Another listener may have asked since.
  if (since(client_.rest_.intervalMs, nowMs) >= IntervalRules::kAnswerMs) client_.rest_.isIntervalOpen = false;
}

}  // namespace detail
}  // namespace mavmission
