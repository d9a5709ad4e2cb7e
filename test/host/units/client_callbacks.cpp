// What a sketch may do in its callbacks: each thing that it can call, in each callback, at each of its moments.
#include <MavMissionConsole.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "ClientOnLine.h"
#include "PlanFrames.h"

using namespace mavmission;

namespace {

// The callback.
enum class In { Progress, End, Source, Sink, SinkReady, Message, Current, Reached, Text, Payload, Last };

// What the sketch does there. The operations come first.
enum class Do {
  Upload,
  UploadByFile,
  Ensure,
  EnsureByFile,
  Verify,
  Download,
  Clear,
  Command,
  Parameter,
  Steer,
  Start,
  UploadAgain,
  TooLong,
  PartOfNothing,
  NoType,
  Cancel,
  CancelAndUpload,
  UploadAndCancel,
  Update,
  KeptValue,
  Listen,
  NoCallbacks,
  Last
};
// How the operation that runs is left alone: without an answer, without heartbeats as well, on a port that says that it
// has no room, or that says nothing and takes no byte.
enum class Left { Silent, Gone, NoRoom, TakesNothing, Last };
constexpr uint32_t kStepMs = 4;                        // between two passes of loop()
constexpr int kMoments = 5;                            // the first calls of each callback
constexpr int kRunning = static_cast<int>(Do::Start);  // of these each is also what runs meanwhile

const MessageKey kPosition[] PROGMEM = {messageKey(24, 24, 30)};  // GPS_RAW_INT
const MessageKey kAttitude[] PROGMEM = {messageKey(30, 39, 28)};
const FlightCommand kCommand = flightCommand(2500);  // VIDEO_START_CAPTURE
constexpr LatLon kPlace = {-35.3632621_deg, 149.1652374_deg};

void put(Bytes& bytes, size_t at, uint16_t value) {
  bytes[at] = static_cast<uint8_t>(value);
  bytes[at + 1] = static_cast<uint8_t>(value >> 8);
}

uint16_t wordOf(const Bytes& bytes, size_t at) { return static_cast<uint16_t>(bytes[at] | bytes[at + 1] << 8); }

// A sketch with all callbacks, and the autopilot that it talks to. One of the callbacks does one thing, once.
class Sketch : public ClientOnLine {
 public:
  static constexpr uint16_t kItems = 3;

  std::vector<Status> told;         // what onEnd() was told
  std::vector<std::string> faults;  // what must not be
  size_t begun = 0;                 // operations that were not refused with Status::Busy
  bool isDone = false;              // the callback has done it
  std::vector<Bytes> held;          // the plan that the autopilot has

  Sketch(uint8_t kind, In place, Do deed, int moment)
      : ClientOnLine(kind),
        place_(place),
        deed_(deed),
        moment_(moment),
        follower_(client),
        files_(client),
        parameters_(client),
        steering_(client),
        messages_(client, kPosition, onMessage, this),
        payload_(client, onCommand, this) {
    client.onProgress(onProgress, this);
    client.onEnd(onEnd, this);
    follower_.onCurrent(onCurrent, this);
    follower_.onReached(onReached, this);
    follower_.onText(onText, this);
    live(1400);
  }

  // The sketch's loop() begins an operation; from now on the calls of the callback count.
  void begin(Do what) {
    calls_ = 0;
    isCounting_ = true;
    doIt(what);
  }

  // Left alone after so many frames of the operation's; the time until its end [ms], 0 when it has ended before.
  uint32_t leaveAlone(Left how, int frames) {
    answers_ = frames;
    for (int i = 0; i < 500 && answers_ > 0 && client.isBusy(); ++i) live(kStepMs);
    if (!client.isBusy()) return 0;
    answers_ = 0;
    beats = how != Left::Gone;
    if (how == Left::NoRoom) line.room = 0;
    if (how == Left::TakesNothing) line.takes = 0;
    const uint32_t fromMs = nowMs();
    while (client.isBusy() && nowMs() - fromMs < 1000000) live(10 * kStepMs, 10 * kStepMs);
    return nowMs() - fromMs;
  }

