// Beside the mission: asks the autopilot for its position twice a second, and decodes it. Any message of any dialect
// can be received in this way, and decoded by hand, as here, or with the headers of another MAVLink library.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

// GLOBAL_POSITION_INT: its id, CRC_EXTRA and length are in the MAVLink common messages.
constexpr uint16_t kGlobalPositionInt = 33;
const MessageKey keys[] PROGMEM = {messageKey(kGlobalPositionInt, 104, 28)};

// Its payload in wire order.
struct __attribute__((packed)) GlobalPositionInt {
  uint32_t timeBootMs;
  int32_t latE7, lonE7;
  int32_t altMm, relativeAltMm;
  int16_t vxCmS, vyCmS, vzCmS;
  uint16_t headingCdeg;
};

void onPosition(void*, const ReceivedMessage& message) {
  GlobalPositionInt position;
  message.copyTo(&position, sizeof(position));
  CONSOLE.print(position.latE7);
  CONSOLE.print(' ');
  CONSOLE.print(position.lonE7);
  CONSOLE.print(F(" (1e-7 deg), "));
  CONSOLE.print(position.relativeAltMm / 1000);
  CONSOLE.println(F(" m above home"));
}

MissionClient autopilot(TELEM);
MessageListener listener(autopilot, keys, onPosition);

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  autopilot.setMessageInterval(kGlobalPositionInt, 500000);
}

void loop() {
  const Status status = autopilot.update();
  if (isEnd(status)) CONSOLE.println(toString(status));
}
