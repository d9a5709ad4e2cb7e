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
  Stall,      // the sketch's loop() stands still for `amount` ms
  Silent,     // the autopilot neither hears nor says anything for `amount` ms; the second vehicle is heard from now on
  Stranger    // from now on a device is heard once a second: kStrangers[amount]
};
constexpr int kWhats = 14;
constexpr const char* kWhatNames[kWhats] = {"pilot",      "lands",     "holds",  "disarms", "failsafe",
                                            "other-plan", "same-plan", "clears", "cut",     "lose-up",
                                            "lose-down",  "stall",     "silent", "stranger"};

// Devices that are no autopilot of ours, by their heartbeats (MAV_TYPE, MAV_AUTOPILOT).
struct Stranger {
  uint8_t systemId, componentId, type, autopilot;
};
constexpr Stranger kStrangers[] = {
    {1, 158, 0, 0},    // a peripheral, as a script sends it
    {1, 156, 27, 0},   // an ADS-B receiver
    {1, 156, 2, 0},    // the same that says it is a copter
    {1, 100, 30, 8},   // a camera
    {1, 154, 26, 0},   // a gimbal
    {1, 191, 18, 8},   // a second Arduino, with our own ids
    {1, 192, 18, 0},   // a computer aboard
    {2, 1, 2, 3},      // another copter
    {2, 1, 10, 12},    // a PX4 that drives
    {2, 1, 2, 0},      // an autopilot that says no name
    {255, 190, 6, 8},  // a ground station
    {255, 190, 0, 0},  // one that does not say what it is
};
constexpr uint32_t kStrangerCount = sizeof(kStrangers) / sizeof(kStrangers[0]);

// In the place of a time: from the beginning, before the autopilot is heard.
constexpr int32_t kAlways = -99999;

struct Act {
  What what;
  int32_t atMs;     // the time since the task began, or since `order` left
  uint32_t amount;  // ms, frames or a number, as `what` says; of a pilot and of a station: which vehicle (0 or 1)
  unsigned order;   // 0: the time counts from the task's beginning; n: from when its n-th order left
};

inline std::string inWords(const Act& act) {
  return std::string(kWhatNames[static_cast<int>(act.what)]) + "@" +
         (act.order != 0 ? std::to_string(act.order) + "+" : "") + std::to_string(act.atMs) +
         (act.amount != 0 ? "=" + std::to_string(act.amount) : "");
}
