// The firmware of the scenario tests: a MissionClient on Serial1 that does what lines on Serial tell it, and says on
// Serial what it sees. simulation/bench.py is the other end; it also writes the items of a RAM plan into benchPlan.
#include <Arduino.h>
#include <MavMission.h>

#include "BenchClient.h"

constexpr MissionItem flashPlan[] PROGMEM = {
    takeoff(20_m),
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
    waypoint(-35.3614500_deg, 149.1652374_deg, 20_m),
    returnToLaunch(),
};

#ifdef BENCH_FILES
PlanFiles files(client);
#endif

struct FunctionPlan {
  uint16_t refusedItem;
  uint16_t agreements;  // how often that item is given before it is refused
};

static FunctionPlan functionPlan;
static uint8_t uploadsInCallback;
static bool neverSleep;

// The same as item_of_function_plan() in simulation/bench.py.
static bool itemOfFunctionPlan(void* context, uint16_t index, MissionItem& item) {
  FunctionPlan& function = *static_cast<FunctionPlan*>(context);
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
  item.frame = CoordinateFrame::GlobalRelative;
  item.current = 0;
  item.autocontinue = index % 3 != 0;
  return true;
}

static void onProgress(void*, uint16_t done, uint16_t total) { tellProgress(done, total); }

static void onEnd(void*, Status status) {
  tell(F("end"), static_cast<uint8_t>(status));
  Serial.println();
  if (uploadsInCallback == 0) return;
  --uploadsInCallback;
  tell(F("restarted"), static_cast<uint8_t>(client.uploadWithoutReadback(plan)));
  Serial.println();
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

// ---- What a line can be.

ACTION(flash) { plan = inFlash(flashPlan); }
// Items, the item that is refused, and how often it is given before.
ACTION(function) {
  functionPlan.refusedItem = numbers[1];
  functionPlan.agreements = numbers[2];
  plan = fromFunction(itemOfFunctionPlan, numbers[0], &functionPlan);
}
// A Readback: 0 none but the autopilot's answer, 1 read back when in doubt, 2 always.
ACTION(upload) {
  const Readback proof = static_cast<Readback>(numbers[0]);
  tellBegun(proof == Readback() ? client.uploadWithoutReadback(plan) : client.upload(plan, proof));
}
#ifdef BENCH_FILES
ACTION(fileupload) { tellBegun(files.upload(plan)); }
ACTION(fileensure) { tellBegun(files.ensure(plan)); }
ACTION(fileverify) { tellBegun(files.verify(plan)); }
ACTION(verify) { tellBegun(client.verify(plan)); }
#endif
#ifdef BENCH_ENSURE
ACTION(ensure) { tellBegun(client.ensure(plan)); }
#endif
ACTION(floats) { client.useMissionItemFallback(numbers[0]); }
ACTION(callbacks) {
  client.onProgress(numbers[0] ? onProgress : nullptr);
  client.onEnd(numbers[0] ? onEnd : nullptr);
}
ACTION(again) { uploadsInCallback = numbers[0]; }
ACTION(nosleep) { neverSleep = numbers[0]; }
ACTION(state) { tellState(); }
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

static const Word words[] = {
    WORDS_OF_CLIENT,  WORD(flash),      WORD(function),   WORD(upload), WORD(floats),
    WORD(callbacks),  WORD(again),      WORD(nosleep),    WORD(state),
#ifdef BENCH_FILES
    WORD(fileupload), WORD(fileverify), WORD(fileensure), WORD(verify),
#endif
#ifdef BENCH_ENSURE
    WORD(ensure),
#endif
#if MAVMISSION_SIGNING
    WORD(sign),       WORD(time),       WORD(signing),    WORD(post),
#endif
};

// Apart, so that its calls can be watched.
extern "C" __attribute__((noinline, noclone)) Status updateClient() { return client.update(); }

void setup() {
  asm volatile("" : : "r"(&benchPlan) : "memory");
  client.onProgress(onProgress);
  client.onEnd(onEnd);
  setUpTalk();
}

void loop() {
  listen(words);
  stallWhereDue();
  tellReturned(updateClient());
  if (!neverSleep) sleepIfNothingCame(Serial1);
}
