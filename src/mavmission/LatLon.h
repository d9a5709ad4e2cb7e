// A place, and another one that is so many metres north and east of it: for plans that are computed.
#pragma once

#include <stdint.h>

#include "Degrees.h"

namespace mavmission {

// A latitude and a longitude.
struct LatLon {
  Degrees latitude;
  Degrees longitude;
};

// The place that is so far north and east of another one [cm]; south and west are negative. On the ellipsoid of GPS
// (WGS 84), by integers: within 10 km, and between 80 degrees south and north, it is off by less than 1 cm and 0.01 %
// of the way. East is measured at the latitude of `from`, so that the columns of a grid are meridians.
LatLon moved(const LatLon& from, int32_t northCm, int32_t eastCm);

}  // namespace mavmission
