#include "mavmission/transfer/UploadTransfer.h"

#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>
#include <vector>

using namespace mavmission;
using namespace mavmission::detail;
using Send = UploadTransfer::Send;
using State = UploadTransfer::State;

namespace {

const uint8_t kAccepted = 0, kError = 1, kInvalidSequence = 13, kDenied = 14, kCancelled = 15;

// A transfer and its clock, which begins shortly before it wraps.
class Upload {
 public:
  UploadTransfer transfer;
  Pace pace;
  uint16_t now;

  explicit Upload(uint16_t count, Firmware firmware = Firmware::Other, uint8_t leftovers = 0, uint16_t start = 65000)
      : now(start) {
    memset(static_cast<void*>(&transfer), 0xA5, sizeof(transfer));  // whatever another operation has left there
    pace = Pace();
    transfer.begin(count, firmware, leftovers);
  }

  Status wait(uint16_t ms) {
    now = static_cast<uint16_t>(now + ms);
    return transfer.onTime(now, pace);
  }
  Send send() {
    const Send send = transfer.toSend();
    if (send != Send::Nothing) transfer.sent(now);
    return send;
  }
  Status request(uint16_t item) { return transfer.onRequest(item, now, pace); }
  Status ack(uint8_t result) { return transfer.onAck(result, now, pace); }

  // As far as `items` asked for and answered.
  Upload& served(uint16_t items) {
    send();
    for (uint16_t item = 0; item < items; ++item) {
      request(item);
      send();
    }
    return *this;
  }
};

bool goesOn(Status status) { return status == Status::Transferring; }

}  // namespace

TEST_CASE("a plan goes out item by item, each for one request, and ends with the acknowledgement") {
  Upload upload(3);
  CHECK((upload.send() == Send::Count));
  for (uint16_t item = 0; item < 3; ++item) {
    CHECK((upload.transfer.toSend() == Send::Nothing));
    CHECK(goesOn(upload.request(item)));
    CHECK(upload.transfer.itemToSend() == item);
    CHECK((upload.send() == Send::Item));
    CHECK(upload.transfer.itemsAskedFor() == item + 1);
    CHECK(goesOn(upload.wait(20)));
  }
  CHECK((upload.transfer.state() == State::Confirming));
  CHECK((upload.ack(kAccepted) == Status::Accepted));
}

TEST_CASE("COUNT is sent 5 times, 1500 ms apart, and then there is no answer") {
  Upload upload(3);
  for (int tries = 0; tries < 5; ++tries) {
    CHECK((upload.send() == Send::Count));
    CHECK(goesOn(upload.wait(1499)));
    CHECK((upload.transfer.toSend() == Send::Nothing));
    const Status status = upload.wait(1);
    CHECK((status == (tries < 4 ? Status::Transferring : Status::NoAnswer)));
  }
}

TEST_CASE("a COUNT that the line has not taken yet is not counted, and no time runs") {
  Upload upload(3);
  CHECK(goesOn(upload.wait(60000)));
  CHECK((upload.send() == Send::Count));
  CHECK(goesOn(upload.wait(1499)));
}

TEST_CASE("an autopilot that falls silent is waited for, 8.5 s from the last new item") {
  for (uint16_t asked = 1; asked < 4; ++asked) {
    Upload upload(5);
    upload.served(asked);
    CHECK(goesOn(upload.wait(8499)));
    CHECK((upload.transfer.toSend() == Send::Nothing));  // no item goes out unasked
    CHECK((upload.wait(1) == Status::TimedOut));
  }
}

TEST_CASE("asking for the same item again does not put off the end") {
  Upload upload(5);
  upload.served(2);
  for (int repeat = 0; repeat < 8; ++repeat) {
    CHECK(goesOn(upload.wait(1000)));
    CHECK(goesOn(upload.request(1)));
    CHECK((upload.send() == Send::Item));
  }
  CHECK((upload.wait(500) == Status::TimedOut));
}

TEST_CASE("on a lossy link, an error long behind the last new request says that PX4 has given the upload up") {
  for (const uint16_t ms : {2400, 2500, 5100}) {
    Upload upload(3, Firmware::Px4, kFromOpen);
    upload.pace.noteLoss();
    upload.served(2);
    CHECK(goesOn(upload.wait(ms)));
    CHECK((upload.send() == Send::Item));
    CHECK((upload.ack(kError) == (ms < 2500 ? Status::Transferring : Status::TimedOut)));
  }
  // Nothing was repeated unasked that it could answer.
  Upload upload(3, Firmware::Px4, kFromOpen);
  upload.pace.noteLoss();
  upload.served(2);
  upload.now = static_cast<uint16_t>(upload.now + 5100);
  CHECK(goesOn(upload.ack(kError)));
}

TEST_CASE("the last item is repeated when the final answer is overdue, 5 times, 1500 ms apart") {
  Upload upload(2);
  upload.served(2);
  for (int repeat = 0; repeat < 5; ++repeat) {
    CHECK(goesOn(upload.wait(1499)));
    CHECK((upload.transfer.toSend() == Send::Nothing));
    CHECK(goesOn(upload.wait(1)));
    CHECK(upload.transfer.itemToSend() == 1);
    CHECK((upload.send() == Send::Item));
  }
  CHECK(goesOn(upload.wait(1499)));
  CHECK((upload.wait(1) == Status::Unconfirmed));
}

