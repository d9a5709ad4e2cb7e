// Finds out why nothing works: the wiring, the baud rate, who sends, and whether the autopilot hears us.
#pragma once

#include "../base/FlashText.h"
#include "Listener.h"

namespace mavmission {

// One line for each verdict: this list is both the enumeration and its texts. docs/troubleshooting.md says more about
// each.
// clang-format off
#define MAVMISSION_VERDICTS(X) \
  /* not known yet */ \
  X(Listening, "listening: not known yet") \
  X(TryingBauds, "bytes, but no frames: trying other baud rates") /* tryBauds() */ \
  /* faults, from the wire upwards */ \
  X(NoBytes, "no bytes: look at the wire from its TX to our RX, at GND, and whether that port is on") \
  X(NoFrames, "bytes, but no frames: another baud rate, or the port does not speak MAVLink") \
  X(NoFramesAtAnyBaud, \
    "bytes, but no frames at any baud rate: the port does not speak MAVLink, or the levels are wrong") \
  X(WrongBaud, "frames, but at another baud rate") /* baud() */ \
  X(OnlyEcho, "only our own frames: our TX is joined to our RX") \
  X(LoopLate, "bytes are lost: loop() calls update() too rarely") \
  X(Damaged, "frames arrive damaged: look at GND, levels, cable, and at code that keeps interrupts off") \
  X(NoAutopilot, "frames, but none from an autopilot: another component sends") /* speaker() */ \
  X(SeveralAutopilots, "several autopilots: name one with setTargetIds()") \
  X(OtherAutopilot, "an autopilot, but not the one named with setTargetIds()") /* speaker() */ \
  X(SameIds, "our system and component id are the autopilot's own: it ignores us") \
  X(NotHeard, "the autopilot does not answer: look at the wire from our TX to its RX, and at its port's settings") \
  X(Signing, "the autopilot signs its messages, and takes no unsigned ones such as ours") \
  /* no fault */ \
  X(Quiet, "all is well; the autopilot sends little unasked: setMessageInterval() asks for more") \
  X(Well, "all is well")
// clang-format on

inline namespace print_it_with_toString {  // what println() of one says: see Status.h
enum class Verdict : uint8_t {
#define MAVMISSION_NAME(name, text) name,
  MAVMISSION_VERDICTS(MAVMISSION_NAME)
#undef MAVMISSION_NAME
};
}  // namespace print_it_with_toString

// The verdict in words, for Serial.print(). Flash text; null for a value that is no Verdict.
FlashText toString(Verdict verdict);

// True when the autopilot is heard, and hears us.
constexpr bool isWell(Verdict verdict) { return verdict >= Verdict::Quiet; }

// Opens the port again at another rate [bit/s], which a Stream cannot do. Called from update(); must not wait.
typedef void (*BaudFunction)(void* context, uint32_t baud);

// Who was heard.
struct Speaker {
  uint8_t systemId;     // as its frames have it
  uint8_t componentId;  // MAV_COMPONENT
  uint8_t type;         // MAV_TYPE of its heartbeat; 0 if it sent none
};

// Examines what a client receives, and gives a verdict within some seconds. Declare one beside the client:
//
//   MissionClient autopilot(Serial1);
//   LinkDoctor doctor(autopilot);
//
// It may run during any operation. What it sends is harmless. As long as no autopilot is heard, it sends a heartbeat
// every second, by which it recognises our own echo. Then it sends a request for AUTOPILOT_VERSION
// (MAV_CMD_REQUEST_MESSAGE), every second until it is answered, then every 5 s. The request changes nothing, and every
// autopilot answers it with COMMAND_ACK, even one that does not know it. While a transfer runs it requests nothing.
class LinkDoctor : public detail::Listener {
 public:
  // The doctor must live as long as the client: declare it next to the client, not in a function.
  explicit LinkDoctor(MissionClient& client);

  // Lets it try other baud rates when bytes come, but no frames: 9600 to 921600, as far as the board can do them.
  // `baud` is the rate at which the sketch has opened the port [bit/s]. With the verdict WrongBaud the port stays at
  // the rate at which frames came; when no more frames come, it goes back to `baud`. Trying all rates takes about half
  // a minute.
  void tryBauds(BaudFunction setBaud, uint32_t baud, void* context = nullptr);

  // To be called from loop(), before the client's update(), so that it can see a full receive buffer. Returns
  // verdict().
  Verdict update();

  // The last verdict.
  Verdict verdict() const { return verdict_; }
  // The current rate of the port [bit/s]; 0 without tryBauds().
  uint32_t baud() const;
  // The last sender other than the client's autopilot; all zeros: nobody.
  const Speaker& speaker() const { return speaker_; }

 private:
  // Events whose age is kept.
  enum What : uint8_t { Bytes, Frame, Echo, Other, Autopilot, Signature, Answer, Question, LateLoop, kWhats };

  static void take(detail::Listener& listener, const detail::FrameParser& frame);
  void takeHeartbeat(const detail::FrameParser& frame);
  uint8_t systemId() const;
  bool isOurs(const detail::FrameParser& frame) const;
  void second(uint16_t nowMs);
  void count();
  void beginWindow();
  void endWindow();
  void listenAnew();
  void setBaud(uint8_t index);
  void tryNextBaud();
  Verdict judge();
  Verdict judgeWithoutFrames();
  void speak(uint16_t nowMs);
  void sendHeartbeat(uint16_t nowMs);
  void ask();

  BaudFunction setBaud_ = nullptr;
  void* baudContext_ = nullptr;
  uint32_t ownBaud_ = 0;
  uint32_t bytes_ = 0;       // the client's count of received bytes a second ago
  uint16_t framesAtWindow_;  // the client's counters when the window began
  uint16_t unknownAtWindow_;
  uint16_t damageAtWindow_;
  uint16_t brokenAtWindow_;
  uint16_t secondMs_ = 0;
  uint16_t mark_ = 0;  // in our last heartbeat, by which its echo is recognised
  Speaker speaker_ = {0, 0, 0};
  uint8_t agesS_[kWhats];  // 255: never, or long ago
  uint8_t listenedS_;      // at this rate, or since bytes came back
  uint8_t windowS_;
  uint8_t unanswered_;  // questions since the last answer
  uint8_t baudIndex_;   // of the rate that is being tried
  Verdict verdict_ = Verdict::Listening;
  Verdict damage_;    // found in the last window; Well: none
  bool weighed_ : 1;  // a window has ended
  bool quiet_ : 1;    // that window had hardly any telemetry
  bool askDue_ : 1;
  bool roundDone_ : 1;  // every rate was tried in vain
};

}  // namespace mavmission
