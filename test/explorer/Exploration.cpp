#include "Exploration.h"

#include <string.h>

#include <algorithm>
#include <deque>
#include <vector>

#include "mavmission/Status.h"

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

// Two chains of multiplications, each with constants of its own.
Hash hashOf(const World& world) {
  static_assert(sizeof(World) % 8 == 0, "hashed by 8 bytes");
  const unsigned char* bytes = reinterpret_cast<const unsigned char*>(&world);
  uint64_t high = 0x9E3779B97F4A7C15u, low = 0xC2B2AE3D27D4EB4Fu;
  for (size_t i = 0; i < sizeof(World); i += 8) {
    uint64_t word;
    memcpy(&word, bytes + i, 8);
    high = mixed(high ^ word, 0xA0761D6478BD642Fu) + i;
    low = mixed(low + word, 0xE7037ED1A0B428DBu) ^ high;
  }
  return Hash{mixed(high, 0x8EBC6AF09C88C6E3u), mixed(low, 0x589965CC75374CC3u)};
}

// The worlds that were met, by hash; each has a number.
class Known {
 public:
  Known() : slots_(1 << 16, kFree) {}

  // The number of a world; `isNew` if it had none.
  uint32_t numberOf(const Hash& hash, bool& isNew) {
    size_t slot = hash.high & (slots_.size() - 1);
    for (; slots_[slot] != kFree; slot = (slot + 1) & (slots_.size() - 1)) {
      const Hash& other = hashes_[slots_[slot]];
      if (other.high == hash.high && other.low == hash.low) {
        isNew = false;
        return slots_[slot];
      }
    }
    isNew = true;
    slots_[slot] = static_cast<uint32_t>(hashes_.size());
    hashes_.push_back(hash);
    if (hashes_.size() * 2 > slots_.size()) grow();
    return static_cast<uint32_t>(hashes_.size() - 1);
  }
  size_t size() const { return hashes_.size(); }

 private:
  static constexpr uint32_t kFree = 0xFFFFFFFF;

  void grow() {
    slots_.assign(slots_.size() * 2, kFree);
    for (uint32_t i = 0; i < hashes_.size(); ++i) {
      size_t slot = hashes_[i].high & (slots_.size() - 1);
      while (slots_[slot] != kFree) slot = (slot + 1) & (slots_.size() - 1);
      slots_[slot] = i;
    }
  }

  std::vector<Hash> hashes_;
  std::vector<uint32_t> slots_;
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
    note(world, Way{0, 0}, began);
    if (began.broken != nullptr) fail(began.broken, 0);
    while (!waiting_.empty() && known_.size() <= mostStates_) {
      const World next = waiting_.front();
      waiting_.pop_front();
      expand(next);
    }
    findings_.isWhole = waiting_.empty();
    findings_.states = known_.size();
    findings_.transitions = edges_.size();
    if (findings_.isWhole) measure();
    return findings_;
  }

 private:
  uint32_t note(const World& world, const Way& way, const Outcome& outcome) {
    bool isNew;
    const uint32_t number = known_.numberOf(hashOf(world), isNew);
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
    const std::vector<Move> moves = world.moves();
    if (moves.empty()) {
      const char* const undone = world.leftUndone();
      if (undone != nullptr) fail(undone, from);
      return;
    }
    for (size_t i = 0; i < moves.size(); ++i) {
      World after;
      memcpy(static_cast<void*>(&after), &world, sizeof(World));
      const Outcome outcome = after.step(scenario_, moves[i], nullptr);
      const uint32_t to = note(after, Way{from, static_cast<uint8_t>(i)}, outcome);
      const bool isLast = outcome.hasEnded && outcome.task + 1u == scenario_.tasks.size();
      const uint8_t end = isLast ? static_cast<uint8_t>(1 + static_cast<uint8_t>(outcome.status)) : 0;
      edges_.push_back(Edge{to, outcome.ms, outcome.isFault, end});
      if (outcome.hasEnded) ++findings_.ends[std::to_string(outcome.task) + " " + mavmission::toString(outcome.status)];
      if (outcome.broken != nullptr) fail(outcome.broken, from, static_cast<int>(i));
    }
  }

  void fail(const char* broken, uint32_t at, int move = -1) {
    ++findings_.violations;
    if (findings_.violations != 1) return;
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
      const Outcome outcome = world.step(scenario_, world.moves()[static_cast<size_t>(which)], &log);
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
  Known known_;
  std::deque<World> waiting_;
  std::vector<uint32_t> order_;      // the states, as they are expanded
  std::vector<uint64_t> firstEdge_;  // of each of them
  std::vector<Edge> edges_;
  std::vector<Way> ways_;  // how each state was first come to
  size_t expanded_ = 0;
};

}  // namespace

Findings explore(const Scenario& scenario, uint64_t mostStates) { return Explorer(scenario, mostStates).run(); }
