// What the items of a fence, and rally points, make together, and that no way of an upload passes it by.
#include "mavmission/plan/Areas.h"

#include <doctest/doctest.h>
#include <string.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "ClientOnLine.h"
#include "Names.h"
#include "mavmission/files/PlanFiles.h"

using namespace mavmission;
using detail::Areas;

namespace {

typedef std::vector<MissionItem> Items;
const float kNaN = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

MissionItem corner(float corners, uint16_t command = kFencePolygonInclusion) {
  return anyCommandAt(command, -35_deg, 149_deg, aboveSeaLevel(0_m), corners);
}
MissionItem circle(float radius) { return corner(radius, kFenceCircleInclusion); }
MissionItem out(float corners) { return corner(corners, kFencePolygonExclusion); }
const MissionItem kReturn = fenceReturnPoint(-35_deg, 149_deg);

std::string told(Status status, size_t item, ItemField field) {
  return std::string(nameOf(status)) + " " + std::to_string(item) + " " + nameOf(field);
}

const struct Case {
  PlanType type;
  Items items;
  const char* told;  // "BadFence 1 Param1": of which item, and which field of it; or "Accepted"
} kCases[] = {
    {PlanType::Fence, {corner(3), corner(3), corner(3), out(3), out(3), out(3), circle(0.5f), kReturn}, "Accepted"},
    {PlanType::Fence, {corner(3), corner(3), corner(3), corner(3), corner(3), corner(3)}, "Accepted"},
    {PlanType::Fence, {corner(2), corner(2)}, "BadFence 0 Param1"},
    {PlanType::Fence, {circle(5), corner(256)}, "BadFence 1 Param1"},
    {PlanType::Fence, {circle(5), corner(3.5f)}, "BadFence 1 Param1"},
    {PlanType::Fence, {circle(5), corner(-3)}, "BadFence 1 Param1"},
    {PlanType::Fence, {circle(5), corner(3), corner(3)}, "BadFence 1 Param1"},
    {PlanType::Fence, {circle(5), corner(3), corner(3), circle(5)}, "BadFence 1 Param1"},
    {PlanType::Fence, {circle(5), corner(3), corner(3), out(3), corner(3)}, "BadFence 1 Param1"},
    {PlanType::Fence, {corner(3), corner(4), corner(4), corner(4)}, "BadFence 0 Param1"},
    {PlanType::Fence, {corner(3), corner(3), corner(3), corner(3)}, "BadFence 3 Param1"},
    {PlanType::Fence, {corner(3), kReturn, corner(3), corner(3)}, "BadFence 0 Param1"},
    {PlanType::Fence, {circle(5), kReturn, kReturn}, "BadFence 2 Command"},
    {PlanType::Fence, {circle(5), circle(0)}, "BadFence 1 Param1"},
    {PlanType::Fence, {circle(5), circle(-0.f)}, "BadFence 1 Param1"},
    {PlanType::Fence, {circle(5), circle(-1)}, "BadFence 1 Param1"},
    {PlanType::Fence, {circle(5), circle(kNaN)}, "BadFence 1 Param1"},
    {PlanType::Fence, {circle(5), circle(kInfinity)}, "BadFence 1 Param1"},
    {PlanType::Fence, {corner(120, 5005), circle(5)}, "NotFlown 0 Command"},
    {PlanType::Fence, {circle(5), waypoint(1_deg, 1_deg, 20_m)}, "NotFlown 1 Command"},
    {PlanType::Fence, {corner(3), rallyPoint(1_deg, 1_deg, 20_m)}, "NotFlown 1 Command"},
    {PlanType::Rally, {rallyPoint(1_deg, 0_deg, 20_m), rallyPoint(0_deg, 1_deg, 20_m)}, "Accepted"},
    {PlanType::Rally, {rallyPoint(1_deg, 1_deg, 20_m), rallyPoint(0_deg, 0_deg, 20_m)}, "NeedsCoordinates 1 Latitude"},
    {PlanType::Rally, {waypoint(1_deg, 1_deg, 20_m)}, "NotFlown 0 Command"},
    {PlanType::Rally, {circle(5)}, "NotFlown 0 Command"},
};

}  // namespace

