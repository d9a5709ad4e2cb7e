// For an ESP32 or ESP8266 as an access point: a telemetry bridge, or the computer with a simulator, joins the board's
// network, and the plan is uploaded over UDP. The board has the address 192.168.4.1 and listens on port 14550: set
// these at the other end (docs/radio.md). Read the serial monitor at 115200 baud.
//
// Everybody in this network can fly the aircraft: choose your own password, of 8 letters or more.

#ifdef ESP8266
#include <ESP8266WiFi.h>
#else
#include <WiFi.h>
#endif
#include <WiFiUdp.h>

#include <MavMission.h>
#include <MavMissionUdp.h>
using namespace mavmission;

const char network[] = "MissionPlan", password[] = "choose-your-own";

constexpr MissionItem survey[] PROGMEM = {
    takeoff(20_m),  // above home
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
    waypoint(-35.3614500_deg, 149.1652374_deg, 20_m),
    returnToLaunch(),
};

WiFiUDP udp;
UdpLink line(udp);
MissionClient autopilot(line);
PositionListener position(autopilot, 1000);

void setup() {
  Serial.begin(115200);
  WiFi.mode(WIFI_AP);
  WiFi.softAP(network, password);
  udp.begin(14550);
  autopilot.setAutopilotTimeout(30);  // [s]
  autopilot.ensure(inFlash(survey));  // at each power-on: uploads it only if it is not aboard
}

void loop() {
  const Status ended = autopilot.update();
  if (isEnd(ended)) {
    Serial.println(toString(ended));
    if (line.severalHeard()) Serial.println(F("two aircraft are in this network: name one by line.setPeer()"));
  }
  if (position.isNew() && position.hasHeights()) {
    Serial.print(position.aboveHomeMm() / 1000);
    Serial.println(F(" m above home"));
  }
  delay(1);
}
