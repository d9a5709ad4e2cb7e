#include "Messages.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <sstream>
#include <stdexcept>

#include "mavmission/base/MavlinkHeaders.h"

namespace {

typedef mavlink_message_info_t Info;
typedef mavlink_field_info_t Field;

const Info kInfos[] = MAVLINK_MESSAGE_INFO;
const mavlink_msg_entry_t kEntries[] = MAVLINK_MESSAGE_CRCS;

// ArduPilot's own.
const Info kArduPilots[] = {{168,
                             "WIND",
                             3,
                             {{"direction", nullptr, MAVLINK_TYPE_FLOAT, 0, 0, 0},
                              {"speed", nullptr, MAVLINK_TYPE_FLOAT, 0, 4, 4},
                              {"speed_z", nullptr, MAVLINK_TYPE_FLOAT, 0, 8, 8}}},
                            {193,
                             "EKF_STATUS_REPORT",
                             6,
                             {{"velocity_variance", nullptr, MAVLINK_TYPE_FLOAT, 0, 0, 0},
                              {"pos_horiz_variance", nullptr, MAVLINK_TYPE_FLOAT, 0, 4, 4},
                              {"pos_vert_variance", nullptr, MAVLINK_TYPE_FLOAT, 0, 8, 8},
                              {"compass_variance", nullptr, MAVLINK_TYPE_FLOAT, 0, 12, 12},
                              {"terrain_alt_variance", nullptr, MAVLINK_TYPE_FLOAT, 0, 16, 16},
                              {"flags", nullptr, MAVLINK_TYPE_UINT16_T, 0, 20, 20}}}};
const mavlink_msg_entry_t kArduPilotEntries[] = {{168, 1, 12, 12, 0, 0, 0}, {193, 71, 22, 22, 0, 0, 0}};

template <typename Is>
const Info& infoThat(Is is) {
  for (const Info& info : kArduPilots) {
    if (is(info)) return info;
  }
  for (const Info& info : kInfos) {
    if (is(info)) return info;
  }
  throw std::invalid_argument("there is no such message");
}

const mavlink_msg_entry_t& entryOf(uint32_t id) {
  for (const mavlink_msg_entry_t& entry : kArduPilotEntries) {
    if (entry.msgid == id) return entry;
  }
  for (const mavlink_msg_entry_t& entry : kEntries) {
    if (entry.msgid == id) return entry;
  }
  throw std::invalid_argument("there is no message " + std::to_string(id));
}

const Field& fieldOf(const Info& info, const std::string& name) {
  for (unsigned i = 0; i < info.num_fields; ++i) {
    if (name == info.fields[i].name) return info.fields[i];
  }
  throw std::invalid_argument(std::string(info.name) + " has no field " + name);
}

unsigned sizeOf(const Field& field) {
  switch (field.type) {
    case MAVLINK_TYPE_CHAR:
    case MAVLINK_TYPE_UINT8_T:
    case MAVLINK_TYPE_INT8_T: return 1;
    case MAVLINK_TYPE_UINT16_T:
    case MAVLINK_TYPE_INT16_T: return 2;
    case MAVLINK_TYPE_UINT32_T:
    case MAVLINK_TYPE_INT32_T:
    case MAVLINK_TYPE_FLOAT: return 4;
    default: return 8;
  }
}

bool isSigned(const Field& field) {
  return field.type == MAVLINK_TYPE_INT8_T || field.type == MAVLINK_TYPE_INT16_T ||
         field.type == MAVLINK_TYPE_INT32_T || field.type == MAVLINK_TYPE_INT64_T;
}

void put(Bytes& payload, const Field& field, unsigned index, const std::string& number) {
  char* end = nullptr;
  uint8_t bytes[8];
  if (field.type == MAVLINK_TYPE_FLOAT) {
    const float value = strtof(number.c_str(), &end);
    memcpy(bytes, &value, sizeof(value));
  } else if (field.type == MAVLINK_TYPE_UINT64_T) {
    const unsigned long long value = strtoull(number.c_str(), &end, 0);
    memcpy(bytes, &value, sizeof(value));
  } else {
    const long long value = strtoll(number.c_str(), &end, 0);
    memcpy(bytes, &value, sizeof(value));
  }
  if (number.empty() || *end != '\0') throw std::invalid_argument(number + " is no number");
  memcpy(&payload.at(field.wire_offset + index * sizeOf(field)), bytes, sizeOf(field));
}

std::string numberAt(const Bytes& payload, const Field& field, unsigned index) {
  const unsigned size = sizeOf(field), at = field.wire_offset + index * size;
  uint64_t bits = 0;
  memcpy(&bits, &payload.at(at), size);
  if (bits == 0) return "";
  if (field.type != MAVLINK_TYPE_FLOAT) {
    const bool isBelow = isSigned(field) && (bits >> (8 * size - 1)) != 0;
    return isBelow && size < 8 ? std::to_string(static_cast<int64_t>(bits) - (int64_t{1} << (8 * size)))
                               : std::to_string(bits);
  }
  float value;
  memcpy(&value, &payload.at(at), sizeof(value));
  return bits == 0x7FC00000 ? "nan" : isnan(value) ? "nan of other bits" : shortest(value);
}

FrameParts made(const std::string& words, Bytes& payload) {
  std::istringstream all(words);
  std::string name;
  all >> name;
  const Info& info = infoThat([&](const Info& one) { return name == one.name; });
  const mavlink_msg_entry_t& entry = entryOf(info.msgid);
  payload.assign(entry.max_msg_len, 0);
  while (all >> name) {
    const size_t bracket = name.find('[');
    const Field& field = fieldOf(info, name.substr(0, bracket));
    unsigned first = 0, last = 0;
    if (bracket != std::string::npos && sscanf(name.c_str() + bracket, "[%u-%u]", &first, &last) == 1) last = first;
    std::string value;
    if (field.type == MAVLINK_TYPE_CHAR) {
      if (all.peek() == ' ') all.get();
      std::getline(all, value);
      if (value.size() > field.array_length) throw std::invalid_argument(value + " is too long");
      std::copy(value.begin(), value.end(), payload.begin() + static_cast<long>(field.wire_offset));
    } else {
      all >> value;
      for (unsigned index = first; index <= last; ++index) put(payload, field, index, value);
    }
  }
  return FrameParts(info.msgid, Bytes(), entry.crc_extra);
}

}  // namespace

