// Adjustments: what a copter is told of its heading and its speeds up and down, and which numbers are refused.
#include "mavmission/steering/Adjustments.h"

#include <doctest/doctest.h>

#include <initializer_list>
#include <limits>

#include "SteeredAircraft.h"

using namespace mavmission;
using namespace steered;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

constexpr DegreesPerSecond perSecond(float degrees) { return DegreesPerSecond(degrees); }
constexpr MetresPerSecond speed(float metres) { return MetresPerSecond(metres); }

// A heading that was computed.
Yaw yaw(float degrees) { return Yaw(Degrees::fromE7(static_cast<int32_t>(degrees * 1e7f))); }

// An aircraft that follows its mission, with a sketch that may steer it.
struct Flown : Aircraft {
  Adjustments adjustments;

  explicit Flown(uint8_t autopilot = kArduPilot, uint8_t vehicleType = 2)
      : Aircraft(autopilot, vehicleType), adjustments(steering) {
    inMission().show(mode);
    forget();
  }

  // What an operation comes to: its status, the number that is wrong, and what was sent.
  std::string turned(Yaw heading, float turn = 0) {
    adjustments.turnTo(heading, perSecond(turn));
    return how();
  }
  std::string climbs(bool isClimb, float metres) {
    isClimb ? adjustments.setClimbSpeed(speed(metres)) : adjustments.setDescentSpeed(speed(metres));
    return how();
  }
  std::string how() {
    const uint32_t asksBefore = asks;
    std::string text = status(500);
    if (client.differingField() != ItemField::None) text += std::string(" of ") + nameOf(client.differingField());
    CHECK_FALSE(client.isBusy());
    if (text != "Done" && text != "CommandDenied") CHECK(asks == asksBefore);  // nor is a heartbeat asked for
    return text + ": " + said();
  }
};

}  // namespace

TEST_CASE("a heading is one from 0 to 360 degrees on the wire, with its turn, and done when it is acknowledged") {
  const struct {
    Yaw heading;
    const char* told;
  } kHeadings[] = {{90_deg, "90"},      {-90_deg, "270"}, {0_deg, "0"},      {yaw(200.25f), "200.25"},
                   {-0.5_deg, "359.5"}, {180_deg, "180"}, {-180_deg, "180"}, {yaw(0.01f), "0.01"}};
  Flown flight;
  for (const auto& one : kHeadings) {
    CHECK(flight.turned(one.heading, 30.5f) == "Done: L115 " + std::string(one.told) + " 30.5 0 0 0 0 0");
  }
  CHECK(flight.turned(90_deg) == "Done: L115 90 0 0 0 0 0 0");
  CHECK(flight.mode == kAuto);
}

TEST_CASE("a speed upwards or downwards is told alone; it is above 0, and at most 20 m/s") {
  const struct {
    float metres;
    const char* how;
  } kCases[] = {{1e-45f, "Done: 1.4013e-45"},
                {0.005f, "Done: 0.005"},
                {1.5f, "Done: 1.5"},
                {20, "Done: 20"},
                {0, "BadSpeed"},
                {-0.0f, "BadSpeed"},
                {-1, "BadSpeed"},
                {20.00001f, "BadSpeed"},
                {1e9f, "BadSpeed"},
                {kInfinity, "NotFinite"},
                {-kInfinity, "BadSpeed"},
                {kNan, "NotANumber"}};
  for (bool isClimb : {true, false}) {
    for (const auto& one : kCases) {
      CAPTURE(one.metres);
      const std::string how = one.how;
      const bool isDone = how.compare(0, 6, "Done: ") == 0;
      CHECK(Flown().climbs(isClimb, one.metres) ==
            (isDone ? "Done: L178 " + std::string(isClimb ? "2 " : "3 ") + how.substr(6) + " -1 0 0 0 0"
                    : how + " of Param2: "));
    }
  }
}

TEST_CASE("the numbers of a turn that are refused are named") {
  const struct {
    Yaw heading;
    float turn;
    const char* how;
  } kCases[] = {
      {360_deg, 360, "Done: L115 360 360 0 0 0 0 0"},
      {-180_deg, -0.0f, "Done: L115 180 -0 0 0 0 0 0"},
      {WideHeading(3600001000), 0, "BadRange of Param1: "},
      {Yaw(), 0, "NotANumber of Param1: "},
      {Yaw(), 400, "NotANumber of Param1: "},
      {WideHeading(4000000000), -1, "BadRange of Param2: "},
      {0_deg, -1e-45f, "BadRange of Param2: "},
      {0_deg, 360.0001f, "BadRange of Param2: "},
      {0_deg, -30, "BadRange of Param2: "},
      {0_deg, kInfinity, "NotFinite of Param2: "},
      {0_deg, kNan, "NotANumber of Param2: "},
  };
  for (const auto& one : kCases) {
    CAPTURE(one.heading.inDegrees());
    CAPTURE(one.turn);
    CHECK(Flown().turned(one.heading, one.turn) == one.how);
  }
}

TEST_CASE("no other vehicle than ArduCopter takes any of them, whoever has it") {
  const struct {
    uint8_t autopilot, type;
    uint32_t autoMode, pilotsMode;
  } kOthers[] = {{ClientOnLine::kArduPilot, MAV_TYPE_GROUND_ROVER, kRoverAuto, 0},
                 {ClientOnLine::kArduPilot, MAV_TYPE_SUBMARINE, kAuto, 0},
                 {ClientOnLine::kArduPilot, MAV_TYPE_FIXED_WING, kPlaneAuto, 0},
                 {ClientOnLine::kPx4, MAV_TYPE_QUADROTOR, kPx4Mission, kPx4Position}};
  for (const auto& other : kOthers) {
    CAPTURE(int{other.type});
    for (uint32_t mode : {other.autoMode, other.pilotsMode}) {
      Flown flight(other.autopilot, other.type);
      flight.show(mode);
      CHECK(flight.turned(90_deg, -1) == "CommandUnsupported: ");
      CHECK(flight.climbs(true, 1) == "CommandUnsupported: ");
      CHECK(flight.climbs(false, 1) == "CommandUnsupported: ");
    }
  }
}

TEST_CASE("nothing is adjusted for a pilot, or a failsafe, and a refusal of the autopilot's is the end") {
  for (uint32_t mode : {kLoiter, kRtl}) {
    Flown flight;
    flight.show(mode);
    CHECK(flight.turned(90_deg) == (mode == kRtl ? "FailsafeHasIt: " : "PilotHasIt: "));
  }
  Flown refused;
  refused.gives[MAV_CMD_DO_CHANGE_SPEED] = MAV_RESULT_DENIED;
  CHECK(refused.climbs(true, 3) == "CommandDenied: L178 2 3 -1 0 0 0 0");
}

TEST_CASE("while another operation runs none begins, and what runs is not changed") {
  Flown flight;
  CHECK((flight.adjustments.turnTo(90_deg, perSecond(20)) != Status::Busy));
  CHECK((flight.adjustments.turnTo(45_deg, perSecond(10)) == Status::Busy));
  CHECK((flight.adjustments.setClimbSpeed(3_mps) == Status::Busy));
  CHECK((flight.adjustments.setDescentSpeed(3_mps) == Status::Busy));
  CHECK(flight.how() == "Done: L115 90 20 0 0 0 0 0");
}
