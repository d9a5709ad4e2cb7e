// Everything at one moment: the client, the autopilot, the frames between them, the referee; and the steps from one
// moment to the next. It is plain data without a gap, so that two worlds are the same when their bytes are.
#pragma once

#include <string>
#include <vector>

#include "Autopilot.h"
#include "ClientUnderTest.h"
#include "FileReferee.h"
#include "FileServer.h"
#include "Line.h"
#include "Referee.h"

// What may happen, and how often. Losses and copies are counted only where their number is bounded.
struct Mishaps {
  static constexpr uint8_t kAnyNumber = 255;

  uint8_t losses = kAnyNumber;
  uint8_t faults = 0;       // frames that are repeated, delayed or damaged
  uint8_t reboots = 0;      // of the autopilot
  uint8_t cancels = 0;      // by the sketch, of what runs then
  uint8_t resets = 0;       // of the Arduino in the first task
  uint8_t copies = 0;       // frames that come once more, some time later
  uint8_t hasTwoLinks = 0;  // or that time later alone
  uint8_t others = 0;       // requests of another client to the server of files

  bool canBe() const { return (losses | faults | reboots | cancels | others | copies) != 0; }
};

// What is explored.
struct Scenario : Mishaps {
  Firmwares firmware = Firmwares::ArduPilot;
  std::vector<Task> tasks;  // each begins when the one before has ended, however, or is broken off
  uint8_t heldPlan = 0;     // what is aboard at the beginning
  uint8_t heldItems = 2;
  uint8_t heldBeside = 0;  // items of the other kind of plan
  uint16_t latencyMs = 0;  // each way
  uint8_t refused = 0;     // the wire item that ArduPilot does not take; 0: none
  bool isLossy = false;    // the client takes the line for one that loses, from the beginning
  // The kind of plan beside the mission: a fence or rally points.
  uint8_t otherType() const;
  bool hasFiles() const { return !tasks.empty() && isByFiles(tasks.front().operation); }
};

enum class Choice : uint8_t { Event, Reboot, Cancel, Reset, OtherOpens, OtherCreates, OtherWrites, OtherEnds };

struct Move {
  Choice choice;
  Fate fate;  // of the frame that is due, where one is
};

struct Moves {
  static constexpr int kMost = 20;
  Move list[kMost];
  uint8_t count;
  void add(Choice choice, Fate fate = Fate::Delivered) { list[count++] = Move{choice, fate}; }
};

// What a step did.
struct Outcome {
  const char* broken = nullptr;  // the rule
  uint16_t ms = 0;
  bool isFault = false;
  bool hasEnded = false;
  uint8_t task = 0;
  mavmission::Status status = mavmission::Status::Idle;
};

class World {
 public:
  // All zero, then this.
  Outcome begin(const Scenario& scenario);
  // What can happen next; nothing at the end.
  Moves moves() const;
  // `log`: what happened, in words; may be null.
  Outcome step(const Scenario& scenario, const Move& move, std::string* log);
  // At the end: null, or what is left undone.
  const char* leftUndone() const;

 private:
  enum class Event : uint8_t { None, ToAutopilot, Autopilot, ToClient, Heartbeat, Client };
  Event next(uint16_t& ms) const;
  Outcome runClient(const Scenario& scenario, uint16_t ms, const Bytes& bytes, std::string* log);
  const char* answer(const Answers& answers, std::string* log);
  const char* sent(const Message& message, Firmwares firmware);
  void heard(const Message& message, Firmwares firmware);
  const char* end(const Doing& doing, bool lineRepeats);
  bool isAlive(mavmission::Status status) const;
  Outcome hearOther(Choice choice, std::string* log);
  void loseFilesOfBefore();
  bool isSure(const Message& message) const;
  void renumber();
  void beginTask(const Scenario& scenario, std::string* log);
  bool isLastTask(const Scenario& scenario) const { return task_ + 1u >= scenario.tasks.size(); }
  void pass(uint16_t ms);

  ClientUnderTest client_;
  Autopilot& planOf(uint8_t type) { return type == kMission ? autopilot_ : beside_; }

  Autopilot autopilot_;
  Autopilot beside_;  // its plan of another kind
  Autopilot before_;  // of the kind that the operation is about, as it was when that began
  Line toAutopilot_;
  Line toClient_;
  Referee referee_;
  Sunk sunk_;
  uint8_t task_;
  FileServer files_;
  FileReferee fileReferee_;
  uint16_t heartbeatInMs_;  // of the autopilot; kNever where nobody waits for it
  Mishaps left_;            // what may still happen
  uint8_t isUndisturbed_;   // nothing can happen to the operation any more
  uint8_t spare_[3];
};
static_assert(std::is_trivially_copyable<World>::value, "copied and folded by its bytes");
