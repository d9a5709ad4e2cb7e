// The upload with the five listeners of telemetry that need no longer buffer.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
MissionClient autopilot(Serial1);
PositionListener position(autopilot, 500);
AttitudeListener attitude(autopilot, 500);
BatteryListener battery(autopilot, 500);
GpsListener gps(autopilot, 500);
RcListener rc(autopilot, 500);
volatile int32_t seen;

void setup() {
  Serial1.begin(57600);
  autopilot.upload(inFlash(survey));
}
void loop() {
  autopilot.update();
  if (position.isNew()) seen = position.place().latitude.e7() + position.aboveHomeMm();
  if (attitude.isNew()) seen = attitude.roll().e7();
  if (battery.isNew()) seen = battery.voltageMv() + battery.remainingPercent();
  if (gps.isNew()) seen = gps.satellites();
  if (rc.isNew()) seen = rc.channelUs(7);
}
