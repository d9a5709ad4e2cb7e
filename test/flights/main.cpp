// flights: a sketch flies, and others take the aircraft in between. See usage().
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <algorithm>
#include <functional>
#include <map>

#include "Arguments.h"
#include "Flight.h"

namespace {

constexpr unsigned kPlayed = 20;  // operations in a play
constexpr int32_t kMuteMs = 500;  // a stranger's heartbeats take the line this time, at most

struct Findings {
  unsigned long flights = 0, operations = 0, taken = 0, unseen = 0, violations = 0;
  uint32_t windowMs = 0, undoneMs = 0;
  int32_t longestMs = 0;
  std::vector<uint32_t> undone;  // how long each mode was undone that was set again [ms]
  std::map<std::string, unsigned long> ends;
  std::map<std::string, std::pair<unsigned long, FlightPlan>> rules;  // and the first flight that broke each
  FlightPlan broken, slowest;
  std::string rule;

  Flown note(const FlightPlan& plan) {
    const Flown flown = fly(plan, nullptr);
    ++flights;
    const Figures& figures = flown.figures;
    taken += figures.hasTaken;
    unseen += figures.isUnseen;
    windowMs = std::max(windowMs, figures.longestWindowMs);
    if (figures.longestUndoneMs > undoneMs) slowest = plan;
    undoneMs = std::max(undoneMs, figures.longestUndoneMs);
    undone.insert(undone.end(), figures.undoneMs.begin(), figures.undoneMs.end());
    longestMs = std::max(longestMs, flown.tookMs);
    ++ends[mavmission::toString(flown.status)];
    if (!flown.broken.empty()) breaks(plan, flown.broken);
    return flown;
  }

  void notePlay(const FlightPlan& plan) {
    std::vector<mavmission::Status> statuses;
    const Flown flown = play(plan, kPlayed, nullptr, statuses);
    ++flights;
    operations += statuses.size();
    for (mavmission::Status status : statuses) ++ends[mavmission::toString(status)];
    if (!flown.broken.empty()) breaks(plan, flown.broken);
  }

