// The frames by which an autopilot gives a plan, and answers commands.
#pragma once

#include <MavMission.h>

#include "Frames.h"

FrameParts countParts(uint16_t items, mavmission::PlanType type = mavmission::PlanType::Mission, uint32_t opaqueId = 0,
                      uint8_t targetSystem = 1);

// An item as MISSION_ITEM_INT has it.
FrameParts itemParts(uint16_t seq, const mavmission::MissionItem& item,
                     mavmission::PlanType type = mavmission::PlanType::Mission, uint8_t targetSystem = 1);

// The same as MISSION_ITEM, whose x and y are floats.
FrameParts floatItemParts(uint16_t seq, const mavmission::MissionItem& item, float x, float y);

// ArduPilot's home.
mavmission::MissionItem homeItem();

FrameParts commandAckParts(uint16_t command, uint8_t result, uint8_t targetSystem = 1);
// MISSION_CURRENT, by default of a mission that is flown.
FrameParts currentParts(uint16_t item, uint16_t total, uint8_t state = 3, uint32_t planId = 0);