TEST_CASE("requests for the last item again and again do not put off the end beyond 9 s") {
  Upload upload(2);
  upload.served(2);
  Status status = Status::Transferring;
  uint32_t elapsedMs = 0;
  while (goesOn(status) && elapsedMs < 60000) {
    status = upload.wait(100);
    elapsedMs += 100;
    if (!goesOn(status)) break;
    upload.request(1);
    upload.send();
  }
  CHECK((status == Status::Unconfirmed));
  CHECK(elapsedMs == 9000);
}

TEST_CASE("an acknowledgement that comes late is one") {
  Upload upload(2);
  upload.served(2);
  upload.wait(1500);
  upload.send();
  upload.wait(1000);
  CHECK((upload.ack(kAccepted) == Status::Accepted));
}

TEST_CASE("a request within 50 ms of its answer is a queue being emptied") {
  Upload upload(5);
  upload.served(1);
  CHECK(goesOn(upload.wait(49)));
  upload.request(0);
  CHECK((upload.send() == Send::Nothing));
  upload.wait(1);
  upload.request(0);
  CHECK((upload.send() == Send::Item));
}

TEST_CASE("a request for an earlier item is late; if it still comes 500 ms behind a newer one, it decides") {
  Upload upload(5);
  upload.served(4);
  upload.wait(499);
  upload.request(1);  // late: it holds items 0 to 2
  CHECK((upload.send() == Send::Nothing));
  CHECK(upload.transfer.itemsAskedFor() == 4);
  upload.wait(1);
  upload.request(1);
  CHECK(upload.transfer.itemToSend() == 1);
  CHECK((upload.send() == Send::Item));
  CHECK(upload.transfer.itemsAskedFor() == 2);
  upload.request(4);  // the one for item 1 was late
  CHECK(upload.transfer.itemToSend() == 4);
  CHECK((upload.send() == Send::Item));
  CHECK((upload.ack(kAccepted) == Status::Accepted));
}

TEST_CASE(
    "an item that is asked for again and again, behind one that was taken for received, is sent again and again") {
  Upload upload(5, Firmware::ArduPilot);
  upload.served(2);
  upload.pace.noteLoss();
  upload.wait(250);
  upload.send();
  upload.ack(kInvalidSequence);  // an answer to item 0, which stood still somewhere
  CHECK((upload.send() == Send::Item));
  CHECK(upload.transfer.lastItem() == 2);
  CHECK(upload.transfer.itemsAskedFor() == 2);  // no item is said to have arrived whose next was not asked for
  upload.wait(300);
  CHECK(goesOn(upload.request(1)));
  for (int repeat = 0; repeat < 20; ++repeat) {
    CHECK((upload.send() == Send::Item));
    CHECK(upload.transfer.lastItem() == 1);
    CHECK(goesOn(upload.wait(100)));
  }
  CHECK(goesOn(upload.request(2)));
  CHECK(upload.transfer.itemToSend() == 2);
}

TEST_CASE("a request that jumps ahead or beyond the plan moves nothing") {
  for (unsigned item : {1u, 2u, 3u, 500u, 65535u}) {
    Upload upload(3);
    upload.send();
    CHECK(goesOn(upload.request(static_cast<uint16_t>(item))));
    CHECK((upload.send() == Send::Nothing));
    CHECK(upload.transfer.itemsAskedFor() == 0);
    CHECK((upload.transfer.state() == State::Counting));
  }
  Upload upload(3);
  upload.served(3);
  upload.request(3);
  CHECK((upload.send() == Send::Nothing));
}

TEST_CASE("the longest plan has 65,535 items, and asks for no item behind its end") {
  Upload upload(65535);
  upload.served(65535);
  CHECK((upload.transfer.state() == State::Confirming));
  CHECK((upload.ack(kAccepted) == Status::Accepted));
  upload.request(65535);
  CHECK((upload.send() == Send::Nothing));
}

TEST_CASE("an empty plan is accepted at once") {
  Upload upload(0);
  CHECK((upload.send() == Send::Count));
  CHECK((upload.ack(kAccepted) == Status::Accepted));
}

TEST_CASE("whatever is said before the first COUNT has left is about something earlier") {
  for (uint16_t count : {uint16_t(0), uint16_t(3)}) {
    for (unsigned result = 0; result <= 255; ++result) {
      Upload upload(count, static_cast<Firmware>(1 + result % 3), result % 2 == 0);
      CHECK(goesOn(upload.ack(static_cast<uint8_t>(result))));
      CHECK((upload.send() == Send::Count));
    }
  }
}

TEST_CASE("a request that is heard before COUNT has left belongs to an earlier transfer, which is not served") {
  Upload upload(3, Firmware::ArduPilot, true);
  CHECK(goesOn(upload.request(0)));
  CHECK(upload.transfer.itemsAskedFor() == 0);
  CHECK((upload.send() == Send::Count));
  CHECK(goesOn(upload.request(0)));
  CHECK((upload.send() == Send::Item));
}

