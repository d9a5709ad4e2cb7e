// The models' mission protocol, as far as flights need it. test/explorer has the rest of the protocol.
#include "Autopilot.h"

namespace {
constexpr uint8_t kClient = 191;
constexpr uint32_t kAnswerMs = 5, kAskAgainMs = 1000, kGiveUpMs = 8000;
}  // namespace

void Autopilot::acknowledge(uint8_t result, uint32_t nowMs) {
  mavlink_mission_ack_t ack = mavlink_mission_ack_t();
  ack.target_system = systemId;
  ack.target_component = kClient;
  ack.type = result;
  ack.opaque_id = result == MAV_MISSION_ACCEPTED ? planId() : 0;
  send(messageOf(MAVLINK_MSG_ID_MISSION_ACK, ack), nowMs + kAnswerMs);
}

void Autopilot::askForItem(uint32_t nowMs) {
  mavlink_mission_request_int_t request = mavlink_mission_request_int_t();
  request.target_system = systemId;
  request.target_component = kClient;
  request.seq = expected_;
  // The older message has the same layout.
  send(messageOf(isPx4() ? MAVLINK_MSG_ID_MISSION_REQUEST_INT : MAVLINK_MSG_ID_MISSION_REQUEST, request),
       nowMs + kAnswerMs);
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

bool Autopilot::hearMission(const Message& message, uint32_t nowMs) {
  const uint16_t home = firstItem();
  switch (message.id) {
    case MAVLINK_MSG_ID_MISSION_COUNT: {
      isReceiving_ = true;
      announced_ = read<mavlink_mission_count_t>(message).count;
      expected_ = 0;
      received_.clear();
      heardMs_ = nowMs;
      askForItem(nowMs);
      return true;
    }
    case MAVLINK_MSG_ID_MISSION_ITEM_INT:
      if (!isReceiving_ || read<mavlink_mission_item_int_t>(message).seq != expected_) return true;
      heardMs_ = nowMs;
      if (expected_++ >= home) received_.push_back(message.payload);
      if (expected_ < announced_) {
        askForItem(nowMs);
        return true;
      }
      isReceiving_ = false;
      take(received_, true);
      acknowledge(MAV_MISSION_ACCEPTED, nowMs);
      return true;
    case MAVLINK_MSG_ID_MISSION_REQUEST_LIST: {
      mavlink_mission_count_t count = mavlink_mission_count_t();
      count.target_system = systemId;
      count.target_component = kClient;
      count.count = static_cast<uint16_t>(plan.size() + home);
      count.opaque_id = planId();
      send(messageOf(MAVLINK_MSG_ID_MISSION_COUNT, count), nowMs + kAnswerMs);
      return true;
    }
    case MAVLINK_MSG_ID_MISSION_REQUEST_INT: {
      const uint16_t item = read<mavlink_mission_request_int_t>(message).seq;
      if (item >= plan.size() + home) {
        acknowledge(MAV_MISSION_INVALID_SEQUENCE, nowMs);
      } else {
        send(itemToRead(item), nowMs + kAnswerMs);
      }
      return true;
    }
    case MAVLINK_MSG_ID_MISSION_CLEAR_ALL:
      isReceiving_ = false;
      current_ = 0;
      take(std::vector<Bytes>(), false);
      acknowledge(MAV_MISSION_ACCEPTED, nowMs);
      return true;
    case MAVLINK_MSG_ID_MISSION_SET_CURRENT:
      hearSetCurrent(read<mavlink_mission_set_current_t>(message).seq, nowMs);
      return true;
    default: return message.id == MAVLINK_MSG_ID_MISSION_ACK;
  }
}

void Autopilot::actorSetsPlan(int moreItems, uint32_t) {
  if (plan.empty()) return;
  std::vector<Bytes> items = plan;
  for (Bytes& item : items) {
    mavlink_mission_item_int_t moved;
    memcpy(&moved, item.data(), sizeof(moved));
    if (moved.x != 0) moved.x += 5000;
    memcpy(item.data(), &moved, sizeof(moved));
  }
  for (int i = 0; i < moreItems; ++i) items.push_back(items.back());
  take(items, false);
}

void Autopilot::actorClearsPlan(uint32_t) {
  current_ = 0;
  take(std::vector<Bytes>(), false);
}