  void finish() {
    for (int i = 0; i < 3000 && (client.isBusy() || i < 5); ++i) live(3 * kStepMs);
    isCounting_ = false;
    if (client.isBusy()) faults.push_back("an operation does not end");
  }

 private:
  In place_;
  Do deed_;
  int moment_;
  int calls_ = 0;
  bool isCounting_ = false;
  int answers_ = 1000000;  // frames that are answered still
  MissionFollower follower_;
  PlanFiles files_;
  Parameters parameters_;
  Steering steering_;
  MessageListener messages_;
  Payload payload_;
  std::vector<MessageListener*> more_;
  std::vector<Bytes> coming_;
  uint16_t announced_ = 0, telling_ = 0;

 public:
  ~Sketch() {
    for (MessageListener* one : more_) delete one;
  }

  // --- The autopilot

  void live(uint32_t ms, uint32_t stepMs = kStepMs) {
    for (; ms != 0; ms -= stepMs) {
      if (isCounting_ && !isDone && nowMs() % 8 == 0) tellSomething();
      run(stepMs, stepMs);
      payload_.update();
      std::vector<SentFrame> heard;
      heard.swap(sent);
      for (const SentFrame& frame : heard) {
        if (frame.messageId != 0 && answers_-- > 0) answer(frame);
      }
    }
  }

 private:
  // The message that leads to the callback.
  void tellSomething() {
    const uint8_t item = static_cast<uint8_t>(++telling_ % 3 + 1);
    Bytes text(51, 'x'), command(33);
    text[0] = 6;
    put(command, 28, 42600);
    command[30] = 1;
    command[31] = 191;
    switch (place_) {
      case In::Current: return hear(FrameParts(42, {item, 0, 0xFF, 0xFF, 0, 0}, 28));
      case In::Reached: return hear(FrameParts(46, {item, 0}, 11));
      case In::Message: return hear(FrameParts(24, Bytes(30, 1), 24));
      case In::Text: return hear(FrameParts(253, text, 83));
      case In::Payload: return hear(FrameParts(76, command, 152));
      default: return;
    }
  }

  void answer(const SentFrame& frame) {
    const Bytes& sentPayload = frame.payload;
    switch (frame.messageId) {
      case kCount:
        announced_ = wordOf(sentPayload, 0);
        coming_.clear();
        return hear(requestParts(0));
      case kItemInt: {
        if (coming_.size() == announced_ || wordOf(sentPayload, 28) != coming_.size()) return;
        Bytes item(sentPayload.begin(), sentPayload.begin() + 38);
        item[33] = 191;  // to us
        coming_.push_back(item);
        if (coming_.size() < announced_) return hear(requestParts(static_cast<uint16_t>(coming_.size())));
        held = coming_;
        return hear(ackParts(0));
      }
      case kRequestList: return hear(countParts(static_cast<uint16_t>(held.size())));
      case kRequestInt: {
        const uint16_t seq = wordOf(sentPayload, 0);
        if (seq < held.size()) hear(FrameParts(73, held[seq], 38));
        return;
      }
      case 45:  // MISSION_CLEAR_ALL
        held.clear();
        return hear(ackParts(0));
      case 75:  // COMMAND_INT
      case 76:  // COMMAND_LONG
        return hear(commandAckParts(wordOf(sentPayload, 28), 0));
      case 20: {  // PARAM_REQUEST_READ
        Bytes value(25);
        put(value, 2, 0x3F80);  // 1.0
        std::copy(sentPayload.begin() + 4, sentPayload.begin() + 20, value.begin() + 8);
        value[24] = 9;  // REAL32
        return hear(FrameParts(22, value, 220));
      }
      default: return;
    }
  }

  // --- The sketch

  void note(Status first, bool wasBusy) {
    if ((first == Status::Busy) != wasBusy) {
      faults.push_back(wasBusy ? "it has begun beside another one" : "it is Busy, and nothing runs");
    }
    if (first != Status::Busy) ++begun;
  }

