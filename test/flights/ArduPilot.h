// ArduCopter and ArduRover: they send a heartbeat at each change of the mode and none at arming, and their plan has no
// checksum.
#pragma once

#include "Autopilot.h"

class ArduPilot : public Autopilot {
 public:
  using Autopilot::Autopilot;

 private:
  uint8_t command(const mavlink_command_long_t& command, bool isInt, uint32_t nowMs) override;
  uint8_t orderMode(uint16_t wanted, uint32_t nowMs) override;
  void hearSetCurrent(uint16_t item, uint32_t nowMs) override;
  void modeChanged(uint32_t nowMs) override { sendFresh(MAVLINK_MSG_ID_HEARTBEAT, nowMs + 3); }
  void disarmed() override { current_ = 0; }
  uint8_t state() const override;
  uint32_t customMode() const override { return mode; }
  FrameParts itemToRead(uint16_t item) const override;
  int32_t heightGoal() const override;
  void atHeight(uint32_t nowMs) override;
  uint8_t arm(bool arms);
};
