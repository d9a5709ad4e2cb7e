// Asks the library itself what it says of a plan: the checks that an upload begins with, and whether one plan is what
// an autopilot makes of another. Made and spoken to by judge.py; a number a word on the standard input:
//
//   check type count ITEMS                 -> for each firmware (ArduPilot, PX4, any other) and item: Status, its text
//   compare firmware type count ITEMS ITEMS -> for each item: Field, its text
//
// An item is param1 to param4, x, y, z as 32 bits each, command, frame, current, autocontinue.
#include <stdio.h>
#include <string.h>

#include <string>
#include <vector>

#include "mavmission/Comparison.h"
#include "mavmission/ItemSource.h"
#include "mavmission/Status.h"
#include "mavmission/WirePlan.h"

using namespace mavmission;

namespace {

constexpr uint8_t kCopter = 2;  // MAV_TYPE_QUADROTOR

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
  made.frame = static_cast<Frame>(number());
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
  Wired(const std::vector<MissionItem>& plan, Firmware firmware, PlanType type) {
    memset(static_cast<void*>(&wire_), 0, sizeof(wire_));
    wire_.setSource(inRam(plan.data(), static_cast<uint32_t>(plan.size())));
    wire_.begin(firmware, kCopter, type, false);
  }
  bool isTooLong() const { return wire_.isTooLong(); }
  Status read(size_t index, MissionItem& out) {
    Status status = Status::Checking;
    while (status == Status::Checking) status = wire_.read(static_cast<uint16_t>(index + wire_.homeItems()), out);
    return status;
  }

 private:
  WirePlan wire_;
};

void check() {
  const PlanType type = static_cast<PlanType>(number());
  const std::vector<MissionItem> plan = items(number());
  const Firmware all[] = {Firmware::ArduPilot, Firmware::Px4, Firmware::Other};
  for (const Firmware firmware : all) {
    Wired wired(plan, firmware, type);
    for (size_t i = 0; i < plan.size(); ++i) {
      MissionItem out;
      Status status = wired.isTooLong() ? Status::TooManyItems : wired.read(i, out);
      if (status == Status::Accepted && notKept(out, keeperOf(firmware, kCopter, type)) != Field::None) status = Status::NotKept;
      printf("%u %s", static_cast<unsigned>(status), toString(status));
      if (status == Status::NotKept) {
        const Keeper keeper = keeperOf(firmware, kCopter, type);
        const Field field = notKept(out, keeper);
        const double kept = static_cast<double>(keptValue(out, field, keeper));
        printf(" of %s", toString(field));
        if (kept == kept) printf(": %.9g", kept);
      }
      putchar('\n');
    }
  }
}

void compare() {
  const Firmware firmware = static_cast<Firmware>(number());
  const PlanType type = static_cast<PlanType>(number());
  const unsigned long count = number();
  const std::vector<MissionItem> meant = items(count);
  const std::vector<MissionItem> aboard = items(count);
  Wired sent(meant, firmware, type);
  Wired read(aboard, firmware, type);
  for (size_t i = 0; i < count && !broken; ++i) {
    MissionItem one, other;
    const bool fits = sent.read(i, one) == Status::Accepted && read.read(i, other) == Status::Accepted;
    const Field field = fits ? difference(one, other, keeperOf(firmware, kCopter, type)) : Field::Count;
    printf("%u %s\n", static_cast<unsigned>(field), toString(field));
  }
}

}  // namespace

int main(int, char** arguments) {
  const std::string order = arguments[1] != nullptr ? arguments[1] : "";
  if (order == "check") check();
  if (order == "compare") compare();
  return broken ? 1 : 0;
}
