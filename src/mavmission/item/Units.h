// Lengths, times, altitudes and headings that cannot be mistaken for one another: each is a type of its own, made by a
// literal (20_m, 10_s, 5_mps, 90_deg) or by name from a computed number.
#pragma once

#include <stdint.h>

#include "../base/Config.h"
#include "Degrees.h"

namespace mavmission {

// A length [m].
struct Metres {
  float value;  // [m]
  // From a number that was computed.
  constexpr explicit Metres(float metres) : value(metres) {}
  // The same length downwards, for an altitude below its reference: -20_m.
  constexpr Metres operator-() const { return Metres(-value); }
};

// A duration [s].
struct Seconds {
  float value;  // [s]
  // From a number that was computed.
  constexpr explicit Seconds(float seconds) : value(seconds) {}
};

// A speed [m/s].
struct MetresPerSecond {
  float value;  // [m/s]
  // From a number that was computed.
  constexpr explicit MetresPerSecond(float metresPerSecond) : value(metresPerSecond) {}
};

// Lengths, durations and speeds as literals: 20_m, 2.5_s, 5_mps.
constexpr Metres operator"" _m(unsigned long long value) { return Metres(static_cast<float>(value)); }
constexpr Metres operator"" _m(long double value) { return Metres(static_cast<float>(value)); }
constexpr Seconds operator"" _s(unsigned long long value) { return Seconds(static_cast<float>(value)); }
constexpr Seconds operator"" _s(long double value) { return Seconds(static_cast<float>(value)); }
constexpr MetresPerSecond operator"" _mps(unsigned long long value) {
  return MetresPerSecond(static_cast<float>(value));
}
constexpr MetresPerSecond operator"" _mps(long double value) { return MetresPerSecond(static_cast<float>(value)); }

// MAV_FRAME (MAVLink common messages): what the coordinates of an item mean.
enum class CoordinateFrame : uint8_t {
  Global = 0,             // altitude [m above mean sea level]
  Mission = 2,            // no coordinates: x, y and z are parameters 5 to 7
  GlobalRelative = 3,     // altitude [m above home]
  GlobalInt = 5,          // as Global; the older number for MISSION_ITEM_INT
  GlobalRelativeInt = 6,  // as GlobalRelative; the older number for MISSION_ITEM_INT
  GlobalTerrain = 10,     // altitude [m above the ground below]
  GlobalTerrainInt = 11,  // as GlobalTerrain; the older number for MISSION_ITEM_INT
};

// The current number of a frame whose number is deprecated: 0, 3 and 10 for 5, 6 and 11.
MAVMISSION_APART inline CoordinateFrame modern(CoordinateFrame frame) {
  if (frame == CoordinateFrame::GlobalInt) return CoordinateFrame::Global;
  if (frame == CoordinateFrame::GlobalRelativeInt) return CoordinateFrame::GlobalRelative;
  if (frame == CoordinateFrame::GlobalTerrainInt) return CoordinateFrame::GlobalTerrain;
  return frame;
}

// An altitude with its reference. Plain metres, 20_m, are above home.
class Altitude {
 public:
  // Metres above home, or above the reference that `frame` names.
  constexpr Altitude(Metres aboveHome) : metres_(aboveHome.value), frame_(CoordinateFrame::GlobalRelative) {}
  constexpr Altitude(Metres metres, CoordinateFrame frame) : metres_(metres.value), frame_(frame) {}
  // Any other type is refused when the sketch is compiled.
  template <typename Other>
  constexpr Altitude(Other) : metres_(0), frame_(CoordinateFrame::Global) {
    static_assert(sizeof(Other) == 0, "write an altitude with its unit: 20_m, or Metres(height) for a computed one");
  }
  // The two values.
  constexpr float metres() const { return metres_; }
  constexpr CoordinateFrame frame() const { return frame_; }

 private:
  float metres_;
  CoordinateFrame frame_;
};

// Above the place where the aircraft was armed or home was set: the same as plain metres.
constexpr Altitude aboveHome(Metres metres) { return Altitude(metres, CoordinateFrame::GlobalRelative); }
// Above mean sea level (MSL), as maps and GPS receivers give it.
constexpr Altitude aboveSeaLevel(Metres metres) { return Altitude(metres, CoordinateFrame::Global); }
// Above the ground below the aircraft. The autopilot needs terrain data; PX4 1.17 does not take it in a plan
// (Status::BadFrame).
constexpr Altitude aboveTerrain(Metres metres) { return Altitude(metres, CoordinateFrame::GlobalTerrain); }

// A heading [degrees from north, clockwise, -180 to 360], or unset, which is the default everywhere: the autopilot
// chooses.
class Yaw {
 public:
  constexpr Yaw() : degrees_(__builtin_nanf("")) {}
  // From north, clockwise.
  constexpr Yaw(Degrees heading) : degrees_(static_cast<float>(heading.e7()) / 10000000.f) {}
  constexpr Yaw(WideHeading heading) : degrees_(static_cast<float>(heading.e7()) / 10000000.f) {}
  constexpr float inDegrees() const { return degrees_; }  // NaN: unset

 private:
  float degrees_;
};

}  // namespace mavmission
