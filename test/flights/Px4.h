// PX4 tells its mode once a second and on request, arms by MISSION_START, and names its plan by a checksum.
#pragma once

#include "Autopilot.h"

class Px4 : public Autopilot {
 public:
  using Autopilot::Autopilot;

 private:
  uint8_t command(const mavlink_command_long_t& command, bool isInt, uint32_t nowMs) override;
  uint8_t orderMode(uint16_t wanted, uint32_t nowMs) override;
  void hearTarget(uint32_t nowMs) override;
  void hearSetCurrent(uint16_t item, uint32_t nowMs) override;
  void modeChanged(uint32_t) override { hasLostStream_ = false; }
  void disarmed() override;
  uint8_t state() const override;
  uint32_t customMode() const override;
  FrameParts itemToRead(uint16_t item) const override;
  uint32_t planId() const override;
  int32_t heightGoal() const override;
  void atHeight(uint32_t nowMs) override;
  void beat(uint32_t nowMs) override;
  bool hasStream(uint32_t nowMs) const;
  uint8_t arm(bool arms);

  uint32_t streamedMs_ = 0;
  bool hasLostStream_ = false;
};
