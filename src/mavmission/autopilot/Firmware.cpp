#include "Firmware.h"

#include "../base/FlashTable.h"

namespace mavmission {
using namespace detail;
namespace {

MAVMISSION_TEXT_TABLE(firmwares, MAVMISSION_FIRMWARES)

}  // namespace

FlashText nameOf(Firmware firmware) { return textAt(firmwares::kTexts, static_cast<uint8_t>(firmware)); }

}  // namespace mavmission
