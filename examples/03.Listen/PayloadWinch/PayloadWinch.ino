// A winch that a plan can command on PX4 (ArduPilot does not forward it: docs/payload.md). It lowers its rope for five
// seconds, reports its progress, and then that it is done. Every second it sends a weight to the ground station.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr uint16_t kDoWinch = 42600;  // MAV_CMD_DO_WINCH: param 2 is the action, param 3 the length of rope [m]
constexpr float kByLength = 1;        // WINCH_RELATIVE_LENGTH_CONTROL; this winch has no other action
constexpr uint8_t kMotorPin = 9;
constexpr uint32_t kLoweringMs = 5000;

MissionClient autopilot(TELEM);
PayloadAnswer carryOut(void*, const PayloadCommand& command);
Payload payload(autopilot, carryOut);
NamedValue weight("weight");
uint32_t startedMs, toldMs;

PayloadAnswer carryOut(void*, const PayloadCommand& command) {
  if (command.id != kDoWinch) return PayloadAnswer::Unsupported;
  if (command.param[1] != kByLength || !(command.param[2] > 0)) return PayloadAnswer::Denied;
  if (payload.isBusy()) return PayloadAnswer::Rejected;
  digitalWrite(kMotorPin, HIGH);
  startedMs = millis();
  if (CONSOLE) {
    CONSOLE.print(F("lowering "));
    CONSOLE.print(command.param[2]);
    CONSOLE.println(F(" m of rope"));
  }
  return PayloadAnswer::InProgress;
}

void lower() {
  const uint32_t elapsedMs = millis() - startedMs;
  payload.progress(elapsedMs * 100 / kLoweringMs);
  if (elapsedMs < kLoweringMs) return;
  digitalWrite(kMotorPin, LOW);
  payload.finish(PayloadAnswer::Accepted);
  if (CONSOLE) CONSOLE.println(F("lowered"));
}

void tellWeight() {
  if (millis() - toldMs < 1000 || !autopilot.isSent()) return;
  weight.set(analogRead(A0) * 0.01f);  // [kg]
  if (autopilot.sendMessage(weight)) toldMs = millis();
}

void setup() {
  pinMode(kMotorPin, OUTPUT);
  CONSOLE.begin(115200);
  beginTelem(57600);
}

void loop() {
  autopilot.update();
  payload.update();
  if (payload.isBusy()) lower();
  tellWeight();
}
