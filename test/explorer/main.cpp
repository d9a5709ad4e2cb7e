// explorer: every way that an operation can go, one scenario a call. See usage().
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <map>
#include <string>

#include "Arguments.h"
#include "Exploration.h"
#include "Plans.h"

namespace {

int report(const Findings& findings, bool showsFewest) {
  printf("states=%llu\noperations=%llu\ntransitions=%llu\nviolations=%llu\nwhole=%d\nlongest_ms=%u\nfewest_faults=%d\n",
         static_cast<unsigned long long>(findings.states), static_cast<unsigned long long>(findings.operations),
         static_cast<unsigned long long>(findings.transitions), static_cast<unsigned long long>(findings.violations),
         findings.isWhole, findings.longestMs, findings.fewestFaults);
  for (const auto& end : findings.ends) {
    printf("end=%s=%llu\n", end.first.c_str(), static_cast<unsigned long long>(end.second));
  }
  if (showsFewest) printf("fewest:\n%s", findings.fewestFaultsTrace.c_str());
  if (findings.violations != 0) printf("broken=%s\n%s", findings.broken.c_str(), findings.trace.c_str());
  return findings.violations != 0 ? 1 : findings.isWhole ? 0 : 3;
}

}  // namespace

void usage(const char* problem) {
  fprintf(
      stderr,
      "%s\n"
      "usage: explorer AUTOPILOT OPERATION ITEMS [OPERATION ITEMS [OPERATION ITEMS]] [option VALUE]...\n"
      "       explorer AUTOPILOT walks COUNT [--seed S]  one way at random of each of COUNT scenarios\n"
      "       explorer AUTOPILOT typed COUNT [--seed S]  COUNT consoles that are typed at, two minutes each\n"
      "  AUTOPILOT  ArduPilot, LateArduPilot (its final ACK comes 700 ms late), PX4, MAVSDK, Betaflight,\n"
      "             iNav\n"
      "  OPERATION  upload, upload-in-doubt, upload-verified, ensure, download, verify, clear, and as files\n"
      "             file-upload, file-verify; the next one begins when one has ended or was broken off\n"
      "             upload, upload-in-doubt, ... with \"fence-\" or \"rally-\" in front: of those; one of both\n"
      "  ITEMS      0 to 7: of the plan that is uploaded or verified; of a fence 4 or more\n"
      "  --held N       items aboard at the beginning, of the kind of the first operation, 0 to 7 (2)\n"
      "  --held-beside N  items aboard of the other kind of plan, 0 to 7 (0)\n"
      "  --held-plan N  which: 0, another plan; 1, that of the first operation (0)\n"
      "  --losses N     frames lost; `any` for any number (any)\n"
      "  --faults N     frames repeated, delayed, damaged or cut (0)\n"
      "  --copies N     frames that come once more, 30, 120 or 300 ms later (0)\n"
      "  --reboots N    reboots of the autopilot, at any point (0)\n"
      "  --cancels N    the sketch cancels what runs, at any point (0)\n"
      "  --resets N     the Arduino is reset in the first operation, at any point, and begins the next one (0)\n"
      "  --others N     requests of another client to the server of files, at any point (0)\n"
      "  --refused N    the item on the wire that ArduPilot does not take; 0: it takes all (0)\n"
      "  --latency N    ms that each frame takes longer, each way, 0 to 500 (0)\n"
      "  --lossy N      1: the client takes the line for one that loses, from the beginning; 0: from when it sees it\n"
      "                 by a repeated request or a damaged frame (0)\n"
      "  --most-states N  give up beyond (200000000)\n"
      "  --show-fewest N  1: show how the fewest faults end without success (0)\n"
      "Prints findings as name=value; then, if a rule was broken, the shortest way to it. Exits with 1 then, with\n"
      "3 when it gave up.\n",
      problem);
  exit(2);
}

int main(int argc, char** argv) {
  if (argc < 4) usage("arguments are missing");
  Scenario scenario;
  scenario.firmware = static_cast<Firmwares>(nameAmong(kFirmwares, argv[1], "no such autopilot"));
  const bool isTyped = strcmp(argv[2], "typed") == 0;
  if (isTyped || strcmp(argv[2], "walks") == 0) {
    const bool isSeeded = argc == 6 && strcmp(argv[4], "--seed") == 0;
    if (argc != 4 && !isSeeded) usage("how many, and nothing else but --seed");
    const uint32_t seed = isSeeded ? static_cast<uint32_t>(number(argv[5], 4000000000u)) : 1;
    return report((isTyped ? type : walk)(scenario.firmware, seed, static_cast<unsigned>(number(argv[3], 10000000))),
                  false);
  }
  int at = 2;
  for (; at + 1 < argc && argv[at][0] != '-'; at += 2) {
    Task task;
    const char* name = argv[at];
    task.type = strncmp(name, "fence-", 6) == 0 ? kFence : strncmp(name, "rally-", 6) == 0 ? kRally : kMission;
    if (task.type != kMission) name += 6;
    task.operation = static_cast<Operation>(nameAmong(kOperations, name, "no such operation"));
    if (task.type != kMission && isByFiles(task.operation)) usage("only a mission goes by file here");
    task.items = static_cast<uint8_t>(number(argv[at + 1], kMostItems));
    task.plan = static_cast<uint8_t>(scenario.tasks.size() + 1);
    scenario.tasks.push_back(task);
  }
  if (scenario.tasks.empty() || scenario.tasks.size() > 3) usage("one to three operations");
  uint64_t mostStates = 200000000;
  bool showsFewest = false;
  struct Option {
    uint8_t* value;
    uint8_t most;
  };
  const std::map<std::string, Option> options = {
      {"--held", {&scenario.heldItems, kMostItems}}, {"--held-beside", {&scenario.heldBeside, kMostItems}},
      {"--held-plan", {&scenario.heldPlan, 1}},      {"--losses", {&scenario.losses, 254}},
      {"--faults", {&scenario.faults, 254}},         {"--copies", {&scenario.copies, 254}},
      {"--reboots", {&scenario.reboots, 254}},       {"--cancels", {&scenario.cancels, 254}},
      {"--resets", {&scenario.resets, 254}},         {"--others", {&scenario.others, 254}},
      {"--refused", {&scenario.refused, kMostItems}}};
  for (; at < argc; at += 2) {
    if (at + 1 == argc) usage("a value is missing");
    const std::string option = argv[at];
    const char* const value = argv[at + 1];
    const auto known = options.find(option);
    if (option == "--losses" && strcmp(value, "any") == 0) {
      scenario.losses = Scenario::kAnyNumber;
    } else if (known != options.end()) {
      *known->second.value = static_cast<uint8_t>(number(value, known->second.most));
    } else if (option == "--latency") {
      scenario.latencyMs = static_cast<uint16_t>(number(value, 500));
    } else if (option == "--lossy") {
      scenario.isLossy = number(value, 1) != 0;
    } else if (option == "--most-states") {
      mostStates = number(value, 4000000000u);
    } else if (option == "--show-fewest") {
      showsFewest = number(value, 1) != 0;
    } else {
      usage("no such option");
    }
  }
  return report(explore(scenario, mostStates), showsFewest);
}
