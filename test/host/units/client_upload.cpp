// Uploads by a whole client.
#include <doctest/doctest.h>

#include <algorithm>

#include "Conversation.h"

using namespace mavmission;

namespace {

typedef std::vector<uint32_t> Times;

constexpr uint8_t kArduPilot = Conversation::kArduPilot, kPx4 = Conversation::kPx4, kOther = Conversation::kOther;
const MissionItem kPlan[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 20_m), returnToLaunch()};

// An upload that may wait for a busy autopilot for so long.
struct Patient : Conversation {
  explicit Patient(uint8_t autopilot, uint16_t seconds = 60) : Conversation(autopilot, kPlan) {
    client.retryWhenBusy(seconds);
    pass(8000);  // what came before can be answered no more
  }
  // The first COUNTs are refused, the next one is left without an answer. When they left, from the first on.
  Times countsWhenDenied(int times) {
    sent.clear();
    plays("upload unread");
    for (int i = 0; i < times; ++i) plays("until COUNT, denied");
    plays("until COUNT");
    return timesOf(kCount, sent.front().atMs);
  }
  std::string state() { return nameOf(client.status()); }
};

bool isNear(const Times& times, const Times& expected) {
  return times.size() == expected.size() &&
         std::equal(times.begin(), times.end(), expected.begin(),
                    [](uint32_t one, uint32_t other) { return one >= other && one <= other + 10; });
}

}  // namespace

TEST_CASE("an upload goes out item by item as it is asked for, and each is the item that was asked for") {
  const std::string all = "3 s, upload unread, until COUNT, asks all, accepted";
  CHECK(Conversation(kArduPilot, kPlan).plays(all) == "COUNT 3, ITEM 0-2, -> Accepted (OurPlan)");
  CHECK(Conversation(kPx4, kPlan).plays(all) == "COUNT 2, ITEM 0-1, -> Accepted (OurPlan)");
  // The acceptance of an autopilot that is neither is no proof.
  CHECK(Conversation(kOther, kPlan).plays(all) == "COUNT 2, ITEM 0-1, -> Unconfirmed (NotKnown)");
}

TEST_CASE("a busy autopilot is tried again after 1, 2, 4, 8, 8 s, in each upload anew") {
  Patient desk(kArduPilot);
  CHECK(isNear(desk.countsWhenDenied(5), {0, 1000, 3000, 7000, 15000, 23000}));
  desk.plays("cancel, 11 s");
  CHECK(isNear(desk.countsWhenDenied(2), {0, 1000, 3000}));
}

TEST_CASE("the time that is allowed for back-offs begins with the first refusal of each upload") {
  Patient desk(kArduPilot, 4);
  for (int upload = 0; upload < 2; ++upload) {
    CHECK(isNear(desk.countsWhenDenied(2), {0, 1000, 3000}));
    // The next one would come 7 s after the first.
    CHECK(desk.plays("denied, 20 ms | 11 s") == "-> Denied (AsBefore) |");
  }
}

TEST_CASE("the time that is allowed for back-offs begins with the refusal, and the last try may be at its very end") {
  Patient desk(kArduPilot, 3);
  CHECK(desk.plays("upload unread, until COUNT, 4 s") == "COUNT 3 x3");
  desk.sent.clear();
  const uint32_t refusedMs = desk.nowMs();
  desk.plays("denied, 50 ms");
  CHECK(desk.state() == "BackingOff");
  desk.plays("until COUNT, denied, until COUNT");
  CHECK(isNear(desk.timesOf(Conversation::kCount, refusedMs), {1000, 3000}));
  CHECK(desk.state() == "Transferring");
}

TEST_CASE("an upload with retryWhenBusy() backs off after no other refusal, and without time after none") {
  CHECK(Patient(kArduPilot).plays("upload unread, until COUNT, no space") == "COUNT 3, -> NoSpace (AsBefore)");
  CHECK(Patient(kArduPilot).plays("upload unread, until COUNT, error") == "COUNT 3, -> Error (AsBefore)");
  CHECK(Patient(kPx4).plays("upload unread, until COUNT, no space") == "COUNT 2, -> NoSpace (AsBefore)");
  CHECK(Patient(kOther).plays("upload unread, until COUNT, no space") == "COUNT 2, -> NoSpace (AsBefore)");
  Patient never(kArduPilot), once(kArduPilot);
  never.client.retryWhenBusy(0);
  CHECK(never.plays("upload unread, until COUNT, denied, 3 s") == "COUNT 3, -> Denied (AsBefore)");
  once.client.retryWhenBusy(1);
  CHECK(once.plays("upload unread, until COUNT, denied | until COUNT 3 s") == "COUNT 3 | COUNT 3");
}

TEST_CASE("PX4's error to COUNT is waited for as a denial is, and the wait can be cancelled") {
  for (const std::string refused : {"error, 20 ms", "denied, 20 ms"}) {
    Patient desk(kPx4);
    desk.plays("upload unread");
    for (int i = 0; i < 9 && desk.state() != "BackingOff"; ++i) desk.plays("until COUNT 3 s, " + refused);
    CHECK(desk.state() == "BackingOff");
    CHECK(desk.plays("until COUNT 1100 ms, denied, 20 ms") == "COUNT 2");
    CHECK(desk.state() == "BackingOff");
    CHECK(desk.plays("cancel, 20 s") == "-> Cancelled (NotKnown)");
  }
}

TEST_CASE("after back-offs an upload begins anew, has its whole time, and goes on as any other") {
  Patient desk(kArduPilot);
  desk.client.setOperationTimeout(10);
  desk.countsWhenDenied(4);  // 15 s later
  const std::vector<Status> expected = {Status::BackingOff, Status::WaitingForAutopilot, Status::Checking,
                                        Status::Transferring};
  REQUIRE(desk.returned.size() >= expected.size());
  CHECK(std::equal(expected.rbegin(), expected.rend(), desk.returned.rbegin()));
  desk.pass(5000);
  CHECK(desk.state() == "Transferring");
  CHECK(desk.plays("asks all, accepted") == "ITEM 0-2, -> Accepted (OurPlan)");
}

TEST_CASE("an autopilot that fell silent during a back-off is waited for first") {
  Patient desk(kArduPilot);
  desk.countsWhenDenied(4);
  CHECK(desk.plays("denied, silence, 9900 ms") == "");
  CHECK(desk.state() == "WaitingForAutopilot");
  CHECK(desk.plays("heartbeats, until COUNT 1500 ms") == "COUNT 3");
}

TEST_CASE(
    "an upload that is begun on an autopilot that was not there yet has its whole time from the check of the plan on") {
  Conversation desk(kPx4, 65000, 0);
  desk.isAbout(inRam(kPlan, 1)).client.setOperationTimeout(3);
  // It is counted in whole seconds.
  CHECK(desk.plays("upload unread, until COUNT, 2990 ms | 1010 ms") ==
        "COUNT 1 x2 | COUNT 1, -> TookTooLong (AsBefore), ACK cancelled");
}
