#include "../LinkDoctor.h"

#include <Arduino.h>
#include <string.h>

#include "../MissionClient.h"
#include "../base/Clock.h"
#include "../base/FlashTable.h"
#include "../link/Messages.h"
#include "../link/Sending.h"

namespace mavmission {
using namespace detail;
namespace {

MAVMISSION_TEXT_TABLE(verdicts, MAVMISSION_VERDICTS)

// An autopilot that speaks at all sends a heartbeat each second: after three and a bit it is not only late.
constexpr uint8_t kListenS = 4;
// Within which something counts as heard [s].
constexpr uint8_t kRecentS = 3;
// After which an autopilot has gone, as AutopilotFinder has it [s].
constexpr uint8_t kLostS = 5;
// For which a baud rate is listened to: two heartbeats, at the least [s].
constexpr uint8_t kDwellS = 3;
// Damage and telemetry are counted over so long [s].
constexpr uint8_t kWindowS = 4;
// In a window: a line that is in order damages nothing at all. It is a fault until a window has none.
constexpr uint8_t kDamageIsFault = 3;
// In a window; fewer are heartbeats, answers, and the TIMESYNC and PARAM_VALUE of an ArduPilot that nobody asked.
constexpr uint8_t kFramesAreTelemetry = 20;
// Frames of unknown messages that are believed without a checksum, each beginning where the one before ended: what
// looks so in garbage is one header in a hundred.
constexpr uint8_t kInStep = 8;
constexpr uint8_t kAskEachS = 5;
// Not answered so often, the autopilot does not hear us.
constexpr uint8_t kUnanswered = 4;
// Until an autopilot has given us its own. 1 is what autopilots have when they come.
constexpr uint8_t kSystemId = 1;
constexpr uint16_t kMarkAbove = 0x4D4D;
constexpr uint8_t kOwnBaud = 255;
constexpr uint8_t kNever = 255;

// Bytes that wait when the receive ring is full: it keeps one place free.
#if defined(SERIAL_RX_BUFFER_SIZE)
constexpr int kFullRing = SERIAL_RX_BUFFER_SIZE - 1;
#elif defined(SERIAL_BUFFER_SIZE)
constexpr int kFullRing = SERIAL_BUFFER_SIZE - 1;
#else
constexpr int kFullRing = 63;
#endif

// The rate, or 0 if the board's divider is off by more than 4 %: half of what a byte's ten bits bear.
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

// The likeliest first.
const uint32_t kBauds[] PROGMEM = {
    ifPossible(57600),  ifPossible(115200), ifPossible(921600), ifPossible(38400), ifPossible(230400),
    ifPossible(460800), ifPossible(500000), ifPossible(19200),  ifPossible(9600),
};
constexpr uint8_t kBaudCount = sizeof(kBauds) / sizeof(kBauds[0]);

}  // namespace

FlashText toString(Verdict verdict) { return textAt(verdicts::kTexts, static_cast<uint8_t>(verdict)); }

LinkDoctor::LinkDoctor(MissionClient& client)
    : Listener(client, kKeys, static_cast<uint8_t>(KeyIndex::kReceived), take),
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
  const LinkCounters counters = client_.link_.counters();
  framesAtWindow_ = counters.frames;
  unknownAtWindow_ = counters.unknownMessages;
  damageAtWindow_ = counters.badChecksums + counters.brokenFrames;
  brokenAtWindow_ = counters.brokenFrames;
  windowS_ = 0;
}

