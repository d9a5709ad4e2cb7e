// The commands of a PlanConsole: their names, what each does, and help.
#include "PlanConsole.h"

#include <Arduino.h>

namespace mavmission {
using namespace detail;
namespace {

// One line for each command: its name, and what it does.
// clang-format off
#define MAVMISSION_COMMANDS(X)                                            \
  X(help, "list the commands")                                            \
  X(status, "show the autopilot and both plans")                          \
  X(load, "read a .waypoints file, up to end or cancel")                  \
  X(end, "end of the file: store the plan")                               \
  X(upload, "upload the stored plan")                                     \
  X(cancel, "stop what is running")                                       \
  X(erase, "delete the stored plan")                                      \
  X(list, "print the stored plan")                                        \
  X(verify, "compare both plans")                                         \
  X(download, "store the plan aboard")                                    \
  X(clear, "delete the plan aboard")                                      \
  X(start, "ARM, and fly the plan aboard")
// clang-format on

#define MAVMISSION_TEXT(name, text) #name "\0" text "\0"
const char kCommands[] PROGMEM = MAVMISSION_COMMANDS(MAVMISSION_TEXT);
#undef MAVMISSION_TEXT

FlashText flash(const char* text) { return reinterpret_cast<FlashText>(text); }

const char* nextText(const char* text) {
  while (pgm_read_byte(text++) != 0) {
  }
  return text;
}

bool isEqual(const char* flash, const char* ram) {
  for (;; ++flash, ++ram) {
    const char c = static_cast<char>(pgm_read_byte(flash));
    if (c != *ram) return false;
    if (c == 0) return true;
  }
}

}  // namespace

enum class PlanConsole::Command : uint8_t {
#define MAVMISSION_NAME(name, text) name,
  MAVMISSION_COMMANDS(MAVMISSION_NAME)
#undef MAVMISSION_NAME
      unknown,
};

void PlanConsole::takeInCommand(char c) {
  if (c == '\n') return runCommand();
  if (length_ == sizeof(command_)) return;  // too long, whatever is erased
  if (isErasing(c)) {
    if (length_ != 0) --length_;
    return;
  }
  if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 0x20);
  command_[length_++] = isBlank(c) ? ' ' : c;
}

void PlanConsole::runCommand() {
  if (length_ < sizeof(command_)) {
    while (length_ != 0 && command_[length_ - 1] == ' ') --length_;
  }
  if (length_ == 0) return;
  uint8_t command = static_cast<uint8_t>(Command::unknown);
  if (length_ < sizeof(command_)) {
    command_[length_] = '\0';
    const char* name = kCommands;
    for (command = 0; command < static_cast<uint8_t>(Command::unknown); ++command, name = nextText(nextText(name))) {
      if (isEqual(name, command_)) break;
    }
  }
  run(static_cast<Command>(command));
}

void PlanConsole::run(Command command) {
  const bool isInText = mode_ == Mode::Text;
  if (mode_ == Mode::Refused) {
    mode_ = Mode::Commands;
    if (command == Command::end) return sayNothingLoaded();
  }
  if (isInText && command != Command::end && command != Command::cancel) return refuse(TextError::BadNumber);
  switch (command) {
    case Command::help: return due(kHelp);
    case Command::status: return due(kStatus);
    case Command::end: return isInText ? endText() : sayLoadFirst();
    case Command::cancel:
      if (!isInText) autopilot_.cancel();
      if (isNotStored_ || isIgnored_) sayNothingLoaded();
      mode_ = Mode::Commands;
      isNotStored_ = false;
      isIgnored_ = false;
      return;
    case Command::upload:
      if (mayUsePlan()) began(autopilot_.upload(plan_.source()));
      return;
    case Command::load: return beginText();
    case Command::erase:
      if (isAutopilotFree()) isPlanAwaited_ = plan_.erase();
      return;
    case Command::list:
    case Command::verify:
    case Command::download:
    case Command::clear:
    case Command::start:
      if (isOffered(command)) return offerOf(command)(*this);
      break;
    case Command::unknown: break;
  }
  say(F("unknown command: type help"));
}

bool PlanConsole::hasPlan() {
  if (plan_.hasPlan()) return true;
  say(F("no plan is stored: type load"));
  return false;
}

// The plan must not be exchanged while it is being transferred.
bool PlanConsole::isAutopilotFree() {
  if (!autopilot_.isBusy()) return true;
  say(toString(Status::Busy));
  return false;
}

// What was pasted after a text that was refused, was meant for the plan in that text.
bool PlanConsole::isStored() {
  if (!isNotStored_ && !isIgnored_) return true;
  say(F("the last load or download failed: repeat it, or type cancel"));
  return false;
}

bool PlanConsole::mayUsePlan() { return isAutopilotFree() && hasPlan() && isStored(); }

void PlanConsole::sayNothingLoaded() { say(F("nothing was loaded")); }

void PlanConsole::sayLoadFirst() { say(F("nothing is being loaded: type load first")); }

// A text comes all the same, and is not stored.
void PlanConsole::ignoreText() {
  mode_ = Mode::Refused;
  isIgnored_ = true;
}

PlanConsole::Offer& PlanConsole::offerOf(Command command) {
  return offers_[static_cast<uint8_t>(command) - static_cast<uint8_t>(Command::list)];
}

bool PlanConsole::isOffered(Command command) {
  return command < Command::list || command == Command::unknown || offerOf(command) != nullptr;
}

void PlanConsole::offerList() {
  offerOf(Command::list) = runList;
  composeList_ = composeList;
}
void PlanConsole::offerVerify() { offerOf(Command::verify) = runVerify; }
void PlanConsole::offerDownload() { offerOf(Command::download) = runDownload; }
void PlanConsole::offerClear() { offerOf(Command::clear) = runClear; }
void PlanConsole::offerStart() { offerOf(Command::start) = runStart; }

void PlanConsole::offerAll() {
  offerList();
  offerVerify();
  offerDownload();
  offerClear();
  offerStart();
}

void PlanConsole::runList(PlanConsole& console) {
  if (console.hasPlan()) console.due(kList);
}

void PlanConsole::runVerify(PlanConsole& console) {
  if (console.mayUsePlan()) console.began(console.autopilot_.verify(console.plan_.source()));
}

void PlanConsole::runDownload(PlanConsole& console) {
  console.isNotStored_ = true;
  if (!console.isAutopilotFree()) return;
  console.isIgnored_ = false;
  console.began(console.autopilot_.download(console.plan_.sink()));
  console.isDownload_ = true;
}

void PlanConsole::runClear(PlanConsole& console) { console.began(console.autopilot_.clear()); }
void PlanConsole::runStart(PlanConsole& console) {
  if (!console.isAutopilotFree() || !console.isStored()) return;
  if (console.isEarlierAboard()) return console.say(F("the stored plan is not aboard: type upload"));
  console.began(console.autopilot_.start());
  console.isStart_ = true;
}

bool PlanConsole::composeHelp() {
  while (!isOffered(static_cast<Command>(step_ / 2))) step_ += 2;
  if (step_ / 2 == static_cast<uint8_t>(Command::unknown)) return false;
  const char* name = kCommands;
  for (uint8_t skipped = step_ / 2; skipped != 0; --skipped) name = nextText(nextText(name));
  if (step_ % 2 == 0) {
    put(flash(name));
    memcpy_P(piece_, PSTR(": "), 3);
  } else {
    put(flash(nextText(name)));
    memcpy_P(piece_, PSTR("\r\n"), 3);
  }
  ram_ = piece_;
  return true;
}

}  // namespace mavmission
