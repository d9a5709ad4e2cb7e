// The differences between autopilots, as one row of traits for each autopilot. Nothing outside this file compares
// firmwares. The rows are compile-time constants: a call of has() costs no more than a comparison of the firmware.
#pragma once

#include <stdint.h>

#include "../base/Config.h"
#include "Firmware.h"

namespace mavmission {
namespace detail {

// Which autopilot's rules tell what is kept of an item (autopilot/Commands.cpp), and the type of the plan: an or of
// these flags. Without kByArduPilot and kByPx4 the protocol holds as the guide describes it.
enum KeeperFlag : uint8_t {
  kByArduPilot = 1,
  kByPx4 = 2,
  kByPlane = 4,  // ArduPilot's Plane, which keeps some fields that ArduPilot's Copter drops
  kOfFence = 8,
  kOfRally = 16,
  kByOwnTable = 32,  // a table of its own has each command that it takes: kGenericFirmware says which
};  // 64 is free, and 128 is Comparison's
typedef uint8_t Keeper;

enum Trait : uint64_t {
  // --- Plans
  kHomeIsItem0 = 1ull << 0,            // item 0 of a mission on the wire is the autopilot's home
  kReplacesItemByItem = 1ull << 1,     // a mission upload that breaks off leaves a mixture of two plans
  kKeepsPlanUntilWhole = 1ull << 2,    // an upload that breaks off leaves the previous plan unchanged
  kTakesWholePlansOnly = 1ull << 3,    // does not support MISSION_WRITE_PARTIAL_LIST
  kTakesTerrainFrames = 1ull << 4,     // takes MAV_FRAME_GLOBAL_TERRAIN_ALT
  kMayTakeAnyFrame = 1ull << 5,        // its frames are not known: an item is sent in any frame
  kWipesShortFences = 1ull << 6,       // accepts a fence with too few corners, and wipes it some time later
  kWantsRepeatsWithin16 = 1ull << 7,   // gives DO_JUMP's "for ever" back as 65535 in a read-back
  kDropsNanYaw = 1ull << 8,            // gives a NaN yaw back as 0 in a read-back
  kDropsPlanFirst = 1ull << 32,        // MISSION_COUNT deletes the plan aboard: an upload that breaks off leaves none
  kGivesHeightsAboveSea = 1ull << 33,  // gives a height above home back above sea level in a read-back
  kTellsTotal = 1ull << 34,            // MISSION_CURRENT.total is the number of items aboard

  // --- Transfers
  kSaysChecksum = 1ull << 9,        // MISSION_ACK.opaque_id is the checksum of the plan that it holds
  kSaysErrorWhenBusy = 1ull << 10,  // MAV_MISSION_ERROR to a COUNT while another transfer runs, and to a second COUNT
  kErrorRefusesCount = 1ull << 11,  // MAV_MISSION_ERROR to a COUNT is a refusal
  kRepeatsAcceptance = 1ull << 12,  // answers a repeated last item with ACCEPTED again
  kGoesOnWithOlder = 1ull << 13,    // may ignore a COUNT, and continue an older transfer that has received no item yet
  kIsReadBack = 1ull << 41,         // its acceptance alone is no proof
  kMayBeOld = 1ull << 14,           // may know only MISSION_REQUEST and MISSION_ITEM, not the _INT messages
  kRefusesTakenItems = 1ull << 25,  // answers an item that it has received already with INVALID_SEQUENCE
  kIgnoresOtherItems = 1ull << 44,  // says nothing to an item that is not the one that it waits for
  kAnswersAnyRequest = 1ull << 43,  // answers each MISSION_REQUEST_INT, in any order and however soon
  kHasPlanFiles = 1ull << 28,       // gives and takes its plans as files too, by MAVLink FTP

