// CONSOLE: where a sketch prints. That is the serial monitor. On a board whose only port goes to the autopilot, it is a
// USB-serial adapter, whose RX is wired to pin 11, on an ESP8266 to GPIO2 (D4). This header includes MavMissionTelem.h,
// so TELEM is there too.
//
// To choose another port or other pins, write this before the #include:
//
//   #define CONSOLE Serial2  // another port
//   #define CONSOLE_TX 9     // an Uno's pin for the adapter
//   #define CONSOLE_RX 8     // and the one that its TX is wired to, for a sketch that also reads from CONSOLE
#pragma once

#include "MavMissionTelem.h"

#ifndef CONSOLE
#if defined(MAVMISSION_ONE_PORT) && defined(ARDUINO_ARCH_ESP8266)
#define CONSOLE Serial1  // it only sends; the usual pins of a SoftwareSerial, 10 and 11, go to the flash
#elif defined(MAVMISSION_ONE_PORT)
#ifndef CONSOLE_TX
#define CONSOLE_TX 11
#endif
#ifdef CONSOLE_RX
#include <SoftwareSerial.h>
static SoftwareSerial mavMissionConsole(CONSOLE_RX, CONSOLE_TX);
#else
#include "mavmission/console/PinPrint.h"
static mavmission::PinPrint mavMissionConsole(CONSOLE_TX);
#endif
#define CONSOLE mavMissionConsole
#else
#define CONSOLE Serial
#endif
#endif

// Where the compiler knows both addresses.
#define MAVMISSION_ONE_FOR_BOTH (static_cast<const void*>(&(TELEM)) == static_cast<const void*>(&(CONSOLE)))
static_assert(!(__builtin_constant_p(MAVMISSION_ONE_FOR_BOTH) && MAVMISSION_ONE_FOR_BOTH),
              "TELEM and CONSOLE are the same port, so the sketch's words would go to the autopilot: "
              "write #define TELEM or #define CONSOLE with another port above the #include");
#undef MAVMISSION_ONE_FOR_BOTH
