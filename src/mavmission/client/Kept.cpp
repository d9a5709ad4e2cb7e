// The value that an autopilot would store in the place of the refused one. A file of its own, since few sketches ask
// for it.
#include <Arduino.h>

#include "../MissionClient.h"

namespace mavmission {
using namespace detail;

float MissionClient::keptValue() {
  MissionItem item;
  Status read = Status::Checking;
  while (read == Status::Checking) read = plan_.read(state_.failedItem + homeBefore(), item);
  if (state_.status != Status::NotKept || read != Status::Accepted) return Yaw().inDegrees();  // NaN
  return mavmission::keptValue(item, rest_.field, plan_.keeper());
}

}  // namespace mavmission
