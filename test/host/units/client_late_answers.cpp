// What one operation leaves behind for the next: answers that are still on their way, and what aboard() says.
#include <doctest/doctest.h>

#include "ClientOnLine.h"

using namespace mavmission;

namespace {

const uint8_t kAccepted = 0, kError = 1, kCancelled = 15;
const uint16_t kClearAll = 45;
const MissionItem kPlan[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 20_m)};
const MissionItem kOther[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 40_m), returnToLaunch()};

// Up to its last item; nothing has answered that.
void sendPlan(ClientOnLine& desk, uint16_t itemsOnTheWire) {
  desk.client.uploadWithoutReadback(inRam(kPlan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 3000));
  for (uint16_t item = 0; item < itemsOnTheWire; ++item) {
    desk.hear(requestParts(item));
    REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 50));
  }
}

// As after a line that answers late: the last item was sent twice, and the first of them is accepted.
void acceptLate(ClientOnLine& desk) {
  sendPlan(desk, 2);
  REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 2000));
  desk.hear(ackParts(kAccepted));
  desk.run(2);
  REQUIRE((desk.ended == Status::Accepted));
}

}  // namespace

TEST_CASE("what follows an upload that has repeated its last item is not ended by the answer to that") {
  for (int second = 0; second < 3; ++second) {
    ClientOnLine desk(ClientOnLine::kArduPilot);
    desk.run(11000);
    acceptLate(desk);
    desk.sent.clear();
    if (second == 0) desk.client.clear();
    if (second == 1) desk.client.verify(inRam(kPlan));
    if (second == 2) desk.client.uploadWithoutReadback(inRam(kOther));
    desk.run(100);
    desk.hear(ackParts(kError));
    desk.run(1000);
    desk.hear(ackParts(kError));
    desk.run(400);
    CHECK(desk.client.isBusy());
    CHECK(desk.timesOf(kClearAll, 0).empty());
    CHECK(desk.timesOf(ClientOnLine::kRequestList, 0).empty());
    CHECK(desk.timesOf(ClientOnLine::kCount, 0).empty());
    const uint16_t first[] = {kClearAll, ClientOnLine::kRequestList, ClientOnLine::kCount};
    CHECK(desk.runUntilSent(first[second], 600));
  }
}

TEST_CASE("what follows an upload that has repeated nothing waits until a copy of its last message has been answered") {
  for (const uint8_t answer : {kAccepted, kError}) {
    ClientOnLine desk(ClientOnLine::kArduPilot);
    desk.run(11000);
    sendPlan(desk, 2);
    desk.hear(ackParts(kAccepted));
    desk.run(2);
    REQUIRE((desk.ended == Status::Accepted));
    desk.client.clear();
    desk.run(350);
    desk.hear(ackParts(answer));  // what a copy of the last item draws from PX4, and from ArduPilot
    CHECK_FALSE(desk.runUntilSent(kClearAll, 30));
    CHECK(desk.runUntilSent(kClearAll, 40));
    CHECK(desk.client.isBusy());
  }
}

TEST_CASE("behind an upload in which a frame came twice it also waits for the copy of that answer") {
  enum class Twice { Never, BeforeIt, InIt };
  for (const Twice twice : {Twice::Never, Twice::BeforeIt, Twice::InIt}) {
    ClientOnLine desk(ClientOnLine::kArduPilot);
    desk.run(11100);
    if (twice == Twice::BeforeIt) {
      desk.lose(255);  // the next frame has the number of the last one
      desk.hear(heartbeatParts(ClientOnLine::kArduPilot));
      desk.run(10);
    }
    sendPlan(desk, 2);
    if (twice == Twice::InIt) desk.lose(255);
    desk.hear(ackParts(kAccepted));
    desk.run(2);
    REQUIRE((desk.ended == Status::Accepted));
    desk.client.clear();
    CHECK(desk.runUntilSent(kClearAll, 700) == (twice != Twice::InIt));
    CHECK(desk.runUntilSent(kClearAll, 200) == (twice == Twice::InIt));
  }
}

TEST_CASE("a command does not wait for late answers of the mission protocol") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(11000);
  acceptLate(desk);
  desk.client.arm();
  CHECK(desk.runUntilSent(76, 10));
}

TEST_CASE("the acceptance of an upload that was cancelled is not that of the next one") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(11000);
  sendPlan(desk, 2);
  desk.client.cancel();
  desk.run(2);
  desk.ended = Status::Idle;
  desk.client.uploadWithoutReadback(emptyPlan());
  desk.run(700);
  desk.hear(ackParts(kAccepted));
  desk.run(50);
  CHECK((desk.ended == Status::Idle));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 1500));
  desk.hear(ackParts(kAccepted));
  desk.run(2);
  CHECK((desk.ended == Status::Unconfirmed));  // it looks the same
}

TEST_CASE("ArduPilot gives up an upload that was left open, and the clear or the reading goes on") {
  for (const bool clears : {true, false}) {
    ClientOnLine desk(ClientOnLine::kArduPilot);
    desk.run(11000);
    sendPlan(desk, 1);
    desk.client.cancel();
    desk.run(2500);
    if (clears) {
      desk.client.clear();
      REQUIRE(desk.runUntilSent(kClearAll, 10));
    } else {
      desk.client.verify(inRam(kPlan));
      REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 10));
    }
    desk.hear(ackParts(kCancelled));
    desk.run(2);
    CHECK(desk.client.isBusy());
  }
}

TEST_CASE("an empty plan is not accepted while its COUNT waits for room") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(3000);
  REQUIRE(desk.runUntilSent(0, 1100));  // our heartbeat, so that none is due now
  desk.line.room = 4;
  desk.line.takes = 4;
  desk.client.uploadWithoutReadback(emptyPlan());
  desk.run(1);
  desk.line.room = 0;
  desk.run(20);
  desk.hear(ackParts(kAccepted));
  desk.run(20);
  CHECK(desk.client.isBusy());
  desk.line.room = desk.line.kAlwaysRoom;
  desk.line.takes = 1000000;
  desk.run(10);
  desk.hear(ackParts(kAccepted));
  desk.run(2);
  CHECK((desk.ended == Status::Accepted));
}

TEST_CASE("aboard() is about the plan that was given last, from its first message on") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(11000);
  sendPlan(desk, 2);
  desk.hear(ackParts(kAccepted));
  desk.run(2);
  REQUIRE((desk.client.aboard() == Aboard::OurPlan));

  desk.client.verify(inRam(kPlan));  // the same one
  desk.client.cancel();
  CHECK((desk.client.aboard() == Aboard::OurPlan));

  uint16_t first = ClientOnLine::kRequestList;
  Aboard then = Aboard::NotKnown;
  SUBCASE("verify() of another one") { desk.client.verify(inRam(kOther)); }
  SUBCASE("a longer part of the same array") { desk.client.verify(inRam(kPlan, 2)); }
  SUBCASE("upload() of another one") {
    desk.client.uploadWithoutReadback(inRam(kOther));
    first = ClientOnLine::kCount;
  }
  SUBCASE("a plan of another type") {
    static const MissionItem kRally[] = {rallyPoint(1_deg, 1_deg, 20_m)};
    desk.client.uploadWithoutReadback(inRam(kRally), PlanType::Rally);
    first = ClientOnLine::kCount;
    then = Aboard::OurPlan;
  }
  CHECK((desk.client.aboard() == Aboard::OurPlan));
  CHECK(desk.runUntilSent(first, 9000));
  CHECK((desk.client.aboard() == then));
}
