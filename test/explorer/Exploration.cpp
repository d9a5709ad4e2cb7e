#include "Exploration.h"

#include <string.h>

#include <algorithm>
#include <vector>

#include "mavmission/base/Status.h"

using mavmission::Status;

namespace {

__extension__ typedef unsigned __int128 Wide;

struct Hash {
  uint64_t high, low;
};

uint64_t mixed(uint64_t a, uint64_t b) {
  const Wide product = static_cast<Wide>(a) * b;
  return static_cast<uint64_t>(product) ^ static_cast<uint64_t>(product >> 64);
}

// Sums of products of each two words to which numbers drawn by lot are added, two sums with numbers of their own: the
// products do not wait for each other. Different worlds meet in one of them, of 128 bits, once in 2^64 draws.
class Hasher {
 public:
  Hasher() {
    uint64_t drawn = 0x9E3779B97F4A7C15u;
    for (uint64_t& key : keys_) {
      drawn += 0x9E3779B97F4A7C15u;
      key = mixed(mixed(drawn, 0xBF58476D1CE4E5B9u) ^ drawn, 0x94D049BB133111EBu);
    }
  }

  Hash of(const World& world) const {
    const Word* const words = reinterpret_cast<const Word*>(&world);
    Wide one = 0, other = 0;
    for (size_t i = 0; i + 1 < kWords; i += 2) {
      one += static_cast<Wide>(words[i] + keys_[i]) * (words[i + 1] + keys_[i + 1]);
      other += static_cast<Wide>(words[i] + keys_[i + 2]) * (words[i + 1] + keys_[i + 3]);
    }
    if (kWords % 2 != 0) {
      one += static_cast<Wide>(words[kWords - 1] + keys_[kWords - 1]) * keys_[kWords];
      other += static_cast<Wide>(words[kWords - 1] + keys_[kWords + 1]) * keys_[kWords + 2];
    }
    return Hash{folded(one), folded(other)};
  }

 private:
  static uint64_t folded(Wide sum) {
    return mixed(static_cast<uint64_t>(sum) ^ 0x8EBC6AF09C88C6E3u,
                 static_cast<uint64_t>(sum >> 64) ^ 0x589965CC75374CC3u);
  }

  typedef uint64_t Word __attribute__((may_alias));

  static_assert(sizeof(World) % sizeof(Word) == 0 && alignof(World) == sizeof(Word), "hashed by 8 bytes");
  static constexpr size_t kWords = sizeof(World) / 8;
  uint64_t keys_[kWords + 3];
};

// The worlds that were met, by hash; each has a number.
class Known {
 public:
  Known() : slots_(1 << 16, Slot{kFree, 0}) {}

  // It will be asked for soon.
  void announce(const Hash& hash) const { __builtin_prefetch(&slots_[hash.high & (slots_.size() - 1)]); }

  // The number of a world; `isNew` if it had none.
  uint32_t numberOf(const Hash& hash, bool& isNew) {
    const uint32_t tag = tagOf(hash);
    size_t slot = hash.high & (slots_.size() - 1);
    for (; slots_[slot].number != kFree; slot = (slot + 1) & (slots_.size() - 1)) {
      if (slots_[slot].tag != tag) continue;
      const Hash& other = hashes_[slots_[slot].number];
      if (other.high == hash.high && other.low == hash.low) {
        isNew = false;
        return slots_[slot].number;
      }
    }
    isNew = true;
    const uint32_t number = static_cast<uint32_t>(hashes_.size());
    slots_[slot] = Slot{number, tag};
    hashes_.push_back(hash);
    if (hashes_.size() * 2 > slots_.size()) grow();
    return number;
  }
  size_t size() const { return hashes_.size(); }

 private:
  static constexpr uint32_t kFree = 0xFFFFFFFF;
  struct Slot {
    uint32_t number, tag;  // of its hash a part, so that the whole is seldom looked up
  };
  static uint32_t tagOf(const Hash& hash) { return static_cast<uint32_t>(hash.low); }

