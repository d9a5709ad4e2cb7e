#include "ClientUnderTest.h"

#include <Arduino.h>
#include <string.h>

#include <algorithm>
#include <new>

#include "Plans.h"
#include "mavmission/base/Clock.h"
#include "mavmission/client/Clearing.h"
#include "mavmission/client/Ensuring.h"
#include "mavmission/client/Reading.h"
#include "mavmission/client/Uploading.h"

using namespace mavmission;
using namespace mavmission::detail;

Sunk* sunk = nullptr;

namespace {

// It is always this moment between two steps, so that each wait crosses the wrap of millis(), in 16 bits and in 32.
constexpr uint32_t kNowMs = 0xFFFFFFFC;
constexpr uint16_t kNow = static_cast<uint16_t>(kNowMs);
// For which a frame keeps the line busy: repeats are five times as far apart. (An answer takes half of that: so no item
// is repeated twice as often.) On a quicker line there are more of them, and nothing else.
constexpr uint8_t kFrameMs = 80;
// A client that does nothing in so many has come to rest: items are got ready in two, and of a plan that goes as a file
// one in each.
constexpr int kQuietUpdates = 3, kQuietFileUpdates = 10;
constexpr int kMostUpdates = 40;  // in one step; a client that sends in each of them would never stop

class FedStream : public Stream {
 public:
  const uint8_t* bytes = nullptr;
  size_t length = 0;
  std::vector<Bytes>* frames = nullptr;

  int available() override { return static_cast<int>(length); }
  int peek() override { return length == 0 ? -1 : *bytes; }
  int read() override {
    if (length == 0) return -1;
    --length;
    return *bytes++;
  }
  int availableForWrite() override { return 1000; }
  size_t write(uint8_t byte) override { return write(&byte, 1); }
  size_t write(const uint8_t* data, size_t size) override {
    begun_.insert(begun_.end(), data, data + size);
    // Zeros between frames are no frame, and do nothing.
    while (!begun_.empty() && begun_.front() == 0) begun_.erase(begun_.begin());
    while (begun_.size() >= kAround && begun_.size() >= kAround + begun_[1]) {
      const auto end = begun_.begin() + kAround + begun_[1];
      frames->push_back(Bytes(begun_.begin(), end));
      begun_.erase(begun_.begin(), end);
    }
    return size;
  }
  bool isWhole() const { return begun_.empty(); }
  void clear() { begun_.clear(); }

 private:
  static constexpr size_t kAround = 12;  // header and checksum of a MAVLink 2 frame
  Bytes begun_;                          // a frame comes in pieces
};

FedStream stream;

bool sink(void*, uint16_t index, const MissionItem& item) {
  const uint8_t taken = itemDownloaded(item, index == kHomeIndex, sunk->type);
  if (sunk->count < sizeof(sunk->items)) sunk->items[sunk->count++] = taken;
  return true;
}

uint16_t leftOf(uint16_t waitMs, uint16_t sinceMs) {
  const uint16_t passed = since(sinceMs, kNow);
  return static_cast<uint16_t>(passed >= waitMs ? 0 : waitMs - passed);
}

// Keeps a time as far back as it was, `mostMs` at most, which is where nothing depends on it any more.
void keep(uint16_t& timeMs, uint16_t stepMs, uint16_t mostMs) {
  const uint16_t ago = since(timeMs, static_cast<uint16_t>(kNow + stepMs));
  timeMs = static_cast<uint16_t>(kNow - std::min(ago, mostMs));
}

// Of very many tries those between the first and the last ones are all the same. `most`: 0 if they do not end by their
// number.
void foldTries(uint8_t& tries, uint8_t most) {
  constexpr uint8_t kFirst = 6, kLast = 1;
  if (tries <= kFirst) return;
  if (most == 0) {
    tries = kFirst;
  } else if (tries < most - kLast) {
    tries = static_cast<uint8_t>(most - kLast);
  }
}

template <typename T>
void blank(T& what) {
  memset(static_cast<void*>(&what), 0, sizeof(what));
}

bool isReading(const MissionClient& client) {
  return client.state_.operation == detail::Client::ReadingPlan::step ||
         client.state_.operation == detail::Client::ReadingPlan::readOn ||
         client.state_.operation == detail::Client::Ensuring::step ||
         client.state_.operation == PlanFiles::proveByItemsStep;
}

}  // namespace

