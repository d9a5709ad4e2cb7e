// A text console: from a terminal on a laptop you load the plan in EEPROM, list it, upload it, verify it and fly it. It
// does not block: it prints in pieces that fit into the port's transmit buffer.
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
// up to "end". Items have the numbers of such a file: 0 is home. A bad text is refused with its line, its field and the
// reason, and the old plan is kept. So that what was pasted after it is not done with that plan, "upload", "verify"
// and "start" are refused until another load or download has succeeded, or "cancel" has been typed.
//
// A line is read when the one before has been answered and the EEPROM is written; so commands may be pasted one after
// the other. While an operation of the client runs, "cancel", "status", "help" and "list" are done; others are refused.
//
// An EEPROM stores about 18 waypoints a second; a terminal that pastes a text sends 150. Items that arrive faster wait
// in `room`. Without it, lines may be typed, or sent one by one, each after the number of the one before has been
// printed; a text that arrives too fast is refused.
#pragma once

#include <Arduino.h>
#include <stdint.h>

#include "../base/FlashText.h"
#include "../client/MissionClient.h"
#include "../storage/EepromPlan.h"
#include "../text/WaypointsText.h"
#include "PlanConsoleState.h"

namespace mavmission {

// The commands of a terminal.
class PlanConsole : private detail::PlanConsoleState {
 public:
  // How much one update() reads at most, and writes at most [bytes].
  static constexpr uint8_t kBytesPerUpdate = 32;

  // The port must be open; it, the client and the plan must live as long as the console. To a port that does not
  // implement availableForWrite() each update() writes one byte, which may block.
  template <typename Port>
  PlanConsole(Port& port, MissionClient& autopilot, EepromPlan& plan)
      : PlanConsole(port, ringOf(&port), autopilot, plan, nullptr, 0) {}
  // `room`: a buffer for items that wait to be stored, 33 bytes each.
  template <typename Port, size_t N>
  PlanConsole(Port& port, MissionClient& autopilot, EepromPlan& plan, MissionItem (&room)[N])
      : PlanConsole(port, ringOf(&port), autopilot, plan, room, N) {
    static_assert(N <= 255, "give PlanConsole a room of at most 255 items: no EEPROM holds more");
  }

  // Sets the size of the port's receive buffer [bytes]. When the buffer is full, further bytes are lost: so a text
  // during which it was full is refused, since characters may be missing, and commands that it holds are ignored until
  // nothing has come for 100 ms. For the board's own ports the size is known; for any other port the default is 0,
  // which means that no byte is ever lost.
  void setRing(uint8_t bytes) { ring_ = bytes; }

  // Commands that a sketch may offer beside help, status, load, end, upload, erase and cancel; to be called in setup().
  // A command that is not offered is not in the program (docs/measurements.md).
  void offerList();      // the plan in EEPROM, as a .waypoints text
  void offerVerify();    // compares it with the plan aboard
  void offerDownload();  // stores the plan that is aboard
  void offerClear();     // deletes the plan that is aboard
  // ARMS the aircraft, and flies the plan aboard, if it is ours: MissionClient::start(). Refused if another plan has
  // been loaded since.
  void offerStart();
  void offerAll();

  // To be called from loop(), in addition to update() of the client and of the plan.
  void update();

 private:
  enum class Command : uint8_t;

  PlanConsole(Stream& port, uint8_t ring, MissionClient& autopilot, EepromPlan& plan, MissionItem* room, uint8_t items);
  static uint8_t ringOf(const HardwareSerial*);
  static uint8_t ringOf(const void*) { return 0; }

  static bool isBlank(char c) { return c == ' ' || c == '\t'; }
  static bool isErasing(char c) { return c == '\b' || c == 0x7F; }

  MAVMISSION_APART void read();
  void overrun();
  bool skip();
  bool isSilent() const { return task_ == kNothing && due_ == 0; }
  void take(char c);
  void takeInCommand(char c);
  void takeInText(char c);
  MAVMISSION_APART void runCommand();
  MAVMISSION_APART MAVMISSION_ONE_EXIT void run(Command command);
  Offer& offerOf(Command command);
  bool isOffered(Command command);
  MAVMISSION_APART bool hasPlan();
  MAVMISSION_APART bool isAutopilotFree();
  MAVMISSION_APART bool isStored();
  MAVMISSION_APART bool mayUsePlan();
  bool isEarlierAboard();
  MAVMISSION_APART void sayNothingLoaded();
  MAVMISSION_APART void sayLoadFirst();
  void ignoreText();
  static void runList(PlanConsole& console);
  static void runVerify(PlanConsole& console);
  static void runDownload(PlanConsole& console);
  static void runClear(PlanConsole& console);
  static void runStart(PlanConsole& console);
  void beginText();
  void endText();
  MAVMISSION_APART void refuse(TextError error);
  MAVMISSION_APART void storeItems();
  MAVMISSION_APART bool putItem(const MissionItem& item);
  MAVMISSION_APART void watchPlan();
  MAVMISSION_APART void watchAutopilot();
  MAVMISSION_APART void began(Status status);

  MAVMISSION_APART void print();
  MAVMISSION_APART void compose();
  void due(Task task) { due_ |= static_cast<uint8_t>(1 << (task - 1)); }
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
  char command_[12];  // 12: too long
  char piece_[detail::kFloatText];
  Offer offers_[kOffers] = {};  // null: not offered
  bool (*composeList_)(PlanConsole& console) = nullptr;
};

}  // namespace mavmission
