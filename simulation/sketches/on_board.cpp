// The board's side of tools/bench, which makes a sketch of it: does what lines on CONSOLE tell it, over TELEM, and says
// what came of it. A line is a word and what it needs; the answer to each ends with "ok". docs/bench.md says how it
// is used.
#define CONSOLE_RX 10  // an Uno and a Nano need it to read from CONSOLE
#include <Arduino.h>
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

MissionClient autopilot(TELEM);

#define TEXT_OF(what) TEXT_OF_IT(what)
#define TEXT_OF_IT(what) #what

static uint32_t longestLoopUs;
static uint16_t stallMs;    // for so long loop() is to stand still, once
static MissionItem own[3];  // what the console has given

// As item_of() in tools/benching/scenarios.py.
static bool itemOfPlan(void*, uint16_t index, MissionItem& item) {
  item = waypoint(47.3977420_deg + Degrees::fromE7(100) * index, 8.5455970_deg, 20_m);
  return true;
}

static void tellAbout() {
  CONSOLE.print(F("about MavMission " MAVMISSION_VERSION ", Arduino " TEXT_OF(ARDUINO) ", compiler " __VERSION__));
#ifdef ARDUINO_BOARD
  CONSOLE.print(F(", board " ARDUINO_BOARD));
#elif defined(ARDUINO_AVR_MEGA2560)
  CONSOLE.print(F(", board AVR_MEGA2560"));
#endif
#ifdef F_CPU
  CONSOLE.print(F(", clock "));
  CONSOLE.print(static_cast<uint32_t>(F_CPU));
#endif
#ifdef SERIAL_RX_BUFFER_SIZE
  CONSOLE.print(F(", receive buffer "));
  CONSOLE.print(SERIAL_RX_BUFFER_SIZE);
#endif
  CONSOLE.println();
}

static void tellNumber(const __FlashStringHelper* name, uint32_t value) {
  CONSOLE.print(name);
  CONSOLE.print(value);
}

static void tellState() {
  const LinkCounters counters = autopilot.counters();
  tellNumber(F("state bytes="), counters.bytes);
  tellNumber(F(" skipped="), counters.bytesSkipped);
  tellNumber(F(" frames="), counters.frames);
  tellNumber(F(" bad="), counters.badChecksums);
  tellNumber(F(" lost="), counters.framesLost);
  tellNumber(F(" found="), autopilot.hasAutopilot());
  tellNumber(F(" aboard="), static_cast<uint8_t>(autopilot.aboard()));
  tellNumber(F(" loop="), longestLoopUs);
  CONSOLE.println();
  longestLoopUs = 0;
}

static uint8_t fromHex(char digit) { return digit <= '9' ? digit - '0' : digit - 'a' + 10; }

// "item 2 0000803f...": an item's bytes in the order of its struct, low ones first.
static void takeItem(const char* words) {
  uint8_t bytes[33];
  const uint8_t number = static_cast<uint8_t>(*words - '0') % 3;
  if (strlen(words) < 2 + 2 * sizeof(bytes)) return;
  for (uint8_t i = 0; i < sizeof(bytes); ++i) {
    bytes[i] = static_cast<uint8_t>(fromHex(words[2 + 2 * i]) << 4 | fromHex(words[3 + 2 * i]));
  }
  memcpy(&own[number], bytes, sizeof(bytes));
}

static bool isWord(const char* line, const char* word) { return strncmp(line, word, strlen(word)) == 0; }

static void obey(const char* line) {
  if (isWord(line, "about")) {
    tellAbout();
  } else if (isWord(line, "state")) {
    tellState();
  } else if (isWord(line, "upload ")) {
    autopilot.upload(fromFunction(itemOfPlan, atoi(line + 7)));
  } else if (isWord(line, "verify ")) {
    autopilot.verify(fromFunction(itemOfPlan, atoi(line + 7)));
  } else if (isWord(line, "ensure ")) {
    autopilot.ensure(fromFunction(itemOfPlan, atoi(line + 7)));
  } else if (isWord(line, "item ")) {
    takeItem(line + 5);
  } else if (isWord(line, "own")) {
    autopilot.upload(inRam(own));
  } else if (isWord(line, "check")) {
    autopilot.verify(inRam(own));
  } else if (isWord(line, "stall ")) {
    stallMs = static_cast<uint16_t>(atoi(line + 6));
  } else if (isWord(line, "clear")) {
    autopilot.clear();
  } else if (isWord(line, "cancel")) {
    autopilot.cancel();
  } else {
    CONSOLE.println(F("what?"));
    return;
  }
  CONSOLE.println(F("ok"));
}

static void listen() {
  static char line[80];
  static uint8_t length;
  while (CONSOLE.available() > 0) {
    const char c = static_cast<char>(CONSOLE.read());
    if (c == '\r') continue;
    if (c != '\n') {
      if (length + 1u < sizeof(line)) line[length++] = c;
      continue;
    }
    line[length] = 0;
    length = 0;
    obey(line);
  }
}

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  CONSOLE.println(F("ready"));
}

void loop() {
  static uint32_t lastUs = micros();
  const uint32_t nowUs = micros();
  if (nowUs - lastUs > longestLoopUs) longestLoopUs = nowUs - lastUs;
  lastUs = nowUs;
  listen();
  if (stallMs != 0) {
    delay(stallMs);
    stallMs = 0;
  }
  const Status status = autopilot.update();
  if (!isEnd(status)) return;
  CONSOLE.print(F("ended "));
  CONSOLE.print(static_cast<uint8_t>(status));
  CONSOLE.print(' ');
  CONSOLE.println(toString(status));
}