alignas(8) uint8_t ClientUnderTest::clientAwake[];
alignas(8) uint8_t ClientUnderTest::filesAwake[];

// While it exists, a client that has PlanFiles is in the place where it runs.
class ClientUnderTest::Awake {
 public:
  explicit Awake(ClientUnderTest& of) : of_(of) {
    if (of.hasFiles_ == 0) return;
    memcpy(clientAwake, of.bytes_, sizeof(clientAwake));
    memcpy(filesAwake, of.fileBytes_, sizeof(filesAwake));
  }
  ~Awake() {
    if (of_.hasFiles_ == 0) return;
    memcpy(of_.bytes_, clientAwake, sizeof(clientAwake));
    memcpy(of_.fileBytes_, filesAwake, sizeof(filesAwake));
  }

 private:
  ClientUnderTest& of_;
};

void ClientUnderTest::construct(Firmwares firmware, bool isFresh, bool isLossy, bool hasFiles) {
  memset(bytes_, 0, sizeof(bytes_));
  memset(fileBytes_, 0, sizeof(fileBytes_));
  hasFiles_ = hasFiles;
  uint8_t closings = 0;
  setMillis(kNowMs);
  {
    const Awake awake(*this);
    new (&client()) MissionClient(stream);
    if (hasFiles) new (filesAwake) PlanFiles(client());
    client().setTargetIds(1, 1);
    client().state_.unsettled = isFresh ? kFromOpen : 0;
    client().state_.unsettledMs = kNow;
    if (isLossy) client().link_.pace_.noteLoss();
    if (hasFiles) std::swap(closings, files().closings_);
  }
  const Bytes& heartbeat = frameOf(message(Kind::Heartbeat), firmware);
  run(0, heartbeat.data(), heartbeat.size(), false);
  // A board that was reset looks for a file that it has left open. Before the first operation it has found none.
  if (!hasFiles) return;
  const Awake awake(*this);
  if (isFresh) {
    files().closings_ = closings;
  } else {
    files().isStorable_ = false;
  }
}

void ClientUnderTest::begin(const Task& task) {
  const Awake awake(*this);
  setMillis(kNowMs);
  const ItemSource plan = inRam(sketchPlan(task.plan, task.type), task.items);
  const PlanType type = static_cast<PlanType>(task.type);
  switch (task.operation) {
    case Operation::Upload: client().uploadWithoutReadback(plan, type); return;
    case Operation::UploadInDoubt: client().upload(plan, type, Readback::InDoubt); return;
    case Operation::UploadVerified: client().upload(plan, type, Readback::Always); return;
    case Operation::Ensure: client().ensure(plan, type); return;
    case Operation::Download:
      blank(*sunk);
      sunk->type = task.type;
      client().download(toFunction(sink), type);
      return;
    case Operation::Verify: client().verify(plan, type); return;
    case Operation::Clear: client().clear(type); return;
    case Operation::FileUpload: files().upload(plan); return;
    case Operation::FileVerify: files().verify(plan); return;
  }
}

void ClientUnderTest::cancel() {
  const Awake awake(*this);
  setMillis(kNowMs);
  client().cancel();
}

Doing ClientUnderTest::run(uint16_t ms, const uint8_t* bytes, size_t length, bool isLast) {
  const Awake awake(*this);
  Doing doing = Doing();
  const uint32_t nowMs = kNowMs + ms;
  setMillis(nowMs);
  // Heartbeats come and go unseen: the autopilot was always heard just now, ours was always sent just now.
  client().link_.state_.heartbeatMs = static_cast<uint16_t>(nowMs);
  client().link_.state_.heartbeatSent = true;
  client().link_.finder_.heardMs_ = static_cast<uint16_t>(nowMs);
  client().link_.state_.emptyMs = nowMs;
  // Each frame has the number 0, and is the next one: that a copy is one, it cannot see.
  client().link_.state_.heardSequence = 255;
  // The limit on the whole operation is out of the way: it has to end without it.
  client().state_.secondMs = static_cast<uint16_t>(nowMs);

  client().state_.tickMs = static_cast<uint16_t>(nowMs - MissionClient::kTickMs);  // onTick() is due

  stream.bytes = bytes;
  stream.length = length;
  stream.frames = &doing.frames;
  stream.clear();
  int quiet = 0;
  const int enough = hasFiles_ != 0 ? kQuietFileUpdates : kQuietUpdates;
  for (int i = 0; i < kMostUpdates && quiet < enough; ++i) {
    const size_t sent = doing.frames.size();
    client().link_.state_.framesSent = 0;  // and with it the number of our next frame
    const Status status = client().update();
    if (isEnd(status)) {
      doing.hasEnded = true;
      doing.status = status;
    }
    const bool isWaiting = status == Status::Idle || status == Status::Transferring || waitsForLateAnswers();
    const bool isPaused = stream.length == 0 && stream.isWhole() && doing.frames.size() == sent && isWaiting;
    quiet = isPaused ? quiet + 1 : 0;
  }
  doing.isRestless = quiet < enough;
  rest(ms, isLast);
  return doing;
}

