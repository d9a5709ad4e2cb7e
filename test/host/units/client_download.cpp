// download() by a whole client: what the sink is given.
#include <doctest/doctest.h>

#include "ClientOnLine.h"
#include "PlanFrames.h"

using namespace mavmission;

namespace {

const MissionItem kPlan[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 20_m), jump(0, 3)};

struct Taken {
  uint16_t index;
  MissionItem item;
};

struct Sink {
  std::vector<Taken> taken;
  bool isReady = true, isFull = false;
  int asked = 0;

  ItemSink sink(uint16_t limit = 100) { return ItemSink{write, this, limit, ready}; }
  static bool write(void* context, uint16_t index, const MissionItem& item) {
    Sink& sink = *static_cast<Sink*>(context);
    if (sink.isFull) return false;
    sink.taken.push_back({index, item});
    return true;
  }
  static bool ready(void* context) {
    Sink& sink = *static_cast<Sink*>(context);
    ++sink.asked;
    return sink.isReady;
  }
};

struct Loading : ClientOnLine {
  Loading(uint8_t autopilot, const ItemSink& sink, bool isRaw = false, PlanType type = PlanType::Mission)
      : ClientOnLine(autopilot) {
    run(3000);
    client.useRawNumbering(isRaw);
    CHECK((client.download(sink, type) == Status::WaitingForAutopilot));
    CHECK((client.download(sink, type) == Status::Busy));
    REQUIRE(runUntilSent(kRequestList, 3000));
    CHECK(sent.back().payload[2] == static_cast<uint8_t>(type));
    sent.clear();
  }
  void tell(const FrameParts& parts) {
    hear(parts);
    run(5);
  }
  // The numbers of the items that were asked for.
  std::vector<int> asked() const {
    std::vector<int> numbers;
    for (const SentFrame& frame : sent) {
      if (frame.messageId == kRequestInt) numbers.push_back(frame.payload[0]);
    }
    return numbers;
  }
};

}  // namespace

TEST_CASE("a plan comes item by item, with the sketch's numbers and ArduPilot's home apart") {
  Sink to;
  Loading desk(ClientOnLine::kArduPilot, to.sink());
  CHECK(desk.client.itemsTotal() == 0);
  desk.tell(countParts(3));
  CHECK(desk.client.itemsTotal() == 2);
  MissionItem onTheWire[] = {waypoint(-35.36_deg, 149.16_deg, 584_m), kPlan[0], kPlan[1]};
  onTheWire[2].param1 = 1;  // behind home
  onTheWire[0].current = 1;
  for (uint16_t seq = 0; seq < 3; ++seq) {
    CHECK(desk.asked() == std::vector<int>{0, 1, 2});
    CHECK(desk.client.itemsDone() == (seq == 0 ? 0 : seq - 1));
    desk.tell(itemParts(seq, onTheWire[seq]));
  }
  CHECK((desk.ended == Status::Downloaded));
  CHECK(desk.client.itemsDone() == 2);
  CHECK(desk.sent.back().messageId == ClientOnLine::kAck);
  CHECK(desk.sent.back().payload[2] == 0);
  REQUIRE(to.taken.size() == 3);
  CHECK(to.taken[0].index == kHomeIndex);
  CHECK(to.taken[0].item.x == onTheWire[0].x);
  CHECK(to.taken[0].item.z == 584);
  CHECK(to.taken[0].item.current == 0);
  CHECK(to.taken[1].index == 0);
  CHECK(to.taken[1].item.command == kNavWaypoint);
  CHECK(to.taken[1].item.x == kPlan[0].x);
  CHECK(to.taken[1].item.y == kPlan[0].y);
  CHECK(to.taken[1].item.z == 20);
  CHECK((to.taken[1].item.frame == CoordinateFrame::GlobalRelative));
  CHECK(to.taken[1].item.autocontinue == 1);
  CHECK(to.taken[1].item.current == 0);
  CHECK(to.taken[2].index == 1);
  CHECK(to.taken[2].item.command == kDoJump);
  CHECK(to.taken[2].item.param1 == 0);  // the sketch's number
  CHECK(to.taken[2].item.param2 == 3);
}

TEST_CASE("with raw numbering home is item 0, and the targets of jumps stay what they are") {
  Sink to;
  Loading desk(ClientOnLine::kArduPilot, to.sink(), true);
  desk.tell(countParts(2));
  CHECK(desk.client.itemsTotal() == 2);
  MissionItem first = kPlan[0];
  first.current = 1;
  desk.tell(itemParts(0, first));
  desk.tell(itemParts(1, jump(1, 3)));
  CHECK((desk.ended == Status::Downloaded));
  REQUIRE(to.taken.size() == 2);
  CHECK(to.taken[0].index == 0);
  CHECK(to.taken[0].item.current == 1);
  CHECK(to.taken[1].index == 1);
  CHECK(to.taken[1].item.param1 == 1);
}

