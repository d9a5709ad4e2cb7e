// The library as it ships, in a sketch: it uploads a plan, and then does one thing.
#pragma once

#include <MavMission.h>

#include "MemoryStream.h"
#include "Modes.h"

enum class Task : uint8_t {
  Start,
  TakeOff,
  GoTo,
  Pause,
  Resume,
  ReturnHome,
  LandNow,
  Follow,
  Arm,
  Disarm,
  StartMission,
  SetMode,
  VerifyAndStart,
  Upload,
  Clear
};
constexpr uint16_t kItems = 3;             // in its plan
constexpr int kTasks = 15, kFlights = 13;  // an aircraft is flown, or made ready to fly, in so many of them
constexpr const char* kTaskNames[kTasks] = {"start",        "takeOff", "goTo",           "pause",  "resume",
                                            "returnHome",   "landNow", "follow",         "arm",    "disarm",
                                            "startMission", "setMode", "verifyAndStart", "upload", "clear"};
inline bool isStart(Task task) { return task == Task::Start || task == Task::VerifyAndStart; }
inline bool isInAir(Task task) {
  return (task >= Task::GoTo && task <= Task::Follow) || task == Task::StartMission || task == Task::SetMode;
}

class Sketch {
 public:
  explicit Sketch(Kind kind);

  MemoryStream line;
  mavmission::MissionClient client;
  mavmission::MissionFollower follower;
  mavmission::Steering steering;
  mavmission::MovingTarget target;

  mavmission::Status begin(Task task);
  // Names the vehicle that it speaks to.
  void name(uint8_t systemId, Kind kind);
  // Does what loop() does. Returns true when the task, or the upload, has ended: see status().
  bool loop(uint32_t nowMs);
  mavmission::Status status() const { return status_; }

 private:
  mavmission::Status take(mavmission::Status begun);

  Kind kind_;
  Task task_ = Task::Start;
  bool isRunning_ = false;
  mavmission::Status status_ = mavmission::Status::Idle;
  uint32_t followedMs_ = 0;  // when it began to be followed
};

// Returns the mode of an actor who lets it land, or stops a rover: not by HOLD where pause() sets that itself first
// (docs/in_control.md).
uint16_t modeOfLanding(Kind kind, Task task);

// Returns the mode in which the aircraft flies when the task is done; kNoSuchMode if the task leaves it as it was.
uint16_t modeWanted(Kind kind, Task task);