TEST_CASE(
    "a busy PX4 that still asks in its old transfer is not served before that has been ended and COUNT sent again") {
  Upload upload(3, Firmware::Px4);
  upload.send();
  upload.ack(kError);
  upload.request(0);
  CHECK((upload.send() == Send::Cancel));
  upload.request(0);
  CHECK((upload.send() == Send::Count));
  upload.request(0);
  CHECK((upload.send() == Send::Item));
}

TEST_CASE("a request beyond the plan shows another upload: ours begins again, once, and its acceptance is no proof") {
  for (Firmware firmware : {Firmware::ArduPilot, Firmware::Px4, Firmware::Other}) {
    Upload upload(3, firmware);
    upload.served(3);
    CHECK(goesOn(upload.request(3)));
    if (firmware != Firmware::Other) {
      CHECK((upload.send() == Send::Cancel));
      CHECK((upload.send() == Send::Count));
      for (uint16_t item = 0; item < 3; ++item) {
        upload.request(item);
        CHECK((upload.send() == Send::Item));
      }
      CHECK(goesOn(upload.request(7)));
    }
    CHECK((upload.send() == Send::Nothing));
    CHECK((upload.ack(kAccepted) == Status::Unconfirmed));
  }
}

TEST_CASE("an empty plan that is accepted behind another operation is not proven by that") {
  for (const uint8_t before : {uint8_t(kFromOpen), uint8_t(kFromBefore)}) {
    Upload upload(0, Firmware::ArduPilot, before);
    upload.send();
    CHECK((upload.ack(kAccepted) == Status::Unconfirmed));
  }
}

TEST_CASE("accepted before every item was asked for is said as such") {
  for (uint16_t asked = 0; asked < 3; ++asked) {
    Upload upload(3);
    upload.served(asked);
    CHECK((upload.ack(kAccepted) == Status::AcceptedEarly));
  }
}

TEST_CASE("accepted while the last item is only asked for, and has not left, is early too") {
  Upload upload(2);
  upload.served(1);
  upload.request(1);
  CHECK((upload.ack(kAccepted) == Status::AcceptedEarly));
}

TEST_CASE(
    "with leftovers an early acceptance may be of the plan before: it ends nothing, but is the reason if nothing else "
    "comes") {
  Upload upload(3, Firmware::Other, true);
  upload.send();
  CHECK(goesOn(upload.ack(kAccepted)));
  CHECK(goesOn(upload.request(0)));
  upload.send();
  CHECK((upload.wait(8500) == Status::AcceptedEarly));
}

TEST_CASE("each refusal ends the transfer in each state, but for the words that may be noise") {
  for (uint8_t result = 1; result <= 30; ++result) {
    for (uint16_t asked = 0; asked <= 3; ++asked) {
      Upload upload(3, Firmware::Other);
      upload.served(asked);
      const Status said = fromMissionResult(result);
      const bool counting = asked == 0;
      const bool noise = result == kError && counting;
      CAPTURE(result);
      CAPTURE(asked);
      if (result == kInvalidSequence && !counting) {
        // It has given the upload up, or is idle behind the last item.
        CHECK((upload.ack(result) == (asked < 3 ? Status::TimedOut : Status::Unconfirmed)));
        continue;
      }
      CHECK((upload.ack(result) == (noise ? Status::Transferring : said)));
    }
  }
  for (const Firmware firmware : {Firmware::ArduPilot, Firmware::Px4}) {
    for (uint16_t asked = 1; asked <= 3; ++asked) {
      Upload upload(3, firmware);
      upload.served(asked);
      CHECK(goesOn(upload.ack(kInvalidSequence)));
    }
  }
}

const uint8_t kNothing = 0;

TEST_CASE("a busy PX4 is told to end what is open, and asked again at once: that it is busy still is its last word") {
  for (uint8_t leftovers : {kNothing, uint8_t{kFromOpen}}) {
    Upload upload(3, Firmware::Px4, leftovers);
    upload.send();
    CHECK(goesOn(upload.ack(kError)));
    CHECK((upload.send() == Send::Cancel));
    CHECK((upload.send() == Send::Count));
    CHECK((upload.ack(kError) == Status::Error));
  }
}

TEST_CASE("a PX4 that may be busy with what was ours is told so and asked every 1500 ms, beyond its own 5 s") {
  for (int unanswered = 1; unanswered <= 5; ++unanswered) {
    Upload upload(3, Firmware::Px4, kFromBusy);
    upload.send();
    for (int tries = 1; tries < unanswered; ++tries) {
      CHECK(goesOn(upload.wait(1500)));
      CHECK((upload.send() == Send::Count));
    }
    CHECK(goesOn(upload.ack(kError)));
    for (uint16_t ms = 0; ms < 6000; ms += 1500) {
      CHECK((upload.send() == Send::Cancel));
      CHECK((upload.send() == Send::Count));
      CHECK(goesOn(upload.ack(kError)));
      CHECK(goesOn(upload.ack(kError)));  // the same, brought twice
      CHECK(goesOn(upload.wait(1499)));
      CHECK((upload.transfer.toSend() == Send::Nothing));
      CHECK(goesOn(upload.wait(1)));
    }
    CHECK((upload.send() == Send::Cancel));
    CHECK((upload.send() == Send::Count));  // 6 s behind the first that PX4 was freed for
    CHECK((upload.ack(kError) == Status::Error));
  }
}

