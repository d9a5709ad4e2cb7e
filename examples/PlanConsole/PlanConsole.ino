// A text console on the serial monitor (115200 baud, "both NL & CR") or any terminal: load a .waypoints file into
// EEPROM, where it stays without power; put it aboard, verify it, fly it. Type "help".
// It needs a Mega for all of its commands; an Uno has room for those that are always there, a Nano or a Leonardo for
// none.
// TAKE OFF THE PROPELLERS WHILE YOU TRY IT: "start" arms.
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

// Items that wait to be stored: with enough of them a whole file may be pasted.
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
