#include "mavmission/transfer/UploadTransfer.h"

#include <doctest/doctest.h>
#include <string.h>

#include <string>

#include "Script.h"

using namespace mavmission;
using namespace mavmission::detail;
using Send = UploadTransfer::Send;

namespace {

constexpr Firmware kArduPilot = Firmware::ArduPilot, kPx4 = Firmware::Px4, kOther = Firmware::Other;
constexpr Firmware kEach[] = {kArduPilot, kPx4, kOther};
const uint8_t kNothing = 0, kError = 1, kInvalidSequence = 13;

class Upload : public Player {
 public:
  UploadTransfer transfer;

  explicit Upload(uint16_t count, Firmware firmware = kOther, uint8_t leftovers = 0, uint16_t startMs = 65000)
      : Player(startMs) {
    memset(static_cast<void*>(&transfer), 0xA5, sizeof(transfer));  // whatever another operation has left there
    transfer.begin(count, firmware, leftovers);
  }

  Send sendOne() {
    const Send send = transfer.toSend();
    if (send != Send::Nothing) transfer.sent(now());
    return send;
  }

 private:
  // asks N: a request for this item; accepted, error, denied, cancelled, out of sequence, result N: MISSION_ACK
  // takes one: the line takes one message; progress: notes how many items were asked for
  void happens(const Event& event) override {
    if (event.is("sleep")) status_ = onTime();  // loop() comes back so much later
    if (event.is("asks")) status_ = transfer.onRequest(static_cast<uint16_t>(event.number), now(), pace);
    if (event.is("accepted")) answer(0);
    if (event.is("error")) answer(kError);
    if (event.is("out of sequence")) answer(kInvalidSequence);
    if (event.is("denied")) answer(14);
    if (event.is("cancelled")) answer(15);
    if (event.is("result")) answer(static_cast<uint8_t>(event.number));
    if (event.is("takes one")) leaveOne();
    if (event.is("progress")) note("asked for", transfer.itemsAskedFor());
  }
  void answer(uint8_t result) { status_ = transfer.onAck(result, now(), pace); }
  Status onTime() override { return transfer.onTime(now(), pace); }
  void leave() override {
    while (!isFull_ && transfer.toSend() != Send::Nothing) leaveOne();
  }
  void leaveOne() {
    const uint16_t item = transfer.itemToSend();
    switch (sendOne()) {
      case Send::Nothing: break;
      case Send::Count: note("count"); break;
      case Send::Cancel:
        if (!isFull_) sendOne();
        note(isFull_ ? "cancel" : "cancel and count");
        break;
      case Send::Item:
      case Send::NextItem: note("item", item); break;
    }
  }
};

std::string number(unsigned number) { return std::to_string(number); }

}  // namespace

TEST_CASE("a plan goes out item by item, each for one request, and ends with the acknowledgement") {
  CHECK(Upload(3).plays("asks 0, wait 20, asks 1, wait 20, asks 2, progress, wait 20, accepted") ==
        "count, item 0, 20 item 1, 20 item 2, asked for 3, 20 Accepted");
}

TEST_CASE("a COUNT that the line has not taken yet is not counted, and no time runs") {
  CHECK(Upload(3).plays("line full, wait 60000, line free, silence") ==
        "60000 count, 1500 count (4 times), 1500 NoAnswer");
}

TEST_CASE("an autopilot that falls silent is waited for, 8.5 s from the last new item") {
  CHECK(Upload(5).plays("asks 0, silence") == "count, item 0, 8500 TimedOut");  // no item goes out unasked
  CHECK(Upload(5).plays("asks 0 to 2, silence") == "count, item 0 to 2, 8500 TimedOut");
}

TEST_CASE("on a lossy link, an error long after the last new request says that PX4 has given the upload up") {
  Upload px4(3, kPx4, kFromOpen);
  px4.plays("lossy, asks 0 to 1, wait 2499");
  CHECK(Upload(px4).ends("error") == "goes on");
  CHECK(px4.ends("wait 1, error") == "TimedOut");
  CHECK(px4.ends("wait 2600, error") == "TimedOut");
  Upload asleep(3, kPx4, kFromOpen);
  asleep.plays("lossy, asks 0 to 1");
  asleep.sleep(5100);
  CHECK(asleep.ends("error") == "goes on");  // nothing was repeated unasked that it could answer
}

