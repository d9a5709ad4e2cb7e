// What an autopilot is, where one differs from another: a row for each. Nothing outside this file compares firmwares.
// A row and its traits are known when the library is compiled: a question costs the comparison that it stands for.
#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../Firmware.h"

namespace mavmission {
namespace detail {

// Whose rules of keeping an item hold (autopilot/Commands.cpp), an or of these, with what kind of plan it is. None of
// the first two: the protocol as the guide has it.
enum KeeperFlag : uint8_t {
  kByArduPilot = 1,
  kByPx4 = 2,
  kByPlane = 4,  // ArduPilot's Plane, which keeps some fields that its Copter drops
  kOfFence = 8,
  kOfRally = 16,
};
typedef uint8_t Keeper;

enum Trait : uint32_t {
  // --- Plans
  kHomeIsItem0 = 1ul << 0,           // item 0 of a mission on the wire is home, the autopilot's own
  kReplacesItemByItem = 1ul << 1,    // a mission upload that breaks off leaves a mixture of two plans
  kKeepsPlanUntilWhole = 1ul << 2,   // an upload that breaks off leaves the plan of before
  kTakesWholePlansOnly = 1ul << 3,   // no MISSION_WRITE_PARTIAL_LIST
  kTakesTerrainFrames = 1ul << 4,    // MAV_FRAME_GLOBAL_TERRAIN_ALT
  kMayTakeAnyFrame = 1ul << 5,       // nothing is known of its frames: each goes out
  kWipesShortFences = 1ul << 6,      // a fence too short to be one is accepted, and gone some time later
  kWantsRepeatsWithin16 = 1ul << 7,  // gives DO_JUMP's "for ever" back as 65535
  kDropsNanYaw = 1ul << 8,           // gives a NaN yaw back as 0

  // --- Transfers
  kSaysChecksum = 1ul << 9,        // MISSION_ACK.opaque_id is the checksum of what it holds
  kSaysErrorWhenBusy = 1ul << 10,  // MAV_MISSION_ERROR to a COUNT while another transfer runs, and to a second COUNT
  kErrorRefusesCount = 1ul << 11,  // MAV_MISSION_ERROR to a COUNT is a refusal
  kRepeatsAcceptance = 1ul << 12,  // answers a repeated last item with ACCEPTED again
  kGoesOnWithOlder = 1ul << 13,    // goes on with an older transfer that had come to no item when COUNT comes
  kRefusesTakenItems = 1ul << 25,  // INVALID_SEQUENCE to an item that it has, and does not expect
  kMayBeOld = 1ul << 14,           // may know MISSION_REQUEST and MISSION_ITEM alone

  // --- Flying
  kArmsByMissionStart = 1ul << 15,  // MAV_CMD_MISSION_START sets the mode and arms
  kFliesByMode = 1ul << 16,         // is armed in another mode, and flies its mission in AUTO
  kSaysCurrentUnasked = 1ul << 17,  // MISSION_CURRENT once a second; MAV_CMD_REQUEST_MESSAGE is denied
  kNamesFlownItems = 1ul << 18,     // MISSION_CURRENT names items that are flown to, no commands on the way
  kModeIsOneByte = 1ul << 19,       // a larger HEARTBEAT.custom_mode would be cut
  kModesByVehicle = 1ul << 20,      // mode numbers differ by HEARTBEAT.type
  kModesHaveSubModes = 1ul << 21,   // custom_mode is a main mode and a sub mode
  kRejectsInWords = 1ul << 22,      // a plan that was accepted may be rejected by a STATUSTEXT
  kStreamsAsArduPilot = 1ul << 23,  // which messages make up most of its telemetry
  kPlanesKeepMore = 1ul << 24,      // kByPlane
};

// X(Firmware, MAV_AUTOPILOT, whose rules of keeping, traits). HEARTBEAT.autopilot is what an autopilot is known by.
// clang-format off
#define MAVMISSION_PERSONALITIES(X)                                                                        \
  X(ArduPilot, 3, kByArduPilot,                                                                            \
    kHomeIsItem0 | kReplacesItemByItem | kTakesTerrainFrames | kWipesShortFences | kDropsNanYaw |          \
    kErrorRefusesCount | kRefusesTakenItems | kFliesByMode | kNamesFlownItems | kModeIsOneByte | kModesByVehicle |              \
    kStreamsAsArduPilot | kPlanesKeepMore)                                                                 \
  X(Px4, 12, kByPx4,                                                                                       \
    kKeepsPlanUntilWhole | kTakesWholePlansOnly | kWantsRepeatsWithin16 | kSaysChecksum |                  \
    kSaysErrorWhenBusy | kRepeatsAcceptance | kGoesOnWithOlder | kArmsByMissionStart |                     \
    kSaysCurrentUnasked | kModesHaveSubModes | kRejectsInWords)
// clang-format on

// Of any other autopilot.
constexpr uint32_t kOtherTraits = kMayTakeAnyFrame | kMayBeOld;

MAVMISSION_INLINE constexpr bool has(Firmware firmware, Trait trait) {
#define MAVMISSION_ROW(NAME, ID, KEEPER, TRAITS) (((TRAITS) & trait) != 0 && firmware == Firmware::NAME) ||
  return MAVMISSION_PERSONALITIES(MAVMISSION_ROW)((kOtherTraits & trait) != 0 && firmware == Firmware::Other);
#undef MAVMISSION_ROW
}

// `autopilot`: HEARTBEAT.autopilot.
MAVMISSION_INLINE Firmware firmwareOf(uint8_t autopilot) {
  switch (autopilot) {
#define MAVMISSION_ROW(NAME, ID, KEEPER, TRAITS) \
  case ID: return Firmware::NAME;
    MAVMISSION_PERSONALITIES(MAVMISSION_ROW)
#undef MAVMISSION_ROW
    default: return Firmware::Other;
  }
}

MAVMISSION_INLINE Keeper flagOf(Firmware firmware) {
  switch (firmware) {
#define MAVMISSION_ROW(NAME, ID, KEEPER, TRAITS) \
  case Firmware::NAME: return KEEPER;
    MAVMISSION_PERSONALITIES(MAVMISSION_ROW)
#undef MAVMISSION_ROW
    default: return 0;
  }
}

}  // namespace detail
}  // namespace mavmission
