// The whole table: each state, each answer, each firmware, with all evidence that there can be.
#include "mavmission/transfer/UploadVerdict.h"

#include <doctest/doctest.h>

#include <initializer_list>

using namespace mavmission;
using namespace mavmission::detail;
using mavmission::detail::Verdict;  // and not the one of a LinkDoctor
using State = UploadState;

namespace {

constexpr uint16_t kAll = 2 * kIsPart - 1;  // kinds of evidence

struct Known {
  uint16_t bits;
  constexpr bool has(uint16_t evidence) const { return (bits & evidence) != 0; }
};

struct Row {
  State state;
  Status answer;
  Firmware firmware;
  Known known;
  bool has(uint16_t evidence) const { return known.has(evidence); }
  Verdict verdict() const { return verdictOf(state, answer, firmware, known); }
};

// An acceptance before all items were sent is early; only of an empty plan, in Counting, it can be the answer.
bool canBe(State state, Status answer) {
  return answer == Status::AcceptedEarly ? state != State::Confirming
                                         : answer != Status::Accepted || state != State::Sending;
}

template <typename Check>
void forEachRow(const Check& check) {
  for (const State state : {State::Counting, State::Sending, State::Confirming}) {
    for (uint8_t result = 0; result <= 17; ++result) {
      const Status answer = result == 17 ? Status::AcceptedEarly : fromMissionResult(result);
      if (!canBe(state, answer)) continue;
      for (const Firmware firmware : {Firmware::ArduPilot, Firmware::Px4, Firmware::Other}) {
        for (uint16_t bits = 0; bits <= kAll; ++bits) check(Row{state, answer, firmware, Known{bits}});
      }
    }
  }
}

// A rule of the table: of all rows none breaks it.
template <typename Broken>
int broken(const Broken& isBroken) {
  int rows = 0;
  forEachRow([&](const Row& row) { rows += isBroken(row); });
  return rows;
}

constexpr Verdict of(State state, Status answer, Firmware firmware, uint16_t bits = 0) {
  return verdictOf(state, answer, firmware, Known{bits});
}

}  // namespace

// It is a function of what it is given alone: the compiler can tell.
static_assert(of(State::Confirming, Status::Accepted, Firmware::ArduPilot) == Verdict::Ends, "");
static_assert(of(State::Confirming, Status::Accepted, Firmware::ArduPilot, kBeyond) == Verdict::Unproven, "");
static_assert(of(State::Counting, Status::Accepted, Firmware::Px4, kFromBefore) == Verdict::Unproven, "");

TEST_CASE("an acceptance is believed where nothing else can have caused it, and is never taken for anything worse") {
  CHECK(broken([](const Row& row) {
          if (row.answer != Status::Accepted) return false;
          const bool isOfOther = row.has(kBeyond) || (row.has(kUnasked) && row.has(kDoubted)) ||
                                 (row.state == State::Counting && (row.has(kFromOpen) || row.has(kFromBefore))) ||
                                 (row.firmware == Firmware::Px4 && row.has(kUnasked) && row.has(kFromOpen));
          return row.verdict() != (isOfOther ? Verdict::Unproven : Verdict::Ends);
        }) == 0);
}

TEST_CASE("no answer but ACCEPTED says that the plan is aboard, and no refusal is lost") {
  CHECK(broken([](const Row& row) {
          const Verdict verdict = row.verdict();
          // These leave open whether the plan is aboard, and so all of it must have been sent.
          return verdict == Verdict::Unproven && row.state != State::Confirming && row.answer != Status::Accepted;
        }) == 0);
  // What stands for a refusal by its own name ends the upload at once, whatever else there is.
  CHECK(broken([](const Row& row) {
          const bool isNamed = row.answer > Status::Error && row.answer != Status::InvalidSequence &&
                               row.answer != Status::Denied && row.answer != Status::CancelledByAutopilot;
          return isNamed && row.verdict() != Verdict::Ends;
        }) == 0);
}

TEST_CASE("what comes early, or cancels, is doubted where an earlier operation can have caused it") {
  CHECK(
      broken([](const Row& row) {
        const bool isEarly = row.answer == Status::AcceptedEarly && (row.has(kFromOpen) || row.has(kFromBefore));
        const bool isCancelled =
            row.answer == Status::CancelledByAutopilot && row.state == State::Counting && row.has(kFromOpen);
        if (row.answer != Status::AcceptedEarly && row.answer != Status::CancelledByAutopilot) return false;
        // PX4 may have gone on with an earlier, shorter plan: that is over then.
        const bool isFreed = isEarly && row.firmware == Firmware::Px4 && !row.has(kFreed);
        const Verdict meant = isFreed ? Verdict::FreeFirst : isEarly || isCancelled ? Verdict::Doubted : Verdict::Ends;
        return row.verdict() != meant;
      }) == 0);
}

TEST_CASE("a denial is doubted of a part alone, whose announcement the line may bring once more") {
  CHECK(broken([](const Row& row) {
          return row.answer == Status::Denied && row.verdict() != (row.has(kIsPart) ? Verdict::Doubted : Verdict::Ends);
        }) == 0);
}

TEST_CASE("out of sequence: noise of ArduPilot and PX4, and the end of an upload to an unknown server") {
  CHECK(broken([](const Row& row) {
          if (row.answer != Status::InvalidSequence) return false;
          Verdict meant = Verdict::GoesOn;
          if (row.state == State::Counting) {
            meant = row.has(kFromOpen) ? Verdict::Doubted : Verdict::Ends;
          } else if (row.firmware == Firmware::Other) {
            meant = row.state == State::Sending ? Verdict::GivenUp : Verdict::Unproven;
          } else if (row.firmware == Firmware::ArduPilot && row.state == State::Sending && row.has(kIsTaken)) {
            meant = Verdict::NextItem;
          }
          return row.verdict() != meant;
        }) == 0);
}

TEST_CASE("an error to COUNT refuses it on ArduPilot, and elsewhere frees what may be ours, until the tries are used") {
  CHECK(broken([](const Row& row) {
          if (row.answer != Status::Error || row.state != State::Counting) return false;
          const bool isLate = row.has(kFromOpen) && row.has(kOnLossy);
          Verdict meant = isLate ? Verdict::Doubted : Verdict::Ends;
          if (row.firmware != Firmware::ArduPilot) {
            const bool mayBeOurs = (row.has(kFromBusy) || isLate) && !row.has(kTriesUsed);
            meant = !row.has(kFreed) ? Verdict::FreeFirst : mayBeOurs ? Verdict::GoesOn : Verdict::Ends;
          }
          return row.verdict() != meant;
        }) == 0);
}

TEST_CASE("an error to an item refuses it only where no copy, no repeat and no earlier message can have drawn it") {
  CHECK(broken([](const Row& row) {
          if (row.answer != Status::Error || row.state == State::Counting) return false;
          const bool isSending = row.state == State::Sending;
          Verdict meant = Verdict::Ends;
          if (isSending && row.has(kUnasked) && row.has(kLongAfter)) {
            meant = Verdict::GivenUp;
          } else if (row.has(kFromOpen) && row.has(kOnLossy) && (isSending || !row.has(kUnasked))) {
            meant = Verdict::GoesOn;
          } else if (row.firmware == Firmware::Px4) {
            meant = Verdict::Doubted;
          } else if (row.has(kUnasked)) {
            meant = isSending ? Verdict::GivenUp : Verdict::Unproven;
          } else if (!isSending && row.has(kItemAgain)) {
            meant = Verdict::Doubted;
          }
          return row.verdict() != meant;
        }) == 0);
}
