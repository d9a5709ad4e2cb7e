// Takes a plan as text for a PlanConsole, and stores it in EEPROM.
#include "PlanConsole.h"

#include <Arduino.h>

namespace mavmission {
using namespace detail;

void PlanConsole::beginText() {
  if (!isAutopilotFree()) return ignoreText();
  text_.begin();
  plan_.store();
  mode_ = Mode::Text;
  isNotStored_ = true;
  isIgnored_ = false;
  kept_ = 0;
  told_ = 0;
  put_ = 0;
  say(F("send the file, then end"));
}

void PlanConsole::takeInText(char c) {
  switch (text_.take(c)) {
    case WaypointsText::Step::More: return;
    case WaypointsText::Step::Item: isItemHeld_ = true; return storeItems();
    case WaypointsText::Step::Bad: return refuse(text_.error());
  }
}

void PlanConsole::endText() {
  switch (text_.end()) {
    case WaypointsText::Step::Item:  // cannot happen: the line has ended
    case WaypointsText::Step::More: mode_ = Mode::Ending; return;
    case WaypointsText::Step::Bad:
      refuse(text_.error());
      mode_ = Mode::Commands;
      return;
  }
}

// The rest of the text is ignored, up to end or another command.
void PlanConsole::refuse(TextError error) {
  error_ = error;
  mode_ = Mode::Refused;
  isItemHeld_ = false;
  kept_ = 0;
  due(kError);
}

void PlanConsole::storeItems() {
  if (mode_ != Mode::Text && mode_ != Mode::Ending) return;
  // It has failed, or the sketch has begun to store another plan.
  if (plan_.state() != EepromPlan::State::Storing || plan_.stored() != put_) return refuse(TextError::NotKept);
  if (kept_ != 0 && plan_.isReady()) {
    if (!putItem(room_[oldest_])) return;
    --kept_;
    if (++oldest_ == roomItems_) oldest_ = 0;
  }
  if (!isItemHeld_) return;
  if (kept_ == 0 && plan_.isReady()) {
    isItemHeld_ = false;
    putItem(text_.item());
  } else if (kept_ < roomItems_) {
    isItemHeld_ = false;
    if (kept_ == 0) oldest_ = 0;
    const uint16_t place = static_cast<uint16_t>(oldest_) + kept_;
    room_[place < roomItems_ ? place : place - roomItems_] = text_.item();
    ++kept_;
  }
}

bool PlanConsole::putItem(const MissionItem& item) {
  if (plan_.put(item)) {
    ++put_;
    return true;
  }
  refuse(TextError::NoRoom);
  return false;
}

void PlanConsole::watchPlan() {
  if (mode_ == Mode::Text || mode_ == Mode::Ending) {
    if (plan_.isReady() && plan_.stored() > told_) due(kStored);
    if (mode_ != Mode::Ending || kept_ != 0 || isItemHeld_ || !plan_.isReady()) return;
    if (plan_.stored() > told_ || autopilot_.isBusy()) return;  // with an operation of the sketch
    mode_ = Mode::Commands;
    isDownload_ = false;
    isPlanAwaited_ = plan_.commit();
    return;
  }
  if (!isPlanAwaited_ || plan_.isBusy()) return;
  isPlanAwaited_ = false;
  if (plan_.state() == EepromPlan::State::Failed) {
    say(F("the EEPROM does not keep what is written"));
  } else if (plan_.hasPlan()) {
    isNotStored_ = false;
    isOtherAboard_ = !isDownload_;
    say(F("stored: list prints it"));
  } else {
    say(F("erased"));
  }
}

}  // namespace mavmission