TEST_CASE("a fence whose items make no areas is named by its item and field, and so is a rally point of no use") {
  for (const Case& given : kCases) {
    Areas areas;
    areas.begin(detail::keeperOf(Firmware::Px4, 2, given.type));
    std::string found = "Accepted";
    for (size_t index = 0; index < given.items.size() && found == "Accepted"; ++index) {
      const Areas::Verdict verdict = areas.take(given.items[index]);
      const size_t before = verdict.status == Status::BadFence ? areas.unfinished() : 0;
      if (verdict.status != Status::Accepted) found = told(verdict.status, index - before, verdict.field);
    }
    if (found == "Accepted" && areas.unfinished() != 0) {
      found = told(Status::BadFence, given.items.size() - areas.unfinished(), ItemField::Param1);
    }
    CAPTURE(&given - kCases);
    CHECK(found == given.told);
  }
}

TEST_CASE("a circle's radius on ArduPilot is no less than a millimetre above whole metres, and any other one on PX4") {
  const auto isTaken = [](uint32_t bits, Firmware firmware) {
    MissionItem item = circle(0);
    memcpy(&item.param1, &bits, sizeof(bits));
    Areas areas;
    areas.begin(detail::keeperOf(firmware, 2, PlanType::Fence));
    const Areas::Verdict verdict = areas.take(item);
    CHECK((verdict.status == Status::Accepted ||
           (verdict.status == Status::NotKept && verdict.field == ItemField::Param1)));
    return verdict.status == Status::Accepted;
  };
  CHECK(isTaken(0x3A83126F, Firmware::ArduPilot));  // 0.001
  CHECK_FALSE(isTaken(0x3A83126E, Firmware::ArduPilot));
  CHECK(isTaken(0x3A83126E, Firmware::Px4));
  for (int metres = 1; metres <= 65536; metres *= 2) {
    const float whole = static_cast<float>(metres);
    uint32_t bits;
    memcpy(&bits, &whole, sizeof(bits));
    unsigned wrong = 0;
    for (uint32_t steps = 0; steps < 8500; ++steps) {
      const double above = std::fmod(steps * static_cast<double>(metres) / (1 << 23), 1);
      if (isTaken(bits + steps, Firmware::ArduPilot) != (above == 0 || above > 0.001)) ++wrong;
    }
    CAPTURE(metres);
    CHECK(wrong == 0);
    CHECK(isTaken(bits + 0x400000, Firmware::ArduPilot));
  }
}

TEST_CASE("no upload of a fence or of rally points that make nothing sends its first byte, whichever way it is begun") {
  for (const Case& given : kCases) {
    if (given.told == std::string("Accepted")) continue;
    for (const uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4, ClientOnLine::kOther}) {
      ClientOnLine desk(autopilot);
      PlanFiles files(desk.client);
      const ItemSource plan = inRam(given.items.data(), static_cast<uint32_t>(given.items.size()));
      const std::function<void()> ways[] = {
          [&] { desk.client.upload(plan, given.type); },
          [&] { desk.client.uploadAgain(); },
          [&] { desk.client.uploadWithoutReadback(plan, given.type); },
          [&] { desk.client.ensure(plan, given.type); },
          [&] { files.upload(plan, given.type); },
          [&] { files.ensure(plan, given.type); },
      };
      for (const auto& way : ways) {
        desk.run(3000);
        desk.sent.clear();
        desk.ended = Status::Idle;
        way();
        desk.run(500);
        CAPTURE(&given - kCases);
        CAPTURE(&way - ways);
        // What one item shows is found before, and may be said more exactly.
        const bool isOneItem = desk.ended == Status::NotKept || desk.ended == Status::NotANumber ||
                               desk.ended == Status::NotFinite || desk.ended == Status::NotFlown;
        if (!isOneItem) CHECK(told(desk.ended, desk.client.failedItem(), desk.client.differingField()) == given.told);
        // Heartbeats; and PlanFiles closes at its first use what may have been left open.
        const bool isFirst = &way == ways;
        for (const SentFrame& frame : desk.sent) CHECK((frame.messageId == 0 || (isFirst && frame.messageId == 110)));
      }
    }
  }
}
