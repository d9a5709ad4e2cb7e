#include "ItemSource.h"

#include "Flash.h"

namespace mavmission {
namespace source {

bool readFromFlash(void* array, uint16_t index, MissionItem& item) {
  memcpy_P(&item, static_cast<const MissionItem*>(array) + index, sizeof(item));
  return true;
}

bool readFromRam(void* array, uint16_t index, MissionItem& item) {
  item = static_cast<const MissionItem*>(array)[index];
  return true;
}

}  // namespace source
}  // namespace mavmission
