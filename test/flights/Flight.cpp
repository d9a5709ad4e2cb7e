#include "Flight.h"

#include <algorithm>
#include <stdexcept>

using mavmission::Status;

namespace {

constexpr uint32_t kBeginMs = 70000;  // what millis() says at the beginning
constexpr uint32_t kStepMs = 4;       // the longest time from one loop() to the next
constexpr uint32_t kLongestMs = 150000, kRestMs = 6000;
constexpr int kTransmitBuffer = 63;
constexpr uint32_t kLeadMs = 1400;  // actors may act so long before the task begins
constexpr uint32_t kNever = 0xFFFFFFFF;

// An aircraft, and who judges what the sketch does to it.
struct Vehicle {
  Vehicle(Kind kind, uint8_t systemId, std::string* log, uint32_t beatMs)
      : referee(kind, log, systemId == 1 ? "" : "(2) "), model(kind, systemId, referee, beatMs) {
    model.pass(kBeginMs);
  }
  Referee referee;
  Autopilot model;
  uint32_t silentUntilMs = 0;
  uint8_t sequence = 0;
};

// A device that is heard once a second.
struct Heard {
  Stranger who;
  uint32_t nextMs;
  uint8_t sequence;
};

// Returns the system to which a message is addressed; 0: to none.
uint8_t targetOf(const FrameParts& message) {
  const mavlink_msg_entry_t* const entry = mavlink_get_msg_entry(message.messageId);
  if (entry == nullptr || message.version != 2) throw std::runtime_error("what is sent is no frame of the library's");
  const bool hasTarget = (entry->flags & MAV_MSG_ENTRY_FLAG_HAVE_TARGET_SYSTEM) != 0;
  return hasTarget ? message.payload[entry->target_system_ofs] : uint8_t{0};
}

class Flying {
 public:
  Flying(const FlightPlan& plan, std::string* log)
      : plan_(plan), sketch_(plan.kind), up_(plan.seed * 2 + 1, 0), down_(plan.seed * 2 + 2, 0), nowMs_(kBeginMs) {
    const uint32_t beatMs = kBeginMs + 100 + plan.seed * 137 % 900;
    vehicles_.emplace_back(new Vehicle(plan.kind, 1, log, beatMs));
    if (plan.second != 0) {
      vehicles_.emplace_back(new Vehicle(static_cast<Kind>((plan.second - 1) % 3), 2, log, beatMs + 371));
      if (plan.second > 3) vehicles_[1]->model.putInAir(nowMs_);
      vehicles_[1]->silentUntilMs = kNever;
    }
    own().referee.isNamed();
    setMillis(nowMs_);
  }

  Flown fly() {
    for (const Act& act : plan_.acts) {
      if (act.atMs == kAlways) heard_.push_back(Heard{kStrangers[act.amount], nowMs_, 0});
    }
    if (!does(Task::Upload, 20000, Status::Accepted)) return broken("the upload does not end well");
    run(1200);
    if (isInAir(plan_.task)) {
      own().model.putInAir(nowMs_);
      run(1100);
      if (plan_.isInOwnMode && !does(Task::SetMode, 3000, Status::Done)) return broken("it cannot be prepared");
    }
    if (plan_.task == Task::Disarm && !does(Task::Arm, 3000, Status::Done)) return broken("it cannot be prepared");
    beganMs_ = nowMs_ + kLeadMs;
    for (const Act& act : plan_.acts) {
      if (act.order == 0 && act.atMs != kAlways) add(act);
    }
    isNoting_ = true;
    run(kLeadMs);
    up_.setLoss(plan_.loss);
    down_.setLoss(plan_.loss);
    // Half of the sketches order at once when loop() goes on, before update() comes by.
    isToBegin_ = plan_.seed % 2 == 0;
    while (nowMs_ < stallUntilMs_) step(stallUntilMs_);
    isToBegin_ = false;
    begin(plan_.task);
    if (!runUntilEnd(kLongestMs)) return broken("it does not end");
    const bool isQuiet = plan_.loss <= 0 && std::all_of(plan_.acts.begin(), plan_.acts.end(),
                                                        [](const Act& act) { return act.what == What::Stranger; });
    if (isQuiet && sketch_.status() != Status::Done) return broken("nothing happens, and it does not end well");
    flown_.tookMs = static_cast<int32_t>(nowMs_ - beganMs_);
    run(1000);
    isNoting_ = false;
    up_.setLoss(0);
    down_.setLoss(0);
    while (!acts_.empty() || nowMs_ < std::max(stallUntilMs_, own().silentUntilMs)) run(100);
    run(kRestMs);
    own().referee.rests(sketch_, own().model);
    broken("");
    if (flown_.broken.empty()) askAgain();
    flown_.broken = own().referee.broken();
    return flown_;
  }

