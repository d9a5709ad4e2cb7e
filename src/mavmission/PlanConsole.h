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

#include <stdint.h>

#include "EepromPlan.h"
#include "FlashText.h"
#include "MissionClient.h"
#include "console/PlanConsoleState.h"
#include "text/WaypointsText.h"

class HardwareSerial;

namespace mavmission {

// The commands of a terminal.
class PlanConsole : private detail::PlanConsoleState {
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
  // One that is not offered is not in the program (docs/measurements.md).
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
  detail::WaypointsText text_;
};

}  // namespace mavmission
