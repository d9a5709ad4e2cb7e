// A client that hears messages said in words, beside what listens by it; and the messages that it requests.
#pragma once

#include <string>

#include "ClientOnLine.h"
#include "Messages.h"
#include "mavmission/base/MavlinkHeaders.h"

class ToldClient : public ClientOnLine {
 public:
  explicit ToldClient(uint8_t autopilot = kArduPilot, uint32_t startMs = 65000) : ClientOnLine(autopilot, startMs) {}

  // It comes, and has been read.
  void tell(const FrameParts& parts) {
    hear(parts);
    while (!line.toRead.empty()) run(1);
  }
  void tell(const std::string& words, uint8_t systemId = 1, uint8_t componentId = 1) {
    FrameParts parts = messageParts(words);
    parts.systemId = systemId;
    parts.componentId = componentId;
    tell(parts);
  }

  // When a message was requested every so many ms [ms, since `fromMs`]: "2002 4002".
  std::string requests(uint16_t messageId, uint32_t intervalMs, uint32_t fromMs = 0) const {
    const std::string request = "COMMAND_LONG target_system 1 target_component 1 command 511 param1 " +
                                std::to_string(messageId) + " param2 " + std::to_string(1000 * intervalMs);
    std::string times;
    for (const SentFrame& frame : sent) {
      if (frame.messageId != MAVLINK_MSG_ID_COMMAND_LONG || frame.atMs < fromMs) continue;
      if (wordsOf(frame.messageId, frame.payload) != request) continue;
      times += (times.empty() ? "" : " ") + std::to_string(frame.atMs - fromMs);
    }
    return times;
  }
};

// The same with one listener, which requests its message every `intervalMs`, or none where that is 0.
template <typename Listener>
struct Told : ToldClient {
  Listener listener;

  explicit Told(uint16_t intervalMs = 0, uint8_t autopilot = kArduPilot, uint32_t startMs = 65000)
      : ToldClient(autopilot, startMs), listener(client, intervalMs) {
    if (intervalMs == 0) run(3500);
  }
};