TEST_CASE("the last item is repeated when the final answer is overdue, 5 times, 1500 ms apart") {
  CHECK(Upload(2).plays("asks 0 to 1, silence") == "count, item 0 to 1, 1500 item 1 (5 times), 1500 Unconfirmed");
}

TEST_CASE("an acknowledgement that comes late is one") {
  CHECK(Upload(2).plays("asks 0 to 1, wait 2500, accepted") == "count, item 0 to 1, 1500 item 1, 1000 Accepted");
}

TEST_CASE("a request within 50 ms of its answer is a queue being emptied") {
  CHECK(Upload(5).plays("asks 0, wait 49, asks 0, wait 1, asks 0") == "count, item 0, 50 item 0");
}

TEST_CASE("a request for an earlier item is late; if it still comes 500 ms after a newer one, it decides") {
  // At first it holds items 0 to 2. The second request for item 1 was late, too.
  CHECK(Upload(5).plays("asks 0 to 3, wait 499, asks 1, progress, wait 1, asks 1, progress, asks 4, accepted") ==
        "count, item 0 to 3, 499 asked for 4, 1 item 1, asked for 2, item 4, Accepted");
}

TEST_CASE("an item that is asked for again and again, after one that was taken for received, is sent again and again") {
  // The answer is to item 0, which stood still somewhere. No item is said to have arrived whose next was not asked for.
  Upload upload(5, kArduPilot);
  CHECK(upload.plays("asks 0 to 1, lossy, sleep 250, out of sequence, progress, sleep 300, asks 1") ==
        "count, item 0 to 1, 250 item 1, item 2, asked for 2, 300 item 2, item 1");
  CHECK(upload.plays(times(20, "sleep 100") + "asks 2") == "100 item 1 (20 times), item 2");
}

TEST_CASE("whatever is said before the first COUNT has left is about something earlier") {
  for (uint16_t count : {uint16_t(0), uint16_t(3)}) {
    for (unsigned result = 0; result <= 255; ++result) {
      Upload upload(count, kEach[result % 3], result % 2);
      CHECK(upload.plays("line full, result " + number(result) + ", line free") == "count");
    }
  }
  // A request is of an earlier transfer, which is not served.
  CHECK(Upload(3, kArduPilot, kFromOpen).plays("line full, asks 0, progress, line free, asks 0") ==
        "asked for 0, count, item 0");
}

TEST_CASE(
    "a busy PX4 that still asks in its old transfer is not served before that has been ended and COUNT sent again") {
  CHECK(Upload(3, kPx4).plays("line full, takes one, error, " + times(3, "asks 0, takes one")) ==
        "count, cancel, count, item 0");
}

TEST_CASE("a request beyond the plan shows another upload: ours begins again, once, and its acceptance is no proof") {
  for (Firmware firmware : {kArduPilot, kPx4}) {
    CHECK(Upload(3, firmware).plays("asks 0 to 3, asks 0 to 2, asks 7, accepted") ==
          "count, item 0 to 2, cancel and count, item 0 to 2, Unconfirmed");
  }
  CHECK(Upload(3).plays("asks 0 to 3, accepted") == "count, item 0 to 2, Unconfirmed");
}

TEST_CASE("accepted before every item was asked for, and has left, is said as such") {
  CHECK(Upload(3).plays("accepted") == "count, AcceptedEarly");
  CHECK(Upload(3).plays("asks 0, accepted") == "count, item 0, AcceptedEarly");
  CHECK(Upload(3).plays("asks 0 to 1, accepted") == "count, item 0 to 1, AcceptedEarly");
  CHECK(Upload(2).plays("asks 0, line full, asks 1, accepted") == "count, item 0, AcceptedEarly");
}

TEST_CASE(
    "with leftovers an early acceptance may be of the plan before: it ends nothing, but is the reason if nothing else "
    "comes") {
  CHECK(Upload(3, kOther, kFromOpen).plays("accepted, asks 0, silence") == "count, item 0, 8500 AcceptedEarly");
}

