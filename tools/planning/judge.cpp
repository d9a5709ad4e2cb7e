// Asks the library itself what it says of a plan: the checks that an upload begins with, what goes out, and whether one
// plan is what an autopilot makes of another. Made and spoken to by judge.py; a number a word on the standard input:
//
//   check type vehicle count ITEMS    -> for each firmware (ArduPilot, PX4, any other) and item: Status, its text;
//   behind
//                                        NotKept the field, what it is, and what would be kept
//   wire firmware vehicle count ITEMS -> for each item of a mission: Status, and what goes out, as an item is here
//   compare firmware type vehicle count ITEMS ITEMS -> for each item: ItemField, its text
//   text, behind it a .waypoints text as bytes -> "home" and an item, if it has one; of each item its line and the
//   item;
//                                        "end", PlanType, the number of the first item in the file. Or at the end
//                                        "bad", TextError, line, field
//   commands                          -> each command that the library knows: its number, 1 if its items have neither a
//                                        place nor an altitude, 2 if its altitude is not flown, else 0
//
// An item is param1 to param4, x, y, z as 32 bits each, command, frame, current, autocontinue. A vehicle is a MAV_TYPE.
#include <stdio.h>
#include <string.h>

#include <string>
#include <vector>

#include "mavmission/autopilot/Rules.h"
#include "mavmission/base/Status.h"
#include "mavmission/plan/Areas.h"
#include "mavmission/plan/Comparison.h"
#include "mavmission/plan/ItemSource.h"
#include "mavmission/plan/WirePlan.h"
#include "read_text.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

bool broken = false;

unsigned long number() {
  unsigned long value = 0;
  if (scanf("%lu", &value) != 1) broken = true;
  return value;
}

MissionItem item() {
  MissionItem made;
  memset(static_cast<void*>(&made), 0, sizeof(made));
  uint32_t words[7];
  for (uint32_t& word : words) word = static_cast<uint32_t>(number());
  static_assert(sizeof(words) == kPlaceBytes, "param1 to z");
  memcpy(static_cast<void*>(&made), words, sizeof(words));
  made.command = static_cast<uint16_t>(number());
  made.frame = static_cast<CoordinateFrame>(number());
  made.current = static_cast<uint8_t>(number());
  made.autocontinue = static_cast<uint8_t>(number());
  return made;
}

std::vector<MissionItem> items(unsigned long count) {
  std::vector<MissionItem> made;
  for (unsigned long i = 0; i < count && !broken; ++i) made.push_back(item());
  return made;
}

// A plan as an autopilot is to get it.
class Wired {
 public:
  Wired(const std::vector<MissionItem>& plan, Firmware firmware, uint8_t vehicle, PlanType type) {
    memset(static_cast<void*>(&wire_), 0, sizeof(wire_));
    wire_.setSource(inRam(plan.data(), static_cast<uint32_t>(plan.size())));
    wire_.begin(firmware, vehicle, type, false);
  }
  bool isTooLong() const { return wire_.isTooLong(); }
  Status read(size_t index, MissionItem& out) {
    Status status = Status::Checking;
    while (status == Status::Checking) {
      status = wire_.read(wire_.numbers().toWire(static_cast<uint16_t>(index)), out);
      MissionItem followed = out;
      if (status == Status::Accepted) status = wire_.follow(followed);
    }
    return status;
  }

 private:
  WirePlan wire_;
};

// What of an item would not be kept: the field, what it is, what would be there.
void putNotKept(const MissionItem& item, ItemField field, Keeper keeper) {
  const uint8_t index = static_cast<uint8_t>(static_cast<uint8_t>(field) - static_cast<uint8_t>(ItemField::Param1));
  float value = 0;
  if (field == ItemField::Latitude || field == ItemField::Longitude) {
    value = static_cast<float>(field == ItemField::Latitude ? item.x : item.y);
  } else if (index < 7) {
    memcpy(&value, reinterpret_cast<const uint8_t*>(&item) + 4 * index, sizeof(value));
  }
  const float kept = keptValue(item, field, keeper);
  printf(": %s, %.9g", toString(field), static_cast<double>(value));
  if (kept == kept) printf(" -> %.9g", static_cast<double>(kept));
}

// The item of a fence or of rally points that is refused by Areas, and why; Accepted: none is.
Areas::Verdict areaTrouble(const std::vector<MissionItem>& plan, Keeper keeper, size_t& index) {
  Areas::Verdict verdict = {Status::Accepted, ItemField::None};
  if ((keeper & (kOfFence | kOfRally)) == 0) return verdict;
  Areas areas;
  areas.begin(keeper);
  for (index = 0; index < plan.size(); ++index) {
    verdict = areas.take(plan[index]);
    if (verdict.status != Status::Accepted) break;
  }
  if (verdict.status == Status::Accepted && areas.unfinished() != 0) verdict.status = Status::BadFence;
  if (verdict.status == Status::BadFence) index -= areas.unfinished();
  return verdict;
}

