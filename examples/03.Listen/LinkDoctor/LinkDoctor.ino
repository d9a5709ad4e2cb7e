// Prints on the serial monitor (115200 baud) why nothing works, or that all is well. Correct the fault: the verdict
// changes within some seconds. docs/troubleshooting.md says what to do about each verdict. When all is well, it reads
// the settings of the autopilot that matter to a mission, and says what follows from them.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr uint32_t kBaud = 57600;  // what the autopilot's port is set to

MissionClient autopilot(TELEM);
LinkDoctor doctor(autopilot);
Parameters parameters(autopilot);
Verdict said = Verdict::Listening;

struct Setting {
  char name[17];
  int8_t value;  // the advice is printed if the setting has this value
  char advice[56];
};
const Setting kArduPilot[] PROGMEM = {
    {"SERIAL1_PROTOCOL", 1, "TELEM1 has MAVLink 1: no fences, no rally points"},
    {"SERIAL1_BAUD", -1, ""},  // in thousands
    {"SERIAL2_PROTOCOL", 1, "TELEM2 has MAVLink 1: no fences, no rally points"},
    {"SERIAL2_BAUD", -1, ""},
    {"MIS_RESTART", 0, "AUTO continues at the item where it stopped"},
    {"FENCE_ENABLE", 0, "an uploaded fence is not enforced"},
};
const Setting kPx4[] PROGMEM = {
    {"SER_TEL1_BAUD", -1, ""},
    {"GF_ACTION", 0, "an uploaded fence is not enforced"},
    {"MAV_0_FORWARD", 0, "TELEM1 gets no commands from a ground station"},
};
uint8_t next = 0;  // the setting that is being read

FlashText flashText(const char* text) { return reinterpret_cast<FlashText>(text); }

// Null after the last one.
const Setting* setting() {
  const bool isPx4 = autopilot.firmware() == Firmware::Px4;
  const uint8_t settings = isPx4 ? sizeof(kPx4) / sizeof(Setting) : sizeof(kArduPilot) / sizeof(Setting);
  return next < settings ? (isPx4 ? kPx4 : kArduPilot) + next : nullptr;
}

void readSetting() {
  if (setting() != nullptr) parameters.read(flashText(setting()->name));
}

void printSetting(Status ended) {
  if (!CONSOLE) return;
  const Setting& read = *setting();
  CONSOLE.print(F("  "));
  CONSOLE.print(flashText(read.name));
  CONSOLE.print(' ');
  if (ended != Status::Done) {
    CONSOLE.println(toString(ended));
    return;
  }
  CONSOLE.print(parameters.whole());
  if (parameters.whole() == static_cast<int8_t>(pgm_read_byte(&read.value))) {
    CONSOLE.print(F(": "));
    CONSOLE.print(flashText(read.advice));
  }
  CONSOLE.println();
}

void openPort(void*, uint32_t baud) { beginTelem(baud); }

void printSpeaker(const Speaker& speaker) {
  CONSOLE.print(F("  heard: system "));
  CONSOLE.print(speaker.systemId);
  CONSOLE.print(F(", component "));
  CONSOLE.print(speaker.componentId);
  CONSOLE.print(F(", MAV_TYPE "));
  CONSOLE.println(speaker.type);
}

void report(Verdict verdict) {
  if (!CONSOLE) return;
  CONSOLE.println(toString(verdict));
  if (verdict == Verdict::WrongBaud) {
    CONSOLE.print(F("  it sends at "));
    CONSOLE.println(doctor.baud());
  }
  if (verdict == Verdict::NoAutopilot || verdict == Verdict::OtherAutopilot || verdict == Verdict::SeveralAutopilots) {
    printSpeaker(doctor.speaker());
  }
}

void setup() {
  CONSOLE.begin(115200);
  openPort(nullptr, kBaud);
  doctor.tryBauds(openPort, kBaud);
}

void loop() {
  const Verdict verdict = doctor.update();
  const Status status = autopilot.update();
  if (isEnd(status) && isWell(verdict) && setting() != nullptr) {
    printSetting(status);
    ++next;
    readSetting();
  }
  if (verdict == said) return;
  if (isWell(verdict) && !isWell(said)) {
    next = 0;
    readSetting();
  }
  said = verdict;
  report(verdict);
}
