// An aircraft that carries out what a Steering beside it orders, on a line in memory, and what it is told word by word.
// The test says how it answers, and what somebody else does to it meanwhile.
#pragma once

#include <math.h>
#include <stdio.h>
#include <string.h>

#include <map>
#include <string>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

namespace steered {

// HEARTBEAT.custom_mode.
enum : uint32_t { kStabilize = 0, kAuto = 3, kGuided = 4, kLoiter = 5, kRtl = 6, kLand = 9 };  // ArduCopter
enum : uint32_t { kPlaneAuto = 10, kPlaneRtl = 11, kPlaneGuided = 15, kPlaneQRtl = 21 };
enum : uint32_t { kRoverHold = 4, kRoverAuto = 10, kRoverGuided = 15 };
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
// What becomes of a command beside its result.
enum : int { kSilent = -1, kUnheard = -2 };  // carried out without an answer; not even that

class Aircraft : public ClientOnLine {
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
  bool takesOff = true;      // when it is told to
  std::map<int, int> gives;  // by command: its result, or what becomes of it
  std::map<int, int> once;   // the same for the next one alone

  explicit Aircraft(uint8_t autopilot, uint8_t vehicleType = 2);

  virtual ~Aircraft() = default;

  // What else loop() does, before the client's update().
  virtual void loop() {}

  // On the ground, and found.
  Aircraft& stand(uint32_t inMode);
  // In the air, in this mode, and seen disarmed before.
  Aircraft& fly(uint32_t inMode);

  void forget();

  // As loop() does.
  void pass(uint32_t ms);
  // Until the operation has ended; with what.
  mavmission::Status end(uint32_t limitMs = 60000);
  // Until this command has been sent; false if it is not.
  bool passUntil(uint16_t command, uint32_t limitMs = 20000);

  // What was sent since the last call, without the heartbeats that were asked for.
  std::string said();
  std::vector<uint32_t> saidMs;  // when
  uint32_t asks = 0;             // for heartbeats
  uint32_t beganMs = 0, tookMs = 0;

  void beat();
  // Its mode becomes this one, and a heartbeat shows it.
  void show(uint32_t newMode);
  void tellPosition();
  void tellTarget(int32_t latitude, int32_t longitude, float altitude);
  void tellLanded();
  void answer(uint16_t command, uint8_t result);
  template <typename Message>
  void tell(uint16_t id, const Message& message, uint8_t crcExtra) {
    Bytes payload(sizeof(message));
    memcpy(payload.data(), &message, sizeof(message));
    hear(FrameParts(id, payload, crcExtra));
  }

 private:
  enum What : uint8_t { Beat, Position, Landed, Home, Answer };
  struct Due {
    What what;
    uint16_t command;
    uint8_t result;
  };

  static int atoiOf(const std::string& text) { return static_cast<int>(strtol(text.c_str() + 1, nullptr, 10)); }

  void one();
  void in(uint32_t ms, What what, uint16_t command = 0, uint8_t result = 0);

  void react(const SentFrame& frame);

  void carryOut(uint16_t command, const float* param);

  bool isPx4_;
  bool positions_ = false;
  std::multimap<uint32_t, Due> due_;
  std::vector<std::string> said_;
};

}  // namespace steered
