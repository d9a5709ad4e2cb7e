// A peer that looks every millisecond for what a client asks, answers it, and says in words what it was.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "ClientOnLine.h"
#include "Names.h"

class AnsweringPeer : public ClientOnLine {
 public:
  enum : int { kSilent = -1, kUnheard = -2 };  // a request is done without an answer; not even that

  std::map<int, int> gives;  // by request: its result, or what becomes of it; 0: it is done
  std::map<int, int> once;   // the same for the next one alone
  std::vector<uint32_t> saidMs;
  uint32_t beganMs = 0, tookMs = 0;  // of the last end()

  explicit AnsweringPeer(uint8_t autopilot) : ClientOnLine(autopilot) { beats = false; }
  virtual ~AnsweringPeer() = default;

  // As loop() does.
  void pass(uint32_t ms) {
    for (; ms != 0; --ms) one();
  }
  // Until the operation has ended; with what.
  mavmission::Status end(uint32_t limitMs = 60000);
  // Until this, or what begins so, has been asked for; false if it is not.
  bool passUntil(const std::string& words, uint32_t limitMs = 20000) { return passUntil(words, 0, limitMs); }
  // Until a frame of this message has left; false if none does. `sent` begins anew.
  bool passUntilSent(uint16_t messageId, uint32_t limitMs = 20000);
  // What was asked for since the last call.
  std::string said();

  // A frame as it would be with its checksum right.
  static Bytes packedAgain(const SentFrame& frame, uint8_t crcExtra);

 protected:
  // A millisecond.
  virtual void one() = 0;
  void say(const std::string& words);
  // So many ms from now this happens: with the next passDue() then.
  void in(uint32_t ms, const std::function<void()>& what) { due_.insert({nowMs() + ms, what}); }
  void passDue();
  // As passUntil(), of words without so many letters in front.
  bool passUntil(const std::string& words, size_t from, uint32_t limitMs);
  // What becomes of a request.
  int resultOf(int request);

  std::vector<std::string> said_;

 private:
  std::multimap<uint32_t, std::function<void()>> due_;
};