TEST_CASE("each refusal ends the transfer in each state, but for the words that may be noise") {
  for (uint8_t result = 1; result <= 30; ++result) {
    for (unsigned asked = 0; asked <= 3; ++asked) {
      std::string expected = nameOf(fromMissionResult(result));
      if (result == kError && asked == 0) expected = "goes on";
      // It has given the upload up, or is idle after the last item.
      if (result == kInvalidSequence && asked != 0) expected = asked < 3 ? "TimedOut" : "Unconfirmed";
      CAPTURE(asked);
      Upload upload(3);
      upload.plays(asked == 0 ? "wait 0" : "asks 0 to " + number(asked - 1));
      CHECK(upload.ends("result " + number(result)) == expected);
    }
  }
  for (const Firmware firmware : {kArduPilot, kPx4}) {
    CHECK(Upload(3, firmware).ends("asks 0, out of sequence, asks 1, out of sequence, asks 2, out of sequence") ==
          "goes on");
  }
}

TEST_CASE("a PX4 that may be busy with what was ours is told so and asked every 1500 ms, beyond its own 5 s") {
  for (unsigned unanswered = 0; unanswered < 5; ++unanswered) {
    Upload upload(3, kPx4, kFromBusy);
    upload.plays("wait " + number(1500 * unanswered));
    // Each error is brought twice, up to 6 s after the first that PX4 was freed for.
    CHECK(upload.plays("error, " + times(4, "error, error, wait 1500") + "error") ==
          "cancel and count, 1500 cancel and count (4 times), Error");
  }
}

TEST_CASE("a PX4 that was busy and then asks for items is served, and what it said before is no reason for anything") {
  CHECK(Upload(2, kPx4, kFromBusy).plays("error, error, asks 0, silence") ==
        "count, cancel and count, item 0, 8500 TimedOut");
  // The error of a COUNT that was sent before PX4 was freed is noise in mid-transfer.
  CHECK(Upload(2, kPx4).plays("wait 1500, error, asks 0, error, asks 1, accepted") ==
        "count, 1500 count, cancel and count, item 0 to 1, Accepted");
}

TEST_CASE("PX4's error in mid-transfer may be to a COUNT that came again: it is the reason if nothing else comes") {
  CHECK(Upload(3, kPx4).plays("asks 0, error, silence") == "count, item 0, 8500 Error");
  CHECK(Upload(3, kPx4).plays("wait 1500, asks 0, error, silence") == "count, 1500 count, item 0, 8500 Error");
  CHECK(Upload(3, kArduPilot).plays("wait 1500, asks 0, error") == "count, 1500 count, item 0, Error");
  CHECK(Upload(3, kArduPilot).plays("error") == "count, Error");
}

TEST_CASE("an error after the last item is about that item, but for PX4, which says so to a COUNT that came again") {
  for (const Firmware firmware : kEach) {
    const bool isPx4 = firmware == kPx4;
    CHECK(Upload(2, firmware).ends("asks 0 to 1, error") == (isPx4 ? "goes on" : "Error"));
    // To our own repetition of the last item it tells nothing of the plan; PX4 may yet accept.
    CHECK(Upload(2, firmware).ends("asks 0 to 1, wait 1500, error") == (isPx4 ? "goes on" : "Unconfirmed"));
    // Nor if that was asked for twice: the autopilot may be idle.
    CHECK(Upload(2, firmware).plays("asks 0 to 1, wait 200, asks 1, error, accepted") ==
          "count, item 0 to 1, 200 item 1, Accepted");
  }
}

TEST_CASE("an acceptance of a last item that is repeated after an error is no acceptance of the plan") {
  CHECK(Upload(2, kPx4).plays("asks 0 to 1, wait 200, asks 1, error, wait 1500, accepted") ==
        "count, item 0 to 1, 200 item 1, 1500 item 1, Unconfirmed");
}

