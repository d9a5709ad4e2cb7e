#include "Comparison.h"
#include "FlashTable.h"

namespace mavmission {
namespace {

#define MAVMISSION_TEXT(name, text) const char kField##name[] PROGMEM = text;
MAVMISSION_FIELDS(MAVMISSION_TEXT)
#undef MAVMISSION_TEXT

const char* const kFieldTexts[] PROGMEM = {
#define MAVMISSION_POINTER(name, text) kField##name,
    MAVMISSION_FIELDS(MAVMISSION_POINTER)
#undef MAVMISSION_POINTER
};

}  // namespace

FlashText toString(Field field) { return textAt(kFieldTexts, static_cast<uint8_t>(field)); }

}  // namespace mavmission