  void grow() {
    slots_.assign(slots_.size() * 2, Slot{kFree, 0});
    for (uint32_t i = 0; i < hashes_.size(); ++i) {
      size_t slot = hashes_[i].high & (slots_.size() - 1);
      while (slots_[slot].number != kFree) slot = (slot + 1) & (slots_.size() - 1);
      slots_[slot] = Slot{i, tagOf(hashes_[i])};
    }
  }

  std::vector<Hash> hashes_;
  std::vector<Slot> slots_;
};

struct Edge {
  uint32_t to;
  uint16_t ms;
  uint8_t isFault;
  uint8_t end;  // 0, or 1 + the status, in which the last operation ended
};

struct Way {
  uint32_t from;
  uint8_t move;  // which one
};

bool isSuccess(Status status) { return status > Status::Transferring && status < Status::Unconfirmed; }

class Explorer {
 public:
  Explorer(const Scenario& scenario, uint64_t mostStates) : scenario_(scenario), mostStates_(mostStates) {}

  Findings run() {
    World world;
    const Outcome began = world.begin(scenario_);
    note(world, hasher_.of(world), Way{0, 0}, began);
    if (began.broken != nullptr) fail(began.broken, 0);
    // As many steps away from the beginning, then those that are one more.
    for (std::vector<World> nearest; !waiting_.empty() && known_.size() <= mostStates_;) {
      nearest.swap(waiting_);
      waiting_.clear();
      for (const World& next : nearest) {
        expand(next);
        if (findings_.violations != 0) return findings_;
      }
    }
    findings_.isWhole = waiting_.empty();
    findings_.states = known_.size();
    findings_.transitions = edges_.size();
    for (int task = 0; task < kMostTasks; ++task) {
      for (int status = 0; status < 256; ++status) {
        if (ends_[task][status] == 0) continue;
        findings_.ends[std::to_string(task) + " " + mavmission::toString(static_cast<Status>(status))] =
            ends_[task][status];
      }
    }
    if (findings_.isWhole) measure();
    return findings_;
  }

 private:
  uint32_t note(const World& world, const Hash& hash, const Way& way, const Outcome& outcome) {
    bool isNew;
    const uint32_t number = known_.numberOf(hash, isNew);
    if (!isNew) return number;
    ways_.push_back(way);
    // What broke a rule is not followed further.
    if (outcome.broken == nullptr) {
      waiting_.push_back(world);
      order_.push_back(number);
    }
    return number;
  }

  void expand(const World& world) {
    const uint32_t from = order_[expanded_++];
    firstEdge_.push_back(edges_.size());
    const Moves moves = world.moves();
    if (moves.count == 0) {
      const char* const undone = world.leftUndone();
      if (undone != nullptr) fail(undone, from);
      return;
    }
    for (size_t i = 0; i < moves.count; ++i) {
      Step& step = steps_[i];
      memcpy(static_cast<void*>(&step.after), &world, sizeof(World));
      step.outcome = step.after.step(scenario_, moves.list[i], nullptr);
      step.hash = hasher_.of(step.after);
      known_.announce(step.hash);
    }
    for (size_t i = 0; i < moves.count; ++i) {
      const Outcome& outcome = steps_[i].outcome;
      const uint32_t to = note(steps_[i].after, steps_[i].hash, Way{from, static_cast<uint8_t>(i)}, outcome);
      const bool isLast = outcome.hasEnded && outcome.task + 1u == scenario_.tasks.size();
      const uint8_t end = isLast ? static_cast<uint8_t>(1 + static_cast<uint8_t>(outcome.status)) : 0;
      edges_.push_back(Edge{to, outcome.ms, outcome.isFault, end});
      if (outcome.hasEnded) ++ends_[outcome.task][static_cast<uint8_t>(outcome.status)];
      if (outcome.broken != nullptr) fail(outcome.broken, from, static_cast<int>(i));
    }
  }

  void fail(const char* broken, uint32_t at, int move = -1) {
    if (findings_.violations++ != 0) return;
    findings_.broken = broken;
    findings_.trace = traceTo(at, move);
  }

