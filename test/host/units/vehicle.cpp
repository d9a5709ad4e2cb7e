#include "mavmission/autopilot/VehicleKind.h"

#include <doctest/doctest.h>

#include <map>
#include <string>

#include "mavmission/autopilot/Commands.h"
#include "mavmission/autopilot/FlightMode.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;
using namespace mavmission::detail;
using mavmission::detail::Vehicle;  // and not the one of telemetry

namespace {

// What the sources of ArduPilot 4.6.3 send in HEARTBEAT.type: AP_Motors' classes by way of ArduCopter, ArduPlane with
// its Q_MAV_TYPE for a VTOL, Rover's frame_type(), ArduSub, Blimp.
const std::map<unsigned, Vehicle> kVehicles = {
    {1, Vehicle::Plane},      {2, Vehicle::Copter},     {3, Vehicle::Copter},     {4, Vehicle::Copter},
    {7, Vehicle::Blimp},      {10, Vehicle::Rover},     {11, Vehicle::Rover},     {12, Vehicle::Submarine},
    {13, Vehicle::Copter},    {14, Vehicle::Copter},    {15, Vehicle::Copter},    {19, Vehicle::QuadPlane},
    {20, Vehicle::QuadPlane}, {21, Vehicle::QuadPlane}, {22, Vehicle::QuadPlane}, {23, Vehicle::QuadPlane},
    {24, Vehicle::QuadPlane}, {25, Vehicle::QuadPlane}, {29, Vehicle::Copter},    {35, Vehicle::Copter},
};

Vehicle expected(unsigned type) {
  const std::map<unsigned, Vehicle>::const_iterator found = kVehicles.find(type);
  return found == kVehicles.end() ? Vehicle::Unknown : found->second;
}

}  // namespace

TEST_CASE("a type is one vehicle's, or unknown: none is a copter because it is no other") {
  for (unsigned type = 0; type < 256; ++type) {
    CAPTURE(type);
    const uint8_t byte = static_cast<uint8_t>(type);
    const Vehicle vehicle = vehicleOf(byte);
    CHECK(static_cast<int>(vehicle) == static_cast<int>(expected(type)));
    const bool isOne = vehicle == Vehicle::Plane || vehicle == Vehicle::QuadPlane;
    CHECK(isPlane(byte) == isOne);
    CHECK(((keeperOf(Firmware::ArduPilot, byte, PlanType::Mission) & kByPlane) != 0) == isOne);
  }
}

TEST_CASE("an unknown type has no mode on ArduPilot, and each on PX4") {
  for (unsigned type = 0; type < 256; ++type) {
    CAPTURE(type);
    const uint8_t byte = static_cast<uint8_t>(type);
    for (FlightMode mode : {FlightMode::Auto, FlightMode::Guided, FlightMode::ReturnToLaunch, FlightMode::Hold,
                            FlightMode::Land, FlightMode::Brake, FlightMode::Manual}) {
      if (expected(type) == Vehicle::Unknown) CHECK(modeNumber(mode, Firmware::ArduPilot, byte) == kNoMode);
      CHECK(modeNumber(mode, Firmware::Px4, byte) == modeNumber(mode, Firmware::Px4, 2));
    }
  }
}

TEST_CASE("each vehicle's modes have its own names") {
  const auto px4s = [](uint32_t main, uint32_t sub) { return main << 16 | sub << 24; };
  const struct {
    Firmware firmware;
    uint8_t type;
    uint32_t mode;
    const char* name;
  } kRows[] = {
      {Firmware::ArduPilot, MAV_TYPE_QUADROTOR, 4, "GUIDED"},
      {Firmware::ArduPilot, MAV_TYPE_QUADROTOR, 8, "unknown"},
      {Firmware::ArduPilot, MAV_TYPE_QUADROTOR, 300, "unknown"},
      {Firmware::ArduPilot, MAV_TYPE_FIXED_WING, 10, "AUTO"},
      {Firmware::ArduPilot, MAV_TYPE_VTOL_TAILSITTER, 17, "QSTABILIZE"},
      {Firmware::ArduPilot, MAV_TYPE_GROUND_ROVER, 4, "HOLD"},
      {Firmware::ArduPilot, MAV_TYPE_SUBMARINE, 19, "MANUAL"},
      {Firmware::ArduPilot, MAV_TYPE_AIRSHIP, 3, "LOITER"},
      {Firmware::ArduPilot, MAV_TYPE_GCS, 0, "unknown"},
      {Firmware::Px4, MAV_TYPE_QUADROTOR, px4s(3, 0), "POSCTL"},
      {Firmware::Px4, MAV_TYPE_QUADROTOR, px4s(4, 4), "MISSION"},
      {Firmware::Px4, MAV_TYPE_QUADROTOR, px4s(4, 99), "unknown"},
      {Firmware::Px4, MAV_TYPE_QUADROTOR, 0, "unknown"},
      {Firmware::Px4, MAV_TYPE_QUADROTOR, px4s(9, 0), "unknown"},
      {Firmware::Other, MAV_TYPE_QUADROTOR, 0, "unknown"},
  };
  for (const auto& row : kRows) {
    CHECK(std::string(reinterpret_cast<const char*>(modeName(row.firmware, row.type, row.mode))) == row.name);
  }
}