void LinkDoctor::endWindow() {
  const LinkCounters counters = client_.link_.counters();
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

// --- What is heard

uint8_t LinkDoctor::systemId() const {
  const uint8_t id = client_.link_.systemId();
  return id != 0 ? id : kSystemId;
}

bool LinkDoctor::isOurs(const FrameParser& frame) const {
  return frame.systemId() == systemId() && frame.componentId() == client_.link_.componentId();
}

void LinkDoctor::take(Listener& listener, const FrameParser& frame) {
  LinkDoctor& self = static_cast<LinkDoctor&>(listener);
  if (self.agesS_[Frame] == kNever) self.beginWindow();  // what came before was another rate, or a boot loader's text
  self.agesS_[Frame] = 0;
  const uint16_t id = frame.messageId();
  if (id == MAVLINK_MSG_ID_HEARTBEAT) return self.takeHeartbeat(frame);
  if (!self.isFromAutopilot(frame) || id == MAVLINK_MSG_ID_MISSION_CURRENT) return;
  const Link& link = self.client_.link_;
  if (!frame.isFor(link.systemId(), link.componentId())) return;
  // MAVLink 1 does not say whom an acknowledgement is for.
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
  // A finder that knows nobody takes the heartbeat of any autopilot, and no other.
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

// --- What is said

void LinkDoctor::sendHeartbeat(uint16_t nowMs) {
  Link& link = client_.link_;
  mark_ = nowMs;
  mavlink_heartbeat_t heartbeat = mavlink_heartbeat_t();
  heartbeat.custom_mode = uint32_t{kMarkAbove} << 16 | mark_;
  heartbeat.type = MAV_TYPE_ONBOARD_CONTROLLER;
  heartbeat.autopilot = MAV_AUTOPILOT_INVALID;
  heartbeat.system_status = MAV_STATE_ACTIVE;
  heartbeat.mavlink_version = 3;
  // The link says nothing before it knows an autopilot, unless it has ids of its own: it is lent some for this frame.
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
  client_.link_.send(message);
  askDue_ = false;
  agesS_[Question] = 0;
  ++unanswered_;
}

void LinkDoctor::speak(uint16_t nowMs) {
  const AutopilotFinder& finder = client_.link_.finder();
  if (baudIndex_ != kOwnBaud || finder.severalHeard())
    return;  // garbage to whoever is there, or for nobody in particular
  if (!finder.isFound()) {
    if (client_.link_.canSend()) sendHeartbeat(nowMs);
    return;
  }
  if (client_.isBusy() && client_.status() == Status::Transferring) return;
  askDue_ = unanswered_ != 0 || agesS_[Question] >= kAskEachS;
  if (unanswered_ > kUnanswered) unanswered_ = kUnanswered;
}

// --- Time

Verdict LinkDoctor::update() {
  const uint16_t nowMs = static_cast<uint16_t>(millis());
  if (client_.link_.stream().available() >= kFullRing) agesS_[LateLoop] = 0;
  const uint16_t elapsedMs = since(secondMs_, nowMs);
  if (elapsedMs >= 1000) {
    secondMs_ = elapsedMs < 2000 ? secondMs_ + 1000 : nowMs;  // what a late loop has not listened to does not count
    second(nowMs);
  }
  if (askDue_ && client_.link_.canSend() && client_.link_.finder().isFound()) ask();
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

// What this second has brought.
void LinkDoctor::count() {
  const LinkCounters counters = client_.link_.counters();
  if (counters.bytes != bytes_) {
    bytes_ = counters.bytes;
    if (verdict_ == Verdict::NoBytes) listenAnew();
    agesS_[Bytes] = 1;
  }
  const uint16_t unknown = counters.unknownMessages - unknownAtWindow_;
  const uint16_t broken = counters.brokenFrames - brokenAtWindow_;
  if (unknown >= kInStep && broken < unknown / 4) {
    agesS_[Frame] = 1;
    // Somebody who sends no heartbeats: the last frame stands for all.
    const FrameParser& frame = client_.link_.frame();
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
  const Link& link = client_.link_;
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
  if (agesS_[LateLoop] <= kRecentS) return Verdict::LoopLate;  // no rate could be told so
  if (baudIndex_ == kOwnBaud) {
    if (agesS_[Bytes] > 2) return verdict_;  // they have ended as well: another second will show
    if (setBaud_ == nullptr) return Verdict::NoFrames;
  }
  if (baudIndex_ == kOwnBaud || listenedS_ >= kDwellS) tryNextBaud();
  return roundDone_ ? Verdict::NoFramesAtAnyBaud : Verdict::TryingBauds;
}

}  // namespace mavmission
