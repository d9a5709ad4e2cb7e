// The upload with a download behind it.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
MissionClient autopilot(Serial1);
volatile uint8_t seen;

bool store(void*, uint16_t, const MissionItem& item) {
  seen = item.command;
  return true;
}

void setup() {
  Serial1.begin(57600);
  autopilot.upload(inFlash(survey));
}
void loop() {
  if (autopilot.update() == Status::Accepted) autopilot.download(toFunction(store));
}