  // What happens on the way to a state, and in one more step.
  std::string traceTo(uint32_t at, int move) const {
    std::vector<int> moves;
    for (; at != 0; at = ways_[at].from) moves.push_back(ways_[at].move);
    std::reverse(moves.begin(), moves.end());
    if (move >= 0) moves.push_back(move);
    World world;
    world.begin(scenario_);
    std::string text;
    uint32_t nowMs = 0;
    for (int which : moves) {
      std::string log;
      const Outcome outcome = world.step(scenario_, world.moves().list[which], &log);
      nowMs += outcome.ms;
      char time[16];
      snprintf(time, sizeof(time), "%9.3f s  ", nowMs / 1000.0);
      text += time + (log.empty() ? "(nothing to be seen)" : log) + "\n";
    }
    return text;
  }

  // In an order in which every step leads forward, the longest time and the fewest faults to each state. Where there is
  // no such order some steps go round for ever.
  void measure() {
    const size_t states = known_.size();
    std::vector<uint32_t> arriving(states, 0), longestMs(states, 0), fewest(states, 0xFFFFFFFF);
    std::vector<uint64_t> begin(states, 0), end(states, 0);
    for (size_t i = 0; i < order_.size(); ++i) {
      begin[order_[i]] = firstEdge_[i];
      end[order_[i]] = i + 1 < order_.size() ? firstEdge_[i + 1] : edges_.size();
    }
    for (const Edge& edge : edges_) ++arriving[edge.to];
    fewest[0] = 0;
    std::vector<uint32_t> ready;
    if (arriving[0] == 0) ready.push_back(0);
    size_t done = 0;
    uint32_t fewestToFail = 0xFFFFFFFF, failedFrom = 0;
    int failedBy = 0;
    for (; done < ready.size(); ++done) {
      const uint32_t from = ready[done];
      for (uint64_t i = begin[from]; i < end[from]; ++i) {
        const Edge& edge = edges_[i];
        const uint32_t ms = longestMs[from] + edge.ms, faults = fewest[from] + edge.isFault;
        longestMs[edge.to] = std::max(longestMs[edge.to], ms);
        fewest[edge.to] = std::min(fewest[edge.to], faults);
        if (edge.end != 0) {
          findings_.longestMs = std::max(findings_.longestMs, ms);
          if (!isSuccess(static_cast<Status>(edge.end - 1)) && faults < fewestToFail) {
            fewestToFail = faults;
            failedFrom = from;
            failedBy = static_cast<int>(i - begin[from]);
          }
        }
        if (--arriving[edge.to] == 0) ready.push_back(edge.to);
      }
    }
    if (fewestToFail != 0xFFFFFFFF) {
      findings_.fewestFaults = static_cast<int>(fewestToFail);
      findings_.fewestFaultsTrace = traceTo(failedFrom, failedBy);
    }
    if (done == states) return;
    for (uint32_t at = 0; at < states; ++at) {
      if (arriving[at] == 0) continue;
      fail("it goes round for ever", at);
      return;
    }
  }

  const Scenario& scenario_;
  const uint64_t mostStates_;
  Findings findings_;
  const Hasher hasher_;
  Known known_;
  std::vector<World> waiting_;       // in the order in which they were come to
  std::vector<uint32_t> order_;      // the states, as they are expanded
  std::vector<uint64_t> firstEdge_;  // of each of them
  std::vector<Edge> edges_;
  std::vector<Way> ways_;  // how each state was first come to
  size_t expanded_ = 0;
  struct Step {
    World after;
    Outcome outcome;
    Hash hash;
  };
  Step steps_[Moves::kMost];  // from the world that is being expanded
  static constexpr int kMostTasks = 3;
  uint64_t ends_[kMostTasks][256] = {};  // by status, of each task
};

}  // namespace

Findings explore(const Scenario& scenario, uint64_t mostStates) { return Explorer(scenario, mostStates).run(); }

Findings findBySeeds(uint32_t seed, unsigned count,
                     const std::function<const char*(uint32_t, Findings*, std::string*)>& run) {
  Findings findings;
  findings.isWhole = true;
  for (; count != 0; --count, ++seed) {
    const char* const broken = run(seed, &findings, nullptr);
    if (broken == nullptr) continue;
    findings.violations = 1;
    run(seed, nullptr, &findings.trace);
    findings.broken = std::string(broken) + " (--seed " + std::to_string(seed) + ")";
    break;
  }
  return findings;
}
