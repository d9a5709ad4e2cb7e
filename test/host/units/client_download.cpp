// download() by a whole client: what the sink is given.
#include <doctest/doctest.h>

#include "Conversation.h"

using namespace mavmission;

namespace {

constexpr uint8_t kArduPilot = Conversation::kArduPilot, kPx4 = Conversation::kPx4, kOther = Conversation::kOther;
const MissionItem kPlan[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 20_m), jump(0, 3)};
const MissionItem kFence[] = {fenceInsideCircle(-35.36_deg, 149.16_deg, 100_m)};

struct Taken {
  uint16_t index;
  MissionItem item;
};

// A download into a sink that notes what it is given, as far as the question for the list.
struct Loading : Conversation {
  std::vector<Taken> taken;
  bool isReady = true, isFull = false;
  int asked = 0;

  explicit Loading(uint8_t autopilot, uint16_t limit = 100, PlanType is = PlanType::Mission, bool isRaw = false)
      : Conversation(autopilot) {
    type = is;
    client.useRawNumbering(isRaw);
    begin(limit);
  }
  void begin(uint16_t limit = 100) {
    const ItemSink sink = {write, this, limit, ready};
    CHECK((client.download(sink, type) == Status::WaitingForAutopilot));
    CHECK((client.download(sink, type) == Status::Busy));
    CHECK(plays("until LIST 3 s") == (type == PlanType::Fence ? "LIST of fence" : "LIST"));
  }
  static bool write(void* context, uint16_t index, const MissionItem& item) {
    Loading& loading = *static_cast<Loading*>(context);
    if (!loading.isFull) loading.taken.push_back({index, item});
    return !loading.isFull;
  }
  static bool ready(void* context) {
    ++static_cast<Loading*>(context)->asked;
    return static_cast<Loading*>(context)->isReady;
  }
};

// What a sink gets of a sent item is the item but for these.
void checkSame(const MissionItem& got, MissionItem sent, uint8_t current, float param1) {
  sent.current = current;
  sent.param1 = param1;
  CHECK(itemParts(0, got).payload == itemParts(0, sent).payload);
}

}  // namespace

TEST_CASE("ArduPilot's home comes first, by its own index, and each item with the sketch's number") {
  Loading desk(kArduPilot);
  CHECK(desk.client.itemsTotal() == 0);
  desk.held = {waypoint(-35.36_deg, 149.16_deg, 584_m), kPlan[0], kPlan[1]};
  desk.held[2].param1 = 1;  // after home
  desk.held[0].current = 1;
  CHECK(desk.plays("count") == "REQUEST 0-2");
  CHECK(desk.client.itemsTotal() == 2);
  desk.plays("item 0, item 1");
  CHECK(desk.client.itemsDone() == 1);
  CHECK(desk.plays("item 2") == "-> Downloaded (NotKnown), ACK accepted");
  CHECK(desk.client.itemsDone() == 2);
  REQUIRE(desk.taken.size() == 3);
  CHECK(desk.taken[0].index == kHomeIndex);
  checkSame(desk.taken[0].item, desk.held[0], 0, 0);
  CHECK(desk.taken[1].index == 0);
  checkSame(desk.taken[1].item, kPlan[0], 0, 0);
  CHECK(desk.taken[2].index == 1);
  checkSame(desk.taken[2].item, kPlan[1], 0, 0);  // the sketch's number
}

TEST_CASE("with raw numbering home is item 0, and the targets of jumps stay what they are") {
  Loading desk(kArduPilot, 100, PlanType::Mission, true);
  desk.held = {kPlan[0], jump(1, 3)};
  desk.held[0].current = 1;
  desk.plays("count");
  CHECK(desk.client.itemsTotal() == 2);
  CHECK(desk.plays("items") == "-> Downloaded (NotKnown), ACK accepted");
  REQUIRE(desk.taken.size() == 2);
  CHECK(desk.taken[0].index == 0);
  checkSame(desk.taken[0].item, kPlan[0], 1, 0);
  CHECK(desk.taken[1].index == 1);
  checkSame(desk.taken[1].item, jump(1, 3), 0, 1);
}

