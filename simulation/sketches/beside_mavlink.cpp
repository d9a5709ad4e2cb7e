// Another MAVLink library in the same sketch: MavMission on Serial1, and the stock headers, which decode what a
// listener hears, pack what the sketch sends, and parse a second line, Serial2.
#include <Arduino.h>
#include <MavMission.h>

#include <common/mavlink.h>

using namespace mavmission;
using namespace mavmission::detail;

constexpr MissionItem plan[] PROGMEM = {
    takeoff(20_m),
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
    returnToLaunch(),
};
const MessageKey keys[] PROGMEM = {
    messageKey(MAVLINK_MSG_ID_GPS_RAW_INT, MAVLINK_MSG_ID_GPS_RAW_INT_CRC, MAVLINK_MSG_ID_GPS_RAW_INT_MIN_LEN)};

static void onGps(void*, const ReceivedMessage& message) {
  mavlink_gps_raw_int_t gps;
  message.copyTo(&gps, sizeof(gps));
  Serial.print(F("gps "));
  Serial.print(gps.lat);
  Serial.print(' ');
  Serial.println(gps.satellites_visible);
}

MissionClient autopilot(Serial1);
MessageListener listener(autopilot, keys, onGps);

static mavlink_request_data_stream_t request;
static bool isRequestDue = true;

void setup() {
  Serial.begin(500000);
  Serial1.begin(57600);
  Serial2.begin(57600);
  request.req_message_rate = 4;
  request.target_system = 1;
  request.target_component = 1;
  request.req_stream_id = 6;
  request.start_stop = 1;
  autopilot.upload(inFlash(plan), Readback::Always);
}

void loop() {
  const Status status = autopilot.update();
  if (isEnd(status)) Serial.println(toString(status));
  if (status == Status::Accepted) isRequestDue = true;
  if (isRequestDue && autopilot.status() == Status::Accepted) {
    const OutgoingMessage message = {MAVLINK_MSG_ID_REQUEST_DATA_STREAM, MAVLINK_MSG_ID_REQUEST_DATA_STREAM_CRC,
                                     MAVLINK_MSG_ID_REQUEST_DATA_STREAM_LEN, MAVLINK_MSG_ID_REQUEST_DATA_STREAM_MIN_LEN,
                                     &request};
    isRequestDue = !autopilot.sendMessage(message);
  }
  while (Serial2.available()) {
    static mavlink_message_t message;
    static mavlink_status_t parsing;
    if (mavlink_parse_char(MAVLINK_COMM_0, Serial2.read(), &message, &parsing)) {
      Serial.print(F("stock "));
      Serial.println(message.msgid);
    }
  }
}
