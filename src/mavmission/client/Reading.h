// The reading of the plan aboard, for a download, a verification or a read-back.
#pragma once

#include "Client.h"

namespace mavmission {
namespace detail {

struct Client::ReadingPlan {
  static void beginStep(Client& client, const FrameParser* frame, uint16_t nowMs);
  static void time(Client& client, uint16_t nowMs);
  // True if several items may be asked for at once.
  static bool asksAhead(const Client& client);
  static void goOn(Client& client, uint16_t nowMs, bool mayBeAhead);
  MAVMISSION_ONE_EXIT static void step(Client& client, const FrameParser* frame, uint16_t nowMs);
  static void frame(Client& client, const FrameParser& frame, uint16_t nowMs);
  MAVMISSION_ONE_EXIT static void readOn(Client& client, const FrameParser* frame, uint16_t nowMs);
  static void take(Client& client, const FrameParser& frame, uint16_t nowMs);
  static uint16_t countIn(const FrameParser& frame);
  static bool onCount(Client& client, const FrameParser& frame, uint16_t nowMs);
  static void compareCount(Client& client, const FrameParser& frame, uint16_t nowMs);
  static void takeNext(Client& client, const FrameParser& frame, uint16_t nowMs);
  // `fromFloats`: makes a MISSION_ITEM_INT of a MISSION_ITEM; null for the former.
  MAVMISSION_APART static void takeItem(Client& client, const FrameParser& frame, uint16_t nowMs,
                                        void (*fromFloats)(void* itemMessage));
  static void send(Client& client, uint16_t nowMs, bool asksAhead);
  static void sendRequest(Client& client, uint16_t wireItem);
  static void end(Client& client, Status status);
  static Status compare(Client& client, uint16_t wireItem, MissionItem& item);
  static Status store(Client& client, uint16_t wireItem, MissionItem& item);
  static void prove(Client& client, uint16_t nowMs);
};

}  // namespace detail
}  // namespace mavmission
