// PX4: it keeps the old plan until the last item of the new one has come, asks again every 265 ms, gives up without a
// word 5 s after it heard something, ignores an item that it does not wait for, says ERROR ("busy") to a COUNT in
// mid-transfer, and ACCEPTED again to the last item repeated. Its ACK and COUNT carry a checksum of the plan.
#include <string.h>

#include "Autopilot.h"
#include "Plans.h"

namespace {

constexpr uint16_t kAsksAgainMs = 265, kGivesUpMs = 5080;  // 5 s and the wait for its next round
typedef Autopilot::State State;

void acknowledge(Answers& answers, Result result, uint32_t opaqueId = 0) {
  answers.add(message(Kind::Ack, result, 0, opaqueId));
}

void ask(Autopilot& autopilot, Answers& answers) {
  autopilot.asksInMs = kAsksAgainMs;
  answers.add(message(Kind::Request, autopilot.expected));
}

void goIdle(Autopilot& autopilot) {
  autopilot.state = State::Idle;
  autopilot.asksInMs = autopilot.givesUpInMs = kNever;
}

void hold(Autopilot& autopilot, const uint8_t* items, uint16_t count, uint32_t sum) {
  memset(autopilot.held, 0, sizeof(autopilot.held));
  memcpy(autopilot.held, items, count);
  autopilot.heldCount = count;
  autopilot.heldSum = sum;
}

void hearCount(Autopilot& autopilot, uint16_t count, Answers& answers) {
  if (autopilot.state == State::Sending) return acknowledge(answers, kError);
  if (autopilot.state == State::Receiving) {
    autopilot.givesUpInMs = kGivesUpMs;
    if (autopilot.expected != 0) return acknowledge(answers, kError);  // "REJ. CMD: Busy", and the transfer goes on
    return ask(autopilot, answers);
  }
  if (autopilot.isUploadOpen) return acknowledge(answers, kError);
  autopilot.hasPartner = true;
  autopilot.stagedSum = 0;
  if (count == 0) {
    hold(autopilot, nullptr, 0, 0);
    return acknowledge(answers, kAccepted);
  }
  autopilot.isUploadOpen = true;
  autopilot.state = State::Receiving;
  autopilot.expected = 0;
  autopilot.count = count;
  memset(autopilot.staged, 0, sizeof(autopilot.staged));
  autopilot.givesUpInMs = kGivesUpMs;
  ask(autopilot, answers);
}

void hearItem(Autopilot& autopilot, const Message& item, Answers& answers) {
  if (!autopilot.hasPartner) return;
  if (autopilot.state == State::Idle) {
    const bool isRepeated = autopilot.expected == item.number + 1;
    return acknowledge(answers, isRepeated ? kAccepted : kError, isRepeated ? autopilot.stagedSum : 0);
  }
  if (autopilot.state == State::Sending) return acknowledge(answers, kError);
  autopilot.givesUpInMs = kGivesUpMs;
  if (item.number != autopilot.expected) return;
  autopilot.stagedSum = checksummed(autopilot.stagedSum, item.item, autopilot.type);
  autopilot.staged[autopilot.expected++] = item.item;
  if (autopilot.expected < autopilot.count) return ask(autopilot, answers);
  goIdle(autopilot);
  autopilot.isUploadOpen = false;
  hold(autopilot, autopilot.staged, autopilot.count, autopilot.stagedSum);
  acknowledge(answers, kAccepted, autopilot.stagedSum);
}

void hearList(Autopilot& autopilot, Answers& answers) {
  // All of an earlier download was sent, only its ACK is missing. It also is so when an upload happens to have come
  // just as far as the old plan is long: that is dropped.
  if (autopilot.expected == autopilot.heldCount) goIdle(autopilot);
  if (autopilot.state == State::Receiving) return;
  autopilot.state = State::Sending;
  autopilot.hasPartner = true;
  autopilot.expected = 0;
  autopilot.count = autopilot.heldCount;
  autopilot.asksInMs = kNever;
  autopilot.givesUpInMs = kGivesUpMs;
  answers.add(message(Kind::Count, autopilot.count, 0, autopilot.heldSum));
}

void hearRequest(Autopilot& autopilot, uint16_t number, Answers& answers) {
  if (!autopilot.hasPartner || autopilot.state != State::Sending) return;
  autopilot.givesUpInMs = kGivesUpMs;
  const bool isNext = number == autopilot.expected && autopilot.expected < autopilot.count;
  if (isNext) ++autopilot.expected;
  if ((!isNext && number + 1 != autopilot.expected) || number >= autopilot.heldCount) {
    goIdle(autopilot);
    return acknowledge(answers, kError);
  }
  answers.add(message(Kind::Item, number, autopilot.held[number]));
}

void hearAck(Autopilot& autopilot, uint16_t result) {
  if (!autopilot.hasPartner) return;
  if (autopilot.state == State::Sending) return goIdle(autopilot);
  if (autopilot.state != State::Receiving || result != kCancelled) return;
  goIdle(autopilot);
  autopilot.isUploadOpen = false;
}

// The one transfer becomes one of the other kind: how far the last one came stays, and what it staged.
void handOver(Autopilot& from, Autopilot& to) {
  to.expected = from.expected;
  to.count = from.count;
  to.hasPartner = from.hasPartner;
  to.isUploadOpen = from.isUploadOpen;
  to.stagedSum = from.stagedSum;
  memcpy(to.staged, from.staged, sizeof(to.staged));
  to.hasTransfer = true;
  from.expected = from.count = 0;
  from.hasPartner = from.isUploadOpen = from.hasTransfer = false;
  from.stagedSum = 0;
  memset(from.staged, 0, sizeof(from.staged));
}

}  // namespace

