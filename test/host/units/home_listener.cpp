// A HomeListener: where home is.
#include <doctest/doctest.h>

#include "mavmission/telemetry/TelemetryListener.h"

// It is to be compiled with room for 60 bytes, and the programs of these tests have less: enough for a HOME_POSITION
// whose last 8 bytes, the time, are 0, since MAVLink 2 omits them. So the check of the buffer's length is set aside
// here.
#pragma push_macro("MAVMISSION_MAX_PAYLOAD")
#undef MAVMISSION_MAX_PAYLOAD
#define MAVMISSION_MAX_PAYLOAD 60
#include "mavmission/telemetry/HomeListener.h"
#pragma pop_macro("MAVMISSION_MAX_PAYLOAD")

#include "ToldClient.h"

using namespace mavmission;

namespace {

std::string says(const HomeListener& home) {
  return std::to_string(home.place().latitude.e7()) + " " + std::to_string(home.place().longitude.e7()) + " " +
         std::to_string(home.aboveSeaLevelMm());
}

}  // namespace

TEST_CASE("home is a place and a height above sea level, as the autopilot says it") {
  Told<HomeListener> desk;
  HomeListener& home = desk.listener;
  CHECK_FALSE(home.isHeard());
  CHECK(says(home) == "0 0 0");
  desk.tell("HOME_POSITION latitude 1 longitude 2 altitude 3", 2);  // another aircraft's
  CHECK_FALSE(home.isHeard());
  // With an approach, so that nothing before the time is omitted.
  desk.tell("HOME_POSITION latitude -353632621 longitude 1491652374 altitude 584090 approach_z 1");
  CHECK(home.isHeard());
  CHECK(home.isNew());
  CHECK_FALSE(home.isNew());
  CHECK(says(home) == "-353632621 1491652374 584090");
  desk.tell("HOME_POSITION latitude -1 longitude -2 altitude -30 approach_z 1");
  CHECK(says(home) == "-1 -2 -30");
  CHECK(home.isNew());
}

TEST_CASE("HOME_POSITION is requested at the listener's interval") {
  Told<HomeListener> desk(4000);
  REQUIRE(desk.runUntilSent(MAVLINK_MSG_ID_COMMAND_LONG, 3000));
  CHECK_FALSE(desk.requests(242, 4000).empty());
}
