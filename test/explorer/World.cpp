#include "World.h"

#include <string.h>

#include <algorithm>

#include "Plans.h"

using mavmission::Status;

namespace {

const char* const kFateWords[kFates] = {"",
                                        " is lost",
                                        " is repeated",
                                        " is repeated later",
                                        " is delayed",
                                        " is damaged",
                                        " is cut",
                                        " is copied, 30 ms later",
                                        " is copied, 120 ms later",
                                        " is copied, 300 ms later",
                                        " comes over the second link alone, 30 ms later",
                                        " comes over the second link alone, 120 ms later",
                                        " comes over the second link alone, 300 ms later"};

std::string inWords(const char* words) { return words; }
std::string inWords(uint8_t number) { return std::to_string(number); }
std::string inWords(Status status) { return mavmission::toString(status); }

// Words are found for what happens only where somebody reads them.
template <typename... Parts>
void say(std::string* log, const Parts&... parts) {
  if (log == nullptr) return;
  if (!log->empty()) *log += "; ";
  ((*log += inWords(parts)), ...);
}

constexpr uint8_t kOtherSession = 7;  // of the other client of the files

bool isDelivered(Fate fate) {
  return fate == Fate::Delivered || fate == Fate::Repeated || fate == Fate::RepeatedLate ||
         (fate >= Fate::Copied30 && fate < Fate::Late30);
}

}  // namespace

uint8_t Scenario::otherType() const {
  for (const Task& task : tasks) {
    if (task.type != kMission) return task.type;
  }
  return kRally;
}

Outcome World::begin(const Scenario& scenario) {
  memset(static_cast<void*>(this), 0, sizeof(*this));
  left_ = scenario;
  autopilot_.begin(scenario.firmware, kMission);
  beside_.begin(scenario.firmware, scenario.otherType());
  const bool isMission = scenario.tasks.front().type == kMission;
  autopilot_.hold(isMission ? scenario.heldPlan : 0, isMission ? scenario.heldItems : scenario.heldBeside);
  beside_.hold(isMission ? 0 : scenario.heldPlan, isMission ? scenario.heldBeside : scenario.heldItems);
  toAutopilot_.latencyMs = toClient_.latencyMs = scenario.latencyMs;
  autopilot_.refused = scenario.refused;
  heartbeatInMs_ = kNever;
  client_.construct(scenario.firmware, false, scenario.isLossy, scenario.hasFiles());
  beginTask(scenario, nullptr);
  return runClient(scenario, 0, Bytes(), nullptr);
}

void World::beginTask(const Scenario& scenario, std::string* log) {
  const Task& task = scenario.tasks[task_];
  say(log, "the sketch begins: ", kOperations[static_cast<int>(task.operation)], ", ", task.items, " items");
  before_ = planOf(task.type);
  // (A board that was reset listens for 1.2 s first, which is left out here.)
  isUndisturbed_ = scenario.resets == 0 && !left_.canBe();
  referee_.begin(task, scenario.firmware);
  if (isByFiles(task.operation)) fileReferee_.begin();
  sunk = &sunk_;
  client_.begin(task);
}

World::Event World::next(uint16_t& ms) const {
  Event event = Event::None;
  ms = kNever;
  const auto consider = [&](Event which, uint16_t when) {
    if (when >= ms) return;
    event = which;
    ms = when;
  };
  const int up = toAutopilot_.first(), down = toClient_.first();
  if (up >= 0) consider(Event::ToAutopilot, toAutopilot_.frames[up].dueMs);
  consider(Event::Autopilot, std::min(autopilot_.nextMs(), beside_.nextMs()));
  if (down >= 0) consider(Event::ToClient, toClient_.frames[down].dueMs);
  consider(Event::Heartbeat, heartbeatInMs_);
  consider(Event::Client, client_.nextMs());
  return event;
}

