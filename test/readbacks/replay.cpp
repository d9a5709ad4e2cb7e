// The library's own upload(plan, Readback::Always), compiled for this computer, against an autopilot that keeps what
// its other end (test/support/replayed.py) says that a real one kept. A line on the standard input for each plan:
//
//   autopilot vehicle type raw ITEM...    HEARTBEAT.autopilot and .type, PlanType, numbering, items in hexadecimal
//
// For each item of it that reaches the autopilot, and was not seen before in such a plan, "item ITEM" is said, and a
// line is taken: a MAV_MISSION_RESULT, and the item as it is read back where it is accepted. Then "end status item
// field aboard value": how it ended, and what keptValue() is. Behind an accepted plan each field of each of its items
// is altered by its smallest step, one at a time, and verify() is asked; "passed item field" for each that did not end
// in Differs.
//
// An ITEM is the 37 bytes of MISSION_ITEM_INT without its mission_type.
#include <Arduino.h>
#include <MavMission.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "Frames.h"
#include "MemoryStream.h"

using namespace mavmission;

namespace {

constexpr size_t kSeq = 28, kCommand = 30, kFrame = 34, kCurrent = 35, kAutocontinue = 36, kItemBytes = 37;

std::string hex(const Bytes& bytes) {
  std::string text;
  char two[3];
  for (const uint8_t byte : bytes) {
    snprintf(two, sizeof(two), "%02x", byte);
    text += two;
  }
  return text;
}

Bytes unhex(const std::string& text) {
  Bytes bytes;
  for (size_t i = 0; i + 1 < text.size(); i += 2) {
    bytes.push_back(static_cast<uint8_t>(strtoul(text.substr(i, 2).c_str(), nullptr, 16)));
  }
  return bytes;
}

MissionItem itemOf(const Bytes& wire) {
  MissionItem item;
  memset(static_cast<void*>(&item), 0, sizeof(item));
  memcpy(static_cast<void*>(&item), wire.data(), kPlaceBytes);
  memcpy(&item.command, &wire[kCommand], 2);
  item.frame = static_cast<Frame>(wire[kFrame]);
  item.current = wire[kCurrent];
  item.autocontinue = wire[kAutocontinue];
  return item;
}

struct Answer {
  uint8_t result;
  Bytes kept;
};

// Takes a plan whole, asks for each item once, and gives back what it kept of them.
struct Autopilot {
  uint8_t autopilot = 0, vehicle = 0, type = 0;
  std::map<std::string, Answer>* known = nullptr;
  std::string kind;
  std::vector<Bytes> held, coming;
  size_t count = 0;

  static Bytes message(uint32_t id, const Bytes& payload, uint8_t extra) {
    return packed(FrameParts(id, payload, extra));
  }
  Bytes heartbeat() const { return message(0, {0, 0, 0, 0, vehicle, autopilot, 0, 3, 3}, 50); }
  bool hasHome() const { return autopilot == 3 && type == 0; }
  // ArduPilot asks by MISSION_REQUEST.
  Bytes request(size_t seq) const {
    const Bytes payload = {static_cast<uint8_t>(seq), static_cast<uint8_t>(seq >> 8), 1, 191, type};
    return autopilot == 3 ? message(40, payload, 230) : message(51, payload, 196);
  }
  // What it gives as item 0, whatever it got.
  static Bytes home() {
    Bytes item(kItemBytes);
    item[kCommand] = 16;
    item[kAutocontinue] = 1;
    return item;
  }
  Bytes ack(uint8_t result) const { return message(47, {1, 191, result, type}, 153); }

  const Answer& answerTo(const Bytes& item) {
    Bytes asked = item;
    asked[kSeq] = asked[kSeq + 1] = 0;
    const std::string text = hex(asked);
    const auto found = known->find(kind + text);
    if (found != known->end()) return found->second;
    std::cout << "item " << text << std::endl;
    std::string line, kept;
    std::getline(std::cin, line);
    std::istringstream words(line);
    unsigned result = 0;
    words >> result >> kept;
    return (*known)[kind + text] = Answer{static_cast<uint8_t>(result), unhex(kept)};
  }

