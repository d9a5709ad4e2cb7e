// The items that plans are made of here. An item is a number; what it is on the wire follows from it, so that the
// models keep bytes and the truth is compared byte by byte all the same.
#pragma once

#include <stdint.h>

#include "Message.h"
#include "mavmission/item/MissionItem.h"

// Items of plan `plan` (0: aboard from before; 1 to 3: uploaded) are 16 * plan + 1, + 2, ... Home is ArduPilot's item
// 0.
constexpr uint8_t kHome = 0x0F;
constexpr uint8_t kNoItemAtAll = 0;
constexpr uint16_t kMostItems = kMostHeld - 1;
// In a longer plan every 14th item is the same: a plan that is shifted by a few items differs all the same.
constexpr uint8_t itemOf(uint8_t plan, uint16_t index) { return static_cast<uint8_t>(16 * plan + 1 + index % 14); }

// The plan on the wire, where ArduPilot's missions begin with home: how many items it has there, and each of them.
inline bool hasHome(Firmwares firmware, uint8_t type) { return isArduPilot(firmware) && type == kMission; }
inline uint16_t wireCount(uint16_t items, Firmwares firmware, uint8_t type) {
  return static_cast<uint16_t>(items + (items != 0 && hasHome(firmware, type)));
}
inline uint8_t wireItem(uint8_t plan, uint16_t number, Firmwares firmware, uint8_t type) {
  if (!hasHome(firmware, type)) return itemOf(plan, number);
  return number == 0 ? kHome : itemOf(plan, static_cast<uint16_t>(number - 1));
}

// The items as a sketch writes them, by MAV_MISSION_TYPE.
const mavmission::MissionItem* sketchPlan(uint8_t plan, uint8_t type);

// MISSION_ITEM_INT's payload for an item: as it must arrive, and as this autopilot gives it when it is read back.
Bytes payloadOf(uint8_t item, uint16_t sequence, uint8_t type, Firmwares firmware, bool isReadBack);

// The item that a payload of the client's holds to the last bit, or kNoItemAtAll. Its mission_type is part of it.
uint8_t itemIn(const Bytes& payload, Firmwares firmware);

// The item of a MissionItem that a download has given to the sketch, or kNoItemAtAll.
uint8_t itemDownloaded(const mavmission::MissionItem& item, bool isHome, uint8_t type);

// PX4's checksum over a plan, continued by an item (the fields as they arrived).
uint32_t checksummed(uint32_t sum, uint8_t item, uint8_t type);
