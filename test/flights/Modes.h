// Which autopilot flies, and its modes: ArduPilot's custom modes, PX4's main mode and, above it, its sub mode.
#pragma once

#include <stdint.h>

enum class Kind : uint8_t { Copter, Rover, Px4 };
constexpr const char* kKinds[] = {"Copter", "Rover", "PX4"};

// What a mode means. In Pilot the sticks fly; the sketch never orders it.
// In First an ArduPilot is at the beginning.
enum class Means : uint8_t { Mission, Guided, Hold, Return, Land, TakeOff, Offboard, Pilot, First };
constexpr const char* kMeanings[] = {"MISSION", "GUIDED",   "HOLD",  "RETURN", "LAND",
                                     "TAKEOFF", "OFFBOARD", "PILOT", "ANOTHER"};

constexpr uint16_t kNoSuchMode = 0xFFFF;

constexpr uint16_t kModes[3][9] = {
    {3, 4, 17, 6, 9, kNoSuchMode, kNoSuchMode, 5, 2},                                    // LOITER, ALT_HOLD
    {10, 15, 4, 11, kNoSuchMode, kNoSuchMode, kNoSuchMode, 3, 1},                        // STEERING, ACRO
    {4 | 4 << 8, kNoSuchMode, 4 | 3 << 8, 4 | 5 << 8, 4 | 6 << 8, 4 | 2 << 8, 6, 3, 2},  // POSITION, ALTITUDE
};

constexpr uint16_t modeOf(Kind kind, Means means) {
  return kModes[static_cast<uint8_t>(kind)][static_cast<uint8_t>(means)];
}

inline const char* modeName(Kind kind, uint16_t mode) {
  for (int i = 0; i < 9; ++i) {
    if (kModes[static_cast<uint8_t>(kind)][i] == mode) return kMeanings[i];
  }
  return "a mode";
}
