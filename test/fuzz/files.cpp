// PlanFiles beside a model of ArduPilot's FTP, on a line where anything may happen: the bytes of the input say what is
// lost, repeated, delayed or damaged, when another client speaks, when the autopilot restarts, what the sketch asks
// for. The model knows no mission protocol: an operation that goes over to it ends without an answer.
//
// What must hold, whatever that is:
// - an upload is Accepted only if the plan is aboard, and a verification Verified only if it was when it was read;
// - aboard() says "our plan" or "as before" only if that is so;
// - a download ends as Downloaded only if each item was given once, in order, as it was aboard;
// - what is written is whole frames but for one that a cancelled upload has left incomplete;
// - update() reads no more bytes than MAVMISSION_BYTES_PER_UPDATE;
// - when nothing happens any more, an operation ends, and no file of ours is left open.
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

const size_t kHeader = 10, kItem = 38, kFrameHead = 15;

// What ArduPilot makes of requests, and of files of plans.
class Server {
 public:
  std::vector<Bytes> held;  // the items of the mission, home first
  bool isOn = true;

  bool isOpenFor(uint8_t session) const { return isOpen_ && session_ == session; }

  void restart() {
    isOpen_ = false;
    last_.clear();
  }

  // The payloads of the answers. `client`: whose request it is.
  std::vector<Bytes> answers(const Bytes& request, uint8_t client) {
    if (!isOn) return {};
    const uint8_t opcode = request[6], session = request[5];
    if (!last_.empty() && client == lastClient_ && session == last_[5] && word(request, 3) + 1 == word(last_, 3))
      return {last_};
    std::vector<Bytes> found;
    Bytes reply(kFrameHead, 0);
    reply[1] = 1;
    reply[2] = client;
    put(reply, 3, static_cast<uint16_t>(word(request, 3) + 1));
    reply[5] = session;
    reply[6] = 128;
    reply[8] = opcode;
    if (opcode == 1) {
      if (isOpenFor(session)) close();
      isBusy_ = false;  // any session's end lets the next one in
    } else if (isOpen_ && session != session_ && isBusy_) {
      refuse(reply, 4);
    } else {
      if (isOpen_ && session != session_) close();
      found = done(request, reply);
      isBusy_ = true;
    }
    found.push_back(reply);
    last_ = reply;
    lastClient_ = client;
    return found;
  }

 private:
  static uint16_t word(const Bytes& bytes, size_t at) { return static_cast<uint16_t>(bytes[at] | bytes[at + 1] << 8); }
  static void put(Bytes& bytes, size_t at, uint16_t value) {
    bytes[at] = static_cast<uint8_t>(value);
    bytes[at + 1] = static_cast<uint8_t>(value >> 8);
  }
  static void refuse(Bytes& reply, uint8_t error) {
    reply[6] = 129;
    reply[7] = 1;
    reply.push_back(error);
  }

  // What comes before `reply`, the last answer.
  std::vector<Bytes> done(const Bytes& request, Bytes& reply) {
    std::vector<Bytes> before;
    const uint8_t opcode = request[6], size = request[7];
    const size_t offset = request[11] | request[12] << 8;
    const bool isOpening = opcode == 4 || opcode == 6, isWriting = opcode == 7;
    if (isOpening ? isOpen_ : !isOpen_ || writes_ != isWriting) {
      refuse(reply, isOpen_ ? 1 : 10);
    } else if (isOpening) {
      isOpen_ = true;
      session_ = request[5];
      writes_ = opcode == 6;
      data_.clear();
    } else if (isWriting) {
      if (data_.size() < offset + size) data_.resize(offset + size, 0);
      memcpy(data_.data() + offset, request.data() + kFrameHead, size);
      reply[11] = request[11];
      reply[12] = request[12];
    } else {
      demand(opcode == 5 || opcode == 15, "a request of FTP is sent that nobody needs");
      const Bytes whole = file();
      for (size_t at = offset; at < whole.size() && size != 0; at += size) {
        Bytes piece = reply;
        piece[7] = static_cast<uint8_t>(std::min<size_t>(size, whole.size() - at));
        piece[11] = static_cast<uint8_t>(at);
        piece[12] = static_cast<uint8_t>(at >> 8);
        piece.insert(piece.end(), whole.begin() + static_cast<long>(at),
                     whole.begin() + static_cast<long>(at + piece[7]));
        if (opcode == 5) {
          reply = piece;
          return before;
        }
        before.push_back(piece);
        put(reply, 3, static_cast<uint16_t>(word(reply, 3) + 1));
      }
      refuse(reply, 6);
    }
    return before;
  }