// A new operation has sent nothing yet.
bool ClientUnderTest::waitsForLateAnswers() const {
  const MissionClient& c = client();
  const bool waits =
      c.state_.status == Status::WaitingForAutopilot || c.state_.operation == detail::Client::Ensuring::freedStep;
  return c.isBusy() && waits && (c.state_.unsettled & kFromBefore) != 0 &&
         since(c.state_.unsettledMs, c.state_.tickMs) < lateMs();
}

// How long it waits for them.
uint16_t ClientUnderTest::lateMs() const {
  const bool isOfRepeats = (client().state_.unsettled & MissionClient::kOfRepeats) != 0;
  return static_cast<uint16_t>((isOfRepeats ? MissionClient::kLateMs : MissionClient::kCopyMs) + 2 * kRoundTripMs);
}

uint16_t ClientUnderTest::nextMs() const {
  const MissionClient& c = client();
  uint16_t next = kNever;
  if (!c.link_.parser_.isIdle()) next = leftOf(FrameParser::kSilenceMs, c.link_.state_.heardByteMs);
  if (waitsForLateAnswers()) return std::min<uint16_t>(next, leftOf(lateMs(), c.state_.unsettledMs));
  if (c.state_.status != Status::Transferring || !c.isBusy()) return next;
  if (c.state_.operation == PlanFiles::writeStep || c.state_.operation == PlanFiles::readStep)
    return std::min(next, nextOfFilesMs());
  const Pace& pace = c.link_.pace_;
  if (c.state_.operation == detail::Client::Uploading::step) {
    const UploadTransfer& t = c.transfer_;
    const bool isCounting = t.state_ == UploadTransfer::State::Counting;
    const uint16_t ruleMs = UploadTransfer::kRepeatMs;
    if (t.state_ != UploadTransfer::State::Sending || pace.isLossy())
      next = std::min(next, leftOf(isCounting && t.has(kFreed) ? ruleMs : pace.waitMs(ruleMs), t.sentMs_));
    switch (t.state_) {
      case UploadTransfer::State::Counting: return std::min(next, leftOf(UploadTransfer::kCountingMs, t.progressMs_));
      case UploadTransfer::State::Sending: return std::min(next, leftOf(UploadTransfer::kPassiveMs, t.progressMs_));
      case UploadTransfer::State::Confirming:
        return std::min(next, leftOf(UploadTransfer::kConfirmingMs, t.progressMs_));
    }
  }
  if (isReading(c)) {
    const DownloadTransfer& t = c.reading_.transfer;
    if (t.pending_ == 0) return std::min(next, leftOf(DownloadTransfer::kCopyMs, t.sentMs_));
    const bool isListing = t.state_ == DownloadTransfer::State::Listing;
    const uint16_t waitMs = isListing ? DownloadTransfer::kListMs : DownloadTransfer::kItemMs;
    const uint16_t severalMs = t.pending_ > 1 ? kRoundTripMs + Pace::kLeastMs : 0;
    return std::min(next, leftOf(std::max(pace.waitMs(waitMs), severalMs), t.sentMs_));
  }
  const bool waits = !c.clearing_.hasBeenSent() && (c.state_.unsettled & kFromOpen) != 0;
  if (waits) return std::min(next, leftOf(ClearTransfer::kAnswerMs, c.state_.unsettledMs));
  return std::min(next, leftOf(pace.waitMs(ClearTransfer::kAnswerMs), c.clearing_.sentMs_));
}

