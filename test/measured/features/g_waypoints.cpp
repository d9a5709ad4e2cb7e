// The upload of a .waypoints text by a WaypointsSource, the stream below it apart.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

struct Text : Stream {
  bool seek(uint32_t) { return true; }
  int available() override { return 1; }
  int peek() override { return GPIOR0; }
  int read() override { return GPIOR0; }
  size_t write(uint8_t) override { return 0; }
} text;

MissionClient autopilot(Serial1);
WaypointsSource plan(text);

void setup() {
  Serial1.begin(57600);
  plan.begin();
}
void loop() {
  if (plan.state() == WaypointsSource::State::Reading && plan.update() == WaypointsSource::State::Good) {
    autopilot.upload(plan.source());
  }
  autopilot.update();
}
