// Uploads a plan from a file: PLAN.TXT on an SD card, as Mission Planner saves it (.waypoints, QGC WPL 110). The file
// may be of any length, and hold a mission, a fence or rally points; an item is read when the autopilot requests it. An
// error in the file is printed with its line.
//
// Without a card the text below is used instead of the file. With a card (any shield; 10 is its chip select pin),
// remove the two slashes at the beginning of the next line:
// #define CARD_SELECT 10

#include <MavMission.h>
#define CONSOLE_TX 9            // on an Uno or a Nano: a pin that the card does not use
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

#ifdef CARD_SELECT
#include <SD.h>
File file;
bool openFile() {
  if (!SD.begin(CARD_SELECT)) return false;
  file = SD.open("PLAN.TXT");
  return file;
}
#else
const char text[] PROGMEM =
    "QGC WPL 110\n"
    "0\t1\t0\t16\t0\t0\t0\t0\t-35.3632621\t149.1652374\t584\t1\n"
    "1\t0\t3\t22\t0\t0\t0\t0\t0\t0\t20\t1\n"
    "2\t0\t3\t16\t0\t0\t0\t0\t-35.3632621\t149.1652374\t20\t1\n"
    "3\t0\t3\t16\t0\t0\t0\t0\t-35.3614500\t149.1652374\t25.5\t1\n"
    "4\t0\t3\t177\t2\t2\t0\t0\t0\t0\t0\t1\n"
    "5\t0\t3\t20\t0\t0\t0\t0\t0\t0\t0\t1\n";

// The text as a file: the library needs a Stream with an end, and seek().
class TextFile : public Stream {
 public:
  bool seek(uint32_t position) {
    position_ = position;
    return position < sizeof(text);
  }
  int available() override { return sizeof(text) - 1 - position_; }
  int peek() override { return available() > 0 ? pgm_read_byte(&text[position_]) : -1; }
  int read() override {
    const int byte = peek();
    if (byte >= 0) ++position_;
    return byte;
  }
  size_t write(uint8_t) override { return 0; }

 private:
  uint16_t position_ = 0;
};
TextFile file;
bool openFile() { return true; }
#endif

MissionClient autopilot(TELEM);
WaypointsSource plan(file);
bool isRead;

void onRead() {
  isRead = true;
  const bool isGood = plan.state() == WaypointsSource::State::Good;
  if (isGood) autopilot.upload(plan.source(), plan.type());
  if (!CONSOLE) return;
  if (isGood) {
    CONSOLE.print(F("items: "));
    CONSOLE.println(plan.count());
    return;
  }
  CONSOLE.print(F("line "));
  CONSOLE.print(plan.errorLine());
  if (plan.errorField() != 0) {
    CONSOLE.print(F(", field "));
    CONSOLE.print(plan.errorField());
  }
  CONSOLE.print(F(": "));
  CONSOLE.println(toString(plan.error()));
}

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  if (!openFile()) CONSOLE.println(F("no card, or no PLAN.TXT on it"));
}

void loop() {
  const Status status = autopilot.update();
  if (isEnd(status) && CONSOLE) CONSOLE.println(toString(status));
  if (!isRead && plan.update() != WaypointsSource::State::Reading) onRead();
}
