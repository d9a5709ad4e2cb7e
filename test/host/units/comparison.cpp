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
  bool isYawOpen;  // it was recorded with NaN
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
      row.isYawOpen = std::isnan(row.sent.param4);
      if (row.firmware == Firmware::ArduPilot && row.isYawOpen) row.sent.param4 = 0;
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

TEST_CASE("a parameter of a command that was never seen to be rewritten is kept as it is") {
  const std::vector<Row> rows = recorded();
  for (const Row& row : rows) {
    if (row.type != PlanType::Mission) continue;
    for (Field field : {Field::Param1, Field::Param2, Field::Param3, Field::Param4}) {
      // These were recorded with 0 and whole numbers alone; the next cases are about them.
      const bool isVtol = row.sent.command == 84 || row.sent.command == 85;
      if (row.firmware == Firmware::ArduPilot && field == Field::Param4 && isVtol) continue;
      if (row.firmware == Firmware::ArduPilot && field == Field::Param1 && row.sent.command == 19) continue;
      bool isRewritten = false;
      for (Row other : rows) {
        if (other.firmware != row.firmware || other.sent.command != row.sent.command) continue;
        const float was = numberOf(other.sent, field), is = numberOf(other.read, field);
        isRewritten = isRewritten || (was != is && !(std::isnan(was) && std::isnan(is)));
        isRewritten = isRewritten || (field == Field::Param4 && other.isYawOpen);
      }
      if (isRewritten) continue;
      Row changed = row;
      numberOf(changed.sent, field) = 77.5f;
      for (float other : {0.f, 77.f, 1.f, -1.f, 78.f}) {
        numberOf(changed.read, field) = other;
        CAPTURE(row.sent.command);
        CAPTURE(static_cast<int>(row.firmware));
        CAPTURE(static_cast<int>(field));
        CAPTURE(other);
        CHECK((differing(changed, changed.read) == field));
      }
    }
  }
}

TEST_CASE("ArduPilot keeps whole seconds of a hold and of a loiter time") {
  for (uint16_t command : {uint16_t(16), uint16_t(19)}) {
    MissionItem sent = survey();
    sent.command = command;
    sent.param3 = command == 19 ? 1.f : 0.f;
    sent.param4 = 0;
    sent.param1 = 7.75f;
    MissionItem read = sent;
    for (float seconds : {7.75f, 7.f}) {
      read.param1 = seconds;
      CHECK((difference(sent, read, Firmware::ArduPilot, PlanType::Mission) == Field::None));
    }
    for (float seconds : {0.f, 6.f, 8.f, 1.f}) {
      read.param1 = seconds;
      CHECK((difference(sent, read, Firmware::ArduPilot, PlanType::Mission) == Field::Param1));
    }
  }
}

TEST_CASE("ArduPilot drops the yaw of a VTOL takeoff and landing, and keeps the rest") {
  for (uint16_t command : {uint16_t(84), uint16_t(85)}) {
    for (Field field : {Field::Param1, Field::Param2, Field::Param3, Field::Param4}) {
      MissionItem sent = survey();
      sent.command = command;
      sent.param4 = 0;
      MissionItem read = sent;
      numberOf(sent, field) = 45;
      const Field expected = field == Field::Param4 ? Field::None : field;
      CHECK((difference(sent, read, Firmware::ArduPilot, PlanType::Mission) == expected));
      CHECK((difference(sent, read, Firmware::Px4, PlanType::Mission) == field));
    }
  }
}

TEST_CASE("fence and rally items keep their parameters, and so does an autopilot that is neither") {
  MissionItem sent = survey(), read = sent;
  sent.param2 = 3;  // which ArduPilot drops, of a waypoint of the mission
  read.param2 = 0;
  CHECK((difference(sent, read, Firmware::ArduPilot, PlanType::Mission) == Field::None));
  CHECK((difference(sent, read, Firmware::ArduPilot, PlanType::Fence) == Field::Param2));
  CHECK((difference(sent, read, Firmware::ArduPilot, PlanType::Rally) == Field::Param2));
  CHECK((difference(sent, read, Firmware::Other, PlanType::Mission) == Field::Param2));
}

