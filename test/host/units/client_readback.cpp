// What follows the end of an upload by a whole client: when the plan is read back, and what that proves.
#include <doctest/doctest.h>

#include "Conversation.h"

using namespace mavmission;

namespace {

constexpr uint8_t kArduPilot = Conversation::kArduPilot, kPx4 = Conversation::kPx4, kOther = Conversation::kOther;
const MissionItem kPlan[] = {anyCommandAt(kNavWaypoint, -35.3632621_deg, 149.1652374_deg, 20_m), returnToLaunch()};
const MissionItem kRally[] = {rallyPoint(-35.36_deg, 149.16_deg, 20_m)};

// An upload up to its last item, as the call begins it.
struct Proving : Conversation {
  explicit Proving(uint8_t autopilot, const std::string& call = "upload", uint32_t startMs = 65000)
      : Conversation(autopilot, kPlan, PlanType::Mission, startMs) {
    begin(call);
  }
  void begin(const std::string& call) { plays(call + ", until COUNT, asks all"); }
};

const std::string kRead = "LIST | REQUEST 0-1, -> Accepted (OurPlan), ACK accepted";
const std::string kReadBehindHome = "LIST | REQUEST 0-2, -> Accepted (OurPlan), ACK accepted";

std::string isRead(uint8_t autopilot) { return autopilot == kArduPilot ? kReadBehindHome : kRead; }

}  // namespace

TEST_CASE("with Readback::Always an accepted plan is read back, and only then is it aboard and done") {
  for (const uint8_t autopilot : {kArduPilot, kPx4}) {
    Proving desk(autopilot, "upload always");
    CHECK(desk.plays("accepted") == "LIST");
    CHECK((desk.client.aboard() == Aboard::NotKnown));
    desk.plays("count, item 0");
    if (autopilot == kArduPilot) desk.plays("item 1");
    CHECK(desk.client.isBusy());
    CHECK(desk.progress == "1/2 ");
    CHECK(desk.plays(autopilot == kArduPilot ? "item 2" : "item 1") == "-> Accepted (OurPlan), ACK accepted");
    CHECK(desk.progress == "1/2 2/2 ");
    CHECK(desk.client.itemsDone() == 2);
    CHECK(desk.client.lastResult() == 0);
    CHECK(desk.plays("clear, until CLEAR 1 s") == "CLEAR");  // no late answer is waited for
  }
}

TEST_CASE("an upload that nobody confirms is read back, and what follows waits for late answers") {
  Proving desk(kArduPilot);
  desk.plays("until LIST");
  CHECK(desk.plays("count, items") == "REQUEST 0-2, -> Accepted (OurPlan), ACK accepted");
  // The next one waits, and nothing that comes after its COUNT is from before.
  CHECK(desk.plays("upload, 1 s | until COUNT 2 s, cancelled") == "| COUNT 3, -> CancelledByAutopilot (AsBefore)");
}

TEST_CASE("in a read-back a height, and what it counts from, must be those of the plan") {
  for (const uint8_t autopilot : {kPx4, kOther}) {
    Proving reference(autopilot, "upload always"), height(autopilot, "upload always");
    reference.held[0].frame = CoordinateFrame::Global;
    height.held[0].z = 21;
    CHECK(reference.plays("accepted, count, item 0") ==
          "LIST, REQUEST 0, -> Differs at 0 in Reference (NotKnown), ACK cancelled");
    CHECK(height.plays("accepted, count, item 0") ==
          "LIST, REQUEST 0, -> Differs at 0 in Height (NotKnown), ACK cancelled");
  }
}

TEST_CASE("on a lossy link, an acceptance is checked, unless PX4 has named the checksum with it") {
  for (const uint8_t autopilot : {kArduPilot, kPx4}) {
    Proving desk(autopilot, "broken, upload");
    CHECK(desk.plays("accepted | count, items") == isRead(autopilot));
    // When nothing has been lost for some time it is enough.
    desk.plays("11 s");
    desk.begin("upload");
    CHECK(desk.plays("accepted") == "-> Accepted (OurPlan)");
  }
  CHECK(Proving(kPx4, "broken, upload").plays("accepted named ours") == "-> Accepted (OurPlan)");
}

