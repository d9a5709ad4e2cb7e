// Downloads and verifications by a whole client.
#include <doctest/doctest.h>

#include "ClientOnLine.h"
#include "PlanFrames.h"

using namespace mavmission;

namespace {

bool ignore(void*, uint16_t, const MissionItem&) { return true; }

// The messages by which an item is asked for that never comes.
std::vector<uint16_t> requestsOfAnItem(uint8_t autopilot) {
  ClientOnLine desk(autopilot);
  desk.run(3000);
  desk.client.download(toFunction(ignore));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 3000));
  desk.hear(countParts(3));
  desk.sent.clear();
  desk.run(3000);
  CHECK((desk.ended == Status::TimedOut));
  std::vector<uint16_t> messages;
  for (const SentFrame& frame : desk.sent) {
    const bool isRequest = frame.messageId == ClientOnLine::kRequest || frame.messageId == ClientOnLine::kRequestInt;
    if (isRequest && frame.payload[0] == 0) {
      messages.push_back(frame.messageId);
    }
  }
  return messages;
}

}  // namespace

TEST_CASE("an autopilot that is neither is asked for an item twice by the new request, then by both in turns") {
  const uint16_t newer = ClientOnLine::kRequestInt, older = ClientOnLine::kRequest;
  CHECK(requestsOfAnItem(ClientOnLine::kOther) ==
        std::vector<uint16_t>{newer, newer, older, newer, older, newer, older, newer});
}

namespace {

// A reading of a plan of `items` items, as far as its count has come.
struct Reading : ClientOnLine {
  std::vector<uint16_t> taken;
  Reading(uint8_t autopilot, uint16_t items, bool hasLost = false) : ClientOnLine(autopilot) {
    run(3000);
    client.download(toFunction(take, this));
    REQUIRE(runUntilSent(kRequestList, 3000));
    run(5);
    if (hasLost) lose(1);
    hear(countParts(items));
  }
  static bool take(void* context, uint16_t index, const MissionItem& item) {
    Reading& reading = *static_cast<Reading*>(context);
    const bool hasHome = reading.client.firmware() == Firmware::ArduPilot;
    CHECK(item.param1 == static_cast<uint16_t>(index + (hasHome ? 1 : 0)));
    reading.taken.push_back(index);
    return true;
  }
  void give(uint16_t seq) {
    MissionItem item = waypoint(-35_deg, 149_deg, 20_m);
    item.param1 = seq;
    hear(itemParts(seq, item));
  }
  // The numbers of the items that are asked for in so many ms.
  std::vector<int> asked(uint32_t ms, uint32_t step = 1) {
    sent.clear();
    run(ms, step);
    std::vector<int> numbers;
    for (const SentFrame& frame : sent) {
      if (frame.messageId == kRequestInt) numbers.push_back(frame.payload[0]);
    }
    return numbers;
  }
  void end(uint16_t items) {
    CHECK((ended == Status::Downloaded));
    CHECK(client.itemsDone() == items);
    REQUIRE(taken.size() == items + 1u);
    for (uint16_t i = 0; i <= items; ++i) CHECK(taken[i] == static_cast<uint16_t>(i - 1));
  }
};

typedef std::vector<int> Numbers;

}  // namespace

TEST_CASE("of ArduPilot's items five are asked for, and another one with each that comes") {
  Reading desk(ClientOnLine::kArduPilot, 8);
  CHECK(desk.asked(20) == Numbers{0, 1, 2, 3, 4});
  for (uint16_t seq = 0; seq < 8; ++seq) {
    desk.give(seq);
    CHECK(desk.asked(20) == (seq < 3 ? Numbers{seq + 5} : Numbers{}));
  }
  desk.end(7);
}

TEST_CASE("several of ArduPilot's items come at once") {
  Reading desk(ClientOnLine::kArduPilot, 8);
  desk.asked(20);
  for (uint16_t seq = 0; seq < 5; ++seq) desk.give(seq);
  CHECK(desk.asked(20) == Numbers{5, 6, 7});
  for (uint16_t seq = 5; seq < 8; ++seq) desk.give(seq);
  desk.run(20);
  desk.end(7);
}

TEST_CASE("PX4's items, and those of one that is not known, are asked for one by one") {
  for (uint8_t autopilot : {ClientOnLine::kPx4, ClientOnLine::kOther}) {
    Reading desk(autopilot, 8);
    CHECK(desk.asked(20) == Numbers{0});
    desk.give(1);
    CHECK(desk.asked(20).empty());
    desk.give(0);
    CHECK(desk.asked(20) == Numbers{1});
  }
}

TEST_CASE("ArduPilot's items are asked for one by one where update() is called seldom, and the buffer would overflow") {
  Reading desk(ClientOnLine::kArduPilot, 8);
  CHECK(desk.asked(40, 10) == Numbers{0});
  desk.give(0);
  CHECK(desk.asked(40, 10) == Numbers{1});
}

TEST_CASE("ArduPilot's items are asked for one by one on a line that has lost something") {
  Reading desk(ClientOnLine::kArduPilot, 8, true);
  const Numbers asked = desk.asked(50);
  CHECK(asked.size() > 1);  // it is not answered
  for (const uint16_t item : asked) CHECK(item == 0);
}

TEST_CASE("what comes ahead of a lost item is asked for anew behind it, and each is taken once") {
  Reading desk(ClientOnLine::kArduPilot, 8);
  CHECK(desk.asked(20) == Numbers{0, 1, 2, 3, 4});
  desk.give(0);
  desk.give(2);  // the request for item 1 is lost
  desk.give(3);
  CHECK(desk.asked(100) == Numbers{5});
  desk.give(4);
  desk.give(5);
  CHECK(desk.asked(1) == Numbers{});
  CHECK(desk.asked(300) == Numbers{1, 2, 3, 4, 5});
  for (uint16_t seq = 1; seq < 8; ++seq) {
    desk.give(seq);
    desk.give(seq);  // the line brings it again
    desk.run(20);
  }
  desk.end(7);
}

TEST_CASE("an item that was not asked for yet is not taken, whatever has been asked for before it") {
  Reading desk(ClientOnLine::kArduPilot, 8);
  desk.asked(20);
  for (uint16_t seq : {5, 6, 1, 4, 0, 0}) desk.give(seq);
  CHECK(desk.asked(20) == Numbers{5});
  CHECK(desk.taken.size() == 1);
}

TEST_CASE("each of ArduPilot's refusals of several requests is an answer to the same reading") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(3000);
  const MissionItem plan[] = {waypoint(-35_deg, 149_deg, 20_m), waypoint(-35_deg, 149_deg, 20_m)};
  desk.client.verify(inRam(plan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 3000));
  desk.hear(countParts(3));
  desk.run(20);
  desk.sent.clear();
  for (int i = 0; i < 3; ++i) desk.hear(ackParts(1));  // somebody has made the plan shorter
  desk.run(100);
  CHECK(desk.client.isBusy());
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 1000));
  desk.hear(countParts(1));
  desk.run(20);
  CHECK((desk.ended == Status::Differs));
}

TEST_CASE("ArduPilot and PX4 are asked for an item by the new request alone") {
  for (uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    CHECK(requestsOfAnItem(autopilot) == std::vector<uint16_t>(8, ClientOnLine::kRequestInt));
  }
}
