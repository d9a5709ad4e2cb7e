// What a PositionListener says of what is not known.
#include "mavmission/telemetry/PositionListener.h"

#include <doctest/doctest.h>
#include <string.h>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

constexpr int32_t kNone = PositionListener::kNoHeight;

struct Heard : ClientOnLine {
  PositionListener position;

  explicit Heard(uint8_t autopilot) : ClientOnLine(autopilot), position(client, 0) { run(3000); }

  void tell(int32_t altMm, int32_t relativeMm, uint16_t headingCdeg, bool hasPlace = true) {
    mavlink_global_position_int_t message = mavlink_global_position_int_t();
    if (hasPlace) message.lat = message.lon = 470000000;
    message.alt = altMm;
    message.relative_alt = relativeMm;
    message.hdg = headingCdeg;
    hear(FrameParts(33, message, 104));
    run(5);
  }
};

}  // namespace

TEST_CASE("a heading that is not known is 0, and hasHeading() says so") {
  Heard desk(ClientOnLine::kArduPilot);
  CHECK_FALSE(desk.position.hasHeading());
  CHECK(desk.position.heading().e7() == 0);
  for (uint16_t unknown : {36001, 65535}) {
    desk.tell(1, 1, static_cast<uint16_t>(unknown));
    CHECK_FALSE(desk.position.hasHeading());
    CHECK(desk.position.heading().e7() == 0);
  }
  desk.tell(1, 1, 27000);
  CHECK(desk.position.hasHeading());
  CHECK(desk.position.heading().e7() == -900000000);
}

TEST_CASE("the height above a home at 0.000 m above sea level is known") {
  Heard desk(ClientOnLine::kArduPilot);
  desk.tell(20000, 20000, 0);
  CHECK(desk.position.hasHeights());
  CHECK(desk.position.aboveHomeMm() == 20000);
  CHECK(desk.position.homeAboveSeaLevelMm() == 0);
  CHECK(desk.position.altitude().metres() == 20);
}

TEST_CASE("a height is not known before a place is, nor above PX4's home before it has one") {
  Heard arduPilot(ClientOnLine::kArduPilot);
  arduPilot.tell(0, 0, 0, false);
  CHECK(arduPilot.position.aboveHomeMm() == kNone);
  arduPilot.tell(0, 0, 0);
  CHECK(arduPilot.position.aboveHomeMm() == 0);
  Heard px4(ClientOnLine::kPx4);
  px4.tell(489500, 489500, 0);
  CHECK(px4.position.aboveHomeMm() == kNone);
  CHECK(px4.position.homeAboveSeaLevelMm() == kNone);
  px4.tell(489500, 1500, 0);
  CHECK(px4.position.aboveHomeMm() == 1500);
  CHECK(px4.position.homeAboveSeaLevelMm() == 488000);
}

TEST_CASE("a home whose height does not fit is not known") {
  Heard desk(ClientOnLine::kArduPilot);
  const struct {
    int32_t altMm, relativeMm, homeMm;
  } kHeights[] = {{INT32_MAX, -1, kNone},        {INT32_MAX, 0, INT32_MAX},     {INT32_MAX, 1, INT32_MAX - 1},
                  {-1, INT32_MAX, kNone},        {0, INT32_MAX, INT32_MIN + 1}, {INT32_MIN, 1, kNone},
                  {0, INT32_MIN + 1, INT32_MAX}, {INT32_MIN, -1, INT32_MIN + 1}};
  for (const auto& one : kHeights) {
    CAPTURE(one.altMm);
    CAPTURE(one.relativeMm);
    desk.tell(one.altMm, one.relativeMm, 0);
    CHECK(desk.position.homeAboveSeaLevelMm() == one.homeMm);
  }
}
