// An upload of 24 items whose update() can be watched, in a loop that can be made to stall.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

// Each kind of item that costs differently on either autopilot: with a place, looking for one, a jump, none of these.
#define EIGHT                                                                                       \
  takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),                                  \
      waypoint(-35.3614500_deg, 149.1652374_deg, 25_m, 3_s), jump(1, 2), changeSpeed(5_mps),        \
      loiterTime(-35.3614500_deg, 149.1652374_deg, 20_m, 9_s), delay(5_s), land()
constexpr MissionItem plan[] PROGMEM = {EIGHT, EIGHT, EIGHT};

MissionClient autopilot(Serial1);
volatile uint16_t stallMs;
volatile uint8_t ended;

extern "C" __attribute__((noinline)) Status measured_update() { return autopilot.update(); }

void setup() {
  Serial1.begin(BAUD);
  autopilot.upload(inFlash(plan));
}

void loop() {
  if (stallMs != 0) delay(stallMs);
  const Status status = measured_update();
  if (isEnd(status)) ended = static_cast<uint8_t>(status);
}
