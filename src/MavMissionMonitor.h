// Where a sketch's words go: CONSOLE, the serial monitor. Where the board's only port is the autopilot's, it is a
// USB-serial adapter, whose RX is on pin 11. It brings TELEM (MavMissionTelem.h).
//
// A sketch that knows better says so before it includes this:
//
//   #define CONSOLE Serial2                       // another port
//   #define CONSOLE_RX 8                          // an Uno's pins for the adapter
//   #define CONSOLE_TX 9
#pragma once

#include "MavMissionTelem.h"

#ifndef CONSOLE
#if defined(MAVMISSION_ONE_PORT)
#include <SoftwareSerial.h>
#ifndef CONSOLE_RX
#define CONSOLE_RX 10
#define CONSOLE_TX 11
#endif
static SoftwareSerial mavMissionConsole(CONSOLE_RX, CONSOLE_TX);
#define CONSOLE mavMissionConsole
#else
#define CONSOLE Serial
#endif
#endif
