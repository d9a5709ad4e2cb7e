// Every world that a scenario can come to: breadth first, so that what breaks a rule is reached by the fewest steps;
// the first rule that is broken ends it. A world is known again by 128 bits of hash of its bytes.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "World.h"

struct Findings {
  uint64_t states = 0;
  uint64_t operations = 0;  // how many have ended, in walk() and type()
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

// What is drawn by each of these seeds, until a rule is broken. `run`: null, or the rule that it breaks; it notes what
// it has found, or tells it in words, where the one or the other is not null.
Findings findBySeeds(uint32_t seed, unsigned count,
                     const std::function<const char*(uint32_t, Findings*, std::string*)>& run);

// One way at random through each of many scenarios, which are drawn as well: what needs more mishaps than the
// exploration of every way can follow. Three operations one behind the other, on a line that loses and doubles many
// frames, beside reboots and cancels; from seed `seed` on.
Findings walk(Firmwares firmware, uint32_t seed, unsigned count);

// A PlanConsole that is typed at at random, while operations run, on links that lose, double and delay frames.
Findings type(Firmwares firmware, uint32_t seed, unsigned sessions);