  // --- Flying
  kArmsByMissionStart = 1ull << 15,    // MAV_CMD_MISSION_START sets the mode and arms
  kFliesByMode = 1ull << 16,           // is armed in another mode, and then flies its mission in mode AUTO
  kSaysCurrentUnasked = 1ull << 17,    // sends MISSION_CURRENT once a second; denies MAV_CMD_REQUEST_MESSAGE
  kNamesFlownItems = 1ull << 18,       // MISSION_CURRENT names only items that are flown, no commands on the way
  kModeIsOneByte = 1ull << 19,         // a larger HEARTBEAT.custom_mode would be cut
  kModesByVehicle = 1ull << 20,        // mode numbers differ by HEARTBEAT.type
  kModesHaveSubModes = 1ull << 21,     // custom_mode is a main mode and a sub mode
  kRejectsInWords = 1ull << 22,        // may reject a plan by a STATUSTEXT after it has accepted the plan
  kStreamsAsArduPilot = 1ull << 23,    // its telemetry consists mostly of the same messages as ArduPilot's
  kIsActiveInAir = 1ull << 26,         // HEARTBEAT.system_status is ACTIVE in the air, and not when it is only armed
  kAltitudesAreAboveSea = 1ull << 27,  // takes each altitude of a command as above sea level, whatever its frame
  kPlanesKeepMore = 1ull << 24,        // its planes keep more fields: kByPlane
  kNeedsStream = 1ull << 29,           // its guided mode (OFFBOARD) wants targets first, and a failsafe ends it without
  kFliesToPlacesInHold = 1ull << 35,   // flies to a place of MAV_CMD_DO_REPOSITION in mode HOLD, and not in GUIDED
  kTakesOffInOwnMode = 1ull << 36,     // MAV_CMD_NAV_TAKEOFF sets a mode of its own, and is not flown in GUIDED
  kUnsetPlaceIsHere = 1ull << 37,      // a command whose place is NaN means: where the vehicle is
  kCriticalInFailsafe = 1ull << 38,    // HEARTBEAT.system_status is CRITICAL only while a failsafe flies
  kSameHeightsWithoutHome = 1ull << 39,  // GLOBAL_POSITION_INT: without home, relative_alt is alt
  kSaysUploadsInWords = 1ull << 40,      // says by a STATUSTEXT that an upload has ended
  kTellsArmingChecks = 1ull << 42,       // SYS_STATUS has the result of its checks before arming

  // MAV_CMD_DO_REPOSITION without its flag CHANGE_MODE is answered UNSUPPORTED, and flown to all the same in HOLD alone
  kRefusesAndRepositions = 1ull << 31,

  kKeptByVersion = 1ull << 45,  // what it does not take, or rounds, differs between its versions

