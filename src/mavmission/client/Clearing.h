// clear().
#pragma once

#include "Client.h"

namespace mavmission {
namespace detail {

struct Client::Clearing : OperationParts {
  static bool begin(Client& client, uint16_t);
  static void frame(Client& client, const FrameParser& frame, uint16_t);
  static void time(Client& client, uint16_t nowMs);
  static void step(Client& client, const FrameParser* frame, uint16_t nowMs);
  static void end(Client& client, Status status);
};

}  // namespace detail
}  // namespace mavmission
