// One way at random through each of many scenarios, which are drawn as well: what needs more mishaps than the
// exploration of every way can follow.
#pragma once

#include "Exploration.h"

// Three operations one behind the other, on a line that loses and doubles many frames, beside reboots and cancels; from
// seed `seed` on.
Findings walk(Firmwares firmware, uint32_t seed, unsigned count);
