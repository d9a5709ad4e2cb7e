// A sketch that calls update() each millisecond, and half of whose transmit line is in use.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

MissionClient autopilot(Serial1);

// Bytes a second that fill half of the line, written a frame at a time.
constexpr uint16_t kHalf = BAUD / 20;
constexpr uint8_t kFrame = 30;
const uint8_t frame[kFrame] = {};

#ifdef WITHOUT_LIBRARY
// What the Arduino core costs by itself: bytes are fetched, and nothing is made of them.
extern "C" __attribute__((noinline)) void measured_update() {
  while (Serial1.read() >= 0) {
  }
}
#else
extern "C" __attribute__((noinline)) void measured_update() { autopilot.update(); }
#endif

extern "C" __attribute__((noinline)) void measured_write() { Serial1.write(frame, kFrame); }

void setup() { Serial1.begin(BAUD); }

void loop() {
  static uint16_t lastMs;
  static uint32_t due;
  const uint16_t nowMs = static_cast<uint16_t>(millis());
  const uint16_t passedMs = nowMs - lastMs;
  if (passedMs == 0) return;
  lastMs = nowMs;
  measured_update();
  due += uint32_t(kHalf) * passedMs;
  if (due < kFrame * 1000UL) return;
  due -= kFrame * 1000UL;
  measured_write();
}