TEST_CASE("a download of a fence asks for the fence, and takes no item of a mission for one of its own") {
  Loading desk(kArduPilot, 100, PlanType::Fence);
  desk.held = {kFence[0]};
  CHECK(desk.plays("count 5 of mission | count | item 0 of mission") == "| REQUEST 0 of fence |");
  CHECK(desk.client.itemsTotal() == 1);
  CHECK(desk.taken.empty());
  CHECK(desk.plays("item 0") == "-> Downloaded (NotKnown), ACK accepted of fence");
  REQUIRE(desk.taken.size() == 1);
  CHECK(desk.taken[0].index == 0);
  CHECK(desk.taken[0].item.param1 == 100);
}

TEST_CASE("a sink that is not ready is asked again, and the item is not lost") {
  Loading desk(kPx4);
  desk.held = {kPlan[0]};
  desk.isReady = false;
  desk.plays("count, item 0");
  CHECK(desk.asked == 1);
  CHECK(desk.taken.empty());
  desk.isReady = true;
  CHECK(desk.plays("until REQUEST 260 ms, item 0") == "REQUEST 0, -> Downloaded (NotKnown), ACK accepted");
  CHECK(desk.asked == 2);
  CHECK(desk.taken.size() == 1);
}

TEST_CASE("a sink without such a question is always ready") {
  MissionItem array[2];
  Conversation desk(kPx4, kPlan);
  desk.client.download(toRam(array));
  CHECK(desk.plays("until LIST, count, items") == "LIST, REQUEST 0-1, -> Downloaded (NotKnown), ACK accepted");
  CHECK(array[0].x == kPlan[0].x);
  CHECK(array[1].param2 == 3);
}

TEST_CASE("a sink that is full, by its limit or in the middle, ends the download, and the autopilot is told") {
  Loading limited(kPx4, 1), full(kPx4, 2);
  CHECK(limited.plays("count 2") == "-> SinkFull (NotKnown), ACK cancelled");
  full.held = {kPlan[0], kPlan[1]};
  full.isFull = true;
  CHECK(full.plays("count | item 0") == "REQUEST 0 | -> SinkFull at 0 (NotKnown), ACK cancelled");
  full.isFull = false;
  full.pass(3000);
  full.begin(2);
  CHECK(full.plays("count, items") == "REQUEST 0-1, -> Downloaded (NotKnown), ACK accepted");  // as many as it may take
}

TEST_CASE("after a verification a download is stored, and not compared") {
  Loading desk(kPx4);
  desk.plays("cancel, 3 s");
  desk.isAbout(inRam(kPlan)).plays("verify, 5 ms, cancel, 3 s");
  desk.begin();
  desk.held = {kPlan[1]};  // of two
  CHECK(desk.plays("count, item 0") == "REQUEST 0, -> Downloaded (NotKnown), ACK accepted");
  CHECK(desk.taken.size() == 1);
}

TEST_CASE("an item that comes as floats is made one of integers") {
  Loading desk(kOther);
  desk.plays("count 2");
  desk.tell(floatItemParts(0, kPlan[0], -35.5f, 149.25f));
  desk.tell(floatItemParts(1, anyCommand(kDoSetServo, 1, 2), 5, -6));
  CHECK((desk.ended == Status::Downloaded));
  REQUIRE(desk.taken.size() == 2);
  CHECK(desk.taken[0].item.x == -355000000);
  CHECK(desk.taken[0].item.y == 1492500000);
  CHECK(desk.taken[0].item.z == 20);
  CHECK(desk.taken[1].item.x == 5);
  CHECK(desk.taken[1].item.y == -6);
  CHECK(desk.taken[1].item.param2 == 2);
}

TEST_CASE("an autopilot without a plan has nothing for the sink, and a plan of all types is none that can be read") {
  for (const uint8_t autopilot : {kArduPilot, kPx4}) {
    Loading desk(autopilot, 0);
    CHECK(desk.plays("count 0") == "ACK accepted, -> Downloaded (NotKnown)");
    CHECK(desk.client.itemsTotal() == 0);
    CHECK(desk.taken.empty());
    desk.type = PlanType::All;
    CHECK(desk.plays("download, 5 ms") == "-> BadPlanType (NotKnown)");
  }
}
