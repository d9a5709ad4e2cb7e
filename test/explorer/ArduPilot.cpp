// ArduPilot: it edits its plan in place from COUNT on, asks again each second, gives up 8 s after the last good item,
// answers INVALID_SEQUENCE to an item that it does not wait for and ERROR to any item while it is idle, and says
// ACCEPTED once. A fence it replaces when all of the new one has come; home is of a mission alone. LateArduPilot is a
// newer one, whose final ACK comes 700 ms after the last item, and INVALID_SEQUENCE to any item until then.
#include "Autopilot.h"
#include "Plans.h"

namespace {

constexpr uint16_t kGivesUpMs = 8000, kLateMs = 700;

void cut(Autopilot& autopilot, uint16_t length) {
  while (autopilot.heldCount > length) autopilot.held[--autopilot.heldCount] = kNoItemAtAll;
}

void complete(Autopilot& autopilot, Answers& answers) {
  if (autopilot.type == kFence) autopilot.keep(autopilot.count);
  autopilot.forget();
  if (autopilot.firmware == Firmwares::LateArduPilot) {
    autopilot.acceptsInMs = kLateMs;
  } else {
    answers.acknowledge(kAccepted);
  }
}

void hearCount(Autopilot& autopilot, uint16_t count, Answers& answers) {
  autopilot.forget();
  if (autopilot.type != kFence) cut(autopilot, count);
  autopilot.count = count;
  if (count == 0) return complete(autopilot, answers);
  autopilot.state = Autopilot::State::Receiving;
  autopilot.givesUpInMs = kGivesUpMs;
  autopilot.ask(answers);
}

void hearItem(Autopilot& autopilot, const Message& item, Answers& answers) {
  if (autopilot.state != Autopilot::State::Receiving) {
    return answers.acknowledge(autopilot.acceptsInMs != kNever ? kInvalidSequence : kError);
  }
  if (item.number != autopilot.expected) return answers.acknowledge(kInvalidSequence);
  if (autopilot.refused != 0 && item.number == autopilot.refused) {
    autopilot.forget();
    return answers.acknowledge(kUnsupported);
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
  autopilot.ask(answers);
}

void hearRequest(Autopilot& autopilot, uint16_t number, Answers& answers) {
  if (autopilot.state == Autopilot::State::Receiving) return answers.acknowledge(kDenied);
  const bool isHome = number == 0 && autopilot.type == kMission;
  if (!isHome && number >= autopilot.heldCount) return answers.acknowledge(kError);
  answers.add(message(Kind::Item, number, isHome ? kHome : autopilot.held[number]));
}

}  // namespace

void hearAsArduPilot(Autopilot& autopilot, const Message& heard, Answers& answers) {
  switch (heard.kind) {
    case Kind::Count: return hearCount(autopilot, heard.number, answers);
    case Kind::Item: return hearItem(autopilot, heard, answers);
    case Kind::Request: return hearRequest(autopilot, heard.number, answers);
    case Kind::List:
      if (autopilot.state == Autopilot::State::Receiving) return answers.acknowledge(kDenied);
      return answers.add(message(Kind::Count, autopilot.heldCount));
    case Kind::ClearAll:
      autopilot.forget();
      cut(autopilot, 0);
      return answers.acknowledge(kAccepted);
    default: return;  // a cancellation too: it times out
  }
}

void actAsArduPilot(Autopilot& autopilot, Answers& answers) {
  if (autopilot.acceptsInMs == 0) {
    autopilot.acceptsInMs = kNever;
    answers.acknowledge(kAccepted);
  }
  if (autopilot.givesUpInMs == 0) {
    autopilot.forget();
    return answers.acknowledge(kCancelled);
  }
  if (autopilot.asksInMs == 0) autopilot.ask(answers);
}
