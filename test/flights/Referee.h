// It sees both ends of the line, so it knows who has the aircraft, and it says which rule was broken.
//
// A mode that an actor sets, or a failsafe, is foreign from then on, as long as the aircraft is armed or a task runs.
// What must hold:
// - An order undoes a foreign mode only if it was set in the moment before the order's arrival (kWindowMs): for each
//   order leaves right behind a heartbeat, which shows no foreign mode.
// - If a heartbeat has shown that mode all the same, it is set again: within kGivenBackMs on a line that loses nothing,
//   within kGivenBackLossyMs, two heartbeats, on one that loses 1 of 200 bytes; if it is not, the status says so.
// - Behind a heartbeat that shows a foreign mode nothing leaves that moves, arms, or sets another mode than that.
// - What takes it, arms it or moves it leaves only if a heartbeat has come since loop() stood still last; nothing arms
// it
//   behind a heartbeat that shows that somebody has disarmed it, or after a takeover, until the sketch asks for it.
// - No frame is addressed to an aircraft for which nothing was begun, and it obeys none.
// - A task ends, and its status is true: see end().
// - Later on maySteer(), isArmed() and aboard() are true, and no aircraft stays armed that a failed task has armed: see
//   rest().
#pragma once

#include <string>

#include "Autopilot.h"
#include "Sketch.h"

// What a flight shows beside the rules.
struct Figures {
  bool hasTaken = false;  // somebody has taken the aircraft
  bool isUnseen = false;  // a foreign mode was undone for good, at a moment that no frame shows
  uint32_t longestWindowMs = 0, longestUndoneMs = 0;
  std::vector<uint32_t> undoneMs;  // how long each mode was undone that was set again after a heartbeat had shown it
};

class Referee : public Witness {
 public:
  static constexpr uint32_t kWindowMs = 45, kGivenBackMs = 300, kGivenBackLossyMs = 2000, kBlindMs = 600,
                            kUnheardMs = 3900;

  // `name` stands before each line of the log.
  Referee(Kind kind, std::string* log, const char* name) : kind_(kind), log_(log), name_(name) {}
  virtual ~Referee() = default;

  // Time has gone on.
  void at(uint32_t nowMs);
  void begins(Task task, double loss, bool isDisturbed, const Autopilot& autopilot);
  // The sketch names this aircraft as its own, leaves it, or asks for it again.
  void isNamed();
  void isLeft() {
    isNamed_ = hasBegun_ = isRunning_ = false;
    leftMs_ = nowMs_;
  }
  void isAsked();
  // loop() stands still until then.
  void standsStill(uint32_t untilMs, uint32_t forMs) {
    if (nowMs_ >= stoodStillMs_) stoodFromMs_ = nowMs_;
    stoodStillMs_ = untilMs;
    if (forMs >= kBlindMs) stoodBlindMs_ = untilMs;
    if (untilMs - cameMs_ > kUnheardMs) wasLost_ = true;
  }
  // An actor disturbs the line or loop(): from now on no rule holds that needs a line without losses.
  void disturbs() { isClean_ = false; }

  void modeSet(uint16_t mode, By by) override;
  void armed(bool isArmed, By by) override;
  void planSet(bool isOurs, By by) override;
  // A frame of the sketch leaves. Returns true if it moves the aircraft, arms it or changes its mode.
  bool leaves(const FrameParts& message);
  // A frame of the autopilot has arrived, which was sent at that time.
  void comes(const FrameParts& message, uint32_t sentMs);

  void ends(mavmission::Status status, const Sketch& sketch, const Autopilot& autopilot);
  // This is called when the line has lost nothing for some seconds, and nothing has happened.
  void rests(const Sketch& sketch, const Autopilot& autopilot);
  void restsAfterMany(const Sketch& sketch, const Autopilot& autopilot);
  void breaks(const std::string& rule);

  const std::string& broken() const { return broken_; }
  const Figures& figures() const { return figures_; }

 private:
  struct Foreign {
    bool is;
    uint16_t mode;
    uint32_t sinceMs;
    bool isShown;  // a heartbeat has shown it to the sketch
    uint32_t shownMs;
    bool isUndone;  // an order has undone it
    uint32_t undoneMs;
    bool isOfStream;  // it is PX4's failsafe for missing targets, which a target of ours ends
  };
  void say(const std::string& words);
  void judge(const FrameParts& message, bool isArming, bool isOrder);
  void take(uint16_t mode, uint16_t before);
  void obeys(const std::string& what);
  std::string name(uint16_t mode) const { return modeName(kind_, mode); }

  Kind kind_;
  std::string* log_;
  const char* const name_;
  std::string broken_;
  uint32_t nowMs_ = 0;
  Task task_ = Task::Start;
  bool isRunning_ = false;
  bool wasForeign_ = false;
  uint32_t beganMs_ = 0, takenMs_ = 0;  // when the task began, and when somebody has set a mode
  bool wasDisarmed_ = false;            // by somebody
  bool isHeard_ = false;                // since it was named
  uint32_t leftMs_ = 0;
  bool isKnown_ = false;   // since loop() stood still last, too
  bool isNamed_ = false;   // as the sketch's own
  bool hasBegun_ = false;  // something was begun for it, since it was named
  bool isClean_ = true;
  bool isBad_ = false;  // the line loses more than 1 of 200 bytes
  Figures figures_;
  Foreign foreign_ = Foreign();
  bool isArmed_ = false;                         // whether the aircraft is armed
  uint32_t armedMs_ = 0;                         // when that changed
  uint32_t wasArmedMs_ = 0;                      // when it was armed last
  bool wasArmedByUs_ = false;                    // whether an order armed it
  bool isOurPlan_ = false, wasOurPlan_ = false;  // the plan aboard is the sketch's, and once was
  uint32_t otherPlanMs_ = 0;
  uint32_t listedMs_ = 0;   // when the sketch began to read the items
  uint8_t otherNamed_ = 0;  // how many MISSION_CURRENTs about the other plan have arrived
  uint16_t mode_ = kNoSuchMode;
  bool isModeOurs_ = false;             // an order has set it, and was not cancelled
  uint32_t cancelledMs_ = 0;            // when the last one was
  uint16_t orderedMode_ = kNoSuchMode;  // the last one that a command has named
  uint32_t orderedMs_ = 0;
  uint16_t firstMode_ = kNoSuchMode;  // the mode when the task began
  bool isFirstOver_ = false;          // a heartbeat has shown another mode since, after an order
  bool hasOrdered_ = false;           // a command that is not only a request has left
  uint16_t shownMode_ = kNoSuchMode;
  uint16_t shownBefore_ = kNoSuchMode;  // the mode in a heartbeat some milliseconds earlier
  uint32_t cameMs_ = 0;
  bool isShownArmed_ = false, wasShownArmedBefore_ = false;  // by the last heartbeat; by the one before, as that mode
  uint32_t shownMs_ = 0;                                     // when the last heartbeat that arrived was sent
  uint32_t stoodFromMs_ = 0, stoodStillMs_ = 0;
  uint32_t stoodBlindMs_ = 0;                          // so long that a stream of targets stops
  bool isDisarmed_ = false, isDisarmedShown_ = false;  // by somebody, since the task began
  bool wasShownDisarmed_ = false;                      // since it was named
  bool isArmingShown_ = false;                         // a heartbeat, or the answer, has shown it armed in this task
  bool wasLost_ = false;                               // it was not heard for so long that its mode may be anybody's
  bool isKept_ = false;                                // somebody has taken it, and the sketch has not asked for it
};
