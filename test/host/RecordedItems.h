// The items that real autopilots were given at random, what each said, and what it gave back:
// test/recordings/readback_random_*.csv.
#pragma once

#include <vector>

#include "mavmission/autopilot/Commands.h"
#include "mavmission/item/MissionItem.h"
#include "mavmission/item/PlanType.h"
#include "mavmission/plan/Comparison.h"

struct RecordedItem {
  const char* vehicle;  // "arducopter", "ardurover", "arduplane" or "px4"
  unsigned line;        // of its file
  uint16_t command;     // as it was recorded; `sent` has the one that the library sends
  mavmission::detail::Keeper keeper;
  mavmission::PlanType type;
  mavmission::MissionItem sent;
  mavmission::MissionItem read;  // what it gave back, if `isRead`
  bool isRead;                   // it was accepted, and could be read

  bool isPx4() const { return (keeper & mavmission::detail::kByPx4) != 0; }
  bool isPlane() const { return (keeper & mavmission::detail::kByPlane) != 0; }
};

// All of them that the library would send like that. MAVMISSION_RECORDINGS says in which folder they are; test_host.py
// sets it.
const std::vector<RecordedItem>& recordedItems();

// param1 to param4, x, y and z, four bytes each.
constexpr unsigned kFourBytes = 7;
uint32_t bitsOf(const mavmission::MissionItem& item, unsigned index);
void setBits(mavmission::MissionItem& item, unsigned index, uint32_t bits);
// As a number: x and y are integers.
double numberOf(const mavmission::MissionItem& item, unsigned index);
bool isInteger(unsigned index);
mavmission::ItemField fieldOf(unsigned index);

// True if the vehicle gave this field back as 0 for every item of that kind, whatever was sent.
bool isDropped(const RecordedItem& row, unsigned index);
// True if what was read of the field means what was sent, by what docs/readback.md says: it is the same, dropped, or
// one of the few rewritings that change nothing. It knows nothing of the library's table.
bool meansTheSame(const RecordedItem& row, unsigned index);
