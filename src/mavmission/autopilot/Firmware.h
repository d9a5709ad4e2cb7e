// The autopilots that the library knows.
#pragma once

#include <stdint.h>

#include "../base/FlashText.h"

namespace mavmission {

// The autopilot's software (HEARTBEAT.autopilot), with its name. autopilot/Personality.h lists the differences.
#define MAVMISSION_FIRMWARES(X)                                                                                    \
  X(Unknown, "no autopilot is heard")                                                                              \
  X(ArduPilot, "ArduPilot")                                  /* MAV_AUTOPILOT_ARDUPILOTMEGA */                     \
  X(Px4, "PX4")                                              /* MAV_AUTOPILOT_PX4 */                               \
  X(Other, "an autopilot that is neither ArduPilot nor PX4") /* the protocol as the guide has it */                \
  X(Betaflight, "Betaflight")                                /* MAV_AUTOPILOT_GENERIC, with a macro of Config.h */ \
  X(Inav, "iNav")                                            /* the same */

// The autopilot's software, by HEARTBEAT.autopilot.
enum class Firmware : uint8_t {
#define MAVMISSION_NAME(name, text) name,
  MAVMISSION_FIRMWARES(MAVMISSION_NAME)
#undef MAVMISSION_NAME
};

// In words, for Serial.print(). Flash text; null for a value that is no Firmware.
FlashText nameOf(Firmware firmware);

}  // namespace mavmission
