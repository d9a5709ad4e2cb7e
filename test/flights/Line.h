// A serial line of 57600 baud in one direction: frames take their time one behind the other, and some may be lost.
#pragma once

#include <algorithm>
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
            size_t sent = 0) {
    occupy(bytes.size() - sent, nowMs);
    Due due = {nowMs, static_cast<uint32_t>(freeUs_ / 1000) + kOnTheWayMs, Bytes(), message, vehicle, isRight};
    const bool isLost = loseNext_ != 0;
    if (isLost) --loseNext_;
    due.bytes.reserve(bytes.size());
    for (uint8_t byte : bytes) {
      const bool isByteLost = loss_ > 0 && static_cast<double>(random_()) < loss_ * static_cast<double>(random_.max());
      if (isLost || isByteLost) {
        due.isWhole = false;
      } else {
        due.bytes.push_back(byte);
      }
    }
    // (Without its last byte alone, a frame may take the first byte of the next one for it.)
    if (!due.isWhole && !due.bytes.empty() && due.bytes.size() + 1 == bytes.size()) due.bytes.pop_back();
    due_.push_back(std::move(due));
  }
  // Sends the beginning of a frame; the rest of it comes with send().
  void occupy(size_t bytes, uint32_t nowMs) {
    freeUs_ = std::max<uint64_t>(freeUs_, nowMs * 1000ull) + bytes * kByteUs;
  }
  // Returns how many bytes wait to go out.
  int waiting(uint32_t nowMs) const {
    const uint64_t nowUs = nowMs * 1000ull;
    return freeUs_ <= nowUs ? 0 : static_cast<int>((freeUs_ - nowUs + kByteUs - 1) / kByteUs);
  }
  // Loses everything that would arrive before this time.
  void cutUntil(uint32_t untilMs) { cutUntilMs_ = untilMs; }
  void loseNext(unsigned frames) { loseNext_ = frames; }
  void setLoss(double perByte) { loss_ = perByte; }

  bool isDue(uint32_t nowMs) const { return !due_.empty() && due_.front().dueMs <= nowMs; }
  uint32_t nextMs() const { return due_.empty() ? 0xFFFFFFFFu : due_.front().dueMs; }
  Due take() {
    Due due = std::move(due_.front());
    due_.pop_front();
    if (due.dueMs < cutUntilMs_) {
      due.bytes.clear();
      due.isWhole = false;
    }
    return due;
  }

 private:
  static constexpr uint32_t kByteUs = 174, kOnTheWayMs = 1;

  std::mt19937 random_;
  double loss_;
  uint64_t freeUs_ = 0;  // when the line has sent everything
  uint32_t cutUntilMs_ = 0;
  unsigned loseNext_ = 0;
  std::deque<Due> due_;
};