  Flown play(unsigned operations, std::vector<Status>& ends) {
    random_ = Random(plan_.seed);
    vehicles_[1]->silentUntilMs = nowMs_ + below(2) * 2500;  // heard later, it is not taken for ours
    if (vehicles_[1]->silentUntilMs == nowMs_) named(0);
    run(4000);
    isNoting_ = true;
    up_.setLoss(plan_.loss);
    down_.setLoss(plan_.loss);
    for (unsigned i = 0; i < operations && flown_.broken.empty(); ++i) {
      beganMs_ = nowMs_;
      for (uint32_t acts = below(4); acts != 0; --acts) add(drawn());
      run(below(3) * below(2000));
      if (below(6) == 0) named(1 - own_);
      if (below(4) == 0) takesAgain();
      if (below(4) == 0 && own().model.plan.size() == kItems && !own().model.isArmed) {
        own().model.putInAir(nowMs_);
        run(1500);
      }
      isToBegin_ = below(2) != 0;
      while (nowMs_ < stallUntilMs_) step(stallUntilMs_);
      isToBegin_ = false;
      begin(drawnTask());
      const bool isBrokenOff = below(12) == 0;
      if (!runUntilEnd(isBrokenOff ? below(3000) : kLongestMs)) {
        if (!isBrokenOff) return broken("it does not end");
        if (below(2) == 0) {
          named(1 - own_);
        } else {
          sketch_.client.cancel();
          sketch_.target.stop();
        }
        if (!runUntilEnd(kLongestMs)) return broken("it does not end, though it was broken off");
      }
      ends.push_back(sketch_.status());
      broken("");
    }
    acts_.clear();
    up_.setLoss(0);
    down_.setLoss(0);
    own().silentUntilMs = nowMs_;
    while (nowMs_ < stallUntilMs_) step(stallUntilMs_);
    run(10000 + kRestMs);  // the line may be cut
    own().referee.restsAfterMany(sketch_, own().model);
    return broken("");
  }

 private:
  Vehicle& own() { return *vehicles_[own_]; }
  uint32_t below(uint32_t n) { return random_.below(n); }

  Flown broken(const std::string& rule) {
    flown_.broken = rule;
    for (const auto& vehicle : vehicles_) {
      if (!vehicle->referee.broken().empty()) flown_.broken = vehicle->referee.broken();
    }
    flown_.status = sketch_.status();
    flown_.figures = own().referee.figures();
    return flown_;
  }

  void run(uint32_t ms) {
    for (const uint32_t until = nowMs_ + ms; nowMs_ < until;) step(until);
  }

  bool runUntilEnd(uint32_t limitMs) {
    const uint32_t until = nowMs_ + limitMs;
    if (mavmission::isEnd(sketch_.status())) return true;  // it was refused at once
    while (nowMs_ < until + stoodMs_) {
      if (step(until + stoodMs_)) return true;
    }
    return false;
  }

  void begin(Task task) {
    own().referee.begins(task, plan_.loss, isDisturbed_, own().model);
    sketch_.begin(task);
    sketch_.loop(nowMs_);  // update() follows it in the same loop()
    send();
  }

  bool does(Task task, uint32_t limitMs, Status wanted) {
    begin(task);
    return runUntilEnd(limitMs) && sketch_.status() == wanted;
  }

  // Whoever has taken the aircraft keeps it, also when it has landed and was disarmed, until the sketch asks for it.
  void askAgain() {
    own().model.actorDisarms();
    run(1500);
    const Status who = sketch_.client.takenBy();
    begin(Task::Arm);
    runUntilEnd(kLongestMs);
    if (who == Status::Idle) return;
    if (sketch_.status() != who) own().referee.breaks("it is armed again for somebody else than who has taken it");
    takesAgain();
    begin(Task::Arm);
    if (!runUntilEnd(kLongestMs) || sketch_.status() == who) {
      own().referee.breaks("the sketch has asked for the aircraft, and does not get it");
    }
  }

  void takesAgain() {
    sketch_.steering.requestControl();
    own().referee.isAsked();
  }

