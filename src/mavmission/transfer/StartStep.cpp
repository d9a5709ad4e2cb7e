#include "../base/FlashTable.h"
#include "Operations.h"

namespace mavmission {
using namespace detail;
namespace {

MAVMISSION_TEXT_TABLE(steps, MAVMISSION_START_STEPS)

}  // namespace

FlashText toString(StartStep step) { return textAt(steps::kTexts, static_cast<uint8_t>(step)); }

}  // namespace mavmission
