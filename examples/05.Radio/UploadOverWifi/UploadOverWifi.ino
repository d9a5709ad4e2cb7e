// For ESP32 and ESP8266: uploads a plan over WiFi, by UDP. The board joins a network: that of a telemetry bridge on the
// autopilot's TELEM port, or the one in which a simulator runs. Nothing is wired to the autopilot. docs/radio.md says
// what to set at the other end. Load it, and read the serial monitor at 115200 baud.

#ifdef ESP8266
#include <ESP8266WiFi.h>
#else
#include <WiFi.h>
#endif
#include <WiFiUdp.h>

#include <MavMission.h>
#include <MavMissionUdp.h>
using namespace mavmission;

const char network[] = "ArduPilot", password[] = "ardupilot";  // yours
constexpr uint16_t port = 14550;                               // to which the other end sends

constexpr MissionItem survey[] PROGMEM = {
    takeoff(20_m),  // above home
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
    waypoint(-35.3614500_deg, 149.1652374_deg, 20_m),
    returnToLaunch(),
};

WiFiUDP udp;
UdpLink line(udp);  // the autopilot is the first to send a heartbeat
MissionClient autopilot(line);

void setup() {
  Serial.begin(115200);
  WiFi.mode(WIFI_STA);
  WiFi.begin(network, password);  // it goes on by itself, and joins again after a break
  udp.begin(port);
  autopilot.retryWhenBusy(60);
  autopilot.upload(inFlash(survey));
}

void loop() {
  static bool wasFound;
  if (line.hasPeer() != wasFound) {
    wasFound = line.hasPeer();
    if (wasFound) {
      Serial.print(F("the autopilot is at "));
      Serial.println(line.peerAddress());
    } else {
      Serial.println(F("two aircraft are in this network: name one by line.setPeer()"));
    }
  }
  const Status ended = autopilot.update();
  if (isEnd(ended)) Serial.println(toString(ended));
  delay(1);  // the radio's turn; longer waits cost time, and nothing else
}