TEST_CASE(
    "the autopilot's own cancelling ends the transfer, but not one that it has not begun yet if leftovers may be "
    "meant") {
  CHECK(Upload(3, kArduPilot, kFromOpen).plays("asks 0, cancelled") == "count, item 0, CancelledByAutopilot");
  CHECK(Upload(3, kArduPilot, kFromOpen).plays("cancelled, asks 0") == "count, item 0");
  CHECK(Upload(3, kArduPilot).plays("cancelled") == "count, CancelledByAutopilot");
}

TEST_CASE("a transfer that is begun again after an older one has all its tries") {
  Upload again(2, kPx4, kFromOpen);
  CHECK(again.plays("asks 0 to 1, wait 1500, asks 2, progress") ==
        "count, item 0 to 1, 1500 item 1, cancel and count, asked for 0");
  CHECK(Upload(again).plays("silence") == "1500 cancel and count (4 times), 1500 NoAnswer");
  // An error may be to one of the COUNTs before: it is the reason if nothing else comes.
  CHECK(Upload(again).plays("asks 0, error, silence") == "item 0, 8500 Error");
  CHECK(again.plays("asks 0 to 1, accepted") == "item 0 to 1, Unconfirmed");
}

TEST_CASE("of a part only its own items are served, from its first one on, which shows the round trip") {
  Upload part(6, kArduPilot);
  part.transfer.limitTo(2, 4);
  CHECK(part.plays("progress, asks 0 to 1, asks 3, wait 40, asks 2") == "count, asked for 2, 40 item 2");
  CHECK(part.pace.roundTripMs() == 40);
  CHECK(Upload(part).plays("asks 3, asks 1, accepted") == "item 3, Accepted");
  CHECK(part.plays("asks 3 to 4, accepted") == "item 3, Unconfirmed");  // it receives more than this part
}

TEST_CASE(
    "denied ends a transfer, but for a part, which may have been announced twice: it is the reason if nothing else "
    "comes") {
  const char* const kCounts[] = {"1500 count (4 times), 1500 Denied", "1500 count (3 times), 1500 Denied"};
  for (unsigned first : {0u, 2u}) {
    for (unsigned again : {0u, 1u}) {
      for (bool begun : {false, true}) {
        Upload upload(4, kArduPilot);
        upload.transfer.limitTo(static_cast<uint16_t>(first), 4);
        upload.plays("wait " + number(1500 * again) + (begun ? ", asks " + number(first) : ""));
        CHECK(upload.plays("denied, silence") == (first == 0 ? "Denied" : begun ? "8500 Denied" : kCounts[again]));
      }
    }
  }
}

TEST_CASE("the next item may be made ready from COUNT on, until the last one has been asked for") {
  Upload upload(2);
  for (const char* happens : {"line full", "line free", "line full, asks 0", "line free"}) {
    upload.plays(happens);
    CHECK(upload.transfer.expectsRequest());
  }
  for (const char* happens : {"line full, asks 1", "line free"}) {
    upload.plays(happens);
    CHECK_FALSE(upload.transfer.expectsRequest());
  }
  CHECK_FALSE(Upload(0).transfer.expectsRequest());
}

TEST_CASE("an acceptance of a repeated last item is in doubt only on PX4, with leftovers") {
  for (Firmware firmware : kEach) {
    for (uint8_t leftovers : {kNothing, uint8_t{kFromOpen}}) {
      const bool isDoubtful = firmware == kPx4 && leftovers != 0;
      CHECK(Upload(1, firmware, leftovers).plays("asks 0, wait 1500, accepted") ==
            std::string("count, item 0, 1500 item 0, ") + (isDoubtful ? "Unconfirmed" : "Accepted"));
    }
  }
}

TEST_CASE("a transfer is suspected from an answer on that may be to an earlier one, until its last item has left") {
  Upload upload(1, kArduPilot, kFromOpen);
  upload.plays("wait 1");
  CHECK_FALSE(upload.transfer.isSuspected());
  upload.plays("out of sequence");
  CHECK(upload.transfer.isSuspected());
  upload.plays("asks 0");
  CHECK_FALSE(upload.transfer.isSuspected());
}