TEST_CASE("a PX4 that falls silent when it has been busy did not answer") {
  for (uint8_t leftovers : {kNothing, uint8_t{kFromOpen}, uint8_t{kFromBusy}}) {
    Upload upload(3, Firmware::Px4, leftovers);
    upload.send();
    upload.ack(kError);
    for (int tries = 1; tries <= 5; ++tries) {
      CHECK((upload.send() == Send::Cancel));
      CHECK((upload.send() == Send::Count));
      CHECK((upload.wait(1500) == (tries < 5 ? Status::Transferring : Status::NoAnswer)));
    }
  }
}

TEST_CASE("a PX4 that was busy and then asks for items is served, and what it said before is no reason for anything") {
  Upload upload(2, Firmware::Px4, kFromBusy);
  upload.send();
  upload.ack(kError);
  upload.send();
  upload.send();
  upload.ack(kError);
  CHECK(goesOn(upload.request(0)));
  CHECK((upload.send() == Send::Item));
  CHECK((upload.wait(8500) == Status::TimedOut));
}

TEST_CASE("the error of a COUNT that was sent before PX4 was freed is noise in mid-transfer") {
  Upload upload(2, Firmware::Px4);
  upload.send();
  upload.wait(1500);
  upload.send();
  upload.ack(kError);
  upload.send();
  upload.send();
  upload.request(0);
  upload.send();
  CHECK(goesOn(upload.ack(kError)));
  upload.request(1);
  upload.send();
  CHECK((upload.ack(kAccepted) == Status::Accepted));
}

TEST_CASE("ArduPilot's error at COUNT is an error") {
  Upload upload(3, Firmware::ArduPilot);
  upload.send();
  CHECK((upload.ack(kError) == Status::Error));
}

TEST_CASE("PX4's error in mid-transfer may be to a COUNT that came again: it is the reason if nothing else comes") {
  Upload once(3, Firmware::Px4);
  once.served(1);
  CHECK(goesOn(once.ack(kError)));
  CHECK((once.wait(8500) == Status::Error));

  Upload twice(3, Firmware::Px4);
  twice.send();
  twice.wait(1500);
  twice.served(1);
  CHECK(goesOn(twice.ack(kError)));
  CHECK((twice.wait(8500) == Status::Error));

  Upload ardupilot(3, Firmware::ArduPilot);
  ardupilot.send();
  ardupilot.wait(1500);
  ardupilot.served(1);
  CHECK((ardupilot.ack(kError) == Status::Error));
}

TEST_CASE("an error after the last item is about that item, but for PX4, which says so to a COUNT that came again") {
  for (Firmware firmware : {Firmware::ArduPilot, Firmware::Px4, Firmware::Other}) {
    Upload upload(2, firmware);
    upload.served(2);
    CHECK((upload.ack(kError) == (firmware == Firmware::Px4 ? Status::Transferring : Status::Error)));
  }
}

TEST_CASE("an error after the last item was asked for twice tells nothing of the plan: it may be idle") {
  for (Firmware firmware : {Firmware::ArduPilot, Firmware::Px4, Firmware::Other}) {
    Upload upload(2, firmware);
    upload.served(2);
    upload.wait(200);
    upload.request(1);
    CHECK((upload.send() == Send::Item));
    CHECK(goesOn(upload.ack(kError)));
    CHECK((upload.ack(kAccepted) == Status::Accepted));
  }
}

TEST_CASE("an acceptance of a last item that is repeated after an error is no acceptance of the plan") {
  Upload upload(2, Firmware::Px4);
  upload.served(2);
  upload.wait(200);
  upload.request(1);
  upload.send();
  upload.ack(kError);
  upload.wait(1500);
  CHECK((upload.send() == Send::Item));
  CHECK((upload.ack(kAccepted) == Status::Unconfirmed));
}

TEST_CASE(
    "the autopilot's own cancelling ends the transfer, but not one that it has not begun yet if leftovers may be "
    "meant") {
  Upload begun(3, Firmware::ArduPilot, true);
  begun.served(1);
  CHECK((begun.ack(kCancelled) == Status::CancelledByAutopilot));

  Upload counting(3, Firmware::ArduPilot, true);
  counting.send();
  CHECK(goesOn(counting.ack(kCancelled)));
  CHECK(goesOn(counting.request(0)));

  Upload alone(3, Firmware::ArduPilot, false);
  alone.send();
  CHECK((alone.ack(kCancelled) == Status::CancelledByAutopilot));
}

