// The autopilot's parameters, one at a time: reads one, or sets one and checks that it is stored.
#pragma once

#include <stdint.h>

#include "../base/FlashText.h"
#include "../base/Status.h"
#include "Listener.h"

namespace mavmission {

namespace detail {
class Client;
}  // namespace detail

// Declare one beside the client:
//
//   MissionClient autopilot(Serial1);
//   Parameters parameters(autopilot);
//
//   parameters.read(F("SERIAL1_BAUD"));  // update() returns Status::Done when value() and whole() are known
//
// read() and set() are operations of the client, of which only one runs at a time: they return the first status of the
// operation, or Status::Busy, and the client's update(), status(), onEnd() and cancel() work for them. An autopilot
// does not answer a name that it does not know: then the operation ends with Status::NoParameter after 7.5 s.
class Parameters : public detail::Listener {
 public:
  // The longest name of a parameter.
  static constexpr uint8_t kMostCharacters = 16;

  // This object must live as long as the client: declare it next to the client, not in a function.
  explicit Parameters(MissionClient& client);

  // Reads a parameter. The name is copied; one with more than kMostCharacters ends with Status::NoParameter.
  Status read(FlashText name);

  // Reads a parameter, to learn its type, and sets it if it has another value. Status::Done: the autopilot has
  // confirmed this value. Status::OtherValue: the autopilot stores another value, value(), because it limits the value
  // or because the parameter is read-only. set() is refused with Status::NotANumber or Status::NotFinite for such a
  // number; with Status::NotKept if the parameter takes whole numbers only, if the value is outside the range of its
  // type (an INT8 has -128 to 127), or if the number has more digits than a float; and with Status::Armed while the
  // autopilot is armed, unless MissionClient::allowWhileArmed() allows it. Many parameters take effect only when the
  // autopilot restarts.
  Status set(FlashText name, float value);
  // The same for a whole number, without a float in the sketch.
  Status setWhole(FlashText name, int32_t value);

#ifdef ARDUINO
  // The same for a name in RAM.
  Status read(const char* name);
  Status set(const char* name, float value);
  Status setWhole(const char* name, int32_t value);
#endif

  // The value of the last operation's parameter, as the autopilot last reported it: valid after Status::Done and
  // Status::OtherValue. whole() is the nearest whole number, or 0 for one beyond 31 bits.
  float value() const;
  int32_t whole() const;
  // True if the parameter takes whole numbers only.
  bool isWhole() const;

 private:
  enum class Wanted : uint8_t { Nothing, Float, Whole };

  static void take(detail::Listener& listener, const detail::FrameParser& frame);
  struct Exchange;
  static void step(detail::Client& client, const detail::FrameParser* frame, uint16_t nowMs);
  Status begin(FlashText name, const char* nameInRam, Wanted wanted, int32_t value);
  void takeValue();
  Status compare();
  void onTime(uint16_t nowMs);
  void send(uint16_t nowMs);
  bool makeBits();
  bool isAsBits() const;

  int32_t wanted_ = 0;  // a whole number, or a float's bits; then those for the wire
  int32_t bits_ = 0;    // of the value, as it came
  char name_[kMostCharacters];
  uint8_t type_ = 0;  // MAV_PARAM_TYPE; 0 before it is known
  Wanted what_ = Wanted::Nothing;
  bool isTooLong_ = false;  // the name
  bool isSetting_ = false;  // the parameter has been read, and PARAM_SET is due or under way
};

}  // namespace mavmission
