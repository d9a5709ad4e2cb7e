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

// In the order of tools/measuring/calls.py. Each by itself, so that no other's registers are saved with its own.
#define CALL(name, what) \
  __attribute__((noinline)) void name() { what; }
CALL(callUpdate, result = static_cast<uint8_t>(autopilot.update()))
CALL(callUpload, result = static_cast<uint8_t>(autopilot.upload(fromFunction(read, ITEMS))))
CALL(callCancel, autopilot.cancel())
CALL(callStatus, result = static_cast<uint8_t>(autopilot.status()))
CALL(callCounters, result = autopilot.counters().frames)
CALL(callItems, result = autopilot.failedItem() + autopilot.itemsDone() + autopilot.itemsTotal())
CALL(callOnProgress, autopilot.onProgress(nothing))
CALL(callOnEnd, autopilot.onEnd(over))
CALL(callSetOwnIds, autopilot.setSourceIds(1, 191))
CALL(callTalkTo, autopilot.setTargetIds(1, 1))
CALL(callToString, result = toString(autopilot.status()) != nullptr)
CALL(callAutopilot, result = autopilot.hasAutopilot() + autopilot.isArmed())

#ifdef EVERY_CALL
const MessageKey keys[] PROGMEM = {messageKey(24, 24, 30)};
void onMessage(void*, const ReceivedMessage&) {}
MissionFollower mission(autopilot);
MessageListener messages(autopilot, keys, onMessage);
LinkDoctor doctor(autopilot);
MissionItem sink[4];
const FlightCommand servo = flightCommand(183, 1, 1500);
CALL(callDownload, result = static_cast<uint8_t>(autopilot.download(toRam(sink))))
CALL(callVerify, result = static_cast<uint8_t>(autopilot.verify(fromFunction(read, ITEMS))))
CALL(callClear, result = static_cast<uint8_t>(autopilot.clear()))
CALL(callUploadAgain, result = static_cast<uint8_t>(autopilot.uploadAgain()))
CALL(callUploadPart, result = static_cast<uint8_t>(autopilot.uploadPartial(fromFunction(read, ITEMS), 1, 1)))
CALL(callStart, result = static_cast<uint8_t>(autopilot.start()))
CALL(callArm, result = static_cast<uint8_t>(autopilot.arm()))
CALL(callSetMode, result = static_cast<uint8_t>(autopilot.setMode(FlightMode::Auto)))
CALL(callSetCurrent, result = static_cast<uint8_t>(autopilot.setCurrentItem(1)))
CALL(callInterval, result = static_cast<uint8_t>(autopilot.setMessageInterval(24, 100000)))
CALL(callSend, result = static_cast<uint8_t>(autopilot.send(servo)))
CALL(callIsInMode, result = autopilot.isInMode(FlightMode::Auto))
CALL(callRetry, autopilot.retryWhenBusy(10))
CALL(callFloats, autopilot.useMissionItemFallback())
CALL(callFollowed, result = mission.currentItem() + mission.isOurPlan())
CALL(callDoctor, result = static_cast<uint8_t>(doctor.update()))
#endif

void (*const calls[])() = {
    callUpdate,     callUpload,  callCancel,     callStatus,      callCounters,   callItems,
    callOnProgress, callOnEnd,   callSetOwnIds,  callTalkTo,      callToString,   callAutopilot,
#ifdef EVERY_CALL
    callDownload,   callVerify,  callClear,      callUploadAgain, callUploadPart, callStart,
    callArm,        callSetMode, callSetCurrent, callInterval,    callSend,       callIsInMode,
    callRetry,      callFloats,  callFollowed,   callDoctor,
#endif
};

void setup() { noInterrupts(); }

void loop() {
  const uint8_t which = callDue;
  if (which == 0) return;
  stackBefore = SP;
  calls[which - 1]();
  callDue = 0;
}
