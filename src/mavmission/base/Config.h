// Settings that take effect when the library is compiled. Each macro may be given on the compiler's command line
// (PlatformIO: build_flags = -DMAVMISSION_MAX_PAYLOAD=38); the Arduino IDE uses the defaults below. A test compiles
// every non-default value that is named here.
#pragma once

// The longest payload of a received message that is kept and decoded [bytes], 38 to 255. Longer frames are ignored, and
// the frames after them are still received. 54 is enough for every message of the mission protocol and STATUSTEXT.
// Costs one byte of RAM for each byte.
#ifndef MAVMISSION_MAX_PAYLOAD
#define MAVMISSION_MAX_PAYLOAD 54
#endif

// How many received bytes one update() reads at most [bytes], 16 to 255. It limits the time that an update() takes. A
// Mega's receive buffer holds 63: no more can be waiting there, however late the loop is. Costs nothing.
#ifndef MAVMISSION_BYTES_PER_UPDATE
#define MAVMISSION_BYTES_PER_UPDATE 64
#endif

// How many items of a plan one update() checks before the transfer, at most [items], 1 to 255. Costs only the
// time to read an item from its source.
#ifndef MAVMISSION_ITEMS_PER_UPDATE
#define MAVMISSION_ITEMS_PER_UPDATE 1
#endif

// 1: MissionClient::signWith() exists, which signs what is sent and refuses what is not signed (MAVLink guide, Message
// Signing); 0 to 1 [switch]. Costs nothing at 0; docs/measurements.md says what 1 costs.
#ifndef MAVMISSION_SIGNING
#define MAVMISSION_SIGNING 0
#endif

// Which autopilot it is, if its heartbeat says "generic" (HEARTBEAT.autopilot 0). Several autopilots say so, and
// nothing that they send distinguishes them: 1 is Betaflight, 2 is iNav, 0 is none of these; 0 to 2 [number]. They take
// different commands, and store them differently (docs/autopilots.md). Costs nothing at 0;
// docs/measurements.md says what 1 and 2 cost.
#ifndef MAVMISSION_GENERIC_FIRMWARE
#define MAVMISSION_GENERIC_FIRMWARE 0
#endif

// 1: the library is for ArduPilot only. The code for other autopilots is left out, and an operation with one of them
// ends with Status::OtherAutopilot before anything is sent; 0 to 1 [switch]. Costs nothing: 1 saves flash.
#ifndef MAVMISSION_ONLY_ARDUPILOT
#define MAVMISSION_ONLY_ARDUPILOT 0
#endif

// 1: the same for PX4 only; 0 to 1 [switch]. Costs nothing: 1 saves flash.
#ifndef MAVMISSION_ONLY_PX4
#define MAVMISSION_ONLY_PX4 0
#endif

// Keeps a function from being inlined, where avr-gcc would inline it and the program would grow. Each use was measured.
#ifdef __AVR__
#define MAVMISSION_APART __attribute__((noinline))
#else
#define MAVMISSION_APART
#endif

// Inlines a function where avr-gcc would call it and time is what counts. Each use was measured.
#ifdef __AVR__
#define MAVMISSION_INLINE inline __attribute__((always_inline))
#else
#define MAVMISSION_INLINE inline
#endif

// Lets a function return in one place only. avr-gcc would turn its final calls into jumps, and repeat all pops before
// each of them.
#ifdef __AVR__
#define MAVMISSION_ONE_EXIT __attribute__((optimize("no-optimize-sibling-calls")))
#else
#define MAVMISSION_ONE_EXIT
#endif

#if MAVMISSION_MAX_PAYLOAD < 38 || MAVMISSION_MAX_PAYLOAD > 255
#error "MAVMISSION_MAX_PAYLOAD must be 38 to 255: MISSION_ITEM_INT has 38 bytes, no MAVLink payload has more than 255"
#endif
#if MAVMISSION_SIGNING < 0 || MAVMISSION_SIGNING > 1
#error "MAVMISSION_SIGNING must be 0 to 1"
#endif
#if MAVMISSION_GENERIC_FIRMWARE < 0 || MAVMISSION_GENERIC_FIRMWARE > 2
#error "MAVMISSION_GENERIC_FIRMWARE must be 0 to 2"
#endif
#if MAVMISSION_ONLY_ARDUPILOT < 0 || MAVMISSION_ONLY_ARDUPILOT > 1
#error "MAVMISSION_ONLY_ARDUPILOT must be 0 to 1"
#endif
#if MAVMISSION_ONLY_PX4 < 0 || MAVMISSION_ONLY_PX4 > 1
#error "MAVMISSION_ONLY_PX4 must be 0 to 1"
#endif
#if MAVMISSION_ONLY_ARDUPILOT + MAVMISSION_ONLY_PX4 + (MAVMISSION_GENERIC_FIRMWARE != 0) > 1
#error "MAVMISSION_ONLY_ARDUPILOT, MAVMISSION_ONLY_PX4 and MAVMISSION_GENERIC_FIRMWARE exclude one another"
#endif
#if MAVMISSION_BYTES_PER_UPDATE < 16 || MAVMISSION_BYTES_PER_UPDATE > 255
#error "MAVMISSION_BYTES_PER_UPDATE must be 16 to 255"
#endif
#if MAVMISSION_ITEMS_PER_UPDATE < 1 || MAVMISSION_ITEMS_PER_UPDATE > 255
#error "MAVMISSION_ITEMS_PER_UPDATE must be 1 to 255"
#endif
