// Prints what an AltitudeListener makes of an ALTITUDE. test/proof/test_changes.py compiles it with a library that has
// one.
#include <MavMission.h>
#include <stdio.h>
#include <string.h>

#include "../ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

int main() {
  ClientOnLine desk(ClientOnLine::kPx4);
  mavmission::AltitudeListener altitude(desk.client);
  mavlink_altitude_t message = mavlink_altitude_t();
  message.altitude_relative = 12.34f;
  Bytes payload(sizeof(message));
  memcpy(payload.data(), &message, sizeof(message));
  desk.run(2000);
  desk.hear(FrameParts(MAVLINK_MSG_ID_ALTITUDE, payload, MAVLINK_MSG_ID_ALTITUDE_CRC));
  printf("%d\n", altitude.isHeard());
  desk.run(5);
  printf("%d\n%ld\n", altitude.isHeard(), static_cast<long>(altitude.aboveHomeCm()));
  return 0;
}