TEST_CASE("an error after the last item may be none, which the plan that is aboard shows") {
  CHECK(Proving(kArduPilot).plays("error | count, items | clear, until CLEAR 1 s") == kReadBehindHome + " | no CLEAR");
  // The last one was refused.
  CHECK(Proving(kArduPilot).plays("error | count 2") == "LIST | -> Error at 1 in Count (Mixture), ACK cancelled");
  // Of PX4 it is about a COUNT that came again, perhaps.
  CHECK(Proving(kPx4).plays("error | until ITEM, accepted | count 1") ==
        "| ITEM 1, LIST | -> Differs in Count (NotKnown), ACK cancelled");
}

TEST_CASE("an error before the last item, and any other refusal, is what it is") {
  Conversation early(kArduPilot, kPlan);
  early.plays("upload always, until COUNT, asks 0-1");
  CHECK(early.plays("error") == "-> Error at 0 (Mixture)");
  CHECK(Proving(kArduPilot, "upload always").plays("no space") == "-> NoSpace at 1 (Mixture)");
}

TEST_CASE("an upload without a read-back stays unconfirmed, whatever else the sketch has chosen") {
  for (const bool retries : {false, true}) {
    Conversation desk(kArduPilot, kPlan);
    if (retries) desk.client.retryWhenBusy(60);
    if (!retries) desk.client.useMissionItemFallback();
    desk.plays(
        "upload always, cancel, 3 s, upload unread, until COUNT, asks all");  // the first one's proof is forgotten
    CHECK(desk.plays("9100 ms") == "ITEM 2 x5, -> Unconfirmed (NotKnown)");
  }
}

TEST_CASE("another plan in the read-back: a mixture only where nothing was accepted, and only of ArduPilot's mission") {
  const struct {
    uint8_t autopilot;
    const char *ending, *aboard;
  } kCases[] = {{kArduPilot, "accepted", "NotKnown"},
                {kArduPilot, "until LIST", "Mixture"},
                {kPx4, "accepted", "NotKnown"},
                {kPx4, "until LIST", "NotKnown"},
                {kOther, "until LIST", "NotKnown"}};
  for (const auto& one : kCases) {
    Proving desk(one.autopilot, "upload always");
    desk.held.back().command = kNavLand;
    desk.plays(one.ending);
    CHECK(desk.plays("count, items") == (one.autopilot == kArduPilot ? "REQUEST 0-2" : "REQUEST 0-1") +
                                            std::string(", -> Differs at 1 in Command (") + one.aboard +
                                            "), ACK cancelled");
    CHECK(desk.client.itemsDone() == 1);
  }
  // Nor of its rally points.
  Conversation desk(kArduPilot, kRally, PlanType::Rally);
  CHECK(desk.plays("upload, until COUNT, asks 0 | until LIST | count 0") ==
        "COUNT 1 of rally, ITEM 0 of rally | ITEM 0 of rally x5, LIST of rally | -> Differs in Count (NotKnown), "
        "ACK cancelled of rally");
}

TEST_CASE("an autopilot that does not let itself be read back leaves the upload unconfirmed") {
  Proving silent(kArduPilot, "upload always"), denied(kArduPilot, "upload always"), late(kArduPilot, "upload always");
  CHECK(silent.plays("accepted, 8 s") == "LIST x5, -> Unconfirmed (NotKnown), ACK cancelled");
  CHECK(silent.client.lastResult() == 0);
  // It may still hold the upload open, and is asked again.
  CHECK(denied.plays("accepted, denied, error, cancelled | until LIST 2 s | count, items") ==
        "LIST | " + kReadBehindHome);
  // While items are read a denial may be due to a copy of our COUNT; the fifth is the end.
  const std::string readings = "count, until REQUEST 410 ms, denied, until LIST 410 ms, ";
  late.plays("accepted, " + readings + readings + readings + readings);
  CHECK(late.plays("count, until REQUEST 410 ms | denied") == "REQUEST 0 | -> Unconfirmed (NotKnown), ACK cancelled");
  CHECK(late.client.lastResult() == 14);
}

