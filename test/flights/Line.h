// A serial line of 57600 baud in one direction: frames take their time one behind the other, and some may be lost.
#pragma once

#include <deque>
#include <random>

#include "PlanFrames.h"
#include "mavmission/base/MavlinkHeaders.h"

struct Due {
  uint32_t leftMs;  // when its last byte has left the sender
  uint32_t dueMs;   // when its last byte arrives
  Bytes bytes;      // what arrives of the frame
  FrameParts message;
  uint8_t vehicle;  // which one sends it
  bool isWhole;
};

class Line {
 public:
  Line(uint32_t seed, double lossPerByte) : random_(seed), loss_(lossPerByte) {}

  // Sends a frame, of which `sent` bytes have gone out already.
  void send(const FrameParts& message, uint8_t vehicle, const Bytes& bytes, bool isRight, uint32_t nowMs,
            size_t sent = 0);
  // Sends the beginning of a frame; the rest of it comes with send().
  void occupy(size_t bytes, uint32_t nowMs);
  // Returns how many bytes wait to go out.
  int waiting(uint32_t nowMs) const;
  // Loses everything that would arrive before this time.
  void cutUntil(uint32_t untilMs) { cutUntilMs_ = untilMs; }
  void loseNext(unsigned frames) { loseNext_ = frames; }
  void setLoss(double perByte) { loss_ = perByte; }

  bool isDue(uint32_t nowMs) const { return !due_.empty() && due_.front().dueMs <= nowMs; }
  uint32_t nextMs() const { return due_.empty() ? 0xFFFFFFFFu : due_.front().dueMs; }
  Due take();

 private:
  std::mt19937 random_;
  double loss_;
  uint64_t freeUs_ = 0;  // when the line has sent everything
  uint32_t cutUntilMs_ = 0;
  unsigned loseNext_ = 0;
  std::deque<Due> due_;
};
