// Calls one public function at a time, with interrupts off and a stream in RAM that the tests fill, so that the stack
// below a call is the call's own.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;
using namespace mavmission::detail;

// Bytes that the tests put in and take out.
volatile uint8_t toSketch[128], toSketchRead, toSketchEnd;
volatile uint8_t fromSketch[128], fromSketchEnd;

class Pipe : public Stream {
 public:
  int available() override { return toSketchEnd - toSketchRead; }
  int read() override { return toSketchRead == toSketchEnd ? -1 : toSketch[toSketchRead++]; }
  int peek() override { return -1; }
  size_t write(uint8_t byte) override {
    fromSketch[fromSketchEnd++] = byte;
    return 1;
  }
  int availableForWrite() override { return 63; }
};

constexpr MissionItem four[] PROGMEM = {
    takeoff(20_m),
    jump(0, 1),
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
    returnToLaunch(),
};

// ITEMS items: the four over and over.
bool read(void*, uint16_t index, MissionItem& item) {
  memcpy_P(&item, &four[index % 4], sizeof item);
  return true;
}

Pipe pipe;
MissionClient autopilot(pipe);
volatile uint8_t callDue;
volatile uint16_t stackBefore;
volatile uint8_t result;

void nothing(void*, uint16_t, uint16_t) {}
void over(void*, Status) {}

// What is called, by its name in the table of tools/measuring/calls.py, and how.
#define FEW_CALLS(X)                                                                                    \
  X(callUpdate, "update()", result = static_cast<uint8_t>(autopilot.update()))                          \
  X(callUpload, "upload()", result = static_cast<uint8_t>(autopilot.upload(fromFunction(read, ITEMS)))) \
  X(callCancel, "cancel()", autopilot.cancel())                                                         \
  X(callStatus, "status()", result = static_cast<uint8_t>(autopilot.status()))                          \
  X(callCounters, "counters()", result = autopilot.counters().frames)                                   \
  X(callItems, "failedItem(), itemsDone(), itemsTotal()",                                               \
    result = autopilot.failedItem() + autopilot.itemsDone() + autopilot.itemsTotal())                   \
  X(callOnProgress, "onProgress()", autopilot.onProgress(nothing))                                      \
  X(callOnEnd, "onEnd()", autopilot.onEnd(over))                                                        \
  X(callSetOwnIds, "setSourceIds()", autopilot.setSourceIds(1, 191))                                    \
  X(callTalkTo, "setTargetIds()", autopilot.setTargetIds(1, 1))                                         \
  X(callToString, "toString()", result = toString(autopilot.status()) != nullptr)                       \
  X(callAutopilot, "hasAutopilot(), isArmed()", result = autopilot.hasAutopilot() + autopilot.isArmed())

#ifdef EVERY_CALL
const MessageKey keys[] PROGMEM = {messageKey(24, 24, 30)};
void onMessage(void*, const ReceivedMessage&) {}
MissionFollower mission(autopilot);
MessageListener messages(autopilot, keys, onMessage);
LinkDoctor doctor(autopilot);
MissionItem sink[4];
const FlightCommand servo = flightCommand(183, 1, 1500);
#define MORE_CALLS(X)                                                                                                  \
  X(callDownload, "download()", result = static_cast<uint8_t>(autopilot.download(toRam(sink))))                        \
  X(callVerify, "verify()", result = static_cast<uint8_t>(autopilot.verify(fromFunction(read, ITEMS))))                \
  X(callClear, "clear()", result = static_cast<uint8_t>(autopilot.clear()))                                            \
  X(callUploadAgain, "uploadAgain()", result = static_cast<uint8_t>(autopilot.uploadAgain()))                          \
  X(callUploadPart, "uploadPartial()",                                                                                 \
    result = static_cast<uint8_t>(autopilot.uploadPartial(fromFunction(read, ITEMS), 1, 1)))                           \
  X(callStart, "start()", result = static_cast<uint8_t>(autopilot.start()))                                            \
  X(callArm, "arm(), disarm()", result = static_cast<uint8_t>(autopilot.arm()))                                        \
  X(callSetMode, "setMode()", result = static_cast<uint8_t>(autopilot.setMode(FlightMode::Auto)))                      \
  X(callSetCurrent, "setCurrentItem()", result = static_cast<uint8_t>(autopilot.setCurrentItem(1)))                    \
  X(callInterval, "setMessageInterval()", result = static_cast<uint8_t>(autopilot.setMessageInterval(24, 100000)))     \
  X(callSend, "send()", result = static_cast<uint8_t>(autopilot.send(servo)))                                          \
  X(callIsInMode, "isInMode()", result = autopilot.isInMode(FlightMode::Auto))                                         \
  X(callRetry, "retryWhenBusy()", autopilot.retryWhenBusy(10))                                                         \
  X(callFloats, "useMissionItemFallback()", autopilot.useMissionItemFallback())                                        \
  X(callFollowed, "MissionFollower: currentItem(), isOurPlan()", result = mission.currentItem() + mission.isOurPlan()) \
  X(callDoctor, "LinkDoctor: update()", result = static_cast<uint8_t>(doctor.update()))
#else
#define MORE_CALLS(X)
#endif

// Each by itself, so that no other's registers are saved with its own.
#define CALL(function, name, ...) \
  __attribute__((noinline)) void function() { __VA_ARGS__; }
#define ADDRESS(function, ...) function,
FEW_CALLS(CALL)
MORE_CALLS(CALL)
void (*const calls[])() = {FEW_CALLS(ADDRESS) MORE_CALLS(ADDRESS)};

void setup() { noInterrupts(); }

void loop() {
  const uint8_t which = callDue;
  if (which == 0) return;
  stackBefore = SP;
  calls[which - 1]();
  callDue = 0;
}