Moves World::moves() const {
  Moves moves;
  moves.count = 0;
  uint16_t ms;
  const Event event = next(ms);
  if (event == Event::None) return moves;
  moves.add(Choice::Event);
  if (event == Event::ToAutopilot || event == Event::ToClient) {
    const Line& line = event == Event::ToClient ? toClient_ : toAutopilot_;
    const InFlight& due = line.frames[line.first()];
    const bool isSpared = due.isSpared || isSure(due.message);
    if (left_.losses != 0 && !isSpared) moves.add(Choice::Event, Fate::Lost);
    if (left_.faults != 0 && !isSpared) {
      for (Fate fate : {Fate::Repeated, Fate::RepeatedLate, Fate::Delayed}) moves.add(Choice::Event, fate);
      // A model has no parser: what is damaged on its way to the autopilot is lost.
      if (event == Event::ToClient) {
        for (Fate fate : {Fate::Damaged, Fate::Cut}) moves.add(Choice::Event, fate);
      }
    }
  }
  if (left_.copies != 0 && (event == Event::ToAutopilot || event == Event::ToClient)) {
    const Line& line = event == Event::ToClient ? toClient_ : toAutopilot_;
    for (Fate fate : {Fate::Copied30, Fate::Copied120, Fate::Copied300, Fate::Late30, Fate::Late120, Fate::Late300}) {
      const bool isMove = fate < Fate::Late30 || left_.hasTwoLinks != 0;
      if (isMove && !line.frames[line.first()].isSpared) moves.add(Choice::Event, fate);
    }
  }
  if (left_.reboots != 0) moves.add(Choice::Reboot);
  if (left_.others != 0) {
    for (Choice choice : {Choice::OtherOpens, Choice::OtherCreates, Choice::OtherWrites, Choice::OtherEnds})
      moves.add(choice);
  }
  if (!referee_.isRunning) return moves;
  if (left_.cancels != 0) moves.add(Choice::Cancel);
  if (left_.resets != 0 && task_ == 0) moves.add(Choice::Reset);
  return moves;
}

void World::pass(uint16_t ms) {
  if (heartbeatInMs_ != kNever) heartbeatInMs_ = static_cast<uint16_t>(heartbeatInMs_ > ms ? heartbeatInMs_ - ms : 0);
  if (fileReferee_.session != 0) {
    files_.pass(ms);
    fileReferee_.pass(ms);
  }
  autopilot_.pass(ms);
  beside_.pass(ms);
  toAutopilot_.pass(ms);
  toClient_.pass(ms);
  referee_.pass(ms);
}

const char* World::answer(const Answers& answers, std::string* log) {
  for (int i = 0; i < answers.count; ++i) {
    say(log, "autopilot: ", answers.messages[i]);
    if (!toClient_.send(answers.messages[i])) return "the line to the client is fuller than the exploration foresees";
  }
  return nullptr;
}

Outcome World::runClient(const Scenario& scenario, uint16_t ms, const Bytes& bytes, std::string* log) {
  Outcome outcome;
  sunk = &sunk_;
  bool again = true;
  for (bool isFirst = true; again; isFirst = false) {
    again = false;
    const Doing doing = client_.run(isFirst ? ms : 0, bytes.data(), isFirst ? bytes.size() : 0, isLastTask(scenario));
    referee_.isHurried = !client_.isHurried() ? 0 : referee_.isHurried == 0 ? 1 : Referee::kHurriedBefore;
    if (doing.isRestless) outcome.broken = "the client does not come to rest";
    // It ended before what it sends behind the end: a cancellation, which the referee then expects.
    const auto takeEnd = [&] {
      outcome.hasEnded = true;
      outcome.task = task_;
      outcome.status = doing.status;
      say(log, "it ends: ", doing.status);
      const Autopilot& plan = planOf(referee_.task.type);
      const char* broken = end(doing, (scenario.faults | scenario.copies) != 0);
      if (broken == nullptr && doing.status == Status::Downloaded &&
          (sunk_.count != plan.heldCount || memcmp(sunk_.items, plan.held, sunk_.count) != 0)) {
        broken = "Downloaded, and what was read is not what is aboard";
      }
      if (outcome.broken == nullptr) outcome.broken = broken;
    };
    bool isEndTaken = !doing.hasEnded;
    for (const Bytes& frame : doing.frames) {
      Message sent = Message();
      const char* broken = decode(frame, scenario.firmware, sent);
      if (broken == nullptr) {
        const bool isCancel = sent.kind == Kind::Ack && sent.number == kCancelled;
        if (!isEndTaken && isCancel && !referee_.owesCancel) {
          isEndTaken = true;
          takeEnd();
        }
        say(log, "client: ", sent);
        broken = this->sent(sent, scenario.firmware);
        if (!toAutopilot_.send(sent)) broken = "the line to the autopilot is fuller than the exploration foresees";
      } else {
        say(log, "client: a frame");
      }
      if (outcome.broken == nullptr) outcome.broken = broken;
    }
    if (!isEndTaken) takeEnd();
    if (doing.hasEnded && !isLastTask(scenario)) {
      ++task_;
      beginTask(scenario, log);
      again = true;
    }
  }
  if (scenario.hasFiles()) renumber();
  return outcome;
}

// What is lost without end after the last operation would be asked for without end.
bool World::isSure(const Message& message) const {
  return isOfFiles(message) && !referee_.isRunning && left_.losses == Scenario::kAnyNumber;
}

