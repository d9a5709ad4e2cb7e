#include "SteeredAircraft.h"

#include <stdexcept>

namespace steered {

Aircraft::Aircraft(uint8_t autopilot, uint8_t vehicleType)
    : AnsweringPeer(autopilot), steering(client), type(vehicleType), isPx4_(autopilot == kPx4) {}

Aircraft& Aircraft::stand(uint32_t inMode) {
  mode = inMode;
  pass(3000);
  forget();
  return *this;
}

Aircraft& Aircraft::fly(uint32_t inMode) {
  if (client.firmware() == mavmission::Firmware::Unknown) stand(inMode);
  mode = inMode;
  isArmed = true;
  state = kActive;
  landed = 2;
  pass(1000);
  forget();
  return *this;
}

Aircraft& Aircraft::until(uint16_t command) {
  if (!passUntil(command)) throw std::runtime_error("never sent: " + std::to_string(command));
  return *this;
}

Aircraft& Aircraft::answering(uint16_t command, int result) {
  gives[command] = result;
  return *this;
}

Aircraft& Aircraft::silence(bool isSilent) {
  beatsBySecond = beatsWhenAsked = !isSilent;
  return *this;
}

Aircraft& Aircraft::atHeight(int32_t aboveHomeMm) {
  homeMm = aboveHomeMm;
  seaMm = 584000 + aboveHomeMm;
  tellPosition();
  return wait(2);
}

std::string Aircraft::how(uint32_t limitMs) {
  static const char* const kSteps[] = {"None", "AskLanded", "AskHome", "AskPosition", "Mode",
                                       "Arm",  "Command",   "Confirm", "Disarm",      "GiveBack"};
  const std::string ends = status(limitMs);
  return ends + " at " + kSteps[static_cast<uint8_t>(steering.step())] + ": " + said();
}

std::string Aircraft::status(uint32_t limitMs) { return nameOf(end(limitMs)); }

Aircraft& Aircraft::done() {
  if (end() != mavmission::Status::Done) throw std::runtime_error(std::string("not done: ") + nameOf(ended));
  return *this;
}

uint32_t Aircraft::times(const std::string& words) const {
  uint32_t found = 0;
  for (const std::string& one : said_) found += one.compare(0, words.size(), words) == 0;
  return found;
}

void Aircraft::forget() {
  sent.clear();
  said_.clear();
  saidMs.clear();
  asks = 0;
  ended = mavmission::Status::Idle;
}

void Aircraft::beat() {
  const uint8_t baseMode = isArmed ? 1 | 128 : 1;
  hear(heartbeatParts(isPx4_ ? kPx4 : kArduPilot, baseMode, mode, type, state));
}

void Aircraft::show(uint32_t newMode) {
  mode = newMode;
  beat();
  pass(1);
}

void Aircraft::tellPosition() {
  mavlink_global_position_int_t message = mavlink_global_position_int_t();
  message.lat = here.latitude.e7();
  message.lon = here.longitude.e7();
  message.alt = seaMm;
  message.relative_alt = homeMm;
  hear(FrameParts(MAVLINK_MSG_ID_GLOBAL_POSITION_INT, message));
}

void Aircraft::tellTarget(int32_t latitude, int32_t longitude, float altitude) {
  mavlink_position_target_global_int_t message = mavlink_position_target_global_int_t();
  message.lat_int = latitude;
  message.lon_int = longitude;
  message.alt = altitude;
  hear(FrameParts(MAVLINK_MSG_ID_POSITION_TARGET_GLOBAL_INT, message));
}

void Aircraft::tellLanded() {
  mavlink_extended_sys_state_t message = mavlink_extended_sys_state_t();
  message.landed_state = landed;
  message.vtol_state = vtol;
  hear(FrameParts(MAVLINK_MSG_ID_EXTENDED_SYS_STATE, message));
}

void Aircraft::one() {
  if (beatsBySecond && nowMs() % 1000 == 0) beat();
  if (positions_ && hasPosition && nowMs() % 500 == 20) tellPosition();
  passDue();
  const size_t before = sent.size();
  loop();
  run(1);
  for (size_t i = before; i < sent.size(); ++i) react(sent[i]);
}

void Aircraft::react(const SentFrame& frame) {
  float param[7];
  uint16_t command;
  char text[200];
  memcpy(param, frame.payload.data(), sizeof(param));
  if (frame.messageId == MAVLINK_MSG_ID_COMMAND_LONG) {
    command = messageIn<mavlink_command_long_t>(frame.payload).command;
    snprintf(text, sizeof(text), "L%d %g %g %g %g %g %g %g", command, double{param[0]}, double{param[1]},
             double{param[2]}, fabs(double{param[3]}), double{param[4]}, double{param[5]}, double{param[6]});
  } else if (frame.messageId == MAVLINK_MSG_ID_COMMAND_INT) {
    const mavlink_command_int_t message = messageIn<mavlink_command_int_t>(frame.payload);
    command = message.command;
    snprintf(text, sizeof(text), "I%d frame %d %g %g %g %g %d %d %g", command, int{message.frame}, double{param[0]},
             double{param[1]}, double{param[2]}, fabs(double{param[3]}), int{message.x}, int{message.y},
             double{float{message.z}});
  } else {
    return;
  }
  if (command == 512 && param[0] == 0) {
    ++asks;
    if (!beatsWhenAsked) return;
    in(24, [this] { answer(512, 0); });
    in(25, [this] { beat(); });
    return;
  }
  say(text);
  const int result = resultOf(command);
  if (result == kUnheard) return;
  if (result == 0 || result == kSilent) carryOut(command, param);
  if (result >= 0) in(30, [this, command, result] { answer(command, static_cast<uint8_t>(result)); });
}

void Aircraft::carryOut(uint16_t command, const float* param) {
  switch (command) {
    case 512:
      if (param[0] == 245.f && hasLanded) in(31, [this] { tellLanded(); });
      if (param[0] == 242.f && hasHome)
        in(31, [this] { hear(FrameParts(MAVLINK_MSG_ID_HOME_POSITION, mavlink_home_position_t())); });
      break;
    case 511: positions_ = true; break;
    case 176:
      mode = isPx4_ ? ofPx4(static_cast<uint32_t>(param[1]), static_cast<uint32_t>(param[2]))
                    : static_cast<uint32_t>(param[1]);
      break;
    case 400: isArmed = param[0] == 1.f; break;
    case 22:
      if (isPx4_) mode = kPx4TakeOff;
      if (!takesOff) break;
      state = kActive;
      landed = 3;  // it takes off
      break;
    case 192:
      if (param[1] == 1.f) mode = isPx4_ ? uint32_t{kPx4Hold} : type == 2 ? uint32_t{kGuided} : uint32_t{kRoverGuided};
      break;
    default: break;
  }
}

}  // namespace steered