  void doIt(Do what) {
    const bool isBusy = client.isBusy();
    const ItemSource plan = fromFunction(giveItem, kItems, this);
    switch (what) {
      case Do::Upload: return note(client.upload(plan), isBusy);
      case Do::UploadByFile: return note(files_.upload(plan), isBusy);
      case Do::Ensure: return note(client.ensure(plan), isBusy);
      case Do::EnsureByFile: return note(files_.ensure(plan), isBusy);
      case Do::Verify: return note(client.verify(plan), isBusy);
      case Do::Download: return note(client.download(ItemSink{takeItem, this, 100, isReady}), isBusy);
      case Do::Clear: return note(client.clear(), isBusy);
      case Do::Command: return note(client.send(kCommand), isBusy);
      case Do::Parameter: return note(parameters_.set("P", 1), isBusy);
      case Do::Steer: return note(steering_.goTo(kPlace, 20_m), isBusy);
      case Do::Start: return note(client.start(), isBusy);
      case Do::UploadAgain: return note(client.uploadAgain(), isBusy);
      case Do::TooLong: return note(client.upload(fromFunction(giveItem, 70000, this)), isBusy);
      case Do::PartOfNothing: return note(client.uploadPartial(plan, 7, 1), isBusy);
      case Do::NoType: return note(client.verify(plan, PlanType::All), isBusy);
      case Do::Cancel: return client.cancel();
      case Do::CancelAndUpload: client.cancel(); return doIt(Do::Upload);
      case Do::UploadAndCancel: doIt(Do::Upload); return client.cancel();
      case Do::Update: {
        const bool mayBe = place_ == In::Payload;
        const Status status = client.update();
        if ((status == Status::Busy) == mayBe) faults.push_back("update() within an update()");
        if (mayBe && isEnd(status)) ends.push_back(status);
        return;
      }
      case Do::KeptValue: {
        const float kept = client.keptValue();
        if (kept == kept) faults.push_back("a value where none was refused");
        return;
      }
      case Do::Listen:
        more_.push_back(new MessageListener(client, kAttitude, onMessage, this));
        more_.push_back(new MessageListener(client, kPosition, onMessage, this));
        return;
      case Do::NoCallbacks:
        client.onProgress(nullptr);
        follower_.onCurrent(nullptr);
        follower_.onText(nullptr);
        return;
      case Do::Last: return;
    }
  }

  void called(In where) {
    if (!isCounting_ || isDone || where != place_ || calls_++ != moment_) return;
    isDone = true;
    doIt(deed_);
  }