  // x, y and z of an item whose command has none are those of the item before.
  Bytes file() const {
    Bytes bytes(kHeader, 0);
    bytes[0] = 0x3D;
    bytes[1] = 0x76;
    put(bytes, 8, static_cast<uint16_t>(held.size()));
    Bytes leftOver(12, 0);
    for (Bytes item : held) {
      const uint16_t command = word(item, 30);
      if (command == 20 || command == 178 || command == 177) {
        memcpy(item.data() + 16, leftOver.data(), 12);
      } else {
        leftOver.assign(item.begin() + 16, item.begin() + 28);
      }
      bytes.insert(bytes.end(), item.begin(), item.end());
    }
    return bytes;
  }

  void close() {
    isOpen_ = false;
    if (!writes_ || data_.size() < kHeader || word(data_, 0) != 0x763D) return;
    const size_t count = (data_.size() - kHeader) / kItem;
    if (count != word(data_, 8)) return;
    std::vector<Bytes> items;
    for (size_t i = 0; i < count; ++i) {
      const Bytes item(data_.begin() + static_cast<long>(kHeader + i * kItem),
                       data_.begin() + static_cast<long>(kHeader + (i + 1) * kItem));
      if (item == Bytes(kItem, 0)) return;
      items.push_back(item);
    }
    held = items;
  }

  bool isOpen_ = false, writes_ = false, isBusy_ = false;
  uint8_t session_ = 0, lastClient_ = 0;
  Bytes data_, last_;
};

const MissionItem kPlan[] = {
    takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),   changeSpeed(5_mps),
    jump(1, 2),    waypoint(-35.3614500_deg, 149.1652374_deg, 25.5_m), returnToLaunch(),
    delay(5_s),    waypoint(-35.3614501_deg, 149.1652374_deg, 20_m),   waypoint(-35.3614502_deg, 149.1652374_deg, 2_m),
};
const uint8_t kPlanItems = sizeof(kPlan) / sizeof(*kPlan);

// The items of kPlan as they lie in a file.
std::vector<Bytes> itemsInFile(uint8_t count) {
  std::vector<Bytes> items;
  for (const MissionItem& item : wireItems(kPlan, count, Firmware::ArduPilot)) {
    items.push_back(itemParts(static_cast<uint16_t>(items.size()), item).payload);
    items.back()[offsetof(mavlink_mission_item_int_t, target_component)] = 1;
  }
  return items;
}

class Session {
 public:
  Session() : client_(line_), files_(client_) {
    client_.setAutopilotTimeout(10);
    setMillis(nowMs_);
    server_.held = itemsInFile(kPlanItems);
  }

  void run(Input input) {
    while (!input.isOver()) step(input);
    finish();
  }

 private:
  static bool take(void* context, uint16_t index, const MissionItem& item) {
    Session& session = *static_cast<Session*>(context);
    demand(index == session.given_, "an item was given twice, or left out");
    ++session.given_;
    if (index == kHomeIndex) session.given_ = 0;
    if (index != kHomeIndex) session.commands_.push_back(item.command);
    return true;
  }

