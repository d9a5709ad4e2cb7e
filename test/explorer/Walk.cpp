#include "Exploration.h"

#include <string.h>

#include "Random.h"
#include "mavmission/base/Status.h"

namespace {

// What a line does to each frame is drawn for each walk: a few of 100 frames suffer it. In every third walk there are
// two links, of which the second one brings each frame later; one or the other drops out at times.
class Walker {
 public:
  explicit Walker(uint32_t seed) : random_(seed), hasTwoLinks_(seed % 3 == 0) {}

  Scenario drawn(Firmwares firmware) {
    Scenario scenario;
    scenario.firmware = firmware;
    const bool byFile = firmware == Firmwares::ArduPilot && below(5) == 0;
    const uint32_t operations = byFile ? 9 : 7;
    for (uint8_t plan = 1; plan <= 3; ++plan) {
      Task task = Task();
      task.operation = byFile && plan == 1 ? Operation::FileUpload : static_cast<Operation>(below(operations));
      task.items = static_cast<uint8_t>(below(6));
      task.plan = plan;
      scenario.tasks.push_back(task);
    }
    scenario.heldItems = static_cast<uint8_t>(below(5));
    scenario.losses = static_cast<uint8_t>(below(2) * below(30));
    scenario.copies = static_cast<uint8_t>(1 + below(200));
    scenario.reboots = below(6) == 0;
    scenario.cancels = below(4) == 0;
    scenario.latencyMs = below(3) == 0 ? 150 : 0;
    scenario.isLossy = below(2) != 0;
    suffersOf100_ = 3 + below(30);
    if (hasTwoLinks_) {
      scenario.hasTwoLinks = true;
      scenario.copies = Scenario::kAnyNumber;
      second_ = static_cast<int>(below(3));
    }
    return scenario;
  }

  // Returns which of the moves is made.
  int next(const Moves& moves) {
    int fates[kFates] = {};
    for (int i = 0; i < moves.count; ++i) fates[static_cast<int>(moves.list[i].fate)] = i;
    const int copied = static_cast<int>(Fate::Copied30) + second_, late = static_cast<int>(Fate::Late30) + second_;
    if (fates[late] != 0 && below(50) != 0) {
      if (below(isDown_ ? 20 : 50) == 0) isDown_ = !isDown_;
      if (!isDown_) which_ = below(2);
      return isDown_ ? which_ == 0 ? fates[late] : 0 : fates[copied];
    }
    if (moves.count == 1 || below(100) >= suffersOf100_) return 0;
    return static_cast<int>(1 + below(moves.count - 1u));
  }

 private:
  uint32_t below(uint32_t n) { return random_.below(n); }

  Random random_;
  bool hasTwoLinks_;
  uint32_t suffersOf100_ = 0;
  int second_ = 0;       // by how much the second link is later, where there are two
  bool isDown_ = false;  // one of them has dropped out,
  uint32_t which_ = 0;   // this one
};

// Null, or the rule that is broken on the way.
const char* go(Firmwares firmware, uint32_t seed, Findings* findings, std::string* told) {
  constexpr uint64_t kMostSteps = 100000;  // of a walk, which otherwise never ends
  Walker walker(seed);
  const Scenario scenario = walker.drawn(firmware);
  World world;
  world.begin(scenario);
  uint32_t nowMs = 0;
  for (uint64_t steps = 0; steps < kMostSteps; ++steps) {
    const Moves moves = world.moves();
    if (moves.count == 0) return world.leftUndone();
    std::string log;
    const Outcome outcome = world.step(scenario, moves.list[walker.next(moves)], told != nullptr ? &log : nullptr);
    nowMs += outcome.ms;
    if (told != nullptr) *told += std::to_string(nowMs) + " ms  " + log + "\n";
    if (findings != nullptr) ++findings->transitions;
    if (findings != nullptr && outcome.hasEnded) {
      ++findings->operations;
      ++findings->ends[std::to_string(outcome.task + 1) + " " + mavmission::toString(outcome.status)];
    }
    // (So many copies at once have no place in the line of an exploration.)
    if (outcome.broken != nullptr && strstr(outcome.broken, "fuller") != nullptr) return nullptr;
    if (outcome.broken != nullptr) return outcome.broken;
  }
  return "it goes on for ever";
}

}  // namespace

Findings walk(Firmwares firmware, uint32_t seed, unsigned count) {
  return findBySeeds(seed, count, [firmware](uint32_t one, Findings* findings, std::string* told) {
    return go(firmware, one, findings, told);
  });
}
