#include "Status.h"
#include "FlashTable.h"

namespace mavmission {
using namespace detail;
namespace {

MAVMISSION_TEXT_TABLE(statuses, MAVMISSION_STATUSES)

MAVMISSION_TEXT_TABLE(aboards, MAVMISSION_ABOARD)

}  // namespace

FlashText toString(Status status) { return textAt(statuses::kTexts, static_cast<uint8_t>(status)); }

FlashText toString(Aboard aboard) { return textAt(aboards::kTexts, static_cast<uint8_t>(aboard)); }

}  // namespace mavmission
