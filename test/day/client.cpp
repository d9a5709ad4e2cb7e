// A sketch with a whole MissionClient and a follower, for this computer: it does what lines on its input tell it, in a
// time that they turn, and answers each with a line. test/support/host_client.py is the other end, or udp_client.py,
// for a client over UDP. loop() runs each millisecond.
//
// With CLIENT_BESIDE there are listeners beside it that ask by commands of their own, and what else sends commands.
//
// Every allocation that the library makes is counted. This file is compiled without access control: it shows the
// client's bytes but for those that are times, counters or buffers, which are private.
#include <Arduino.h>
#include <MavMission.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <algorithm>
#include <new>
#include <string>

#include "Words.h"
#include CLIENT_LINE  // SerialLine.h or UdpLine.h

using namespace mavmission;
using namespace mavmission::detail;

// ---- Allocations, counted while the library runs.

static bool isCounting;
static unsigned long allocations;

extern "C" {
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* block, size_t size);

void* malloc(size_t size) {
  allocations += isCounting;
  return __libc_malloc(size);
}
void* calloc(size_t count, size_t size) {
  allocations += isCounting;
  return __libc_calloc(count, size);
}
void* realloc(void* block, size_t size) {
  allocations += isCounting;
  return __libc_realloc(block, size);
}
}

