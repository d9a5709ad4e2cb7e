// Two items go to an autopilot that says HEARTBEAT.autopilot = the first argument; what the client sends and how it
// ends is said in words: "name NAME", "count 3", "item 0 command 16", "mode 17", "status 14 aboard 2".
// test/proof/test_third_autopilot.py compiles it with a library that knows one autopilot more.
#include <Arduino.h>
#include <MavMission.h>
#include <stdio.h>
#include <stdlib.h>

#include "Frames.h"
#include "MemoryStream.h"

using namespace mavmission;

namespace {

constexpr uint16_t kCount = 44, kItemInt = 73;  // MISSION_COUNT, MISSION_ITEM_INT
constexpr size_t kHeader = 10, kChecksum = 2;   // of a MAVLink 2 frame [bytes]

const MissionItem kPlan[] = {takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m)};

uint16_t word(const uint8_t* payload, uint8_t length, size_t offset) {  // what was cut off its end is 0
  const unsigned low = offset < length ? payload[offset] : 0, high = offset + 1 < length ? payload[offset + 1] : 0;
  return static_cast<uint16_t>(low | high << 8);
}

}  // namespace

int main(int argumentCount, char** arguments) {
  if (argumentCount != 2) return 2;
  const uint8_t autopilot = static_cast<uint8_t>(atoi(arguments[1]));
  MemoryStream stream;
  MissionClient client(stream);
  client.upload(inRam(kPlan));
  uint16_t items = 0;
  uint32_t nowMs = 0;
  for (; nowMs < 20000 && client.isBusy(); ++nowMs) {
    setMillis(nowMs);
    if (nowMs % 1000 == 0) stream.bring(packed(heartbeatParts(autopilot)));
    client.update();
    const Bytes sent = stream.takeWritten();
    for (size_t at = 0; at + kHeader < sent.size(); at += kHeader + sent[at + 1] + kChecksum) {
      const uint8_t* payload = &sent[at + kHeader];
      const uint8_t length = sent[at + 1];
      const uint16_t id = static_cast<uint16_t>(sent[at + 7] | sent[at + 8] << 8);
      if (id == kCount) {
        items = word(payload, length, 0);
        printf("count %u\n", items);
        stream.bring(request(0));
      } else if (id == kItemInt) {
        const uint16_t item = word(payload, length, 28);
        printf("item %u command %u\n", item, word(payload, length, 30));
        stream.bring(item + 1 < items ? request(static_cast<uint16_t>(item + 1)) : ack(5));  // MAV_MISSION_INVALID
      }
    }
  }
  printf("firmware %u\n", static_cast<unsigned>(client.firmware()));
  printf("name %s\n", nameOf(client.firmware()));
  printf("status %u aboard %u\n", static_cast<unsigned>(client.status()), static_cast<unsigned>(client.aboard()));
  return 0;
}
