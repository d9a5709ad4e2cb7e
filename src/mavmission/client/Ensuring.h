// ensure(): the look at what is aboard, and the upload after it.
#pragma once

#include "Client.h"

namespace mavmission {
namespace detail {

struct Client::Ensuring : OperationParts {
  static bool begin(Client& client, uint16_t);
  static void time(Client& client, uint16_t nowMs);
  static void step(Client& client, const FrameParser* frame, uint16_t nowMs);
  static void freeStep(Client& client, const FrameParser* frame, uint16_t nowMs);
  static void freedStep(Client& client, const FrameParser* frame, uint16_t nowMs);
  static void prove(Client& client, uint16_t nowMs);
  static void proofStep(Client& client, const FrameParser* frame, uint16_t nowMs);
  static void backOffStep(Client& client, const FrameParser* frame, uint16_t nowMs);
  static bool continueAfterFirst(Client& client, Status status, uint16_t nowMs);
  static bool continueAfter(Client& client, Status status, uint16_t nowMs);
  static Status takeItem(Client& client, uint16_t wireItem, MissionItem& item);
  static void checkNext(Client& client, uint16_t nowMs);
  static Status sum(Client& client, uint16_t wireItem);
  static void beginLook(Client& client, uint16_t nowMs);
  static void look(Client& client, uint16_t nowMs);
  static void frame(Client& client, const FrameParser& frame, uint16_t nowMs);
  static void takeCount(Client& client, const FrameParser& frame, uint16_t nowMs);
  static void replaceOther(Client& client);
  static void endLook(Client& client, Status status);
};

}  // namespace detail
}  // namespace mavmission