  void named(uint8_t which) {
    own().referee.isLeft();
    own_ = which;
    sketch_.name(own().model.systemId, own().model.kind);
    cutter_ = FrameCutter();  // a frame for the other one is cut
    own().referee.isNamed();
  }

  void add(const Act& act) {
    acts_.push_back(act);
    std::stable_sort(acts_.begin(), acts_.end(), [](const Act& a, const Act& b) { return a.atMs < b.atMs; });
  }

  // Most tasks are those that an aircraft in the air, or on the ground, can do.
  Task drawnTask() {
    if (below(3) == 0 && own().model.plan.empty()) return Task::Upload;
    Task task = Task::Start;
    for (int draws = 0; draws < 3; ++draws) {
      task = static_cast<Task>(below(kTasks));
      if (isInAir(task) == own().model.isArmed) break;
    }
    return task;
  }

  // What happens at random, from now on.
  Act drawn() {
    const uint32_t kStalls[] = {250 + below(800), 2000 + below(9000), 65536, 131072};
    const What what = static_cast<What>(below(kWhats));
    uint32_t amount = below(2);
    switch (what) {
      case What::Cut: amount = 200 + below(8000); break;
      case What::LoseUp:
      case What::LoseDown: amount = 1 + below(4); break;
      case What::Stall: amount = kStalls[below(20) == 0 ? 2 + below(2) : below(2)]; break;
      case What::Silent: amount = 1000 + below(9000); break;
      case What::Stranger: amount = below(kStrangerCount) % 7; break;  // no other autopilot
      default: break;
    }
    return Act{what, static_cast<int32_t>(below(below(2) != 0 ? 400 : 6000)), amount, 0};
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
    Autopilot& model = vehicles_[act.what < What::Cut && act.amount < vehicles_.size() ? act.amount : 0]->model;
    const Kind kind = model.kind;
    switch (act.what) {
      case What::Pilot: return model.actorSetsMode(modeOf(kind, Means::Pilot), false, nowMs_);
      case What::Lands: return model.actorSetsMode(modeOfLanding(kind, plan_.task), false, nowMs_);
      case What::Holds: return model.actorSetsMode(modeOf(kind, Means::Hold), false, nowMs_);
      case What::Disarms: return model.actorDisarms();
      case What::Failsafe: return model.actorSetsMode(modeOf(kind, Means::Return), true, nowMs_);
      case What::OtherPlan: return model.actorSetsPlan(1);
      case What::SamePlan: return model.actorSetsPlan(0);
      case What::Clears: return model.clear();
      case What::Cut:
        up_.cutUntil(nowMs_ + act.amount);
        down_.cutUntil(nowMs_ + act.amount);
        break;
      case What::LoseUp: up_.loseNext(act.amount); break;
      case What::LoseDown: down_.loseNext(act.amount); break;
      case What::Stall:
        stallUntilMs_ = std::max(stallUntilMs_, nowMs_ + act.amount);
        stoodMs_ += act.amount;
        for (const auto& vehicle : vehicles_) vehicle->referee.standsStill(stallUntilMs_, act.amount);
        break;
      case What::Silent:
        own().silentUntilMs = nowMs_ + act.amount;
        if (vehicles_.size() > 1) vehicles_[1 - own_]->silentUntilMs = nowMs_;
        break;
      case What::Stranger: heard_.push_back(Heard{kStrangers[act.amount], nowMs_, 0}); return;
    }
    isDisturbed_ = true;
    for (const auto& vehicle : vehicles_) vehicle->referee.disturbs();
  }

