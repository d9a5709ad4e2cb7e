// What an autopilot would make of the value that was refused; apart because few sketches ask.
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
