// PlanConsole: a text console for a plan on the serial monitor. Not part of MavMission.h, since few sketches have one.
#pragma once

#include "MavMission.h"
#include "mavmission/PlanConsole.h"