TEST_CASE("coordinates are compared as the integers that they are") {
  const MissionItem sent = survey();
  for (Firmware firmware : {Firmware::ArduPilot, Firmware::Px4, Firmware::Other}) {
    MissionItem zero = sent, lowest = sent;
    zero.x = 0;
    lowest.x = std::numeric_limits<int32_t>::min();  // as a float it would be -0
    CHECK((difference(zero, lowest, firmware, PlanType::Mission) == Field::Latitude));
    zero.x = lowest.x = sent.x;
    zero.y = 0;
    lowest.y = std::numeric_limits<int32_t>::min();
    CHECK((difference(zero, lowest, firmware, PlanType::Mission) == Field::Longitude));
  }
}

TEST_CASE("autocontinue may be 1 in a mission from ArduPilot, is of no account in a fence, and is kept elsewhere") {
  for (Firmware firmware : {Firmware::ArduPilot, Firmware::Px4, Firmware::Other}) {
    for (PlanType type : {PlanType::Mission, PlanType::Fence, PlanType::Rally}) {
      for (uint8_t was : {0, 1}) {
        for (uint8_t is : {0, 1, 2}) {
          MissionItem sent = survey(), read = sent;
          sent.autocontinue = was;
          read.autocontinue = is;
          const bool isRight = type != PlanType::Mission || is == was || (firmware == Firmware::ArduPilot && is == 1);
          CHECK((difference(sent, read, firmware, type) == (isRight ? Field::None : Field::Autocontinue)));
        }
      }
    }
  }
}

TEST_CASE("a frame may come back by its other number, or as Global from ArduPilot where there is no height") {
  const Frame frames[] = {Frame::Global,           Frame::Mission,       Frame::GlobalRelative,  Frame::GlobalInt,
                          Frame::GlobalRelativeInt, Frame::GlobalTerrain, Frame::GlobalTerrainInt};
  const auto number = [](Frame frame) {
    return frame == Frame::GlobalInt ? Frame::Global
           : frame == Frame::GlobalRelativeInt ? Frame::GlobalRelative
           : frame == Frame::GlobalTerrainInt  ? Frame::GlobalTerrain
                                               : frame;
  };
  for (Firmware firmware : {Firmware::ArduPilot, Firmware::Px4, Firmware::Other}) {
    for (PlanType type : {PlanType::Mission, PlanType::Fence, PlanType::Rally}) {
      for (uint16_t command : {uint16_t(16), uint16_t(178)}) {  // with a place, and without
        for (Frame was : frames) {
          for (Frame is : frames) {
            MissionItem sent = survey(), read;
            sent.command = command;
            sent.frame = was;
            sent.param4 = 0;
            read = sent;
            read.frame = is;
            const bool hasNoHeight = type == PlanType::Fence || was == Frame::Mission || command == 178;
            const bool isRight =
                number(was) == number(is) || (firmware == Firmware::ArduPilot && is == Frame::Global && hasNoHeight);
            CAPTURE(static_cast<int>(was));
            CAPTURE(static_cast<int>(is));
            CHECK((difference(sent, read, firmware, type) == (isRight ? Field::None : Field::Reference)));
          }
        }
      }
    }
  }
}

TEST_CASE("ArduPilot keeps no height of a fence and whole metres of rally points; PX4 keeps both") {
  MissionItem sent = survey();
  sent.z = 30.5f;
  for (float height : {0.f, 30.f, 30.5f, 31.f, 1.f}) {
    MissionItem read = sent;
    read.z = height;
    const bool isSame = height == 30.5f;
    const auto expected = [](bool isRight) { return isRight ? Field::None : Field::Height; };
    CAPTURE(height);
    CHECK((difference(sent, read, Firmware::ArduPilot, PlanType::Fence) == expected(isSame || height == 0)));
    CHECK((difference(sent, read, Firmware::ArduPilot, PlanType::Rally) == expected(isSame || height == 30)));
    for (PlanType type : {PlanType::Fence, PlanType::Rally}) {
      CHECK((difference(sent, read, Firmware::Px4, type) == expected(isSame)));
    }
  }
}

TEST_CASE("PX4 keeps what it was not recorded to rewrite: the parameters of turns") {
  for (Field field : {Field::Param1, Field::Param2, Field::Param3, Field::Param4}) {
    MissionItem sent = survey();
    sent.command = 18;
    sent.param4 = 0;
    MissionItem read = sent;
    numberOf(sent, field) = 77.5f;
    CHECK((difference(sent, read, Firmware::Px4, PlanType::Mission) == field));
  }
}
