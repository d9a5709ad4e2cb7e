#include "Fitness.h"

#include "../base/FlashTable.h"

namespace mavmission {
using namespace detail;
namespace {

MAVMISSION_TEXT_TABLE(reasons, MAVMISSION_FIT_REASONS)

MAVMISSION_TEXT_TABLE(fitnesses, MAVMISSION_FITNESSES)

}  // namespace

FlashText toString(Fitness fitness) { return textAt(fitnesses::kTexts, static_cast<uint8_t>(fitness)); }

FlashText toString(FitReason reason) { return textAt(reasons::kTexts, static_cast<uint8_t>(reason)); }

}  // namespace mavmission