void hearAsPx4(Autopilot& autopilot, const Message& heard, Answers& answers) {
  switch (heard.kind) {
    case Kind::Count: return hearCount(autopilot, heard.number, answers);
    case Kind::Item: return hearItem(autopilot, heard, answers);
    case Kind::Request: return hearRequest(autopilot, heard.number, answers);
    case Kind::List: return hearList(autopilot, answers);
    case Kind::ClearAll:
      if (autopilot.state != State::Idle) return;  // without a word
      hold(autopilot, nullptr, 0, 0);
      return acknowledge(answers, kAccepted);
    case Kind::Ack: return hearAck(autopilot, heard.number);
    case Kind::OlderRequest:
    case Kind::Heartbeat:
    case Kind::File:
    case Kind::FileReply: return;
  }
}

void hearAsPx4OfKinds(Autopilot& has, Autopilot& other, const Message& heard, Answers& answers) {
  if (heard.type == has.type) return hearAsPx4(has, heard, answers);
  switch (heard.kind) {
    case Kind::Count:
      if (has.state != State::Idle || has.isUploadOpen) return hearAsPx4(has, heard, answers);  // asks, or is busy
      break;
    case Kind::List:
      if (has.expected == has.heldCount) goIdle(has);
      if (has.state != State::Idle) return;
      break;
    case Kind::ClearAll:
      if (has.state != State::Idle) return;
      break;
    case Kind::Item:
      if (has.hasPartner) acknowledge(answers, kError);
      return;
    case Kind::Ack:
      if (has.state == State::Receiving) hearAck(has, heard.number);
      return;
    case Kind::Request:
    case Kind::OlderRequest:
    case Kind::Heartbeat:
    case Kind::File:
    case Kind::FileReply: return;
  }
  handOver(has, other);
  hearAsPx4(other, heard, answers);
}

void actAsPx4(Autopilot& autopilot, Answers& answers) {
  if (autopilot.givesUpInMs == 0) {
    goIdle(autopilot);
    autopilot.isUploadOpen = false;
    return;
  }
  if (autopilot.asksInMs == 0) ask(autopilot, answers);
}