  void breaks(const FlightPlan& plan, const std::string& which) {
    if (rules[which].first++ == 0) rules[which].second = plan;
    if (violations++ != 0) return;
    broken = plan;
    rule = which;
  }
};

struct Kinds {
  What what;
  uint32_t amount;
};
constexpr Kinds kSingle[] = {
    {What::Pilot, 0},     {What::Holds, 0},     {What::Lands, 0},     {What::Disarms, 0},   {What::Failsafe, 0},
    {What::OtherPlan, 0}, {What::SamePlan, 0},  {What::Clears, 0},    {What::Cut, 700},     {What::Cut, 3000},
    {What::LoseUp, 1},    {What::LoseUp, 3},    {What::LoseDown, 1},  {What::LoseDown, 4},  {What::Stall, 300},
    {What::Stall, 2500},  {What::Stall, 65536}, {What::Silent, 3000}, {What::Silent, 7000}, {What::Stranger, 0},
};

// Returns the mode that this actor sets.
uint16_t modeSetBy(Kind kind, Task task, What what) {
  switch (what) {
    case What::Pilot: return modeOf(kind, Means::Pilot);
    case What::Lands: return modeOfLanding(kind, task);
    case What::Failsafe: return modeOf(kind, Means::Return);
    default: return modeOf(kind, Means::Hold);
  }
}

// Returns whether this actor can be told from the task's own order, and has something to do.
bool isOfUse(const FlightPlan& plan, What what) {
  const uint16_t wanted = modeWanted(plan.kind, plan.task);
  switch (what) {
    case What::Lands: return wanted != modeOfLanding(plan.kind, plan.task);
    case What::Holds: return isStart(plan.task) || plan.task == Task::TakeOff;
    case What::Failsafe: return wanted != modeOf(plan.kind, Means::Return);
    case What::OtherPlan:
    case What::SamePlan:
    case What::Clears: return isStart(plan.task);
    default: return true;
  }
}

bool canBe(Kind kind, Task task) { return kind != Kind::Rover || (task != Task::TakeOff && task != Task::LandNow); }

// Each of these is met with the others, in turn.
void vary(FlightPlan& plan, uint32_t number) {
  constexpr uint16_t kBuffers[] = {63, 255, 511};
  plan.buffer = kBuffers[number % 3];
  for (Act& act : plan.acts) {
    if (act.what == What::Stranger) {
      act.amount = number % kStrangerCount;
      const bool isAutopilot = kStrangers[act.amount].autopilot == 3 || kStrangers[act.amount].autopilot == 12;
      if (number / kStrangerCount % 2 != 0 && !isAutopilot) act.atMs = kAlways;
    }
    if (act.what == What::Silent) plan.second = static_cast<uint8_t>(1 + number % 6);
  }
}

void flyEach(FlightPlan plan, unsigned every, Findings& findings) {
  const std::vector<Act> always = plan.acts;
  const Flown clean = findings.note(plan);
  unsigned number = 0;
  for (const Kinds& kind : kSingle) {
    if (!isOfUse(plan, kind.what)) continue;
    for (int32_t moment : clean.moments) {
      for (int32_t later : {0, 1}) {
        if (number++ % every != 0) continue;
        plan.acts = always;
        plan.acts.push_back(Act{kind.what, moment + later, kind.amount, 0});
        vary(plan, number / every);
        const Flown flown = findings.note(plan);
        if (kind.what == What::Stranger && always.empty() && plan.loss <= 0 && flown.tookMs > clean.tookMs + kMuteMs) {
          findings.breaks(plan, "a stranger makes the sketch mute");
        }
      }
    }
  }
}

bool mayBeInOwnMode(Task task) { return task != Task::Resume && isInAir(task); }

// So many flights, from this seed on. `draw`: adds what happens in one of them.
template <typename Draw>
void flySeeds(FlightPlan plan, unsigned count, Findings& findings, Draw draw) {
  for (; count != 0; --count, ++plan.seed) {
    Random random(plan.seed);
    plan.isInOwnMode = mayBeInOwnMode(plan.task) && random.below(2) != 0;
    plan.acts.clear();
    draw(plan, random);
    findings.note(plan);
  }
}

void flyRandom(FlightPlan from, unsigned count, Findings& findings) {
  flySeeds(from, count, findings, [](FlightPlan& plan, Random& random) {
    for (uint32_t acts = 1 + random.below(3); acts != 0; --acts) {
      const Kinds& kind = kSingle[random.below(sizeof(kSingle) / sizeof(kSingle[0]))];
      // Most of them act about when the orders leave.
      const uint32_t spans[] = {250, 250, 250, 1500, 9000};
      const uint32_t span = spans[random.below(5)];
      const int32_t atMs = static_cast<int32_t>(random.below(span)) - (span < 1000 ? 20 : 600);
      if (isOfUse(plan, kind.what)) plan.acts.push_back(Act{kind.what, atMs, kind.amount, 0});
    }
    vary(plan, random.below(1000));
  });
}

constexpr What kWho[] = {What::Pilot, What::Lands, What::Holds, What::Failsafe, What::Disarms};

// How long the task takes when nothing happens.
uint32_t undisturbedMs(FlightPlan plan) {
  plan.loss = 0;
  return static_cast<uint32_t>(fly(plan, nullptr).tookMs);
}

// Somebody sets a mode while the task runs, once in each flight, until that has happened in so many flights.
void flyPilots(FlightPlan plan, unsigned count, Findings& findings) {
  constexpr unsigned kMostFlights = 20;  // flown for each that counts
  const uint32_t span = undisturbedMs(plan) * (plan.loss > 0 ? 3 : 1);
  const uint32_t first = plan.seed;
  const unsigned long unseenBefore = findings.unseen;
  unsigned taken = 0;
  for (unsigned i = 0; taken < count && i < kMostFlights * count; ++i) {
    plan.seed = first + i;
    Random random(plan.seed);
    const What who = kWho[random.below(4)];
    if (!isOfUse(plan, who)) continue;
    plan.isInOwnMode = mayBeInOwnMode(plan.task) && random.below(2) != 0;
    plan.acts.assign(1, Act{who, static_cast<int32_t>(random.below(span + 1)), 0, 0});
    const Flown flown = findings.note(plan);
    if (flown.figures.hasTaken && plan.acts.front().atMs <= flown.tookMs) ++taken;
  }
  printf("%s=%u %lu\n", kTaskNames[static_cast<int>(plan.task)], taken, findings.unseen - unseenBefore);
}

// Somebody sets a mode while an order is under way; in two flights of three one or two others follow within a second.
void flyOvertakes(FlightPlan from, unsigned count, Findings& findings) {
  flySeeds(from, count, findings, [](FlightPlan& plan, Random& random) {
    constexpr uint32_t kUnderWayMs = 14, kAgainMs = 1000;
    const unsigned order = 1 + random.below(4);
    uint32_t atMs = random.below(kUnderWayMs);
    for (uint32_t acts = 1 + random.below(3); acts != 0; --acts) {
      const What who = kWho[random.below(4)];
      // (A mode that is changed back to an earlier one cannot be told from ours that has set that one again.)
      const bool isNew = std::none_of(plan.acts.begin(), plan.acts.end(), [&](const Act& act) {
        return modeSetBy(plan.kind, plan.task, act.what) == modeSetBy(plan.kind, plan.task, who);
      });
      if (isOfUse(plan, who) && isNew) plan.acts.push_back(Act{who, static_cast<int32_t>(atMs), 0, order});
      atMs += random.below(kAgainMs);
    }
  });
}

// loop() stands still, before the task or within it, and somebody takes the aircraft a little sooner, or meanwhile.
void flyStandstills(FlightPlan from, unsigned count, Findings& findings) {
  const uint32_t span = undisturbedMs(from);
  flySeeds(from, count, findings, [span](FlightPlan& plan, Random& random) {
    const uint32_t longestMs = random.below(20) == 0 ? 0 : random.below(2) != 0 ? 10000 : 1000;
    const uint32_t stallMs = longestMs == 0 ? 65536 * (1 + random.below(2)) : 250 + random.below(longestMs);
    const int32_t atMs = random.below(2) != 0 ? -static_cast<int32_t>(1 + random.below(1000))
                                              : static_cast<int32_t>(random.below(span + 200));
    plan.acts.push_back(Act{What::Stall, atMs, stallMs, 0});
    const What who = kWho[random.below(5)];
    const int32_t tookMs = atMs - 300 + static_cast<int32_t>(random.below(300 + stallMs));
    if (isOfUse(plan, who)) plan.acts.push_back(Act{who, tookMs, 0, 0});
    vary(plan, random.below(1000));
  });
}

// A whole number of operations, which follow each other.
void flyPlays(FlightPlan plan, unsigned count, Findings& findings) {
  const uint32_t first = plan.seed;
  for (unsigned i = 0; i < count; ++i) {
    plan.seed = first + i;
    plan.second = static_cast<uint8_t>(1 + plan.seed % 6);
    plan.loss = plan.seed % 4 == 0 ? 0.005 : 0;
    vary(plan, plan.seed / 6);
    findings.notePlay(plan);
  }
}

Act actOf(const std::string& word) {
  const size_t at = word.find('@'), amount = word.find('=');
  if (at == std::string::npos) usage("an ACT without a moment");
  const int what = nameAmong(kWhatNames, word.substr(0, at), "there is no such ACT");
  const size_t plus = word.find('+');
  return Act{static_cast<What>(what), atoi(word.c_str() + (plus == std::string::npos ? at : plus) + 1),
             amount == std::string::npos ? 0 : static_cast<uint32_t>(atoi(word.c_str() + amount + 1)),
             plus == std::string::npos ? 0 : static_cast<unsigned>(atoi(word.c_str() + at + 1))};
}

int tell(const FlightPlan& plan, bool isPlay) {
  std::string log;
  std::vector<mavmission::Status> statuses;
  const Flown flown = isPlay ? play(plan, kPlayed, &log, statuses) : fly(plan, &log);
  printf("%sstatus=%s\nbroken=%s\n", log.c_str(), mavmission::toString(flown.status), flown.broken.c_str());
  return flown.broken.empty() ? 0 : 1;
}

// Returns the command that flies it again.
std::string wordsFor(const FlightPlan& plan, bool isPlay = false) {
  std::string words = std::string(kKinds[static_cast<int>(plan.kind)]) + " " + kTaskNames[static_cast<int>(plan.task)];
  words += isPlay ? " plays 1" : " one";
  for (const Act& act : plan.acts) words += " " + inWords(act);
  char options[100];
  snprintf(options, sizeof(options), " --seed %u --loss %g --own %d --buffer %d --second %d", plan.seed,
           plan.loss * 1000, plan.isInOwnMode, plan.buffer, plan.second);
  return words + options;
}

int report(const Findings& findings) {
  const bool isPlay = findings.operations != 0;
  printf(
      "flights=%lu\noperations=%lu\ntaken=%lu\nunseen=%lu\nviolations=%lu\nwindow_ms=%u\nundone_ms=%u\nlongest_ms=%d\n",
      findings.flights, findings.operations, findings.taken, findings.unseen, findings.violations, findings.windowMs,
      findings.undoneMs, findings.longestMs);
  const auto longerThan = [&](uint32_t ms) {
    return std::count_if(findings.undone.begin(), findings.undone.end(), [ms](uint32_t was) { return was > ms; });
  };
  if (findings.undoneMs != 0) printf("longest_undone=%s\n", wordsFor(findings.slowest).c_str());
  printf("set_again=%zu\n", findings.undone.size());
  for (uint32_t ms : {100u, 300u, 500u, 1000u, 1500u, 2000u}) printf("longer_%u=%ld\n", ms, longerThan(ms));
  for (const auto& end : findings.ends) printf("end=%lu %s\n", end.second, end.first.c_str());
  for (const auto& rule : findings.rules) {
    printf("rule=%lu %s (%s)\n", rule.second.first, rule.first.c_str(), wordsFor(rule.second.second, isPlay).c_str());
  }
  if (findings.violations == 0) return 0;
  printf("broken=%s\n%s\n", findings.rule.c_str(), wordsFor(findings.broken, isPlay).c_str());
  tell(findings.broken, isPlay);
  return 1;
}

}  // namespace

