// A loop with nothing to do most of the time, of several rounds to a turn: what it waits for is a byte, the time, a
// pin, a register that no interrupt tells of, or a variable that the test sets; and a timer whose mode it changes.
#include <Arduino.h>

volatile uint8_t asked, timed, tuned;
uint16_t heard, tens, pressed, answered, polled, ticks;
volatile uint16_t overflows;

static uint32_t lastMs;

static void look() {
  if (Serial1.available()) {
    heard += Serial1.read();
    Serial1.write(static_cast<uint8_t>(heard));
  }
}

static void count() {
  const uint32_t now = millis();
  if (now - lastMs >= 10) {
    lastMs = now;
    ++tens;
  }
}

static void feel() {
  static bool wasDown;
  const bool isDown = digitalRead(2) == LOW;  // a pin with a timer, whose mode digitalRead() sets
  if (isDown && !wasDown) ++pressed;
  wasDown = isDown;
  digitalWrite(9, isDown ? HIGH : LOW);
}

static void answer() {
  static uint8_t roundsLeft;
  if (asked) roundsLeft = 100;
  asked = 0;
  if (roundsLeft > 0 && --roundsLeft == 0) ++answered;
}

static void poll() {
  if (UCSR2A & 1 << RXC2) polled += UDR2;
}

static void tick() {
  static uint32_t lastUs;
  if (!timed || micros() - lastUs < 300) return;
  lastUs = micros();
  ++ticks;
}

ISR(TIMER4_OVF_vect) { ++overflows; }

// Each write of another mode changes when the timer overflows.
static void tune() {
  if (tuned) TCCR4A ^= 1 << WGM40;
}

static void (*const parts[])() = {look, count, feel, answer, poll, tick, tune};

void setup() {
  pinMode(2, INPUT_PULLUP);
  pinMode(9, OUTPUT);
  TIMSK4 = 1 << TOIE4;
  Serial1.begin(115200);
  UBRR2 = 16;  // 115200 baud, with U2X2
  UCSR2A = 1 << U2X2;
  UCSR2B = 1 << RXEN2;
}

void loop() {
  for (uint8_t n = 0; n < sizeof parts / sizeof *parts; ++n) parts[n]();
}
