// Prints on the serial monitor (115200 baud) why nothing works, or that all is well. Correct the fault, and the verdict
// changes within some seconds. docs/troubleshooting.md says what to do about each verdict.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr uint32_t kBaud = 57600;  // what the autopilot's port is set to

MissionClient autopilot(TELEM);
LinkDoctor doctor(autopilot);
Verdict said = Verdict::Listening;

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
  CONSOLE.println(toString(verdict));
  if (verdict == Verdict::WrongBaud) {
    CONSOLE.print(F("  it speaks at "));
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
  autopilot.update();
  if (verdict == said) return;
  said = verdict;
  report(verdict);
}
