// An ArduPilot on a line in memory that gives and takes its plans as files, and what it is asked for word by word.
#pragma once

#include <string.h>

#include <map>
#include <string>

#include "ClientOnLine.h"
#include "PlanFrames.h"
#include "mavmission/base/MavlinkHeaders.h"

class FilePilot : public ClientOnLine {
 public:
  enum : uint8_t { kTerminate = 1, kOpen = 4, kRead = 5, kCreate = 6, kWrite = 7, kBurst = 15 };  // MAV_FTP_OPCODE
  enum : int { kFail = 1, kInvalidSession = 4, kFileNotFound = 10 };                              // MAV_FTP_ERR
  enum : int { kSilent = -1, kUnheard = -2 };  // it is done without an answer; not even that

  mavmission::PlanFiles files;
  std::vector<Bytes> plans[3];  // by MAV_MISSION_TYPE: the items, of a mission with home, as MISSION_ITEM_INT
  uint8_t type = 0;             // of the file that was opened last
  uint8_t baseMode = 0;
  uint8_t version = 2;         // of MAVLink
  std::map<int, int> gives;    // by opcode: the error, or what becomes of it; 0: it is done
  std::map<int, int> once;     // the same for the next one alone
  uint16_t lostItem = 0xFFFF;  // of a burst, this one is lost
  uint32_t delayMs = 5;
  uint32_t stored = 0;  // how often a plan has been stored
  Bytes header;         // of the file that was stored last

  // The last request.
  uint16_t sequence = 0;
  uint8_t session = 0;

  explicit FilePilot(uint8_t autopilot = kArduPilot);

  void pass(uint32_t ms);
  mavmission::Status end(uint32_t limitMs = 60000);
  // Until this has been asked for; false if it is not.
  bool passUntil(const std::string& words, uint32_t limitMs = 20000);
  std::string said();
  std::vector<uint32_t> saidMs;
  uint32_t tookMs = 0;

  // The plan that an earlier upload has left aboard.
  void hold(const std::vector<mavmission::MissionItem>& plan);
  // An item of a file; what is not set is 0 in it.
  Bytes bytesOf(mavmission::MissionItem item, uint16_t seq) const;
  mavlink_mission_item_int_t itemAboard(size_t number) const;
  Bytes home() const;
  void beat();
  // A reply of its own making.
  void reply(uint16_t number, uint8_t inSession, uint8_t opcode, uint8_t requested, uint32_t offset, const Bytes& data,
             bool isComplete = false);
  void refuse(uint16_t number, uint8_t requested, uint8_t error) { reply(number, session, 129, requested, 0, {error}); }

 private:
  struct Due {
    uint16_t number;
    uint8_t session, opcode, requested;
    uint32_t offset;
    Bytes data;
    bool isComplete;
  };

  void one();
  void in(uint32_t ms, const Due& due) { due_.insert({nowMs() + ms, due}); }

  static uint32_t longAt(const Bytes& bytes, size_t at);

  void react(const Bytes& request);

  Bytes file() const;
  Bytes part(uint32_t offset, uint8_t size) const;
  void burst(uint16_t number, uint32_t offset);
  void store();

  bool isPx4_;
  Bytes written_;
  std::multimap<uint32_t, Due> due_;
  std::vector<std::string> said_;
};
