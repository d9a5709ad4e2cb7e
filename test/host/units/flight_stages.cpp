// A flight as conversations: what the aircraft shows and how operations end, and what the flight makes of it.
#include "mavmission/steering/FlightStages.h"

#include <doctest/doctest.h>
#include <stdlib.h>

#include <map>
#include <sstream>
#include <string>

using namespace mavmission;
using namespace mavmission::detail;

namespace {

const char* const kStates[] = {"idle", "preparing", "notready", "flying", "atstop", "landed", "ended"};
const char* const kEnders[] = {"nobody", "itself", "sketch", "pilot", "failsafe", "other", "refusal", "silence"};
const char* const kOrders[] = {"", "upload", "start", "takeoff", "goto", "home", "land", "disarm"};

// The words of a conversation, one after the other. `beat`: a second passes, and a heartbeat comes; with a number, so
// many. What ends with ! is a change of what the aircraft shows. `=Status`: the running operation ends. What begins
// with > must be what is begun now; any other word must be the state, with a slash and who has ended it.
struct Talk {
  FlightStages stages = FlightStages();
  FlightSight sight = FlightSight();
  uint32_t nowMs = 1000000;
  std::string began;
  std::string failed;

  Talk() {
    sight.isHeard = true;
    sight.mode = 1;
  }

  void step(bool isBeat) {
    stages.setNow(nowMs);
    stages.look(sight, isBeat);
    if (stages.takeBreak()) began = "break";
    const FlightOrder order = stages.due(sight.isHeard);
    if (order == FlightOrder::None) return;
    began = kOrders[static_cast<uint8_t>(order)];
    stages.begun(sight.mode);
  }
  std::string state() const {
    std::string text = kStates[static_cast<uint8_t>(stages.state())];
    if (stages.state() == FlightState::Ended) {
      text += std::string("/") + kEnders[static_cast<uint8_t>(stages.endedBy())];
    }
    return text;
  }
  void end(Status status, bool hasArmed = false) {
    stages.setNow(nowMs);
    stages.onEnd(status, sight, hasArmed);
    step(false);
  }

