// A text console on the serial monitor (115200 baud, "both NL & CR") or any terminal: load a .waypoints file into
// EEPROM, which keeps it without power; upload, verify and fly it. Type "help". A Mega has enough flash for all
// commands; an Uno, a Nano or a Leonardo does not. REMOVE THE PROPELLERS WHILE YOU TRY IT: "start" arms the aircraft.
#define CONSOLE_RX 10  // an Uno and a Nano need it to read from CONSOLE
#include <MavMissionConsole.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

// A buffer for items that wait to be stored: if it is large enough, a whole file may be pasted.
#if defined(__AVR__) && FLASHEND < 0x10000
MissionItem room[8];
#else
MissionItem room[112];
#endif

MissionClient autopilot(TELEM);
#ifdef __AVR__
EepromPlan plan;  // in the board's own EEPROM
#elif defined(ARDUINO_ARCH_SAMD) || defined(ARDUINO_ARCH_MBED)
// These cores have no EEPROM library: the plan is kept until the power goes off. For an FRAM change the two functions.
uint8_t bytes[1024];
EepromPlan plan(Eeprom{[](uint16_t address) { return bytes[address]; },
                       [](uint16_t address, uint8_t value) { bytes[address] = value; }, nullptr, sizeof(bytes)});
#else
#include <EEPROM.h>
EepromPlan plan(MAVMISSION_EEPROM(EEPROM, 1024));  // in what the board's EEPROM library uses
#endif
PlanConsole commands(CONSOLE, autopilot, plan, room);

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
#if defined(ARDUINO_ARCH_ESP32) || defined(ARDUINO_ARCH_ESP8266) || defined(ARDUINO_ARCH_RP2040)
  EEPROM.begin(1024);
#endif
  plan.begin();
#if !defined(__AVR__) || FLASHEND >= 0x10000
  commands.offerAll();  // a smaller board has not enough flash for them
#endif
}

void loop() {
  autopilot.update();
  plan.update();
  commands.update();
}