  // What it says to a frame.
  Bytes hear(uint8_t id, Bytes payload) {
    payload.resize(40, 0);
    switch (id) {
      case 44:  // MISSION_COUNT
        count = static_cast<size_t>(payload[0] | payload[1] << 8);
        coming.clear();
        return request(0);
      case 73: {  // MISSION_ITEM_INT
        payload.resize(kItemBytes);
        if (coming.size() == count) return Bytes();
        const Answer& answer = answerTo(payload);
        if (answer.result != 0) return ack(answer.result);
        coming.push_back(hasHome() && coming.empty() ? home() : answer.kept);
        if (coming.size() < count) return request(coming.size());
        held = coming;
        return ack(0);
      }
      case 43: {  // MISSION_REQUEST_LIST
        const size_t items = held.size();
        return message(44, {static_cast<uint8_t>(items), static_cast<uint8_t>(items >> 8), 1, 191, type}, 221);
      }
      case 51: {  // MISSION_REQUEST_INT
        const size_t seq = static_cast<size_t>(payload[0] | payload[1] << 8);
        if (seq >= held.size() || held[seq].empty()) return ack(13);
        Bytes item = held[seq];
        item[kSeq] = static_cast<uint8_t>(seq);
        item[kSeq + 1] = static_cast<uint8_t>(seq >> 8);
        item[32] = 1;
        item[33] = 191;
        item.push_back(type);
        return message(73, item, 38);
      }
      default: return Bytes();
    }
  }
};

MemoryStream stream;
uint32_t nowMs = 1000;

// Runs until an operation ends.
Status finished(MissionClient& client, Autopilot& autopilot) {
  for (uint32_t ms = 0; ms < 60000; ++ms) {
    setMillis(++nowMs);
    if (ms % 1000 == 0) stream.bring(autopilot.heartbeat());
    const Status status = client.update();
    if (isEnd(status)) return status;
    const Bytes sent = stream.takeWritten();
    for (size_t at = 0; at + 12 <= sent.size(); at += static_cast<size_t>(sent[at + 1]) + 12) {
      const Bytes payload(sent.begin() + static_cast<long>(at + 10),
                          sent.begin() + static_cast<long>(at + 10 + sent[at + 1]));
      stream.bring(autopilot.hear(sent[at + 7], payload));
    }
  }
  return Status::Idle;
}

// ItemField `field` of the item by its smallest step: of param1 to z a bit of its bytes, of the rest another value.
Bytes altered(Bytes item, size_t field, int step) {
  if (field < 7) {
    int32_t bits;
    memcpy(&bits, &item[field * 4], 4);
    const bool isFloat = field != 4 && field != 5;
    if (isFloat && (bits & 0x7FFFFFFF) == 0) {
      bits = step > 0 ? 1 : static_cast<int32_t>(0x80000001u);  // the smallest number on either side of 0
    } else {
      bits = static_cast<int32_t>(static_cast<uint32_t>(bits) + static_cast<uint32_t>(step));
    }
    memcpy(&item[field * 4], &bits, 4);
  } else if (field == 7) {
    item[kCommand] ^= 1;
  } else if (field == 8) {
    const uint8_t frame = item[kFrame];
    item[kFrame] = frame == 0 || frame == 5 ? 3 : frame == 3 || frame == 6 ? 10 : 0;
  } else {
    item[kAutocontinue] ^= 1;
  }
  return item;
}

void alterAll(MissionClient& client, Autopilot& autopilot, const ItemSource& source, size_t first) {
  for (size_t i = first; i < autopilot.held.size(); ++i) {
    const Bytes kept = autopilot.held[i];
    for (size_t field = 0; field < 10; ++field) {
      for (const int step : {1, -1}) {
        if (field > 6 && step < 0) continue;
        autopilot.held[i] = altered(kept, field, step);
        float value;
        memcpy(&value, &autopilot.held[i][(field < 7 ? field : 0) * 4], 4);
        if (field < 7 && field != 4 && field != 5 && isnan(value)) continue;  // one NaN is as good as another
        client.verify(source, static_cast<PlanType>(autopilot.type));
        const Status status = finished(client, autopilot);
        if (status != Status::Differs) {
          std::cout << "passed " << i << ' ' << field << ' ' << hex(autopilot.held[i]) << '\n';
        }
      }
    }
    autopilot.held[i] = kept;
  }
}

}  // namespace

int main() {
  std::map<std::string, Answer> known;
  std::string line;
  while (std::getline(std::cin, line)) {
    std::istringstream words(line);
    unsigned autopilotNumber = 0, vehicle = 0, type = 0, raw = 0;
    words >> autopilotNumber >> vehicle >> type >> raw;
    std::vector<MissionItem> plan;
    for (std::string text; words >> text;) plan.push_back(itemOf(unhex(text)));

    Autopilot autopilot;
    autopilot.autopilot = static_cast<uint8_t>(autopilotNumber);
    autopilot.vehicle = static_cast<uint8_t>(vehicle);
    autopilot.type = static_cast<uint8_t>(type);
    autopilot.known = &known;
    autopilot.kind = std::to_string(autopilotNumber) + ' ' + std::to_string(vehicle) + ' ' + std::to_string(type) + ' ';
    stream.toRead.clear();
    stream.written.clear();
    MissionClient client(stream);
    client.setTargetIds(1);
    client.useRawNumbering(raw != 0);
    const ItemSource source = inRam(plan.data(), static_cast<uint32_t>(plan.size()));
    client.upload(source, static_cast<PlanType>(type), Readback::Always);
    Status status = finished(client, autopilot);
    printf("end %s|%u|%u|%u|%u|%.9g\n", toString(status), static_cast<unsigned>(status), client.failedItem(),
           static_cast<unsigned>(client.differingField()),
           static_cast<unsigned>(client.aboard(static_cast<PlanType>(type))),
           status == Status::NotKept ? static_cast<double>(client.keptValue()) : 0.0);
    fflush(stdout);
    if (status == Status::Accepted) alterAll(client, autopilot, source, autopilot.hasHome() ? 1 : 0);
    std::cout << "done" << std::endl;
  }
  return 0;
}