  bool say(const std::string& word) {
    typedef FlightOrder Order;
    static const std::map<std::string, Status> kEnds = {
        {"=accepted", Status::Accepted}, {"=aboard", Status::AlreadyAboard},   {"=unconfirmed", Status::Unconfirmed},
        {"=done", Status::Done},         {"=failed", Status::CommandFailed},   {"=denied", Status::CommandDenied},
        {"=silent", Status::NoAnswer},   {"=taken", Status::TakenOver},        {"=overruled", Status::Overruled},
        {"=pilot", Status::PilotHasIt},  {"=failsafe", Status::FailsafeHasIt}, {"=armed", Status::Armed},
        {"=notarmed", Status::NotArmed}, {"=unproven", Status::Unproven},      {"=nohome", Status::NoHome},
        {"=bad", Status::BadLatitude},   {"=otheritem", Status::OtherItem},    {"=cancelled", Status::Cancelled}};
    static const std::map<std::string, void (*)(Talk&)> kDoes = {
        {"fly", [](Talk& t) { t.stages.begin(Order::Upload); }},
        {"takeoff", [](Talk& t) { t.stages.begin(Order::TakeOff); }},
        {"goto", [](Talk& t) { t.stages.order(Order::GoTo); }},
        {"home", [](Talk& t) { t.stages.order(Order::Home); }},
        {"land", [](Talk& t) { t.stages.order(Order::Land); }},
        {"takeland", [](Talk& t) { t.stages.take(Order::Land); }},
        {"giveup", [](Talk& t) { t.stages.giveUp(Order::None); }},
        {"again", [](Talk& t) { t.stages.forget(); }},
        {"arrive", [](Talk& t) { t.stages.arrive(); }},
        {"armed!", [](Talk& t) { t.sight.isArmed = true; }},
        {"disarmed!", [](Talk& t) { t.sight.isArmed = false; }},
        {"silent!", [](Talk& t) { t.sight.isHeard = false; }},
        {"lossy!", [](Talk& t) { t.sight.isLossy = true; }},
        {"heard!", [](Talk& t) { t.sight.isHeard = true; }},
        {"mode1!", [](Talk& t) { t.sight.mode = 1; }},
        {"mode2!", [](Talk& t) { t.sight.mode = 2; }},
        {"mode3!", [](Talk& t) { t.sight.mode = 3; }},
        {"mayrest!", [](Talk& t) { t.sight.mayRest = true; }},
        {"pilot!", [](Talk& t) { t.sight.hands = FlightHands::Pilot; }},
        {"failsafe!", [](Talk& t) { t.sight.hands = FlightHands::Failsafe; }},
        {"unclear!", [](Talk& t) { t.sight.hands = FlightHands::Unclear; }},
        {"own!", [](Talk& t) { t.sight.hands = FlightHands::Own; }},
        {"over!", [](Talk& t) { t.sight.isOver = true; }},
        {"staysarmed!", [](Talk& t) { t.sight.staysArmed = true; }},
        {"otherplan!", [](Talk& t) { t.sight.isOtherPlan = true; }},
        {"=failed,disarmed", [](Talk& t) { t.end(Status::CommandFailed, true); }},
    };
    if (word.compare(0, 4, "beat") == 0) {
      const int count = word.size() > 4 ? atoi(word.c_str() + 4) : 1;
      for (int i = 0; i < count; ++i) {
        nowMs += 1000;
        step(sight.isHeard);
      }
      return true;
    }
    stages.setNow(nowMs);
    if (kDoes.count(word) != 0) {
      kDoes.at(word)(*this);
      return true;
    }
    if (kEnds.count(word) != 0) {
      end(kEnds.at(word));
      return true;
    }
    if (word[0] != '>') return word == state();
    const bool isSame = began == word.substr(1);
    began.clear();
    return isSame;
  }
};

// Where the conversation goes another way; "" if it goes as it says.
std::string differs(const std::string& conversation) {
  Talk talk;
  std::istringstream words(conversation);
  std::string said;
  for (std::string word; words >> word; said += word + " ") {
    const std::string began = talk.began;
    if (!talk.say(word)) return said + "<" + word + "> is " + talk.state() + " >" + began;
  }
  return "";
}

// The aircraft flies the plan; the pieces from which conversations are made.
#define AIRBORNE "fly beat >upload =accepted >start armed! =done flying beat3 flying "
#define NOTREADY "fly beat >upload =accepted >start =failed notready beat "
#define ALOFT "takeoff beat >takeoff armed! =done flying beat arrive atstop "

}  // namespace