TEST_CASE("an error while items are compared begins the reading anew, and each request then waits for copies") {
  for (const bool isProof : {true, false}) {
    Conversation desk(kPx4, kPlan);
    desk.plays(isProof ? "upload always, until COUNT, asks all, accepted" : "verify, 5 ms");
    CHECK(desk.plays("count, item 0, error | 385 ms | until LIST 20 ms, count | 380 ms | until REQUEST 20 ms, item 0 | "
                     "380 ms | until REQUEST 20 ms, item 1, 410 ms") ==
          std::string("REQUEST 0-1 | | LIST | | REQUEST 0 | | REQUEST 1, ACK accepted, -> ") +
              (isProof ? "Accepted" : "Verified") + " (OurPlan)");
  }
}

TEST_CASE("PX4's checksum of its plan proves an upload in doubt without its items, and the reading is closed") {
  CHECK(Proving(kPx4).plays("until LIST | count named ours") ==
        "ITEM 1 x5, LIST | -> Accepted (OurPlan), ACK accepted");
  // With Readback::Always its items are read all the same.
  CHECK(Proving(kPx4, "upload always").plays("accepted | count named ours") == "LIST | REQUEST 0");
}

TEST_CASE("a server whose ways are not known begins anew on a lossy link, when it has given the upload up") {
  const auto first = [](uint8_t autopilot, const std::string& line, const std::string& answers) {
    Conversation desk(autopilot, kPlan);
    desk.plays(line + "upload, until COUNT, asks 0");
    return desk.plays(answers);
  };
  // What is cancelled then may be what was before.
  CHECK(first(kOther, "broken, ", "cancelled | cancelled, asks 0-1") == "COUNT 2 | ITEM 0-1");
  CHECK(first(kOther, "", "cancelled") == "-> CancelledByAutopilot at 0 (NotKnown)");
  CHECK(first(kOther, "broken, ", "denied") == "-> Denied at 0 (NotKnown)");
  CHECK(first(kArduPilot, "broken, ", "cancelled") == "-> CancelledByAutopilot (Mixture)");
  CHECK(first(kPx4, "broken, ", "cancelled") == "-> CancelledByAutopilot at 0 (AsBefore)");
}

TEST_CASE("an upload that has begun anew, and is refused then, may have changed what was aboard before") {
  Conversation desk(kOther, kPlan), patient(kOther, kPlan);
  patient.client.retryWhenBusy(2);
  const std::string events = "broken, upload, until COUNT, asks 0, cancelled | denied";
  CHECK(desk.plays(events) == "COUNT 2, ITEM 0, COUNT 2 | -> Denied (NotKnown)");
  CHECK(patient.plays(events) == "COUNT 2, ITEM 0, COUNT 2 |");
  CHECK((patient.client.status() == Status::BackingOff));
  CHECK(patient.plays("until COUNT 3 s, denied") == "COUNT 2, -> Denied (NotKnown)");
}

TEST_CASE("a server whose ways are not known, and that falls silent, is tried again on a lossy link") {
  Conversation clean(kOther, kPlan), lossy(kOther, kPlan);
  CHECK(clean.plays("upload, until COUNT, asks 0, 9 s") ==
        "COUNT 2, ITEM 0, -> TimedOut at 0 (NotKnown), ACK cancelled");
  lossy.plays("upload, until COUNT, asks 0");
  for (int second = 0; second < 9; ++second) lossy.plays("broken, 1 s");
  CHECK(lossy.client.isBusy());
  CHECK(lossy.timesOf(Conversation::kCount, 0).size() > 1);
}

TEST_CASE("a server whose ways are not known is read back, though it has accepted") {
  CHECK(Proving(kOther).plays("accepted | count, items") == kRead);
}