  // Returns true when the task has ended.
  bool step(uint32_t untilMs) {
    uint32_t next = std::min(nowMs_ < stallUntilMs_ ? stallUntilMs_ : nowMs_ + kStepMs, untilMs);
    next = std::min({next, up_.nextMs(), down_.nextMs()});
    for (const auto& vehicle : vehicles_) next = std::min(next, vehicle->model.nextMs());
    for (const Heard& stranger : heard_) next = std::min(next, stranger.nextMs);
    if (!acts_.empty())
      next = std::min(next, static_cast<uint32_t>(static_cast<int32_t>(beganMs_) + acts_.front().atMs));
    nowMs_ = std::max(next, nowMs_ + 1);
    for (const auto& vehicle : vehicles_) vehicle->referee.at(nowMs_);
    while (!acts_.empty() && static_cast<int32_t>(nowMs_ - beganMs_) >= acts_.front().atMs) {
      const Act now = acts_.front();
      acts_.erase(acts_.begin());
      act(now);
    }
    while (up_.isDue(nowMs_)) {
      const Due due = up_.take();
      note();
      Vehicle* const to = vehicleOf(targetOf(due.message));
      if (due.isWhole && to != nullptr && to->silentUntilMs <= nowMs_) to->model.hear(due.message, nowMs_);
    }
    for (uint8_t i = 0; i < vehicles_.size(); ++i) speak(i);
    for (Heard& stranger : heard_) speak(stranger);
    while (down_.isDue(nowMs_)) {
      const Due due = down_.take();
      note();
      const bool isStalled = nowMs_ < stallUntilMs_;
      const bool fits = !isStalled || sketch_.line.toRead.size() + due.bytes.size() <= plan_.buffer;
      if (!fits) continue;  // the receive buffer is full
      sketch_.line.bring(due.bytes);
      if (due.isWhole && due.vehicle < vehicles_.size()) vehicles_[due.vehicle]->referee.comes(due.message, due.leftMs);
    }
    if (nowMs_ < stallUntilMs_ || (nowMs_ == stallUntilMs_ && isToBegin_)) return false;
    sketch_.line.room = kTransmitBuffer - up_.waiting(nowMs_);
    const bool hasEnded = sketch_.loop(nowMs_);
    send();
    if (hasEnded && isNoting_) own().referee.ends(sketch_.status(), sketch_, own().model);
    return hasEnded;
  }

  void speak(uint8_t which) {
    Vehicle& vehicle = *vehicles_[which];
    vehicle.model.pass(nowMs_);
    for (FrameParts& message : vehicle.model.takeSent()) {
      if (vehicle.silentUntilMs > nowMs_) continue;
      note();
      message.sequence = vehicle.sequence++;
      message.systemId = vehicle.model.systemId;
      down_.send(message, which, packed(message), true, nowMs_);
    }
  }

  void speak(Heard& stranger) {
    if (stranger.nextMs > nowMs_) return;
    stranger.nextMs += 1000;
    const Stranger& who = stranger.who;
    FrameParts beat = heartbeatParts(who.autopilot, MAV_MODE_FLAG_SAFETY_ARMED, 0, who.type, uint8_t{MAV_STATE_ACTIVE});
    beat.systemId = who.systemId;
    beat.componentId = who.componentId;
    beat.sequence = stranger.sequence++;
    down_.send(beat, 255, packed(beat), true, nowMs_);
  }

  Vehicle* vehicleOf(uint8_t systemId) {
    return systemId != 0 && systemId <= vehicles_.size() ? vehicles_[systemId - 1u].get() : nullptr;
  }

  void send() {
    const Bytes written = sketch_.line.takeWritten();
    if (written.empty()) return;
    note();
    size_t begin = 0;
    for (const FrameIn& found : cutter_.take(written)) {
      const size_t news = found.end - begin;
      up_.send(found.parts, 255, Bytes(std::max(news, found.size)), found.isRight, nowMs_,
               found.size > news ? found.size - news : 0);
      begin = found.end;
      const uint8_t target = targetOf(found.parts);
      if (!found.isRight) continue;
      Vehicle* const to = vehicleOf(target);
      if (target != 0 && to == nullptr) own().referee.breaks("a frame leaves to system " + std::to_string(target));
      if (to != nullptr && to->referee.leaves(found.parts)) ordered();
    }
    if (begin < written.size()) up_.occupy(written.size() - begin, nowMs_);
  }

  const FlightPlan& plan_;
  Sketch sketch_;
  std::vector<std::unique_ptr<Vehicle>> vehicles_;
  std::vector<Heard> heard_;
  uint8_t own_ = 0;  // the vehicle that is the sketch's
  Line up_, down_;
  FrameCutter cutter_;
  Random random_;
  uint32_t nowMs_;
  uint32_t beganMs_ = 0;
  uint32_t stallUntilMs_ = 0, stoodMs_ = 0;
  unsigned orders_ = 0;  // how many orders have left
  bool isNoting_ = false, isDisturbed_ = false;
  bool isToBegin_ = false;  // the sketch orders when loop() goes on, before update() comes by
  std::vector<Act> acts_;
  Flown flown_;
};

}  // namespace

Flown fly(const FlightPlan& plan, std::string* log) { return Flying(plan, log).fly(); }

Flown play(const FlightPlan& plan, unsigned operations, std::string* log, std::vector<Status>& ends) {
  return Flying(plan, log).play(operations, ends);
}
