#include "Signing.h"

#include <string.h>

namespace mavmission {
namespace detail {

void Signing::begin(const SigningKey& key, uint8_t linkId, const TimestampStore& store) {
  store_ = store;
  key_ = key;
  linkId_ = linkId;
  // All reserved times may have been used before the reset. Times must be reserved again before they are used.
  const SigningTime kept = {store.load(store.context), 0};
  moveTo(kept);
  reserved_ = time_.high;
  saving_ = 0;
  hasMoved_ = false;
  job_ = Job::None;
}

void Signing::moveTo(const SigningTime& time) {
  if (!time_.isBefore(time)) return;
  time_ = time;
  hasMoved_ = true;
}

void Signing::keepTime() {
  if (saving_ == 0 || !store_.save(store_.context, saving_)) return;
  reserved_ = saving_;
  saving_ = 0;
}

bool Signing::maySign() {
  SigningTime next = time_;
  next.advance();
  // Reserves early enough for signing not to wait, but not before something is to be signed.
  const bool isDue = next.high >= reserved_ || (hasMoved_ && next.high + kReserveLeft >= reserved_);
  if (isDue && saving_ == 0) {
    saving_ = next.high + (hasMoved_ ? kReserve : kLeastReserve);
    hasMoved_ = false;
  }
  return next.high < reserved_;
}

void Signing::sign(const Piece* pieces, uint8_t count) {
  pieces_[0] = Piece{key_.bytes, SigningKey::kLength};
  for (uint8_t i = 0; i < kPieces; ++i) pieces_[1 + i] = i < count ? pieces[i] : Piece{nullptr, 0};
  Piece& last = pieces_[count];
  uint8_t* const signature = const_cast<uint8_t*>(last.bytes) + last.length;
  last.length += kLinkAndTime;
  time_.advance();
  signature[0] = linkId_;
  time_.write(signature + 1);
  toFill_ = signature + kLinkAndTime;
  start(Job::Signing);
}

bool Signing::check(const uint8_t* frame, uint16_t length, uint8_t systemId, uint8_t componentId,
                    const uint8_t* signature) {
  // The cheap check comes first: a replay is not worth hashing.
  if (!isTimely(streamOf(systemId, componentId, signature[0]), SigningTime::read(signature + 1))) return false;
  systemId_ = systemId;
  componentId_ = componentId;
  signature_ = signature;
  pieces_[0] = Piece{key_.bytes, SigningKey::kLength};
  pieces_[1] = Piece{frame, length};
  pieces_[2] = Piece{signature, kLinkAndTime};
  pieces_[3] = Piece{nullptr, 0};
  start(Job::Checking);
  return true;
}

Signing::Stream* Signing::streamOf(uint8_t systemId, uint8_t componentId, uint8_t linkId) {
  for (Stream& stream : streams_) {
    if (!stream.time.isNone() && stream.systemId == systemId && stream.componentId == componentId &&
        stream.linkId == linkId) {
      return &stream;
    }
  }
  return nullptr;
}

Signing::Stream* Signing::freeStream() {
  for (Stream& stream : streams_) {
    if (stream.time.isNone() || stream.time.aMinuteLater().isBefore(time_)) return &stream;
  }
  return nullptr;
}

// Counts the frames that it refuses.
bool Signing::isTimely(Stream* stream, const SigningTime& time) {
  if (stream != nullptr) {
    if (stream->time.isBefore(time)) return true;
    ++counters_.replayed;
    return false;
  }
  if (time.isNone() || time.aMinuteLater().isBefore(time_)) {
    ++counters_.old;
    return false;
  }
  if (freeStream() != nullptr) return true;
  ++counters_.tooManyStreams;
  return false;
}

void Signing::start(Job job) {
  job_ = job;
  piece_ = 0;
  finished_ = false;
  sum_.begin();
}

// True when the hash is complete.
bool Signing::hash(uint8_t rounds) {
  if (sum_.isReady()) fill();
  if (!sum_.work(rounds)) return false;
  if (finished_) return true;
  fill();
  return false;
}

// Fills a block.
void Signing::fill() {
  for (; piece_ <= kPieces; ++piece_) {
    Piece& piece = pieces_[piece_];
    const uint16_t taken = sum_.add(piece.bytes, piece.length);
    piece.bytes += taken;
    piece.length -= taken;
    if (!sum_.isReady()) return;
  }
  sum_.finish();
  finished_ = true;
}

Signing::Done Signing::work(uint8_t rounds) {
  if (job_ == Job::None || !hash(rounds)) return Done::Nothing;
  const bool isSigning = job_ == Job::Signing;
  job_ = Job::None;
  if (!isSigning) return finishChecking();
  for (uint8_t i = 0; i < kSum; ++i) toFill_[i] = sum_.digest(i);
  return Done::Signed;
}

Signing::Done Signing::finishChecking() {
  // Compares all bytes, whatever the first ones are, so that the time does not tell how many were right.
  uint8_t difference = 0;
  for (uint8_t i = 0; i < kSum; ++i) difference |= sum_.digest(i) ^ signature_[kLinkAndTime + i];
  if (difference != 0) {
    ++counters_.wrong;
    return Done::Refused;
  }
  // Only now, so that nobody without the key can change a time.
  const SigningTime time = SigningTime::read(signature_ + 1);
  const uint8_t linkId = signature_[0];
  Stream* stream = streamOf(systemId_, componentId_, linkId);
  if (stream == nullptr) stream = freeStream();
  if (stream == nullptr) return Done::Refused;  // cannot happen: check() found one before
  stream->time = time;
  stream->systemId = systemId_;
  stream->componentId = componentId_;
  stream->linkId = linkId;
  moveTo(time);
  ++counters_.accepted;
  return Done::Accepted;
}

}  // namespace detail

SigningKey keyFromPassphrase(const char* passphrase) {
  detail::Sha256 sum;
  sum.begin();
  if (passphrase != nullptr) {
    uint16_t left = static_cast<uint16_t>(strlen(passphrase));
    while (left != 0) {
      const uint16_t taken = sum.add(reinterpret_cast<const uint8_t*>(passphrase), left);
      passphrase += taken;
      left -= taken;
      while (!sum.work(detail::Sha256::kRounds)) {
      }
    }
  }
  sum.finish();
  while (!sum.work(detail::Sha256::kRounds)) {
  }
  SigningKey key;
  for (uint8_t i = 0; i < SigningKey::kLength; ++i) key.bytes[i] = sum.digest(i);
  return key;
}

}  // namespace mavmission
