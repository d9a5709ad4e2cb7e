// The MissionClient under test: the library's own code, on a stream that the exploration feeds. It lies in the state of
// the world as plain bytes, and is put into its rest form after each step: times as if it were always the same moment,
// and nothing left in it that no code will read again. The rest form is what goes on, so that a wrong one would show.
//
// This file is compiled without access control: the rest form and the next timer are about private members.
#pragma once

#include <stdint.h>

#include <vector>

#include "Message.h"
#include "Referee.h"
#include "mavmission/client/MissionClient.h"
#include "mavmission/files/PlanFiles.h"

// What a client has sent and how it ended in a step.
struct Doing {
  std::vector<Bytes> frames;
  bool isRestless;  // it did not come to rest
  bool hasEnded;
  mavmission::Status status;
};

class ClientUnderTest {
 public:
  // As after power-on, the autopilot named and heard. `isFresh`: the first ten seconds, in which an earlier transfer
  // may still be answered, have not passed.
  void construct(Firmwares firmware, bool isFresh, bool isLossy, bool hasFiles);
  void begin(const Task& task);
  void cancel();
  // Time passes [ms]; the bytes come; update() runs until it has nothing to do. `isLast`: no operation follows.
  Doing run(uint16_t ms, const uint8_t* bytes, size_t length, bool isLast);
  // Until it does something of its own accord [ms], or kNever.
  uint16_t nextMs() const;
  // The line has been seen to lose: it sends again sooner, and more often.
  bool isHurried() const { return client().link_.pace_.isLossy(); }
  static constexpr uint16_t kRoundTripMs = 200;
  // Of PlanFiles. A file that was left open is closed with the next heartbeat, which is seen only then.
  bool waitsForHeartbeat() const;
  uint16_t lastNumber() const { return hasFiles_ != 0 ? files().sequence_ : 0; }
  // Numbers of requests count from another one.
  void renumber(uint16_t by);
  mavmission::Aboard aboard(uint8_t type) const { return client().aboard(static_cast<mavmission::PlanType>(type)); }

 private:
  class Awake;
  typedef mavmission::MissionClient Client;
  typedef mavmission::PlanFiles Files;
  Client& client() { return *reinterpret_cast<Client*>(hasFiles_ != 0 ? clientAwake : bytes_); }
  Files& files() { return *reinterpret_cast<Files*>(filesAwake); }
  const Files& files() const { return *reinterpret_cast<const Files*>(fileBytes_); }
  const mavmission::MissionClient& client() const {
    return *reinterpret_cast<const mavmission::MissionClient*>(bytes_);
  }
  void rest(uint16_t ms, bool isLast);
  bool waitsForLateAnswers() const;
  uint16_t lateMs() const;
  void restFiles(uint16_t ms);
  uint16_t nextOfFilesMs() const;

  // PlanFiles and its client know each other by address: they are run in this place.
  alignas(8) static uint8_t clientAwake[sizeof(Client)];
  alignas(8) static uint8_t filesAwake[sizeof(Files)];

  alignas(8) uint8_t bytes_[(sizeof(Client) + 7) / 8 * 8];
  alignas(8) uint8_t fileBytes_[(sizeof(Files) + 7) / 8 * 8];
  uint64_t hasFiles_;
};

// The items that the running download has given to the sketch, in their order: those of the client that runs next.
struct Sunk {
  uint8_t count;
  uint8_t type;
  uint8_t items[14];
};
extern Sunk* sunk;
