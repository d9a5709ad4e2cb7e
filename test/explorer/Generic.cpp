// Servers of a firmware that the library does not know, by their sources; none of them has a home. What they do with an
// item's fields is not modelled here.
//
// Mavsdk: MAVSDK's mission server. It asks again 500 ms after the last item that it heard, whichever that was, gives up
// after five such requests, and says "unsupported" to MISSION_REQUEST.
// Betaflight: COUNT deletes the plan aboard; an item that it does not wait for ends the upload; it asks again after
// 1500 ms, five times; idle, it says nothing to an item. It does not know MISSION_REQUEST.
// Inav: each item replaces one of the plan aboard, and what is behind it; it asks again after 1000 ms, and when the
// item before comes again; any other ends the upload.
#include "Autopilot.h"

namespace {

constexpr uint8_t kMostRequests = 5;       // requests that draw no item
constexpr uint16_t kReadingEndsMs = 5000;  // of a download, without a request
typedef Autopilot::State State;

bool isBetaflight(const Autopilot& autopilot) { return autopilot.firmware == Firmwares::Betaflight; }
bool isInav(const Autopilot& autopilot) { return autopilot.firmware == Firmwares::Inav; }

void end(Autopilot& autopilot, Answers& answers, Result result) {
  autopilot.forget();
  answers.acknowledge(result);
}

void hearCount(Autopilot& autopilot, uint16_t count, Answers& answers) {
  autopilot.forget();
  if (isBetaflight(autopilot) || count == 0) autopilot.keep(0);
  if (count == 0) return answers.acknowledge(kAccepted);
  autopilot.state = State::Receiving;
  autopilot.count = count;
  autopilot.ask(answers);
}

void hearItem(Autopilot& autopilot, const Message& item, Answers& answers) {
  if (autopilot.state != State::Receiving) {
    if (!isBetaflight(autopilot)) answers.acknowledge(kInvalidSequence);
    return;
  }
  if (item.number != autopilot.expected && isBetaflight(autopilot)) return end(autopilot, answers, kInvalidSequence);
  autopilot.requests = 0;
  autopilot.asksInMs = autopilot.asksAgainMs();
  if (item.number != autopilot.expected) {
    if (!isInav(autopilot)) return;
    if (item.number + 1 == autopilot.expected) return autopilot.ask(answers);
    return end(autopilot, answers, kInvalidSequence);
  }
  autopilot.staged[autopilot.expected++] = item.item;
  if (isInav(autopilot)) autopilot.keep(autopilot.expected);
  if (autopilot.expected < autopilot.count) return autopilot.ask(answers);
  autopilot.keep(autopilot.count);
  end(autopilot, answers, kAccepted);
}

void hearList(Autopilot& autopilot, Answers& answers) {
  autopilot.forget();
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
      if (!isBetaflight(autopilot)) answers.acknowledge(kUnsupported);
      return;
    case Kind::List: return hearList(autopilot, answers);
    case Kind::ClearAll:
      autopilot.forget();
      autopilot.keep(0);
      return answers.acknowledge(kAccepted);
    case Kind::Ack:
      if (autopilot.state == State::Sending) autopilot.forget();
      return;
    case Kind::Heartbeat:
    case Kind::File:
    case Kind::FileReply: return;
  }
}

void actAsGeneric(Autopilot& autopilot, Answers& answers) {
  if (autopilot.givesUpInMs == 0) return autopilot.forget();
  if (autopilot.asksInMs != 0) return;
  if (autopilot.requests == kMostRequests) return end(autopilot, answers, kCancelled);
  ++autopilot.requests;
  autopilot.ask(answers);
}
