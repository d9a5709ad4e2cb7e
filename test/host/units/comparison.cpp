#include "mavmission/Comparison.h"

#include <doctest/doctest.h>
#include <stdlib.h>
#include <string.h>

#include <cmath>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using namespace mavmission;

namespace {

// An item that an autopilot accepted, and what it gave back.
struct Row {
  Firmware firmware;
  PlanType type;
  MissionItem sent, read;
};

struct Recording {
  const char* name;
  Firmware firmware;
};
const Recording kRecordings[] = {
    {"arducopter", Firmware::ArduPilot}, {"ardurover", Firmware::ArduPilot}, {"px4", Firmware::Px4}};

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::stringstream text(line);
  for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
  return cells;
}

// From the frame on: frame, (command,) param1 to param4, x, y, z.
MissionItem itemOf(const std::vector<std::string>& cells, size_t frame, size_t params, int command) {
  MissionItem item;
  memset(static_cast<void*>(&item), 0, sizeof(item));
  item.frame = static_cast<Frame>(atoi(cells[frame].c_str()));
  item.command = static_cast<uint16_t>(command);
  float* const numbers[] = {&item.param1, &item.param2, &item.param3, &item.param4};
  for (size_t i = 0; i < 4; ++i) *numbers[i] = strtof(cells[params + i].c_str(), nullptr);
  item.x = atoi(cells[params + 4].c_str());
  item.y = atoi(cells[params + 5].c_str());
  item.z = strtof(cells[params + 6].c_str(), nullptr);
  item.autocontinue = 1;
  return item;
}

// test_host.py says where they are.
std::vector<Row> recorded() {
  const char* folder = getenv("MAVMISSION_RECORDINGS");
  REQUIRE_MESSAGE(folder != nullptr, "set MAVMISSION_RECORDINGS, or run test_host.py, which does");
  std::vector<Row> rows;
  for (const Recording& recording : kRecordings) {
    std::ifstream file(std::string(folder) + "/readback_" + recording.name + ".csv");
    REQUIRE(file.good());
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
      const std::vector<std::string> cells = cellsOf(line);
      if (cells[10] != "ACCEPTED" || cells.size() < 21) continue;
      Row row;
      row.firmware = recording.firmware;
      row.type = cells[1] == "type 1" ? PlanType::Fence : cells[1] == "type 2" ? PlanType::Rally : PlanType::Mission;
      row.sent = itemOf(cells, 2, 3, atoi(cells[0].c_str()));
      row.read = itemOf(cells, 11, 13, atoi(cells[12].c_str()));
      row.read.current = static_cast<uint8_t>(atoi(cells[20].c_str()));
      row.read.autocontinue = static_cast<uint8_t>(atoi(cells[21].c_str()));
      // As it would go out; the library refuses a NaN that is no yaw.
      if (row.sent.command == 19 && std::isnan(row.sent.param4)) continue;
      if (row.firmware == Firmware::ArduPilot && std::isnan(row.sent.param4)) row.sent.param4 = 0;
      rows.push_back(row);
    }
  }
  return rows;
}

Field differing(const Row& row, const MissionItem& read) { return difference(row.sent, read, row.firmware, row.type); }

const Field kNumbers[] = {Field::Param1, Field::Param2, Field::Param3, Field::Param4, Field::Height};

float& numberOf(MissionItem& item, Field field) {
  switch (field) {
    case Field::Param1:
      return item.param1;
    case Field::Param2:
      return item.param2;
    case Field::Param3:
      return item.param3;
    case Field::Param4:
      return item.param4;
    default:
      return item.z;
  }
}

bool isNear(float one, float other, float by) { return one == other || std::fabs(one - other) < by; }

MissionItem survey() { return waypoint(-35.3632621_deg, 149.1652374_deg, 20_m); }

}  // namespace

TEST_CASE("what an autopilot was recorded to give back is the item that was sent") {
  const std::vector<Row> rows = recorded();
  CHECK(rows.size() > 250);
  for (const Row& row : rows) {
    CAPTURE(row.sent.command);
    CAPTURE(static_cast<int>(row.firmware));
    CHECK((differing(row, row.read) == Field::None));
  }
}

TEST_CASE("a number that is neither what was sent nor what is recorded to be made of it differs") {
  for (const Row& row : recorded()) {
    for (Field field : kNumbers) {
      MissionItem sent = row.sent;
      const float was = numberOf(sent, field);
      MissionItem read = row.read;
      const float kept = numberOf(read, field);
      for (float other : {0.f, 1.f, -1.f, 2.f, 250.f, std::trunc(was), was + 1, was - 1, was + 0.5f, was * 2, -was}) {
        if (std::isnan(other)) other = 3;
        const bool isHeight = field == Field::Height;
        if (isNear(other, was, isHeight ? 0.02f : 0) || isNear(other, kept, isHeight ? 0.02f : 0)) continue;
        numberOf(read, field) = other;
        CAPTURE(row.sent.command);
        CAPTURE(static_cast<int>(row.firmware));
        CAPTURE(static_cast<int>(field));
        CAPTURE(was);
        CAPTURE(other);
        CHECK((differing(row, read) == field));
      }
    }
    for (int32_t by : {1, -1, 256, 1000000}) {
      MissionItem read = row.read;
      read.x = row.sent.x + by;
      CHECK((differing(row, read) == Field::Latitude));
      read = row.read;
      read.y = row.sent.y + by;
      CHECK((differing(row, read) == Field::Longitude));
    }
  }
}

TEST_CASE("of several differences the first in the order of the message is told") {
  const MissionItem sent = survey();
  MissionItem read = sent;
  read.autocontinue = 0;
  CHECK((difference(sent, read, Firmware::Other, PlanType::Mission) == Field::Autocontinue));
  read.z = 7;
  CHECK((difference(sent, read, Firmware::Other, PlanType::Mission) == Field::Height));
  read.y = 7;
  CHECK((difference(sent, read, Firmware::Other, PlanType::Mission) == Field::Longitude));
  read.x = 7;
  CHECK((difference(sent, read, Firmware::Other, PlanType::Mission) == Field::Latitude));
  read.param1 = 7;
  CHECK((difference(sent, read, Firmware::Other, PlanType::Mission) == Field::Param1));
  read.frame = Frame::Global;
  CHECK((difference(sent, read, Firmware::Other, PlanType::Mission) == Field::Reference));
  read.command = 17;
  CHECK((difference(sent, read, Firmware::Other, PlanType::Mission) == Field::Command));
}
