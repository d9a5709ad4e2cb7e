// Every operation of a client with a follower and listeners, whose update() can be watched, in a loop that
// can be made to stall.
#include <Arduino.h>
#include <MavMission.h>

#include "items.h"

using namespace mavmission;
using namespace mavmission::detail;

// Ids, CRC_EXTRA and lengths of common.xml: GPS_RAW_INT, ATTITUDE, GLOBAL_POSITION_INT, HEARTBEAT.
const MessageKey keys[] PROGMEM = {messageKey(24, 24, 30), messageKey(30, 39, 28), messageKey(33, 104, 28),
                                   messageKey(0, 50, 9)};

volatile uint16_t heard;
void onMessage(void*, const ReceivedMessage&) { heard = heard + 1; }

MissionClient autopilot(Serial1);
MissionFollower mission(autopilot);
MessageListener messages(autopilot, keys, onMessage);
MissionItem sink[30];
FlightCommand command = {};

volatile uint16_t stallMs;
volatile uint8_t ended, ends;
volatile uint8_t operationDue;  // 1 to 9, in the order below

extern "C" __attribute__((noinline)) Status measured_update() { return autopilot.update(); }

void begin(uint8_t operation) {
  ended = 0;
  const ItemSource source = inFlash(plan);
  switch (operation) {
    case 1: autopilot.upload(source, Readback::Always); break;
    case 2: autopilot.download(toRam(sink)); break;
    case 3: autopilot.verify(source); break;
    case 4: autopilot.clear(PlanType::All); break;
    case 5: autopilot.start(); break;
    case 6: autopilot.setCurrentItem(2); break;
    case 7:
      command = flightCommand(183, 1, 1500);
      autopilot.send(command);
      break;
    case 8: autopilot.uploadPartial(source, 3, 4); break;
    case 9: autopilot.ensure(source); break;
  }
}

void onText(void*, uint8_t, const char*) {}
void onItem(void*, uint16_t) {}

void setup() {
  Serial1.begin(BAUD);
  mission.onText(onText);
  mission.onReached(onItem);
  mission.onCurrent(onItem);
  autopilot.allowWhileArmed(true);
}

void loop() {
  if (stallMs != 0) delay(stallMs);
  const uint8_t due = operationDue;
  if (due != 0) {
    operationDue = 0;
    begin(due);
  }
  const Status status = measured_update();
  if (isEnd(status)) {
    ended = static_cast<uint8_t>(status);
    ends = ends + 1;
  }
}