  // --- Parameters
  kIntegersAsBits = 1ull << 30,  // PARAM_VALUE has integers as the bits of its float, and not as the float's value
};

// X(Firmware, MAV_AUTOPILOT, KeeperFlag, traits). An autopilot is recognised by HEARTBEAT.autopilot.
// clang-format off
#define MAVMISSION_PERSONALITIES(X)                                                                        \
  X(ArduPilot, 3, kByArduPilot,                                                                            \
    kHomeIsItem0 | kReplacesItemByItem | kTakesTerrainFrames | kWipesShortFences | kDropsNanYaw |          \
    kErrorRefusesCount | kRefusesTakenItems | kAnswersAnyRequest | kHasPlanFiles | kFliesByMode |          \
    kNamesFlownItems | kModeIsOneByte | kModesByVehicle | kStreamsAsArduPilot | kPlanesKeepMore |          \
    kIsActiveInAir | kTellsTotal | kSaysUploadsInWords | kTellsArmingChecks)                               \
  X(Px4, 12, kByPx4,                                                                                       \
    kKeepsPlanUntilWhole | kTakesWholePlansOnly | kWantsRepeatsWithin16 | kSaysChecksum |                  \
    kSaysErrorWhenBusy | kRepeatsAcceptance | kGoesOnWithOlder | kIgnoresOtherItems | kArmsByMissionStart |  \
    kSaysCurrentUnasked | kModesHaveSubModes | kRejectsInWords | kAltitudesAreAboveSea |                   \
    kNeedsStream | kRefusesAndRepositions | kIntegersAsBits | kFliesToPlacesInHold | kTakesOffInOwnMode |  \
    kUnsetPlaceIsHere | kCriticalInFailsafe | kSameHeightsWithoutHome |                                    \
    kTellsArmingChecks)
// clang-format on

// X(Firmware, traits). These say MAV_AUTOPILOT_GENERIC, as others do, and nothing that they send tells them apart:
// MAVMISSION_GENERIC_FIRMWARE says which one it is. The others of these rows cost nothing. Each has its table in
// Commands.cpp: kInInav is that of Inav.
// clang-format off
#define MAVMISSION_GENERIC_PERSONALITIES(X)                                                      \
  X(Betaflight, kDropsPlanFirst | kIsReadBack | kGivesHeightsAboveSea | kMayBeOld | kTellsTotal) \
  X(Inav, kMayBeOld | kTellsTotal | kKeptByVersion)
// clang-format on

// The traits of any other autopilot.
constexpr uint64_t kOtherTraits = kMayTakeAnyFrame | kMayBeOld | kIsReadBack;

// What a generic autopilot is.
constexpr Firmware kGenericFirmware = MAVMISSION_GENERIC_FIRMWARE == 0   ? Firmware::Other
                                      : MAVMISSION_GENERIC_FIRMWARE == 1 ? Firmware::Betaflight
                                                                         : Firmware::Inav;
constexpr bool isGenericKnown() { return kGenericFirmware != Firmware::Other; }
// kByOwnTable where there is such a table.
constexpr Keeper kOwn = isGenericKnown() ? kByOwnTable : 0;

// The autopilot that the library is compiled for, where it is for one alone; else Unknown. With one alone the answers
// of has(), isByArduPilot() and isByPx4() are constants, and what the others guard is not linked.
constexpr Firmware kOnly = MAVMISSION_ONLY_ARDUPILOT ? Firmware::ArduPilot
                           : MAVMISSION_ONLY_PX4     ? Firmware::Px4
                                                     : Firmware::Unknown;
// What the others alone need is not compiled then.
constexpr bool kOnlyArduPilot = kOnly == Firmware::ArduPilot;
// True if the library serves this autopilot.
constexpr bool isServed(Firmware firmware) { return kOnly == Firmware::Unknown || kOnly == firmware; }
constexpr bool kServesArduPilot = isServed(Firmware::ArduPilot);

#if MAVMISSION_ONLY_ARDUPILOT || MAVMISSION_ONLY_PX4
MAVMISSION_INLINE constexpr bool isByArduPilot(Keeper) { return kOnly == Firmware::ArduPilot; }
MAVMISSION_INLINE constexpr bool isByPx4(Keeper) { return kOnly == Firmware::Px4; }
MAVMISSION_INLINE constexpr bool isByEither(Keeper) { return true; }
#else
MAVMISSION_INLINE constexpr bool isByArduPilot(Keeper keeper) { return (keeper & kByArduPilot) != 0; }
MAVMISSION_INLINE constexpr bool isByPx4(Keeper keeper) { return (keeper & kByPx4) != 0; }
MAVMISSION_INLINE constexpr bool isByEither(Keeper keeper) { return (keeper & (kByArduPilot | kByPx4)) != 0; }
#endif
MAVMISSION_INLINE constexpr bool isByOwn(Keeper keeper) { return (keeper & kOwn) != 0; }

MAVMISSION_INLINE constexpr bool has(Firmware firmware, Trait trait) {
#define MAVMISSION_ROW(NAME, ID, KEEPER, TRAITS) \
  (((TRAITS) & trait) != 0 && (kOnly == Firmware::Unknown ? firmware : kOnly) == Firmware::NAME) ||
#define MAVMISSION_GENERIC_ROW(NAME, TRAITS) \
  (((TRAITS) & trait) != 0 && kGenericFirmware == Firmware::NAME && firmware == Firmware::NAME) ||
  return MAVMISSION_PERSONALITIES(MAVMISSION_ROW) MAVMISSION_GENERIC_PERSONALITIES(MAVMISSION_GENERIC_ROW)(
      (kOtherTraits & trait) != 0 && kOnly == Firmware::Unknown && firmware == Firmware::Other);
#undef MAVMISSION_GENERIC_ROW
#undef MAVMISSION_ROW
}

// `autopilot`: HEARTBEAT.autopilot.
MAVMISSION_INLINE Firmware firmwareOf(uint8_t autopilot) {
  if (isGenericKnown() && autopilot == 0) return kGenericFirmware;  // MAV_AUTOPILOT_GENERIC
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
    default: break;
  }
  return isGenericKnown() && firmware == kGenericFirmware ? kByOwnTable : 0;
}

}  // namespace detail
}  // namespace mavmission
