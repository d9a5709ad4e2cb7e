// A whole MissionClient on a line where anything may happen, driven by the bytes of the input: what is received, how
// time passes, what the sketch asks for, what the stream takes.
//
// What must hold, whatever that is:
// - update() reads no more bytes than MAVMISSION_BYTES_PER_UPDATE, and writes no more than the stream said it takes;
// - an upload is Accepted only if it was announced, and the bytes that came since it was asked for (and those that the
//   parser may still hold then) hold either a request for its last item and behind it an ACK with MAV_MISSION_ACCEPTED,
//   or, once they were asked for, the right number of items and each of them as it was meant; all right to the
//   checksum, from the autopilot, for us and for a mission. uploadWithoutReadback() takes only the first, upload(plan,
//   Verified) only the second. verify() ends with Verified only by the second, too;
// - what is written is whole frames, one behind the other, each with the next sequence number; a message of the
// sketch's
//   own is among them as it was given;
// - nothing is announced to an autopilot that is refused for being armed;
// - start() is Done only for an autopilot that was heard to be armed, in its mission mode, since it was asked for, and
// to
//   be at an item; it sends nothing that forces;
// - items that are done never go back, and are never more than there are;
// - listeners are told of nothing that they did not ask for, and of no text without an end;
// - when nothing comes any more, an operation ends in the time that its limits add up to.
#include <Arduino.h>
#include <string.h>

#include <deque>
#include <vector>

#include "Evidence.h"
#include "Frames.h"
#include "MavMission.h"
#include "MemoryStream.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

const uint16_t kWaitingLimitS = 10;
const uint16_t kBackOffLimitS = 20;
const long kMostHeldBack = 66;  // bytes that the parser keeps of a frame

const MissionItem kPlan[] = {
    takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m), changeSpeed(5_mps),
    jump(1, 2),    waypoint(-35.3614500_deg, 149.1652374_deg, 20_m), returnToLaunch(),
};
const uint8_t kPlanItems = sizeof(kPlan) / sizeof(*kPlan);

const MessageKey kListened[] = {messageKey(24, 24, 30), messageKey(MAVLINK_MSG_ID_MISSION_ACK, 153, 3)};

// Longer than the outbox: a message of 254 bytes that each MAVLink has, and one of 255 that only MAVLink 2 has.
const Bytes kLongPayload(255, 0xA5);
const OutgoingMessage kLong[] = {{MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL, 84, 254, 254, kLongPayload.data()},
                                 {MAVLINK_MSG_ID_LOGGING_DATA, 193, 255, 255, kLongPayload.data()}};

class Line : public MemoryStream {
 public:
  Bytes heard;  // since an operation was asked for, and a few before
  int read() override {
    const int byte = MemoryStream::read();
    if (byte >= 0) heard.push_back(static_cast<uint8_t>(byte));
    return byte;
  }
  // What is written takes room.
  using MemoryStream::write;
  size_t write(const uint8_t* bytes, size_t size) override {
    const size_t taken = MemoryStream::write(bytes, size);
    if (room > 0) room = static_cast<size_t>(room) > taken ? room - static_cast<int>(taken) : 0;
    return taken;
  }
};

// The last operation about a plan.
struct Asked {
  enum class Kind : uint8_t { Nothing, InDoubt, Verified, ByAnswer, Part, Verification };
  Kind kind = Kind::Nothing;
  uint16_t count = 0;  // items of the plan
  uint16_t first = 0, part = 0;
  bool looksFirst = false;  // ensure()
  bool isUpload() const { return kind != Kind::Nothing && kind != Kind::Verification; }
};

class Session {
 public:
  Session() : client_(line_), follower_(client_), listener_(client_, kListened, message, this) {
    client_.setAutopilotTimeout(kWaitingLimitS);
    client_.onProgress(progress, this);
    follower_.onCurrent(item);
    follower_.onReached(item);
    follower_.onText(text);
    setMillis(nowMs_);
  }

  void run(Input input) {
    while (!input.isOver()) step(input);
    finish();
  }

 private:
  static void progress(void* context, uint16_t done, uint16_t total) {
    Session& session = *static_cast<Session*>(context);
    demand(done > session.done_ && done <= total, "progress went back or beyond the end");
    session.done_ = done;
  }

