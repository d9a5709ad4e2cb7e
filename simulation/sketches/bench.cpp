// The firmware of the scenario tests: a MissionClient on Serial1 that does what lines on Serial tell it, and says on
// Serial what it sees. simulation/bench.py is the other end; it also writes the items of a RAM plan into benchPlan.
//
// A line is a word and up to three numbers. When it is done, the answer is "ok". What happens is told by lines that
// begin with millis(): "1234 progress 1 10".
#include <Arduino.h>
#include <MavMission.h>
#include <avr/sleep.h>

#include "Line.h"

using namespace mavmission;
using namespace mavmission::detail;

#ifndef BENCH_BAUD
#define BENCH_BAUD 57600
#endif

static const uint8_t kPlanItems = 60;

extern "C" {
// Written by the test, from outside.
MissionItem benchPlan[kPlanItems] __attribute__((used, externally_visible));
}

constexpr MissionItem flashPlan[] PROGMEM = {
    takeoff(20_m),
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
    waypoint(-35.3614500_deg, 149.1652374_deg, 20_m),
    returnToLaunch(),
};

#ifdef BENCH_DIRECT
MissionClient client(Serial1);
#else
Line line(Serial1);
MissionClient client(line);
#endif
#ifdef BENCH_FILES
PlanFiles files(client);
#endif

struct FunctionPlan {
  uint16_t refusedItem;
  uint16_t agreements;  // how often that item is given before it is refused
};

static FunctionPlan functionPlan;
static ItemSource plan = emptyPlan();
static uint8_t uploadsInCallback;
static uint16_t cancelAtItem = 0xFFFF;
static uint16_t uploadAtItem = 0xFFFF;  // what onProgress() tries
static uint16_t cancelInSource;         // at that call of the source's function, from 1
static uint16_t stallEachMs, stallMs;
static bool neverSleep;
static Status lastReturned = Status::Idle;

// The same as item_of_function_plan() in simulation/bench.py.
static bool itemOfFunctionPlan(void* context, uint16_t index, MissionItem& item) {
  FunctionPlan& function = *static_cast<FunctionPlan*>(context);
  if (cancelInSource != 0 && --cancelInSource == 0) client.cancel();
  if (index == function.refusedItem && function.agreements-- == 0) {
    function.agreements = 0;
    return false;
  }
  item.param1 = index % 7;
  item.param2 = index * 0.25f;
  item.param3 = 0;
  item.param4 = 10 + index % 350;
  item.x = 473977880L + 37L * index;
  item.y = 85456280L - 41L * index;
  item.z = 20.125f + index % 100;
  item.command = kNavWaypoint;
  item.frame = Frame::GlobalRelative;
  item.current = 0;
  item.autocontinue = index % 3 != 0;
  return true;
}

static void tell(const __FlashStringHelper* word, uint16_t first) {
  Serial.print(millis());
  Serial.print(' ');
  Serial.print(word);
  Serial.print(' ');
  Serial.print(first);
}

static void onProgress(void*, uint16_t done, uint16_t total) {
  tell(F("progress"), done);
  Serial.print(' ');
  Serial.println(total);
  if (done == cancelAtItem) client.cancel();
  if (done != uploadAtItem) return;
  tell(F("restarted"), static_cast<uint8_t>(client.uploadWithoutReadback(plan)));
  Serial.println();
  tell(F("nested"), static_cast<uint8_t>(client.update()));
  Serial.println();
}

static void onEnd(void*, Status status) {
  tell(F("end"), static_cast<uint8_t>(status));
  Serial.println();
  if (uploadsInCallback == 0) return;
  --uploadsInCallback;
  tell(F("restarted"), static_cast<uint8_t>(client.uploadWithoutReadback(plan)));
  Serial.println();
}

static void tellNumber(const __FlashStringHelper* name, uint32_t value) {
  Serial.print(' ');
  Serial.print(name);
  Serial.print('=');
  Serial.print(value);
}

static void tellState() {
  tell(F("state"), static_cast<uint8_t>(client.status()));
  tellNumber(F("busy"), client.isBusy());
  tellNumber(F("failed"), client.failedItem());
  tellNumber(F("done"), client.itemsDone());
  tellNumber(F("total"), client.itemsTotal());
  tellNumber(F("aboard"), static_cast<uint8_t>(client.aboard()));
  tellNumber(F("result"), client.lastResult());
  tellNumber(F("found"), client.hasAutopilot());
  tellNumber(F("firmware"), static_cast<uint8_t>(client.firmware()));
  tellNumber(F("system"), client.autopilotSystemId());
  tellNumber(F("component"), client.autopilotComponentId());
  tellNumber(F("armed"), client.isArmed());
  Serial.println();
}

