// The output of a PlanConsole, piece by piece.
#include "PlanConsole.h"

#include <Arduino.h>

namespace mavmission {
using namespace detail;

const char PlanConsoleState::kLineEnd[] PROGMEM = "\r\n";

void PlanConsole::say(FlashText text) {
  said_ = text;
  due(kSay);
}

void PlanConsole::print() {
  if (flash_ == nullptr && ram_ == nullptr) compose();
  if (flash_ == nullptr && ram_ == nullptr) return;
  int room = portRoom_.of(port_, static_cast<uint16_t>(millis()), 1);
  for (uint8_t left = kBytesPerUpdate; left != 0 && (room > 0 || StreamRoom::saysOne(port_)); --left, --room) {
    if (flash_ != nullptr) {
      const uint8_t byte = pgm_read_byte(flash_);
      if (byte != 0) {
        port_.write(byte);
        ++flash_;
        continue;
      }
      flash_ = nullptr;
    }
    if (ram_ == nullptr) return;
    if (*ram_ == '\0') {
      ram_ = nullptr;
      return;
    }
    port_.write(static_cast<uint8_t>(*ram_++));
  }
}

void PlanConsole::putNumber(uint32_t number) {
  printWhole(number, piece_);
  ram_ = piece_;
}

// Composes the next piece of output.
void PlanConsole::compose() {
  if (task_ == kNothing) {
    if (due_ == 0) return;
    uint8_t task = kSay;
    uint8_t bit = 1;
    for (; (due_ & bit) == 0; bit <<= 1) ++task;
    task_ = static_cast<Task>(task);
    due_ ^= bit;
    step_ = 0;
  }
  bool isMore = false;
  switch (task_) {
    case kSay:
      if (step_ == 0) {
        put(said_);
      } else {
        putLineEnd();
      }
      isMore = step_ == 0;
      break;
    case kError: isMore = composeError(); break;
    case kHelp: isMore = composeHelp(); break;
    case kList: isMore = composeList_(*this); break;
    case kStatus: isMore = composeStatus(); break;
    case kEnded: isMore = composeEnded(); break;
    case kStored:
      if (step_ == 0) {
        putNumber(++told_);
      } else {
        putLineEnd();
      }
      isMore = step_ == 0;
      break;
    case kProgress: {
      if (step_ == 0) {
        done_ = autopilot_.itemsDone();
        putNumber(done_);
      } else {
        put(F("/"));
        putNumber(autopilot_.itemsTotal());
      }
      if (step_ == 2) {
        ram_ = nullptr;
        putLineEnd();
      }
      isMore = step_ < 2;
      break;
    }
    case kNothing: break;
  }
  ++step_;
  if (!isMore) task_ = kNothing;
}

bool PlanConsole::composeError() {
  switch (step_) {
    case 0:
      if (error_ == TextError::NoRoom) {
        put(F("item "));
        putNumber(plan_.stored() + 1u);
        return true;
      }
      put(F("line "));
      putNumber(text_.errorLine());
      return true;
    case 1:
      if (error_ == text_.error() && text_.errorField() != 0) {
        put(F(", field "));
        putNumber(text_.errorField());
      }
      return true;
    case 2: put(F(": ")); return true;
    case 3: put(toString(error_)); return true;
    default: put(F("\r\nnothing was loaded; further lines are ignored, up to end\r\n")); return false;
  }
}

// The client's last status, and which plan is aboard, in three pieces.
void PlanConsole::putOutcome(uint8_t piece) {
  if (piece == 0) return put(toString(autopilot_.status()));
  put(piece == 1          ? F("\r\naboard: ")
      : isEarlierAboard() ? F("an earlier plan of ours, whole")
                          : toString(autopilot_.aboard()));
}

bool PlanConsole::isEarlierAboard() { return isOtherAboard_ && autopilot_.aboard() == Aboard::OurPlan; }

bool PlanConsole::composeStatus() {
  switch (step_) {
    case 0: put(nameOf(autopilot_.firmware())); return true;
    case 1:
      if (autopilot_.hasAutopilot()) put(autopilot_.isArmed() ? F(", armed") : F(", disarmed"));
      return true;
    case 2: putLineEnd(); return true;
    case 3:
    case 4:
    case 5: putOutcome(step_ - 3); return true;
    case 6:
      put(plan_.isDamaged() ? F("\r\nstored: damaged, items ") : F("\r\nstored: items "));
      putNumber(plan_.count());
      return true;
    default: putLineEnd(); return false;
  }
}

bool PlanConsole::composeEnded() {
  const bool hasItem = autopilot_.failedItem() != MissionClient::kNoItem;
  switch (step_) {
    case 0: putOutcome(0); return true;
    case 1:
      if (hasItem) {
        put(F("\r\nitem "));
        putNumber(autopilot_.failedItem() + 1u);
      }
      return true;
    case 2:
      if (autopilot_.status() == Status::Differs) put(F("\r\nwhat differs: "));
      if (isStart_ && autopilot_.startArming() == StartArming::Disarmed) put(F("\r\nit is disarmed again"));
      return true;
    case 3:
      if (autopilot_.status() == Status::Differs) put(toString(autopilot_.differingField()));
      return true;
    case 4:
    case 5: putOutcome(step_ - 3); return true;
    default: putLineEnd(); return false;
  }
}

}  // namespace mavmission