  static void item(void*, uint16_t item) { demand(item != MissionClient::kNoItem, "no item was said to be flown"); }

  static void text(void*, uint8_t, const char* text) { demand(strnlen(text, 51) <= 50, "a text is too long"); }

  static void message(void*, const ReceivedMessage& message) {
    demand(message.id == kListened[0].id || message.id == kListened[1].id, "a message came that nobody asked for");
    demand(message.length <= MAVMISSION_MAX_PAYLOAD, "a message came that is longer than what is kept");
    uint8_t copy[MAVMISSION_MAX_PAYLOAD];
    message.copyTo(copy, sizeof(copy));
    demand(memcmp(copy, message.payload, message.length) == 0, "a message came and is not what it is");
  }

  void step(Input& input) {
    const uint8_t what = input.next();
    switch (what % 32) {
      case 0:
      case 1: return wait(input.next());
      case 2:
        for (uint8_t n = input.next() % 40; n != 0; --n) wait(50);
        return;
      case 3:
        for (uint8_t n = input.next() % 64; n != 0; --n) line_.toRead.push_back(input.next());
        return;
      case 4:
      case 5: {
        const uint8_t kinds[] = {3, 12, 0, 8};
        // In the mission mode of a copter, or of PX4, in one of four.
        const uint8_t kind = kinds[input.next() % 4];
        ++heartbeats_;
        FrameParts heartbeat = heartbeatParts(kind, what >= 128 ? 0x80 : 0);
        if ((what & 0x60) == 0x60) {
          const uint32_t mode = kind == 12 ? 0x04040000u : what & 1 ? 4 : 3;
          memcpy(heartbeat.payload.data(), &mode, sizeof(mode));
        }
        return bring(heartbeat, input);
      }
      case 6:
      case 7:
      case 8: {
        const uint8_t sequence = input.next() % (kPlanItems + 3);
        FrameParts parts = requestParts(sequence, what >= 128 ? 0 : kAutopilot, kClient, what >= 224);
        if (what & 64) {
          parts.messageId = 40;
          parts.crcExtra = 230;
        }
        return bring(parts, input);
      }
      case 9:
      case 10: {
        const uint8_t result = input.next();
        const uint32_t opaqueId = what >= 192 ? input.next() * 0x01010101u : 0;
        return bring(ackParts(what & 32 ? 0 : result % 20, kAutopilot, kClient, result >= 224, opaqueId), input);
      }
      case 11: {
        const uint8_t how = input.next();
        return upload(how, how / 7 % 4 == 3 ? input.next() : uint8_t(0));
      }
      case 12:
        client_.cancel();
        if (uploading_) uploading_ = client_.isBusy();
        return;
      case 13: room_ = input.next() % 70; return;
      case 14: line_.takes = 1 + input.next() % 64; return;
      case 15: return other(input.next());
      case 16:
      case 17:
      case 18: return answer(input);
      case 19: {
        const uint8_t to = input.next();
        return bring(altered(countParts(to % (kPlanItems + 3)), to >= 128 ? input.next() : uint8_t(0)), input);
      }
      case 20: {
        const uint8_t sequence = input.next();
        return bring(altered(itemInPlan(sequence % (kPlanItems + 2)), input.next()), input);
      }
      case 21:
        if (!client_.isBusy()) client_.retryWhenBusy(input.next() % kBackOffLimitS);
        return;
      case 22:
        if (!client_.isBusy()) client_.allowWhileArmed(what >= 128);
        return;
      case 23: client_.sendMessage(kLong[what >= 128 ? 1 : 0]); return;
      case 24: return uploadAgain();
      case 25: {
        const uint16_t current = input.next();
        const uint16_t total = what >= 128 ? 6 : 0;
        return bring(currentParts(current, total, static_cast<uint8_t>(current % 6), current * 7u), input);
      }
      case 26: {
        mavlink_mission_item_reached_t message = {input.next()};
        return bring(FrameParts(MAVLINK_MSG_ID_MISSION_ITEM_REACHED, message), input);
      }
      case 27: {
        mavlink_statustext_t message = mavlink_statustext_t();
        if (what >= 128) memcpy(message.text, "Mission rejected", 16);
        memset(message.text + 16, 'x', input.next() % 35);
        return bring(FrameParts(MAVLINK_MSG_ID_STATUSTEXT, message), input);
      }
      case 28: return bring(FrameParts(24, Bytes(what >= 128 ? 52 : 30, input.next()), 24), input);
      case 29:  // the other autopilot of two, which is not listened to
        other_ = !other_;
        return;
      default:
        for (uint8_t n = 4; n != 0; --n) wait(what);
        return;
    }
  }

