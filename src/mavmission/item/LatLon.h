// A place, and a second place at a given distance north and east of it: for plans that are computed.
#pragma once

#include <stdint.h>

#include "Degrees.h"

namespace mavmission {

// A latitude and a longitude.
struct LatLon {
  Degrees latitude;   // north is positive
  Degrees longitude;  // east is positive
};

// The place that is `northCm` north and `eastCm` east of `from`; south and west are negative. It is computed on the
// ellipsoid of GPS (WGS 84), with integers: within 10 km, and between 80 degrees south and north, the error is less
// than 1 cm plus 0.01 % of the distance. East is measured at the latitude of `from`, so that the columns of a grid are
// meridians. Of a place or a way that cannot be on the earth the result is any place.
LatLon moved(const LatLon& from, int32_t northCm, int32_t eastCm);

// The distance over the ground from one place to another [cm], also across 180 degrees of longitude; 20,000 km, which
// is 2,000,000,000, where it would be more. It is the inverse of moved(), with the same error. A latitude
// beyond a pole counts as the pole.
uint32_t distanceCm(const LatLon& from, const LatLon& to);

}  // namespace mavmission
