#include "RecordedItems.h"

#include <stdlib.h>
#include <string.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>

using namespace mavmission;
using namespace mavmission::detail;

namespace {

struct Vehicle {
  const char* name;
  Firmware firmware;
  uint8_t type;  // HEARTBEAT.type
};
const Vehicle kVehicles[] = {{"arducopter", Firmware::ArduPilot, 2},
                             {"ardurover", Firmware::ArduPilot, 10},
                             {"arduplane", Firmware::ArduPilot, 1},
                             {"px4", Firmware::Px4, 2}};

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::stringstream text(line);
  for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
  cells.resize(22);
  return cells;
}

int integer(const std::string& cell) { return atoi(cell.c_str()); }

// param1 to param4, x, y, z, from a column on.
MissionItem itemOf(const std::vector<std::string>& cells, size_t column, int frame, int command) {
  MissionItem item = anyCommand(static_cast<uint16_t>(command));
  item.frame = static_cast<CoordinateFrame>(frame);
  float* const numbers[] = {&item.param1, &item.param2, &item.param3, &item.param4};
  for (size_t i = 0; i < 4; ++i) *numbers[i] = strtof(cells[column + i].c_str(), nullptr);
  item.x = integer(cells[column + 4]);
  item.y = integer(cells[column + 5]);
  item.z = strtof(cells[column + 6].c_str(), nullptr);
  return item;
}

RecordedItem rowOf(const std::vector<std::string>& cells, const Vehicle& vehicle, unsigned line) {
  const PlanType type = cells[1] == "type 1"   ? PlanType::Fence
                        : cells[1] == "type 2" ? PlanType::Rally
                                               : PlanType::Mission;
  RecordedItem row = {vehicle.name,
                      line,
                      static_cast<uint16_t>(integer(cells[0])),
                      keeperOf(vehicle.firmware, vehicle.type, type),
                      type,
                      itemOf(cells, 3, integer(cells[2]), integer(cells[0])),
                      itemOf(cells, 13, integer(cells[11]), integer(cells[12])),
                      cells[10] == "ACCEPTED" && !cells[11].empty()};
  row.read.current = static_cast<uint8_t>(integer(cells[20]));
  row.read.autocontinue = static_cast<uint8_t>(integer(cells[21]));
  return row;
}

// Not as the library sends it, where a command without a place has no other frame.
bool isSentOtherwise(const RecordedItem& row) {
  return row.isPx4() && row.sent.frame != CoordinateFrame::Mission && (traitsOf(row.sent.command) & kHasNoPlace) != 0;
}

std::vector<RecordedItem> loaded() {
  const char* folder = getenv("MAVMISSION_RECORDINGS");
  if (folder == nullptr) throw std::runtime_error("set MAVMISSION_RECORDINGS, or run test_host.py, which does");
  std::vector<RecordedItem> rows;
  for (const Vehicle& vehicle : kVehicles) {
    std::ifstream file(std::string(folder) + "/readback_random_" + vehicle.name + ".csv");
    std::string text;
    std::getline(file, text);
    for (unsigned line = 2; std::getline(file, text); ++line) {
      const RecordedItem row = rowOf(cellsOf(text), vehicle, line);
      if (!isSentOtherwise(row)) rows.push_back(row);
    }
  }
  return rows;
}

// PX4 has another layout for an item without a place.
typedef std::tuple<std::string, PlanType, uint16_t, bool, unsigned> FieldOfCommand;
FieldOfCommand keyOf(const RecordedItem& row, unsigned index) {
  const bool hasNoPlace = row.isPx4() && row.sent.frame == CoordinateFrame::Mission;
  return FieldOfCommand(row.vehicle, row.type, row.sent.command, hasNoPlace, index);
}

std::map<FieldOfCommand, bool> droppedFields() {
  std::map<FieldOfCommand, bool> dropped;
  for (const RecordedItem& row : recordedItems()) {
    if (!row.isRead) continue;
    for (unsigned i = 0; i < kFourBytes; ++i) {
      const FieldOfCommand key = keyOf(row, i);
      const bool isFirst = dropped.count(key) == 0;
      dropped[key] = (isFirst || dropped[key]) && numberOf(row.read, i) == 0;
    }
  }
  return dropped;
}

}  // namespace

const std::vector<RecordedItem>& recordedItems() {
  static const std::vector<RecordedItem> rows = loaded();
  return rows;
}

uint32_t bitsOf(const MissionItem& item, unsigned index) {
  uint32_t bits = 0;
  memcpy(&bits, reinterpret_cast<const uint8_t*>(&item) + size_t{4} * index, 4);
  return bits;
}

void setBits(MissionItem& item, unsigned index, uint32_t bits) {
  memcpy(reinterpret_cast<uint8_t*>(&item) + size_t{4} * index, &bits, 4);
}

bool isInteger(unsigned index) { return index == 4 || index == 5; }

double numberOf(const MissionItem& item, unsigned index) {
  const uint32_t bits = bitsOf(item, index);
  if (isInteger(index)) return static_cast<int32_t>(bits);
  float number;
  memcpy(&number, &bits, 4);
  return static_cast<double>(number);
}

ItemField fieldOf(unsigned index) { return static_cast<ItemField>(static_cast<unsigned>(ItemField::Param1) + index); }

bool isDropped(const RecordedItem& row, unsigned index) {
  static const std::map<FieldOfCommand, bool> dropped = droppedFields();
  return dropped.at(keyOf(row, index));
}

namespace {

// True where ArduPilot drops a number that would change the flight.
bool isMissed(const RecordedItem& row, unsigned index) {
  switch (row.sent.command) {
    case kNavWaypoint: return index == 0 && row.isPlane();  // a time to hold
    case 178: return index == 3;                            // DO_CHANGE_SPEED: a relative speed
    case 207:                                               // DO_FENCE_ENABLE: which fences
    case 3000: return index == 1;                           // DO_VTOL_TRANSITION: at once
    default: return false;
  }
}

}  // namespace

bool meansTheSame(const RecordedItem& row, unsigned index) {
  const double sent = numberOf(row.sent, index), read = numberOf(row.read, index);
  if (sent == read || (std::isnan(sent) && std::isnan(read))) return true;
  if (isDropped(row, index)) return row.isPx4() || !isMissed(row, index);
  const uint16_t command = row.sent.command;
  const bool isInCentimetres = std::fabs(read) <= std::fabs(sent) && std::fabs(sent - read) < 0.0101;
  const bool isASign = read == (std::signbit(sent) ? -1 : 1) && (!row.isPlane() || sent == 0);
  if (row.isPx4()) {
    // A heading, whole turns apart.
    if (index == 3) return sent >= -180 && sent <= 360 && std::fabs(std::remainder(read - sent, 360)) < 4e-5;
    // The place of DO_LAND_START has been a float, and is of no use.
    const double asFloat = static_cast<double>(static_cast<float>(sent));
    return command == 189 && isInteger(index) && read == (asFloat < 2147483648.0 ? asFloat : -2147483648.0);
  }
  switch (index) {
    case 0: return command == 94 && isInCentimetres;                                               // NAV_PAYLOAD_PLACE
    case 2: return (command == 223 && isInCentimetres) || (command == kNavLoiterTime && isASign);  // DO_ENGINE_CONTROL
    case 3: return command == kNavLand && isASign;
    case 6: return command == 205 || (row.type == PlanType::Mission && isInCentimetres);  // DO_MOUNT_CONTROL
    default: return false;
  }
}
