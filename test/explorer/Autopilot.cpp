#include "Autopilot.h"

#include <string.h>

#include <algorithm>

#include "Plans.h"

namespace {
void passOf(uint16_t& left, uint16_t ms) {
  if (left != kNever) left = left > ms ? static_cast<uint16_t>(left - ms) : 0;
}
}  // namespace

uint16_t Autopilot::nextMs() const { return std::min({asksInMs, givesUpInMs, acceptsInMs, bootsInMs}); }

void Autopilot::pass(uint16_t ms) {
  passOf(asksInMs, ms);
  passOf(givesUpInMs, ms);
  passOf(acceptsInMs, ms);
  passOf(bootsInMs, ms);
}

void Autopilot::hear(const Message& message, Answers& answers) {
  if (bootsInMs != kNever) return;
  if (isGeneric(firmware)) return hearAsGeneric(*this, message, answers);
  if (firmware == Firmwares::Px4) return hearAsPx4(*this, message, answers);
  hearAsArduPilot(*this, message, answers);
}

void Autopilot::act(Answers& answers) {
  if (bootsInMs == 0) bootsInMs = kNever;
  if (isGeneric(firmware)) return actAsGeneric(*this, answers);
  if (firmware == Firmwares::Px4) return actAsPx4(*this, answers);
  actAsArduPilot(*this, answers);
}

void Autopilot::reboot() {
  state = State::Idle;
  expected = count = hasPartner = isUploadOpen = requests = 0;
  memset(staged, 0, sizeof(staged));
  stagedSum = 0;
  asksInMs = givesUpInMs = acceptsInMs = kNever;
  bootsInMs = kBootMs;
}

void Autopilot::hold(uint8_t plan, uint16_t items) {
  uint8_t* to = held;
  if (isArduPilot(firmware) && items != 0) *to++ = kHome;
  for (uint16_t i = 0; i < items; ++i) {
    *to++ = itemOf(plan, i);
    heldSum = checksummed(heldSum, itemOf(plan, i));
  }
  heldCount = static_cast<uint16_t>(to - held);
  if (firmware != Firmwares::Px4) heldSum = 0;
}
