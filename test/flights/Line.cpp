#include "Line.h"

namespace {
constexpr uint32_t kByteUs = 174, kOnTheWayMs = 1;
}

void Line::occupy(size_t bytes, uint32_t nowMs) {
  const uint64_t nowUs = nowMs * 1000ull;
  if (freeUs_ < nowUs) freeUs_ = nowUs;
  freeUs_ += bytes * kByteUs;
}

void Line::send(const FrameParts& message, uint8_t vehicle, const Bytes& bytes, bool isRight, uint32_t nowMs,
                size_t sent) {
  occupy(bytes.size() - sent, nowMs);
  Due due = {nowMs, static_cast<uint32_t>(freeUs_ / 1000) + kOnTheWayMs, Bytes(), message, vehicle, isRight};
  const bool isLost = loseNext_ != 0;
  if (isLost) --loseNext_;
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
  due_.push_back(due);
}

int Line::waiting(uint32_t nowMs) const {
  const uint64_t nowUs = nowMs * 1000ull;
  return freeUs_ <= nowUs ? 0 : static_cast<int>((freeUs_ - nowUs + kByteUs - 1) / kByteUs);
}

Due Line::take() {
  Due due = due_.front();
  due_.pop_front();
  if (due.dueMs < cutUntilMs_) {
    due.bytes.clear();
    due.isWhole = false;
  }
  return due;
}
