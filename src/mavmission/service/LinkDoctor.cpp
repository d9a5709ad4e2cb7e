#include "LinkDoctor.h"

#include <Arduino.h>
#include <string.h>

#include "../base/Clock.h"
#include "../base/FlashTable.h"
#include "../client/Port.h"
#include "../link/Messages.h"
#include "../link/OwnHeartbeat.h"
#include "../link/Sending.h"

namespace mavmission {
using namespace detail;
namespace {

MAVMISSION_TEXT_TABLE(verdicts, MAVMISSION_VERDICTS)

// How long a heartbeat is waited for [s]. An autopilot sends one every second: after more than three it is not merely
// late.
constexpr uint8_t kListenS = 4;
// The age up to which something counts as heard [s].
constexpr uint8_t kRecentS = 3;
// The silence after which an autopilot counts as gone [s], as in AutopilotFinder.
constexpr uint8_t kLostS = FinderRules::kLostMs / 1000;
// How long the doctor listens at a baud rate: at least two heartbeats [s].
constexpr uint8_t kDwellS = 3;
// The window over which damage and telemetry are counted [s].
constexpr uint8_t kWindowS = 4;
// Damaged frames in a window that make a fault. A good line damages none: the fault lasts until a window has none.
constexpr uint8_t kDamageIsFault = 3;
// Frames in a window that count as telemetry. Fewer are heartbeats, answers, and the TIMESYNC and PARAM_VALUE that an
// ArduPilot sends unasked.
constexpr uint8_t kFramesAreTelemetry = 20;
// Frames of unknown messages, each beginning where the one before ended, that are believed without a checksum. In
// garbage one header in a hundred is followed by another in this way.
constexpr uint8_t kInStep = 8;
constexpr uint8_t kAskEachS = 5;
// Unanswered requests after which the autopilot does not hear us.
constexpr uint8_t kUnanswered = 4;
// Our system id before an autopilot is heard. 1 is the default of autopilots.
constexpr uint8_t kSystemId = 1;
constexpr uint16_t kMarkAbove = 0x4D4D;
constexpr uint8_t kOwnBaud = 255;
constexpr uint8_t kNever = 255;

// Bytes that wait when the receive ring is full: it keeps one place free.
#if defined(ARDUINO_ARCH_ESP32)
constexpr int kFullRing = 256;  // HardwareSerial's, if no other size is set before begin()
#elif defined(ARDUINO_ARCH_RP2040) && !defined(ARDUINO_ARCH_MBED)
constexpr int kFullRing = 256;  // SerialUART's, as beginTelem() asks for; its own are 31, of which it is not known
#elif defined(SERIAL_RX_BUFFER_SIZE)
constexpr int kFullRing = SERIAL_RX_BUFFER_SIZE - 1;
#elif defined(SERIAL_BUFFER_SIZE)
constexpr int kFullRing = SERIAL_BUFFER_SIZE - 1;
#else
constexpr int kFullRing = 63;
#endif

// The rate, or 0 if the board's divider is off by more than 4 %, which is half of what ten bits of a byte tolerate.
#if defined(__AVR__) && defined(F_CPU)
constexpr uint32_t rateOfDivider(uint32_t divider) { return F_CPU / 8 / divider; }
constexpr uint32_t nearestRate(uint32_t baud) {
  // As HardwareSerial::begin() chooses it, at double speed.
  return F_CPU / 4 / baud == 0 ? 0 : rateOfDivider((F_CPU / 4 / baud - 1) / 2 + 1);
}
constexpr uint32_t apart(uint32_t one, uint32_t other) { return one > other ? one - other : other - one; }
constexpr uint32_t ifPossible(uint32_t baud) { return apart(nearestRate(baud), baud) <= baud / 25 ? baud : 0; }
#else
constexpr uint32_t ifPossible(uint32_t baud) { return baud; }
#endif

// The most likely rate first.
const uint32_t kBauds[] PROGMEM = {
    ifPossible(57600),  ifPossible(115200), ifPossible(921600), ifPossible(38400), ifPossible(230400),
    ifPossible(460800), ifPossible(500000), ifPossible(19200),  ifPossible(9600),
};
constexpr uint8_t kBaudCount = sizeof(kBauds) / sizeof(kBauds[0]);

}  // namespace

FlashText toString(Verdict verdict) { return textAt(verdicts::kTexts, static_cast<uint8_t>(verdict)); }

LinkDoctor::LinkDoctor(MissionClient& client)
    : Listener(client, kKeys, kKeyPlaces, take),
      baudIndex_(kOwnBaud),
      quiet_(false),
      askDue_(false),
      roundDone_(false) {
  listenAnew();
}

void LinkDoctor::tryBauds(BaudFunction setBaud, uint32_t baud, void* context) {
  setBaud_ = setBaud;
  baudContext_ = context;
  ownBaud_ = baud;
}

uint32_t LinkDoctor::baud() const { return baudIndex_ == kOwnBaud ? ownBaud_ : fromFlash(&kBauds[baudIndex_]); }

void LinkDoctor::setBaud(uint8_t index) {
  baudIndex_ = index;
  setBaud_(baudContext_, baud());
  listenAnew();
}

void LinkDoctor::tryNextBaud() {
  uint8_t next = baudIndex_ == kOwnBaud ? 0 : baudIndex_ + 1;
  while (next < kBaudCount && (fromFlash(&kBauds[next]) == 0 || fromFlash(&kBauds[next]) == ownBaud_)) ++next;
  if (next == kBaudCount) roundDone_ = true;
  setBaud(next == kBaudCount ? kOwnBaud : next);
}

void LinkDoctor::listenAnew() {
  memset(agesS_, kNever, sizeof(agesS_));
  listenedS_ = 0;
  unanswered_ = 0;
  damage_ = Verdict::Well;
  weighed_ = false;
  beginWindow();
}

void LinkDoctor::beginWindow() {
  const LinkCounters counters = client_.link().counters();
  framesAtWindow_ = counters.frames;
  unknownAtWindow_ = counters.unknownMessages;
  damageAtWindow_ = counters.badChecksums + counters.brokenFrames;
  brokenAtWindow_ = counters.brokenFrames;
  windowS_ = 0;
}

void LinkDoctor::endWindow() {
  const LinkCounters counters = client_.link().counters();
  const uint16_t frames = counters.frames + counters.unknownMessages - framesAtWindow_ - unknownAtWindow_;
  const uint16_t damage = counters.badChecksums + counters.brokenFrames - damageAtWindow_;
  quiet_ = frames < kFramesAreTelemetry;
  if (damage == 0) {
    damage_ = Verdict::Well;
  } else if (damage >= kDamageIsFault) {
    damage_ = agesS_[LateLoop] <= kWindowS ? Verdict::LoopLate : Verdict::Damaged;
  }
  weighed_ = true;
  beginWindow();
}

// --- Receiving

uint8_t LinkDoctor::systemId() const {
  const uint8_t id = client_.link().systemId();
  return id != 0 ? id : kSystemId;
}

bool LinkDoctor::isOurs(const FrameParser& frame) const {
  return frame.systemId() == systemId() && frame.componentId() == client_.link().componentId();
}

void LinkDoctor::take(Listener& listener, const FrameParser& frame) {
  LinkDoctor& self = static_cast<LinkDoctor&>(listener);
  if (self.agesS_[Frame] == kNever) self.beginWindow();  // before: another rate, or a boot loader's text
  self.agesS_[Frame] = 0;
  const uint16_t id = frame.messageId();
  if (id == MAVLINK_MSG_ID_HEARTBEAT) return self.takeHeartbeat(frame);
  if (!self.isFromAutopilot(frame) || id == MAVLINK_MSG_ID_MISSION_CURRENT) return;
  if (wantedKey(id) == nullptr) return;  // a message that we send is no answer when it comes
  const Link& link = self.client_.link();
  if (!frame.isFor(link.systemId(), link.componentId())) return;
  // In MAVLink 1 an acknowledgement has no target.
  if (id == MAVLINK_MSG_ID_COMMAND_ACK &&
      frame.payloadWord(offsetof(mavlink_command_ack_t, command)) != MAV_CMD_REQUEST_MESSAGE) {
    return;
  }
  self.agesS_[Answer] = 0;
  self.unanswered_ = 0;
}

void LinkDoctor::takeHeartbeat(const FrameParser& frame) {
  if (frame.isSigned()) agesS_[Signature] = 0;
  const uint8_t type = frame.payloadByte(offsetof(mavlink_heartbeat_t, type));
  const uint8_t autopilot = frame.payloadByte(offsetof(mavlink_heartbeat_t, autopilot));
  // A finder without an autopilot accepts the heartbeat of any autopilot, and of nobody else.
  AutopilotFinder anyone = AutopilotFinder();
  const bool isAutopilot = anyone.onHeartbeat(frame.systemId(), frame.componentId(), autopilot, type, 0);
  if (isAutopilot) agesS_[Autopilot] = 0;
  if (isFromAutopilot(frame)) return;
  if (!isAutopilot && isOurs(frame)) {
    const uint32_t customMode = frame.payloadLong(offsetof(mavlink_heartbeat_t, custom_mode));
    if (customMode == (uint32_t{kMarkAbove} << 16 | mark_)) agesS_[Echo] = 0;
    return;
  }
  agesS_[Other] = 0;
  speaker_ = Speaker{frame.systemId(), frame.componentId(), type};
}

// --- Sending

void LinkDoctor::sendHeartbeat(uint16_t nowMs) {
  Link& link = client_.link();
  mark_ = nowMs;
  mavlink_heartbeat_t heartbeat;
  makeOwnHeartbeat(heartbeat);
  // By this it is known again on a line that is looped back.
  heartbeat.custom_mode = uint32_t{kMarkAbove} << 16 | mark_;
  // The link sends nothing before it knows an autopilot, unless it has ids of its own: it gets some for this frame.
  const uint8_t own = link.ownSystemId();
  const uint8_t componentId = link.componentId();
  link.setSourceIds(systemId(), componentId);
  link.send(heartbeat);
  link.setSourceIds(own, componentId);
}

void LinkDoctor::ask() {
  mavlink_command_long_t message = mavlink_command_long_t();
  message.command = MAV_CMD_REQUEST_MESSAGE;
  message.param1 = MAVLINK_MSG_ID_AUTOPILOT_VERSION;
  client_.link().send(message);
  askDue_ = false;
  agesS_[Question] = 0;
  ++unanswered_;
}

void LinkDoctor::speak(uint16_t nowMs) {
  const AutopilotFinder& finder = client_.autopilot();
  if (baudIndex_ != kOwnBaud || finder.severalHeard())
    return;  // it would be garbage to the other end, or addressed to nobody
  if (!finder.isFound()) {
    if (client_.link().canSend()) sendHeartbeat(nowMs);
    return;
  }
  if (client_.running() == Status::Transferring) return;
  askDue_ = unanswered_ != 0 || agesS_[Question] >= kAskEachS;
  if (unanswered_ > kUnanswered) unanswered_ = kUnanswered;
}

// --- Time

Verdict LinkDoctor::update() {
  const uint16_t nowMs = static_cast<uint16_t>(millis());
  if (client_.link().stream().available() >= kFullRing) agesS_[LateLoop] = 0;
  const uint16_t elapsedMs = since(secondMs_, nowMs);
  if (elapsedMs >= 1000) {
    secondMs_ = elapsedMs < 2000 ? secondMs_ + 1000 : nowMs;  // the time that a late loop has missed does not count
    second(nowMs);
  }
  if (askDue_ && client_.link().canSend() && client_.autopilot().isFound()) ask();
  return verdict_;
}

void LinkDoctor::second(uint16_t nowMs) {
  for (uint8_t& age : agesS_) {
    if (age != kNever) ++age;
  }
  if (listenedS_ != kNever) ++listenedS_;
  count();
  verdict_ = judge();
  speak(nowMs);
}

// Evaluates the last second.
void LinkDoctor::count() {
  const LinkCounters counters = client_.link().counters();
  if (counters.bytes != bytes_) {
    bytes_ = counters.bytes;
    if (verdict_ == Verdict::NoBytes) listenAnew();
    agesS_[Bytes] = 1;
  }
  const uint16_t unknown = counters.unknownMessages - unknownAtWindow_;
  const uint16_t broken = counters.brokenFrames - brokenAtWindow_;
  if (unknown >= kInStep && broken < unknown / 4) {
    agesS_[Frame] = 1;
    // A sender without heartbeats: the last frame stands for all.
    const FrameParser& frame = client_.link().frame();
    if (agesS_[Autopilot] > kLostS && agesS_[Other] > kLostS && !isOurs(frame)) {
      speaker_ = Speaker{frame.systemId(), frame.componentId(), 0};
    }
  }
  if (agesS_[Frame] <= 1) {
    roundDone_ = false;
    if (verdict_ == Verdict::NoFrames || verdict_ == Verdict::NoFramesAtAnyBaud) {
      listenAnew();
      agesS_[Bytes] = agesS_[Frame] = 1;
    }
  }
  if (++windowS_ == kWindowS) endWindow();
}

// --- The verdict

Verdict LinkDoctor::judge() {
  if (baudIndex_ != kOwnBaud) {
    if (agesS_[Frame] <= kLostS) return Verdict::WrongBaud;
    if (verdict_ != Verdict::WrongBaud) return judgeWithoutFrames();
    setBaud(kOwnBaud);
    return Verdict::Listening;
  }
  if (listenedS_ < kListenS) return roundDone_ ? Verdict::NoFramesAtAnyBaud : Verdict::Listening;
  if (agesS_[Bytes] > kRecentS) {
    roundDone_ = false;
    return Verdict::NoBytes;
  }
  if (agesS_[Frame] > kRecentS) return judgeWithoutFrames();
  if (!weighed_) return Verdict::Listening;
  const Link& link = client_.link();
  const AutopilotFinder& finder = link.finder();
  if (finder.severalHeard()) return Verdict::SeveralAutopilots;
  if (damage_ != Verdict::Well) return damage_;
  if (agesS_[Autopilot] > kLostS) {
    return agesS_[Echo] <= kRecentS && agesS_[Other] > kRecentS ? Verdict::OnlyEcho : Verdict::NoAutopilot;
  }
  if (!finder.isFound()) return agesS_[Autopilot] <= kRecentS ? Verdict::OtherAutopilot : verdict_;
  if (finder.isFrom(link.systemId(), link.componentId())) return Verdict::SameIds;
  if (unanswered_ >= kUnanswered) return agesS_[Signature] <= kRecentS ? Verdict::Signing : Verdict::NotHeard;
  if (agesS_[Answer] == kNever) return Verdict::Listening;
  return quiet_ ? Verdict::Quiet : Verdict::Well;
}

Verdict LinkDoctor::judgeWithoutFrames() {
  if (agesS_[LateLoop] <= kRecentS) return Verdict::LoopLate;  // no baud rate can be recognised then
  if (baudIndex_ == kOwnBaud) {
    if (agesS_[Bytes] > 2) return verdict_;  // the bytes have ended too: the next second will show
    if (setBaud_ == nullptr) return Verdict::NoFrames;
  }
  if (baudIndex_ == kOwnBaud || listenedS_ >= kDwellS) tryNextBaud();
  return roundDone_ ? Verdict::NoFramesAtAnyBaud : Verdict::TryingBauds;
}

}  // namespace mavmission
