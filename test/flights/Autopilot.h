// A small model of an autopilot: its modes, its arming, its answers to commands, a climb and a descent, its plan. It
// does what recordings and sources of the real ones show; what the flights do not need is left out.
#pragma once

#include <vector>

#include "Modes.h"
#include "PlanFrames.h"
#include "mavmission/base/MavlinkHeaders.h"

// This says who has brought a change about.
enum class By : uint8_t { Order, Actor, Itself };

// It is told of each change.
class Witness {
 public:
  virtual void modeSet(uint16_t mode, By by) = 0;
  virtual void armed(bool isArmed, By by) = 0;
  virtual void planSet(bool isOurs, By by) = 0;

 protected:
  ~Witness() = default;
};

class Autopilot {
 public:
  Autopilot(Kind kind, uint8_t systemId, Witness& witness, uint32_t firstBeatMs);

  const Kind kind;
  const uint8_t systemId;  // also of the sketch that it answers
  bool isArmed = false;
  uint16_t mode;
  int32_t heightCm = 0;
  std::vector<Bytes> plan;  // MISSION_ITEM_INTs, without home

  void hear(const FrameParts& message, uint32_t nowMs);
  // Lets time go on to this moment.
  void pass(uint32_t nowMs);
  uint32_t nextMs() const;
  std::vector<FrameParts> takeSent();

  // Puts it in the air, in its mission.
  void putInAir(uint32_t nowMs);
  // These are what actors do to it.
  void actorSetsMode(uint16_t mode, bool isFailsafe, uint32_t nowMs);
  void actorDisarms();
  void actorSetsPlan(int moreItems);  // so many items longer than the plan aboard
  void clear();
  bool isAirborne() const { return heightCm > 10; }

 private:
  // Each returns a MAV_RESULT.
  uint8_t command(const mavlink_command_long_t& command, bool isInt, uint32_t nowMs);
  uint8_t arm(bool arms);
  uint8_t orderMode(uint16_t wanted, uint32_t nowMs);
  uint8_t startMission(float first, uint32_t nowMs);
  uint8_t takeOff(float height, uint32_t nowMs);
  uint8_t refusal() const { return isPx4() ? MAV_RESULT_TEMPORARILY_REJECTED : MAV_RESULT_FAILED; }

  void hearTarget(uint32_t nowMs);
  void hearSetCurrent(uint16_t item, uint32_t nowMs);
  void modeChanged(uint32_t nowMs);
  void disarmed();
  uint8_t state() const;  // MAV_STATE
  uint32_t customMode() const;
  FrameParts itemToRead(uint16_t item) const;
  uint32_t planId() const;
  int32_t heightGoal() const;     // [cm]; its own height if it is to stay there
  void atHeight(uint32_t nowMs);  // called when it has climbed or sunk to its goal
  void beat(uint32_t nowMs);      // called ten times a second

  bool is(Means means) const { return mode == modeOf(kind, means); }
  bool isPx4() const { return kind == Kind::Px4; }
  void setMode(uint16_t wanted, uint32_t nowMs);
  void setArmed(bool isArmed);
  void send(const FrameParts& message, uint32_t atMs);
  // Sends a message that is filled in at the moment at which it leaves.
  void sendFresh(uint32_t id, uint32_t atMs) { send(FrameParts(id, Bytes()), atMs); }
  void setStream(uint32_t id, uint32_t everyMs, uint32_t nextMs);
  uint16_t firstItem() const { return isPx4() ? 0 : 1; }

  struct Sending {
    uint32_t atMs;
    FrameParts message;
  };
  // A message that is sent again and again; never, where the interval is 0.
  struct Stream {
    uint32_t id, everyMs, nextMs;
  };
  FrameParts composed(uint32_t id) const;
  void hearCommand(const mavlink_command_long_t& command, bool isInt, uint32_t nowMs);
  void hearMission(const FrameParts& message, uint32_t nowMs);
  void askForItem(uint32_t nowMs);
  void lookForItem(uint32_t nowMs);
  void acknowledge(uint8_t result, uint32_t nowMs);
  void take(const std::vector<Bytes>& items, bool isOurs);

  uint16_t current_ = 0;
  bool isInFailsafe_ = false;
  bool mayClimb_ = false;  // the mission mode has been begun
  int32_t goalCm_ = -1;    // the height of a takeoff; -1: there is none
  By by_ = By::Itself;
  uint32_t streamedMs_ = 0;     // PX4: when the last target came
  bool hasLostStream_ = false;  // and that none comes any more
  Witness& witness_;
  std::vector<Sending> sending_;
  std::vector<FrameParts> sent_;
  std::vector<Stream> streams_;  // in the order of their ids
  uint32_t movedMs_ = 0;
  uint32_t landedMs_ = 0;
  bool isReceiving_ = false;
  uint32_t askedMs_ = 0, heardMs_ = 0;  // when it has asked for an item, and when the last one came
  uint16_t announced_ = 0, expected_ = 0;
  std::vector<Bytes> received_;
};
