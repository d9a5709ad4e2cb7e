// A whole MissionClient on a line where anything may happen, driven by the bytes of the input: what is received, how time
// passes, what the sketch asks for, what the stream takes.
//
// What must hold, whatever that is:
// - update() reads no more bytes than MAVMISSION_BYTES_PER_UPDATE, and writes no more than the stream said it takes;
// - an upload is Accepted only if it was announced, and the bytes that came since it was asked for hold a request for its last item, behind it
//   an ACK with MAV_MISSION_ACCEPTED, both right to the checksum, from the autopilot, for us and for a mission;
// - what is written is whole frames, one behind the other, each with the next sequence number;
// - items that are done never go back, and are never more than there are;
// - when nothing comes any more, an operation ends in the time that its limits add up to.
#include <Arduino.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <deque>
#include <vector>

#include "Frames.h"
#include "MavMission.h"
#include "MemoryStream.h"
#include "mavmission/MavlinkHeaders.h"

using namespace mavmission;

namespace {

const uint16_t kWaitingLimitS = 10;
const uint8_t kAutopilot = 1;  // system and component

void demand(bool holds, const char* what) {
  if (holds) return;
  fprintf(stderr, "%s\n", what);
  abort();
}

// The bytes of the input, as far as they go.
struct Input {
  const uint8_t* data;
  size_t size;
  bool isOver() const { return size == 0; }
  uint8_t next() {
    if (size == 0) return 0;
    --size;
    return *data++;
  }
};

const MissionItem kPlan[] = {
    takeoff(20_m),
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
    changeSpeed(5_mps),
    jump(1, 2),
    waypoint(-35.3614500_deg, 149.1652374_deg, 20_m),
    returnToLaunch(),
};
const uint8_t kPlanItems = sizeof(kPlan) / sizeof(*kPlan);

// A frame of the mission service that lies in the bytes at `at` and is right, whatever lies around it.
bool isRight(const Bytes& bytes, size_t at, uint32_t& id, Bytes& payload, size_t& size) {
  const bool v2 = bytes[at] == 0xFD;
  const size_t header = v2 ? 10 : 6;
  if ((!v2 && bytes[at] != 0xFE) || bytes.size() - at < header + 2) return false;
  const size_t length = bytes[at + 1];
  size = header + length + 2;
  if (bytes.size() - at < size) return false;
  id = v2 ? static_cast<uint32_t>(bytes[at + 7] | bytes[at + 8] << 8 | bytes[at + 9] << 16) : bytes[at + 5];
  const mavlink_msg_entry_t* entry = mavlink_get_msg_entry(id);
  if (entry == nullptr) return false;
  uint16_t crc = X25_INIT_CRC;
  for (size_t i = 1; i < size - 2; ++i) crc_accumulate(bytes[at + i], &crc);
  crc_accumulate(entry->crc_extra, &crc);
  if (bytes[at + size - 2] != (crc & 0xFF) || bytes[at + size - 1] != crc >> 8) return false;
  payload.assign(bytes.begin() + static_cast<long>(at + header), bytes.begin() + static_cast<long>(at + header + length));
  payload.resize(64, 0);
  return true;
}

bool isForUs(uint8_t system, uint8_t component) {
  return (system == 0 || system == kAutopilot) && (component == 0 || component == 191);
}

// True if the bytes hold what an upload of `count` items on the wire needs to be accepted.
bool holdsProof(const Bytes& heard, uint16_t count) {
  bool asked = count == 0;
  for (size_t at = 0; at < heard.size(); ++at) {
    uint32_t id;
    Bytes payload;
    size_t size;
    if (!isRight(heard, at, id, payload, size)) continue;
    if ((id == 40 || id == 51) && isForUs(payload[2], payload[3]) && payload[4] == 0 &&
        (payload[0] | payload[1] << 8) == count - 1) {
      asked = true;
    }
    if (asked && id == 47 && isForUs(payload[0], payload[1]) && payload[2] == 0 && payload[3] == 0) return true;
  }
  return false;
}

// How many items the last MISSION_COUNT among frames announces.
uint16_t announced(const Bytes& written) {
  uint16_t count = 0xFFFF;
  for (size_t at = 0; at < written.size(); ++at) {
    uint32_t id;
    Bytes payload;
    size_t size;
    if (isRight(written, at, id, payload, size) && id == 44) count = static_cast<uint16_t>(payload[0] | payload[1] << 8);
  }
  return count;
}

class Line : public MemoryStream {
 public:
  Bytes heard;  // since the upload was asked for
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

class Session {
 public:
  Session() : client_(line_) {
    client_.limitWaiting(kWaitingLimitS);
    client_.onProgress(progress, this);
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

  void step(Input& input) {
    const uint8_t what = input.next();
    switch (what % 16) {
      case 0:
      case 1:
        return wait(input.next());
      case 2:
        for (uint8_t n = input.next() % 40; n != 0; --n) wait(50);
        return;
      case 3:
        for (uint8_t n = input.next() % 64; n != 0; --n) line_.toRead.push_back(input.next());
        return;
      case 4:
      case 5: {
        const uint8_t kinds[] = {3, 12, 0, 8};
        return bring(heartbeatParts(kinds[input.next() % 4], what >= 128 ? 0x80 : 0), input);
      }
      case 6:
      case 7:
      case 8: {
        FrameParts parts = requestParts(input.next() % (kPlanItems + 3), what >= 128 ? 0 : kAutopilot, 191, what >= 224);
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
        return bring(ackParts(what & 32 ? 0 : result % 20, kAutopilot, 191, result >= 224, opaqueId), input);
      }
      case 11:
        return upload(input.next());
      case 12:
        client_.cancel();
        if (uploading_) uploading_ = client_.isBusy();
        return;
      case 13:
        room_ = input.next() % 70;
        return;
      case 14:
        line_.takes = 1 + input.next() % 64;
        return;
      case 15:
        return other(input.next());
    }
  }

  void upload(uint8_t how) {
    const bool wasBusy = client_.isBusy();
    const uint16_t count = how % (kPlanItems + 1);
    const Status status = client_.upload(inRam(kPlan, count));
    demand(wasBusy == (status == Status::Busy), "an operation was begun while another one ran, or refused without one");
    if (wasBusy) return;
    uploading_ = true;
    count_ = count;
    done_ = 0;
    line_.heard.clear();
    written_ = line_.written.size();
  }

  // What a sketch may ask for besides. None of it may end with Accepted.
  void other(uint8_t what) {
    if (client_.isBusy()) {
      demand(client_.clear() == Status::Busy, "an operation was begun while another one ran");
      return;
    }
    done_ = 0;
    switch (what % 6) {
      case 0:
        client_.clear(what & 64 ? PlanType::All : PlanType::Mission);
        return;
      case 1:
        client_.verify(inRam(kPlan, kPlanItems));
        return;
      case 2:
        client_.download(toRam(space_));
        return;
      case 3:
        client_.setCurrentItem(what);
        return;
      case 4:
        client_.arm();
        return;
      case 5:
        client_.start();
        return;
    }
  }

  void bring(FrameParts parts, Input& input) {
    const uint8_t how = input.next();
    parts.sequence = sequence_++;
    if (how & 1) {
      parts.version = 1;
      if (parts.messageId == 40 || parts.messageId == 51) parts.payload.resize(4);
      if (parts.messageId == 47) parts.payload.resize(3);
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
    const Status status = client_.update();
    demand(line_.bytesRead - read <= MAVMISSION_BYTES_PER_UPDATE, "update() read more than it may");
    if (room_ > 0) demand(line_.written.size() - written <= static_cast<size_t>(room_), "more was written than there was room");
    demand(client_.itemsDone() <= client_.itemsTotal(), "more items are done than there are");
    demand(client_.failedItem() == MissionClient::kNoItem || !uploading_ || client_.failedItem() < count_,
           "an item failed that is not in the plan");
    demand(client_.isBusy() || status == Status::Idle || isEnd(status), "an operation that is over was said to run");
    if (!isEnd(status)) return;
    if (status == Status::Accepted) {
      demand(uploading_, "what was no upload was accepted");
      const uint16_t onTheWire = announced(Bytes(line_.written.begin() + static_cast<long>(written_), line_.written.end()));
      // (Of an empty plan nothing is asked for. Its COUNT may be held back by a stream that takes nothing.)
      const bool home = count_ != 0 && onTheWire == count_ + 1;
      demand(count_ == 0 || onTheWire == count_ || home, "accepted, though another plan was announced");
      demand(holdsProof(line_.heard, count_ == 0 ? 0 : onTheWire), "accepted, though the autopilot has not said so");
      demand(client_.itemsDone() == count_, "accepted, though not every item is done");
    }
    uploading_ = uploading_ && client_.isBusy();  // what was cancelled is told by the next update(), when another may run
  }

  // Silence. The longest upload: waiting, checking, the transfer's own limit. Others are shorter.
  void finish() {
    room_ = MemoryStream::kAlwaysRoom;
    line_.takes = 1000;
    const uint32_t limitMs = 1000u * (kWaitingLimitS + 120 + 2 * (kPlanItems + 1) + 40);
    const uint32_t beganMs = nowMs_;
    while (client_.isBusy() || !line_.toRead.empty()) {
      wait(50);
      demand(nowMs_ - beganMs <= limitMs, "an operation does not end");
    }
    wait(50);
    wait(50);
    checkWritten();
  }

  void checkWritten() {
    const Bytes& bytes = line_.written;
    size_t at = 0;
    for (uint8_t sequence = 0; at < bytes.size(); ++sequence) {
      uint32_t id;
      Bytes payload;
      size_t size = 0;
      demand(isRight(bytes, at, id, payload, size), "what was written is no frame");
      demand(bytes[at + (bytes[at] == 0xFD ? 4 : 2)] == sequence, "a sequence number was left out or used twice");
      at += size;
    }
  }

  Line line_;
  MissionClient client_;
  MissionItem space_[4];
  uint32_t nowMs_ = 0xFFFFF000;  // it wraps soon, in 16 bits and in 32
  int room_ = MemoryStream::kAlwaysRoom;  // at the beginning of each update()
  uint8_t sequence_ = 0;
  bool uploading_ = false;
  uint16_t count_ = 0;     // the items of the upload
  size_t written_ = 0;     // bytes written before it
  uint16_t done_ = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Session().run(Input{data, size});
  return 0;
}
