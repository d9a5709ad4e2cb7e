// Signs, checks and hashes what lines on its input tell it, and answers each with a line: simulation/signing_program.py
// is the other end. Bytes are in hexadecimal, "-" for none.
#include "mavmission/signing/Signing.h"

#include <stdio.h>
#include <string.h>

#include <iostream>
#include <sstream>
#include <string>
#include <vector>

using namespace mavmission;
using namespace mavmission::detail;

namespace {

typedef std::vector<uint8_t> Bytes;

Bytes fromHex(const std::string& text) {
  Bytes bytes;
  if (text == "-") return bytes;
  for (size_t i = 0; i + 1 < text.size(); i += 2)
    bytes.push_back(static_cast<uint8_t>(std::stoul(text.substr(i, 2), nullptr, 16)));
  return bytes;
}

std::string toHex(const uint8_t* bytes, size_t count) {
  std::string text;
  char digits[3];
  for (size_t i = 0; i < count; ++i) {
    snprintf(digits, sizeof digits, "%02x", bytes[i]);
    text += digits;
  }
  return text;
}

// A store that takes so many calls to save; what it holds survives begin(), as over a reset.
uint32_t kept;
unsigned callsToSave = 1, callsLeft = 1, saves;

uint32_t loadKept(void*) { return kept; }

bool saveKept(void*, uint32_t time) {
  if (--callsLeft != 0) return false;
  callsLeft = callsToSave;
  kept = time;
  ++saves;
  return true;
}

Signing signing;
unsigned roundsAtOnce = Sha256::kRoundsAtOnce;

// How many calls of work() it took.
Signing::Done finish(unsigned& calls) {
  for (calls = 1;; ++calls) {
    const Signing::Done done = signing.work(static_cast<uint8_t>(roundsAtOnce));
    if (done != Signing::Done::Nothing) return done;
  }
}

// bytes, and the numbers of bytes to offer and of rounds to do at a time, over and over.
std::string hash(std::istringstream& words) {
  std::string text;
  words >> text;
  const Bytes bytes = fromHex(text);
  std::vector<unsigned> pattern;
  unsigned number;
  while (words >> number) pattern.push_back(number);
  size_t step = 0, position = 0;
  Sha256 sum;
  sum.begin();
  while (position != bytes.size()) {
    const size_t offered = std::min<size_t>(pattern[step++ % pattern.size()], bytes.size() - position);
    position += sum.add(bytes.data() + position, static_cast<uint16_t>(offered));
    while (!sum.work(static_cast<uint8_t>(Sha256::kRoundsAtOnce * (1 + step++ % 8)))) {
    }
  }
  sum.finish();
  while (!sum.work(Sha256::kRoundsAtOnce)) {
  }
  uint8_t digest[Sha256::kDigest];
  for (uint8_t i = 0; i < Sha256::kDigest; ++i) digest[i] = sum.digest(i);
  return toHex(digest, sizeof digest);
}

// key, link id.
std::string begin(std::istringstream& words) {
  std::string text;
  unsigned link;
  words >> text >> link;
  const Bytes bytes = fromHex(text);
  SigningKey key;
  memcpy(key.bytes, bytes.data(), sizeof key.bytes);
  memset(static_cast<void*>(&signing), 0, sizeof signing);
  callsLeft = callsToSave;
  signing.begin(key, static_cast<uint8_t>(link), TimestampStore{loadKept, saveKept, nullptr});
  return "ok";
}

// A frame with its flag set and its checksum right, and where to cut it into two pieces.
std::string sign(std::istringstream& words) {
  std::string text;
  size_t cut = 0;
  words >> text >> cut;
  const Bytes frame = fromHex(text);
  unsigned waited = 0;
  while (!signing.maySign()) {
    signing.keepTime();
    if (++waited > 1000) return "never";
  }
  signing.keepTime();
  Bytes first(frame.begin(), frame.begin() + static_cast<long>(cut)),
      second(frame.begin() + static_cast<long>(cut), frame.end());
  const size_t length = second.size();
  second.resize(length + Signing::kLength);
  const Signing::Piece pieces[2] = {
      {first.data(), static_cast<uint16_t>(cut)},
      {second.data(), static_cast<uint16_t>(length)},
  };
  signing.sign(cut == 0 ? pieces + 1 : pieces, cut == 0 ? 1 : 2);
  unsigned calls;
  if (finish(calls) != Signing::Done::Signed) return "not signed";
  return toHex(second.data() + length, Signing::kLength) + " " + std::to_string(calls);
}

// A frame with its signature.
std::string check(std::istringstream& words) {
  std::string text;
  words >> text;
  const Bytes bytes = fromHex(text);
  const size_t length = bytes.size() - Signing::kLength;
  // Each in memory of its own, so that a byte read beyond it is noticed.
  const Bytes frame(bytes.begin(), bytes.begin() + static_cast<long>(length)),
      signature(bytes.begin() + static_cast<long>(length), bytes.end());
  if (!signing.check(frame.data(), static_cast<uint16_t>(length), frame[5], frame[6], signature.data()))
    return "refused";
  unsigned calls;
  return finish(calls) == Signing::Done::Accepted ? "accepted" : "refused";
}

std::string counters() {
  const SigningCounters& seen = signing.counters();
  std::ostringstream text;
  text << seen.accepted << ' ' << seen.wrong << ' ' << seen.replayed << ' ' << seen.old << ' ' << seen.tooManyStreams;
  return text.str();
}

std::string time() {
  return std::to_string(static_cast<uint64_t>(signing.time().high) << 16 | signing.time().low) + " " +
         std::to_string(kept) + " " + std::to_string(saves);
}

std::string answer(const std::string& line) {
  std::istringstream words(line);
  std::string word;
  words >> word;
  if (word == "hash") return hash(words);
  if (word == "begin") return begin(words);
  if (word == "sign") return sign(words);
  if (word == "check") return check(words);
  if (word == "counters") return counters();
  if (word == "time") return time();
  if (word == "passphrase") {
    std::string text;
    std::getline(words >> std::ws, text);
    return toHex(keyFromPassphrase(text.c_str()).bytes, SigningKey::kLength);
  }
  unsigned long number = 0;
  words >> number;
  if (word == "kept")
    kept = static_cast<uint32_t>(number);
  else if (word == "slow")
    callsToSave = callsLeft = static_cast<unsigned>(number);
  else if (word == "rounds")
    roundsAtOnce = static_cast<unsigned>(number);
  else if (word == "clock")
    signing.setTime(SigningTime::atUnixTime(static_cast<uint32_t>(number)));
  else
    return "what?";
  return "ok";
}

}  // namespace

int main() {
  std::string line;
  while (std::getline(std::cin, line)) std::cout << answer(line) << std::endl;
}
