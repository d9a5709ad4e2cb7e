// The upload of a plan, item by item, and what may follow its end.
#pragma once

#include "Client.h"

namespace mavmission {
namespace detail {

struct Client::Uploading {
  MAVMISSION_ONE_EXIT static void step(Client& client, const FrameParser* frame, uint16_t nowMs);
  static void noteEarly(Client& client, const FrameParser& frame);
  static void checkNext(Client& client, uint16_t nowMs);
  MAVMISSION_ONE_EXIT static void begin(Client& client, uint16_t nowMs);
  static void time(Client& client, uint16_t nowMs);
  static void frame(Client& client, const FrameParser& frame, uint16_t nowMs);
  static Status proven(Client& client, uint32_t opaqueId);
  MAVMISSION_ONE_EXIT static void goOn(Client& client, Status status, uint16_t nowMs);
  static Aboard aboardAfter(const Client& client, Status status);
  static void send(Client& client, uint16_t nowMs);
  static void sendAnnouncement(Client& client);
  MAVMISSION_APART MAVMISSION_ONE_EXIT static void prepare(Client& client, uint16_t wireItem, uint16_t nowMs);
  static bool continueAfter(Client& client, Status status, uint16_t nowMs);
  static bool fallBackToFloats(Client& client, Status status, uint16_t nowMs);
  // True if the back-off that the sketch may have chosen has begun.
  static bool backsOff(Client& client, Status status, uint16_t) {
    const Options& options = client.session_.options;
    return options.backOff != nullptr && !client.transfer_.hasBegun() && options.backOff(client, status);
  }
  static void announcePart(Client& client);
};

}  // namespace detail
}  // namespace mavmission
