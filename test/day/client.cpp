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

// True if the word was one of these.
bool orderBeside(const std::string& what, Words& words, Status& status) {
  Beside& beside = *reinterpret_cast<Beside*>(besideMemory);
  if (what == "intervalof") {  // message, us
    const uint16_t message = static_cast<uint16_t>(words.number());
    status = client().setMessageInterval(message, static_cast<int32_t>(words.number()));
  } else if (what == "param") {  // name
    strncpy(name, words.word().c_str(), sizeof(name) - 1);
    status = beside.parameters.read(name);
  } else if (what == "setparam") {  // name, number
    strncpy(name, words.word().c_str(), sizeof(name) - 1);
    status = beside.parameters.setWhole(name, static_cast<int32_t>(words.number()));
  } else if (what == "standard") {
    status = beside.modes.set(static_cast<StandardMode>(words.number()));
  } else if (what == "entry") {
    status = beside.modes.read(static_cast<uint8_t>(words.number()));
  } else if (what == "speed") {
    status = beside.steering.setSpeed(MetresPerSecond(static_cast<float>(words.number())));
  } else if (what == "hold") {
    status = beside.steering.pause();
  } else if (what == "goTo") {  // 1e-7 degrees
    const int32_t latitude = static_cast<int32_t>(words.number());
    const int32_t longitude = static_cast<int32_t>(words.number());
    const LatLon place = {Degrees::fromE7(latitude), Degrees::fromE7(longitude)};
    status = beside.steering.goTo(place, aboveHome(0.0_m));
  } else {
    return false;
  }
  return true;
}
#endif

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

PlanType typeOf(Words& words) { return static_cast<PlanType>(words.number()); }

// An order and its numbers; the status that it begins with.
void order(Words& words) {
  const std::string what = words.word();
  Status status = Status::Idle;
  sunkCount = 0;
  {
    if (what == "upload") {  // type, items, Readback
      const PlanType type = typeOf(words);
      const ItemSource source = inRam(plan, static_cast<uint16_t>(words.number()));
      const unsigned proof = static_cast<unsigned>(words.number());
      const Counting counting;
      status = proof == 0 ? client().uploadWithoutReadback(source, type)
                          : client().upload(source, type, static_cast<Readback>(proof));
    } else if (what == "again") {
      const Counting counting;
      status = client().uploadAgain();
    } else if (what == "part") {  // items, first, count
      const ItemSource source = inRam(plan, static_cast<uint16_t>(words.number()));
      const uint16_t first = static_cast<uint16_t>(words.number());
      const uint16_t count = static_cast<uint16_t>(words.number());
      const Counting counting;
      status = client().uploadPartial(source, first, count);
    } else if (what == "verify") {  // type, items
      const PlanType type = typeOf(words);
      const ItemSource source = inRam(plan, static_cast<uint16_t>(words.number()));
      const Counting counting;
      status = client().verify(source, type);
    } else if (what == "ensure") {  // type, items
      const PlanType type = typeOf(words);
      const ItemSource source = inRam(plan, static_cast<uint16_t>(words.number()));
      const Counting counting;
      status = client().ensure(source, type);
    } else if (what == "download") {  // type
      const PlanType type = typeOf(words);
      const Counting counting;
      status = client().download(toFunction(takeItem, nullptr, kPlanItems), type);
#ifdef CLIENT_BESIDE
    } else if (orderBeside(what, words, status)) {
#endif
    } else {
      const unsigned long long number = words.number();
      const Counting counting;
      if (what == "clear") status = client().clear(static_cast<PlanType>(number));
      if (what == "start") status = client().start();
      if (what == "arm") status = client().arm();
      if (what == "disarm") status = client().disarm();
      if (what == "mode") status = client().setMode(static_cast<FlightMode>(number));
      if (what == "setcurrent") status = client().setCurrentItem(static_cast<uint16_t>(number));
      if (what == "interval") status = client().setMessageInterval(33, static_cast<int32_t>(number));
      if (what == "order") {  // of a command of the sketch's own
        command = flightCommand(static_cast<uint16_t>(number));
        status = client().send(command);
      }
      if (what == "cancel") client().cancel();
    }
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
