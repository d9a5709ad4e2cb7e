// For a Mega with an Ethernet shield (W5500, W5100): uploads a plan over UDP. The autopilot has an Ethernet port or a
// bridge, or is a simulator; docs/radio.md says what to set there. The library "Ethernet" is the Arduino IDE's. Read
// the serial monitor at 115200 baud.

#include <Ethernet.h>
#include <SPI.h>

#include <MavMission.h>
#include <MavMissionUdp.h>
using namespace mavmission;

byte mac[] = {0x02, 0x4D, 0x61, 0x76, 0x00, 0x01};
const IPAddress address(192, 168, 144, 20);  // of this board; the autopilot's has the same first three numbers
constexpr uint16_t port = 14550;             // to which the other end sends

constexpr MissionItem survey[] PROGMEM = {
    takeoff(20_m),  // above home
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
    waypoint(-35.3614500_deg, 149.1652374_deg, 20_m),
    returnToLaunch(),
};

EthernetUDP udp;
UdpLink line(udp);
MissionClient autopilot(line);

void setup() {
  Serial.begin(115200);
  Ethernet.begin(mac, address);
  // Without these two lines each datagram to an autopilot that has gone holds loop() up for 1.6 s.
  Ethernet.setRetransmissionTimeout(10);  // [ms]
  Ethernet.setRetransmissionCount(1);
  udp.begin(port);
  autopilot.upload(inFlash(survey));
}

void loop() {
  const Status ended = autopilot.update();
  if (isEnd(ended)) Serial.println(toString(ended));
}
