// A PlanConsole that is typed at at random, while operations run, on links that lose, double and delay frames.
#pragma once

#include "Exploration.h"

// Many sessions at one console each, from seed `seed` on. What must hold is in Typed.cpp, class Terminal.
Findings type(Firmwares firmware, uint32_t seed, unsigned sessions);