static void tellCounters() {
  const LinkCounters counters = client.counters();
  tell(F("counters"), 0);
  tellNumber(F("bytes"), counters.bytes);
  tellNumber(F("skipped"), counters.bytesSkipped);
  tellNumber(F("frames"), counters.frames);
  tellNumber(F("unknown"), counters.unknownMessages);
  tellNumber(F("bad"), counters.badChecksums);
  tellNumber(F("broken"), counters.brokenFrames);
  tellNumber(F("lost"), counters.framesLost);
  tellNumber(F("sent"), counters.framesSent);
  Serial.println();
}

#if MAVMISSION_SIGNING
static EepromTimestamps timestamps(16);
static uint8_t radioHeard;  // RADIO_STATUS

static void onRadio(void*, const ReceivedMessage&) { ++radioHeard; }
const MessageKey radioKeys[] PROGMEM = {messageKey(109, 185, 9)};
MessageListener radio(client, radioKeys, onRadio);

static void tellSigning() {
  const SigningCounters& counters = client.signingCounters();
  tell(F("signing"), 0);
  tellNumber(F("accepted"), counters.accepted);
  tellNumber(F("unsigned"), counters.notSigned);
  tellNumber(F("wrong"), counters.wrong);
  tellNumber(F("replayed"), counters.replayed);
  tellNumber(F("old"), counters.old);
  tellNumber(F("streams"), counters.tooManyStreams);
  tellNumber(F("radio"), radioHeard);
  Serial.println();
}
#endif

static void tellText(FlashText text) {
  tell(F("text"), 0);
  Serial.print(' ');
  if (text == nullptr) {
    Serial.println();
  } else {
    Serial.println(text);
  }
}

// ---- What a line can be.

typedef void (*Action)(const uint32_t (&numbers)[3]);
#define ACTION(name) static void name(const uint32_t(&numbers)[3] __attribute__((unused)))

ACTION(ram) { plan = inRam(benchPlan, numbers[0]); }
ACTION(flash) { plan = inFlash(flashPlan); }
ACTION(empty) { plan = emptyPlan(); }
// Items, the item that is refused, and how often it is given before.
ACTION(function) {
  functionPlan.refusedItem = numbers[1];
  functionPlan.agreements = numbers[2];
  plan = fromFunction(itemOfFunctionPlan, numbers[0], &functionPlan);
}
// A Readback: 0 none but the autopilot's answer, 1 read back when in doubt, 2 always.
ACTION(upload) {
  const Readback proof = static_cast<Readback>(numbers[0]);
  tell(F("began"),
       static_cast<uint8_t>(proof == Readback() ? client.uploadWithoutReadback(plan) : client.upload(plan, proof)));
  Serial.println();
}
#ifdef BENCH_FILES
ACTION(fileupload) {
  tell(F("began"), static_cast<uint8_t>(files.upload(plan)));
  Serial.println();
}
ACTION(fileensure) {
  tell(F("began"), static_cast<uint8_t>(files.ensure(plan)));
  Serial.println();
}
ACTION(fileverify) {
  tell(F("began"), static_cast<uint8_t>(files.verify(plan)));
  Serial.println();
}
ACTION(verify) {
  tell(F("began"), static_cast<uint8_t>(client.verify(plan)));
  Serial.println();
}
#endif
#ifdef BENCH_ENSURE
ACTION(ensure) {
  tell(F("began"), static_cast<uint8_t>(client.ensure(plan)));
  Serial.println();
}
#endif
ACTION(cancel) { client.cancel(); }
ACTION(ids) { client.setSourceIds(numbers[0], numbers[1]); }
ACTION(talk) { client.setTargetIds(numbers[0], numbers[1]); }
ACTION(speak) { client.setMavlinkVersion(static_cast<MavlinkVersion>(numbers[0])); }
ACTION(armed) { client.allowWhileArmed(numbers[0]); }
ACTION(raw) { client.useRawNumbering(numbers[0]); }
ACTION(floats) { client.useMissionItemFallback(numbers[0]); }
ACTION(waiting) { client.setAutopilotTimeout(numbers[0]); }
ACTION(limit) { client.setOperationTimeout(numbers[0]); }
ACTION(backoff) { client.retryWhenBusy(numbers[0]); }
ACTION(callbacks) {
  client.onProgress(numbers[0] ? onProgress : nullptr);
  client.onEnd(numbers[0] ? onEnd : nullptr);
}
ACTION(again) { uploadsInCallback = numbers[0]; }
ACTION(cancelat) { cancelAtItem = numbers[0]; }
ACTION(uploadat) { uploadAtItem = numbers[0]; }
ACTION(cancelin) { cancelInSource = numbers[0]; }
// Each so many milliseconds, loop() takes so many milliseconds longer.
ACTION(stall) {
  stallEachMs = numbers[0];
  stallMs = numbers[1];
}
ACTION(nosleep) { neverSleep = numbers[0]; }
ACTION(state) { tellState(); }
ACTION(counters) { tellCounters(); }
ACTION(text) { tellText(toString(static_cast<Status>(numbers[0]))); }
ACTION(aboard) { tellText(toString(static_cast<Aboard>(numbers[0]))); }
#if MAVMISSION_SIGNING
ACTION(sign) { client.signWith(keyFromPassphrase("a secret of the tests"), numbers[0], timestamps); }
ACTION(time) { client.setSigningTime(numbers[0]); }
ACTION(signing) { tellSigning(); }
// A TUNNEL, the longest message that there is here.
ACTION(post) {
  static uint8_t payload[133];
  for (uint8_t i = 0; i < sizeof payload; ++i) payload[i] = i + 1;
  tell(F("posted"), client.sendMessage(OutgoingMessage{385, 147, sizeof payload, sizeof payload, payload}));
  Serial.println();
}
#endif
#ifndef BENCH_DIRECT
ACTION(room) { line.setRoom(numbers[0]); }
ACTION(blind) { line.setBlind(numbers[0]); }
ACTION(blocked) {
  tell(F("blocked"), line.blocked());
  Serial.println();
}
#endif