TEST_CASE("a transfer that is begun again behind an older one has all its tries") {
  const auto begunAgain = []() {
    Upload upload(2, Firmware::Px4, true);
    upload.served(2);
    upload.wait(1500);
    CHECK((upload.send() == Send::Item));  // the last one, unasked
    upload.request(2);
    CHECK((upload.send() == Send::Cancel));
    CHECK(upload.transfer.itemsAskedFor() == 0);
    return upload;
  };
  Upload unanswered = begunAgain();
  for (int tries = 0; tries < 5; ++tries) {
    if (tries != 0) CHECK((unanswered.send() == Send::Cancel));
    CHECK((unanswered.send() == Send::Count));
    const Status status = unanswered.wait(1500);
    CHECK((status == (tries < 4 ? Status::Transferring : Status::NoAnswer)));
  }
  // An error may be to one of the COUNTs before: it is the reason if nothing else comes.
  Upload refused = begunAgain();
  refused.served(1);
  CHECK(goesOn(refused.ack(kError)));
  CHECK((refused.wait(8500) == Status::Error));
  Upload accepted = begunAgain();
  accepted.served(2);
  CHECK((accepted.ack(kAccepted) == Status::Unconfirmed));
}

TEST_CASE("of a part only its own items are served, from its first one on") {
  Upload part(6, Firmware::ArduPilot);
  part.transfer.limitTo(2, 4);
  CHECK(part.transfer.itemsAskedFor() == 2);
  part.send();
  for (uint16_t item : {uint16_t(0), uint16_t(1), uint16_t(3)}) {
    part.request(item);
    CHECK((part.send() == Send::Nothing));
  }
  for (uint16_t item : {uint16_t(2), uint16_t(3)}) {
    part.request(item);
    CHECK(part.transfer.itemToSend() == item);
    CHECK((part.send() == Send::Item));
  }
  CHECK((part.transfer.state() == State::Confirming));
  part.request(1);
  CHECK((part.send() == Send::Nothing));
  CHECK((part.ack(kAccepted) == Status::Accepted));
  part.request(4);  // the autopilot receives more than this part
  CHECK((part.send() == Send::Nothing));
  CHECK((part.ack(kAccepted) == Status::Unconfirmed));
}

TEST_CASE("the request for the first item of a part shows the round trip") {
  Upload part(6, Firmware::ArduPilot);
  part.transfer.limitTo(2, 4);
  part.send();
  part.wait(40);
  part.request(2);
  CHECK(part.pace.roundTripMs() == 40);
}

TEST_CASE(
    "denied ends a transfer, but for a part, which may have been announced twice: it is the reason if nothing else "
    "comes") {
  for (uint16_t first : {uint16_t(0), uint16_t(2)}) {
    for (int announced = 1; announced <= 3; ++announced) {
      for (bool begun : {false, true}) {
        Upload upload(4, Firmware::ArduPilot);
        upload.transfer.limitTo(first, 4);
        upload.send();
        for (int i = 1; i < announced; ++i) {
          upload.wait(1500);
          upload.send();
        }
        if (begun) {
          upload.request(first);
          upload.send();
        }
        CAPTURE(first);
        CAPTURE(announced);
        CAPTURE(begun);
        const bool isDoubtful = first != 0;
        CHECK((upload.ack(kDenied) == (isDoubtful ? Status::Transferring : Status::Denied)));
        if (!isDoubtful) continue;
        if (begun) {
          CHECK((upload.wait(8500) == Status::Denied));
          continue;
        }
        for (int sent = announced; sent < 5; ++sent) {
          CHECK(goesOn(upload.wait(1500)));
          upload.send();
        }
        CHECK((upload.wait(1500) == Status::Denied));
      }
    }
  }
}

TEST_CASE("an error to our own repetition of the last item tells nothing of the plan; PX4 may yet accept") {
  for (Firmware firmware : {Firmware::ArduPilot, Firmware::Px4, Firmware::Other}) {
    Upload upload(2, firmware);
    upload.served(2);
    upload.wait(1500);
    upload.send();
    CHECK((upload.ack(kError) == (firmware == Firmware::Px4 ? Status::Transferring : Status::Unconfirmed)));
  }
}

TEST_CASE("the next item may be made ready from COUNT on, until the last one has been asked for") {
  Upload upload(2);
  CHECK(upload.transfer.expectsRequest());
  upload.send();
  CHECK(upload.transfer.expectsRequest());
  upload.request(0);
  CHECK(upload.transfer.expectsRequest());
  upload.send();
  CHECK(upload.transfer.expectsRequest());
  upload.request(1);
  CHECK_FALSE(upload.transfer.expectsRequest());
  upload.send();
  CHECK_FALSE(upload.transfer.expectsRequest());
  CHECK_FALSE(Upload(0).transfer.expectsRequest());
}

TEST_CASE("an acceptance of a repeated last item is in doubt only on PX4, with leftovers") {
  for (Firmware firmware : {Firmware::ArduPilot, Firmware::Px4, Firmware::Other}) {
    for (bool leftovers : {false, true}) {
      Upload upload(1, firmware, leftovers);
      upload.served(1);
      upload.wait(1500);
      upload.send();
      const bool isDoubtful = firmware == Firmware::Px4 && leftovers;
      CHECK((upload.ack(kAccepted) == (isDoubtful ? Status::Unconfirmed : Status::Accepted)));
    }
  }
}

TEST_CASE("a transfer is suspected from an answer on that may be to an earlier one, until its last item has left") {
  Upload upload(1, Firmware::ArduPilot, true);
  upload.send();
  CHECK_FALSE(upload.transfer.isSuspected());
  upload.ack(kInvalidSequence);
  CHECK(upload.transfer.isSuspected());
  upload.request(0);
  upload.send();
  CHECK_FALSE(upload.transfer.isSuspected());
}

