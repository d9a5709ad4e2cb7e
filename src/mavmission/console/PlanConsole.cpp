#include "../PlanConsole.h"

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
  console->read();
  console->watchPlan();
  console->watchAutopilot();
  console->print();
}

void PlanConsole::read() {
  for (uint8_t left = kBytesPerUpdate; left != 0; --left) {
    if (mode_ == Mode::Text && ring_ != 0 && port_.available() >= ring_) refuse(TextError::TooFast);
    // A command waits until the output of the last one is printed; a text does not wait.
    const bool isSilent = task_ == kNothing && due_ == 0;
    if (isItemHeld_ || mode_ == Mode::Ending || (mode_ == Mode::Commands && !isSilent)) return;
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

void PlanConsole::take(char c) {
  if (!isLineBegun_) {
    // Within a text a line that begins with a letter is a command, except for the Q of its first line.
    const char lower = static_cast<char>(c | 0x20);
    const bool isLetter = lower >= 'a' && lower <= 'z' && c != 'Q';
    isCommand_ = mode_ == Mode::Commands || isLetter;
    length_ = 0;
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
  if (isDownload_ && autopilot_.status() == Status::Downloaded) isPlanAwaited_ = plan_.commit();
}

}  // namespace mavmission
