// What happens beside the sketch and the autopilot, at one moment.
#pragma once

#include <stdint.h>

#include <string>

enum class What : uint8_t {
  Pilot,      // a pilot sets a mode in which the sticks fly
  Lands,      // somebody sets LAND
  Holds,      // somebody sets HOLD; on PX4 this is the earlier mode
  Disarms,    // somebody disarms the aircraft, also in the air
  Failsafe,   // a failsafe sets the mode that returns home
  OtherPlan,  // another station uploads a plan with one item more
  SamePlan,   // another station uploads a plan of the same length
  Clears,     // another station clears the plan
  Cut,        // the line is cut for `amount` ms
  LoseUp,     // the next `amount` frames to the autopilot are lost
  LoseDown,   // the next `amount` frames to the sketch are lost
  Stall       // the sketch's loop() stands still for `amount` ms
};
constexpr int kWhats = 12;
constexpr const char* kWhatNames[kWhats] = {"pilot",     "lands",  "holds", "disarms", "failsafe",  "other-plan",
                                            "same-plan", "clears", "cut",   "lose-up", "lose-down", "stall"};

struct Act {
  What what;
  int32_t atMs;     // the time since the task began, or since `order` left
  uint32_t amount;  // ms or frames, as `what` says
  unsigned order;   // 0: the time counts from the task's beginning; n: from when its n-th order left
};

inline std::string inWords(const Act& act) {
  return std::string(kWhatNames[static_cast<int>(act.what)]) + "@" +
         (act.order != 0 ? std::to_string(act.order) + "+" : "") + std::to_string(act.atMs) +
         (act.amount != 0 ? "=" + std::to_string(act.amount) : "");
}
