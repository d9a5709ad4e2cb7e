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

void hearOfKinds(Autopilot& one, Autopilot& other, const Message& message, Answers& answers) {
  const int before = answers.count;
  Autopilot* to = message.type == other.type ? &other : &one;
  if (one.firmware == Firmwares::Px4) {
    Autopilot& has = other.hasTransfer ? other : one;
    if (has.bootsInMs == kNever) hearAsPx4OfKinds(has, other.hasTransfer ? one : other, message, answers);
    to = other.hasTransfer ? &other : &one;
  } else {
    to->hear(message, answers);
  }
  for (int i = before; i < answers.count; ++i) answers.messages[i].type = to->type;
}

void Autopilot::act(Answers& answers) {
  const int before = answers.count;
  if (bootsInMs == 0) bootsInMs = kNever;
  if (isGeneric(firmware)) {
    actAsGeneric(*this, answers);
  } else if (firmware == Firmwares::Px4) {
    actAsPx4(*this, answers);
  } else {
    actAsArduPilot(*this, answers);
  }
  for (int i = before; i < answers.count; ++i) answers.messages[i].type = type;
}

void Autopilot::reboot() {
  state = State::Idle;
  expected = count = hasPartner = isUploadOpen = requests = 0;
  if (firmware == Firmwares::Px4) hasTransfer = type == kMission;
  memset(staged, 0, sizeof(staged));
  stagedSum = 0;
  asksInMs = givesUpInMs = acceptsInMs = kNever;
  bootsInMs = kBootMs;
}

void Autopilot::hold(uint8_t plan, uint16_t items) {
  uint8_t* to = held;
  hasTransfer = type == kMission;
  if (isArduPilot(firmware) && type == kMission && items != 0) *to++ = kHome;
  for (uint16_t i = 0; i < items; ++i) {
    *to++ = itemOf(plan, i);
    heldSum = checksummed(heldSum, itemOf(plan, i), type);
  }
  heldCount = static_cast<uint16_t>(to - held);
  if (firmware != Firmwares::Px4) heldSum = 0;
}
