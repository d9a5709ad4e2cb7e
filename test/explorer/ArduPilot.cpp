// ArduPilot: it edits its plan in place from COUNT on, asks again each second, gives up 8 s after the last good item,
// answers INVALID_SEQUENCE to an item that it does not wait for and ERROR to any item while it is idle, and says
// ACCEPTED once. A fence it replaces when all of the new one has come; home is of a mission alone. LateArduPilot is a
// newer one, whose final ACK comes 700 ms after the last item, and INVALID_SEQUENCE to any item until then.
#include <string.h>

#include "Autopilot.h"
#include "Plans.h"

namespace {

constexpr uint16_t kAsksAgainMs = 1000, kGivesUpMs = 8000, kLateMs = 700;

void acknowledge(Answers& answers, Result result) { answers.add(message(Kind::Ack, result)); }

void ask(Autopilot& autopilot, Answers& answers) {
  autopilot.asksInMs = kAsksAgainMs;
  answers.add(message(Kind::Request, autopilot.expected));
}

void forget(Autopilot& autopilot) {
  autopilot.state = Autopilot::State::Idle;
  autopilot.expected = autopilot.count = 0;
  autopilot.asksInMs = autopilot.givesUpInMs = kNever;
  memset(autopilot.staged, 0, sizeof(autopilot.staged));
}

void cut(Autopilot& autopilot, uint16_t length) {
  while (autopilot.heldCount > length) autopilot.held[--autopilot.heldCount] = kNoItemAtAll;
}

void complete(Autopilot& autopilot, Answers& answers) {
  if (autopilot.type == kFence) {
    memcpy(autopilot.held, autopilot.staged, sizeof(autopilot.held));
    autopilot.heldCount = autopilot.count;
  }
  forget(autopilot);
  if (autopilot.firmware == Firmwares::LateArduPilot) {
    autopilot.acceptsInMs = kLateMs;
  } else {
    acknowledge(answers, kAccepted);
  }
}

void hearCount(Autopilot& autopilot, uint16_t count, Answers& answers) {
  forget(autopilot);
  if (autopilot.type != kFence) cut(autopilot, count);
  autopilot.count = count;
  if (count == 0) return complete(autopilot, answers);
  autopilot.state = Autopilot::State::Receiving;
  autopilot.givesUpInMs = kGivesUpMs;
  ask(autopilot, answers);
}

void hearItem(Autopilot& autopilot, const Message& item, Answers& answers) {
  if (autopilot.state != Autopilot::State::Receiving) {
    return acknowledge(answers, autopilot.acceptsInMs != kNever ? kInvalidSequence : kError);
  }
  if (item.number != autopilot.expected) return acknowledge(answers, kInvalidSequence);
  if (autopilot.refused != 0 && item.number == autopilot.refused) {
    forget(autopilot);
    return acknowledge(answers, kUnsupported);
  }
  if (autopilot.type == kFence) {
    autopilot.staged[item.number] = item.item;
  } else {
    autopilot.held[item.number] = item.item;
    if (item.number == autopilot.heldCount) ++autopilot.heldCount;
  }
  autopilot.givesUpInMs = kGivesUpMs;
  ++autopilot.expected;
  if (autopilot.expected == autopilot.count) return complete(autopilot, answers);
  ask(autopilot, answers);
}

void hearRequest(Autopilot& autopilot, uint16_t number, Answers& answers) {
  if (autopilot.state == Autopilot::State::Receiving) return acknowledge(answers, kDenied);
  const bool isHome = number == 0 && autopilot.type == kMission;
  if (!isHome && number >= autopilot.heldCount) return acknowledge(answers, kError);
  answers.add(message(Kind::Item, number, isHome ? kHome : autopilot.held[number]));
}

}  // namespace

void hearAsArduPilot(Autopilot& autopilot, const Message& heard, Answers& answers) {
  switch (heard.kind) {
    case Kind::Count: return hearCount(autopilot, heard.number, answers);
    case Kind::Item: return hearItem(autopilot, heard, answers);
    case Kind::Request: return hearRequest(autopilot, heard.number, answers);
    case Kind::List:
      if (autopilot.state == Autopilot::State::Receiving) return acknowledge(answers, kDenied);
      answers.add(message(Kind::Count, autopilot.heldCount));
      return;
    case Kind::ClearAll:
      forget(autopilot);
      cut(autopilot, 0);
      return acknowledge(answers, kAccepted);
    case Kind::Ack:  // a cancellation too: it times out
    case Kind::OlderRequest:
    case Kind::Heartbeat:
    case Kind::File:
    case Kind::FileReply: return;
  }
}

void actAsArduPilot(Autopilot& autopilot, Answers& answers) {
  if (autopilot.acceptsInMs == 0) {
    autopilot.acceptsInMs = kNever;
    acknowledge(answers, kAccepted);
  }
  if (autopilot.givesUpInMs == 0) {
    forget(autopilot);
    return acknowledge(answers, kCancelled);
  }
  if (autopilot.asksInMs == 0) ask(autopilot, answers);
}
