// The models' mission protocol, as far as flights need it. test/explorer has the rest of the protocol.
#include "Autopilot.h"

namespace {
constexpr uint8_t kClient = 191;
constexpr uint32_t kAnswerMs = 5, kAskAgainMs = 1000, kGiveUpMs = 8000;
}  // namespace

void Autopilot::acknowledge(uint8_t result, uint32_t nowMs) {
  const uint32_t name = result == MAV_MISSION_ACCEPTED ? planId() : 0;
  send(ackParts(result, systemId, kClient, 0, name), nowMs + kAnswerMs);
}

void Autopilot::askForItem(uint32_t nowMs) {
  FrameParts request = requestParts(expected_, systemId);
  if (!isPx4()) request = FrameParts(MAVLINK_MSG_ID_MISSION_REQUEST, request.payload);  // it has the same layout
  send(request, nowMs + kAnswerMs);
  askedMs_ = nowMs;
}

void Autopilot::lookForItem(uint32_t nowMs) {
  if (nowMs - heardMs_ >= kGiveUpMs) isReceiving_ = false;
  if (isReceiving_ && nowMs - askedMs_ >= kAskAgainMs) askForItem(nowMs);
}

void Autopilot::take(const std::vector<Bytes>& items, bool isOurs) {
  plan = items;
  witness_.planSet(isOurs, by_);
}

void Autopilot::hearMission(const FrameParts& message, uint32_t nowMs) {
  const uint16_t home = firstItem();
  switch (message.messageId) {
    case MAVLINK_MSG_ID_MISSION_COUNT:
      isReceiving_ = true;
      announced_ = messageIn<mavlink_mission_count_t>(message.payload).count;
      expected_ = 0;
      received_.clear();
      heardMs_ = nowMs;
      return askForItem(nowMs);
    case MAVLINK_MSG_ID_MISSION_ITEM_INT:
      if (!isReceiving_ || messageIn<mavlink_mission_item_int_t>(message.payload).seq != expected_) return;
      heardMs_ = nowMs;
      if (expected_++ >= home) received_.push_back(message.payload);
      if (expected_ < announced_) return askForItem(nowMs);
      isReceiving_ = false;
      take(received_, true);
      return acknowledge(MAV_MISSION_ACCEPTED, nowMs);
    case MAVLINK_MSG_ID_MISSION_REQUEST_LIST: {
      const uint16_t items = static_cast<uint16_t>(plan.size() + home);
      return send(countParts(items, mavmission::PlanType::Mission, planId(), systemId), nowMs + kAnswerMs);
    }
    case MAVLINK_MSG_ID_MISSION_REQUEST_INT: {
      const uint16_t item = messageIn<mavlink_mission_request_int_t>(message.payload).seq;
      if (item >= plan.size() + home) return acknowledge(MAV_MISSION_INVALID_SEQUENCE, nowMs);
      return send(itemToRead(item), nowMs + kAnswerMs);
    }
    case MAVLINK_MSG_ID_MISSION_CLEAR_ALL:
      isReceiving_ = false;
      clear();
      return acknowledge(MAV_MISSION_ACCEPTED, nowMs);
    case MAVLINK_MSG_ID_MISSION_SET_CURRENT:
      return hearSetCurrent(messageIn<mavlink_mission_set_current_t>(message.payload).seq, nowMs);
    default: return;
  }
}

void Autopilot::actorSetsPlan(int moreItems) {
  if (plan.empty()) return;
  std::vector<Bytes> items = plan;
  for (Bytes& item : items) {
    mavlink_mission_item_int_t moved = messageIn<mavlink_mission_item_int_t>(item);
    if (moved.x != 0) moved.x += 5000;
    item = bytesOf(moved);
  }
  for (int i = 0; i < moreItems; ++i) items.push_back(items.back());
  take(items, false);
}

void Autopilot::clear() {
  current_ = 0;
  take(std::vector<Bytes>(), false);
}
