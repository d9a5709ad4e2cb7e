// The firmware of the tests of Payload: it tells each command that it is given, and answers as lines on Serial have
// told it to. simulation/payload.py is the other end.
#include <Arduino.h>
#include <MavMission.h>

#include "ClientTalk.h"

using namespace mavmission;

static PayloadAnswer next = PayloadAnswer::Accepted;

static PayloadAnswer carryOut(void* context, const PayloadCommand& command) {
  tell(F("command"), command.id);
  tellNumber(F("system"), command.systemId);
  tellNumber(F("component"), command.componentId);
  tellNumber(F("all"), command.isForAll);
  tellNumber(F("context"), *static_cast<uint8_t*>(context));
  for (uint8_t i = 0; i < 7; ++i) {
    uint32_t bits;
    memcpy(&bits, &command.param[i], sizeof(bits));
    Serial.print(F(" p"));
    Serial.print(i + 1);
    Serial.print('=');
    Serial.print(bits);
  }
  Serial.println();
  return next;
}

static uint8_t context = 77;
static MissionClient client(Serial1);
static Payload payload(client, carryOut, &context);
#ifdef BENCH_LISTENER
// The sketch hears the same message, with a key that does not say whom it is for.
const MessageKey commandKeys[] PROGMEM = {messageKey(76, 152, 33)};
static void onCommand(void*, const ReceivedMessage& message) {
  tell(F("heard"), message.id);
  Serial.println();
}
static MessageListener commands(client, commandKeys, onCommand);
#endif
static DistanceSensor distance(20, 700, 25, 3, 1);
static LandingTarget target(2);
static LandingTargetPosition landingPlace(3);
static NamedValue value("ten_letter");
static NamedValue cut("more than ten letters");
static TextMessage text;

static void tellSent(bool isTaken) {
  tell(F("sent"), isTaken);
  Serial.println();
}

ACTION(answer) { next = static_cast<PayloadAnswer>(numbers[0]); }
ACTION(progress) { payload.progress(numbers[0]); }
ACTION(finish) { payload.finish(static_cast<PayloadAnswer>(numbers[0])); }
ACTION(busy) {
  tell(F("busy"), payload.isBusy());
  Serial.println();
}
ACTION(ids) { client.setSourceIds(numbers[0], numbers[1]); }
ACTION(distance_) {
  distance.set(numbers[0]);
  tellSent(client.sendMessage(distance));
}
ACTION(target_) {
  target.set(0.25f, -0.5f, 3);
  tellSent(client.sendMessage(target));
}
ACTION(seen) {
  landingPlace.setFromAircraft(-1.5f, 2, 6, 6.5f);
  tellSent(client.sendMessage(landingPlace));
}
ACTION(origin) {
  landingPlace.setFromOrigin(-30.25f, 12, -0.5f);
  tellSent(client.sendMessage(landingPlace));
}
ACTION(value_) {
  value.set(-1.5f);
  tellSent(client.sendMessage(value));
}
ACTION(cut_) {
  cut.set(2);
  tellSent(client.sendMessage(cut));
}
ACTION(text_) {
  text.set(4, F("rope torn"));
  tellSent(client.sendMessage(text));
}
ACTION(longtext) {
  text.set(6, "a text of more than fifty characters, which are the most");
  tellSent(client.sendMessage(text));
}
ACTION(upload) { client.upload(fromFunction(itemOnTheWayNorth, numbers[0])); }
ACTION(arm) { client.arm(); }

static const Word words[] = {
    WORD(answer),        WORD(progress), WORD(finish), WORD(busy),        WORD(ids),     {"distance", distance_},
    {"target", target_}, WORD(seen),     WORD(origin), {"value", value_}, {"cut", cut_}, {"text", text_},
    WORD(longtext),      WORD(upload),   WORD(arm),
};

void setup() { setUpTalk(); }

void loop() {
  listen(words);
  tellReturned(client.update());
  payload.update();
  sleepIfNothingCame(Serial1);
}