  void begin(const Asked& asked) {
    asked_ = asked;
    if (asked.isUpload()) again_ = client_.status() == Status::BadRange ? Asked() : asked;
    if (asked.kind ==
        Asked::Kind::Verification) {  // its plan is the one that is uploaded next, as the last one was proven
      again_.count = asked.count;
      const bool isProofKept = again_.kind == Asked::Kind::ByAnswer || again_.kind == Asked::Kind::Verified;
      if (!isProofKept) again_.kind = Asked::Kind::InDoubt;
    }
    uploading_ = asked.isUpload();
    isStart_ = false;
    done_ = 0;
    hasBackedOff_ = false;
    // The parser may hold the latest bytes still, within a frame that was cut off, and find a frame among them later.
    Bytes& heard = line_.heard;
    if (heard.size() > static_cast<size_t>(kMostHeldBack)) heard.erase(heard.begin(), heard.end() - kMostHeldBack);
    written_ = line_.written.size();
    isHeldBack_ = !client_.isSent();
  }

  void upload(uint8_t how, uint8_t which) {
    const bool wasBusy = client_.isBusy();
    Asked asked;
    asked.count = how % (kPlanItems + 1);
    const ItemSource plan = inRam(kPlan, asked.count);
    Status status;
    switch (how / 7 % 4) {
      case 0:
        asked.kind = Asked::Kind::InDoubt;
        asked.looksFirst = which >= 192;
        status = asked.looksFirst ? client_.ensure(plan) : client_.upload(plan);
        break;
      case 1:
        asked.kind = Asked::Kind::Verified;
        status = client_.upload(plan, Readback::Always);
        break;
      case 2:
        asked.kind = Asked::Kind::ByAnswer;
        status = client_.uploadWithoutReadback(plan);
        break;
      default:
        asked.kind = Asked::Kind::Part;
        asked.first = which % 8;
        asked.part = which / 8 % 8;
        status = client_.uploadPartial(plan, asked.first, asked.part);
    }
    demand(wasBusy == (status == Status::Busy), "an operation was begun while another one ran, or refused without one");
    if (!wasBusy) begin(asked);
  }

  void uploadAgain() {
    const bool wasBusy = client_.isBusy();
    const Status status = client_.uploadAgain();
    demand(wasBusy == (status == Status::Busy), "an operation was begun while another one ran, or refused without one");
    if (wasBusy) return;
    Asked asked = again_;
    asked.looksFirst = false;
    const bool isRefused = status == Status::SourceRefused;
    demand(asked.kind != Asked::Kind::Nothing || isRefused, "a plan was uploaded that was never given");
    begin(asked);
  }

  // What a sketch may ask for besides. None of it may end with Accepted.
  void other(uint8_t what) {
    if (client_.isBusy()) {
      demand(client_.clear() == Status::Busy, "an operation was begun while another one ran");
      return;
    }
    Asked asked;
    if (what % 6 == 1) asked.kind = Asked::Kind::Verification;
    asked.count = kPlanItems;
    begin(asked);
    switch (what % 6) {
      case 0: client_.clear(what & 64 ? PlanType::All : PlanType::Mission); return;
      case 1: client_.verify(inRam(kPlan, kPlanItems)); return;
      case 2: client_.download(toRam(space_)); return;
      case 3: client_.setCurrentItem(what); return;
      case 4: client_.arm(); return;
      case 5:
        isStart_ = true;
        client_.start(what / 6 % 8);
        return;
    }
  }

  // How = 0: as it is; otherwise a bit of its payload is another.
  static FrameParts altered(FrameParts parts, uint8_t how) {
    if (how != 0) parts.payload[(how - 1u) % parts.payload.size()] ^= static_cast<uint8_t>(1 << how % 8);
    return parts;
  }

  FrameParts itemInPlan(uint16_t sequence) const {
    return itemParts(sequence, sequence < meant_.size() ? meant_[sequence] : kPlan[1]);
  }

