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
#include "mavmission/MissionClient.h"

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
  void construct(Firmwares firmware, bool isFresh, bool isLossy);
  void begin(const Task& task);
  void cancel();
  // Time passes [ms]; the bytes come; update() runs until it has nothing to do. `isLast`: no operation follows.
  Doing run(uint16_t ms, const uint8_t* bytes, size_t length, bool isLast);
  // Until it does something of its own accord [ms], or kNever.
  uint16_t nextMs() const;
  // The line has been seen to lose: it sends again sooner, and more often.
  bool isHurried() const { return client().link_.pace_.isLossy(); }
  static constexpr uint16_t kRoundTripMs = 200;
  bool isBusy() const { return client().isBusy(); }
  mavmission::Aboard aboard() const { return client().aboard(); }

 private:
  mavmission::MissionClient& client() { return *reinterpret_cast<mavmission::MissionClient*>(bytes_); }
  const mavmission::MissionClient& client() const {
    return *reinterpret_cast<const mavmission::MissionClient*>(bytes_);
  }
  void rest(uint16_t ms, bool isLast);

  alignas(8) uint8_t bytes_[(sizeof(mavmission::MissionClient) + 7) / 8 * 8];
};

// The items that the running download has given to the sketch, in their order: those of the client that runs next.
struct Sunk {
  uint8_t count;
  uint8_t items[7];
};
extern Sunk* sunk;