struct Word {
  const char* name;
  Action action;
};
#define WORD(name) {#name, name}
static const Word words[] = {
    WORD(ram),        WORD(flash),      WORD(empty),      WORD(function), WORD(upload),   WORD(cancel),   WORD(ids),
    WORD(talk),       WORD(speak),      WORD(armed),      WORD(raw),      WORD(floats),   WORD(waiting),  WORD(limit),
    WORD(callbacks),  WORD(again),      WORD(cancelat),   WORD(stall),    WORD(uploadat), WORD(cancelin), WORD(nosleep),
    WORD(state),      WORD(counters),   WORD(text),       WORD(aboard),   WORD(backoff),
#ifdef BENCH_FILES
    WORD(fileupload), WORD(fileverify), WORD(fileensure), WORD(verify),
#endif
#ifdef BENCH_ENSURE
    WORD(ensure),
#endif
#if MAVMISSION_SIGNING
    WORD(sign),       WORD(time),       WORD(signing),    WORD(post),
#endif
#ifndef BENCH_DIRECT
    WORD(room),       WORD(blind),      WORD(blocked),
#endif
};

static void obey(char* text) {
  uint32_t numbers[3] = {0, 0, 0};
  char* rest = text;
  while (*rest != 0 && *rest != ' ') ++rest;
  if (*rest != 0) *rest++ = 0;
  for (uint32_t& number : numbers) number = strtoul(rest, &rest, 10);
  for (const Word& word : words) {
    if (strcmp(word.name, text) != 0) continue;
    word.action(numbers);
    Serial.println(F("ok"));
    return;
  }
  Serial.println(F("what?"));
}

static void listen() {
  static char text[40];
  static uint8_t length;
  while (Serial.available()) {
    const char c = Serial.read();
    if (c != '\n') {
      if (length + 1u < sizeof(text)) text[length++] = c;
      continue;
    }
    text[length] = 0;
    length = 0;
    obey(text);
  }
}

// Until the next interrupt, at the latest that of millis(). The simulator jumps over it.
static void sleep() {
  noInterrupts();
  if (Serial.available() == 0 && Serial1.available() == 0) {
    sleep_enable();
    interrupts();  // takes effect after the next instruction: nothing is slept through
    sleep_cpu();
    sleep_disable();
  }
  interrupts();
}

// Apart, so that its calls can be watched.
extern "C" __attribute__((noinline, noclone)) Status updateClient() { return client.update(); }

void setup() {
  Serial.begin(500000);
  Serial1.begin(BENCH_BAUD);
  set_sleep_mode(SLEEP_MODE_IDLE);
  asm volatile("" : : "r"(&benchPlan) : "memory");
  client.onProgress(onProgress);
  client.onEnd(onEnd);
  Serial.println(F("ready"));
}

void loop() {
  static uint16_t stalledMs;
  listen();
  const uint16_t nowMs = millis();
  if (stallMs != 0 && static_cast<uint16_t>(nowMs - stalledMs) >= stallEachMs) {
    stalledMs = nowMs;
    delay(stallMs);
  }
  const Status status = updateClient();
  if (status != lastReturned || isEnd(status)) {
    lastReturned = status;
    tell(F("returned"), static_cast<uint8_t>(status));
    Serial.println();
  }
  if (!neverSleep) sleep();
}