TEST_CASE("an upload remembers whether an item was asked for by MISSION_REQUEST_INT, and whether it was proven") {
  Upload upload(1);
  CHECK_FALSE((upload.transfer.isAskedByInt() || upload.transfer.isProven()));
  upload.transfer.noteInt();
  CHECK((upload.transfer.isAskedByInt() && !upload.transfer.isProven()));
  upload.transfer.noteProven();
  CHECK(upload.transfer.isProven());
}

TEST_CASE("every wait is the same wherever the clock wraps in it") {
  for (uint32_t start = 65535 - 9000; start <= 65535; start += 250) {
    const auto upload = [start](uint16_t count) { return Upload(count, kOther, 0, static_cast<uint16_t>(start)); };
    CHECK(upload(3).plays("wait 1500") == "count, 1500 count");
    CHECK(upload(3).plays("asks 0, silence") == "count, item 0, 8500 TimedOut");
    CHECK(upload(1).plays("asks 0, wait 1500") == "count, item 0, 1500 item 0");
  }
}

TEST_CASE("whatever is heard in whatever order, accepted means that every item was asked for and the last one left") {
  uint32_t seed = 99;
  for (int round = 0; round < 20000; ++round) {
    const uint16_t count = static_cast<uint16_t>(round % 4);
    Upload upload(count, kEach[round % 3], round % 5 == 0, static_cast<uint16_t>(seed));
    bool lastLeft = count == 0;
    Status status = Status::Transferring;
    uint32_t spentMs = 0;
    int steps = 0;
    for (; status == Status::Transferring && steps < 1000; ++steps) {
      seed = seed * 1664525 + 1013904223;
      const uint8_t dice = static_cast<uint8_t>(seed >> 24);
      const uint16_t number = static_cast<uint16_t>(seed >> 8);
      if (dice % 2) {
        const bool isLast = upload.transfer.itemToSend() + 1 == count;
        if (upload.sendOne() == Send::Item && isLast) lastLeft = true;
      }
      if (dice < 60) {
        status = upload.transfer.onRequest(number % 5, upload.now(), upload.pace);
      } else if (dice < 80) {
        status = upload.transfer.onAck(static_cast<uint8_t>(number % 18), upload.now(), upload.pace);
      } else {
        spentMs += number % 700;
        upload.sleep(number % 700);
        status = upload.transfer.onTime(upload.now(), upload.pace);
      }
      if (status == Status::Accepted) REQUIRE(lastLeft);
    }
    REQUIRE(steps < 1000);
    REQUIRE(spentMs < 120000);
  }
}

TEST_CASE("on a lossy link, an unknown server gets room for its own timeout after each eight of an item") {
  // Until the time for the next request is over.
  CHECK(Upload(3).plays("asks 0, lossy, silence") ==
        "count, item 0, " + times(8, "50 item 0 (7 times), 700 item 0") + "50 item 0, 50 TimedOut");
}

TEST_CASE("on a lossy link, an item is sent again when its answer is overdue, the last one every 50 ms") {
  for (const Firmware firmware : {kArduPilot, kPx4}) {  // three quarters of 18 ms
    CHECK(Upload(2, firmware).plays("wait 18, asks 0, lossy, wait 280, asks 1, wait 1000") ==
          "count, 18 item 0, 14 item 0 (20 times), item 1, 50 item 1 (20 times)");
  }
  CHECK(Upload(2).plays("asks 0 to 1, lossy, silence") ==
        "count, item 0 to 1, " + times(8, "50 item 1 (7 times), 700 item 1") + "50 item 1 (7 times), 250 Unconfirmed");
}