  // What an autopilot says to the client's last message, right or altered.
  void answer(Input& input) {
    for (FrameIn frame; frame = nextWritten(answered_), frame.isRight;) {
      answered_ = frame.end;
      if (frame.parts.messageId == MAVLINK_MSG_ID_HEARTBEAT || frame.size > 100) continue;
      said_ = frame.parts.messageId;
      saidPayload_ = frame.parts.payload;
    }
    const uint8_t how = input.next();
    const uint16_t sequence = static_cast<uint16_t>(saidPayload_[0] | saidPayload_[1] << 8);
    switch (said_) {
      case MAVLINK_MSG_ID_MISSION_COUNT:
        if (sequence != 0) return bring(altered(requestParts(0), how), input);
        return bring(altered(ackParts(0), how), input);
      case MAVLINK_MSG_ID_MISSION_WRITE_PARTIAL_LIST: return bring(altered(requestParts(sequence), how), input);
      case MAVLINK_MSG_ID_MISSION_ITEM_INT: {
        const uint16_t item = static_cast<uint16_t>(saidPayload_[28] | saidPayload_[29] << 8);
        if (item + 1u == behindLast()) return bring(altered(ackParts(0), how), input);
        return bring(altered(requestParts(item + 1), how), input);
      }
      case MAVLINK_MSG_ID_MISSION_REQUEST_LIST:
        return bring(altered(countParts(static_cast<uint16_t>(meant_.size()), PlanType::Mission,
                                        meant_.size() % 2 ? nameOf(meant_) : 0),
                             how),
                     input);
      case MAVLINK_MSG_ID_MISSION_REQUEST:
      case MAVLINK_MSG_ID_MISSION_REQUEST_INT: return bring(altered(itemInPlan(sequence), how), input);
      case MAVLINK_MSG_ID_MISSION_SET_CURRENT: return bring(altered(currentParts(sequence, 0, 0), how), input);
      case MAVLINK_MSG_ID_COMMAND_LONG: {
        const uint16_t command = messageIn<mavlink_command_long_t>(saidPayload_).command;
        const bool isQuestion = command == MAV_CMD_REQUEST_MESSAGE;
        return bring(altered(isQuestion ? currentParts(1, 0) : commandAckParts(command, 0), how), input);
      }
      default: return bring(altered(ackParts(0), how), input);
    }
  }

  // The frame that was written at this place, with its end.
  FrameIn nextWritten(size_t at) const {
    FrameIn frame = frameAt(line_.written, behindFill(line_.written, at));
    frame.end = behindFill(line_.written, at) + frame.size;
    return frame;
  }

  // The wire item behind those that are uploaded.
  uint16_t behindLast() const {
    if (asked_.kind != Asked::Kind::Part) return static_cast<uint16_t>(meant_.size());
    const size_t home = meant_.size() - asked_.count;
    return static_cast<uint16_t>(home + asked_.first + asked_.part);
  }

  void bring(FrameParts parts, Input& input) {
    const uint8_t how = input.next();
    parts.sequence = sequence_++;
    if (other_) parts.systemId = 2;
    if (how & 1) {
      parts.version = 1;
      const mavlink_msg_entry_t* const entry = mavlink_get_msg_entry(parts.messageId);
      if (parts.payload.size() > entry->min_msg_len) parts.payload.resize(entry->min_msg_len);
    } else {
      while (parts.payload.size() > 1 && parts.payload.back() == 0) parts.payload.pop_back();
      if (how & 2) parts.incompatibility = 1;
    }
    Bytes frame = packed(parts);
    if (how >= 192) frame[how % frame.size()] = static_cast<uint8_t>(frame[how % frame.size()] ^ (1 << how % 8));
    if (how >= 128 && how < 160) frame.resize(how % frame.size());
    line_.bring(frame);
  }

