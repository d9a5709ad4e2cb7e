// A message of the mission protocol as the models and the referee see it, and the frame that it is on the wire.
#pragma once

#include <stdint.h>

#include <string>
#include <type_traits>

#include "Frames.h"

// Mavsdk, Betaflight and Inav say that they are generic: see Generic.cpp.
enum class Firmwares : uint8_t { ArduPilot, LateArduPilot, Px4, Mavsdk, Betaflight, Inav };
constexpr const char* kFirmwares[] = {"ArduPilot", "LateArduPilot", "PX4", "MAVSDK", "Betaflight", "iNav"};

inline bool isArduPilot(Firmwares firmware) { return firmware <= Firmwares::LateArduPilot; }
inline bool isGeneric(Firmwares firmware) { return firmware >= Firmwares::Mavsdk; }

// OlderRequest: MISSION_REQUEST, where the client asks so. File and FileReply: a request of MAVLink FTP and its answer,
// see FileWords.h.
enum class Kind : uint8_t { Heartbeat, Count, Request, OlderRequest, Item, Ack, List, ClearAll, File, FileReply };

// The client was told that the generic one is Betaflight.
#if defined(MAVMISSION_GENERIC_FIRMWARE) && MAVMISSION_GENERIC_FIRMWARE == 1
constexpr bool kIsBetaflightNamed = true;
#else
constexpr bool kIsBetaflightNamed = false;
#endif

// Of a plan on the wire, home included. (A program that follows longer plans is compiled with its own number.)
#ifdef MOST_HELD
constexpr uint16_t kMostHeld = MOST_HELD;
#else
constexpr uint16_t kMostHeld = 8;
#endif

// MAV_MISSION_TYPE.
enum Type : uint8_t { kMission = 0, kFence = 1, kRally = 2 };

// MAV_MISSION_RESULT, as far as it occurs.
enum Result : uint8_t {
  kAccepted = 0,
  kError = 1,
  kUnsupported = 3,
  kInvalidSequence = 13,
  kDenied = 14,
  kCancelled = 15
};

struct Message {
  Kind kind : 6;
  uint8_t type : 2;   // MAV_MISSION_TYPE
  uint8_t item;       // Item, FileReply: which one of Plans.h; File: the plan whose items are written
  uint16_t number;    // Count: how many; Request, Item, File, FileReply: sequence number; Ack: MAV_MISSION_RESULT
  uint32_t opaqueId;  // Count, Ack; File, FileReply: FileWords
};
static_assert(std::has_unique_object_representations<Message>::value, "folded by its bytes");

inline Message message(Kind kind, uint16_t number = 0, uint8_t item = 0, uint32_t opaqueId = 0) {
  return Message{kind, kMission, item, number, opaqueId};
}

// "COUNT 3", "ACK accepted", ...
std::string inWords(const Message& message);

// The frame of a message that this autopilot (system 1, component 1) sends to the client (1, 191).
FrameParts partsOf(const Message& message, Firmwares firmware);
const Bytes& frameOf(const Message& message, Firmwares firmware);

// The message in a frame of the client's. Null, or what is wrong with the frame: its checksum, length, sender or
// target, a field that must be 0, an item that is in no plan, a message that has no place in these operations.
const char* decode(const Bytes& frame, Firmwares firmware, Message& message);