TEST_CASE("a download of a fence asks for the fence, and takes no item of a mission for one of its own") {
  Sink to;
  Loading desk(ClientOnLine::kArduPilot, to.sink(), false, PlanType::Fence);
  desk.tell(countParts(5));
  CHECK(desk.client.itemsTotal() == 0);
  desk.tell(countParts(1, PlanType::Fence));
  CHECK(desk.client.itemsTotal() == 1);
  REQUIRE(desk.timesOf(ClientOnLine::kRequestInt, 0).size() == 1);
  CHECK(desk.sent.back().payload[4] == 1);
  const MissionItem circle = fenceInsideCircle(-35.36_deg, 149.16_deg, 100_m);
  desk.tell(itemParts(0, circle));
  CHECK(to.taken.empty());
  desk.tell(itemParts(0, circle, PlanType::Fence));
  CHECK((desk.ended == Status::Downloaded));
  REQUIRE(to.taken.size() == 1);
  CHECK(to.taken[0].index == 0);
  CHECK(to.taken[0].item.param1 == 100);
}

TEST_CASE("a sink that is not ready is asked again, and the item is not lost") {
  Sink to;
  to.isReady = false;
  Loading desk(ClientOnLine::kPx4, to.sink());
  desk.tell(countParts(1));
  desk.tell(itemParts(0, kPlan[0]));
  CHECK(to.asked == 1);
  CHECK(to.taken.empty());
  CHECK(desk.client.isBusy());
  to.isReady = true;
  desk.sent.clear();
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestInt, 260));
  desk.tell(itemParts(0, kPlan[0]));
  CHECK(to.asked == 2);
  CHECK((desk.ended == Status::Downloaded));
  CHECK(to.taken.size() == 1);
}

TEST_CASE("a sink without such a question is always ready") {
  MissionItem array[2];
  Loading desk(ClientOnLine::kPx4, toRam(array));
  desk.tell(countParts(2));
  desk.tell(itemParts(0, kPlan[0]));
  desk.tell(itemParts(1, kPlan[1]));
  CHECK((desk.ended == Status::Downloaded));
  CHECK(array[0].x == kPlan[0].x);
  CHECK(array[1].param2 == 3);
}

TEST_CASE("a sink that is full, by its limit or in the middle, ends the download, and the autopilot is told") {
  for (const bool isByLimit : {true, false}) {
    Sink to;
    Loading desk(ClientOnLine::kPx4, to.sink(isByLimit ? 1 : 2));
    to.isFull = true;
    desk.tell(countParts(2));
    if (!isByLimit) desk.tell(itemParts(0, kPlan[0]));
    CHECK((desk.ended == Status::SinkFull));
    CHECK(desk.client.failedItem() == (isByLimit ? MissionClient::kNoItem : 0));
    desk.run(5);
    REQUIRE(desk.timesOf(ClientOnLine::kAck, 0).size() == 1);
    for (const SentFrame& frame : desk.sent) {
      if (frame.messageId == ClientOnLine::kAck) CHECK(frame.payload[2] == 15);  // MAV_MISSION_OPERATION_CANCELLED
    }
  }
}

TEST_CASE("behind a verification a download is stored, and not compared") {
  ClientOnLine desk(ClientOnLine::kPx4);
  desk.run(3000);
  desk.client.verify(inRam(kPlan));
  desk.run(5);
  desk.client.cancel();
  Sink to;
  desk.client.download(to.sink());
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 3000));
  desk.hear(countParts(1));  // of two
  desk.run(5);
  desk.hear(itemParts(0, kPlan[1]));
  desk.run(5);
  CHECK((desk.ended == Status::Downloaded));
  CHECK(to.taken.size() == 1);
  CHECK((desk.client.aboard() == Aboard::NotKnown));
}

TEST_CASE("as many items as the sink may take are taken") {
  Sink to;
  Loading desk(ClientOnLine::kPx4, to.sink(2));
  desk.tell(countParts(2));
  CHECK(desk.client.isBusy());
}

TEST_CASE("an item that comes as floats is made one of integers") {
  Sink to;
  Loading desk(ClientOnLine::kOther, to.sink());
  desk.tell(countParts(2));
  desk.tell(floatItemParts(0, kPlan[0], -35.5f, 149.25f));
  desk.tell(floatItemParts(1, anyCommand(kDoSetServo, 1, 2), 5, -6));
  CHECK((desk.ended == Status::Downloaded));
  REQUIRE(to.taken.size() == 2);
  CHECK(to.taken[0].item.x == -355000000);
  CHECK(to.taken[0].item.y == 1492500000);
  CHECK(to.taken[0].item.z == 20);
  CHECK(to.taken[1].item.x == 5);
  CHECK(to.taken[1].item.y == -6);
  CHECK(to.taken[1].item.param2 == 2);
}

TEST_CASE("an autopilot without a plan has nothing for the sink") {
  for (const uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    Sink to;
    Loading desk(autopilot, to.sink(0));
    desk.tell(countParts(0));
    CHECK((desk.ended == Status::Downloaded));
    CHECK(desk.client.itemsTotal() == 0);
    CHECK(to.taken.empty());
  }
}

TEST_CASE("a plan of all types is none that can be read") {
  Sink to;
  ClientOnLine desk(ClientOnLine::kPx4);
  desk.run(3000);
  CHECK((desk.client.download(to.sink(), PlanType::All) == Status::BadPlanType));
  desk.run(5);
  CHECK((desk.ended == Status::BadPlanType));
}