void check() {
  const PlanType type = static_cast<PlanType>(number());
  const uint8_t vehicle = static_cast<uint8_t>(number());
  const std::vector<MissionItem> plan = items(number());
  const Firmware all[] = {Firmware::ArduPilot, Firmware::Px4, Firmware::Other};
  for (const Firmware firmware : all) {
    Wired wired(plan, firmware, vehicle, type);
    const Keeper keeper = keeperOf(firmware, vehicle, type);
    size_t refused = 0;
    const Areas::Verdict trouble = areaTrouble(plan, keeper, refused);
    for (size_t i = 0; i < plan.size(); ++i) {
      MissionItem out;
      Status status = wired.isTooLong() ? Status::TooManyItems : wired.read(i, out);
      ItemField field = status == Status::Accepted ? notKept(out, keeper) : ItemField::None;
      if (field != ItemField::None) status = Status::NotKept;
      if (trouble.status != Status::Accepted && i == refused) {
        status = trouble.status;
        field = trouble.field;
      }
      printf("%u %s", static_cast<unsigned>(status), toString(status));
      if (status == Status::NotKept) putNotKept(out, field, keeper);
      printf("\n");
    }
  }
}

void put(const MissionItem& item) {
  uint32_t words[7];
  memcpy(words, &item, sizeof(words));
  for (uint32_t word : words) printf("%lu ", static_cast<unsigned long>(word));
  printf("%u %u %u %u\n", item.command, static_cast<unsigned>(item.frame), item.current, item.autocontinue);
}

void wire() {
  const Firmware firmware = static_cast<Firmware>(number());
  const uint8_t vehicle = static_cast<uint8_t>(number());
  const std::vector<MissionItem> plan = items(number());
  Wired wired(plan, firmware, vehicle, PlanType::Mission);
  for (size_t i = 0; i < plan.size() && !broken; ++i) {
    MissionItem out = plan[i];
    printf("%u ", static_cast<unsigned>(wired.read(i, out)));
    put(out);
  }
}

void compare() {
  const Firmware firmware = static_cast<Firmware>(number());
  const PlanType type = static_cast<PlanType>(number());
  const uint8_t vehicle = static_cast<uint8_t>(number());
  const unsigned long count = number();
  const std::vector<MissionItem> meant = items(count);
  const std::vector<MissionItem> aboard = items(count);
  Wired sent(meant, firmware, vehicle, type);
  Wired read(aboard, firmware, vehicle, type);
  const Keeper keeper = keeperOf(firmware, vehicle, type);
  for (size_t i = 0; i < count && !broken; ++i) {
    MissionItem one, other;
    const bool fits = sent.read(i, one) == Status::Accepted && read.read(i, other) == Status::Accepted;
    const ItemField field = fits ? difference(one, other, keeper) : ItemField::Count;
    printf("%u %s\n", static_cast<unsigned>(field), toString(field));
  }
}

void text() {
  TextReading reading;
  for (;;) {
    const TextReading::Event event = reading.take(getchar());
    if (event == TextReading::kItem) printf("%u ", reading.itemLine());
    if (event == TextReading::kHome) printf("home ");
    if (event == TextReading::kItem || event == TextReading::kHome) put(reading.text().item());
    if (event == TextReading::kBad) {
      printf("bad %u %u %u\n", static_cast<unsigned>(reading.text().error()), reading.text().errorLine(),
             reading.text().errorField());
    }
    if (event == TextReading::kEnd) printf("end %u\n", static_cast<unsigned>(reading.text().type()));
    if (event == TextReading::kBad || event == TextReading::kEnd) return;
  }
}

void commands() {
  for (unsigned command = 0; command <= 0xFFFF; ++command) {
    MissionItem item = anyCommand(static_cast<uint16_t>(command));
    item.frame = CoordinateFrame::Global;
    // What is in no row has a place, or has none, as its frame says, on ArduPilot too.
    if (rulesOf(item, kByArduPilot).has(kAsItsFrameSays)) continue;
    const uint8_t traits = traitsOf(item.command);
    printf("%u %u\n", command,
           (traits & kHasNoPlace) != 0                            ? 1
           : (traits & (kPlaceIsOptional | kAsItsFrameSays)) != 0 ? 2
                                                                  : 0);
  }
}

}  // namespace

int main(int, char** arguments) {
  const std::string order = arguments[1] != nullptr ? arguments[1] : "";
  if (order == "check") check();
  if (order == "wire") wire();
  if (order == "compare") compare();
  if (order == "text") text();
  if (order == "commands") commands();
  return broken ? 1 : 0;
}