std::string shortest(float value) {
  char text[40];
  if (fabsf(value) < 1e9f && floorf(value) == value) return std::to_string(static_cast<long>(value));
  for (int digits = 6; digits <= 9; ++digits) {
    snprintf(text, sizeof(text), "%.*g", digits, double{value});
    if (strtof(text, nullptr) == value) break;
  }
  return text;
}

FrameParts messageParts(const std::string& words) {
  Bytes payload;
  FrameParts parts = made(words, payload);
  while (payload.size() > 1 && payload.back() == 0) payload.pop_back();
  parts.payload = payload;
  return parts;
}

FrameParts messagePartsV1(const std::string& words) {
  Bytes payload;
  FrameParts parts = made(words, payload);
  payload.resize(entryOf(parts.messageId).min_msg_len);
  parts.payload = payload;
  parts.version = 1;
  return parts;
}

std::string wordsOf(uint32_t messageId, const Bytes& bytes) {
  const Info& info = infoThat([&](const Info& one) { return one.msgid == messageId; });
  Bytes payload = bytes;
  payload.resize(255);
  std::string words = info.name;
  for (unsigned i = 0; i < info.num_fields; ++i) {
    const Field& field = info.fields[i];
    const unsigned count = field.array_length == 0 ? 1 : field.array_length;
    if (field.type == MAVLINK_TYPE_CHAR) {
      std::string text(payload.begin() + static_cast<long>(field.wire_offset),
                       payload.begin() + static_cast<long>(field.wire_offset + count));
      while (!text.empty() && text.back() == '\0') text.pop_back();
      if (!text.empty()) words += " " + std::string(field.name) + " " + text;
      continue;
    }
    for (unsigned first = 0, last; first < count; first = last + 1) {
      const std::string number = numberAt(payload, field, first);
      last = first;
      while (last + 1 < count && numberAt(payload, field, last + 1) == number) ++last;
      if (number.empty()) continue;
      words += " " + std::string(field.name);
      if (field.array_length != 0) words += "[" + std::to_string(first);
      if (last != first) words += "-" + std::to_string(last);
      words += (field.array_length != 0 ? "] " : " ") + number;
    }
  }
  return words;
}

std::string wordsOf(const mavmission::OutgoingMessage& message) {
  if (message.crcExtra != entryOf(message.id).crc_extra) throw std::invalid_argument("it is of another definition");
  const uint8_t* const bytes = static_cast<const uint8_t*>(message.payload);
  return std::to_string(message.length) + " " + std::to_string(message.lengthV1) + ": " +
         wordsOf(message.id, Bytes(bytes, bytes + message.length));
}
