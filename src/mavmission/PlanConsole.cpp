#include "PlanConsole.h"

#include <Arduino.h>

#include "Clock.h"
#include "FloatBits.h"

namespace mavmission {
namespace {

// One line a command: its name, and what it does.
// clang-format off
#define MAVMISSION_COMMANDS(X)                                            \
  X(help, "these words")                                                  \
  X(status, "the autopilot, the plan aboard, the plan here")              \
  X(load, "take the lines of a .waypoints file, up to end or cancel")     \
  X(end, "of the file: keep it, in EEPROM")                               \
  X(upload, "put it aboard")                                              \
  X(cancel, "what is going on")                                           \
  X(erase, "take the plan here away")                                     \
  X(list, "print the plan here, as a .waypoints file")                    \
  X(verify, "is it what is aboard?")                                      \
  X(download, "keep what is aboard")                                      \
  X(clear, "take the plan aboard away")                                   \
  X(start, "arm, and fly what is aboard")
// clang-format on

#define MAVMISSION_TEXT(name, text) #name "\0" text "\0"
const char kCommands[] PROGMEM = MAVMISSION_COMMANDS(MAVMISSION_TEXT);
#undef MAVMISSION_TEXT

const char kNewLine[] PROGMEM = "\r\n";
constexpr uint16_t kNotImplementedMs = 100;  // so long without room: the port does not say what it has

FlashText flash(const char* text) { return reinterpret_cast<FlashText>(text); }

const char* behind(const char* text) {
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

void printWhole(uint32_t number, char* text) {
  char digits[10];
  uint8_t count = 0;
  do {
    digits[count++] = static_cast<char>('0' + number % 10);
    number /= 10;
  } while (number != 0);
  while (count != 0) *text++ = digits[--count];
  *text = '\0';
}

}  // namespace

enum class PlanConsole::Command : uint8_t {
#define MAVMISSION_NAME(name, text) name,
  MAVMISSION_COMMANDS(MAVMISSION_NAME)
#undef MAVMISSION_NAME
  unknown,
};

PlanConsole::PlanConsole(Stream& port, uint8_t ring, MissionClient& autopilot, EepromPlan& plan, MissionItem* room,
                         uint8_t items)
    : PlanConsoleState(), port_(port), autopilot_(autopilot), plan_(plan), room_(room), roomItems_(items) {
  ring_ = ring;
}

#ifndef SERIAL_RX_BUFFER_SIZE  // in cores other than AVR's
#define SERIAL_RX_BUFFER_SIZE 1
#endif
uint8_t PlanConsole::ringOf(const HardwareSerial*) { return SERIAL_RX_BUFFER_SIZE - 1; }

void PlanConsole::update() {
  // The optimiser is not to know which object this is: it would use 4-byte addresses instead of 2-byte offsets.
  PlanConsole* console = this;
  asm("" : "+r"(console));
  console->storeItems();
  console->read();
  console->watchPlan();
  console->watchAutopilot();
  console->print();
}

// --- What comes

void PlanConsole::read() {
  for (uint8_t left = kBytesPerUpdate; left != 0; --left) {
    if (mode_ == Mode::Text && ring_ != 0 && port_.available() >= ring_) refuse(TextError::TooFast);
    // A command waits until what the last one had to say is said; a text does not wait.
    const bool isSilent = task_ == kNothing && due_ == 0;
    if (isItemHeld_ || mode_ == Mode::Ending || (mode_ == Mode::Commands && !isSilent)) return;
    const int byte = port_.read();
    if (byte < 0) return;
    const bool isSecond = byte == '\n' && wasReturn_;
    wasReturn_ = byte == '\r';
    if (isSecond) continue;
    const bool wasInField = text_.isInField();
    take(byte == '\r' ? '\n' : static_cast<char>(byte));
    if (wasInField && !text_.isInField()) return;  // a number is enough work
  }
}

void PlanConsole::take(char c) {
  if (!isLineBegun_) {
    // Among a text, what begins with a letter is a command, but for the Q of its first line.
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

void PlanConsole::takeInCommand(char c) {
  if (c == '\n') return runCommand();
  if (c == '\b' || c == 0x7F) {
    if (length_ != 0) --length_;
    return;
  }
  if (c == ' ' || c == '\t') return;
  if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 0x20);
  if (length_ < sizeof(command_)) command_[length_++] = c;
}

void PlanConsole::runCommand() {
  if (length_ == 0) return;
  uint8_t command = static_cast<uint8_t>(Command::unknown);
  if (length_ < sizeof(command_)) {
    command_[length_] = '\0';
    const char* name = kCommands;
    for (command = 0; command < static_cast<uint8_t>(Command::unknown); ++command, name = behind(behind(name))) {
      if (isEqual(name, command_)) break;
    }
  }
  run(static_cast<Command>(command));
}

#define MAVMISSION_SAY(text) say(PSTR(text))

void PlanConsole::run(Command command) {
  const bool isInText = mode_ == Mode::Text;
  if (mode_ == Mode::Refused) {
    mode_ = Mode::Commands;
    if (command == Command::end || command == Command::cancel) return MAVMISSION_SAY("nothing was loaded");
  }
  if (isInText && command != Command::end && command != Command::cancel) return refuse(TextError::BadNumber);
  switch (command) {
    case Command::help:
      return due(kHelp);
    case Command::status:
      return due(kStatus);
    case Command::end:
      return isInText ? endText() : MAVMISSION_SAY("nothing is being loaded: load comes first");
    case Command::cancel:
      if (!isInText) return autopilot_.cancel();
      mode_ = Mode::Commands;
      return MAVMISSION_SAY("nothing was loaded");
    case Command::upload:
      if (mayUsePlan()) began(autopilot_.upload(plan_.source()));
      return;
    case Command::load:
      if (mayExchangePlan()) beginText();
      return;
    case Command::erase:
      if (mayExchangePlan()) isPlanAwaited_ = plan_.erase();
      return;
    case Command::list:
    case Command::verify:
    case Command::download:
    case Command::clear:
    case Command::start:
      if (isOffered(command)) return offerOf(command)(*this);
      break;
    case Command::unknown:
      break;
  }
  MAVMISSION_SAY("no such command here: help names them");
}

bool PlanConsole::mayUsePlan() {
  if (plan_.hasPlan()) return true;
  MAVMISSION_SAY("no plan is here: load one");
  return false;
}

// The plan must not be exchanged while it is on its way.
bool PlanConsole::mayExchangePlan() {
  if (autopilot_.isBusy()) {
    began(Status::Busy);
  } else if (plan_.isBusy()) {
    MAVMISSION_SAY("the EEPROM is being written: wait");
  } else {
    return true;
  }
  return false;
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
  if (console.mayUsePlan()) console.due(kList);
}

void PlanConsole::runVerify(PlanConsole& console) {
  if (console.mayUsePlan()) console.began(console.autopilot_.verify(console.plan_.source()));
}

void PlanConsole::runDownload(PlanConsole& console) {
  if (!console.mayExchangePlan()) return;
  console.began(console.autopilot_.download(console.plan_.sink()));
  console.isDownload_ = true;
}

void PlanConsole::runClear(PlanConsole& console) { console.began(console.autopilot_.clear()); }
void PlanConsole::runStart(PlanConsole& console) { console.began(console.autopilot_.start()); }

// --- A text

void PlanConsole::beginText() {
  text_.begin();
  plan_.store();
  mode_ = Mode::Text;
  kept_ = 0;
  told_ = 0;
  MAVMISSION_SAY("send the file, then end");
}

void PlanConsole::takeInText(char c) {
  switch (text_.take(c)) {
    case WaypointsText::Step::More:
      return;
    case WaypointsText::Step::Item:
      isItemHeld_ = true;
      return storeItems();
    case WaypointsText::Step::Bad:
      return refuse(text_.error());
  }
}

void PlanConsole::endText() {
  switch (text_.end()) {
    case WaypointsText::Step::Item:  // cannot be: its line had an end
    case WaypointsText::Step::More:
      mode_ = Mode::Ending;
      return;
    case WaypointsText::Step::Bad:
      refuse(text_.error());
      mode_ = Mode::Commands;
      return;
  }
}

// The rest of the text is passed over, up to end or another command.
void PlanConsole::refuse(TextError error) {
  error_ = error;
  mode_ = Mode::Refused;
  isItemHeld_ = false;
  kept_ = 0;
  due(kError);
}

void PlanConsole::storeItems() {
  if (mode_ != Mode::Text && mode_ != Mode::Ending) return;
  if (plan_.state() == EepromPlan::State::Failed) return refuse(TextError::NotKept);
  if (kept_ != 0 && plan_.isReady()) {
    if (!plan_.put(room_[oldest_])) return refuse(TextError::NoRoom);
    --kept_;
    if (++oldest_ == roomItems_) oldest_ = 0;
  }
  if (!isItemHeld_) return;
  if (kept_ == 0 && plan_.isReady()) {
    isItemHeld_ = false;
    if (!plan_.put(text_.item())) refuse(TextError::NoRoom);
  } else if (kept_ < roomItems_) {
    isItemHeld_ = false;
    if (kept_ == 0) oldest_ = 0;
    const uint16_t place = static_cast<uint16_t>(oldest_) + kept_;
    room_[place < roomItems_ ? place : place - roomItems_] = text_.item();
    ++kept_;
  }
}

// --- What goes on

void PlanConsole::watchPlan() {
  if (mode_ == Mode::Text || mode_ == Mode::Ending) {
    if (plan_.isReady() && plan_.stored() > told_) due(kStored);
    if (mode_ != Mode::Ending || kept_ != 0 || isItemHeld_ || !plan_.isReady()) return;
    if (plan_.stored() > told_) return;
    mode_ = Mode::Commands;
    isPlanAwaited_ = plan_.commit();
    return;
  }
  if (!isPlanAwaited_ || plan_.isBusy()) return;
  isPlanAwaited_ = false;
  if (plan_.state() == EepromPlan::State::Failed) {
    MAVMISSION_SAY("the EEPROM does not keep it");
  } else if (plan_.hasPlan()) {
    MAVMISSION_SAY("kept: list prints it");
  } else {
    MAVMISSION_SAY("erased");
  }
}

void PlanConsole::began(Status status) {
  if (status == Status::Busy) return say(reinterpret_cast<const char*>(toString(status)));
  isOperation_ = true;
  isDownload_ = false;
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

// --- What is said

void PlanConsole::say(const char* text) {
  said_ = text;
  due(kSay);
}

void PlanConsole::print() {
  if (flash_ == nullptr && ram_ == nullptr) compose();
  if (flash_ == nullptr && ram_ == nullptr) return;
  int room = port_.availableForWrite();
  if (room <= 0) {
    const uint16_t nowMs = static_cast<uint16_t>(millis());
    if (!isStuck_) stuckMs_ = nowMs;
    isStuck_ = true;
    if (since(stuckMs_, nowMs) >= kNotImplementedMs) isBlind_ = true;
    if (!isBlind_) return;
    room = 1;
  } else {
    isStuck_ = false;
    isBlind_ = false;
  }
  if (room > kBytesPerUpdate) room = kBytesPerUpdate;
  for (; room > 0; --room) {
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

// The next piece of what there is to say.
void PlanConsole::compose() {
  if (task_ == kNothing) {
    if (due_ == 0) return;
    uint8_t first = 1;
    while ((due_ >> first & 1) == 0) ++first;
    task_ = static_cast<Task>(first);
    due_ &= static_cast<uint16_t>(~(1 << first));
    step_ = 0;
  }
  bool isMore = false;
  switch (task_) {
    case kSay:
      put(flash(step_ == 0 ? said_ : kNewLine));
      isMore = step_ == 0;
      break;
    case kError:
      isMore = composeError();
      break;
    case kHelp:
      isMore = composeHelp();
      break;
    case kList:
      isMore = composeList_(*this);
      break;
    case kStatus:
      isMore = composeStatus();
      break;
    case kEnded:
      isMore = composeEnded();
      break;
    case kStored:
      if (step_ == 0) {
        putNumber(++told_);
      } else {
        put(flash(kNewLine));
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
        put(flash(kNewLine));
      }
      isMore = step_ < 2;
      break;
    }
    case kNothing:
      break;
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
    case 2:
      put(F(": "));
      return true;
    case 3:
      put(toString(error_));
      return true;
    default:
      put(F("\r\nnothing was loaded; what is still to come of it is passed over, up to end\r\n"));
      return false;
  }
}

bool PlanConsole::composeHelp() {
  while (!isOffered(static_cast<Command>(step_ / 2))) step_ += 2;
  if (step_ / 2 == static_cast<uint8_t>(Command::unknown)) return false;
  const char* name = kCommands;
  for (uint8_t skipped = step_ / 2; skipped != 0; --skipped) name = behind(behind(name));
  if (step_ % 2 == 0) {
    put(flash(name));
    memcpy_P(piece_, PSTR(": "), 3);
    ram_ = piece_;
    return true;
  }
  put(flash(behind(name)));
  memcpy_P(piece_, kNewLine, sizeof(kNewLine));
  ram_ = piece_;
  return true;
}

// As a .waypoints file: home is not known here.
bool PlanConsole::composeList(PlanConsole& console) {
  uint8_t& step = console.step_;
  if (step == 0) {
    console.item_ = 0;
    console.put(F("QGC WPL 110\r\n0\t0\t0\t16\t0\t0\t0\t0\t0\t0\t0\t1"));
    return true;
  }
  if (step == 13) {
    if (++console.item_ >= console.plan_.count()) {
      console.put(flash(kNewLine));
      return false;
    }
    step = 1;
  }
  console.put(step == 1 ? F("\r\n") : F("\t"));
  console.composeField(step);
  return true;
}

void PlanConsole::composeField(uint8_t field) {
  MissionItem item;
  const ItemSource source = plan_.source();
  if (!source.read(source.context, item_, item)) return;
  ram_ = piece_;
  const bool isPlace = item.frame != Frame::Mission;
  switch (field) {
    case 1:
      return putNumber(item_ + 1u);
    case 2:
      return putNumber(item.current);
    case 3:
      return putNumber(static_cast<uint8_t>(item.frame));
    case 4:
      return putNumber(item.command);
    case 5:
      return printFloat(item.command == kDoJump ? oneMore(item.param1) : item.param1, piece_);
    case 6:
      return printFloat(item.param2, piece_);
    case 7:
      return printFloat(item.param3, piece_);
    case 8:
      return printFloat(item.param4, piece_);
    case 9:
    case 10: {
      const int32_t value = field == 9 ? item.x : item.y;
      if (isPlace) return printDegrees(value, piece_);
      const uint32_t whole = static_cast<uint32_t>(value);
      piece_[0] = '-';
      return value < 0 ? printWhole(0 - whole, piece_ + 1) : printWhole(whole, piece_);
    }
    case 11:
      return printFloat(item.z, piece_);
    default:
      return putNumber(item.autocontinue);
  }
}

bool PlanConsole::composeStatus() {
  switch (step_) {
    case 0:
      switch (autopilot_.firmware()) {
        case Firmware::Unknown:
          put(F("no autopilot is heard"));
          break;
        case Firmware::ArduPilot:
          put(F("ArduPilot"));
          break;
        case Firmware::Px4:
          put(F("PX4"));
          break;
        case Firmware::Other:
          put(F("an autopilot that is neither ArduPilot nor PX4"));
          break;
      }
      return true;
    case 1:
      if (autopilot_.hasAutopilot()) put(autopilot_.isArmed() ? F(", armed") : F(", disarmed"));
      return true;
    case 2:
      put(F("\r\n"));
      return true;
    case 3:
      put(toString(autopilot_.status()));
      return true;
    case 4:
      put(F("\r\naboard: "));
      return true;
    case 5:
      put(toString(autopilot_.aboard()));
      return true;
    case 6:
      put(plan_.isDamaged() ? F("\r\nhere: damaged, items ") : F("\r\nhere: items "));
      putNumber(plan_.count());
      return true;
    default:
      put(flash(kNewLine));
      return false;
  }
}

bool PlanConsole::composeEnded() {
  const bool hasItem = autopilot_.failedItem() != MissionClient::kNoItem;
  switch (step_) {
    case 0:
      put(toString(autopilot_.status()));
      return true;
    case 1:
      if (hasItem) {
        put(F("\r\nitem "));
        putNumber(autopilot_.failedItem() + 1u);
      }
      return true;
    case 2:
      if (autopilot_.status() == Status::Differs) put(F("\r\nwhat differs: "));
      return true;
    case 3:
      if (autopilot_.status() == Status::Differs) put(toString(autopilot_.differingField()));
      return true;
    case 4:
      put(F("\r\naboard: "));
      return true;
    case 5:
      put(toString(autopilot_.aboard()));
      return true;
    default:
      put(flash(kNewLine));
      return false;
  }
}

}  // namespace mavmission
