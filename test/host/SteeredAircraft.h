// An aircraft that carries out what a Steering beside it orders, on a line in memory, and what it is told word by word.
// The test says how it answers, and what somebody else does to it meanwhile.
#pragma once

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "AnsweringPeer.h"
#include "PlanFrames.h"
#include "mavmission/base/MavlinkHeaders.h"

namespace steered {

// HEARTBEAT.custom_mode.
enum : uint32_t { kStabilize = 0, kAuto = 3, kGuided = 4, kLoiter = 5, kRtl = 6, kLand = 9 };  // ArduCopter
enum : uint32_t { kPlaneAuto = 10, kPlaneRtl = 11, kPlaneGuided = 15, kPlaneQRtl = 21 };
enum : uint32_t { kRoverAuto = 10, kRoverGuided = 15 };
constexpr uint32_t ofPx4(uint32_t main, uint32_t sub) { return main << 16 | sub << 24; }
enum : uint32_t {
  kPx4Position = ofPx4(3, 0),
  kPx4TakeOff = ofPx4(4, 2),
  kPx4Hold = ofPx4(4, 3),
  kPx4Mission = ofPx4(4, 4),
  kPx4Rtl = ofPx4(4, 5),
  kPx4Land = ofPx4(4, 6),
  kPx4Offboard = ofPx4(6, 0)
};
enum : uint8_t { kStandby = 3, kActive = 4, kCritical = 5, kEmergency = 6 };
constexpr int kSilent = AnsweringPeer::kSilent, kUnheard = AnsweringPeer::kUnheard;

const mavmission::LatLon kThere = {mavmission::Degrees::fromE7(-353630000), mavmission::Degrees::fromE7(1491652374)};
constexpr char kDisarm[] = "L400 0 0 0 0 0 0 0";

class Aircraft : public AnsweringPeer {
 public:
  mavmission::Steering steering;

  uint8_t type;
  uint32_t mode = 0;
  bool isArmed = false;
  uint8_t state = kStandby;
  uint8_t landed = 1;  // MAV_LANDED_STATE
  uint8_t vtol = 0;    // MAV_VTOL_STATE
  mavmission::LatLon here = {mavmission::Degrees::fromE7(-353632621), mavmission::Degrees::fromE7(1491652374)};
  int32_t seaMm = 584000, homeMm = 0;
  bool hasHome = true, hasPosition = true, hasLanded = true, beatsWhenAsked = true, beatsBySecond = true;
  bool takesOff = true;  // when it is told to

  explicit Aircraft(uint8_t autopilot, uint8_t vehicleType = 2);

  // What else loop() does, before the client's update().
  virtual void loop() {}

  // What happens, one after the other. On the ground, and found...
  Aircraft& stand(uint32_t inMode);
  Aircraft& stand() { return stand(isPx4_ ? uint32_t{kPx4Mission} : uint32_t{kStabilize}); }
  // In the air, in this mode, and seen disarmed before.
  Aircraft& fly(uint32_t inMode);
  Aircraft& inMission() { return fly(isPx4_ ? uint32_t{kPx4Mission} : type == 10 ? uint32_t{kRoverAuto} : kAuto); }
  Aircraft& wait(uint32_t ms) {
    pass(ms);
    return *this;
  }
  Aircraft& until(uint16_t command);  // has been sent
  Aircraft& answering(uint16_t command, int result = AnsweringPeer::kUnheard);
  Aircraft& silence(bool isSilent = true);  // no heartbeat comes
  Aircraft& atHeight(int32_t aboveHomeMm);  // it tells
  // The orders of the sketch.
  Aircraft& takeOff(mavmission::Metres height = mavmission::Metres(20)) { return having(steering.takeOff(height)); }
  Aircraft& goTo(mavmission::Altitude altitude = mavmission::Metres(20)) { return goTo(kThere, altitude); }
  Aircraft& goTo(const mavmission::LatLon& place, mavmission::Altitude altitude) {
    return having(steering.goTo(place, altitude));
  }
  Aircraft& setSpeed(float speed) { return having(steering.setSpeed(mavmission::MetresPerSecond(speed))); }
  Aircraft& pause() { return having(steering.pause()); }
  Aircraft& resume() { return having(steering.resume()); }
  Aircraft& returnHome() { return having(steering.returnHome()); }
  Aircraft& landNow() { return having(steering.landNow()); }
  // How the order ends, in which step, and what was sent.
  std::string how(uint32_t limitMs = 60000);
  // The same in a line that is no more than its status.
  std::string status(uint32_t limitMs = 60000);
  // It has to be done.
  Aircraft& done();
  // How often a command that begins so was sent since the last said().
  uint32_t times(const std::string& words) const;

  void forget();

  // Until this command has been sent; false if it is not.
  bool passUntil(uint16_t command, uint32_t limitMs = 20000) {
    return AnsweringPeer::passUntil(std::to_string(command) + " ", 1, limitMs);
  }
  using AnsweringPeer::passUntil;

  uint32_t asks = 0;  // for heartbeats, which are not said

  void beat();
  // Its mode becomes this one, and a heartbeat shows it.
  void show(uint32_t newMode);
  void tellPosition();
  void tellTarget(int32_t latitude, int32_t longitude, float altitude);
  void tellLanded();
  void answer(uint16_t command, uint8_t result) { hear(commandAckParts(command, result)); }

 private:
  // The same aircraft, with an order begun.
  Aircraft& having(mavmission::Status) { return *this; }
  void one() override;
  void react(const SentFrame& frame);

  void carryOut(uint16_t command, const float* param);

  bool isPx4_;
  bool positions_ = false;
};

}  // namespace steered