TEST_CASE("every wait is the same wherever the clock wraps in it") {
  for (uint32_t start = 65535 - 9000; start <= 65535; start += 250) {
    Upload counting(3, Firmware::Other, false, static_cast<uint16_t>(start));
    counting.send();
    CHECK(goesOn(counting.wait(1499)));
    CHECK((counting.transfer.toSend() == Send::Nothing));
    counting.wait(1);
    CHECK((counting.transfer.toSend() == Send::Count));

    Upload sending(3, Firmware::Other, false, static_cast<uint16_t>(start));
    sending.served(1);
    CHECK(goesOn(sending.wait(8499)));
    CHECK((sending.wait(1) == Status::TimedOut));

    Upload confirming(1, Firmware::Other, false, static_cast<uint16_t>(start));
    confirming.served(1);
    CHECK(goesOn(confirming.wait(1499)));
    CHECK((confirming.transfer.toSend() == Send::Nothing));
    confirming.wait(1);
    CHECK((confirming.transfer.toSend() == Send::Item));
  }
}

TEST_CASE("whatever is heard in whatever order, accepted means that every item was asked for and the last one left") {
  uint32_t seed = 99;
  for (int round = 0; round < 20000; ++round) {
    const uint16_t count = static_cast<uint16_t>(round % 4);
    Upload upload(count, static_cast<Firmware>(1 + round % 3), round % 5 == 0, static_cast<uint16_t>(seed));
    bool lastLeft = count == 0;
    Status status = Status::Transferring;
    uint32_t spentMs = 0;
    int steps = 0;
    for (; goesOn(status) && steps < 1000; ++steps) {
      seed = seed * 1664525 + 1013904223;
      const uint8_t dice = static_cast<uint8_t>(seed >> 24);
      if (upload.transfer.toSend() != Send::Nothing && dice % 2) {
        if (upload.transfer.toSend() == Send::Item && upload.transfer.itemToSend() + 1 == count) lastLeft = true;
        upload.send();
      }
      if (dice < 60) {
        status = upload.request(static_cast<uint16_t>((seed >> 8) % 5));
      } else if (dice < 80) {
        status = upload.ack(static_cast<uint8_t>((seed >> 8) % 18));
      } else {
        const uint16_t ms = static_cast<uint16_t>((seed >> 8) % 700);
        spentMs += ms;
        status = upload.wait(ms);
      }
      if (status == Status::Accepted) REQUIRE(lastLeft);
    }
    REQUIRE(steps < 1000);
    REQUIRE(spentMs < 120000);
  }
}

TEST_CASE("on a lossy link, an unknown server gets room for its own timeout behind each eight of an item") {
  Upload upload(3, Firmware::Other);
  upload.send();
  upload.wait(18);
  upload.request(0);
  upload.send();
  upload.pace.noteLoss();
  for (int sent = 1; sent < 20; ++sent) {
    const uint16_t waitMs = sent % 8 == 0 ? UploadTransfer::kRoomMs : 50;
    CHECK(goesOn(upload.wait(waitMs - 1)));
    CHECK((upload.transfer.toSend() == Send::Nothing));
    upload.wait(1);
    CHECK((upload.send() == Send::Item));
  }
}

TEST_CASE("on a lossy link, an item is sent again when its answer is overdue, the last one every 50 ms") {
  for (const Firmware firmware : {Firmware::ArduPilot, Firmware::Px4}) {
    Upload upload(2, firmware);
    upload.send();
    upload.wait(18);
    upload.request(0);
    upload.send();
    upload.pace.noteLoss();
    for (const uint16_t item : {0, 1}) {
      const uint16_t againMs = item == 0 ? 14 : 50;  // three quarters of 18 ms
      for (int repeat = 0; repeat < 20; ++repeat) {
        CHECK(goesOn(upload.wait(againMs - 1)));
        CHECK((upload.transfer.toSend() == Send::Nothing));
        upload.wait(1);
        CHECK((upload.send() == Send::Item));
        CHECK(upload.transfer.lastItem() == item);
      }
      upload.request(1);
      upload.send();
    }
  }
}

TEST_CASE("an item is sent again after three quarters of a round trip, but 4 times as often as the last at the most") {
  const uint16_t againMs[][2] = {{4, 12}, {16, 12}, {17, 13}, {48, 36}, {49, 37}, {50, 50}, {90, 50}};
  for (const auto& row : againMs) {
    Upload upload(3, Firmware::ArduPilot);
    upload.send();
    upload.wait(row[0]);
    upload.request(0);
    upload.send();
    upload.pace.noteLoss();
    CHECK(goesOn(upload.wait(row[1] - 1)));
    CHECK((upload.transfer.toSend() == Send::Nothing));
    upload.wait(1);
    CHECK((upload.transfer.toSend() == Send::Item));
  }
}

