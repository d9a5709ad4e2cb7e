#include "PlanConsole.h"

#include <Arduino.h>

namespace mavmission {
using namespace detail;

PlanConsole::PlanConsole(Stream& port, uint8_t ring, MissionClient& autopilot, EepromPlan& plan, MissionItem* room,
                         uint8_t items)
    : PlanConsoleState(), port_(port), autopilot_(autopilot), plan_(plan), room_(room), roomItems_(items) {
  ring_ = ring;
}

#ifndef SERIAL_RX_BUFFER_SIZE  // in cores that do not say it
#define SERIAL_RX_BUFFER_SIZE 1
#endif
// Of a longer ring 255: a text that is refused before anything is lost does no harm.
uint8_t PlanConsole::ringOf(const HardwareSerial*) {
  return SERIAL_RX_BUFFER_SIZE > 256 ? 255 : static_cast<uint8_t>(SERIAL_RX_BUFFER_SIZE - 1);
}

void PlanConsole::update() {
  // Hides from the optimiser which object this is: it would use 4-byte addresses instead of 2-byte offsets.
  PlanConsole* console = this;
  asm("" : "+r"(console));
  console->storeItems();
  // What has ended is seen before the next command is read.
  console->watchPlan();
  console->watchAutopilot();
  console->read();
  console->print();
}

void PlanConsole::read() {
  for (uint8_t left = kBytesPerUpdate; left != 0; --left) {
    if (ring_ != 0 && port_.available() >= ring_) overrun();
    if (isOverrun_) {
      if (!skip()) return;
      continue;
    }
    // A command waits until the output of the last one is printed, and until the plan is stored, so that it uses the
    // new one; a text does not wait.
    const bool isInCommand = mode_ == Mode::Commands || (mode_ == Mode::Refused && isLineBegun_ && isCommand_);
    if (isItemHeld_ || mode_ == Mode::Ending || plan_.isBusy() || (isInCommand && !isSilent())) return;
    const int byte = port_.read();
    if (byte < 0) return;
    const bool isSecond = byte == '\n' && wasReturn_;
    wasReturn_ = byte == '\r';
    if (isSecond) continue;
    const bool wasInField = text_.isInField();
    take(byte == '\r' ? '\n' : static_cast<char>(byte));
    if (wasInField && !text_.isInField()) return;  // one number is enough work for one call
  }
}

// Characters of the lines that wait in the port may be missing. What is left of two lines could be a command.
void PlanConsole::overrun() {
  if (mode_ == Mode::Text) refuse(TextError::TooFast);
  isOverrun_ = true;
  skippedMs_ = static_cast<uint16_t>(millis());
}

// Ignores a byte. False if there is none: when the line has been quiet, the console says that it has ignored them.
bool PlanConsole::skip() {
  const uint16_t nowMs = static_cast<uint16_t>(millis());
  if (port_.read() >= 0) {
    skippedMs_ = nowMs;
    return true;
  }
  if (isSilent() && static_cast<uint16_t>(nowMs - skippedMs_) >= kQuietMs) {
    isOverrun_ = false;
    isLineBegun_ = false;
    say(F("too much at once: the rest was ignored"));
  }
  return false;
}

void PlanConsole::take(char c) {
  if (!isLineBegun_) {
    // Within a text a line that begins with a letter is a command, except for the Q of its first line.
    const char lower = static_cast<char>(c | 0x20);
    isCommand_ = lower >= 'a' && lower <= 'z' && c != 'Q';
    length_ = 0;
    if (mode_ == Mode::Commands) {
      if (isBlank(c) || isErasing(c)) return;
      // A file that was sent without load is refused once, and not line by line.
      if (c == 'Q' || c == '#' || (c >= '0' && c <= '9')) {
        sayLoadFirst();
        ignoreText();
      } else {
        isCommand_ = true;
      }
    }
  }
  isLineBegun_ = c != '\n';
  if (isCommand_) {
    takeInCommand(c);
  } else if (mode_ == Mode::Text) {
    takeInText(c);
  }
}

void PlanConsole::began(Status status) {
  if (status == Status::Busy) return say(toString(status));
  isOperation_ = true;
  isDownload_ = false;
  isStart_ = false;
  done_ = 0;
}

void PlanConsole::watchAutopilot() {
  if (!isOperation_) return;
  if (autopilot_.itemsDone() != done_ && autopilot_.itemsTotal() != 0) due(kProgress);
  if (autopilot_.isBusy()) return;
  isOperation_ = false;
  due(kEnded);
  const Status status = autopilot_.status();
  if (status == Status::Accepted || status == Status::Verified) isOtherAboard_ = false;
  if (!isDownload_ || status != Status::Downloaded) return;
  isPlanAwaited_ = plan_.commit();
  if (!isPlanAwaited_) sayNothingLoaded();  // no plan is aboard
}

}  // namespace mavmission