const char* World::sent(const Message& message, Firmwares firmware) {
  if (message.kind == Kind::File) return fileReferee_.sent(message, referee_);
  const bool isCancel = message.kind == Kind::Ack && message.number == kCancelled;
  if (isCancel && fileReferee_.mayCancel) {
    fileReferee_.mayCancel = false;
    return nullptr;
  }
  if (fileReferee_.isRunning) {
    fileReferee_.isRunning = false;
    const bool isProof = message.kind == Kind::List;
    if (isProof && referee_.task.operation == Operation::FileUpload && !fileReferee_.isClosed)
      return "the plan is read back before the file was closed";
    referee_.goOnByItems(isProof);
  }
  return referee_.sent(message, firmware);
}

void World::heard(const Message& message, Firmwares firmware) {
  if (message.kind == Kind::FileReply) return fileReferee_.heard(message);
  if (!fileReferee_.isRunning) referee_.heard(message, firmware);
}

// An operation that nothing can happen to any more ends well, whatever has happened before. (ArduPilot denies reading
// while it holds an upload open; it has no ear for a cancelling.)
bool World::isAlive(Status status) const {
  if (!isUndisturbed_) return true;
  const bool isReceiving = (referee_.task.type == kMission ? autopilot_ : beside_).state == Autopilot::State::Receiving;
  switch (status) {
    case Status::Accepted:
    case Status::AlreadyAboard:
    case Status::Verified:
    case Status::Downloaded:
    case Status::Cleared: return true;
    case Status::Differs:
      return referee_.task.operation == Operation::Verify || referee_.task.operation == Operation::FileVerify;
    case Status::Denied: return isReceiving && (!referee_.isUpload() || referee_.isLooking);
    // PX4 hears nothing else while it waits for items; a newer ArduPilot that is asked again accepts later.
    case Status::NoAnswer:
      return task_ != 0 && (isReceiving || referee_.task.items == 0 || autopilot_.firmware == Firmwares::Px4);
    case Status::Unconfirmed:  // what is accepted may be the operation before, and it is not read back
      return task_ != 0 && referee_.task.operation == Operation::Upload;
    default: return false;
  }
}

const char* World::end(const Doing& doing, bool lineRepeats) {
  const Autopilot* const before = task_ == 0 ? &before_ : nullptr;
  const char* broken;
  if (fileReferee_.isRunning) {
    referee_.isRunning = false;
    referee_.ended = doing.status;
    broken = fileReferee_.end(doing.status, client_.aboard(kMission), referee_, autopilot_, before);
  } else {
    const uint8_t type = referee_.task.type;
    broken = referee_.end(doing.status, client_.aboard(type), planOf(type), before, lineRepeats);
  }
  if (broken != nullptr || isAlive(doing.status)) return broken;
  return "nothing is lost any more, and it does not end well";
}

// Numbers of requests count from the client's last one, so that a state is known again whatever they were.
void World::renumber() {
  const uint16_t by = client_.lastNumber();
  client_.renumber(by);
  fileReferee_.renumber(by);
  files_.last.number = static_cast<uint16_t>(files_.last.number - by);
  for (Line* line : {&toAutopilot_, &toClient_}) {
    for (uint32_t i = 0; i < line->count; ++i) {
      Message& message = line->frames[i].message;
      if (isOfFiles(message)) message.number = static_cast<uint16_t>(message.number - by);
    }
  }
  // Nothing that is sent from now on has the number of an answer so old.
  constexpr int16_t kOld = -48;
  if (static_cast<int16_t>(files_.last.number) < kOld) files_.last = Message();
  if (client_.waitsForHeartbeat() != (heartbeatInMs_ != kNever))
    heartbeatInMs_ = heartbeatInMs_ == kNever ? 1000 : kNever;
}

// A client with a session of its own. It has our ids, so that we hear its answers; and it numbers its requests as we
// do.
Outcome World::hearOther(Choice choice, std::string* log) {
  FileWords words = FileWords();
  words.session = kOtherSession;
  words.opcode = choice == Choice::OtherOpens     ? kFileOpen
                 : choice == Choice::OtherCreates ? kFileCreate
                 : choice == Choice::OtherWrites  ? kFileWrite
                                                  : kFileTerminate;
  words.count = choice == Choice::OtherWrites;
  const Message request = message(Kind::File, client_.lastNumber(), 0, words.packed());
  say(log, "another client: ", request);
  --left_.others;
  Outcome outcome;
  outcome.isFault = true;
  if (autopilot_.bootsInMs != kNever) return outcome;
  Answers answers;
  files_.hear(request, autopilot_, answers);
  outcome.broken = answer(answers, log);
  return outcome;
}

