// TELEM: the port of this board that goes to the autopilot. beginTelem(57600) opens it. So the same sketch works on a
// Mega, an Uno, a Nano Every, an Uno R4, a Pico, an ESP32, a Teensy. Include this after MavMission.h.
//
// To choose another port or other pins, write this before the #include:
//
//   #define TELEM Serial2     // another port
//   #define TELEM_RX 18       // an ESP32's pins, any that are free
//   #define TELEM_TX 17
#pragma once

#include <Arduino.h>

#ifndef TELEM
#if defined(ARDUINO_ARCH_ESP8266) || (defined(__AVR__) && !defined(HAVE_HWSERIAL1) && !defined(ARDUINO_ARCH_MEGAAVR))
#define TELEM Serial  // an Uno, a Nano, an ESP8266: the only port
#define MAVMISSION_ONE_PORT
#else
#define TELEM Serial1  // all others: Serial stays free for the computer
#endif
#endif

#if defined(ARDUINO_ARCH_ESP32) && !defined(TELEM_RX)
#ifdef CONFIG_IDF_TARGET_ESP32
#define TELEM_RX 16  // GPIO16 and GPIO17; those that Serial1 has by itself are the flash's on many boards
#define TELEM_TX 17
#else
#define TELEM_RX -1  // the core's own for Serial1
#define TELEM_TX -1
#endif
#endif

// Opens TELEM at the rate that the autopilot's port is set to. A later call sets another rate.
inline void beginTelem(uint32_t baud) {
#if defined(ARDUINO_ARCH_ESP32)
  TELEM.begin(baud, SERIAL_8N1, TELEM_RX, TELEM_TX);
#else
#if defined(ARDUINO_ARCH_RP2040) && !defined(ARDUINO_ARCH_MBED)
  TELEM.end();
  TELEM.setFIFOSize(256);  // the default is 31 bytes, which at 57600 baud are full after 5 ms
#endif
  TELEM.begin(baud);
#endif
}
