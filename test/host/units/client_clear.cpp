// clear() by a whole client.
#include <doctest/doctest.h>

#include "Conversation.h"

using namespace mavmission;

namespace {

constexpr uint8_t kArduPilot = Conversation::kArduPilot, kPx4 = Conversation::kPx4;
const MissionItem kPlan[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 20_m)};

// A clear that has left; what came before can be answered no more.
struct Clearing : Conversation {
  explicit Clearing(PlanType is, uint32_t startMs = 65000) : Conversation(kArduPilot, kPlan, is, startMs) {
    plays("8 s, clear, until CLEAR");
  }
};

}  // namespace

TEST_CASE("a plan of each type is cleared by itself, and nothing of that type is aboard then") {
  for (const PlanType type : {PlanType::Mission, PlanType::Fence, PlanType::Rally}) {
    Conversation desk(kArduPilot, kPlan, type);
    const std::string of = type == PlanType::Mission ? "" : type == PlanType::Fence ? " of fence" : " of rally";
    CHECK(desk.plays("8 s, clear, 5 ms, accepted") == "CLEAR" + of + ", -> Cleared (Nothing)");
    CHECK(desk.client.lastResult() == 0);
    for (const PlanType other : {PlanType::Mission, PlanType::Fence, PlanType::Rally}) {
      CHECK((desk.client.aboard(other) == (other == type ? Aboard::Nothing : Aboard::NotKnown)));
    }
  }
}

TEST_CASE("all plans are cleared one after the other, and the first refusal is the end, or silence") {
  for (const bool isSilent : {false, true}) {
    Conversation desk(kArduPilot, kPlan, PlanType::All);
    CHECK(desk.plays("8 s, clear, 5 ms | accepted of mission") == "CLEAR | CLEAR of fence");
    if (isSilent) {
      CHECK(desk.plays("8 s") == "CLEAR of fence x4, -> NoAnswer (NotKnown)");
    } else {
      CHECK(desk.plays("denied of fence") == "-> Denied (NotKnown)");
      CHECK(desk.client.lastResult() == 14);
    }
    CHECK((desk.client.aboard(PlanType::Mission) == Aboard::Nothing));
    CHECK((desk.client.aboard(PlanType::Fence) == Aboard::NotKnown));
  }
}

TEST_CASE("what is aboard is not known from the first CLEAR_ALL on, until it is accepted or refused at once") {
  const auto second = [](const std::string& events) {
    Clearing desk(PlanType::Mission);
    CHECK(desk.plays("accepted, 11 s") == "-> Cleared (Nothing)");
    desk.plays("clear, until CLEAR 10 ms");
    CHECK((desk.client.aboard() == Aboard::NotKnown));
    return desk.plays(events);
  };
  CHECK(second("denied, 8 s") == "-> Denied (Nothing)");
  CHECK(second("until CLEAR 2 s, denied, 8 s") == "CLEAR, -> Denied (NotKnown)");
  CHECK(second("8 s") == "CLEAR x4, -> NoAnswer (NotKnown)");
  CHECK(second("cancel, 8 s") == "-> Cancelled (NotKnown)");
}

TEST_CASE(
    "after another operation an acceptance is proven by the number of items, and CLEAR_ALL sent again if need be") {
  Clearing desk(PlanType::Mission);
  desk.plays("accepted, 3 s");
  CHECK(desk.plays("clear, until CLEAR 10 ms, count 0 | accepted") == "CLEAR | LIST");  // nobody had asked yet
  CHECK((desk.client.aboard() == Aboard::NotKnown));
  CHECK(desk.plays("denied, count 0 of fence | count 5") == "| ACK cancelled, CLEAR");      // so that PX4 does not wait
  CHECK(desk.plays("accepted | count 1") == "LIST | ACK cancelled, -> Cleared (Nothing)");  // ArduPilot's home
}

TEST_CASE("no CLEAR_ALL is sent to an autopilot that has been armed meanwhile") {
  Clearing desk(PlanType::All);
  desk.plays("silence");
  desk.baseMode = 128;
  desk.beat();
  CHECK(desk.plays("accepted of mission, 100 ms") == "-> Armed (NotKnown)");
}

TEST_CASE("a clear on a stream that takes no more bytes ends with its time limit") {
  Conversation desk(kArduPilot, kPlan);
  desk.client.setOperationTimeout(60);
  desk.line.room = 0;
  desk.line.takes = 0;
  CHECK(desk.plays("clear, 59 s | 2 s") == "| -> TookTooLong (NotKnown)");
}

TEST_CASE("neither the answer to another type nor another message ends a clear") {
  Clearing desk(PlanType::Fence);
  CHECK(desk.plays("accepted of mission, denied of rally, count 0") == "");
  CHECK(desk.client.lastResult() == 255);
  CHECK((desk.client.aboard() == Aboard::NotKnown));
}