namespace {

struct Counting {
  Counting() { isCounting = true; }
  ~Counting() { isCounting = false; }
};

// ---- The sketch.

constexpr size_t kPlanItems = 60;

Line line;

alignas(16) uint8_t memory[sizeof(MissionClient)];
alignas(16) uint8_t followerMemory[sizeof(MissionFollower)];
uint64_t nowMs;        // since begin()
uint32_t firstMillis;  // what millis() was then
uint64_t updates;
uint64_t ended;
MissionItem plan[kPlanItems];
MissionItem sunk[kPlanItems];
uint16_t sunkCount;
MissionItem home;
FlightCommand command;
uint16_t reached;  // how many items the follower has told of

MissionClient& client() { return *reinterpret_cast<MissionClient*>(memory); }
MissionFollower& follower() { return *reinterpret_cast<MissionFollower*>(followerMemory); }

#ifdef CLIENT_BESIDE
struct Beside {
  explicit Beside(MissionClient& client)
      : position(client, 500),
        battery(client, 1000),
        waypoint(client, 1000),
        parameters(client),
        modes(client),
        steering(client) {}
  PositionListener position;
  BatteryListener battery;
  WaypointListener waypoint;
  Parameters parameters;
  StandardModes modes;
  Steering steering;
};
alignas(16) uint8_t besideMemory[sizeof(Beside)];
char name[17];
#endif

// The numbers that stand behind an order; what they are stands beside it.
constexpr size_t kNumbers = 3;
typedef unsigned long long Numbers[kNumbers];

ItemSource items(unsigned long long count) { return inRam(plan, static_cast<uint16_t>(count)); }

void onEnd(void*, Status) { ++ended; }
void onReached(void*, uint16_t) { ++reached; }

bool takeItem(void*, uint16_t index, const MissionItem& item) {
  if (index == kHomeIndex) {
    home = item;
    return true;
  }
  if (index >= kPlanItems) return false;
  sunk[index] = item;
  sunkCount = static_cast<uint16_t>(index + 1);
  return true;
}

// ---- What a line can be.

// The value of millis().
void begin(Words& words) {
  firstMillis = static_cast<uint32_t>(words.number());
  setMillis(firstMillis);
  nowMs = 0;
  memset(memory, 0xA5, sizeof(memory));
  {
    const Counting counting;
    new (memory) MissionClient(line.stream);
    new (followerMemory) MissionFollower(client());
#ifdef CLIENT_BESIDE
    new (besideMemory) Beside(client());
#endif
    client().onEnd(onEnd);
    follower().onReached(onReached);
  }
  puts("ok");
}

// A time, and bytes that come now: to that time, or until something has left or ended. The time, what has left, the
// end.
void run(Words& words) {
  const uint64_t until = words.number();
  if (!line.bring(words)) {
    puts("too many bytes at once");
    return;
  }
  int end = -1;
  {
    const Counting counting;
    while (nowMs < until && end < 0) {
      ++nowMs;
      setMillis(static_cast<uint32_t>(firstMillis + nowMs));
      ++updates;
      const Status status = client().update();
      if (isEnd(status)) end = static_cast<int>(status);
      if (line.hasLeft() && client().isSent()) break;
    }
  }
  printf("%llu ", static_cast<unsigned long long>(nowMs));
  line.sayWhatLeft();
  printf(" %d\n", end);
}

// Items, as they lie in memory, without what fills a MissionItem up.
void setPlan(Words& words) {
  const Bytes bytes = words.bytes();
  constexpr size_t kItem = kPlaceBytes + 5;
  for (size_t i = 0; i < bytes.size() / kItem && i < kPlanItems; ++i) {
    memcpy(static_cast<void*>(&plan[i]), bytes.data() + i * kItem, kItem);
  }
  puts("ok");
}

Status ordered(const std::string& what, const Numbers& numbers) {
  const PlanType type = static_cast<PlanType>(numbers[0]);
  const uint16_t first = static_cast<uint16_t>(numbers[0]), second = static_cast<uint16_t>(numbers[1]);
  // Type, items, Readback; items, first, count; type and items; type.
  if (what == "upload" && numbers[2] == 0) return client().uploadWithoutReadback(items(second), type);
  if (what == "upload") return client().upload(items(second), type, static_cast<Readback>(numbers[2]));
  if (what == "again") return client().uploadAgain();
  if (what == "part") return client().uploadPartial(items(first), second, static_cast<uint16_t>(numbers[2]));
  if (what == "verify") return client().verify(items(second), type);
  if (what == "ensure") return client().ensure(items(second), type);
  if (what == "download") return client().download(toFunction(takeItem, nullptr, kPlanItems), type);
  if (what == "clear") return client().clear(type);
  if (what == "start") return client().start();
  if (what == "arm") return client().arm();
  if (what == "disarm") return client().disarm();
  if (what == "mode") return client().setMode(static_cast<FlightMode>(first));
  if (what == "setcurrent") return client().setCurrentItem(first);
  if (what == "interval") return client().setMessageInterval(33, static_cast<int32_t>(numbers[0]));
  if (what == "order") {  // of a command of the sketch's own
    command = flightCommand(first);
    return client().send(command);
  }
  if (what == "cancel") client().cancel();
#ifdef CLIENT_BESIDE
  Beside& beside = *reinterpret_cast<Beside*>(besideMemory);
  const int32_t latitude = static_cast<int32_t>(numbers[0]),
                longitude = static_cast<int32_t>(numbers[1]);  // [1e-7 deg]
  const LatLon place = {Degrees::fromE7(latitude), Degrees::fromE7(longitude)};
  if (what == "intervalof") return client().setMessageInterval(first, static_cast<int32_t>(numbers[1]));  // message, us
  if (what == "param") return beside.parameters.read(name);
  if (what == "setparam") return beside.parameters.setWhole(name, static_cast<int32_t>(numbers[1]));
  if (what == "standard") return beside.modes.set(static_cast<StandardMode>(first));
  if (what == "entry") return beside.modes.read(static_cast<uint8_t>(first));
  if (what == "speed") return beside.steering.setSpeed(MetresPerSecond(static_cast<float>(first)));
  if (what == "hold") return beside.steering.pause();
  if (what == "goTo") return beside.steering.goTo(place, aboveHome(0.0_m));
#endif
  return Status::Idle;
}

// An order and its numbers, or the name of a parameter; the status that it begins with.
void order(Words& words) {
  const std::string what = words.word();
  Numbers numbers;
  for (size_t i = 0; i < kNumbers; ++i) {
    const std::string word = words.word();
    numbers[i] = strtoull(word.c_str(), nullptr, 10);
#ifdef CLIENT_BESIDE
    if (i == 0 && what.find("param") != std::string::npos) strncpy(name, word.c_str(), sizeof(name) - 1);
#endif
  }
  sunkCount = 0;
  Status status;
  {
    const Counting counting;
    status = ordered(what, numbers);
  }
  printf("%d\n", static_cast<int>(status));
}

void tellState(Words&) {
  const MissionClient& c = client();
  printf("status=%d busy=%d failed=%d done=%d total=%d mission=%d fence=%d rally=%d armed=%d found=%d reached=%d\n",
         static_cast<int>(c.status()), c.isBusy(), c.failedItem(), c.itemsDone(), c.itemsTotal(),
         static_cast<int>(c.aboard(PlanType::Mission)), static_cast<int>(c.aboard(PlanType::Fence)),
         static_cast<int>(c.aboard(PlanType::Rally)), c.isArmed(), c.hasAutopilot(), reached);
}

void tellCounters(Words&) {
  const LinkCounters counters = client().counters();
  printf("bytes=%lu skipped=%lu frames=%d unknown=%d bad=%d broken=%d lost=%d sent=%d\n",
         static_cast<unsigned long>(counters.bytes), static_cast<unsigned long>(counters.bytesSkipped), counters.frames,
         counters.unknownMessages, counters.badChecksums, counters.brokenFrames, counters.framesLost,
         counters.framesSent);
}

// How many update()s, ends and allocations there were.
void tellTally(Words&) {
  printf("updates=%llu ends=%llu allocations=%lu size=%zu\n", static_cast<unsigned long long>(updates),
         static_cast<unsigned long long>(ended), allocations, sizeof(MissionClient));
}

// The items that the last download gave.
void tellSunk(Words&) {
  say(reinterpret_cast<const uint8_t*>(sunk), sunkCount * sizeof(MissionItem));
  putchar('\n');
}

// The client's bytes, and the follower's, in Idle: those that something would still read, and that are no time, no
// counter and no buffer. What is left out has its own checks: times move nothing in Idle, counters are compared with
// what went over the line, and buffers are empty.
void tellIdle(Words&) {
  Bytes bytes(memory, memory + sizeof(memory));
  const MissionClient& c = client();
  const auto leftOut = [&](const void* what, size_t size) {
    const size_t at = static_cast<size_t>(static_cast<const uint8_t*>(what) - memory);
    std::fill(bytes.begin() + static_cast<long>(at), bytes.begin() + static_cast<long>(at + size), 0);
  };
#define LEFT_OUT(member) leftOut(&c.member, sizeof(c.member))
  LEFT_OUT(state_.secondMs);
  LEFT_OUT(state_.seconds);
  LEFT_OUT(state_.unsettledMs);
  LEFT_OUT(state_.tickMs);
  LEFT_OUT(known_.log);  // whose command may still be answered, and until when
  LEFT_OUT(reading_);    // one operation's state: there is none
  LEFT_OUT(commanding_);
  LEFT_OUT(link_.state_.emptyMs);
  LEFT_OUT(link_.state_.gap);
  LEFT_OUT(link_.state_.heardByteMs);
  LEFT_OUT(link_.state_.heartbeatMs);
  LEFT_OUT(link_.state_.bytes);
  LEFT_OUT(link_.state_.frames);
  LEFT_OUT(link_.state_.unknownMessages);
  LEFT_OUT(link_.state_.framesLost);
  LEFT_OUT(link_.state_.framesSent);
  LEFT_OUT(link_.state_.heardSequence);
  LEFT_OUT(link_.damage_);  // made of counters
  LEFT_OUT(link_.pace_.roundTripMs_);
  LEFT_OUT(link_.pace_.busyMs_);
  LEFT_OUT(link_.finder_.heardMs_);
  LEFT_OUT(link_.finder_.searchMs_);
  LEFT_OUT(link_.finder_.knowledge_);  // it counts the autopilots and their restarts
  LEFT_OUT(link_.parser_);
  LEFT_OUT(link_.outbox_);
#undef LEFT_OUT
  printf("busy=%d parser=%d outbox=%d ", c.isBusy(), c.link_.parser_.isIdle() ? 0 : 1,
         c.link_.outbox_.isEmpty() ? 0 : 1);
  say(bytes.data(), bytes.size());
  putchar('\n');
}

#ifdef CLIENT_OVER_UDP
void tellPeer(Words&) { line.sayPeer(); }
#endif

struct Word {
  const char* name;
  void (*act)(Words& words);
};

const Word words[] = {
    {"begin", begin},           {"run", run},         {"plan", setPlan},
    {"order", order},           {"state", tellState}, {"sunk", tellSunk},
    {"counters", tellCounters}, {"tally", tellTally}, {"idle", tellIdle},
#ifdef CLIENT_OVER_UDP
    {"peer", tellPeer},
#endif
};

}  // namespace

int main() {
  static char told[2 * kLine + 100];
  while (fgets(told, sizeof(told), stdin) != nullptr) {
    Words rest(told);
    const std::string name = rest.word();
    const Word* found =
        std::find_if(std::begin(words), std::end(words), [&](const Word& word) { return name == word.name; });
    if (found == std::end(words)) {
      puts("what?");
    } else {
      found->act(rest);
    }
    fflush(stdout);
  }
  return 0;
}
