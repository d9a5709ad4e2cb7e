// A small display (SSD1306, 128 x 64, I2C) that shows the aircraft: mode, armed or not, battery, GPS, height, and
// whether it is fit to fly. Install the library U8g2 (Sketch > Include Library > Manage Libraries); wire SDA and SCL to
// the board's I2C pins, on a Mega 20 and 21, on an Uno A4 and A5.
#include <MavMission.h>
#include <MavMissionTelem.h>  // TELEM: this board's port to the autopilot
#include <U8x8lib.h>
using namespace mavmission;

constexpr uint8_t kLines = 6;
constexpr uint32_t kPauseMs = 150;  // from one line to the next

MissionClient autopilot(TELEM);
Vehicle<autopilot> vehicle;
U8X8_SSD1306_128X64_NONAME_HW_I2C display(U8X8_PIN_NONE);

void showTenths(int32_t tenths) {
  if (tenths < 0) display.print('-');
  display.print(abs(tenths) / 10);
  display.print('.');
  display.print(abs(tenths) % 10);
}

void showBattery() {
  if (!vehicle.battery().hasVoltage()) return;
  showTenths(vehicle.battery().voltageMv() / 100);
  display.print(F(" V "));
  if (!vehicle.battery().hasRemaining()) return;
  display.print(vehicle.battery().remainingPercent());
  display.print(F(" %"));
}

void showGps() {
  if (!vehicle.gps().isHeard()) return;
  display.print(vehicle.gps().hasFix() ? F("fix ") : F("no fix "));
  if (!vehicle.gps().hasSatellites()) return;
  display.print(vehicle.gps().satellites());
  display.print(F(" sat"));
}

void showHeight() {
  if (!vehicle.position().hasHeights()) return;
  showTenths(vehicle.position().aboveHomeMm() / 100);
  display.print(F(" m"));
}

// A line takes some milliseconds, in which the port's receive buffer must not fill up: so one line at a time.
void showLine(uint8_t line) {
  display.clearLine(line);
  display.setCursor(0, line);
  switch (line) {
    case 0: display.print(vehicle.isHeard() ? vehicle.modeName() : F("no autopilot")); break;
    case 1: display.print(!vehicle.isHeard() ? F("") : vehicle.isArmed() ? F("ARMED") : F("disarmed")); break;
    case 2: display.print(toString(vehicle.fitness())); break;
    case 3: showBattery(); break;
    case 4: showGps(); break;
    case 5: showHeight(); break;
  }
}

void setup() {
  display.begin();
  display.setFont(u8x8_font_chroma48medium8_r);
  beginTelem(57600);
}

void loop() {
  autopilot.update();

  static uint32_t shownMs;
  static uint8_t line;
  if (millis() - shownMs < kPauseMs) return;
  shownMs = millis();
  showLine(line);
  line = (line + 1) % kLines;
}