TEST_CASE("the plans of an armed autopilot are cleared only where the sketch allows it") {
  Conversation desk(kArduPilot, kPlan), allowed(kArduPilot, kPlan);
  allowed.client.allowWhileArmed(true);
  CHECK(desk.plays("armed, clear, 1 s") == "-> Armed (NotKnown)");
  CHECK(allowed.plays("armed, clear, 1 s") == "CLEAR");
}

TEST_CASE("MAVLink 1 carries missions alone, and that is said first") {
  for (const bool isArmed : {false, true}) {
    for (const PlanType type : {PlanType::Mission, PlanType::Fence, PlanType::All}) {
      Conversation desk(kArduPilot, 65000, 0);
      desk.mavlinkVersion = 1;
      desk.baseMode = isArmed ? 128 : 0;
      desk.pass(3000);
      CHECK(desk.isAbout(emptyPlan(), type).plays("clear, 1 s") == std::string(type != PlanType::Mission
                                                                                   ? "-> NeedsMavlink2 (NotKnown)"
                                                                               : isArmed ? "-> Armed (NotKnown)"
                                                                                         : "CLEAR"));
    }
  }
}

TEST_CASE("a fence's clear stays one when the autopilot's heartbeats turn to MAVLink 1") {
  Conversation desk(kArduPilot, 65000, 2500);
  desk.isAbout(emptyPlan(), PlanType::Fence).plays("clear, 600 ms");
  desk.sent.clear();
  desk.mavlinkVersion = 1;
  CHECK(desk.plays("6 s").compare(0, 16, "CLEAR of fence x") == 0);
  for (const SentFrame& frame : desk.sent) CHECK((frame.messageId != 45 || frame.frame[0] == 0xFD));
}

TEST_CASE("after a transfer that was left open a clear waits for the answers to that") {
  Conversation desk(kArduPilot, kPlan);
  desk.plays("8 s, upload unread, until COUNT, asks 0");
  CHECK(desk.plays("cancel, clear, 1500 ms | until CLEAR 3 s, cancelled") ==
        "ACK cancelled, -> Cancelled (Mixture) | CLEAR");  // ArduPilot gives the upload up
  CHECK(desk.client.isBusy());
  // When nothing is open it is the answer.
  CHECK(desk.plays("9 s, cancelled") == "CLEAR x4, -> NoAnswer (NotKnown)");
}

TEST_CASE("after a reset a clear waits for answers to what was before, and is then repeated as any other") {
  Conversation desk(kArduPilot, 0, 0);
  desk.client.setTargetIds(1, 1);
  desk.pass(10);
  CHECK(desk.plays("clear, 8 s | denied") == "CLEAR x5 | -> Denied (NotKnown)");
  CHECK(desk.timesOf(45, 0) == std::vector<uint32_t>{1500, 3000, 4500, 6000, 7500});
}

TEST_CASE("a clear leaves in the update() that follows, and is a message of its target and type alone") {
  Clearing desk(PlanType::Fence);
  desk.plays("accepted, 1100 ms");
  CHECK(desk.isAbout(emptyPlan(), PlanType::Rally).plays("clear, 1 ms") == "CLEAR of rally");
}

TEST_CASE("after a reading that has ended a clear waits until a copy of its last message has come") {
  CHECK(
      Conversation(kArduPilot, kPlan).plays("8 s, verify, until LIST, count 5 | clear, 390 ms | until CLEAR 100 ms") ==
      "LIST, -> Differs in Count (NotKnown), ACK cancelled | | CLEAR");
}

TEST_CASE("what follows a clear that was repeated waits for the other answer, and what follows another one does not") {
  CHECK(Clearing(PlanType::Mission).plays("accepted, clear, 1 s") == "-> Cleared (Nothing), CLEAR");
  CHECK(Clearing(PlanType::Mission).plays("until CLEAR 1600 ms, accepted, clear, 1 s") ==
        "CLEAR, -> Cleared (Nothing)");
}

TEST_CASE("a clear that is cancelled is cancelled without a word, and the next one waits for its answer") {
  CHECK(Clearing(PlanType::Mission).plays("cancel, clear, clear, 1500 ms | until CLEAR 1500 ms") ==
        "Busy, -> Cancelled (NotKnown) | CLEAR");
}

TEST_CASE("after a clear PX4 may still be busy if it was asked for the number of items, and not otherwise") {
  const std::string refused = "upload unread, until COUNT | error | error, 20 ms";
  Conversation plain(kPx4, kPlan), asked(kPx4, kPlan);
  plain.plays("8 s, clear, 5 ms, accepted");
  CHECK(plain.plays(refused) == "COUNT 1 | ACK cancelled, COUNT 1 | -> Error (AsBefore)");
  asked.plays("8 s, clear, 5 ms, accepted, clear, until CLEAR, accepted, count 0");
  CHECK(asked.plays(refused) == "COUNT 1 | ACK cancelled, COUNT 1 |");
}