TEST_CASE("on a lossy link, PX4 gets four copies of an item, then the next one in turn, but not the last one") {
  Upload upload(4, Firmware::Px4);
  upload.served(1);
  upload.pace.noteLoss();
  const auto leaves = [&] {
    while (upload.transfer.toSend() == Send::Nothing) CHECK(goesOn(upload.wait(1)));
    const uint16_t item = upload.transfer.itemToSend();
    upload.send();
    CHECK(upload.transfer.isLastItemRefused() == (upload.transfer.tries() <= 4));
    return item;
  };
  for (int copy = 2; copy <= 17; ++copy) CHECK(leaves() == (copy > 4 && copy % 2 != 0 ? 1 : 0));
  CHECK(upload.transfer.itemsAskedFor() == 1);

  SUBCASE("it asks for the first of them once more") {
    leaves();
    while (upload.transfer.toSend() == Send::Nothing) upload.wait(1);
    CHECK((upload.transfer.toSend() == Send::NextItem));
    CHECK(goesOn(upload.request(0)));
    CHECK(leaves() == 0);
  }
  SUBCASE("it asks for the second, and all is as if that had not left yet") {
    CHECK(goesOn(upload.request(1)));
    CHECK(upload.transfer.itemsAskedFor() == 2);
    for (int copy = 1; copy <= 4; ++copy) CHECK(leaves() == 1);
  }
  SUBCASE("it asks for the one after, since it has taken both; the one behind that is the last") {
    CHECK(goesOn(upload.request(2)));
    CHECK(upload.transfer.itemsAskedFor() == 3);
    while (upload.transfer.tries() <= 20) CHECK(leaves() == 2);
    CHECK((upload.transfer.state() == State::Sending));
    CHECK(goesOn(upload.request(3)));
    CHECK(leaves() == 3);
    CHECK((upload.ack(kAccepted) == Status::Accepted));
  }
  SUBCASE("what it asks for beyond that answers nothing that has left") {
    CHECK(goesOn(upload.request(3)));
    CHECK(upload.transfer.itemsAskedFor() == 1);
  }
}

TEST_CASE("where answers come late, each copy is of the item that PX4 has asked for") {
  for (const uint16_t roundTripMs : {49, 50}) {
    Upload upload(9, Firmware::Px4);
    upload.send();
    upload.wait(roundTripMs);
    upload.request(0);
    upload.send();
    upload.pace.noteLoss();
    for (int copy = 2; copy <= 5; ++copy) {
      while (upload.transfer.toSend() == Send::Nothing) upload.wait(1);
      CHECK((upload.send() == (roundTripMs < 50 && copy == 5 ? Send::NextItem : Send::Item)));
    }
    upload.request(2);
    CHECK(upload.transfer.itemsAskedFor() == (roundTripMs < 50 ? 3 : 1));
    CHECK(upload.pace.roundTripMs() == roundTripMs);  // a jump over what has left is no late answer
  }
}

TEST_CASE("a request that is repeated says that the line loses; one of a queue that is being emptied does not") {
  Upload upload(3);
  upload.served(1);
  upload.wait(49);
  upload.request(0);
  CHECK_FALSE(upload.pace.isLossy());
  upload.wait(1);
  upload.request(0);
  CHECK((upload.send() == Send::Item));
  upload.wait(499);
  upload.request(0);
  CHECK((upload.send() == Send::Item));
  CHECK_FALSE(upload.pace.isLossy());
  upload.wait(500);
  upload.request(0);
  CHECK((upload.send() == Send::Item));
  CHECK(upload.pace.isLossy());
}

TEST_CASE("on a lossy link that answers late, an item is repeated eight times in a round trip at the most") {
  for (uint16_t roundTripMs : {480, 800, 1400}) {
    Upload upload(3);
    upload.send();
    upload.wait(roundTripMs);
    upload.request(0);
    upload.send();
    upload.pace.noteLoss();
    CHECK(goesOn(upload.wait(roundTripMs < 800 ? 59 : 99)));
    CHECK((upload.transfer.toSend() == Send::Nothing));
    upload.wait(1);
    CHECK((upload.transfer.toSend() == Send::Item));
  }
}

TEST_CASE("a request that comes again within a round trip after its answer was sent before that arrived") {
  Upload upload(3, Firmware::Px4);
  upload.send();
  upload.wait(1000);  // 500 ms each way, and PX4 asks every 265 ms
  upload.request(0);
  CHECK((upload.send() == Send::Item));
  for (int repeat = 0; repeat < 3; ++repeat) {
    upload.wait(265);
    upload.request(0);
    CHECK((upload.send() == Send::Nothing));
  }
  upload.wait(265);
  upload.request(0);
  CHECK((upload.send() == Send::Item));
}

TEST_CASE("the first answer says how long a round trip takes, at the most; of repeats it is the first that counts") {
  Upload upload(4, Firmware::ArduPilot);
  upload.pace.noteLoss();
  for (int count = 0; count < 20; ++count) {
    CHECK((upload.send() == Send::Count));
    CHECK(goesOn(upload.wait(50)));
  }
  upload.request(0);  // 20 ms after the last COUNT, 1 s after the first
  upload.send();
  upload.wait(100);
  upload.send();
  upload.wait(900);
  upload.ack(kInvalidSequence);  // to what was sent before: no word of item 0
  CHECK(upload.transfer.itemToSend() == 0);
  upload.send();
  upload.wait(50);
  upload.send();
  upload.ack(kInvalidSequence);
  CHECK(upload.transfer.itemToSend() == 1);
}

