#include "Commands.h"

#include "Flash.h"

namespace mavmission {
namespace {

struct Row {
  uint16_t command;
  uint8_t traits;
};

// Observed on ArduCopter and ArduRover 4.6.3 and on PX4 1.17.0: test/recordings/readback_*.csv has what each said to
// each of these. Yaws are those of MAV_CMD's table in the MAVLink common messages.
const Row kRows[] PROGMEM = {
    {16, kYawInParam4},                          // NAV_WAYPOINT
    {17, kYawInParam4},                          // NAV_LOITER_UNLIM
    {18, kNotFlownByPx4},                        // NAV_LOITER_TURNS
    {20, kHasNoPlace},                           // NAV_RETURN_TO_LAUNCH
    {21, kYawInParam4 | kPlaceIsOptional},       // NAV_LAND
    {22, kYawInParam4 | kPlaceIsOptional},       // NAV_TAKEOFF
    {82, kNotFlownByPx4},                        // NAV_SPLINE_WAYPOINT
    {84, kYawInParam4 | kPlaceIsOptional},       // NAV_VTOL_TAKEOFF
    {85, kYawInParam4 | kPlaceIsOptional},       // NAV_VTOL_LAND
    {93, kHasNoPlace},                           // NAV_DELAY
    {94, kNotFlownByPx4},                        // NAV_PAYLOAD_PLACE
    {112, kHasNoPlace},                          // CONDITION_DELAY
    {114, kHasNoPlace},                          // CONDITION_DISTANCE
    {115, kHasNoPlace | kNotFlownByPx4},         // CONDITION_YAW
    {177, kHasNoPlace},                          // DO_JUMP
    {178, kHasNoPlace},                          // DO_CHANGE_SPEED
    {181, kHasNoPlace | kNotFlownByPx4},         // DO_SET_RELAY
    {182, kHasNoPlace | kNotFlownByPx4},         // DO_REPEAT_RELAY
    {183, kHasNoPlace | kNotFlownByPx4},         // DO_SET_SERVO
    {184, kHasNoPlace | kNotFlownByPx4},         // DO_REPEAT_SERVO
    {187, kHasNoPlace | kNotFlownByArduPilot},   // DO_SET_ACTUATOR
    {189, kNoPlaceOnPx4},                        // DO_LAND_START
    {197, kHasNoPlace},                          // DO_SET_ROI_NONE
    {203, kHasNoPlace},                          // DO_DIGICAM_CONTROL
    {205, kHasNoPlace},                          // DO_MOUNT_CONTROL
    {206, kHasNoPlace},                          // DO_SET_CAM_TRIGG_DIST
    {207, kHasNoPlace | kNotFlownByPx4},         // DO_FENCE_ENABLE
    {211, kHasNoPlace},                          // DO_GRIPPER
    {600, kHasNoPlace | kNotFlownByPx4},         // JUMP_TAG
    {601, kHasNoPlace | kNotFlownByPx4},         // DO_JUMP_TAG
    {1000, kHasNoPlace},                         // DO_GIMBAL_MANAGER_PITCHYAW
    {2000, kHasNoPlace},                         // IMAGE_START_CAPTURE
    {2001, kHasNoPlace},                         // IMAGE_STOP_CAPTURE
    {42600, kHasNoPlace},                        // DO_WINCH
};

}  // namespace

uint8_t traitsOf(uint16_t command) {
  for (const Row& row : kRows) {
    if (fromFlash(&row.command) == command) return fromFlash(&row.traits);
  }
  return 0;
}

}  // namespace mavmission
