// PX4: it keeps the old plan until the last item of the new one has come, asks again every 265 ms, gives up without a
// word 5 s after it heard something, ignores an item that it does not wait for, says ERROR ("busy") to a COUNT in
// mid-transfer, and ACCEPTED again to the last item repeated. Its ACK and COUNT carry a checksum of the plan.
#include <string.h>

#include "Autopilot.h"
#include "Plans.h"

namespace {

constexpr uint16_t kGivesUpMs = 5080;  // 5 s and the wait for its next round
typedef Autopilot::State State;

void hearCount(Autopilot& autopilot, uint16_t count, Answers& answers) {
  if (autopilot.state == State::Sending) return answers.acknowledge(kError);
  if (autopilot.state == State::Receiving) {
    autopilot.givesUpInMs = kGivesUpMs;
    if (autopilot.expected != 0) return answers.acknowledge(kError);  // "REJ. CMD: Busy", and the transfer goes on
    return autopilot.ask(answers);
  }
  if (autopilot.isUploadOpen) return answers.acknowledge(kError);
  autopilot.hasPartner = true;
  autopilot.stagedSum = 0;
  if (count == 0) {
    autopilot.keep(0);
    return answers.acknowledge(kAccepted);
  }
  autopilot.isUploadOpen = true;
  autopilot.state = State::Receiving;
  autopilot.expected = 0;
  autopilot.count = count;
  memset(autopilot.staged, 0, sizeof(autopilot.staged));
  autopilot.givesUpInMs = kGivesUpMs;
  autopilot.ask(answers);
}

void hearItem(Autopilot& autopilot, const Message& item, Answers& answers) {
  if (!autopilot.hasPartner) return;
  if (autopilot.state == State::Idle) {
    const bool isRepeated = autopilot.expected == item.number + 1;
    return answers.acknowledge(isRepeated ? kAccepted : kError, isRepeated ? autopilot.stagedSum : 0);
  }
  if (autopilot.state == State::Sending) return answers.acknowledge(kError);
  autopilot.givesUpInMs = kGivesUpMs;
  if (item.number != autopilot.expected) return;
  autopilot.stagedSum = checksummed(autopilot.stagedSum, item.item, autopilot.type);
  autopilot.staged[autopilot.expected++] = item.item;
  if (autopilot.expected < autopilot.count) return autopilot.ask(answers);
  autopilot.goIdle();
  autopilot.isUploadOpen = false;
  autopilot.keep(autopilot.count, autopilot.stagedSum);
  answers.acknowledge(kAccepted, autopilot.stagedSum);
}

void hearList(Autopilot& autopilot, Answers& answers) {
  // All of an earlier download was sent, only its ACK is missing. It also is so when an upload happens to have come
  // just as far as the old plan is long: that is dropped.
  if (autopilot.expected == autopilot.heldCount) autopilot.goIdle();
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
    autopilot.goIdle();
    return answers.acknowledge(kError);
  }
  answers.add(message(Kind::Item, number, autopilot.held[number]));
}

void hearAck(Autopilot& autopilot, uint16_t result) {
  if (!autopilot.hasPartner) return;
  if (autopilot.state == State::Sending) return autopilot.goIdle();
  if (autopilot.state != State::Receiving || result != kCancelled) return;
  autopilot.goIdle();
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
  from.forget();
  from.hasPartner = from.isUploadOpen = from.hasTransfer = false;
  from.stagedSum = 0;
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
      autopilot.keep(0);
      return answers.acknowledge(kAccepted);
    case Kind::Ack: return hearAck(autopilot, heard.number);
    default: return;
  }
}

void hearAsPx4OfKinds(Autopilot& has, Autopilot& other, const Message& heard, Answers& answers) {
  if (heard.type == has.type) return hearAsPx4(has, heard, answers);
  switch (heard.kind) {
    case Kind::Count:
      if (has.state != State::Idle || has.isUploadOpen) return hearAsPx4(has, heard, answers);  // asks, or is busy
      break;
    case Kind::List:
      if (has.expected == has.heldCount) has.goIdle();
      if (has.state != State::Idle) return;
      break;
    case Kind::ClearAll:
      if (has.state != State::Idle) return;
      break;
    case Kind::Item:
      if (has.hasPartner) answers.acknowledge(kError);
      return;
    case Kind::Ack:
      if (has.state == State::Receiving) hearAck(has, heard.number);
      return;
    default: return;
  }
  handOver(has, other);
  hearAsPx4(other, heard, answers);
}

void actAsPx4(Autopilot& autopilot, Answers& answers) {
  if (autopilot.givesUpInMs == 0) {
    autopilot.goIdle();
    autopilot.isUploadOpen = false;
    return;
  }
  if (autopilot.asksInMs == 0) autopilot.ask(answers);
}
