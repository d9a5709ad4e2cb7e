// TELEM: the port of this board that goes to the autopilot. beginTelem(57600) opens it. So the same sketch works on a
// Mega, an Uno, a Nano Every, an Uno R4, a Pico, an ESP32, a Teensy. Include this after MavMission.h.
//
// To choose another port or other pins, write this before the #include:
//
//   #define TELEM Serial2     // another port
//   #define TELEM_RX 18       // on an ESP32 or an STM32: pins, which go to a serial port there
//   #define TELEM_TX 17
//
// docs/boards.md lists each board's port and pins.
#pragma once

#include <Arduino.h>

#if defined(TELEM_RX) != defined(TELEM_TX)
#error "One of TELEM_RX and TELEM_TX is missing: above the #include, #define both"
#elif defined(TELEM_RX) && !defined(ARDUINO_ARCH_ESP32) && !defined(ARDUINO_ARCH_STM32)
#error "TELEM_RX and TELEM_TX are for an ESP32 or an STM32: #define TELEM Serial2, or another port of this board"
#endif

#ifndef TELEM
#if defined(ARDUINO_ARCH_STM32)
// Serial is another name for one of the numbered ports here, or the USB; and Serial1 exists only if the board's menu or
// the sketch has enabled it.
#if defined(TELEM_RX)
static decltype(Serial1) mavMissionTelem(TELEM_RX, TELEM_TX);
#define TELEM mavMissionTelem
#else
#if !defined(HAVE_HWSERIAL1) || (!defined(HAVE_SERIALUSB) && SERIAL_UART_INSTANCE == 1)
#error "No Serial1 beside Serial: above the #include, #define TELEM_RX PA3 and TELEM_TX PA2 (docs/boards.md)"
#endif
#define TELEM Serial1
#endif
#elif defined(ARDUINO_ARCH_ESP8266) || (defined(__AVR__) && !defined(HAVE_HWSERIAL1) && !defined(ARDUINO_ARCH_MEGAAVR))
#define TELEM Serial  // an Uno, a Nano, an ESP8266: the only port
#define MAVMISSION_ONE_PORT
#else
#define TELEM Serial1  // all others: Serial stays free for the computer
#endif
#endif

// The pins of an ESP32's Serial1 can be chosen. Those that it has by itself differ between the chips and between the
// versions of the core, and are the flash's or the USB's on some.
#if defined(ARDUINO_ARCH_ESP32) && !defined(TELEM_RX)
#if defined(CONFIG_IDF_TARGET_ESP32)
#define TELEM_RX 16
#define TELEM_TX 17
#elif defined(CONFIG_IDF_TARGET_ESP32S3)
#define TELEM_RX 15
#define TELEM_TX 16
#elif defined(CONFIG_IDF_TARGET_ESP32S2) || defined(CONFIG_IDF_TARGET_ESP32C3) || defined(CONFIG_IDF_TARGET_ESP32C6)
#define TELEM_RX 4
#define TELEM_TX 5
#elif defined(CONFIG_IDF_TARGET_ESP32H2)
#define TELEM_RX 0
#define TELEM_TX 1
#else
#error "No pins known for this ESP32: above the #include, #define TELEM_RX 4 and TELEM_TX 5, or other free pins"
#define TELEM_RX -1
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
