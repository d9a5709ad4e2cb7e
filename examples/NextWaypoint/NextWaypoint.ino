// A soil probe: the plan lands in one field after the other. At each landing the probe works, then the Arduino sends the
// aircraft on to the next field.
//
// After a landing inside a plan the autopilot disarms. The Arduino takes the sample, makes the takeoff of the next leg the
// current item, and starts the plan again from there.
#include <MavMission.h>
using namespace mavmission;

#ifdef HAVE_HWSERIAL1
#define TELEM Serial1
#define CONSOLE Serial
#else
// An Uno and a Nano have one port, for the autopilot; the console is a USB-serial adapter on pin 11.
#include <SoftwareSerial.h>
SoftwareSerial console(10, 11);
#define TELEM Serial
#define CONSOLE console
#endif

// Each leg: take off, fly, land. The Arduino does the rest between them.
constexpr MissionItem legs[] PROGMEM = {
    takeoff(-35.3632621_deg, 149.1652374_deg, 10_m),
    waypoint(-35.3630000_deg, 149.1652374_deg, 10_m),
    land(-35.3630000_deg, 149.1652374_deg),
    takeoff(-35.3630000_deg, 149.1652374_deg, 10_m),
    waypoint(-35.3627000_deg, 149.1655000_deg, 10_m),
    land(-35.3627000_deg, 149.1655000_deg),
};
constexpr uint16_t kItems = sizeof(legs) / sizeof(legs[0]);
constexpr uint32_t kSampleMs = 5000;  // what the probe needs

MissionClient autopilot(TELEM);
MissionFollower mission(autopilot);

enum class Stage : uint8_t { Uploading, Going, Flying, Sampling, Selecting, Done };
Stage stage = Stage::Uploading;
uint16_t nextItem = 0;
uint32_t landedAtMs;

void setup() {
  CONSOLE.begin(115200);
  TELEM.begin(57600);
  autopilot.upload(inFlash(legs), Verified);
}

void onEnded(Status status) {
  CONSOLE.println(toString(status));
  if (stage == Stage::Uploading && status == Status::Accepted) {
    stage = Stage::Going;
    autopilot.start();
  } else if (stage == Stage::Going && status == Status::Done) {
    stage = Stage::Flying;
  } else if (stage == Stage::Selecting && status == Status::Done) {
    stage = Stage::Going;
    autopilot.start();
  } else {
    stage = Stage::Done;  // something was refused, and the words above say what: leave it to the pilot
  }
}

bool hasLanded() {
  const uint16_t reached = mission.reachedItem();
  return !autopilot.isArmed() && reached != MissionClient::kNoItem && reached >= nextItem && reached % 3 == 2;
}

void loop() {
  const Status status = autopilot.update();
  if (isEnd(status)) onEnded(status);
  if (stage == Stage::Flying && hasLanded()) {
    nextItem = mission.reachedItem() + 1;
    landedAtMs = millis();
    stage = nextItem < kItems ? Stage::Sampling : Stage::Done;
    CONSOLE.println(nextItem < kItems ? F("landed: sampling") : F("landed: done"));
  }
  if (stage == Stage::Sampling && millis() - landedAtMs >= kSampleMs) {
    stage = Stage::Selecting;
    autopilot.setCurrentItem(nextItem);
  }
}