  void step(Input& input) {
    const uint8_t what = input.next();
    switch (what % 16) {
      case 0:
      case 1: return wait(1 + input.next());
      case 2: return bring(heartbeatParts(3, what >= 192 ? 0x80 : 0));
      case 3:
      case 4:
      case 5:
      case 6: return deliver(255);
      case 7:  // a few answers are lost
        for (uint8_t n = input.next() % 8; n != 0 && !waiting_.empty(); --n) waiting_.pop_front();
        return;
      case 8:
        if (!waiting_.empty()) waiting_.push_back(waiting_.front());  // repeated, later
        return;
      case 9: requestsLost_ = input.next() % 4; return;
      case 10: return ask(input.next());
      case 11: client_.cancel(); return;
      case 12: return another(input);
      case 13:
        server_.restart();
        if (what >= 192) server_.isOn = !server_.isOn;
        return;
      case 14:
        for (uint8_t n = input.next() % 32; n != 0; --n) line_.toRead.push_back(input.next());
        return;
      case 15:
        if (what >= 128) {
          line_.room = input.next() % 70;
        } else {
          line_.takes = 1 + input.next() % 64;
        }
        return;
    }
  }

  void ask(uint8_t what) {
    if (client_.isBusy()) return;
    const uint8_t count = what / 4 % (kPlanItems + 1);
    const bool isUpload = what % 4 == 0 || what % 4 == 3;
    if (isUpload) {  // of another plan than the one aboard
      server_.held = itemsInFile(kPlanItems);
      for (Bytes& item : server_.held) item[27] ^= 1;
    }
    before_ = server_.held;
    meant_ = itemsInFile(count);
    const ItemSource plan = inRam(kPlan, count);
    given_ = kHomeIndex;
    commands_.clear();
    wasHeld_ = false;
    isUpload_ = isUpload;
    hasUploaded_ = hasUploaded_ || isUpload;
    if (isUpload_) {
      files_.upload(plan);
    } else if (what % 4 == 1) {
      files_.verify(plan);
    } else {
      files_.download(toFunction(take, this));
    }
    note();
  }

  // Another client, which has drawn our number or not.
  void another(Input& input) {
    Bytes request(kFrameHead, 0);
    const uint8_t how = input.next();
    const uint8_t opcodes[] = {1, 4, 6, 7};
    request[3] = input.next();
    request[5] = how & 128 ? session_ : 7;
    request[6] = opcodes[how % 4];
    if ((request[6] == 4 || request[6] == 6) && request[5] == session_) isAnothers_ = true;
    if (request[6] == 7) {
      request[7] = kItem;
      request[11] = static_cast<uint8_t>(kHeader + kItem * (how / 4 % 5));
      const Bytes item = itemsInFile(kPlanItems)[how / 8 % kPlanItems];
      request.insert(request.end(), item.begin(), item.end());
    }
    server_.answers(request, 190);
    note();
  }

  void note() { wasHeld_ = wasHeld_ || isHeld(); }

  // Items are the same, their numbers and targets apart; home is the autopilot's own.
  static bool isSame(const std::vector<Bytes>& ones, const std::vector<Bytes>& others) {
    if (ones.size() < 2 && others.size() < 2) return true;
    if (ones.size() != others.size()) return false;
    for (size_t i = 1; i < ones.size(); ++i) {
      if (memcmp(ones[i].data(), others[i].data(), 28) != 0) return false;
      if (memcmp(ones[i].data() + 30, others[i].data() + 30, 2) != 0) return false;
    }
    return true;
  }
  bool isHeld() const { return isSame(server_.held, meant_); }

  void bring(FrameParts parts) {
    parts.sequence = sequence_++;
    line_.bring(packed(parts));
    wait(1);
  }

  void deliver(size_t most) {
    for (; most != 0 && !waiting_.empty(); --most) {
      const Bytes payload = waiting_.front();
      waiting_.pop_front();
      bring(FrameParts(MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL, payload, 84));
      if (line_.toRead.size() > 200) return;
    }
  }

