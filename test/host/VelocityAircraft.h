// An aircraft that a VelocityTarget steers beside its Steering, and the velocities that leave.
#pragma once

#include <stdexcept>

#include "SteeredAircraft.h"

namespace steered {

typedef mavlink_set_position_target_local_ned_t VelocityMessage;
enum : uint16_t { kVelocity = 84 };

constexpr mavmission::EarthVelocity earth(float north, float east, float up = 0) {
  return mavmission::EarthVelocity(mavmission::MetresPerSecond(north), mavmission::MetresPerSecond(east),
                                   mavmission::MetresPerSecond(up));
}
constexpr mavmission::BodyVelocity body(float forward, float right = 0, float up = 0) {
  return mavmission::BodyVelocity(mavmission::MetresPerSecond(forward), mavmission::MetresPerSecond(right),
                                  mavmission::MetresPerSecond(up));
}

class VelocityAircraft : public Aircraft {
 public:
  mavmission::VelocityTarget velocity;

  explicit VelocityAircraft(uint8_t autopilot = kArduPilot, uint8_t vehicleType = 2)
      : Aircraft(autopilot, vehicleType), velocity(steering) {}
  void loop() override { velocity.update(); }

  // It flies its mission, and is taken over with this velocity.
  VelocityAircraft& begin(const mavmission::Velocity& first) {
    inMission();
    velocity.start(first);
    done();
    if (!velocity.isFlown()) throw std::runtime_error("not flown");
    pass(250);
    return *this;
  }
  // The velocities that have left since `sent` was emptied.
  std::vector<VelocityMessage> messages() const {
    std::vector<VelocityMessage> found;
    for (const SentFrame& frame : sent) {
      if (frame.messageId != kVelocity) continue;
      VelocityMessage message;
      memcpy(&message, frame.payload.data(), sizeof(message));
      found.push_back(message);
    }
    return found;
  }
  // The last one: "earth 1 2 -3, yaw 0, turn 0, mask 0x5c7". What the mask leaves out is 0.
  std::string last() const {
    const std::vector<VelocityMessage> all = messages();
    if (all.empty()) return "";
    const VelocityMessage& it = all.back();
    const char* frame = it.coordinate_frame == MAV_FRAME_LOCAL_NED  ? "earth"
                        : it.coordinate_frame == MAV_FRAME_BODY_NED ? "body"
                                                                    : "another frame";
    char text[120];
    snprintf(text, sizeof(text), "%s %g %g %g, yaw %.5g, turn %.5g, mask 0x%x", frame, double{float{it.vx}},
             double{float{it.vy}}, double{float{it.vz}}, double{float{it.yaw}}, double{float{it.yaw_rate}},
             unsigned{it.type_mask});
    return text;
  }
  // The same, of what it flies now.
  std::string flown(const mavmission::Velocity& now) {
    if (velocity.renew(now) != mavmission::Status::Transferring) return "refused";
    sent.clear();
    pass(450);
    return last();
  }
};

}  // namespace steered
