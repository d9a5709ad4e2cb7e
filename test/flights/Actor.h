// What happens beside the sketch and the autopilot, at one moment.
#pragma once

#include <stdint.h>

#include <string>

enum class What : uint8_t {
  Pilot,      // sets a mode that flies by the sticks
  Lands,      // sets LAND
  Holds,      // sets HOLD, which on PX4 is the mode of before
  Disarms,    // disarms it, wherever it is
  Failsafe,   // makes it return
  OtherPlan,  // another station's plan, one item longer
  SamePlan,   // and one of the same length
  Clears,     // another station clears the plan
  Cut,        // the line is cut for so many ms
  LoseUp,     // so many frames to the autopilot are lost
  LoseDown,   // and to the sketch
  Stall       // the sketch's loop() stands still for so many ms
};
constexpr int kWhats = 12;
constexpr const char* kWhatNames[kWhats] = {"pilot",     "lands",  "holds", "disarms", "failsafe",  "other-plan",
                                            "same-plan", "clears", "cut",   "lose-up", "lose-down", "stall"};

struct Act {
  What what;
  int32_t atMs;     // since the task began, or since that order
  uint32_t amount;  // ms, or frames
  unsigned order;   // 0: since the task began; else since the task's first, second... order has left
};

inline std::string inWords(const Act& act) {
  return std::string(kWhatNames[static_cast<int>(act.what)]) + "@" +
         (act.order != 0 ? std::to_string(act.order) + "+" : "") + std::to_string(act.atMs) +
         (act.amount != 0 ? "=" + std::to_string(act.amount) : "");
}
