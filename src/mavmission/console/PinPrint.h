// A serial port that only sends, on any pin of an AVR board: CONSOLE on an Uno or a Nano (MavMissionMonitor.h), whose
// only serial port goes to the autopilot.
#pragma once

#ifdef __AVR__

#include <Arduino.h>
#include <stdint.h>
#include <util/delay_basic.h>

namespace mavmission {

// As SoftwareSerial does, it sends each byte at once, with interrupts off: for 78 µs at 115200 baud. It does not
// receive, so it needs no interrupt and no buffer.
class PinPrint : public Print {
 public:
  explicit PinPrint(uint8_t pin) : pin_(pin) {}

  // At 16 MHz up to 115200 baud.
  void begin(uint32_t baud) {
    loops_ = static_cast<uint16_t>((F_CPU / baud - kOverhead + 2) / 4);
    const uint8_t port = digitalPinToPort(pin_);
    mask_ = digitalPinToBitMask(pin_);
    output_ = portOutputRegister(port);
    const uint8_t sreg = SREG;
    noInterrupts();
    *output_ |= mask_;
    *portModeRegister(port) |= mask_;
    SREG = sreg;
  }

  size_t write(uint8_t byte) override {
    volatile uint8_t* const output = output_;
    const uint16_t loops = loops_;
    uint16_t bits = static_cast<uint16_t>(byte) << 1 | 1 << 9;  // after the start bit, and before the stop bit
    const uint8_t sreg = SREG;
    noInterrupts();
    const uint8_t high = *output | mask_;
    const uint8_t low = high ^ mask_;
    for (uint8_t left = 10;; bits >>= 1) {
      *output = (bits & 1) != 0 ? high : low;
      if (--left == 0) break;
      _delay_loop_2(loops);
    }
    SREG = sreg;
    _delay_loop_2(loops);
    return 1;
  }
  using Print::write;

  // As every port of a core has it: true, since nobody has to open the other end.
  explicit operator bool() const { return true; }

  // What reads from CONSOLE needs a port that receives.
  template <typename T = int>
  T read() {
    static_assert(sizeof(T) == 0, "CONSOLE only prints on this board: above the #include, #define CONSOLE_RX 10");
    return T();
  }
  template <typename T = int>
  T available() {
    return read<T>();
  }
  template <typename T = Stream*>
  operator Stream&() {
    return *read<T>();
  }

 private:
  static constexpr uint8_t kOverhead = 12;  // of a bit, without its _delay_loop_2() [cycles]

  volatile uint8_t* output_;
  uint16_t loops_;  // how often _delay_loop_2() loops in a bit
  uint8_t mask_;
  const uint8_t pin_;
};

}  // namespace mavmission

#endif
