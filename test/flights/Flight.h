// One flight: a sketch, an autopilot or two, the line between them, actors; all of it decided by the plan of the
// flight.
#pragma once

#include <memory>

#include "Actor.h"
#include "Line.h"
#include "Random.h"
#include "Referee.h"

struct FlightPlan {
  Kind kind = Kind::Copter;
  Task task = Task::Start;
  bool isInOwnMode = false;  // it begins in the air in the sketch's own mode, not in the mission
  double loss = 0;           // this share of the bytes is lost
  uint32_t seed = 1;         // decides what is lost, and when the autopilot's heartbeats come
  uint16_t buffer = 63;      // bytes that are received while loop() stands still
  uint8_t second = 0;        // the second vehicle: 0: there is none; else 1 + its kind, and 3 more if it flies
  std::vector<Act> acts;
};

struct Flown {
  std::string broken;  // the rule that was broken; empty if none was
  mavmission::Status status = mavmission::Status::Idle;
  int32_t tookMs = 0;
  Figures figures;
  std::vector<int32_t> moments;  // the times since the task began at which a frame left or arrived
};

// `log` takes what happened, in words; it may be null.
Flown fly(const FlightPlan& plan, std::string* log);

// So many operations at random, one behind the other, beside actors at random and a second vehicle, which the sketch
// names at times. `ends` counts how they ended.
Flown play(const FlightPlan& plan, unsigned operations, std::string* log, std::vector<mavmission::Status>& ends);
