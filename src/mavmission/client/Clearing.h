// clear().
#pragma once

#include "Client.h"

namespace mavmission {
namespace detail {

struct Client::Clearing : OperationParts {
  static bool begin(Client& client, uint16_t nowMs);
  static void frame(Client& client, const FrameParser& frame, uint16_t);
  static void time(Client& client, uint16_t nowMs);
  static void step(Client& client, const FrameParser* frame, uint16_t nowMs);
  static void takeCount(Client& client, const mavlink_mission_count_t& count);
  static void takeAck(Client& client, const mavlink_mission_ack_t& ack);
  static void takeCleared(Client& client);
};

}  // namespace detail
}  // namespace mavmission
