// Prints the status of each MAV_MISSION_RESULT from 14 to 17, in words. test/proof/test_changes.py compiles it with a
// library that knows one result more.
#include <stdio.h>

#include "mavmission/base/Status.h"

int main() {
  for (unsigned result = 14; result <= 17; ++result) {
    printf("%s\n", mavmission::toString(mavmission::fromMissionResult(static_cast<uint8_t>(result))));
  }
  return 0;
}
