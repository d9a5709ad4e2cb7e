// Changes a setting of the autopilot: it reads parameters, one after the other, and sets one, ArduPilot's MIS_RESTART,
// so that AUTO always begins with the first item. The names are ArduPilot's: PX4 has others, such as SER_TEL1_BAUD.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

MissionClient autopilot(TELEM);
Parameters parameters(autopilot);
uint8_t next = 0;

FlashText name() {
  switch (next) {
    case 0: return F("SERIAL1_BAUD");  // 57 is 57600
    case 1: return F("FENCE_ENABLE");
    default: return F("MIS_RESTART");
  }
}

void begin() {
  if (next < 2) {
    parameters.read(name());
  } else {
    parameters.setWhole(name(), 1);  // refused while it is armed
  }
}

void report(Status ended) {
  if (!CONSOLE) return;
  CONSOLE.print(name());
  CONSOLE.print(F(": "));
  if (ended == Status::Done || ended == Status::OtherValue) {
    CONSOLE.print(parameters.value());
    CONSOLE.print(' ');
  }
  CONSOLE.println(toString(ended));
}

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  begin();
}

void loop() {
  const Status status = autopilot.update();
  if (!isEnd(status)) return;
  report(status);
  if (++next < 3) begin();
}
