// A soil probe: the aircraft lands in one field after another. After each landing the probe takes its sample, then the
// Arduino sends the aircraft to the next field.
//
// Each leg is a separate plan, which the autopilot flies to its end even if the Arduino fails. At its end Copter and
// PX4 land and disarm; a rover stays armed, and the sketch disarms it. With BY_COMMANDS each leg is three commands
// instead, and nothing is uploaded: take off, go there, land. If the Arduino fails, a copter then waits in the air for
// the next command. TAKE OFF THE PROPELLERS WHILE YOU TRY IT.
#ifndef BY_COMMANDS
#define BY_COMMANDS 0
#endif
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr LatLon kStart = {-35.3632621_deg, 149.1652374_deg};
constexpr LatLon fields[] = {
    {-35.3631000_deg, 149.1652374_deg},
    {-35.3631000_deg, 149.1654000_deg},
};
constexpr uint8_t kFields = sizeof(fields) / sizeof(fields[0]);
constexpr Metres kHeight = 10_m;
constexpr uint32_t kSampleMs = 5000;  // the time that the probe needs

MissionClient autopilot(TELEM);
MissionFollower mission(autopilot);

enum class Stage : uint8_t { Uploading, Starting, Climbing, Crossing, Flying, Sampling, Done };
Stage stage = Stage::Uploading;
uint8_t field;
bool saysComplete;     // the text that a rover sends at the end of its mission has come
uint32_t notOverAtMs;  // when the leg was last known to be under way
uint32_t landedAtMs;

#if BY_COMMANDS
Steering steering(autopilot);

void beginLeg() {
  stage = Stage::Starting;
  steering.takeOff(kHeight);
}

// The commands after the takeoff.
void goOnWithLeg() {
  if (autopilot.isBusy() || !steering.hasArrived()) return;
  if (stage == Stage::Climbing) {
    stage = Stage::Crossing;
    steering.goTo(fields[field], kHeight);
  } else if (stage == Stage::Crossing) {
    stage = Stage::Flying;
    steering.landNow();
  }
}
#else
// Takes off where the aircraft stands, flies to the field, lands there.
bool legItem(void*, uint16_t index, MissionItem& item) {
  const LatLon& from = field == 0 ? kStart : fields[field - 1];
  const LatLon& to = fields[field];
  item = index == 0   ? takeoff(from.latitude, from.longitude, kHeight)
         : index == 1 ? waypoint(to.latitude, to.longitude, kHeight)
                      : land(to.latitude, to.longitude);
  return true;
}

void beginLeg() {
  stage = Stage::Uploading;
  autopilot.upload(fromFunction(legItem, 3), Readback::Always);
}

void goOnWithLeg() {}
#endif

void onText(void*, uint8_t, const char* text) {
  CONSOLE.print(F("autopilot: "));
  CONSOLE.println(text);
  if (strcmp_P(text, PSTR("Mission Complete")) == 0) saysComplete = true;
}

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  mission.onText(onText);
  beginLeg();
}

void onEnded(Status status) {
  CONSOLE.println(toString(status));
  if (stage == Stage::Uploading && status == Status::Accepted) {
    stage = Stage::Starting;
    saysComplete = false;
    autopilot.start();
  } else if (stage == Stage::Starting && status == Status::Done) {
    stage = BY_COMMANDS ? Stage::Climbing : Stage::Flying;
  } else if ((stage == Stage::Flying || stage == Stage::Crossing) && status == Status::Done) {
    return;  // disarmed, which loop() notices; or the leg is being flown
  } else {
    stage = Stage::Done;  // something was refused, as printed above: leave the aircraft to the pilot
  }
}

void loop() {
  const Status status = autopilot.update();
  if (isEnd(status)) onEnded(status);
  goOnWithLeg();
  if (stage == Stage::Flying && autopilot.hasAutopilot() && !autopilot.isBusy()) {
    const bool isOver = saysComplete || mission.state() == MissionState::Complete;
    if (!isOver) notOverAtMs = millis();
    if (!autopilot.isArmed()) {
      CONSOLE.println(F("landed: sampling"));
      landedAtMs = millis();
      stage = Stage::Sampling;
    } else if (millis() - notOverAtMs >= 5000) {
      notOverAtMs = millis();
      autopilot.disarm();
    }
  }
  if (stage == Stage::Sampling && millis() - landedAtMs >= kSampleMs) {
    ++field;
    if (field < kFields) {
      beginLeg();
    } else {
      CONSOLE.println(F("all fields sampled"));
      stage = Stage::Done;
    }
  }
}
