// The job of the first example done the usual way: MAVLink's own headers at
// their defaults, one channel, blocking writes, no retries. The sizes and speeds
// in the README are set against this.
//
// Built for MAVLink 2 as it stands; with BASELINE_MAVLINK1 against the headers
// that mavgen makes for wire protocol 1.0. The folder to include <mavlink.h>
// from is on the command line.

#include <Arduino.h>
#include <mavlink.h>

namespace {

constexpr uint8_t kSystem = 1;
constexpr uint8_t kComponent = MAV_COMP_ID_ONBOARD_COMPUTER;
constexpr uint8_t kAutopilotSystem = 1;
constexpr uint8_t kAutopilotComponent = MAV_COMP_ID_AUTOPILOT1;

// A plan as sketches usually hold one: in RAM, in floating-point degrees, which
// are 32 bits wide on AVR.
struct Step {
  uint16_t command;
  float param1, param2, param3, param4;
  double latitude, longitude;  // [degrees]
  float altitude;              // [m above home]
};

Step plan[] = {
    {MAV_CMD_NAV_TAKEOFF, 0, 0, 0, 0, -35.3632621, 149.1652374, 20},
    {MAV_CMD_NAV_WAYPOINT, 0, 0, 0, 0, -35.3614500, 149.1652374, 20},
};
constexpr uint16_t kItems = sizeof plan / sizeof plan[0];

uint32_t lastHeartbeatAtMs = 0;
bool autopilotHeard = false;

void send(const mavlink_message_t& message) {
  uint8_t buffer[MAVLINK_MAX_PACKET_LEN];
  const uint16_t length = mavlink_msg_to_send_buffer(buffer, &message);
  Serial1.write(buffer, length);
}

void sendHeartbeat() {
  mavlink_message_t message;
  mavlink_msg_heartbeat_pack(kSystem, kComponent, &message, MAV_TYPE_ONBOARD_CONTROLLER, MAV_AUTOPILOT_INVALID, 0, 0,
                             MAV_STATE_ACTIVE);
  send(message);
}

void sendCount() {
  mavlink_message_t message;
#ifdef BASELINE_MAVLINK1
  mavlink_msg_mission_count_pack(kSystem, kComponent, &message, kAutopilotSystem, kAutopilotComponent, kItems);
#else
  mavlink_msg_mission_count_pack(kSystem, kComponent, &message, kAutopilotSystem, kAutopilotComponent, kItems,
                                 MAV_MISSION_TYPE_MISSION, 0);
#endif
  send(message);
}

}  // namespace

// Read by the tests.
volatile bool accepted = false;

// The two functions that the measurements watch are not inlined.
extern "C" __attribute__((noinline)) uint8_t baseline_parse(uint8_t byte, mavlink_message_t* message,
                                                            mavlink_status_t* status) {
  return mavlink_parse_char(MAVLINK_COMM_0, byte, message, status);
}

extern "C" __attribute__((noinline)) void baseline_pack(mavlink_message_t* message, uint16_t seq) {
  const Step& step = plan[seq];
  const int32_t latE7 = static_cast<int32_t>(step.latitude * 1e7);
  const int32_t lonE7 = static_cast<int32_t>(step.longitude * 1e7);
#ifdef BASELINE_MAVLINK1
  mavlink_msg_mission_item_int_pack(kSystem, kComponent, message, kAutopilotSystem, kAutopilotComponent, seq,
                                    MAV_FRAME_GLOBAL_RELATIVE_ALT, step.command, 0, 1, step.param1, step.param2,
                                    step.param3, step.param4, latE7, lonE7, step.altitude);
#else
  mavlink_msg_mission_item_int_pack(kSystem, kComponent, message, kAutopilotSystem, kAutopilotComponent, seq,
                                    MAV_FRAME_GLOBAL_RELATIVE_ALT, step.command, 0, 1, step.param1, step.param2,
                                    step.param3, step.param4, latE7, lonE7, step.altitude, MAV_MISSION_TYPE_MISSION);
#endif
}

namespace {

void sendItem(uint16_t seq) {
  if (seq >= kItems) return;
  mavlink_message_t message;
  baseline_pack(&message, seq);
  send(message);
}

void answer(const mavlink_message_t& received) {
  switch (received.msgid) {
    case MAVLINK_MSG_ID_HEARTBEAT:
      if (!autopilotHeard && mavlink_msg_heartbeat_get_autopilot(&received) != MAV_AUTOPILOT_INVALID) {
        autopilotHeard = true;
        sendCount();
      }
      break;
    case MAVLINK_MSG_ID_MISSION_REQUEST: sendItem(mavlink_msg_mission_request_get_seq(&received)); break;
    case MAVLINK_MSG_ID_MISSION_REQUEST_INT: sendItem(mavlink_msg_mission_request_int_get_seq(&received)); break;
    case MAVLINK_MSG_ID_MISSION_ACK:
      accepted = mavlink_msg_mission_ack_get_type(&received) == MAV_MISSION_ACCEPTED;
      break;
  }
}

}  // namespace

void setup() { Serial1.begin(57600); }

void loop() {
  mavlink_message_t message;
  mavlink_status_t status;
  while (Serial1.available()) {
    if (baseline_parse(Serial1.read(), &message, &status)) answer(message);
  }
  if (millis() - lastHeartbeatAtMs >= 1000) {
    lastHeartbeatAtMs = millis();
    sendHeartbeat();
  }
}
