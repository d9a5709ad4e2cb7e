// One flight: a sketch, an autopilot, the line between them, actors; all of it decided by the plan of the flight.
#pragma once

#include <memory>
#include <random>

#include "Actor.h"
#include "ArduPilot.h"
#include "Line.h"
#include "Px4.h"
#include "Referee.h"

struct FlightPlan {
  Kind kind = Kind::Copter;
  Task task = Task::Start;
  bool isInOwnMode = false;  // in the air: in the sketch's own mode at the beginning, and not in its mission
  double loss = 0;           // of the bytes
  uint32_t seed = 1;         // of what is lost, and of when the autopilot's heartbeats come
  std::vector<Act> acts;
};

struct Flown {
  std::string broken;  // the rule; empty: none
  mavmission::Status status = mavmission::Status::Idle;
  int32_t tookMs = 0;
  bool hasTaken = false, isUnseen = false;
  uint32_t longestWindowMs = 0, longestUndoneMs = 0;
  std::vector<uint32_t> undoneMs;  // of each mode that was undone and set again
  std::vector<int32_t> moments;    // when a frame left or arrived, since the task began
};

// `log`: what happened, in words; may be null.
Flown fly(const FlightPlan& plan, std::string* log);
