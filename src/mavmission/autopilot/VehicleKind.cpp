#include "VehicleKind.h"

#include "../base/Flash.h"
#include "../base/MavlinkHeaders.h"

namespace mavmission {
namespace detail {
namespace {

static_assert(kFixedWing == MAV_TYPE_FIXED_WING && kFirstVtol == MAV_TYPE_VTOL_TAILSITTER_DUOROTOR &&
                  kLastVtol == MAV_TYPE_VTOL_RESERVED5,
              "the types of planes must be MAVLink's");

struct Row {
  uint8_t type;
  Vehicle vehicle;
};

const Row kRows[] PROGMEM = {
    {MAV_TYPE_QUADROTOR, Vehicle::Copter},   {MAV_TYPE_COAXIAL, Vehicle::Copter},
    {MAV_TYPE_HELICOPTER, Vehicle::Copter},  {MAV_TYPE_HEXAROTOR, Vehicle::Copter},
    {MAV_TYPE_OCTOROTOR, Vehicle::Copter},   {MAV_TYPE_TRICOPTER, Vehicle::Copter},
    {MAV_TYPE_DODECAROTOR, Vehicle::Copter}, {MAV_TYPE_DECAROTOR, Vehicle::Copter},
    {MAV_TYPE_GROUND_ROVER, Vehicle::Rover}, {MAV_TYPE_SURFACE_BOAT, Vehicle::Rover},
    {MAV_TYPE_AIRSHIP, Vehicle::Blimp},      {MAV_TYPE_SUBMARINE, Vehicle::Submarine},
};

}  // namespace

Vehicle vehicleOf(uint8_t type) {
  if (isPlane(type)) return type == kFixedWing ? Vehicle::Plane : Vehicle::QuadPlane;
  for (const Row& row : kRows) {
    if (fromFlash(&row.type) == type)
      return static_cast<Vehicle>(fromFlash(reinterpret_cast<const uint8_t*>(&row) + 1));
  }
  return Vehicle::Unknown;
}

}  // namespace detail
}  // namespace mavmission