  void wait(uint32_t ms) {
    nowMs_ += ms;
    setMillis(nowMs_);
    const size_t before = line_.bytesRead;
    const Status status = client_.update();
    demand(line_.bytesRead - before <= MAVMISSION_BYTES_PER_UPDATE, "update() has read too many bytes");
    hear();
    if (isEnd(status)) check(status);
  }

  // What the client has written goes to the model, which answers at once.
  void hear() {
    const Bytes& bytes = line_.written;
    for (;;) {
      while (at_ < bytes.size() && bytes[at_] == 0) ++at_;  // before a frame, on a lossy link
      if (bytes.size() - at_ < 12) return;
      demand(bytes[at_] == 0xFD, "what was written is no frame");
      const size_t size = bytes[at_ + 1] + 12u;
      if (bytes.size() - at_ < size) return;
      const FrameIn frame = frameAt(bytes, at_);
      demand(frame.isRight || hasUploaded_, "what was written is no frame, and nothing was uploaded");
      at_ += size;
      if (!frame.isRight || frame.parts.messageId != MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL) continue;
      const Bytes& payload = frame.parts.payload;
      demand(payload[1] == 1 && payload[2] == 1, "a request goes to somebody else");
      session_ = payload[5];
      if (requestsLost_ != 0) {
        --requestsLost_;
        continue;
      }
      for (const Bytes& answer : server_.answers(payload, kClient)) waiting_.push_back(answer);
      note();
    }
  }

  void check(Status status) {
    const Aboard aboard = client_.aboard();
    if (status == Status::Accepted) {
      demand(isUpload_, "what was no upload ended as one");
      demand(wasHeld_, "accepted, and the plan was never aboard");
      demand(aboard == Aboard::OurPlan, "accepted, and aboard() does not know it");
    }
    if (status == Status::Verified) demand(!isUpload_ && wasHeld_, "verified, and it was not aboard");
    if (isUpload_ && aboard == Aboard::AsBefore) demand(isSame(server_.held, before_), "as before, and it is not");
    if (status == Status::Downloaded) {
      demand(commands_.size() + 1 >= server_.held.size() || wasDisturbed(), "downloaded, and items are missing");
    }
    demand(status != Status::NotKept && status != Status::BadJump, "a plan that is right was refused");
  }

  bool wasDisturbed() const { return !isSame(before_, server_.held); }

  void finish() {
    line_.room = MemoryStream::kAlwaysRoom;
    line_.takes = 1000;
    requestsLost_ = 0;
    server_.isOn = true;
    const uint32_t beganMs = nowMs_;
    for (int i = 0; client_.isBusy() || i < 40; ++i) {
      if (i % 20 == 0) bring(heartbeatParts(3));
      wait(25);
      wait(25);
      deliver(8);
      demand(nowMs_ - beganMs < 200000, "an operation does not end");
    }
    for (int i = 0; i < 400 && server_.isOpenFor(session_); ++i) {
      if (i % 20 == 0) bring(heartbeatParts(3));
      wait(50);
      deliver(8);
    }
    demand(!server_.isOpenFor(session_) || isAnothers_, "a file of ours was left open");
  }

  MemoryStream line_;
  MissionClient client_;
  PlanFiles files_;
  Server server_;
  std::deque<Bytes> waiting_;  // answers that have not been delivered
  std::vector<Bytes> before_, meant_;
  std::vector<uint16_t> commands_;
  uint32_t nowMs_ = 0xFFFFF000;
  size_t at_ = 0;
  uint16_t given_ = kHomeIndex;
  uint8_t sequence_ = 0, session_ = 0, requestsLost_ = 0;
  bool isUpload_ = false, hasUploaded_ = false, wasHeld_ = false, isAnothers_ = false;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Session().run(Input{data, size});
  return 0;
}