  void wait(uint32_t ms) {
    nowMs_ += ms;
    setMillis(nowMs_);
    const size_t read = line_.bytesRead, written = line_.written.size();
    line_.room = room_;
    const Status before = client_.status();
    const Status status = client_.update();
    demand(line_.bytesRead - read <= MAVMISSION_BYTES_PER_UPDATE, "update() read more than it may");
    if (room_ > 0)
      demand(line_.written.size() - written <= static_cast<size_t>(room_), "more was written than there was room");
    demand(client_.itemsDone() <= client_.itemsTotal(), "more items are done than there are");
    demand(client_.failedItem() == MissionClient::kNoItem || !uploading_ || client_.failedItem() < asked_.count,
           "an item failed that is not in the plan");
    demand(client_.isBusy() || status == Status::Idle || isEnd(status), "an operation that is over was said to run");
    if (client_.status() == Status::BackingOff) hasBackedOff_ = true;
    if (client_.isBusy() && client_.status() == Status::Transferring && before != Status::Transferring) {
      firmware_ = client_.firmware();
      meant_ = wireItems(kPlan, asked_.count, firmware_);
    }
    if (isEnd(status)) judge(status);
  }

  // The frames that the operation has written. A stream that takes nothing may have held back one of the operation
  // before, which is then written first.
  Bytes writtenByOperation() const {
    size_t from = written_;
    if (isHeldBack_) {
      from = 0;
      while (from <= written_ && nextWritten(from).isRight) from = nextWritten(from).end;
      if (from <= written_) from = line_.written.size();  // it is not whole yet
    }
    return Bytes(line_.written.begin() + static_cast<long>(from), line_.written.end());
  }

  // How an operation may end.
  void judge(Status status) {
    const Bytes written = writtenByOperation();
    uint16_t announced = static_cast<uint16_t>(meant_.size());
    const bool isAnnounced = announces(written, announced);
    if (status == Status::Accepted) {
      demand(uploading_, "what was no upload was accepted");
      // (Of an empty plan nothing is asked for. Its COUNT may be held back by a stream that takes nothing.)
      demand(isAnnounced || asked_.count == 0, "accepted, though it was not announced");
      demand(asked_.count == 0 || announced == meant_.size(), "accepted, though another plan was announced");
      const bool isAnswered = holdsAnswer(line_.heard, asked_.count == 0, static_cast<uint16_t>(behindLast() - 1));
      const bool isRead = holdsReading(line_.heard, written, meant_, firmware_);
      demand(asked_.kind != Asked::Kind::ByAnswer || isAnswered, "accepted, though the autopilot has not said so");
      demand(asked_.kind != Asked::Kind::Verified || isRead, "accepted, though it was not read back as it was meant");
      const bool isNamed = firmware_ == Firmware::Px4 && holdsName(line_.heard, meant_);  // in the read-back's COUNT
      demand(isAnswered || isRead || isNamed, "accepted, though neither the autopilot said so nor it was read back");
      demand(client_.itemsDone() == asked_.count, "accepted, though not every item is done");
    }
    if (isStart_ && status == Status::Done) {
      demand(client_.isArmed() && client_.isInMode(FlightMode::Auto), "it is started, and does not fly its mission");
      demand(holdsMessage(line_.heard, MAVLINK_MSG_ID_HEARTBEAT), "it is started, though no heartbeat showed it");
      demand(holdsMessage(line_.heard, MAVLINK_MSG_ID_MISSION_CURRENT), "it is started, and did not say from where");
      demand(client_.aboard() == Aboard::OurPlan, "what is started is not our plan");
    }
    if (client_.startArming() == StartArming::Disarmed) {
      demand(holdsMessage(line_.written, MAVLINK_MSG_ID_COMMAND_LONG), "it was disarmed without a command");
    }
    if (status == Status::AlreadyAboard) {
      demand(asked_.looksFirst, "what did not look found its plan");
      const bool isNamed = firmware_ == Firmware::Px4 && holdsName(line_.heard, meant_);
      demand(isNamed || holdsReading(line_.heard, written, meant_, firmware_), "found, and neither named nor read");
      demand(!isAnnounced || hasBackedOff_, "found, though it was uploaded");
      demand(client_.aboard() == Aboard::OurPlan, "found, and aboard() does not know it");
    }
    if (status == Status::Verified) {
      demand(asked_.kind == Asked::Kind::Verification, "what was no verification ended as one");
      demand(holdsReading(line_.heard, written, meant_, firmware_),
             "verified, though what was read is not what was meant");
    }
    if (status == Status::Armed && uploading_ && !hasBackedOff_) {
      demand(!isAnnounced, "a plan was announced to an armed autopilot that is refused for it");
    }
    uploading_ =
        uploading_ && client_.isBusy();  // what was cancelled is told by the next update(), when another may run
  }