uint16_t ClientUnderTest::nextOfFilesMs() const {
  const Pace& pace = client().link_.pace_;
  if (client().state_.operation == PlanFiles::readStep) {
    const FileReadTransfer& t = files().reading_;
    const bool isOpening = t.state_ == FileReadTransfer::State::Opening;
    return leftOf(pace.waitMs(isOpening ? FileRules::kOpenMs : FileRules::kPieceMs), t.sentMs_);
  }
  const FileWriteTransfer& t = files().writing_.transfer;
  const bool isCreating = t.state_ == FileWriteTransfer::State::Creating;
  const uint16_t waitMs = pace.waitMs(isCreating ? FileRules::kOpenMs : FileRules::kWriteMs);
  uint16_t next = kNever;
  for (const FileWriteTransfer::Slot& slot : t.slots_) {
    if (slot.phase == FileWriteTransfer::Phase::Sent) next = std::min(next, leftOf(waitMs, slot.sentMs));
  }
  return next;
}

bool ClientUnderTest::waitsForHeartbeat() const {
  return hasFiles_ != 0 && files().closings_ != 0 &&
         (client().state_.operation == nullptr || client().state_.operation != files().operation_);
}

void ClientUnderTest::renumber(uint16_t by) {
  PlanFiles& f = *reinterpret_cast<PlanFiles*>(fileBytes_);
  // An answer so old is none to anything.
  constexpr int kOld = 48;
  f.sequence_ = static_cast<uint16_t>(f.sequence_ - by);
  f.firstSequence_ = static_cast<uint16_t>(std::max<int>(static_cast<int16_t>(f.firstSequence_ - by), -kOld));
  if (client().state_.operation != PlanFiles::writeStep || client().state_.status != Status::Transferring) return;
  for (FileWriteTransfer::Slot& slot : f.writing_.transfer.slots_) {
    if (slot.phase != FileWriteTransfer::Phase::Idle && slot.tries != 0)
      slot.request.sequence = static_cast<uint16_t>(slot.request.sequence - by);
  }
}

void ClientUnderTest::restFiles(uint16_t ms) {
  const MissionClient& c = client();
  PlanFiles& f = files();
  const bool isHasty = c.link_.pace_.isLossy();
  if (c.state_.operation == PlanFiles::readStep && c.state_.status == Status::Transferring) {
    FileReadTransfer& t = f.reading_;
    keep(t.sentMs_, ms, FileRules::kOpenMs);
    const bool isOpening = t.state_ == FileReadTransfer::State::Opening;
    foldTries(t.tries_,
              isHasty ? (isOpening ? FileRules::kLossyOpenTries : FileRules::kLossyTries) : FileRules::kPieceTries);
    memset(static_cast<void*>(t.holes_ + t.holeCount_), 0,
           static_cast<size_t>(FileReadTransfer::kHoles - t.holeCount_) * sizeof(t.holes_[0]));
  } else if (c.state_.operation == PlanFiles::writeStep && c.state_.status == Status::Transferring) {
    FileWriteTransfer& t = f.writing_.transfer;
    const bool isCreating = t.state_ == FileWriteTransfer::State::Creating;
    for (FileWriteTransfer::Slot& slot : t.slots_) {
      if (slot.phase == FileWriteTransfer::Phase::Idle) blank(slot);
      if (slot.phase != FileWriteTransfer::Phase::Sent) slot.sentMs = kNow;
      if (slot.tries == 0) slot.request.sequence = 0;
      keep(slot.sentMs, ms, FileRules::kWriteMs);
      foldTries(slot.tries,
                isHasty ? (isCreating ? FileRules::kLossyOpenTries : FileRules::kLossyTries) : FileRules::kPieceTries);
    }
    if (!t.isLeaving()) blank(f.writing_.going);
    if (!t.isLeaving()) f.writing_.pieces = 0;
  } else {
    blank(f.reading_);
    blank(f.writing_);
    f.onRead_ = nullptr;
  }
}

