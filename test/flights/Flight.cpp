#include "Flight.h"

#include <algorithm>

using mavmission::Status;

namespace {

constexpr uint32_t kBeginMs = 70000;  // what millis() says at the beginning
constexpr uint32_t kStepMs = 4;       // the longest time from one loop() to the next
constexpr uint32_t kLongestMs = 150000, kRestMs = 6000;
constexpr int kTransmitBuffer = 63;
constexpr size_t kReceiveBuffer = 63;
constexpr uint32_t kLeadMs = 1400;  // actors may act so long before the task begins

class Flying {
 public:
  Flying(const FlightPlan& plan, std::string* log)
      : plan_(plan),
        referee_(plan.kind, log),
        sketch_(plan.kind),
        up_(plan.seed * 2 + 1, 0),
        down_(plan.seed * 2 + 2, 0),
        nowMs_(kBeginMs) {
    const uint32_t beatMs = kBeginMs + 100 + plan.seed * 137 % 900;
    if (plan.kind == Kind::Px4) {
      autopilot_.reset(new Px4(plan.kind, referee_, beatMs));
    } else {
      autopilot_.reset(new ArduPilot(plan.kind, referee_, beatMs));
    }
    autopilot_->pass(kBeginMs);
    setMillis(nowMs_);
  }

  Flown fly() {
    sketch_.upload();
    if (!runUntilEnd(20000) || sketch_.status() != Status::Accepted) return broken("the upload does not end well");
    run(1200);
    if (isInAir(plan_.task)) {
      autopilot_->putInAir(nowMs_);
      run(1100);
      if (plan_.isInOwnMode) {
        sketch_.begin(Task::SetMode);
        if (!runUntilEnd(3000) || sketch_.status() != Status::Done) return broken("it cannot be prepared");
      }
    }
    if (plan_.task == Task::Disarm) {
      sketch_.begin(Task::Arm);
      if (!runUntilEnd(3000) || sketch_.status() != Status::Done) return broken("it cannot be prepared");
    }
    beganMs_ = nowMs_ + kLeadMs;
    for (const Act& act : plan_.acts) {
      if (act.order == 0) add(act);
    }
    isNoting_ = true;
    run(kLeadMs);
    up_.setLoss(plan_.loss);
    down_.setLoss(plan_.loss);
    while (nowMs_ < stallUntilMs_) step(stallUntilMs_);
    referee_.begins(plan_.task, plan_.loss, isDisturbed_, *autopilot_);
    sketch_.begin(plan_.task);
    sketch_.loop(nowMs_);  // update() follows it in the same loop()
    send();
    if (!runUntilEnd(kLongestMs)) return broken("it does not end");
    const bool isQuiet = plan_.acts.empty() && plan_.loss <= 0;
    if (isQuiet && sketch_.status() != Status::Done) return broken("nothing happens, and it does not end well");
    flown_.tookMs = static_cast<int32_t>(nowMs_ - beganMs_);
    run(1000);
    isNoting_ = false;
    up_.setLoss(0);
    down_.setLoss(0);
    while (!acts_.empty()) run(100);
    run(kRestMs);
    referee_.rests(sketch_, *autopilot_);
    return broken(referee_.broken());
  }

 private:
  Flown broken(const std::string& rule) {
    flown_.broken = !referee_.broken().empty() ? referee_.broken() : rule;
    flown_.status = sketch_.status();
    flown_.hasTaken = referee_.hasTaken();
    flown_.isUnseen = referee_.isUnseen();
    flown_.longestWindowMs = referee_.longestWindowMs();
    flown_.longestUndoneMs = referee_.longestUndoneMs();
    flown_.undoneMs = referee_.undoneMs();
    return flown_;
  }

  void run(uint32_t ms) {
    for (const uint32_t until = nowMs_ + ms; nowMs_ < until;) step(until);
  }

  bool runUntilEnd(uint32_t limitMs) {
    const uint32_t until = nowMs_ + limitMs;
    if (mavmission::isEnd(sketch_.status())) return true;  // it was refused at once
    while (nowMs_ < until) {
      if (step(until)) return true;
    }
    return false;
  }

  void add(const Act& act) {
    acts_.push_back(act);
    std::stable_sort(acts_.begin(), acts_.end(), [](const Act& a, const Act& b) { return a.atMs < b.atMs; });
  }

  // Sets the time for the actors who act after the order that leaves now.
  void ordered() {
    if (!isNoting_) return;
    ++orders_;
    const int32_t nowMs = static_cast<int32_t>(nowMs_ - beganMs_);
    for (const Act& act : plan_.acts) {
      if (act.order == orders_) add(Act{act.what, nowMs + act.atMs, act.amount, 0});
    }
  }

