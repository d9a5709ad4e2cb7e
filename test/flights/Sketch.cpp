#include "Sketch.h"

using namespace mavmission;

namespace {

constexpr uint16_t kWaitS = 20;       // for an autopilot, where it would wait for ever
constexpr uint32_t kFollowMs = 4000;  // after this the sketch calls stop()

// Returns a place so many 1e-7 degrees north of home.
LatLon placeNorth(int32_t e7) { return LatLon{Degrees::fromE7(-353632621 + e7), Degrees::fromE7(1491652374)}; }

MissionItem waypointNorth(int32_t e7) {
  const LatLon place = placeNorth(e7);
  return waypoint(place.latitude, place.longitude, 10_m);
}

const MissionItem* plan(Kind kind) {
  static const MissionItem flown[] = {takeoff(10_m), waypointNorth(40000), waypointNorth(80000), waypointNorth(90000)};
  return kind == Kind::Rover ? flown + 1 : flown;
}

}  // namespace

Sketch::Sketch(Kind kind) : client(line), follower(client), steering(client), target(steering), kind_(kind) {}

Status Sketch::take(Status begun) {
  status_ = begun;
  isRunning_ = !isEnd(begun);
  return begun;
}

void Sketch::name(uint8_t systemId, Kind kind) {
  kind_ = kind;
  client.setTargetIds(systemId, 1);
}

Status Sketch::begin(Task task) {
  task_ = task;
  followedMs_ = 0;
  client.setAutopilotTimeout(task == Task::Upload || task == Task::Clear || task == Task::VerifyAndStart ? kWaitS : 0);
  const LatLon place = placeNorth(9000);
  switch (task) {
    case Task::Start: return take(client.start());
    case Task::VerifyAndStart: return take(client.verifyAndStart(inRam(plan(kind_), kItems)));
    case Task::TakeOff: return take(steering.takeOff(5_m));
    case Task::GoTo: return take(steering.goTo(place, 20_m));
    case Task::Pause: return take(steering.pause());
    case Task::Resume: return take(steering.resume());
    case Task::ReturnHome: return take(steering.returnHome());
    case Task::LandNow: return take(steering.landNow());
    case Task::Follow: return take(target.start(place, 20_m));
    case Task::Arm: return take(client.arm());
    case Task::Disarm: return take(client.disarm());
    case Task::StartMission: return take(client.startMission());
    case Task::Upload: return take(client.upload(inRam(plan(kind_), kItems)));
    case Task::Clear: return take(client.clear());
    case Task::SetMode: return take(client.setMode(kind_ == Kind::Px4 ? FlightMode::Hold : FlightMode::Guided));
  }
  return Status::Idle;
}

bool Sketch::loop(uint32_t nowMs) {
  setMillis(nowMs);
  if (isRunning_ && target.status() == Status::Transferring) {
    target.renew(placeNorth(9000 + static_cast<int32_t>(nowMs % 100)), 20_m);
  }
  if (target.isFollowed() && followedMs_ == 0) followedMs_ = nowMs;
  if (followedMs_ != 0 && nowMs - followedMs_ >= kFollowMs) target.stop();
  const Status followed = target.update();
  const Status status = client.update();
  if (!isRunning_) return false;
  const Status ended = task_ == Task::Follow ? followed : status;
  if (!isEnd(ended)) return false;
  status_ = ended;
  isRunning_ = false;
  return true;
}

uint16_t modeOfLanding(Kind kind, Task task) {
  if (kind != Kind::Rover) return modeOf(kind, Means::Land);
  return modeOf(kind, task == Task::Pause || task == Task::Follow ? Means::First : Means::Hold);
}

uint16_t modeWanted(Kind kind, Task task) {
  const bool isPx4 = kind == Kind::Px4;
  switch (task) {
    case Task::Start:
    case Task::VerifyAndStart:
    case Task::Resume:
    case Task::StartMission: return modeOf(kind, Means::Mission);
    case Task::TakeOff: return modeOf(kind, isPx4 ? Means::TakeOff : Means::Guided);
    case Task::GoTo:
    case Task::Pause:
    case Task::SetMode: return modeOf(kind, isPx4 ? Means::Hold : Means::Guided);
    case Task::ReturnHome: return modeOf(kind, Means::Return);
    case Task::LandNow: return modeOf(kind, Means::Land);
    case Task::Follow: return modeOf(kind, isPx4 ? Means::Hold : Means::Guided);
    case Task::Arm:
    case Task::Disarm:
    case Task::Upload:
    case Task::Clear: break;
  }
  return kNoSuchMode;
}
