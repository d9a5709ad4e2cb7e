// The firmware of the tests of the mission service: a MissionClient on Serial1, with a follower and listeners, that
// does what lines on Serial tell it, and says on Serial what it sees. simulation/service.py is the other end; it also
// writes plans, commands and messages into the arrays below, and reads what was downloaded from there.
#include <Arduino.h>
#include <MavMission.h>

#include "BenchClient.h"

extern "C" {
MissionItem benchSink[kPlanItems] FROM_OUTSIDE;
MissionItem benchHome FROM_OUTSIDE;
FlightCommand benchCommand FROM_OUTSIDE;
uint8_t benchPayload[255] FROM_OUTSIDE;
}

// Of the common dialect: GPS_RAW_INT and GLOBAL_POSITION_INT.
const MessageKey positionKeys[] PROGMEM = {messageKey(24, 24, 30), messageKey(33, 104, 28)};

MissionFollower follower(client);
#ifdef BENCH_QUIET
TelemetryPause quiet(client);
#endif
#ifdef BENCH_STEERING
Steering steering(client);
#endif
#ifdef BENCH_TARGET
MovingTarget moving(steering);
#endif
#ifdef BENCH_VELOCITY
VelocityTarget velocity(steering);
Adjustments adjustments(steering);
#endif
#ifdef BENCH_FILES
PlanFiles files(client);
#endif

static uint16_t refusedSinkItem = kHomeIndex - 1;  // no item has that number
static OutgoingMessage outgoing;
static bool isPosting;

static void onMessage(void*, const ReceivedMessage& message) {
  tell(F("message"), message.id);
  Serial.print(' ');
  Serial.print(message.systemId);
  Serial.print(' ');
  Serial.print(message.componentId);
  Serial.print(' ');
  Serial.print(message.version);
  Serial.print(' ');
  uint8_t whole[60];
  message.copyTo(whole, message.id == 24 ? 52 : 28);
  tellHex(whole, message.id == 24 ? 52 : 28);
  Serial.println();
}

MessageListener positions(client, positionKeys, onMessage);

static void onProgress(void*, uint16_t done, uint16_t total) { tellProgress(done, total); }

static void onCurrent(void*, uint16_t item) {
  tell(F("current"), item);
  Serial.println();
}

static void onReached(void*, uint16_t item) {
  tell(F("reached"), item);
  Serial.println();
}

static void onText(void*, uint8_t severity, const char* text) {
  tell(F("text"), severity);
  Serial.print(' ');
  Serial.println(text);
}

static bool takeItem(void*, uint16_t index, const MissionItem& item) {
  tell(F("item"), index);
  Serial.println();
  if (index == refusedSinkItem) return false;
  if (index == kHomeIndex) {
    benchHome = item;
  } else if (index < kPlanItems) {
    benchSink[index] = item;
  }
  return true;
}

static void onEnd(void*, Status status) {
  tell(F("end"), static_cast<uint8_t>(status));
  Serial.println();
}

static void tellState() {
  tell(F("state"), static_cast<uint8_t>(client.status()));
  tellNumber(F("busy"), client.isBusy());
  tellNumber(F("failed"), client.failedItem());
  tellNumber(F("done"), client.itemsDone());
  tellNumber(F("total"), client.itemsTotal());
  tellNumber(F("aboard"), static_cast<uint8_t>(client.aboard()));
  tellNumber(F("fence"), static_cast<uint8_t>(client.aboard(PlanType::Fence)));
  tellNumber(F("rally"), static_cast<uint8_t>(client.aboard(PlanType::Rally)));
  tellNumber(F("field"), static_cast<uint8_t>(client.differingField()));
  tellNumber(F("step"), static_cast<uint8_t>(client.startStep()));
  tellNumber(F("arming"), static_cast<uint8_t>(client.startArming()));
  tellNumber(F("result"), client.lastResult());
  tellNumber(F("found"), client.hasAutopilot());
  tellNumber(F("firmware"), static_cast<uint8_t>(client.firmware()));
  tellNumber(F("system"), client.autopilotSystemId());
  tellNumber(F("component"), client.autopilotComponentId());
  tellNumber(F("armed"), client.isArmed());
  tellNumber(F("mode"), client.customMode());
  uint8_t modes = 0;
  for (uint8_t mode = 0; mode < 7; ++mode) {
    if (client.isInMode(static_cast<FlightMode>(mode))) modes |= 1 << mode;
  }
  tellNumber(F("modes"), modes);
  Serial.println();
}

static void tellFollowed() {
  tell(F("followed"), 0);
  tellNumber(F("current"), follower.currentItem());
  tellNumber(F("reached"), follower.reachedItem());
  tellNumber(F("total"), follower.total());
  tellNumber(F("state"), static_cast<uint8_t>(follower.state()));
  tellNumber(F("ours"), follower.isOurPlan());
  Serial.println();
}

// ---- What a line can be.

static PlanType typeOf(uint32_t number) { return static_cast<PlanType>(number); }