  void note() {
    if (!isNoting_) return;
    const int32_t at = static_cast<int32_t>(nowMs_ - beganMs_);
    if (flown_.moments.empty() || flown_.moments.back() != at) flown_.moments.push_back(at);
  }

  void act(const Act& act) {
    const Kind kind = plan_.kind;
    switch (act.what) {
      case What::Pilot: return autopilot_->actorSetsMode(modeOf(kind, Means::Pilot), false, nowMs_);
      case What::Lands: return autopilot_->actorSetsMode(modeOfLanding(kind, plan_.task), false, nowMs_);
      case What::Holds: return autopilot_->actorSetsMode(modeOf(kind, Means::Hold), false, nowMs_);
      case What::Disarms: return autopilot_->actorDisarms(nowMs_);
      case What::Failsafe: return autopilot_->actorSetsMode(modeOf(kind, Means::Return), true, nowMs_);
      case What::OtherPlan: return autopilot_->actorSetsPlan(1, nowMs_);
      case What::SamePlan: return autopilot_->actorSetsPlan(0, nowMs_);
      case What::Clears: return autopilot_->actorClearsPlan(nowMs_);
      case What::Cut:
        up_.cutUntil(nowMs_ + act.amount);
        down_.cutUntil(nowMs_ + act.amount);
        break;
      case What::LoseUp: up_.loseNext(act.amount); break;
      case What::LoseDown: down_.loseNext(act.amount); break;
      case What::Stall: stallUntilMs_ = nowMs_ + act.amount; break;
    }
    isDisturbed_ = true;
    referee_.disturbs();
  }

  // Returns true when the task has ended.
  bool step(uint32_t untilMs) {
    uint32_t next = std::min(nowMs_ + kStepMs, untilMs);
    next = std::min({next, up_.nextMs(), down_.nextMs(), autopilot_->nextMs()});
    if (!acts_.empty())
      next = std::min(next, static_cast<uint32_t>(static_cast<int32_t>(beganMs_) + acts_.front().atMs));
    nowMs_ = std::max(next, nowMs_ + 1);
    referee_.at(nowMs_);
    while (!acts_.empty() && static_cast<int32_t>(nowMs_ - beganMs_) >= acts_.front().atMs) {
      const Act now = acts_.front();
      acts_.erase(acts_.begin());
      act(now);
    }
    while (up_.isDue(nowMs_)) {
      const Due due = up_.take();
      note();
      if (due.isWhole) autopilot_->hear(due.message, nowMs_);
    }
    autopilot_->pass(nowMs_);
    for (const Message& message : autopilot_->takeSent()) {
      note();
      down_.send(message, frameOf(message, sequence_++), true, nowMs_);
    }
    while (down_.isDue(nowMs_)) {
      const Due due = down_.take();
      note();
      const bool isStalled = nowMs_ < stallUntilMs_;
      const bool fits = !isStalled || sketch_.line.toRead.size() + due.bytes.size() <= kReceiveBuffer;
      if (!fits) continue;  // the receive buffer is full
      sketch_.line.bring(due.bytes);
      if (due.isWhole) referee_.comes(due.message, due.leftMs);
    }
    if (nowMs_ < stallUntilMs_) return false;
    sketch_.line.room = kTransmitBuffer - up_.waiting(nowMs_);
    const bool hasEnded = sketch_.loop(nowMs_);
    send();
    if (hasEnded && isNoting_) referee_.ends(sketch_.status(), sketch_, *autopilot_);
    return hasEnded;
  }

  void send() {
    const Bytes written = sketch_.line.takeWritten();
    if (written.empty()) return;
    note();
    size_t begin = 0;
    for (const Unpacker::Found& found : unpacker_.take(written)) {
      const size_t news = found.end - begin;
      up_.send(found.message, Bytes(std::max(news, found.length)), found.isRight, nowMs_,
               found.length > news ? found.length - news : 0);
      begin = found.end;
      if (found.isRight && referee_.leaves(found.message)) ordered();
    }
    if (begin < written.size()) up_.occupy(written.size() - begin, nowMs_);
  }

  const FlightPlan& plan_;
  Referee referee_;
  Sketch sketch_;
  std::unique_ptr<Autopilot> autopilot_;
  Line up_, down_;
  Unpacker unpacker_;
  uint32_t nowMs_;
  uint32_t beganMs_ = 0;
  uint32_t stallUntilMs_ = 0;
  unsigned orders_ = 0;  // how many orders have left
  bool isNoting_ = false, isDisturbed_ = false;
  uint8_t sequence_ = 0;
  std::vector<Act> acts_;
  Flown flown_;
};

}  // namespace

Flown fly(const FlightPlan& plan, std::string* log) { return Flying(plan, log).fly(); }