void usage(const char* problem) {
  fprintf(
      stderr,
      "%s\n"
      "usage: flights AUTOPILOT TASK each EVERY [OPTION VALUE]...    an actor at each moment of a clean flight\n"
      "       flights AUTOPILOT TASK random COUNT [OPTION VALUE]...  actors at random, from seed S on\n"
      "       flights AUTOPILOT TASK pilots COUNT [OPTION VALUE]...  one pilot or failsafe takes it, at a random "
      "moment\n"
      "                                                              of so many flights of each task\n"
      "       flights AUTOPILOT TASK overtakes COUNT [OPTION VALUE]...  the same while an order is under way, and "
      "up to\n"
      "                                                              two others a little later, in COUNT flights\n"
      "       flights AUTOPILOT TASK standstills COUNT [OPTION VALUE]...  somebody takes it while loop() stands still, "
      "before\n"
      "                                                              or within the task, in COUNT flights\n"
      "       flights AUTOPILOT all plays COUNT [OPTION VALUE]...  20 operations at random in each of COUNT flights, "
      "with\n"
      "                                                              all actors and a second vehicle\n"
      "       flights AUTOPILOT TASK one ACT@[ORDER+]MS[=AMOUNT]... [OPTION VALUE]...  one flight, told in words\n"
      "  AUTOPILOT  Copter, Rover or PX4\n"
      "  TASK       start, takeOff, goTo, pause, resume, returnHome, landNow, follow, arm, disarm, startMission,\n"
      "             setMode, verifyAndStart, all\n"
      "  ACT        pilot, lands, holds, disarms, failsafe, other-plan, same-plan, clears, cut, lose-up, "
      "lose-down, stall,\n"
      "             silent, stranger\n"
      "  MS         since the task began, or since its order number ORDER has left\n"
      "  --seed S   of the losses, and of when heartbeats come (1)\n"
      "  --loss P   per mille of the bytes that are lost (0)\n"
      "  --own 1    in the air: in the sketch's own mode at the beginning, not in its mission (0)\n"
      "  --buffer B  bytes that are received while loop() stands still (63)\n"
      "  --second N  the second vehicle: 1 Copter, 2 Rover, 3 PX4; 4, 5, 6: the same in the air (0: none)\n"
      "  --with ACT@MS[=AMOUNT]  each: beside the actor, in each flight\n"
      "Prints findings as name=value; then, if a rule was broken, the first such flight. Exits with 1 then.\n",
      problem);
  exit(2);
}

