#include "ItemSink.h"

namespace mavmission {

bool writeItemToRam(void* array, uint16_t index, const MissionItem& item) {
  if (index != kHomeIndex) static_cast<MissionItem*>(array)[index] = item;
  return true;
}

}  // namespace mavmission
