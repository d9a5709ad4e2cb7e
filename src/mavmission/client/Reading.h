// The reading of the plan aboard, for a download, a verification or a read-back.
#pragma once

#include "Client.h"

namespace mavmission {
namespace detail {

struct Client::ReadingPlan : OperationParts {
  static bool begin(Client& client, uint16_t nowMs);
  static void time(Client& client, uint16_t nowMs);
  MAVMISSION_ONE_EXIT static void step(Client& client, const FrameParser* frame, uint16_t nowMs);
  static void frame(Client& client, const FrameParser& frame, uint16_t nowMs);
  static void takeCount(Client& client, const FrameParser& frame, uint16_t nowMs);
  MAVMISSION_APART static void takeItem(Client& client, const FrameParser& frame, uint16_t nowMs);
  static void send(Client& client, uint16_t nowMs);
  static void sendRequest(Client& client, uint16_t wireItem);
  static void end(Client& client, Status status);
  static Status compare(Client& client, uint16_t wireItem, MissionItem& item);
  static Status store(Client& client, uint16_t wireItem, MissionItem& item);
  static void prove(Client& client, uint16_t nowMs);
};

}  // namespace detail
}  // namespace mavmission
