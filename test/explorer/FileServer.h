// ArduPilot's files of plans as a small model, the mission alone: what it does was observed on ArduPilot 4.6.3
// (simulation/recordings). One file is open at a time, for all clients; what was written is stored when it is closed,
// by whomever; the answer to a request with the number of the last one comes from memory.
#pragma once

#include <type_traits>

#include "Autopilot.h"
#include "FileWords.h"

struct FileServer {
  static constexpr uint16_t kIdleMs = 3000;  // after its last answer another session may take over

  uint8_t isOpen;
  uint8_t isWritten;  // it was created; else it is read
  uint8_t session;
  uint8_t header;            // the number of items in the header that was written, one more; 0: none was
  uint8_t extent;            // items that the file has room for
  uint8_t items[kMostHeld];  // as they were written; kNoItemAtAll: zeros
  uint8_t spare;
  uint16_t idleInMs;  // until another session may take over
  Message last;       // its last answer; a heartbeat: none

  void pass(uint16_t ms) { idleInMs = static_cast<uint16_t>(idleInMs > ms ? idleInMs - ms : 0); }
  void hear(const Message& request, Autopilot& autopilot, Answers& answers);
  // Forgets the file.
  void reboot();

 private:
  FileWords done(const Message& request, const FileWords& words, const Autopilot& autopilot, Message& reply,
                 Answers& before);
  void close(Autopilot& autopilot);
};
static_assert(std::has_unique_object_representations<FileServer>::value, "folded by its bytes");
