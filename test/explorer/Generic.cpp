// Servers of a firmware that the library does not know, by their sources; none of them has a home. What they do with an
// item's fields is not modelled here.
//
// Mavsdk: MAVSDK's mission server. It asks again 500 ms after the last item that it heard, whichever that was, gives up
// after five such requests, and says "unsupported" to MISSION_REQUEST.
// Betaflight: COUNT deletes the plan aboard; an item that it does not wait for ends the upload; it asks again after
// 1500 ms, five times; idle, it says nothing to an item. It does not know MISSION_REQUEST.
// Inav: each item replaces one of the plan aboard, and what is behind it; it asks again after 1000 ms, and when the
// item before comes again; any other ends the upload.
#include <string.h>

#include "Autopilot.h"
#include "Plans.h"

namespace {

constexpr uint8_t kMostRequests = 5;       // requests that draw no item
constexpr uint16_t kReadingEndsMs = 5000;  // of a download, without a request
typedef Autopilot::State State;

bool isBetaflight(const Autopilot& autopilot) { return autopilot.firmware == Firmwares::Betaflight; }
bool isInav(const Autopilot& autopilot) { return autopilot.firmware == Firmwares::Inav; }
uint16_t asksAgainMs(const Autopilot& autopilot) {
  return isBetaflight(autopilot) ? 1500 : isInav(autopilot) ? 1000 : 500;
}

void acknowledge(Answers& answers, Result result) { answers.add(message(Kind::Ack, result)); }

void ask(Autopilot& autopilot, Answers& answers) {
  autopilot.asksInMs = asksAgainMs(autopilot);
  answers.add(message(Kind::Request, autopilot.expected));
}

void goIdle(Autopilot& autopilot) {
  autopilot.state = State::Idle;
  autopilot.expected = autopilot.count = 0;
  autopilot.requests = 0;
  autopilot.asksInMs = autopilot.givesUpInMs = kNever;
  memset(autopilot.staged, 0, sizeof(autopilot.staged));
}

void end(Autopilot& autopilot, Answers& answers, Result result) {
  goIdle(autopilot);
  acknowledge(answers, result);
}

void hold(Autopilot& autopilot, uint16_t count) {
  memset(autopilot.held, 0, sizeof(autopilot.held));
  memcpy(autopilot.held, autopilot.staged, count);
  autopilot.heldCount = count;
}

void hearCount(Autopilot& autopilot, uint16_t count, Answers& answers) {
  goIdle(autopilot);
  if (isBetaflight(autopilot) || count == 0) hold(autopilot, 0);
  if (count == 0) return acknowledge(answers, kAccepted);
  autopilot.state = State::Receiving;
  autopilot.count = count;
  ask(autopilot, answers);
}

void hearItem(Autopilot& autopilot, const Message& item, Answers& answers) {
  if (autopilot.state != State::Receiving) {
    if (!isBetaflight(autopilot)) acknowledge(answers, kInvalidSequence);
    return;
  }
  if (item.number != autopilot.expected && isBetaflight(autopilot)) return end(autopilot, answers, kInvalidSequence);
  autopilot.requests = 0;
  autopilot.asksInMs = asksAgainMs(autopilot);
  if (item.number != autopilot.expected) {
    if (!isInav(autopilot)) return;
    if (item.number + 1 == autopilot.expected) return ask(autopilot, answers);
    return end(autopilot, answers, kInvalidSequence);
  }
  autopilot.staged[autopilot.expected++] = item.item;
  if (isInav(autopilot)) hold(autopilot, autopilot.expected);
  if (autopilot.expected < autopilot.count) return ask(autopilot, answers);
  hold(autopilot, autopilot.count);
  end(autopilot, answers, kAccepted);
}

void hearList(Autopilot& autopilot, Answers& answers) {
  goIdle(autopilot);
  autopilot.state = State::Sending;
  autopilot.givesUpInMs = kReadingEndsMs;
  answers.add(message(Kind::Count, autopilot.heldCount));
}

void hearRequest(Autopilot& autopilot, uint16_t number, Answers& answers) {
  if (autopilot.state != State::Sending) return;
  if ((number != autopilot.expected && number + 1 != autopilot.expected) || number >= autopilot.heldCount) {
    return end(autopilot, answers, kInvalidSequence);
  }
  autopilot.expected = static_cast<uint16_t>(number + 1);
  autopilot.givesUpInMs = kReadingEndsMs;
  answers.add(message(Kind::Item, number, autopilot.held[number]));
}

}  // namespace

void hearAsGeneric(Autopilot& autopilot, const Message& heard, Answers& answers) {
  switch (heard.kind) {
    case Kind::Count: return hearCount(autopilot, heard.number, answers);
    case Kind::Item: return hearItem(autopilot, heard, answers);
    case Kind::Request: return hearRequest(autopilot, heard.number, answers);
    case Kind::OlderRequest:
      if (!isBetaflight(autopilot)) acknowledge(answers, kUnsupported);
      return;
    case Kind::List: return hearList(autopilot, answers);
    case Kind::ClearAll:
      goIdle(autopilot);
      hold(autopilot, 0);
      return acknowledge(answers, kAccepted);
    case Kind::Ack:
      if (autopilot.state == State::Sending) goIdle(autopilot);
      return;
    case Kind::Heartbeat:
    case Kind::File:
    case Kind::FileReply: return;
  }
}

void actAsGeneric(Autopilot& autopilot, Answers& answers) {
  if (autopilot.givesUpInMs == 0) return goIdle(autopilot);
  if (autopilot.asksInMs != 0) return;
  if (autopilot.requests == kMostRequests) return end(autopilot, answers, kCancelled);
  ++autopilot.requests;
  ask(autopilot, answers);
}
