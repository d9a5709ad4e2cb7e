#include "TextError.h"
#include "FlashTable.h"

namespace mavmission {
using namespace detail;
namespace {

MAVMISSION_TEXT_TABLE(errors, MAVMISSION_TEXT_ERRORS)

}  // namespace

FlashText toString(TextError error) { return textAt(errors::kTexts, static_cast<uint8_t>(error)); }

}  // namespace mavmission
