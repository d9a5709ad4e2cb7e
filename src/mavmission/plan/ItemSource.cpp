#include "ItemSource.h"

#include "../base/Flash.h"

namespace mavmission {
using namespace detail;

bool readItemFromFlash(void* array, uint16_t index, MissionItem& item) {
  memcpy_P(&item, static_cast<const MissionItem*>(array) + index, sizeof(item));
  return true;
}

bool readItemFromRam(void* array, uint16_t index, MissionItem& item) {
  item = static_cast<const MissionItem*>(array)[index];
  return true;
}

}  // namespace mavmission
