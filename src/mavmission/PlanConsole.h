// A text console: by a terminal on a laptop the plan in EEPROM is loaded and listed, put aboard, verified and flown. It
// does not block: what it says goes out in pieces that the stream takes without waiting.
//
//   MissionClient autopilot(Serial1);
//   EepromPlan plan;
//   MissionItem room[64];
//   PlanConsole console(Serial, autopilot, plan, room);
//   ...
//   plan.begin();                                            // in setup()
//   ...
//   autopilot.update(); plan.update(); console.update();     // in loop()
//
// Each line is a command; "help" names them. After "load" the lines are those of a .waypoints file (WaypointsText.h),
// up to "end". Items are named as such a file numbers them: 0 is home. A bad text is refused with its line, its field
// and the reason, and the plan that was there stays.
//
// An EEPROM takes about 18 waypoints a second; a terminal that pastes sends 150. What comes faster waits in `room`.
// Without it lines may be typed, or sent one by one, each when the number of the one before has been printed; a text
// that comes too fast is refused.
#pragma once

#include <Arduino.h>
#include <stdint.h>

#include "EepromPlan.h"
#include "Flash.h"
#include "MissionClient.h"
#include "WaypointsText.h"

namespace mavmission {

class PlanConsole;

// What PlanConsole keeps, all zero at the start; a base of it, so that it lies first, which is cheap to reach on AVR.
class PlanConsoleState {
 protected:
  // What the lines are that come.
  enum class Mode : uint8_t { Commands, Text, Ending, Refused };
  // What there is to print; the first that is due comes first.
  enum Task : uint8_t { kNothing, kSay, kError, kHelp, kList, kStatus, kProgress, kEnded, kStored };
  typedef void (*Offer)(PlanConsole& console);
  static constexpr uint8_t kOffers = 5;
  static const char kLineEnd[];  // in flash

  Mode mode_;
  TextError error_;         // why the text was refused
  bool isItemHeld_ : 1;     // text_ holds an item for which there is no room
  bool isLineBegun_ : 1;    // of the text, or of what is passed over
  bool isCommand_ : 1;      // the line is one
  bool wasReturn_ : 1;      // the last character was CR: an LF behind it is no further line
  bool isOperation_ : 1;    // the client does what the console began
  bool isDownload_ : 1;     // that is one
  bool isStart_ : 1;        // that is start()
  bool isPlanAwaited_ : 1;  // it is being committed or erased
  bool isStuck_ : 1;        // the port had no room
  bool isBlind_ : 1;        // it does not say when it has
#ifndef __AVR__
  bool hasSaid_ : 1;  // it has said so once: without room it waits, as a USB port to which nobody listens
#endif
  uint8_t length_;  // of the command so far
  uint8_t kept_;    // items in the room
  uint8_t oldest_;  // of them
  uint8_t ring_;
  uint16_t told_;  // items that were said to be stored
  uint16_t done_;  // the progress that was printed
  uint16_t due_;   // a bit for each Task
  Task task_;
  uint8_t step_;       // of it
  uint16_t item_;      // that is listed
  uint16_t stuckMs_;   // when the port first had no room
  FlashText said_;     // the text of kSay
  const char* flash_;  // what is being printed: this, in flash, if it is not null,
  const char* ram_;    // then this
  char command_[9];
  char piece_[kFloatText];
  Offer offers_[kOffers];  // null: not offered
  bool (*composeList_)(PlanConsole& console);
};

// The commands of a terminal.
class PlanConsole : private PlanConsoleState {
 public:
  // The most that one update() reads, and that it writes [bytes].
  static constexpr uint8_t kBytesPerUpdate = 32;

  // The port must be open; all must stay as long as this. On one that does not implement availableForWrite() a byte is
  // written each update(), and may block.
  template <typename Port>
  PlanConsole(Port& port, MissionClient& autopilot, EepromPlan& plan)
      : PlanConsole(port, ringOf(&port), autopilot, plan, nullptr, 0) {}
  // `room`: for items that wait to be stored, 33 bytes each.
  template <typename Port, size_t N>
  PlanConsole(Port& port, MissionClient& autopilot, EepromPlan& plan, MissionItem (&room)[N])
      : PlanConsole(port, ringOf(&port), autopilot, plan, room, N) {
    static_assert(N <= 255, "no EEPROM holds as many items");
  }

  // The bytes that the port's receive ring holds [bytes], where what comes then is lost: a text in whose midst it was
  // full is refused, for something may be missing. Known of the board's own ports; 0, nothing is ever lost, for any
  // other.
  void setRing(uint8_t bytes) { ring_ = bytes; }

  // Commands that a sketch offers beside help, status, load, end, upload, erase and cancel, to be called in setup().
  // One that is not offered is not in the program (README.md, "Sizes").
  void offerList();      // the plan in EEPROM, as a .waypoints text
  void offerVerify();    // is it what is aboard?
  void offerDownload();  // keeps what is aboard
  void offerClear();     // takes away what is aboard
  void offerStart();     // ARMS, and flies what is aboard, if that is our plan: MissionClient::start()
  void offerAll();

  // To be called from loop(), beside the client's and the plan's.
  void update();

 private:
  enum class Command : uint8_t;

  PlanConsole(Stream& port, uint8_t ring, MissionClient& autopilot, EepromPlan& plan, MissionItem* room, uint8_t items);
  static uint8_t ringOf(const HardwareSerial*);
  static uint8_t ringOf(const void*) { return 0; }

  MAVMISSION_APART void read();
  void take(char c);
  void takeInCommand(char c);
  void takeInText(char c);
  MAVMISSION_APART void runCommand();
  MAVMISSION_APART void run(Command command);
  Offer& offerOf(Command command);
  bool isOffered(Command command);
  bool mayExchangePlan();
  MAVMISSION_APART bool mayUsePlan();
  static void runList(PlanConsole& console);
  static void runVerify(PlanConsole& console);
  static void runDownload(PlanConsole& console);
  static void runClear(PlanConsole& console);
  static void runStart(PlanConsole& console);
  void beginText();
  void endText();
  MAVMISSION_APART void refuse(TextError error);
  MAVMISSION_APART void storeItems();
  MAVMISSION_APART void watchPlan();
  MAVMISSION_APART void watchAutopilot();
  MAVMISSION_APART void began(Status status);

  MAVMISSION_APART void print();
  MAVMISSION_APART void compose();
  void due(Task task) { due_ |= static_cast<uint16_t>(1 << task); }
  MAVMISSION_APART void say(FlashText text);
  void put(FlashText text) { flash_ = reinterpret_cast<const char*>(text); }
  void putLineEnd() { flash_ = kLineEnd; }
  MAVMISSION_APART void putOutcome(uint8_t piece);
  MAVMISSION_APART void putNumber(uint32_t number);
  MAVMISSION_APART bool composeError();
  MAVMISSION_APART bool composeHelp();
  static bool composeList(PlanConsole& console);
  MAVMISSION_APART bool composeStatus();
  MAVMISSION_APART bool composeEnded();
  void composeField(uint8_t field);

  Stream& port_;
  MissionClient& autopilot_;
  EepromPlan& plan_;
  MissionItem* const room_;
  const uint8_t roomItems_;
  WaypointsText text_;
};

}  // namespace mavmission