  static Sketch& of(void* context) { return *static_cast<Sketch*>(context); }
  static bool giveItem(void* context, uint16_t index, MissionItem& item) {
    of(context).called(In::Source);
    item = waypoint(kPlace.latitude + Degrees::fromE7(100 * index), kPlace.longitude, 20_m);
    return true;
  }
  static bool takeItem(void* context, uint16_t, const MissionItem&) {
    of(context).called(In::Sink);
    return true;
  }
  static bool isReady(void* context) {
    of(context).called(In::SinkReady);
    return true;
  }
  static void onProgress(void* context, uint16_t, uint16_t) { of(context).called(In::Progress); }
  static void onEnd(void* context, Status status) {
    of(context).told.push_back(status);
    of(context).called(In::End);
  }
  static void onMessage(void* context, const ReceivedMessage&) { of(context).called(In::Message); }
  static void onCurrent(void* context, uint16_t) { of(context).called(In::Current); }
  static void onReached(void* context, uint16_t) { of(context).called(In::Reached); }
  static void onText(void* context, uint8_t, const char*) { of(context).called(In::Text); }
  static PayloadAnswer onCommand(void* context, const PayloadCommand&) {
    of(context).called(In::Payload);
    return PayloadAnswer::Accepted;
  }
};

std::string text(const std::vector<Status>& ends) {
  std::string all;
  for (Status end : ends) all += std::string(toString(end)) + "; ";
  return all;
}

// Runs one case; false when the callback was not called so often.
bool check(uint8_t kind, Do running, In place, Do deed, int moment) {
  Sketch sketch(kind, place, deed, moment);
  if (running == Do::Verify || running == Do::Download || deed == Do::UploadAgain) {
    sketch.begin(Do::Upload);
    sketch.finish();
    if (sketch.isDone) return true;  // looked at where an upload runs
  }
  sketch.begin(running);
  sketch.finish();
  CAPTURE(static_cast<int>(kind));
  CAPTURE(static_cast<int>(running));
  CAPTURE(static_cast<int>(place));
  CAPTURE(static_cast<int>(deed));
  CAPTURE(moment);
  CAPTURE(text(sketch.told));
  CAPTURE(text(sketch.ends));
  // Each operation ends once, for onEnd() as for update().
  CHECK(sketch.told.size() == sketch.begun);
  // (An update() returns one end, the first: that of an operation which a listener's callback has begun in vain after
  // the end of another one was returned to whoever began it.)
  const bool isVain = deed == Do::TooLong || deed == Do::PartOfNothing || deed == Do::NoType;
  const bool isHidden = isVain && place >= In::Message && sketch.told.size() == 2 && sketch.ends.size() == 1;
  if (!isHidden) CHECK((sketch.told == sketch.ends));
  CHECK((!sketch.ends.empty() && sketch.ends.front() == sketch.told.front()));
  for (const std::string& fault : sketch.faults) FAIL_CHECK(fault);
  const bool isCancelled = std::count(sketch.told.begin(), sketch.told.end(), Status::Cancelled) != 0;
  const bool mayCancel = deed == Do::Cancel || deed == Do::CancelAndUpload || deed == Do::UploadAndCancel;
  if (!mayCancel) CHECK_FALSE(isCancelled);
  // What was said last is true.
  const Status last = sketch.told.empty() ? Status::Idle : sketch.told.back();
  if (last == Status::Accepted || last == Status::AlreadyAboard || last == Status::Verified) {
    CHECK((sketch.client.aboard() == Aboard::OurPlan));
    CHECK(sketch.held.size() == Sketch::kItems + (kind == ClientOnLine::kArduPilot ? 1 : 0));
  }
  // And the client is in order.
  const bool wasDone = sketch.isDone;
  sketch.isDone = true;
  sketch.begin(Do::Upload);
  sketch.finish();
  CHECK((sketch.client.status() == Status::Accepted));
  CHECK((sketch.client.aboard() == Aboard::OurPlan));
  return wasDone;
}

}  // namespace

TEST_CASE("whatever is called in whichever callback, each operation ends once and tells the truth") {
  int cases = 0;
  for (uint8_t kind : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    // What a listener hears is the same on both.
    const In behind = kind == ClientOnLine::kArduPilot ? In::Last : In::Message;
    for (int place = 0; place < static_cast<int>(behind); ++place) {
      for (int running = 0; running < kRunning; ++running) {
        for (int deed = 0; deed < static_cast<int>(Do::Last); ++deed) {
          for (int moment = 0; moment < kMoments; ++moment) {
            if (!check(kind, static_cast<Do>(running), static_cast<In>(place), static_cast<Do>(deed), moment)) break;
            ++cases;
          }
        }
      }
    }
  }
  MESSAGE(cases << " cases");
  CHECK(cases > 1000);
}

TEST_CASE("each operation ends within its time wherever it is left alone, however") {
  constexpr uint32_t kOwnS = 60, kWaitingS = 20;
  int cases = 0;
  for (uint8_t kind : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    for (int running = 0; running <= static_cast<int>(Do::Start); ++running) {
      for (int how = 0; how < static_cast<int>(Left::Last); ++how) {
        for (int frames = 0; frames < 20; ++frames) {
          CAPTURE(static_cast<int>(kind));
          CAPTURE(running);
          CAPTURE(how);
          CAPTURE(frames);
          Sketch sketch(kind, In::Last, Do::Last, 0);
          sketch.begin(Do::Upload);
          sketch.finish();
          sketch.client.setOperationTimeout(kOwnS);
          sketch.client.setAutopilotTimeout(kWaitingS);
          sketch.begin(static_cast<Do>(running));
          const uint32_t tookMs = sketch.leaveAlone(static_cast<Left>(how), frames);
          CHECK(tookMs <= 1000 * (kOwnS + kWaitingS + 1));
          if (tookMs == 0) break;
          ++cases;
        }
      }
    }
  }
  MESSAGE(cases << " cases");
  CHECK(cases > 300);
}
