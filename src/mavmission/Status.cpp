#include "Status.h"

#include "FlashTable.h"

namespace mavmission {
namespace {

#define MAVMISSION_TEXT(name, text) const char kStatus##name[] PROGMEM = text;
MAVMISSION_STATUSES(MAVMISSION_TEXT)
#undef MAVMISSION_TEXT

const char* const kStatusTexts[] PROGMEM = {
#define MAVMISSION_POINTER(name, text) kStatus##name,
    MAVMISSION_STATUSES(MAVMISSION_POINTER)
#undef MAVMISSION_POINTER
};

#define MAVMISSION_TEXT(name, text) const char kAboard##name[] PROGMEM = text;
MAVMISSION_ABOARD(MAVMISSION_TEXT)
#undef MAVMISSION_TEXT

const char* const kAboardTexts[] PROGMEM = {
#define MAVMISSION_POINTER(name, text) kAboard##name,
    MAVMISSION_ABOARD(MAVMISSION_POINTER)
#undef MAVMISSION_POINTER
};

}  // namespace

FlashText toString(Status status) { return textAt(kStatusTexts, static_cast<uint8_t>(status)); }

FlashText toString(Aboard aboard) { return textAt(kAboardTexts, static_cast<uint8_t>(aboard)); }

}  // namespace mavmission
