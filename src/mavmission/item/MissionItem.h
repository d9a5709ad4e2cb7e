// One step of a plan, with the values that go over the wire, and functions that make the usual steps.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "LatLon.h"
#include "Units.h"

namespace mavmission {

// The commands that the library knows by name (MAV_CMD, MAVLink common messages). Any other number may be used too.
enum : uint16_t {
  kNavWaypoint = 16,
  kNavLoiterUnlimited = 17,
  kNavLoiterTurns = 18,
  kNavLoiterTime = 19,
  kNavReturnToLaunch = 20,
  kNavLand = 21,
  kNavTakeoff = 22,
  kNavRoi = 80,
  kNavSplineWaypoint = 82,
  kNavVtolTakeoff = 84,
  kNavVtolLand = 85,
  kNavDelay = 93,
  kConditionDelay = 112,
  kConditionYaw = 115,
  kDoJump = 177,
  kDoChangeSpeed = 178,
  kDoSetRelay = 181,
  kDoSetServo = 183,
  kDoSetRoiLocation = 195,
  kDoSetRoiNone = 197,
  kDoSetRoi = 201,
  kDoDigicamControl = 203,
  kDoSetCameraTriggerDistance = 206,
  kFenceReturnPoint = 5000,
  kFencePolygonInclusion = 5001,
  kFencePolygonExclusion = 5002,
  kFenceCircleInclusion = 5003,
  kFenceCircleExclusion = 5004,
  kRallyPoint = 5100,
};

// A step of a plan: MISSION_ITEM_INT without its addresses. A plain struct that may be in flash; make one with the
// functions below.
struct MissionItem {
  float param1, param2, param3, param4;  // meaning by command; a NaN is allowed only where param4 is a yaw
  int32_t x;                             // latitude [1e-7 deg], or parameter 5 with CoordinateFrame::Mission
  int32_t y;                             // longitude [1e-7 deg], or parameter 6 with CoordinateFrame::Mission
  float z;                               // altitude [m, from what frame says], or parameter 7
  uint16_t command;                      // MAV_CMD
  CoordinateFrame frame;                 // MAV_FRAME
  uint8_t current;                       // 1: PX4 begins here if the plan comes in flight; else 0. 2, 3: refused
  uint8_t autocontinue;                  // 1: go on to the next item
};

// The size of param1 to z, which are in the same order as in MISSION_ITEM_INT [bytes].
constexpr uint8_t kPlaceBytes = 28;
static_assert(offsetof(MissionItem, command) == kPlaceBytes,
              "param1 to z must come first: they are copied in one piece");

// Any command without coordinates, by hand: the parameters are those of MAV_CMD's table.
constexpr MissionItem anyCommand(uint16_t id, float param1 = 0, float param2 = 0, float param3 = 0, float param4 = 0,
                                 int32_t param5 = 0, int32_t param6 = 0, float param7 = 0) {
  return MissionItem{param1, param2, param3, param4, param5, param6, param7, id, CoordinateFrame::Mission, 0, 1};
}

// Any command with coordinates, by hand.
constexpr MissionItem anyCommandAt(uint16_t id, Degrees latitude, Degrees longitude, Altitude altitude,
                                   float param1 = 0, float param2 = 0, float param3 = 0, float param4 = 0) {
  return MissionItem{param1, param2,           param3, param4, latitude.e7(), longitude.e7(), altitude.metres(),
                     id,     altitude.frame(), 0,      1};
}

// Climb vertically to the altitude. (PX4 needs coordinates; it gets those of the nearest item that has some.)
constexpr MissionItem takeoff(Altitude altitude, Yaw yaw = Yaw()) {
  return anyCommandAt(kNavTakeoff, Degrees(), Degrees(), altitude, 0, 0, 0, yaw.inDegrees());
}
// Climb and fly to a place.
constexpr MissionItem takeoff(Degrees latitude, Degrees longitude, Altitude altitude, Yaw yaw = Yaw()) {
  return anyCommandAt(kNavTakeoff, latitude, longitude, altitude, 0, 0, 0, yaw.inDegrees());
}
constexpr MissionItem takeoff(const LatLon& place, Altitude altitude, Yaw yaw = Yaw()) {
  return takeoff(place.latitude, place.longitude, altitude, yaw);
}

// Fly to a place. A copter waits there for `hold` (on ArduPilot in whole seconds only). The place counts as reached
// within `acceptanceRadius` (0: the autopilot's own setting; an ArduCopter always uses its own setting).
constexpr MissionItem waypoint(Degrees latitude, Degrees longitude, Altitude altitude, Seconds hold = Seconds(0),
                               Metres acceptanceRadius = Metres(0), Yaw yaw = Yaw()) {
  return anyCommandAt(kNavWaypoint, latitude, longitude, altitude, hold.value, acceptanceRadius.value, 0,
                      yaw.inDegrees());
}
constexpr MissionItem waypoint(const LatLon& place, Altitude altitude, Seconds hold = Seconds(0),
                               Metres acceptanceRadius = Metres(0), Yaw yaw = Yaw()) {
  return waypoint(place.latitude, place.longitude, altitude, hold, acceptanceRadius, yaw);
}

// Fly to a place and stand there for `hold`, in whole seconds, so that work can be done meanwhile (Flight): a waypoint
// that PX4, too, takes for reached only within 2 m. On ArduPilot's planes, which do not hold, the upload is refused
// (Status::NotKept).
constexpr MissionItem stopAt(Degrees latitude, Degrees longitude, Altitude altitude, Seconds hold) {
  return waypoint(latitude, longitude, altitude, hold, Metres(2));
}
constexpr MissionItem stopAt(const LatLon& place, Altitude altitude, Seconds hold) {
  return stopAt(place.latitude, place.longitude, altitude, hold);
}

// Stay at a place for a time. A fixed-wing aircraft circles at `radius`, counter-clockwise if it is negative (0: its
// default).
constexpr MissionItem loiterTime(Degrees latitude, Degrees longitude, Altitude altitude, Seconds time,
                                 Metres radius = Metres(0)) {
  return anyCommandAt(kNavLoiterTime, latitude, longitude, altitude, time.value, 0, radius.value, 0);
}
// Circle a place `turns` times. PX4 does not fly it (Status::NotFlown).
constexpr MissionItem loiterTurns(Degrees latitude, Degrees longitude, Altitude altitude, float turns,
                                  Metres radius = Metres(0)) {
  return anyCommandAt(kNavLoiterTurns, latitude, longitude, altitude, turns, 0, radius.value, 0);
}
// Stay at a place until another command comes.
constexpr MissionItem loiterUnlimited(Degrees latitude, Degrees longitude, Altitude altitude, Metres radius = Metres(0),
                                      Yaw yaw = Yaw()) {
  return anyCommandAt(kNavLoiterUnlimited, latitude, longitude, altitude, 0, 0, radius.value, yaw.inDegrees());
}

// Land where the aircraft then is. (PX4 needs coordinates; it gets those of the nearest item that has some.)
constexpr MissionItem land(Yaw yaw = Yaw()) {
  return anyCommandAt(kNavLand, Degrees(), Degrees(), Altitude(Metres(0)), 0, 0, 0, yaw.inDegrees());
}
// Fly to a place and land.
constexpr MissionItem land(Degrees latitude, Degrees longitude, Yaw yaw = Yaw()) {
  return anyCommandAt(kNavLand, latitude, longitude, Altitude(Metres(0)), 0, 0, 0, yaw.inDegrees());
}
constexpr MissionItem land(const LatLon& place, Yaw yaw = Yaw()) { return land(place.latitude, place.longitude, yaw); }

// Fly home and land. An ArduPilot plane circles there by default: end its plan with land().
constexpr MissionItem returnToLaunch() { return anyCommand(kNavReturnToLaunch); }

// Wait at the last waypoint.
constexpr MissionItem delay(Seconds time) { return anyCommand(kNavDelay, time.value, -1, -1, -1); }

// Fly at this ground speed from here on. (In flight, without a plan: Steering::setSpeed().)
constexpr MissionItem changeSpeed(MetresPerSecond speed) { return anyCommand(kDoChangeSpeed, 1, speed.value, -1); }

namespace literal {
// A constant plan that calls this does not compile: a jump is repeated at most 32,767 times, or for ever (-1). A
// computed plan is refused when it is checked.
inline auto jumpRepeatsMustBeFromMinus1To32767(uint16_t target, int32_t repeats) -> MissionItem {
  return anyCommand(kDoJump, target, repeats);
}
}  // namespace literal

// Continue with item `target`, `repeats` times (-1: for ever). `target` counts the sketch's items from 0, on every
// autopilot.
constexpr MissionItem jump(uint16_t target, int32_t repeats) {
  return repeats >= -1 && repeats <= 32767 ? anyCommand(kDoJump, target, repeats)
                                           : literal::jumpRepeatsMustBeFromMinus1To32767(target, repeats);
}

// Set an output to a pulse length [us]. PX4 does not take it in a plan (Status::NotFlown).
constexpr MissionItem setServo(uint8_t output, uint16_t pulseUs) { return anyCommand(kDoSetServo, output, pulseUs); }

// Switch a relay, counted from 0. PX4 does not take it in a plan (Status::NotFlown).
constexpr MissionItem setRelay(uint8_t relay, bool on) { return anyCommand(kDoSetRelay, relay, on ? 1 : 0); }

// Take a picture now.
constexpr MissionItem takePicture() { return anyCommand(kDoDigicamControl, 0, 0, 0, 0, 1); }

// Take a picture every `distance` from here on; 0 m stops it.
constexpr MissionItem cameraTriggerDistance(Metres distance) {
  return anyCommand(kDoSetCameraTriggerDistance, distance.value);
}

// Point the camera (or the nose) at a place from here on.
constexpr MissionItem regionOfInterest(Degrees latitude, Degrees longitude, Altitude altitude) {
  return anyCommandAt(kDoSetRoiLocation, latitude, longitude, altitude);
}
// Point the camera (or the nose) ahead again.
constexpr MissionItem regionOfInterestOff() { return anyCommand(kDoSetRoiNone); }

// Turn to a heading and fly on. PX4 does not take it in a plan (Status::NotFlown): give the waypoint a yaw instead.
constexpr MissionItem turnTo(Degrees heading) { return anyCommand(kConditionYaw, Yaw(heading).inDegrees(), 0, 0, 0); }
constexpr MissionItem turnTo(WideHeading heading) {
  return anyCommand(kConditionYaw, Yaw(heading).inDegrees(), 0, 0, 0);
}

// --- Items of a fence: upload(fence, PlanType::Fence).

// One corner of a polygon that the aircraft must not leave. All corners of a polygon follow one another, each with the
// same `corners`: how many corners the polygon has.
constexpr MissionItem fenceInside(Degrees latitude, Degrees longitude, uint8_t corners) {
  return anyCommandAt(kFencePolygonInclusion, latitude, longitude, Altitude(Metres(0), CoordinateFrame::Global),
                      corners);
}
// One corner of a polygon that the aircraft must not enter.
constexpr MissionItem fenceOutside(Degrees latitude, Degrees longitude, uint8_t corners) {
  return anyCommandAt(kFencePolygonExclusion, latitude, longitude, Altitude(Metres(0), CoordinateFrame::Global),
                      corners);
}
// A circle that the aircraft must not leave.
constexpr MissionItem fenceInsideCircle(Degrees latitude, Degrees longitude, Metres radius) {
  return anyCommandAt(kFenceCircleInclusion, latitude, longitude, Altitude(Metres(0), CoordinateFrame::Global),
                      radius.value);
}
// A circle that the aircraft must not enter.
constexpr MissionItem fenceOutsideCircle(Degrees latitude, Degrees longitude, Metres radius) {
  return anyCommandAt(kFenceCircleExclusion, latitude, longitude, Altitude(Metres(0), CoordinateFrame::Global),
                      radius.value);
}
// The point to which the aircraft goes when it has breached the fence (ArduPilot's Plane).
constexpr MissionItem fenceReturnPoint(Degrees latitude, Degrees longitude) {
  return anyCommandAt(kFenceReturnPoint, latitude, longitude, Altitude(Metres(0), CoordinateFrame::Global));
}

// --- Items of a rally plan: upload(points, PlanType::Rally).

// A place to land instead of at home. ArduPilot takes only whole metres of altitude.
constexpr MissionItem rallyPoint(Degrees latitude, Degrees longitude, Altitude altitude) {
  return anyCommandAt(kRallyPoint, latitude, longitude, altitude);
}

}  // namespace mavmission