TEST_CASE("an item is sent again until the time for the next request is over") {
  Upload upload(3);
  upload.served(1);
  Status status = Status::Transferring;
  uint16_t passed = 0;
  for (; goesOn(status); ++passed) {
    upload.pace.noteLoss();
    status = upload.wait(1);
    upload.send();
  }
  CHECK((status == Status::TimedOut));
  CHECK(passed == 8500);
}

TEST_CASE("while PX4 may be busy with an earlier transfer, COUNT is repeated every 1500 ms on a lossy link too") {
  Upload upload(3, Firmware::Px4, kFromBusy);
  upload.pace.noteLoss();
  upload.send();
  upload.ack(kError);
  CHECK((upload.send() == Send::Cancel));
  CHECK((upload.send() == Send::Count));
  CHECK(goesOn(upload.wait(1499)));
  CHECK((upload.transfer.toSend() == Send::Nothing));
  upload.wait(1);
  CHECK((upload.transfer.toSend() == Send::Cancel));
}

TEST_CASE("an item's repeats take four fifths of the line at the most; the last one's, and a COUNT's, a fifth") {
  for (const uint16_t asked : {0, 1, 3}) {
    Upload upload(3, Firmware::ArduPilot);
    upload.served(asked);
    upload.pace.noteLoss();
    upload.pace.noteBusy(60);  // 9600 baud
    const uint16_t againMs = asked == 1 ? 75 : 300;
    CHECK(goesOn(upload.wait(againMs - 1)));
    CHECK((upload.transfer.toSend() == Send::Nothing));
    upload.wait(1);
    CHECK((upload.transfer.toSend() == (asked == 0 ? Send::Count : Send::Item)));
  }
}

TEST_CASE("on a lossy link, COUNT is sent again for 7.5 s, before ArduPilot would give up what it has heard") {
  Upload upload(3, Firmware::ArduPilot);
  upload.pace.noteLoss();
  uint16_t counts = 0;
  Status status = Status::Transferring;
  uint16_t elapsedMs = 0;
  for (; goesOn(status) && elapsedMs < 20000; ++elapsedMs) {
    if (upload.send() == Send::Count) ++counts;
    status = upload.wait(1);
  }
  CHECK((status == Status::NoAnswer));
  CHECK(elapsedMs < 8000);
  CHECK(counts > 80);
}

TEST_CASE("ArduPilot's word that an item is out of sequence means that it has it, if no answer to another can come") {
  Upload upload(3, Firmware::ArduPilot);
  upload.served(2);
  upload.ack(kInvalidSequence);  // it may be to the item before
  CHECK((upload.transfer.toSend() == Send::Nothing));
  upload.pace.noteLoss();
  upload.wait(250);
  upload.send();
  upload.ack(kInvalidSequence);
  CHECK((upload.transfer.toSend() == Send::Item));
  CHECK(upload.transfer.itemToSend() == 2);
  upload.send();
  upload.ack(kInvalidSequence);
  CHECK((upload.transfer.toSend() == Send::Nothing));
  CHECK((upload.ack(kAccepted) == Status::Accepted));

  Upload slow(3, Firmware::ArduPilot);
  slow.send();
  slow.wait(300);
  slow.request(0);
  slow.send();
  slow.pace.noteLoss();
  for (int repeat = 0; repeat < 6; ++repeat) {
    slow.wait(50);
    slow.send();
  }
  slow.request(1);
  slow.send();
  for (int late = 0; late < 6; ++late) {
    slow.wait(50);
    slow.send();
    slow.ack(kInvalidSequence);  // each is to a repeat of item 0
    CHECK(slow.transfer.lastItem() == 1);
  }
  slow.wait(50);
  slow.send();
  slow.ack(kInvalidSequence);
  CHECK(slow.transfer.itemToSend() == 2);

  Upload px4(3, Firmware::Px4);
  px4.served(2);
  px4.pace.noteLoss();
  px4.wait(250);
  px4.send();
  px4.ack(kInvalidSequence);
  CHECK((px4.transfer.toSend() == Send::Nothing));
}

TEST_CASE("where an earlier transfer may be what is accepted, the last item is sent only when it is asked for") {
  for (bool leftovers : {false, true}) {
    Upload upload(2, Firmware::ArduPilot, leftovers ? kFromOpen : 0);
    upload.served(1);
    upload.pace.noteLoss();
    upload.wait(250);
    upload.send();
    upload.ack(kInvalidSequence);
    CHECK((upload.transfer.toSend() == (leftovers ? Send::Nothing : Send::Item)));
  }
}

TEST_CASE("on a lossy link, the last item is sent again until 9 s are over") {
  Upload upload(2);
  upload.served(2);
  Status status = Status::Transferring;
  uint16_t passed = 0;
  for (; goesOn(status); ++passed) {
    upload.pace.noteLoss();
    status = upload.wait(1);
    upload.send();
  }
  CHECK((status == Status::Unconfirmed));
  CHECK(passed == 9000);
}