void ClientUnderTest::rest(uint16_t ms, bool isLast) {
  MissionClient& c = client();
  const bool isHasty = c.link_.pace_.isLossy();
  if (hasFiles_ != 0) restFiles(ms);
  Link::State& link = c.link_.state_;
  FrameParser& parser = c.link_.parser_;
  link.bytes = 0;
  link.frames = link.unknownMessages = link.framesLost = link.framesSent = 0;
  link.heardSequence = 0;
  link.sequenceKnown = false;
  link.heartbeatMs = kNow;
  c.link_.damage_ = 0;
  // One pace for all lines, and slower than on a quick one: what there is between two repeats is the same.
  c.link_.pace_.roundTripMs_ = kRoundTripMs;
  c.link_.pace_.busyMs_ = kFrameMs;
  c.link_.finder_.heardMs_ = c.link_.finder_.searchMs_ = kNow;
  c.link_.finder_.knowledge_ = 0;
  link.emptyMs = kNowMs;
  link.gap = 0;
  link.isCurrent = true;
  if (parser.isIdle()) {
    const bool inStep = parser.inStep_;
    MoreKeys* const moreKeys = parser.moreKeys_;
    blank(parser);
    parser.inStep_ = inStep;
    parser.moreKeys_ = moreKeys;
    link.heardByteMs = kNow;
  } else {
    keep(link.heardByteMs, ms, FrameParser::kSilenceMs);
    const size_t used = std::max(parser.have_, parser.end_);
    memset(parser.bytes_ + used, 0, sizeof(parser.bytes_) - used);
    parser.badChecksums_ = parser.brokenFrames_ = 0;
    parser.bytesSkipped_ = 0;
  }
  if (!c.link_.outbox_.isHeld()) {
    blank(c.link_.outbox_);
    c.session_.prepared = 0;
  }
  c.state_.isTimeLeft = false;
  c.state_.tickMs = kNow;

  c.state_.secondMs = kNow;
  c.state_.seconds = c.state_.limitFromS = 0;
  const bool isLooking = c.state_.operation == detail::Client::Ensuring::step;
  const bool isByFile = c.state_.operation == PlanFiles::writeStep || c.state_.operation == PlanFiles::readStep;
  if (!isLooking) c.state_.lastResult = 255;  // ensure() remembers a refusal
  const bool isUpload = c.state_.operation == detail::Client::Uploading::step;
  const bool isTransferring = c.isBusy() && c.state_.status == Status::Transferring;
  // What earlier transfers left matters when a transfer begins, and to a clear and a reading; what an upload leaves it
  // says at its end.
  const bool isClear = c.state_.operation == detail::Client::Clearing::step;
  const bool isLeftUnread =
      isLast ? (isTransferring && !isClear && !isReading(c) && !isByFile) || !c.isBusy() : isTransferring && isUpload;
  constexpr uint8_t kOfNext = kFromBefore | MissionClient::kOfRepeats;
  const bool isFreed = c.state_.operation == detail::Client::Ensuring::freedStep;
  if (isTransferring && !isFreed) c.state_.unsettled &= static_cast<uint8_t>(~kFromBefore);  // its end sets it again
  if (isLeftUnread && !isFreed) c.state_.unsettled &= isLast ? 0 : kOfNext;
  if (isLast && !isFreed && (!c.isBusy() || isTransferring)) c.state_.unsettled &= static_cast<uint8_t>(~kOfNext);
  c.state_.unsettledMs = c.state_.unsettled != 0 ? c.state_.unsettledMs : kNow;
  keep(c.state_.unsettledMs, c.state_.unsettled != 0 ? ms : 0, MissionClient::kLeftoversMs);
  if (!c.isBusy()) {
    static_assert(sizeof(c.reading_) >= sizeof(c.transfer_) && sizeof(c.reading_) >= sizeof(c.clearing_), "all of it");
    blank(c.reading_);
    blank(c.commanding_);
  }
  if (!isTransferring || isByFile) return;
  if (isUpload) {
    UploadTransfer& t = c.transfer_;
    keep(t.sentMs_, ms, UploadTransfer::kRepeatMs);
    keep(t.progressMs_, ms, UploadTransfer::kConfirmingMs);
    // Whether an INVALID_SEQUENCE may be the answer to an earlier item. (Times are not measured here.)
    t.isAgain_ = false;
    if (t.state_ == UploadTransfer::State::Sending && t.firmware_ == Firmware::ArduPilot) {
      keep(t.startedMs_, ms, Referee::kLastAnswerMs);
    } else {
      t.startedMs_ = kNow;
    }
    foldTries(t.tries_, 0);
    if (t.state_ == UploadTransfer::State::Sending) t.tries_ = std::min<uint8_t>(t.tries_, 2);
  } else if (isReading(c)) {
    keep(c.reading_.transfer.sentMs_, ms, DownloadTransfer::kListMs);
    c.reading_.transfer.startedMs_ = kNow;
    foldTries(c.reading_.transfer.tries_, isHasty ? Pace::kLossyTries : DownloadTransfer::kItemTries);
  } else {
    keep(c.clearing_.sentMs_, ms, ClearTransfer::kAnswerMs);
    foldTries(c.clearing_.tries_, isHasty ? Pace::kLossyTries : 0);
  }
}