int main(int argc, char** argv) {
  if (argc < 4) usage("too few words");
  FlightPlan plan;
  plan.kind = static_cast<Kind>(nameAmong(kKinds, argv[1], "there is no such AUTOPILOT"));
  const std::string task = argv[2], how = argv[3];
  const std::map<std::string, std::function<void(const char*)>> options = {
      {"--seed", [&plan](const char* value) { plan.seed = static_cast<uint32_t>(atol(value)); }},
      {"--loss", [&plan](const char* value) { plan.loss = atof(value) / 1000; }},
      {"--own", [&plan](const char* value) { plan.isInOwnMode = atoi(value) != 0; }},
      {"--buffer", [&plan](const char* value) { plan.buffer = static_cast<uint16_t>(atoi(value)); }},
      {"--second", [&plan](const char* value) { plan.second = static_cast<uint8_t>(atoi(value)); }},
      {"--with", [&plan](const char* value) { plan.acts.push_back(actOf(value)); }}};
  unsigned count = 0;
  int word = 4;
  if (how != "one") count = word < argc ? static_cast<unsigned>(atoi(argv[word++])) : 0;
  for (; word < argc; ++word) {
    const std::string name = argv[word];
    if (name.compare(0, 2, "--") != 0) {
      plan.acts.push_back(actOf(name));
      continue;
    }
    if (++word == argc) usage("an option without a value");
    const auto option = options.find(name);
    if (option == options.end()) usage("there is no such option");
    option->second(argv[word]);
  }
  if (how == "one") {
    plan.task = static_cast<Task>(nameAmong(kTaskNames, task, "there is no such TASK"));
    return tell(plan, false);
  }
  const std::map<std::string, void (*)(FlightPlan, unsigned, Findings&)> ways = {
      {"each", flyEach},           {"random", flyRandom},           {"pilots", flyPilots},
      {"overtakes", flyOvertakes}, {"standstills", flyStandstills}, {"plays", flyPlays}};
  if (count == 0 || ways.count(how) == 0) usage("each, random, pilots, overtakes, standstills or plays, and a number");
  Findings findings;
  for (int i = 0; i < kFlights; ++i) {
    plan.task = static_cast<Task>(i);
    if ((task != "all" && task != kTaskNames[i]) || !canBe(plan.kind, plan.task)) continue;
    ways.at(how)(plan, count, findings);
    if (how == "plays") break;
  }
  if (findings.flights == 0) usage("there is no such TASK");
  return report(findings);
}
