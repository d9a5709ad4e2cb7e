// A text console on the serial monitor (115200 baud, "both NL & CR") or any terminal: load a .waypoints file into
// EEPROM, which keeps it without power; upload, verify and fly it. Type "help". A Mega has room for all commands, an
// Uno for those that are always offered; a Nano or a Leonardo is too small. TAKE OFF THE PROPELLERS WHILE YOU TRY IT:
// "start" arms.
#include <MavMissionConsole.h>
using namespace mavmission;

#ifdef HAVE_HWSERIAL1
#define TELEM Serial1
#define CONSOLE Serial
#else
// An Uno and a Nano have one port, for the autopilot; the console is a USB-serial adapter on pins 10 and 11.
#include <SoftwareSerial.h>
SoftwareSerial console(10, 11);
#define TELEM Serial
#define CONSOLE console
#endif

// A buffer for items that wait to be stored: if it is large enough, a whole file may be pasted.
#ifdef __AVR_ATmega2560__
MissionItem room[112];
#else
MissionItem room[8];
#endif

MissionClient autopilot(TELEM);
EepromPlan plan;
PlanConsole commands(CONSOLE, autopilot, plan, room);

void setup() {
  CONSOLE.begin(115200);
  TELEM.begin(57600);
  plan.begin();
#if FLASHEND >= 0x10000
  commands.offerAll();  // a smaller board has no room for them
#endif
}

void loop() {
  autopilot.update();
  plan.update();
  commands.update();
}
