#include "Commands.h"

#include "Flash.h"
#include "Rules.h"

namespace mavmission {

using namespace keeping;

namespace {

constexpr uint8_t pair(uint8_t low, uint8_t high) { return static_cast<uint8_t>(low | high << 4); }

// What ArduPilot does with x, y and z.
enum class InArduPilot : uint8_t { NotTaken, None, Place, Optional, Configure, Shoot, Mount, Gimbal, Attitude, Fence, Rally };

struct More {
  uint8_t xy, zAndTraits;
};

const More kInArduPilot[] PROGMEM = {
    {pair(K, K), pair(K, kIsNotTaken)},
    {pair(D, D), pair(D, kHasNoPlace)},
    {pair(K, K), pair(Height, 0)},
    {pair(K, K), pair(Height, kPlaceIsOptional)},
    {pair(U8, U8), pair(K, kHasNoPlace)},
    {pair(U8, U8), pair(D, kHasNoPlace)},
    {pair(D, D), pair(MountMode, kHasNoPlace)},
    {pair(U8, D), pair(U8, kHasNoPlace)},
    {pair(I16, D), pair(D, kHasNoPlace)},
    {pair(K, K), pair(D, 0)},
    {pair(K, K), pair(I16, 0)},
};

// What PX4 does with such an item.
enum class InPx4 : uint8_t {
  NotTaken, Command, Place, Waypoint, Loiter, LoiterTime, LoiterToAltitude, Land, Takeoff, Roi, Jump, LandStart, Corner, Circle
};

const Rules kInPx4[] PROGMEM = {
    {{pair(K, K), pair(K, K), pair(K, K), pair(K, kIsNotTaken)}},
    {{pair(K, K), pair(K, K), pair(K, K), pair(K, kHasNoPlace)}},
    {{pair(D, D), pair(D, D), pair(K, K), pair(K, 0)}},
    {{pair(K, K), pair(D, Yaw360), pair(K, K), pair(K, 0)}},
    {{pair(D, D), pair(K, Yaw360), pair(K, K), pair(K, 0)}},
    {{pair(K, U1), pair(K, U1), pair(K, K), pair(K, 0)}},
    {{pair(U1, K), pair(D, U1), pair(K, K), pair(K, 0)}},
    {{pair(D, U16), pair(D, Yaw360), pair(K, K), pair(K, kPlaceIsOptional)}},
    {{pair(D, D), pair(D, Yaw360), pair(K, K), pair(K, kPlaceIsOptional)}},
    {{pair(Special, D), pair(D, D), pair(K, K), pair(K, kAsItsFrameSays)}},
    {{pair(I16, U16), pair(K, K), pair(K, K), pair(K, kHasNoPlace)}},
    {{pair(K, K), pair(K, K), pair(Rounded, Rounded), pair(K, kHasNoPlace)}},
    {{pair(U16, D), pair(D, D), pair(K, K), pair(K, 0)}},
    {{pair(K, D), pair(D, D), pair(K, K), pair(K, 0)}},
};

struct Row {
  uint16_t command;
  uint8_t params12, params34, where;  // on ArduPilot; and what each autopilot does else
};

constexpr Row row(uint16_t command, uint8_t param1, uint8_t param2, uint8_t param3, uint8_t param4, InArduPilot arduPilot,
                  InPx4 px4) {
  return Row{command, pair(param1, param2), pair(param3, param4),
             pair(static_cast<uint8_t>(arduPilot), static_cast<uint8_t>(px4))};
}

constexpr uint8_t kPlaneRows = 2;  // of planes alone, before all others

// Observed on ArduCopter, ArduRover and ArduPlane 4.6.3 and on PX4 1.17.0: test/recordings has what each said to each of
// these, and what it kept (readback_*.csv, readback_random_*.csv); docs/readback.md has it in words. A command that is in
// no row was taken by none of them: it goes out, for a newer autopilot may.
const Row kRows[] PROGMEM = {
    row(16, D, U8, U8, NoYaw, InArduPilot::Place, InPx4::NotTaken),  // NAV_WAYPOINT on a plane: two distances, and no hold
    row(82, K, K, K, K, InArduPilot::NotTaken, InPx4::NotTaken),  // NAV_SPLINE_WAYPOINT on a plane
    row(16, U16, D, D, NoYaw, InArduPilot::Place, InPx4::Waypoint),  // NAV_WAYPOINT
    row(17, D, D, Radius, NoYaw, InArduPilot::Place, InPx4::Loiter),  // NAV_LOITER_UNLIM
    row(18, Special, D, Special, U1, InArduPilot::Place, InPx4::NotTaken),  // NAV_LOITER_TURNS
    row(19, U16, D, Sign, U1, InArduPilot::Place, InPx4::LoiterTime),  // NAV_LOITER_TIME
    row(20, D, D, D, D, InArduPilot::None, InPx4::Command),  // NAV_RETURN_TO_LAUNCH
    row(21, U16, D, D, Sign, InArduPilot::Optional, InPx4::Land),  // NAV_LAND
    row(22, U16, D, D, NoYaw, InArduPilot::Optional, InPx4::Takeoff),  // NAV_TAKEOFF
    row(30, U16, D, D, D, InArduPilot::Place, InPx4::NotTaken),  // NAV_CONTINUE_AND_CHANGE_ALT
    row(31, D, Radius, D, U1, InArduPilot::Place, InPx4::LoiterToAltitude),  // NAV_LOITER_TO_ALT
    row(80, K, K, K, K, InArduPilot::NotTaken, InPx4::Roi),  // NAV_ROI
    row(82, U16, D, D, D, InArduPilot::Place, InPx4::NotTaken),  // NAV_SPLINE_WAYPOINT
    row(83, K, K, U8, D, InArduPilot::None, InPx4::NotTaken),  // NAV_ALTITUDE_WAIT
    row(84, D, D, D, NoYaw, InArduPilot::Optional, InPx4::Takeoff),  // NAV_VTOL_TAKEOFF
    row(85, U16, D, D, NoYaw, InArduPilot::Optional, InPx4::Takeoff),  // NAV_VTOL_LAND
    row(92, U16, D, D, D, InArduPilot::Place, InPx4::NotTaken),  // NAV_GUIDED_ENABLE
    row(93, K, I8, I8, I8, InArduPilot::None, InPx4::Command),  // NAV_DELAY
    row(94, Centimetres, D, D, D, InArduPilot::Place, InPx4::NotTaken),  // NAV_PAYLOAD_PLACE
    row(112, K, D, D, D, InArduPilot::None, InPx4::Command),  // CONDITION_DELAY
    row(114, K, D, D, D, InArduPilot::None, InPx4::Command),  // CONDITION_DISTANCE
    row(115, K, K, I8, U8, InArduPilot::None, InPx4::NotTaken),  // CONDITION_YAW
    row(177, U16, I16, D, D, InArduPilot::None, InPx4::Jump),  // DO_JUMP
    row(178, U8, K, K, D, InArduPilot::None, InPx4::Command),  // DO_CHANGE_SPEED
    row(179, U16, D, D, D, InArduPilot::Place, InPx4::Command),  // DO_SET_HOME
    row(181, U8, U8, D, D, InArduPilot::None, InPx4::NotTaken),  // DO_SET_RELAY
    row(182, U8, I16, K, D, InArduPilot::None, InPx4::NotTaken),  // DO_REPEAT_RELAY
    row(183, U8, U16, D, D, InArduPilot::None, InPx4::NotTaken),  // DO_SET_SERVO
    row(184, U8, U16, I16, K, InArduPilot::None, InPx4::NotTaken),  // DO_REPEAT_SERVO
    row(187, K, K, K, K, InArduPilot::NotTaken, InPx4::Command),  // DO_SET_ACTUATOR
    row(188, D, D, D, D, InArduPilot::Place, InPx4::NotTaken),  // DO_RETURN_PATH_START
    row(189, D, D, D, D, InArduPilot::Place, InPx4::LandStart),  // DO_LAND_START
    row(191, D, D, D, D, InArduPilot::Place, InPx4::NotTaken),  // DO_GO_AROUND
    row(193, U16, D, D, D, InArduPilot::None, InPx4::NotTaken),  // DO_PAUSE_CONTINUE
    row(194, U16, D, D, D, InArduPilot::None, InPx4::NotTaken),  // DO_SET_REVERSE
    row(195, U16, D, D, D, InArduPilot::Place, InPx4::Place),  // DO_SET_ROI_LOCATION
    row(196, K, K, K, K, InArduPilot::NotTaken, InPx4::Command),  // DO_SET_ROI_WPNEXT_OFFSET
    row(197, U16, D, D, D, InArduPilot::None, InPx4::Command),  // DO_SET_ROI_NONE
    row(200, K, K, K, K, InArduPilot::NotTaken, InPx4::Command),  // DO_CONTROL_VIDEO
    row(201, U16, D, D, D, InArduPilot::Place, InPx4::Roi),  // DO_SET_ROI
    row(202, U8, U16, U8, U16, InArduPilot::Configure, InPx4::NotTaken),  // DO_DIGICAM_CONFIGURE
    row(203, U8, U8, I8, U8, InArduPilot::Shoot, InPx4::Command),  // DO_DIGICAM_CONTROL
    row(204, K, K, K, K, InArduPilot::NotTaken, InPx4::Command),  // DO_MOUNT_CONFIGURE
    row(205, K, K, K, D, InArduPilot::Mount, InPx4::Command),  // DO_MOUNT_CONTROL
    row(206, K, D, U8, D, InArduPilot::None, InPx4::Command),  // DO_SET_CAM_TRIGG_DIST
    row(207, U16, D, D, D, InArduPilot::None, InPx4::NotTaken),  // DO_FENCE_ENABLE
    row(208, U16, D, D, D, InArduPilot::None, InPx4::NotTaken),  // DO_PARACHUTE
    row(210, U16, D, D, D, InArduPilot::None, InPx4::NotTaken),  // DO_INVERTED_FLIGHT
    row(211, U8, U8, D, D, InArduPilot::None, InPx4::Command),  // DO_GRIPPER
    row(212, U16, D, D, D, InArduPilot::None, InPx4::NotTaken),  // DO_AUTOTUNE_ENABLE
    row(213, K, K, U8, D, InArduPilot::None, InPx4::NotTaken),  // NAV_SET_YAW_SPEED
    row(214, K, K, K, K, InArduPilot::NotTaken, InPx4::Command),  // DO_SET_CAM_TRIGG_INTERVAL
    row(215, U16, D, D, D, InArduPilot::None, InPx4::NotTaken),  // DO_SET_RESUME_REPEAT_DIST
    row(216, U16, D, D, D, InArduPilot::None, InPx4::NotTaken),  // DO_SPRAYER
    row(217, U16, K, K, K, InArduPilot::None, InPx4::NotTaken),  // DO_SEND_SCRIPT_MESSAGE
    row(218, U16, U8, D, D, InArduPilot::None, InPx4::NotTaken),  // DO_AUX_FUNCTION
    row(222, U16, K, K, K, InArduPilot::None, InPx4::NotTaken),  // DO_GUIDED_LIMITS
    row(223, U1, U1, Centimetres, U1, InArduPilot::None, InPx4::NotTaken),  // DO_ENGINE_CONTROL
    row(260, K, K, K, K, InArduPilot::NotTaken, InPx4::Command),  // OBLIQUE_SURVEY
    row(400, K, K, K, K, InArduPilot::NotTaken, InPx4::Command),  // COMPONENT_ARM_DISARM
    row(530, K, K, K, K, InArduPilot::NotTaken, InPx4::Command),  // SET_CAMERA_MODE
    row(531, U8, K, D, D, InArduPilot::None, InPx4::NotTaken),  // SET_CAMERA_ZOOM
    row(532, U8, K, D, D, InArduPilot::None, InPx4::Command),  // SET_CAMERA_FOCUS
    row(534, U8, U8, U8, D, InArduPilot::None, InPx4::Command),  // SET_CAMERA_SOURCE
    row(600, U16, D, D, D, InArduPilot::None, InPx4::NotTaken),  // JUMP_TAG
    row(601, U16, I16, D, D, InArduPilot::None, InPx4::NotTaken),  // DO_JUMP_TAG
    row(1000, I8, I16, I8, I8, InArduPilot::Gimbal, InPx4::Command),  // DO_GIMBAL_MANAGER_PITCHYAW
    row(1001, K, K, K, K, InArduPilot::NotTaken, InPx4::Command),  // DO_GIMBAL_MANAGER_CONFIGURE
    row(2000, U8, K, U16, U16, InArduPilot::None, InPx4::Command),  // IMAGE_START_CAPTURE
    row(2001, U16, D, D, D, InArduPilot::None, InPx4::Command),  // IMAGE_STOP_CAPTURE
    row(2003, K, K, K, K, InArduPilot::NotTaken, InPx4::Command),  // DO_TRIGGER_CONTROL
    row(2500, U8, D, D, D, InArduPilot::None, InPx4::Command),  // VIDEO_START_CAPTURE
    row(2501, U8, D, D, D, InArduPilot::None, InPx4::Command),  // VIDEO_STOP_CAPTURE
    row(3000, U8, D, D, D, InArduPilot::None, InPx4::Command),  // DO_VTOL_TRANSITION
    row(4501, K, K, K, K, InArduPilot::NotTaken, InPx4::Place),  // CONDITION_GATE
    row(5000, D, D, D, D, InArduPilot::Fence, InPx4::Place),  // NAV_FENCE_RETURN_POINT
    row(5001, U8, D, D, D, InArduPilot::Fence, InPx4::Corner),  // NAV_FENCE_POLYGON_VERTEX_INCLUSION
    row(5002, U8, D, D, D, InArduPilot::Fence, InPx4::Corner),  // NAV_FENCE_POLYGON_VERTEX_EXCLUSION
    row(5003, Special, D, D, D, InArduPilot::Fence, InPx4::Circle),  // NAV_FENCE_CIRCLE_INCLUSION
    row(5004, Special, D, D, D, InArduPilot::Fence, InPx4::Circle),  // NAV_FENCE_CIRCLE_EXCLUSION
    row(5100, D, D, D, D, InArduPilot::Rally, InPx4::Place),  // NAV_RALLY_POINT
    row(42600, U8, U8, K, K, InArduPilot::None, InPx4::Command),  // DO_WINCH
    row(42703, U16, To180, To90, To360, InArduPilot::Attitude, InPx4::NotTaken),  // NAV_ATTITUDE_TIME
};

// The row of a command, in flash; null: there is none.
const Row* findRow(uint16_t command, bool isPlane) {
  for (const Row* row = isPlane ? kRows : kRows + kPlaneRows; row != kRows + sizeof(kRows) / sizeof(kRows[0]); ++row) {
    if (fromFlash(&row->command) == command) return row;
  }
  return nullptr;
}

}  // namespace

bool isPlane(uint8_t vehicleType) {
  return vehicleType == 1 || (vehicleType >= 19 && vehicleType <= 25);  // MAV_TYPE_FIXED_WING, MAV_TYPE_VTOL_...
}

Rules rulesOf(const MissionItem& item, Keeper keeper) {
  Rules rules = {{0, 0, 0, pair(Height, kAsItsFrameSays)}};
  const Row* row = findRow(item.command, keeper.isPlane);
  if (row != nullptr) {
    const uint8_t where = fromFlash(&row->where);
    if (keeper.firmware == Firmware::Px4 || (keeper.firmware != Firmware::ArduPilot && (where & 15) == 0)) {
      const Rules* found = &kInPx4[where >> 4];
      for (uint8_t i = 0; i < 4; ++i) rules.pairs[i] = fromFlash(&found->pairs[i]);
    } else {
      const More* more = &kInArduPilot[where & 15];
      rules.pairs[0] = fromFlash(&row->params12);
      rules.pairs[1] = fromFlash(&row->params34);
      rules.pairs[2] = fromFlash(&more->xy);
      rules.pairs[3] = fromFlash(&more->zAndTraits);
    }
  }
  if (rules.has(kAsItsFrameSays) && item.frame == Frame::Mission) {
    // All is kept, but for what is special in param1.
    rules.pairs[0] &= 15;
    rules.pairs[1] = 0;
    rules.pairs[3] = pair(Height, kHasNoPlace);
  }
  return rules;
}

uint8_t traitsOf(uint16_t command) {
  const Row* row = findRow(command, false);
  if (row == nullptr) return 0;
  const uint8_t where = fromFlash(&row->where);
  return ((where & 15) != 0 ? fromFlash(&kInArduPilot[where & 15].zAndTraits) : fromFlash(&kInPx4[where >> 4].pairs[3])) >> 4;
}

}  // namespace mavmission