TEST_CASE("each conversation of a flight ends as it says, and nothing is begun after a person") {
  static const char* const kTalks[] = {
      // A plan, and a second one.
      AIRBORNE "over! disarmed! beat landed beat9 > landed",
      AIRBORNE "over! disarmed! beat landed fly preparing beat >upload =aboard >start armed! =done flying",
      "fly preparing > beat >upload fly =accepted >start fly armed! =done flying fly beat9 >",
      // It flies, if to another item, or without saying so; but not where it is not armed.
      "fly beat >upload =accepted >start armed! =otheritem flying",
      "fly beat >upload =accepted >start armed! =unconfirmed flying",
      "fly beat >upload =accepted >start =otheritem notready beat5 >start armed! =done flying",
      // It is not ready: every 5 s again, for five minutes.
      NOTREADY "beat3 > beat >start =failed notready beat4 > beat >start armed! =done flying",
      "fly beat >upload =unconfirmed notready beat10 > beat >upload =accepted >start",
      NOTREADY "beat300 >start =failed ended/refusal beat99 >",
      NOTREADY "=failed beat9 >start =failed,disarmed ended/refusal",
      "fly beat >upload =accepted >start =denied notready beat4 > beat >start =denied ended/refusal beat9 >",
      "fly beat >upload =accepted >start =failed beat5 >start =denied ended/refusal",
      "takeoff beat >takeoff =denied ended/refusal",
      "fly beat >upload =bad ended/refusal beat9 >",
      "takeoff beat >takeoff =nohome notready beat5 >takeoff",
      // Nobody is heard; then silence.
      "fly silent! beat299 preparing > beat2 ended/refusal heard! beat9 > ended/refusal",
      "fly silent! beat200 preparing heard! beat >upload",
      "fly beat >upload =accepted >start silent! beat ended/silence >break heard! beat9 >",
      "fly beat >upload =accepted >start armed! silent! beat9 preparing > =silent ended/refusal heard! beat9 >",
      "fly beat >upload silent! beat ended/silence fly =silent heard! beat9 > ended/silence",
      NOTREADY "silent! beat ended/silence heard! beat9 >",
      NOTREADY "lossy! silent! beat9 notready beat ended/silence heard! beat9 >",
      NOTREADY "lossy! silent! beat9 notready heard! beat silent! beat9 notready beat ended/silence",
      AIRBORNE "over! disarmed! beat landed silent! beat ended/silence heard! beat9 > fly ended/silence beat9 >",
      AIRBORNE "over! disarmed! beat landed silent! fly beat ended/silence heard! beat9 >",  // it lasted already
      // Somebody arms it, disarms it, sets another mode on the ground.
      "armed! fly beat ended/refusal > disarmed! beat9 > fly > ended/refusal",
      "fly beat >upload armed! beat ended/pilot =armed disarmed! beat9 > ended/pilot",
      "fly beat >upload =armed ended/pilot",
      NOTREADY "armed! beat ended/pilot disarmed! beat9 >",
      NOTREADY "mode2! beat ended/pilot mode1! beat9 >",
      "fly beat >upload mode2! =accepted >start mode3! =failed notready mode2! beat notready mode1! beat ended/pilot",
      AIRBORNE "mode2! over! disarmed! beat landed mode3! beat ended/pilot mode2! beat9 >",
      AIRBORNE "mode2! over! disarmed! beat landed mode3! mayrest! beat9 landed",
      AIRBORNE "over! disarmed! beat landed failsafe! mode3! beat ended/failsafe mode1! own! beat9 > ended/failsafe",
      NOTREADY "failsafe! mode2! beat ended/failsafe own! beat9 >",
      AIRBORNE "over! disarmed! beat landed fly beat >upload mode3! beat ended/pilot =accepted > beat9 >",
      AIRBORNE "over! disarmed! beat landed armed! beat ended/pilot",
      // During start().
      "fly beat >upload =accepted >start =notarmed ended/pilot beat9 >",
      "fly beat >upload =accepted >start pilot! =taken ended/pilot disarmed! own! beat9 >",
      "fly beat >upload =accepted >start failsafe! =taken ended/failsafe",
      "fly beat >upload =accepted >start pilot! =overruled ended/pilot",
      "fly beat >upload =accepted >start otherplan! =unproven ended/other",
      "fly beat >upload =accepted >start =unproven ended/refusal",
      // In flight.
      AIRBORNE
      "pilot! beat ended/pilot own! beat disarmed! beat9 > ended/pilot fly ended/pilot > again idle fly beat >upload",
      AIRBORNE "failsafe! beat ended/failsafe disarmed! beat9 >",
      AIRBORNE "disarmed! beat ended/pilot beat9 >",
      AIRBORNE "otherplan! beat ended/other",
      AIRBORNE "unclear! beat5 flying own! beat flying over! disarmed! beat landed",
      AIRBORNE "unclear! beat6 ended/failsafe",
      AIRBORNE "silent! beat20 flying heard! beat flying over! disarmed! beat ended/silence beat9 >",
      AIRBORNE "silent! beat disarmed! heard! beat ended/silence",
      AIRBORNE "silent! beat pilot! heard! beat ended/silence beat9 >",
      AIRBORNE "silent! beat heard! beat pilot! beat ended/pilot",
      // What is in the air already is landed.
      "armed! takeland flying beat >land =done beat flying over! disarmed! beat landed",
      "armed! takeland beat >land takeland =pilot ended/pilot takeland ended/pilot beat9 > again takeland beat >land",
      AIRBORNE "giveup flying again flying",
      // A rover is disarmed at its end, while it is still ours.
      AIRBORNE "over! staysarmed! beat3 > beat >disarm disarmed! =done beat landed",
      AIRBORNE "over! staysarmed! beat4 >disarm =silent > beat >disarm",
      AIRBORNE "over! staysarmed! beat4 >disarm =pilot ended/pilot beat9 >",
      AIRBORNE "over! staysarmed! pilot! beat4 > ended/pilot",
      // It is given up.
      "fly beat >upload giveup ended/sketch beat =accepted beat9 > again fly beat >upload",
      "fly beat >upload =accepted >start giveup preparing =failed ended/sketch beat9 >",
      "fly beat >upload =accepted >start giveup armed! =done flying beat9 >",
      "takeoff beat >takeoff land armed! =done flying >land =done beat flying over! disarmed! beat landed",
      NOTREADY "home ended/sketch",
      // By orders.
      ALOFT "goto beat >goto =done flying arrive atstop home beat >home =done flying over! disarmed! beat landed",
      ALOFT "goto beat >goto =silent > beat >goto =done flying",
      ALOFT "goto beat >goto goto =silent beat >goto",
      ALOFT "goto beat >goto =bad atstop home beat >home =done",
      ALOFT "goto beat >goto =pilot ended/pilot home beat9 >",
      ALOFT "goto beat >goto =failsafe ended/failsafe land beat9 >",
      ALOFT "goto beat >goto =notarmed disarmed! beat ended/pilot",
      ALOFT "pilot! beat ended/pilot home > own! beat9 > ended/pilot",
      ALOFT "silent! beat7 atstop home flying > heard! beat >home =done over! disarmed! beat ended/silence",
      "goto home land idle beat9 >",
      // The line is lost while it takes off: it has to be brought down.
      "takeoff beat >takeoff armed! =silent flying land beat >land =done over! disarmed! beat landed",
      "takeoff beat armed! silent! =silent beat heard! land beat >land =done over! disarmed! beat ended/silence",
  };
  for (const char* talk : kTalks) {
    CAPTURE(talk);
    CHECK(differs(talk) == "");
  }
}

TEST_CASE("an order in the air is given 30 times, and then its refusal is told") {
  Talk talk;
  std::istringstream words(ALOFT "goto");
  for (std::string word; words >> word;) talk.say(word);
  talk.stages.takeNews();
  int given = 0;
  for (; given < 100 && talk.stages.why() == Status::Done; ++given) {
    talk.nowMs += 1000;
    talk.step(true);
    talk.end(Status::NoAnswer);
  }
  CHECK(given == 30);
  CHECK(talk.state() == "atstop");
  CHECK((talk.stages.why() == Status::NoAnswer));
  CHECK(talk.stages.takeNews());
  CHECK_FALSE(talk.stages.takeNews());
}

TEST_CASE("the time until it must be ready is the sketch's, and a state's time begins with the state") {
  Talk talk;
  talk.stages.setLimit(20);
  for (const char* word : {"fly", "silent!", "beat19"}) talk.say(word);
  CHECK(talk.state() == "preparing");
  CHECK(talk.stages.inStateMs(talk.nowMs) == 19000);
  talk.say("beat");
  CHECK(talk.state() == "ended/refusal");
  CHECK((talk.stages.why() == Status::NoAutopilot));
  CHECK(talk.stages.inStateMs(talk.nowMs + 7) == 7);
}
