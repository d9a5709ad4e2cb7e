// PlanConsole: a text console for a plan on the serial monitor. Apart from MavMission.h, since few sketches have one.
#pragma once

#include "MavMission.h"
#include "mavmission/PlanConsole.h"
