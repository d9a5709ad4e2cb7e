// Every world that a scenario can come to: breadth first, so that what breaks a rule is reached by the fewest steps. A
// world is known again by 128 bits of hash of its bytes.
#pragma once

#include <map>
#include <string>

#include "World.h"

struct Findings {
  uint64_t states = 0;
  uint64_t operations = 0;  // how many have ended, in walks (Walk.h) and at consoles (Typed.h)
  uint64_t transitions = 0;
  uint64_t violations = 0;
  bool isWhole = false;                  // false: more states than allowed
  std::map<std::string, uint64_t> ends;  // "1 accepted" and the like: how many transitions end an operation so
  uint32_t longestMs = 0;                // the longest way from the beginning to the end of the last operation
  int fewestFaults = -1;                 // with which an operation ends without success; -1: none does
  std::string fewestFaultsTrace;
  std::string broken;  // the first rule that was broken, and how it came to that
  std::string trace;
};

Findings explore(const Scenario& scenario, uint64_t mostStates);
