#include "MessageIntervals.h"

#include "../client/Port.h"
#include "../link/Messages.h"
#include "../link/Sending.h"

namespace mavmission {
namespace detail {

bool MessageIntervals::mayAsk(uint16_t nowMs) const {
  // Commands and clear() have no items, nor has a download before its MISSION_COUNT.
  const bool isCommanding = client_.running() != Status::Idle && !client_.hasItems();
  return !isCommanding && client_.autopilot().isFound() && client_.commandLog().mayAsk(asked_, nowMs);
}

void MessageIntervals::ask(float messageId, float intervalUs, uint8_t tries, uint16_t nowMs) {
  mavlink_command_long_t command = mavlink_command_long_t();
  command.command = MAV_CMD_SET_MESSAGE_INTERVAL;
  command.param1 = messageId;
  command.param2 = intervalUs;
  command.confirmation = tries;
  client_.link().send(command);
  await(nowMs);
}

void MessageIntervals::await(uint16_t nowMs) { client_.commandLog().await(asked_, nowMs); }

bool MessageIntervals::isAnswer(const FrameParser& frame) const {
  typedef mavlink_command_ack_t Ack;
  const Link& link = client_.link();
  return isFromAutopilot(frame) && frame.isFor(link.systemId(), link.componentId()) &&
         frame.payloadWord(offsetof(Ack, command)) == MAV_CMD_SET_MESSAGE_INTERVAL &&
         client_.commandLog().isAnswerTo(asked_, frame.sequence());
}

bool MessageIntervals::isWaiting() const { return client_.commandLog().isOf(asked_); }

void MessageIntervals::settle() { client_.commandLog().settle(); }

void MessageIntervals::giveUpWaiting(uint16_t nowMs) { client_.commandLog().giveUpOld(asked_, nowMs); }

}  // namespace detail
}  // namespace mavmission
