// PlanConsole: a text console for a plan on the serial monitor. It is not part of MavMission.h, since few sketches use
// it.
#pragma once

#include "MavMission.h"
#include "mavmission/console/PlanConsole.h"
