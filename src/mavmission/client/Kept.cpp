// The value that an autopilot would store in the place of the refused one. A file of its own, since few sketches ask
// for it.
#include <Arduino.h>

#include "MissionClient.h"

namespace mavmission {
using namespace detail;

float MissionClient::keptValue() {
  MissionItem item;
  // Parameters::set() ends so too, without an item.
  const bool isItem = state_.status == Status::NotKept && state_.failedItem != kNoItem;
  Status read = isItem ? Status::Checking : Status::NotKept;
  while (read == Status::Checking) read = plan_.read(plan_.numbers().toWire(state_.failedItem), item);
  if (read != Status::Accepted) return Yaw().inDegrees();  // NaN
  return mavmission::keptValue(item, session_.field, plan_.keeper());
}

}  // namespace mavmission