TEST_CASE("on a lossy link, PX4 gets four copies of an item, then the next one in turn, but not the last one") {
  Upload px4(4, kPx4);
  CHECK(px4.plays("asks 0, lossy, wait 36") == "count, item 0, 12 item 0 (3 times)");
  CHECK(px4.transfer.isLastItemRefused());
  CHECK(px4.plays("wait 60, progress") == "12 item 1, 12 item 0, 12 item 1, 12 item 0, 12 item 1, asked for 1");
  CHECK_FALSE(px4.transfer.isLastItemRefused());
  // It asks for the first of them once more.
  CHECK(Upload(px4).plays("wait 12, line full, wait 12, asks 0, line free") == "12 item 0 (2 times)");
  // It asks for the second, and all is as if that had not left yet.
  CHECK(Upload(px4).plays("asks 1, progress, wait 150") == "item 1, asked for 2, 50 item 1 (3 times)");
  // It asks for the one after, since it has taken both; the one after that is the last.
  CHECK(Upload(px4).plays("asks 2, progress, asks 3, accepted") == "item 2, asked for 3, item 3, Accepted");
  CHECK(Upload(4, kPx4).plays("lossy, wait 9, asks 0, wait 9, asks 1, wait 9, asks 2, wait 240") ==
        "count, 9 item 0, 9 item 1, 9 item 2, 12 item 2 (20 times)");
  // What it asks for beyond that answers nothing that has left.
  CHECK(px4.plays("asks 3, progress") == "asked for 1");
}

TEST_CASE("where answers come late, each copy is of the item that PX4 has asked for") {
  Upload near(9, kPx4), far(9, kPx4);
  CHECK(near.plays("wait 49, asks 0, lossy, wait 148, asks 2, progress") ==
        "count, 49 item 0, 37 item 0 (3 times), 37 item 1, item 2, asked for 3");
  CHECK(far.plays("wait 50, asks 0, lossy, wait 200, asks 2, progress") == "count, 50 item 0 (5 times), asked for 1");
  CHECK(near.pace.roundTripMs() == 49);  // a jump over what has left is no late answer
  CHECK(far.pace.roundTripMs() == 50);
}

TEST_CASE("a request that is repeated says that the line loses; one of a queue that is being emptied does not") {
  Upload upload(3);
  CHECK(upload.plays("asks 0, wait 49, asks 0, wait 1, asks 0, wait 499, asks 0") ==
        "count, item 0, 50 item 0, 499 item 0");
  CHECK_FALSE(upload.pace.isLossy());
  CHECK(upload.plays("wait 500, asks 0") == "500 item 0");
  CHECK(upload.pace.isLossy());
}

TEST_CASE("the first answer says how long a round trip takes, at the most; of repeats it is the first that counts") {
  // What comes within that time, and 50 ms, of item 0 is to what was sent before.
  CHECK(Upload(4, kArduPilot).plays("lossy, wait 999, asks 0, wait 1048, out of sequence, wait 1, out of sequence") ==
        "count, 50 count (19 times), 49 item 0, 100 item 0 (10 times), 49 item 1");
}

TEST_CASE("while PX4 may be busy with an earlier transfer, COUNT is repeated every 1500 ms on a lossy link too") {
  CHECK(Upload(3, kPx4, kFromBusy).plays("lossy, error, wait 1500") ==
        "count, cancel and count, 1500 cancel and count");
}

TEST_CASE("on a lossy link, COUNT is sent again for 7.5 s, before ArduPilot would give up what it has heard") {
  CHECK(Upload(3, kArduPilot).plays("lossy, silence") == "count, 50 count (149 times), 50 NoAnswer");
}

TEST_CASE("ArduPilot's word that an item is out of sequence means that it has it, if no answer to another can come") {
  // The first may be to the item before. Of the last item it is no word.
  const char* const script = "asks 0 to 1, out of sequence, lossy, sleep 250, out of sequence, out of sequence";
  CHECK(Upload(3, kArduPilot).plays(std::string(script) + ", accepted") ==
        "count, item 0 to 1, 250 item 1, item 2, Accepted");
  CHECK(Upload(3, kPx4).plays(script) == "count, item 0 to 1, 250 item 1");
  // Where an earlier transfer may be what is accepted, the last item is sent only when it is asked for.
  CHECK(Upload(3, kArduPilot, kFromOpen).plays(script) == "count, item 0 to 1, 250 item 1");

  Upload slow(3, kArduPilot);
  slow.plays("wait 300, asks 0, lossy, wait 300, asks 1");
  CHECK(slow.plays(times(6, "wait 50, out of sequence")) == "50 item 1 (6 times)");  // each is to a repeat of item 0
  CHECK(slow.plays("wait 50, out of sequence") == "50 item 1, item 2");
}
