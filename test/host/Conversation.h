// A whole client in conversation with an autopilot that the test plays: it says what happens in words, and is told as
// words what left and how each operation ended.
//
//   Conversation desk(Conversation::kArduPilot, kPlan);
//   CHECK(desk.plays("upload, 20 ms | asks 0-1, no space") == "COUNT 4 | ITEM 0, ITEM 1, -> NoSpace at 0 (Mixture)");
#pragma once

#include <string>

#include "ClientOnLine.h"
#include "Names.h"
#include "PlanFrames.h"

class Conversation : public ClientOnLine {
 public:
  // What the sketch's calls are about, and what the autopilot counts and gives.
  mavmission::ItemSource plan = mavmission::emptyPlan();
  mavmission::PlanType type = mavmission::PlanType::Mission;
  std::vector<mavmission::MissionItem> held;  // in the autopilot's numbers
  mavmission::FlightCommand command = mavmission::flightCommand(2500);

  // As the autopilot's heartbeats show it.
  uint8_t vehicle = 2, baseMode = 1, mavlinkVersion = 2;
  uint32_t mode = 0;
  bool beatsBySecond = true;
  bool beatsWhenAsked = true;  // at once; a request that is not answered is said as "BEAT?"

  std::vector<mavmission::Status> told;  // what onEnd() was told
  std::string progress;                  // what onProgress() was told since it was emptied: "1/3 2/3 "

  // The autopilot has been heard for `aloneMs`. `startMs`: of millis(); 0 is after a reset.
  explicit Conversation(uint8_t autopilot, uint32_t startMs = 65000, uint32_t aloneMs = 3000);
  template <size_t N>
  Conversation(uint8_t autopilot, const mavmission::MissionItem (&items)[N],
               mavmission::PlanType is = mavmission::PlanType::Mission, uint32_t startMs = 65000)
      : Conversation(autopilot, startMs) {
    isAbout(mavmission::inRam(items, N), is);
  }

  // From now on it is about this plan, which the autopilot has as it keeps it: after home, and without a yaw.
  Conversation& isAbout(const mavmission::ItemSource& source, mavmission::PlanType is = mavmission::PlanType::Mission);

  // What left, and how operations ended, while this happened, one after the other:
  //   20 ms, 9 s                   time passes, with a heartbeat each second
  //   until COUNT [9 s]            until that has been said; "no COUNT" if it has not within that time (20 s)
  //   upload, upload unread, upload always, again, verify, ensure, clear, download, send, arm, disarm, cancel
  //                              the sketch calls that
  //   asks 0-3, asks all           the autopilot asks for these items, each when the one before has left
  //   ask 2                        the same, and what leaves in 5 ms
  //   count [3], item 2, items, float item 2    it gives its plan, or a part of it
  //   accepted, denied, error, no space, cancelled, ...    MISSION_ACK
  //   ... of fence, ... named 7, ... named ours    with this type, and with this opaque_id or PX4's checksum
  //   answer 400 failed            COMMAND_ACK
  //   current 2 of 6               MISSION_CURRENT of an active mission
  //   beat, armed, disarmed, mode 5    a heartbeat, which shows that
  //   silence, heartbeats          it sends none by itself any more, or does again
  //   broken, lost, twice          a frame comes damaged, is lost, has the number of the one before
  //   full, free                   the port has no room, and our heartbeat waits for it; it has again
  //   clock                        from here on what leaves has its time
  //   |                            stands in the answer as well
  // After what the autopilot says 5 ms pass.
  std::string plays(const std::string& events);

  // The next of what is said begins without what was said before.
  void forget() { said_.clear(); }
  // So many ms, without a word about it.
  void pass(uint32_t ms);
  void tell(const FrameParts& parts);
  void beat();
  template <typename Message>
  void tell(uint16_t id, uint8_t crcExtra, const Message& message) {
    tell(FrameParts(id, message, crcExtra));
  }

  // How many of these bytes an update() takes.
  size_t readInOne(const Bytes& bytes = Bytes(600, 0x11));
  uint32_t checksum() const;  // PX4's, of what is held
  bool isArduPilot() const { return kind_ == kArduPilot; }

 private:
  void happens(const std::string& event);
  bool isCall(const std::string& event);
  bool isOfTheLine(const std::string& event);
  bool isHeartbeat(const std::string& event);
  bool isOfThePlan(const std::string& event, mavmission::PlanType of, uint32_t named);
  void until(const std::string& word, uint32_t limitMs);
  void say(const std::string& word);
  void one();
  std::string wordFor(const SentFrame& frame) const;
  static void noteEnd(void* context, mavmission::Status status);
  static void noteProgress(void* context, uint16_t done, uint16_t total);
  static bool take(void*, uint16_t, const mavmission::MissionItem&) { return true; }

  const uint8_t kind_;
  size_t ends_ = 0, sent_ = 0;
  bool isTimed_ = false;
  uint32_t clockMs_ = 0;
  struct Said {
    std::string word;
    std::vector<uint32_t> atMs;
  };
  std::vector<Said> said_;
};
