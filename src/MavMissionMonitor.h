// CONSOLE: where a sketch prints. That is the serial monitor. On a board whose only port goes to the autopilot, it is a
// USB-serial adapter, whose RX is wired to pin 11. This header includes MavMissionTelem.h, so TELEM is there too.
//
// To choose another port or other pins, write this before the #include:
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
