#include "Commands.h"

#include "../base/Flash.h"
#include "Rules.h"
#include "VehicleKind.h"

namespace mavmission {
namespace detail {

using namespace keeping;

namespace {

constexpr uint16_t four(uint8_t first, uint8_t second, uint8_t third, uint8_t fourth) {
  return static_cast<uint16_t>(first | second << 4 | third << 8 | static_cast<uint16_t>(fourth) << 12);
}

// What ArduPilot does with x, y and z of a command: the index into kInArduPilot.
enum class InArduPilot : uint8_t {
  NotTaken,
  None,
  Place,
  OnTheWay,
  Configure,
  Shoot,
  Mount,
  Gimbal,
  Attitude,
  Fence,
  Rally
};

const uint16_t kInArduPilot[] PROGMEM = {
    four(K, K, K, kIsNotTaken),
    four(D, D, D, kHasNoPlace),
    four(K, K, Height, 0),
    four(K, K, Height, kPlaceIsOptional),
    four(U8, U8, K, kHasNoPlace),
    four(U8, U8, D, kHasNoPlace),
    four(D, D, MountMode, kHasNoPlace),
    four(U8, D, U8, kHasNoPlace),
    four(I16, D, D, kHasNoPlace),
    four(K, K, D, 0),
    four(K, K, I16, 0),
};

// What PX4 does with the fields of a command: the index into kInPx4.
enum class InPx4 : uint8_t {
  NotTaken,
  Command,
  Place,
  Waypoint,
  Loiter,
  LoiterTime,
  LoiterToAltitude,
  Land,
  Takeoff,
  Roi,
  Jump,
  LandStart,
  Corner,
  Circle
};

struct Both {
  uint16_t params, more;
};

const Both kInPx4[] PROGMEM = {
    {four(K, K, K, K), four(K, K, K, kIsNotTaken)},
    {four(K, K, K, K), four(K, K, K, kHasNoPlace)},
    {four(D, D, D, D), four(K, K, K, 0)},
    {four(K, K, D, Yaw360), four(K, K, K, 0)},
    {four(D, D, K, Yaw360), four(K, K, K, 0)},
    {four(K, U1, K, U1), four(K, K, K, 0)},
    {four(U1, K, D, U1), four(K, K, K, 0)},
    {four(Later, U16, D, Yaw360), four(K, K, K, kPlaceIsOptional)},
    {four(D, D, D, Yaw360), four(K, K, K, kPlaceIsOptional)},
    {four(Special, D, D, D), four(K, K, K, kAsItsFrameSays)},
    {four(I16, U16, K, K), four(K, K, K, kHasNoPlace)},
    {four(K, K, K, K), four(Rounded, Rounded, K, kHasNoPlace)},
    {four(U16, D, D, D), four(K, K, K, 0)},
    {four(K, D, D, D), four(K, K, K, 0)},
};

constexpr uint8_t whereOf(InArduPilot arduPilot, InPx4 px4) {
  return static_cast<uint8_t>(static_cast<uint8_t>(arduPilot) | static_cast<uint8_t>(px4) << 4);
}

#if MAVMISSION_ONLY_PX4
struct Row {
  uint16_t command;
  uint8_t where;  // InArduPilot in the lower four bits, InPx4 in the upper four
};

constexpr Row row(uint16_t command, uint8_t, uint8_t, uint8_t, uint8_t, InArduPilot arduPilot, InPx4 px4) {
  return Row{command, whereOf(arduPilot, px4)};
}
#else
struct Row {
  uint16_t command;
  uint16_t params;  // the Kinds of param1 to param4 on ArduPilot
  uint8_t where;    // InArduPilot in the lower four bits, InPx4 in the upper four
};

constexpr Row row(uint16_t command, uint8_t param1, uint8_t param2, uint8_t param3, uint8_t param4,
                  InArduPilot arduPilot, InPx4 px4) {
  return Row{command, four(param1, param2, param3, param4), whereOf(arduPilot, px4)};
}
#endif

constexpr uint8_t kPlaneRows = 2;  // the first rows, which hold for planes only

// Observed on ArduCopter, ArduRover and ArduPlane 4.6.3 and on PX4 1.17.0: simulation/recordings has the answer of each
// autopilot to each of these commands, and the values that it kept (readback_*.csv, readback_random_*.csv);
// docs/readback.md describes them in words. NAV_ARC_WAYPOINT is from the source of ArduCopter 4.7. A command without a
// row was accepted by none of these autopilots. It is sent nevertheless, since a newer autopilot may accept it; but not
// CONDITION_CHANGE_ALT, whose altitude no frame would be sure to go with.
const Row kRows[] PROGMEM = {
    row(16, NoHold, U8, U8, NoYaw, InArduPilot::Place, InPx4::NotTaken),          // NAV_WAYPOINT on a plane
    row(82, K, K, K, K, InArduPilot::NotTaken, InPx4::NotTaken),                  // NAV_SPLINE_WAYPOINT on a plane
    row(16, U16, D, D, NoYaw, InArduPilot::Place, InPx4::Waypoint),               // NAV_WAYPOINT
    row(17, D, D, Radius, NoYaw, InArduPilot::Place, InPx4::Loiter),              // NAV_LOITER_UNLIM
    row(18, Special, D, Special, U1, InArduPilot::Place, InPx4::NotTaken),        // NAV_LOITER_TURNS
    row(19, U16, D, Sign, U1, InArduPilot::Place, InPx4::LoiterTime),             // NAV_LOITER_TIME
    row(20, D, D, D, D, InArduPilot::None, InPx4::Command),                       // NAV_RETURN_TO_LAUNCH
    row(21, U16, D, D, Sign, InArduPilot::Place, InPx4::Land),                    // NAV_LAND
    row(22, U16, D, D, NoYaw, InArduPilot::Place, InPx4::Takeoff),                // NAV_TAKEOFF
    row(30, U16, D, D, D, InArduPilot::Place, InPx4::NotTaken),                   // NAV_CONTINUE_AND_CHANGE_ALT
    row(31, D, Radius, D, U1, InArduPilot::Place, InPx4::LoiterToAltitude),       // NAV_LOITER_TO_ALT
    row(36, Radius, D, D, D, InArduPilot::Place, InPx4::NotTaken),                // NAV_ARC_WAYPOINT
    row(80, K, K, K, K, InArduPilot::NotTaken, InPx4::Roi),                       // NAV_ROI
    row(82, U16, D, D, D, InArduPilot::Place, InPx4::NotTaken),                   // NAV_SPLINE_WAYPOINT
    row(83, K, K, U8, D, InArduPilot::None, InPx4::NotTaken),                     // NAV_ALTITUDE_WAIT
    row(84, D, D, D, NoYaw, InArduPilot::Place, InPx4::Takeoff),                  // NAV_VTOL_TAKEOFF
    row(85, U16, D, D, NoYaw, InArduPilot::Place, InPx4::Takeoff),                // NAV_VTOL_LAND
    row(92, U16, D, D, D, InArduPilot::OnTheWay, InPx4::NotTaken),                // NAV_GUIDED_ENABLE
    row(93, K, I8, I8, I8, InArduPilot::None, InPx4::Command),                    // NAV_DELAY
    row(94, Centimetres, D, D, D, InArduPilot::Place, InPx4::NotTaken),           // NAV_PAYLOAD_PLACE
    row(112, K, D, D, D, InArduPilot::None, InPx4::Command),                      // CONDITION_DELAY
    row(113, K, K, K, K, InArduPilot::NotTaken, InPx4::NotTaken),                 // CONDITION_CHANGE_ALT
    row(114, K, D, D, D, InArduPilot::None, InPx4::Command),                      // CONDITION_DISTANCE
    row(115, K, K, I8, U8, InArduPilot::None, InPx4::NotTaken),                   // CONDITION_YAW
    row(177, U16, I16, D, D, InArduPilot::None, InPx4::Jump),                     // DO_JUMP
    row(178, U8, K, K, Zero, InArduPilot::None, InPx4::Command),                  // DO_CHANGE_SPEED
    row(179, U16, D, D, D, InArduPilot::Place, InPx4::Command),                   // DO_SET_HOME
    row(181, U8, U8, D, D, InArduPilot::None, InPx4::NotTaken),                   // DO_SET_RELAY
    row(182, U8, I16, K, D, InArduPilot::None, InPx4::NotTaken),                  // DO_REPEAT_RELAY
    row(183, U8, U16, D, D, InArduPilot::None, InPx4::NotTaken),                  // DO_SET_SERVO
    row(184, U8, U16, I16, K, InArduPilot::None, InPx4::NotTaken),                // DO_REPEAT_SERVO
    row(187, K, K, K, K, InArduPilot::NotTaken, InPx4::Command),                  // DO_SET_ACTUATOR
    row(188, D, D, D, D, InArduPilot::OnTheWay, InPx4::NotTaken),                 // DO_RETURN_PATH_START
    row(189, D, D, D, D, InArduPilot::OnTheWay, InPx4::LandStart),                // DO_LAND_START
    row(191, D, D, D, D, InArduPilot::OnTheWay, InPx4::NotTaken),                 // DO_GO_AROUND
    row(193, U16, D, D, D, InArduPilot::None, InPx4::NotTaken),                   // DO_PAUSE_CONTINUE
    row(194, U16, D, D, D, InArduPilot::None, InPx4::NotTaken),                   // DO_SET_REVERSE
    row(195, U16, D, D, D, InArduPilot::Place, InPx4::Place),                     // DO_SET_ROI_LOCATION
    row(196, K, K, K, K, InArduPilot::NotTaken, InPx4::Command),                  // DO_SET_ROI_WPNEXT_OFFSET
    row(197, U16, D, D, D, InArduPilot::None, InPx4::Command),                    // DO_SET_ROI_NONE
    row(200, K, K, K, K, InArduPilot::NotTaken, InPx4::Command),                  // DO_CONTROL_VIDEO
    row(201, U16, D, D, D, InArduPilot::Place, InPx4::Roi),                       // DO_SET_ROI
    row(202, U8, U16, U8, U16, InArduPilot::Configure, InPx4::NotTaken),          // DO_DIGICAM_CONFIGURE
    row(203, U8, U8, I8, U8, InArduPilot::Shoot, InPx4::Command),                 // DO_DIGICAM_CONTROL
    row(204, K, K, K, K, InArduPilot::NotTaken, InPx4::Command),                  // DO_MOUNT_CONFIGURE
    row(205, K, K, K, D, InArduPilot::Mount, InPx4::Command),                     // DO_MOUNT_CONTROL
    row(206, K, D, U8, D, InArduPilot::None, InPx4::Command),                     // DO_SET_CAM_TRIGG_DIST
    row(207, U16, Zero, D, D, InArduPilot::None, InPx4::NotTaken),                // DO_FENCE_ENABLE
    row(208, U16, D, D, D, InArduPilot::None, InPx4::NotTaken),                   // DO_PARACHUTE
    row(210, U16, D, D, D, InArduPilot::None, InPx4::NotTaken),                   // DO_INVERTED_FLIGHT
    row(211, U8, U8, D, D, InArduPilot::None, InPx4::Command),                    // DO_GRIPPER
    row(212, U16, D, D, D, InArduPilot::None, InPx4::Command),                    // DO_AUTOTUNE_ENABLE
    row(213, K, K, U8, D, InArduPilot::None, InPx4::NotTaken),                    // NAV_SET_YAW_SPEED
    row(214, K, K, K, K, InArduPilot::NotTaken, InPx4::Command),                  // DO_SET_CAM_TRIGG_INTERVAL
    row(215, U16, D, D, D, InArduPilot::None, InPx4::NotTaken),                   // DO_SET_RESUME_REPEAT_DIST
    row(216, U16, D, D, D, InArduPilot::None, InPx4::NotTaken),                   // DO_SPRAYER
    row(217, U16, K, K, K, InArduPilot::None, InPx4::NotTaken),                   // DO_SEND_SCRIPT_MESSAGE
    row(218, U16, U8, D, D, InArduPilot::None, InPx4::NotTaken),                  // DO_AUX_FUNCTION
    row(222, U16, K, K, K, InArduPilot::None, InPx4::NotTaken),                   // DO_GUIDED_LIMITS
    row(223, U1, U1, Centimetres, U1, InArduPilot::None, InPx4::NotTaken),        // DO_ENGINE_CONTROL
    row(260, K, K, K, K, InArduPilot::NotTaken, InPx4::Command),                  // OBLIQUE_SURVEY
    row(400, K, K, K, K, InArduPilot::NotTaken, InPx4::Command),                  // COMPONENT_ARM_DISARM
    row(530, K, K, K, K, InArduPilot::NotTaken, InPx4::Command),                  // SET_CAMERA_MODE
    row(531, U8, K, D, D, InArduPilot::None, InPx4::NotTaken),                    // SET_CAMERA_ZOOM
    row(532, U8, K, D, D, InArduPilot::None, InPx4::Command),                     // SET_CAMERA_FOCUS
    row(534, U8, U8, U8, D, InArduPilot::None, InPx4::Command),                   // SET_CAMERA_SOURCE
    row(600, U16, D, D, D, InArduPilot::None, InPx4::NotTaken),                   // JUMP_TAG
    row(601, U16, I16, D, D, InArduPilot::None, InPx4::NotTaken),                 // DO_JUMP_TAG
    row(1000, I8, I16, I8, I8, InArduPilot::Gimbal, InPx4::Command),              // DO_GIMBAL_MANAGER_PITCHYAW
    row(1001, K, K, K, K, InArduPilot::NotTaken, InPx4::Command),                 // DO_GIMBAL_MANAGER_CONFIGURE
    row(2000, U8, K, U16, U16, InArduPilot::None, InPx4::Command),                // IMAGE_START_CAPTURE
    row(2001, U16, D, D, D, InArduPilot::None, InPx4::Command),                   // IMAGE_STOP_CAPTURE
    row(2003, K, K, K, K, InArduPilot::NotTaken, InPx4::Command),                 // DO_TRIGGER_CONTROL
    row(2500, U8, D, D, D, InArduPilot::None, InPx4::Command),                    // VIDEO_START_CAPTURE
    row(2501, U8, D, D, D, InArduPilot::None, InPx4::Command),                    // VIDEO_STOP_CAPTURE
    row(3000, U8, Zero, D, D, InArduPilot::None, InPx4::Command),                 // DO_VTOL_TRANSITION
    row(4501, K, K, K, K, InArduPilot::NotTaken, InPx4::Place),                   // CONDITION_GATE
    row(5000, D, D, D, D, InArduPilot::Fence, InPx4::Place),                      // NAV_FENCE_RETURN_POINT
    row(5001, U8, D, D, D, InArduPilot::Fence, InPx4::Corner),                    // NAV_FENCE_POLYGON_VERTEX_INCLUSION
    row(5002, U8, D, D, D, InArduPilot::Fence, InPx4::Corner),                    // NAV_FENCE_POLYGON_VERTEX_EXCLUSION
    row(5003, K, D, D, D, InArduPilot::Fence, InPx4::Circle),                     // NAV_FENCE_CIRCLE_INCLUSION
    row(5004, K, D, D, D, InArduPilot::Fence, InPx4::Circle),                     // NAV_FENCE_CIRCLE_EXCLUSION
    row(5100, D, D, D, D, InArduPilot::Rally, InPx4::Place),                      // NAV_RALLY_POINT
    row(42600, U8, U8, K, K, InArduPilot::None, InPx4::Command),                  // DO_WINCH
    row(42703, U16, To180, To90, To360, InArduPilot::Attitude, InPx4::NotTaken),  // NAV_ATTITUDE_TIME
};

// The parameters of a command that PX4 keeps as NaN, one bit each, and to which that means something: by MAVLink's own
// definitions, for which a NaN also fills what is reserved; by MAVSDK, which leaves the acceptance radius to PX4 so;
// and by QGroundControl, which leaves all unset of a camera's item that it does not use.
struct Unset {
  uint16_t command;
  uint8_t params;
};

constexpr uint8_t unset(uint8_t first, uint8_t second = 0, uint8_t third = 0, uint8_t fourth = 0) {
  return static_cast<uint8_t>((1 << first | 1 << second | 1 << third | 1 << fourth) & ~1);
}

const Unset kUnset[] PROGMEM = {
    {16, unset(2)},             // NAV_WAYPOINT: the acceptance radius
    {179, unset(2, 3, 4)},      // DO_SET_HOME: the surface, the heading
    {187, unset(1, 2, 3, 4)},   // DO_SET_ACTUATOR: the others are left as they are
    {530, unset(3, 4, 7)},      // SET_CAMERA_MODE
    {532, unset(4)},            // SET_CAMERA_FOCUS
    {1000, unset(1, 2, 3, 4)},  // DO_GIMBAL_MANAGER_PITCHYAW: by angles, by rates
    {2000, unset(4, 7)},        // IMAGE_START_CAPTURE
    {2001, unset(2, 3, 4, 7)},  // IMAGE_STOP_CAPTURE
    {2500, unset(3, 4, 7)},     // VIDEO_START_CAPTURE
    {2501, unset(2, 3, 4, 7)},  // VIDEO_STOP_CAPTURE
};

// Where a table of its own has each command that an autopilot takes: all Kinds of each.
struct OwnRow {
  uint16_t command;
  uint16_t params, more;
};

struct OwnTable {
  const OwnRow *begin, *end;
};

// From Betaflight's source (2026.12). What it takes and flies otherwise than it is meant has no row: a return at the
// end (which it drops), spline waypoints (straight), turns and loitering without an end (kept as a time), fences
// (stored, and not enforced).
const OwnRow kInBetaflight[] PROGMEM = {
    {16, four(Zero, D, D, NoYaw), four(K, K, Height, 0)},              // NAV_WAYPOINT: it does not hold there
    {19, four(U8, D, Zero, NoYaw), four(K, K, Height, 0)},             // NAV_LOITER_TIME
    {21, four(D, D, D, NoYaw), four(K, K, Height, kPlaceIsOptional)},  // NAV_LAND
    {22, four(D, D, D, NoYaw), four(K, K, Height, kPlaceIsOptional)},  // NAV_TAKEOFF
};

// From iNav's source (10).
const OwnRow kInInav[] PROGMEM = {
    {16, four(Zero, D, D, NoYaw), four(K, K, Height, 0)},              // NAV_WAYPOINT: it does not hold there
    {19, four(I16, D, Zero, NoYaw), four(K, K, Height, 0)},            // NAV_LOITER_TIME
    {20, four(D, D, D, D), four(D, D, D, kHasNoPlace)},                // NAV_RETURN_TO_LAUNCH
    {21, four(D, D, D, NoYaw), four(K, K, Height, kPlaceIsOptional)},  // NAV_LAND
    {115, four(To360, D, D, Zero), four(D, D, D, kHasNoPlace)},        // CONDITION_YAW
    {177, four(I16, I16, D, D), four(D, D, D, kHasNoPlace)},           // DO_JUMP
    {201, four(Three, D, D, D), four(K, K, Height, 0)},                // DO_SET_ROI
};

// The rules of a command, from the autopilot's own table.
MAVMISSION_APART Rules ownRulesOf(uint16_t command) {
#define MAVMISSION_GENERIC_ROW(NAME, TRAITS) \
  kGenericFirmware == Firmware::NAME ? OwnTable{kIn##NAME, kIn##NAME + sizeof(kIn##NAME) / sizeof(OwnRow)}:
  const OwnTable table = MAVMISSION_GENERIC_PERSONALITIES(MAVMISSION_GENERIC_ROW)(OwnTable{nullptr, nullptr});
#undef MAVMISSION_GENERIC_ROW
  Rules rules = {static_cast<uint32_t>(kIsNotTaken) << 28};
  for (const OwnRow* row = table.begin; row != table.end; ++row) {
    if (fromFlash(&row->command) != command) continue;
    rules.bits = static_cast<uint32_t>(fromFlash(&row->more)) << 16 | fromFlash(&row->params);
  }
  return rules;
}

}  // namespace

Keeper keeperOf(Firmware firmware, uint8_t vehicleType, PlanType type) {
  static_assert(
      static_cast<uint8_t>(PlanType::Fence) << 3 == kOfFence && static_cast<uint8_t>(PlanType::Rally) << 3 == kOfRally,
      "the flags of a Keeper must be the numbers of PlanType, shifted by 3 bits");
  Keeper keeper = static_cast<uint8_t>(static_cast<uint8_t>(type) << 3) | flagOf(firmware);
  if (isPlane(vehicleType) && has(firmware, kPlanesKeepMore)) keeper |= kByPlane;
  return keeper;
}

Rules rulesOf(const MissionItem& item, Keeper keeper) {
  if (isByOwn(keeper)) return ownRulesOf(item.command);
  uint16_t params = 0, more = four(K, K, Height, kAsItsFrameSays);
  for (const Row* row = kServesArduPilot && (keeper & kByPlane) != 0 ? kRows : kRows + kPlaneRows;
       row != kRows + sizeof(kRows) / sizeof(*kRows); ++row) {
    if (fromFlash(&row->command) != item.command) continue;
    const uint8_t where = fromFlash(&row->where);
    const uint8_t inArduPilot = where & 15;
#if MAVMISSION_ONLY_PX4
    const uint16_t *inFlash, *moreInFlash;
#else
    const uint16_t* inFlash = &row->params;
    const uint16_t* moreInFlash = &kInArduPilot[inArduPilot];
#endif
    // An autopilot that is neither ArduPilot nor PX4 is treated as ArduPilot, or as PX4 if ArduPilot does not take the
    // command.
    if (isByPx4(keeper) || (!isByArduPilot(keeper) && inArduPilot == 0)) {
      inFlash = &kInPx4[where >> 4].params;
      moreInFlash = inFlash + 1;
    }
    params = fromFlash(inFlash);
    more = fromFlash(moreInFlash);
    break;
  }
  if ((more & kAsItsFrameSays << 12) != 0 && item.frame == CoordinateFrame::Mission) {
    // In an item without a place all fields are kept as they are; only a Special param1 keeps its rule.
    params &= 15;
    more = four(K, K, Height, kHasNoPlace);
  }
  union {  // avr-gcc puts two words together more cheaply so
    uint16_t words[2];
    Rules rules;
  } both;
  both.words[0] = params;
  both.words[1] = more;
  return both.rules;
}

uint8_t unsetOf(uint16_t command) {
  for (const Unset& one : kUnset) {
    if (fromFlash(&one.command) == command) return fromFlash(&one.params);
  }
  return 0;
}

namespace {

// For any autopilot.
Rules anyRulesOf(uint16_t command) {
  MissionItem item;
  item.command = command;
  item.frame = CoordinateFrame::Global;
  return rulesOf(item, 0);
}

}  // namespace

uint8_t traitsOf(uint16_t command) { return static_cast<uint8_t>(anyRulesOf(command).bits >> 28); }

bool dropsPlace(uint16_t command) { return anyRulesOf(command).bytes[2] == (D | D << 4); }

}  // namespace detail
}  // namespace mavmission
