// A HomeListener: where home is.
#include <doctest/doctest.h>
#include <string.h>

#include "mavmission/telemetry/TelemetryListener.h"

// It is to be compiled with room for 60 bytes, and the programs of these tests have less: enough for a HOME_POSITION
// whose last 8 bytes, the time, are 0, since MAVLink 2 omits them. So the check of the buffer's length is set aside
// here.
#pragma push_macro("MAVMISSION_MAX_PAYLOAD")
#undef MAVMISSION_MAX_PAYLOAD
#define MAVMISSION_MAX_PAYLOAD 60
#include "mavmission/telemetry/HomeListener.h"
#pragma pop_macro("MAVMISSION_MAX_PAYLOAD")

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

struct Desk : ClientOnLine {
  HomeListener home;

  explicit Desk(uint16_t intervalMs) : ClientOnLine(kArduPilot), home(client, intervalMs) {}

  void tell(int32_t latitude, int32_t longitude, int32_t altitude, uint8_t systemId = 1) {
    mavlink_home_position_t message = mavlink_home_position_t();
    message.latitude = latitude;
    message.longitude = longitude;
    message.altitude = altitude;
    message.approach_z = 1;  // so that nothing before the time is omitted
    Bytes payload(52);
    memcpy(payload.data(), &message, payload.size());
    FrameParts parts(MAVLINK_MSG_ID_HOME_POSITION, payload, MAVLINK_MSG_ID_HOME_POSITION_CRC);
    parts.systemId = systemId;
    hear(parts);
    run(5);
  }
};

}  // namespace

TEST_CASE("home is a place and a height above sea level, as the autopilot says it") {
  Desk desk(0);
  desk.run(3500);
  CHECK_FALSE(desk.home.isHeard());
  CHECK(desk.home.place().latitude.e7() == 0);
  CHECK(desk.home.place().longitude.e7() == 0);
  CHECK(desk.home.aboveSeaLevelMm() == 0);
  desk.tell(1, 2, 3, 2);  // another aircraft's
  CHECK_FALSE(desk.home.isHeard());
  desk.tell(-353632621, 1491652374, 584090);
  CHECK(desk.home.isHeard());
  CHECK(desk.home.isNew());
  CHECK_FALSE(desk.home.isNew());
  CHECK(desk.home.place().latitude.e7() == -353632621);
  CHECK(desk.home.place().longitude.e7() == 1491652374);
  CHECK(desk.home.aboveSeaLevelMm() == 584090);
  desk.tell(-1, -2, -30);
  CHECK(desk.home.place().latitude.e7() == -1);
  CHECK(desk.home.place().longitude.e7() == -2);
  CHECK(desk.home.aboveSeaLevelMm() == -30);
  CHECK(desk.home.isNew());
}

TEST_CASE("HOME_POSITION is requested at the listener's interval") {
  Desk desk(4000);
  REQUIRE(desk.runUntilSent(MAVLINK_MSG_ID_COMMAND_LONG, 3000));
  mavlink_command_long_t command;
  memcpy(&command, desk.sent.back().payload.data(), sizeof(command));
  CHECK((command.command == MAV_CMD_SET_MESSAGE_INTERVAL));
  CHECK((command.param1 == MAVLINK_MSG_ID_HOME_POSITION));
  CHECK((command.param2 == 4000000));
}
