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

void Autopilot::begin(Firmwares which, uint8_t kind) {
  memset(static_cast<void*>(this), 0, sizeof(*this));
  firmware = which;
  type = kind;
  asksInMs = givesUpInMs = acceptsInMs = bootsInMs = kNever;
}

void Autopilot::pass(uint16_t ms) {
  for (uint16_t* left : {&asksInMs, &givesUpInMs, &acceptsInMs, &bootsInMs}) passOf(*left, ms);
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

uint16_t Autopilot::asksAgainMs() const {
  constexpr uint16_t kByFirmware[] = {1000, 1000, 265, 500, 1500, 1000};
  return kByFirmware[static_cast<int>(firmware)];
}

void Autopilot::ask(Answers& answers) {
  asksInMs = asksAgainMs();
  answers.add(message(Kind::Request, expected));
}

void Autopilot::goIdle() {
  state = State::Idle;
  asksInMs = givesUpInMs = kNever;
}

void Autopilot::forget() {
  goIdle();
  expected = count = requests = 0;
  memset(staged, 0, sizeof(staged));
}

void Autopilot::reboot() {
  forget();
  hasPartner = isUploadOpen = 0;
  if (firmware == Firmwares::Px4) hasTransfer = type == kMission;
  stagedSum = 0;
  acceptsInMs = kNever;
  bootsInMs = kBootMs;
}

void Autopilot::keep(uint16_t items, uint32_t sum) {
  memset(held, 0, sizeof(held));
  memcpy(held, staged, items);
  heldCount = items;
  heldSum = sum;
}

void Autopilot::hold(uint8_t plan, uint16_t items) {
  hasTransfer = type == kMission;
  heldCount = wireCount(items, firmware, type);
  for (uint16_t i = 0; i < heldCount; ++i) {
    held[i] = wireItem(plan, i, firmware, type);
    if (firmware == Firmwares::Px4) heldSum = checksummed(heldSum, held[i], type);
  }
}

bool Autopilot::holds(uint8_t plan, uint16_t items) const {
  if (items == 0 && heldCount == 1 && hasHome(firmware, type)) return true;
  if (heldCount != wireCount(items, firmware, type)) return false;
  for (uint16_t i = 0; i < heldCount; ++i) {
    if (held[i] != wireItem(plan, i, firmware, type)) return false;
  }
  return true;
}

bool Autopilot::holdsAs(const Autopilot& other) const {
  return heldCount == other.heldCount && memcmp(held, other.held, sizeof(held)) == 0;
}