// Type, Proof.
ACTION(upload) {
  if (numbers[1] == 0) return tellBegun(client.uploadWithoutReadback(plan, typeOf(numbers[0])));
  tellBegun(client.upload(plan, typeOf(numbers[0]), static_cast<Readback>(numbers[1])));
}
// Type, Proof.
ACTION(ensure) { tellBegun(client.ensure(plan, typeOf(numbers[0]), static_cast<Readback>(numbers[1]))); }
ACTION(uploadagain) { tellBegun(client.uploadAgain()); }
ACTION(uploadpart) { tellBegun(client.uploadPartial(plan, numbers[0], numbers[1])); }
ACTION(verify) { tellBegun(client.verify(plan, typeOf(numbers[0]))); }
// Type, the items that the function takes at most, the item that it refuses.
ACTION(download) {
  refusedSinkItem = numbers[2];
  tellBegun(client.download(toFunction(takeItem, nullptr, numbers[1]), typeOf(numbers[0])));
}
#ifdef BENCH_FILES
// The same by file.
ACTION(fileupload) { tellBegun(files.upload(plan, typeOf(numbers[0]))); }
ACTION(fileensure) { tellBegun(files.ensure(plan, typeOf(numbers[0]))); }
ACTION(fileverify) { tellBegun(files.verify(plan, typeOf(numbers[0]))); }
ACTION(filedownload) {
  refusedSinkItem = numbers[2];
  tellBegun(files.download(toFunction(takeItem, nullptr, numbers[1]), typeOf(numbers[0])));
}
// Whether the last operation went by file.
ACTION(byfile) {
  tell(F("byfile"), files.isByFile());
  Serial.println();
}
#endif
ACTION(clear) { tellBegun(client.clear(typeOf(numbers[0]))); }
ACTION(start) { tellBegun(client.start(numbers[0])); }
ACTION(startproven) { tellBegun(client.verifyAndStart(plan, numbers[0])); }
ACTION(arm) { tellBegun(client.arm()); }
ACTION(disarm) { tellBegun(client.disarm()); }
ACTION(mode) { tellBegun(client.setMode(static_cast<FlightMode>(numbers[0]))); }
ACTION(startmission) { tellBegun(client.startMission()); }
ACTION(setcurrent) { tellBegun(client.setCurrentItem(numbers[0])); }
ACTION(interval) { tellBegun(client.setMessageInterval(numbers[0], numbers[1])); }
// benchCommand; 1: repeat it always.
ACTION(order) { tellBegun(client.send(benchCommand, static_cast<CommandRepeat>(numbers[0]))); }
// benchPayload: id, CRC_EXTRA, length, MAVLink 1 length.
ACTION(post) {
  outgoing = OutgoingMessage{numbers[0], static_cast<uint8_t>(numbers[1]), static_cast<uint8_t>(numbers[2]),
                             static_cast<uint8_t>(numbers[3]), benchPayload};
  isPosting = true;
}
#ifdef BENCH_STEERING
static float asFloat(uint32_t bits) {
  float value;
  memcpy(&value, &bits, sizeof(value));
  return value;
}
// Numbers with a fraction come as the bits of a float.
ACTION(takeoff) { tellBegun(steering.takeOff(Metres(asFloat(numbers[0])))); }
// Latitude and longitude [1e-7 degrees], altitude, frame.
ACTION(goTo) {
  const LatLon place = {Degrees::fromE7(static_cast<int32_t>(numbers[0])),
                        Degrees::fromE7(static_cast<int32_t>(numbers[1]))};
  tellBegun(steering.goTo(place, Altitude(Metres(asFloat(numbers[2])), static_cast<CoordinateFrame>(numbers[3]))));
}
ACTION(hold) { tellBegun(steering.pause()); }
ACTION(goOn) { tellBegun(steering.resume()); }
ACTION(home) { tellBegun(steering.returnHome()); }
ACTION(landNow) { tellBegun(steering.landNow()); }
ACTION(speed) { tellBegun(steering.setSpeed(MetresPerSecond(asFloat(numbers[0])))); }
// Within so many centimetres.
ACTION(steered) {
  tell(F("steered"), steering.hasArrived(numbers[0]));
  Serial.println();
}
#endif
#ifdef BENCH_TARGET
static uint16_t renewEachMs;  // 0: nobody renews it
static LatLon targetPlace;
static Altitude targetAltitude = 0_m;
// Latitude and longitude [1e-7 degrees], altitude, frame; then how it went.
static void readTarget(const Numbers& numbers) {
  targetPlace =
      LatLon{Degrees::fromE7(static_cast<int32_t>(numbers[0])), Degrees::fromE7(static_cast<int32_t>(numbers[1]))};
  targetAltitude = Altitude(Metres(asFloat(numbers[2])), static_cast<CoordinateFrame>(numbers[3]));
}
ACTION(follow) {
  readTarget(numbers);
  tellBegun(moving.start(targetPlace, targetAltitude));
}
// The sketch itself renews the last place each so many milliseconds.
ACTION(renewing) { renewEachMs = numbers[0]; }
// loop() stands still once for so many milliseconds, in the middle of the next long message.
static uint32_t hangMs;
ACTION(hang) { hangMs = numbers[0]; }
ACTION(target) {
  tell(F("target"), static_cast<uint8_t>(moving.status()));
  Serial.println();
}
static void moveTarget() {
  static uint16_t renewedMs;
  moving.update();
  const uint16_t nowMs = millis();
  if (renewEachMs == 0 || static_cast<uint16_t>(nowMs - renewedMs) < renewEachMs) return;
  renewedMs = nowMs;
  moving.renew(targetPlace, targetAltitude);
}
#endif
#ifdef BENCH_VELOCITY
static uint16_t flyEachMs;  // 0: nobody renews it
static float flightNumbers[3];
static Velocity flightVelocity() {
  return EarthVelocity(MetresPerSecond(flightNumbers[0]), MetresPerSecond(flightNumbers[1]),
                       MetresPerSecond(flightNumbers[2]));
}
// To the north, to the east, up.
ACTION(fly) {
  for (uint8_t i = 0; i < 3; ++i) flightNumbers[i] = asFloat(numbers[i]);
  tellBegun(velocity.start(flightVelocity()));
}
// The sketch itself renews the last velocity each so many milliseconds.
ACTION(flying) { flyEachMs = numbers[0]; }
ACTION(turnTo) {
  const int32_t e7 = static_cast<int32_t>(asFloat(numbers[0]) * 10000000.0f);
  tellBegun(adjustments.turnTo(Yaw(Degrees::fromE7(e7)), DegreesPerSecond(asFloat(numbers[1]))));
}
ACTION(climbs) { tellBegun(adjustments.setClimbSpeed(MetresPerSecond(asFloat(numbers[0])))); }
ACTION(sinks) { tellBegun(adjustments.setDescentSpeed(MetresPerSecond(asFloat(numbers[0])))); }
ACTION(flown) {
  tell(F("flown"), static_cast<uint8_t>(velocity.status()));
  tellNumber(F("flown"), velocity.isFlown());
  Serial.println();
}
static void flyVelocity() {
  static uint16_t renewedMs;
  velocity.update();
  const uint16_t nowMs = millis();
  if (flyEachMs == 0 || static_cast<uint16_t>(nowMs - renewedMs) < flyEachMs) return;
  renewedMs = nowMs;
  velocity.renew(flightVelocity());
}
#endif
ACTION(state) { tellState(); }
ACTION(followed) { tellFollowed(); }
// Is benchSink[0] what this autopilot makes of benchPlan[0]? Firmware, type, HEARTBEAT.type.
ACTION(compare) {
  tell(F("field"),
       static_cast<uint8_t>(difference(benchPlan[0], benchSink[0],
                                       keeperOf(static_cast<Firmware>(numbers[0]), numbers[2], typeOf(numbers[1])))));
  Serial.println();
}
ACTION(fieldtext) {
  tell(F("text"), 0);
  Serial.print(' ');
  Serial.println(toString(static_cast<ItemField>(numbers[0])));
}

