// A command to be carried out now (MAV_CMD), not as an item of a plan.
#pragma once

#include "../item/MissionItem.h"

namespace mavmission {

// COMMAND_LONG, or COMMAND_INT for a command with coordinates. A plain struct; the functions below make one.
struct FlightCommand {
  float param1, param2, param3, param4;  // meaning by command
  float param5, param6;                  // of COMMAND_LONG
  float param7;                          // or the altitude
  int32_t x, y;                          // of COMMAND_INT: latitude, longitude [1e-7 deg]
  uint16_t id;                           // MAV_CMD
  CoordinateFrame frame;                 // of COMMAND_INT
  bool hasPlace;                         // it is sent as COMMAND_INT
};

// Any command, with the meaning that MAV_CMD gives its parameters...
constexpr FlightCommand flightCommand(uint16_t id, float param1 = 0, float param2 = 0, float param3 = 0,
                                      float param4 = 0, float param5 = 0, float param6 = 0, float param7 = 0) {
  return FlightCommand{param1, param2, param3, param4, param5, param6, param7, 0, 0, id, CoordinateFrame::Mission,
                       false};
}
// ... and one with coordinates.
constexpr FlightCommand flightCommandAt(uint16_t id, Degrees latitude, Degrees longitude, Altitude altitude,
                                        float param1 = 0, float param2 = 0, float param3 = 0, float param4 = 0) {
  return FlightCommand{param1,        param2,         param3, param4,           0,   0, altitude.metres(),
                       latitude.e7(), longitude.e7(), id,     altitude.frame(), true};
}

// Whether a command is sent again if no answer comes.
enum class CommandRepeat : uint8_t {
  IfHarmless,  // except those that must not be carried out twice: servo, relay, gripper, winch, parachute, picture ...
  Always,
};

// True for a command that must not be carried out twice.
bool isOnceOnly(uint16_t id);

}  // namespace mavmission
