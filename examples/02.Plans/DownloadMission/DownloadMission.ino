// Reads the autopilot's plan and prints it on the serial monitor (115200 baud), item by item as it arrives: a plan of
// any length, without a buffer for it.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

MissionClient autopilot(TELEM);

// Prints a coordinate with all its digits: a float would lose some.
void printDegrees(int32_t e7) {
  if (e7 < 0) CONSOLE.print('-');
  const uint32_t magnitude = e7 < 0 ? 0 - static_cast<uint32_t>(e7) : static_cast<uint32_t>(e7);
  CONSOLE.print(magnitude / 10000000);
  CONSOLE.print('.');
  uint32_t decimals = magnitude % 10000000;
  for (uint32_t place = 1000000; place != 0; place /= 10) {
    CONSOLE.print(static_cast<char>('0' + decimals / place));
    decimals %= place;
  }
}

bool printItem(void*, uint16_t index, const MissionItem& item) {
  if (!CONSOLE) return true;
  if (index == kHomeIndex) {
    CONSOLE.print(F("home"));
  } else {
    CONSOLE.print(index);
  }
  CONSOLE.print(F(": command "));
  CONSOLE.print(item.command);
  if (item.frame == CoordinateFrame::Mission) {
    CONSOLE.print(F(", param1 "));
    CONSOLE.print(item.param1);
    CONSOLE.print(F(", param2 "));
    CONSOLE.println(item.param2);
    return true;
  }
  CONSOLE.print(F(" at "));
  printDegrees(item.x);
  CONSOLE.print(' ');
  printDegrees(item.y);
  CONSOLE.print(' ');
  CONSOLE.print(item.z);
  CONSOLE.println(item.frame == CoordinateFrame::GlobalRelative ? F(" m above home")
                  : item.frame == CoordinateFrame::Global       ? F(" m above sea level")
                                                                : F(" m above the ground"));
  return true;
}

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  autopilot.download(toFunction(printItem));
}

void loop() {
  const Status status = autopilot.update();
  if (isEnd(status) && CONSOLE) CONSOLE.println(toString(status));
}