// A board that was reset sends its first request of a file after more than a second. What was under way to the
// autopilot has arrived by then, and the answers are not heard.
void World::loseFilesOfBefore() {
  Answers unheard;
  for (int i = 0; i < static_cast<int>(toAutopilot_.count);) {
    if (!isOfFiles(toAutopilot_.frames[i].message)) {
      ++i;
    } else {
      files_.hear(toAutopilot_.take(i, Fate::Delivered), autopilot_, unheard);
    }
  }
  for (int i = static_cast<int>(toClient_.count) - 1; i >= 0; --i) {
    if (isOfFiles(toClient_.frames[i].message)) toClient_.take(i, Fate::Lost);
  }
}

Outcome World::step(const Scenario& scenario, const Move& move, std::string* log) {
  Outcome outcome;
  switch (move.choice) {
    case Choice::Reboot:
      say(log, "the autopilot reboots");
      --left_.reboots;
      autopilot_.reboot();
      beside_.reboot();
      files_.reboot();
      outcome.isFault = true;
      return outcome;
    case Choice::Cancel:
      say(log, "the sketch cancels");
      --left_.cancels;
      client_.cancel();
      outcome = runClient(scenario, 0, Bytes(), log);
      outcome.isFault = true;
      return outcome;
    case Choice::Reset:
      say(log, "the Arduino is reset");
      --left_.resets;
      if (!isLastTask(scenario)) ++task_;
      referee_.owesCancel = referee_.hasEndedOne = false;
      loseFilesOfBefore();
      fileReferee_.beginBehindReset();
      client_.construct(scenario.firmware, true, scenario.isLossy, scenario.hasFiles());
      beginTask(scenario, log);
      outcome = runClient(scenario, 0, Bytes(), log);
      outcome.isFault = true;
      return outcome;
    case Choice::OtherOpens:
    case Choice::OtherCreates:
    case Choice::OtherWrites:
    case Choice::OtherEnds: return hearOther(move.choice, log);
    case Choice::Event: break;
  }

  uint16_t ms;
  const Event event = next(ms);
  pass(ms);
  Bytes bytes;
  if (event == Event::ToAutopilot || event == Event::ToClient) {
    Line& line = event == Event::ToClient ? toClient_ : toAutopilot_;
    const Message message = line.take(line.first(), move.fate);
    say(log, message, isDelivered(move.fate) ? " arrives" : "", kFateWords[static_cast<int>(move.fate)]);
    outcome.isFault = move.fate != Fate::Delivered;
    if (move.fate == Fate::Lost) {
      if (left_.losses != Scenario::kAnyNumber) --left_.losses;
    } else if (move.fate >= Fate::Copied30) {
      if (left_.copies != Scenario::kAnyNumber) --left_.copies;
    } else if (outcome.isFault) {
      --left_.faults;
    }
    if (event == Event::ToAutopilot) {
      Answers answers;
      if (isDelivered(move.fate) && message.kind != Kind::File) hearOfKinds(autopilot_, beside_, message, answers);
      if (isDelivered(move.fate) && message.kind == Kind::File && autopilot_.bootsInMs == kNever)
        files_.hear(message, autopilot_, answers);
      outcome.broken = answer(answers, log);
    } else if (move.fate != Fate::Lost && move.fate != Fate::Delayed && move.fate < Fate::Late30) {
      bytes = frameOf(message, scenario.firmware);
      if (move.fate == Fate::Damaged) bytes[bytes.size() - 3] = static_cast<uint8_t>(~bytes[bytes.size() - 3]);
      if (move.fate == Fate::Cut) bytes.resize(bytes.size() - 3);
      if (isDelivered(move.fate)) heard(message, scenario.firmware);
    }
  } else if (event == Event::Heartbeat) {
    heartbeatInMs_ = 1000;
    if (autopilot_.bootsInMs == kNever) bytes = frameOf(message(Kind::Heartbeat), scenario.firmware);
    say(log, "a heartbeat");
  } else if (event == Event::Autopilot) {
    Answers answers;
    (beside_.nextMs() == 0 ? beside_ : autopilot_).act(answers);
    outcome.broken = answer(answers, log);
  }
  // Its time is every moment: update() is called in each.
  const Outcome ran = runClient(scenario, ms, bytes, log);
  const char* const broken = outcome.broken;
  const bool isFault = outcome.isFault;
  outcome = ran;
  if (outcome.broken == nullptr) outcome.broken = broken;
  outcome.isFault = isFault;
  outcome.ms = ms;
  return outcome;
}

const char* World::leftUndone() const {
  if (referee_.isRunning) return "nothing happens any more, and it has not ended";
  if (files_.isOpen && files_.session != kOtherSession && !fileReferee_.mayLeaveOpen())
    return "a file of ours is left open";
  if (referee_.owesCancel) return "the autopilot is not told that it is over";
  return nullptr;
}
