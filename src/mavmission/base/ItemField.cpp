#include "ItemField.h"
#include "FlashTable.h"

namespace mavmission {
using namespace detail;
namespace {

MAVMISSION_TEXT_TABLE(fields, MAVMISSION_FIELDS)

}  // namespace

FlashText toString(ItemField field) { return textAt(fields::kTexts, static_cast<uint8_t>(field)); }

}  // namespace mavmission