  // Silence. The longest upload: waiting, checking, the transfer's own limit, back-offs. Others are
  // shorter.
  void finish() {
    room_ = MemoryStream::kAlwaysRoom;
    line_.takes = 1000;
    const uint32_t limitMs =
        1000u * (kWaitingLimitS + 120 + 2 * (kPlanItems + 1) + 40 + kBackOffLimitS + kWaitingLimitS);
    const uint32_t beganMs = nowMs_;
    while (client_.isBusy() || !line_.toRead.empty()) {
      wait(50);
      demand(nowMs_ - beganMs <= limitMs, "an operation does not end");
    }
    for (int i = 0; i < 20 && !client_.isSent(); ++i) wait(50);
    wait(50);
    wait(50);
    for (int i = 0; i < 20 && !client_.isSent(); ++i) wait(1);  // a heartbeat may have begun in the last one
    checkWritten();
  }

  void checkWritten() {
    const Bytes& bytes = line_.written;
    size_t at = 0;
    unsigned cut = 0;  // a frame for an autopilot that is another one since a heartbeat leaves no further
    for (uint8_t sequence = 0; at < bytes.size(); ++sequence) {
      const size_t from = at;
      FrameIn frame;
      for (at = behindFill(bytes, at); at < bytes.size(); ++at) {
        frame = frameAt(bytes, at);
        if (frame.isRight || isSpoilt(bytes, at, frame.size)) break;
      }
      if (at == bytes.size()) {
        demand(++cut <= heartbeats_, "what was written is no frame");
        break;
      }
      const uint8_t leftOut = static_cast<uint8_t>(frame.parts.sequence - sequence);
      cut += leftOut;
      sequence = static_cast<uint8_t>(sequence + leftOut);
      demand(cut <= heartbeats_, "a sequence number was left out or used twice");
      demand(leftOut != 0 || at == behindFill(bytes, from), "what was written is no frame");
      for (const OutgoingMessage& own : kLong) {
        const bool isOther = memcmp(frame.parts.payload.data(), kLongPayload.data(), own.length) != 0;
        demand(frame.parts.messageId != own.id || !isOther, "a message of the sketch's own was written as another");
      }
      if (frame.isRight && frame.parts.messageId == MAVLINK_MSG_ID_COMMAND_LONG) {
        const mavlink_command_long_t command = messageIn<mavlink_command_long_t>(frame.parts.payload);
        const bool arms = command.command == MAV_CMD_COMPONENT_ARM_DISARM;
        demand(!arms || isZero(command.param2), "it arms or disarms by force");
      }
      at += frame.size;
    }
  }

  // A frame that was no longer true when its last byte left, which is therefore another one.
  static bool isSpoilt(Bytes bytes, size_t at, size_t size) {
    if (size == 0) return false;
    bytes[at + size - 1] ^= 0xFF;
    return frameAt(bytes, at).isRight;
  }

  static bool isZero(float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof(bits));
    return bits == 0;
  }

  Line line_;
  MissionClient client_;
  MissionFollower follower_;
  MessageListener listener_;
  MissionItem space_[kPlanItems];
  uint32_t nowMs_ = 0xFFFFF000;           // it wraps soon, in 16 bits and in 32
  int room_ = MemoryStream::kAlwaysRoom;  // at the beginning of each update()
  uint8_t sequence_ = 0;
  bool other_ = false;       // frames are another system's
  unsigned heartbeats_ = 0;  // in the input so far
  bool uploading_ = false;
  bool isStart_ = false;       // the last operation is start()
  bool hasBackedOff_ = false;  // it has backed off
  Asked asked_;
  Asked again_;                     // what uploadAgain() uploads
  Firmware firmware_ = Firmware();  // that the transfer began with
  WireItems meant_;                 // and the plan for it
  size_t written_ = 0;              // bytes written before the operation
  bool isHeldBack_ = false;         // a frame was on its way out then
  size_t answered_ = 0;             // bytes written before the first frame that answer() has not looked at
  uint32_t said_ = 0xFFFFFFFF;      // the client's last message that is answered
  Bytes saidPayload_ = Bytes(255);
  uint16_t done_ = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Session().run(Input{data, size});
  return 0;
}