static const Word words[] = {
    WORDS_OF_CLIENT,  WORD(upload),     WORD(uploadagain),  WORD(uploadpart),  WORD(verify),     WORD(download),
    WORD(clear),      WORD(start),      WORD(arm),          WORD(disarm),      WORD(mode),       WORD(startmission),
    WORD(setcurrent), WORD(interval),   WORD(order),        WORD(post),        WORD(state),      WORD(followed),
    WORD(compare),    WORD(fieldtext),  WORD(ensure),       WORD(startproven),
#ifdef BENCH_STEERING
    WORD(takeoff),    WORD(goTo),       WORD(hold),         WORD(goOn),        WORD(home),       WORD(landNow),
    WORD(speed),      WORD(steered),
#endif
#ifdef BENCH_TARGET
    WORD(follow),     WORD(renewing),   WORD(target),       WORD(hang),
#endif
#ifdef BENCH_VELOCITY
    WORD(fly),        WORD(flying),     WORD(flown),        WORD(turnTo),      WORD(climbs),     WORD(sinks),
#endif
#ifdef BENCH_FILES
    WORD(fileupload), WORD(fileverify), WORD(filedownload), WORD(byfile),      WORD(fileensure),
#endif
};

void setup() {
  asm volatile("" : : "r"(&benchPlan), "r"(&benchSink), "r"(&benchCommand), "r"(&benchPayload) : "memory");
  client.onProgress(onProgress);
  client.onEnd(onEnd);
  follower.onCurrent(onCurrent);
  follower.onReached(onReached);
  follower.onText(onText);
  setUpTalk();
}

void loop() {
  listen(words);
  stallWhereDue();
#ifdef BENCH_QUIET
  quiet.update();
#endif
#ifdef BENCH_TARGET
  moveTarget();
#endif
#ifdef BENCH_VELOCITY
  flyVelocity();
#endif
  const Status status = client.update();
#ifdef BENCH_TARGET
  if (hangMs != 0 && !client.isSent()) {
    delay(hangMs);
    hangMs = 0;
  }
#endif
  tellReturned(status);
  if (isPosting && client.sendMessage(outgoing)) {
    isPosting = false;
    tell(F("posted"), 0);
    Serial.println();
  }
  sleepIfNothingCame(Serial1);
}
