#include "Exploration.h"

#include <string.h>

#include <algorithm>
#include <deque>

#include "ClientOnLine.h"
#include "PlanFrames.h"
#include "Plans.h"
#include "Random.h"
#include "mavmission/base/MavlinkHeaders.h"
#include "mavmission/console/PlanConsole.h"

using mavmission::Aboard;
using mavmission::Eeprom;
using mavmission::EepromPlan;
using mavmission::MissionItem;
using mavmission::PlanConsole;
using mavmission::Status;

namespace {

constexpr uint32_t kMostMs = 600000;  // an operation that runs for longer has no end
const char kHeader[] = "QGC WPL 110";
const char kHomeLine[] = "0\t1\t0\t16\t0\t0\t0\t0\t0\t0\t0\t1";

const char kStored[] = "stored: list prints it";
const char kErased[] = "erased";

typedef std::vector<uint8_t> Plan;  // the numbers of its items in Plans.h, without home

// The line of a .waypoints file, behind the number of the item.
const std::string& fieldsOf(uint8_t item) {
  static std::string made[256];
  if (!made[item].empty()) return made[item];
  mavlink_mission_item_int_t place;
  memcpy(&place, payloadOf(item, 0, kMission, Firmwares::Px4, false).data(), sizeof(place));
  char fields[80];
  snprintf(fields, sizeof(fields), "\t0\t3\t16\t0\t0\t0\tnan\t-%d.%07d\t%d.%07d\t20\t1", -place.x / 10000000,
           -place.x % 10000000, place.y / 10000000, place.y % 10000000);
  return made[item] = fields;
}

std::string lineOf(uint8_t item, size_t number) { return std::to_string(number) + fieldsOf(item); }

std::vector<std::string> fileOf(const Plan& plan) {
  std::vector<std::string> lines = {kHeader, kHomeLine};
  for (uint8_t item : plan) lines.push_back(lineOf(item, lines.size() - 1));
  return lines;
}

bool isErasing(char c) { return c == '\b' || c == 0x7F; }
bool isBlank(char c) { return c == ' ' || c == '\t'; }

// The lines that somebody can do.
enum Word : uint8_t { kNone, kUpload, kVerify, kDownload, kClear, kStart, kCancel, kErase, kLoad, kEnd, kOther };
const char* const kWords[] = {"",      "upload", "verify", "download", "clear",  "start", "cancel",
                              "erase", "load",   "end",    "list",     "status", "help"};  // fmt: skip
constexpr unsigned bit(Word word) { return 1u << word; }
constexpr unsigned kOperations = bit(kUpload) | bit(kVerify) | bit(kDownload) | bit(kClear) | bit(kStart);

// What the lines that have been read ask for: by what is seen on them when they end, and apart from the console's code.
struct Paper {
  unsigned asked = 0;         // the words that were read in this loop()
  unsigned askedInOrder = 0;  // those of them that were not in doubt
  bool isInDoubt = false;     // what was asked for last to be stored is not, and nobody has typed cancel
  bool isAwaited = false;     // and it is the plan in `awaited`
  bool isDownload = false;    // and it is what is aboard
  Plan awaited;

  // `isGap`: the port has lost bytes in front of this one.
  void take(char c, bool isGap) {
    isSpoilt_ |= isGap;
    const bool isSecond = wasReturn_ && c == '\n';
    wasReturn_ = c == '\r';
    if (isSecond) return;
    if (c != '\r' && c != '\n') {
      line_ += c;
      return;
    }
    endLine();
    dropLine();
  }
  void dropLine() {
    line_.clear();
    isSpoilt_ = false;
  }
  void ask(bool forDownload) {
    isInDoubt = true;
    isAwaited = false;
    isDownload = forDownload;
  }
  void await(const Plan& plan) {
    isAwaited = !plan.empty();
    awaited = plan;
  }

 private:
  void endLine() {
    size_t first = 0;
    while (first < line_.size() && (isBlank(line_[first]) || isErasing(line_[first]))) ++first;
    const char c = first < line_.size() ? line_[first] : '\0';
    const bool isOfFile = c == 'Q' || c == '#' || (c >= '0' && c <= '9');
    if (isInText_ && (isOfFile || !isalpha(static_cast<uint8_t>(c)))) return text_.push_back(isSpoilt_ ? "?" : line_);
    if (isOfFile) return ask(false);
    if (c == '\0') return;
    std::string seen;
    bool isLong = false;
    for (char next : line_.substr(first)) {
      if (!isErasing(next)) {
        seen += static_cast<char>(tolower(next));
      } else if (!seen.empty()) {
        seen.pop_back();
      }
      isLong |= seen.size() == 12;
    }
    while (!seen.empty() && isBlank(seen.back())) seen.pop_back();
    const auto found = std::find(kWords + 1, std::end(kWords), seen);
    const int which = static_cast<int>(found - kWords);
    const bool isNone = isSpoilt_ || isLong || found == std::end(kWords);
    const Word word = isNone ? kNone : static_cast<Word>(std::min<int>(which, kOther));
    asked |= bit(word);
    if (!isInDoubt) askedInOrder |= bit(word);
    if (word == kLoad || word == kDownload) ask(word == kDownload);
    if (word == kEnd && isInText_) readText();
    if (word == kCancel) isInDoubt = isAwaited = false;
    isInText_ = word == kLoad;
    text_.clear();
  }

  // Empty lines and comments may stand behind the first line.
  void readText() {
    Plan plan;
    size_t number = 0;
    for (std::string& line : text_) {
      while (line.compare(0, 2, "00") == 0) line.erase(0, 1);
      const bool isEmpty = line.find_first_not_of(" \t") == std::string::npos;
      if (number != 0 && (isEmpty || line[0] == '#')) continue;
      if (number < 2) {
        if (line != (number == 0 ? kHeader : kHomeLine)) return;
      } else {
        int item = 255;
        while (item > 0 && (item == kHome || line != lineOf(static_cast<uint8_t>(item), number - 1))) --item;
        if (item == 0) return;
        plan.push_back(static_cast<uint8_t>(item));
      }
      ++number;
    }
    await(plan);
  }

  std::string line_;
  std::vector<std::string> text_;
  bool isInText_ = false, isSpoilt_ = false, wasReturn_ = false;
};

std::vector<uint8_t> memory;

// The port: it may have a ring for 63 bytes, and loses what comes when that is full.
class Keyboard : public MemoryStream {
 public:
  Paper paper;
  const PlanConsole* console = nullptr;
  std::deque<uint8_t> coming;
  size_t ring = 0, bytesPerMs = 0;

  void pass(uint32_t ms) {
    for (size_t left = ring == 0 ? coming.size() : std::min<size_t>(coming.size(), bytesPerMs * ms); left != 0;
         --left) {
      if (ring != 0 && toRead.size() == ring) {
        isGap_ = true;
      } else {
        toRead.push_back(coming.front());
        gaps_.push_back(isGap_);
        isGap_ = false;
      }
      coming.pop_front();
    }
  }
  void closeGap() { isGap_ = false; }
  int read() override {
    const int byte = MemoryStream::read();
    if (byte < 0) return byte;
    // (It says of these that they were ignored.)
    if (console->isOverrun_) {
      paper.dropLine();
    } else {
      paper.take(static_cast<char>(byte), gaps_.front());
    }
    gaps_.pop_front();
    return byte;
  }

 private:
  std::deque<bool> gaps_;
  bool isGap_ = false;
};

// The aircraft around the plan: it does what it is ordered at once.
struct Aircraft {
  bool isArmed = false;
  uint8_t mode = 0;  // ArduPilot's; of PX4 the main mode, and 4 is AUTO.MISSION
  uint16_t current = 0;
};

class Terminal {
 public:
  Terminal(Firmwares firmware, uint32_t seed, std::string* log)
      : random_(seed),
        log_(log),
        firmware_(firmware),
        station_(isPx4() ? ClientOnLine::kPx4 : ClientOnLine::kArduPilot) {
    memory.assign(400, 0xFF);
    autopilot_.begin(firmware, kMission);
    beside_.begin(firmware, kRally);
    beside_.hold(0, 0);
    autopilot_.hold(0, static_cast<uint16_t>(random_.below(5)));
    station_.beats = station_.saysVehicle = false;
    station_.client.setTargetIds(1, 1);
    keyboard_.console = &console_;
    plan_.begin();
    console_.offerAll();
    const uint8_t steps[] = {1, 4, 10, 20};
    stepMs_ = steps[random_.below(4)];
    if (random_.oneIn(3)) {
      console_.setRing(static_cast<uint8_t>(keyboard_.ring = 63));
      keyboard_.bytesPerMs = 1 + random_.below(11);
      stepMs_ = 1;
    }
    lossOf100_ = random_.oneIn(2) ? random_.below(20) : 0;
    copiesOf100_ = random_.oneIn(2) ? random_.below(30) : 0;
    secondLinkMs_ = random_.oneIn(3) ? 5 + random_.below(296) : 0;
    latencyMs_ = random_.oneIn(4) ? 150 : 10;
  }

  // Null, or what is untrue.
  const char* run(Findings* findings) {
    constexpr uint32_t kTypedMs = 120000;
    const uint32_t endMs = station_.nowMs() + kTypedMs;
    for (;;) {
      const bool isOver = static_cast<int32_t>(station_.nowMs() - endMs) > 0;
      if (isOver && !station_.client.isBusy()) return broken_;
      if (!isOver) typeSomething();
      loop(findings);
      if (broken_ != nullptr) return broken_;
    }
  }

 private:
  bool isPx4() const { return firmware_ == Firmwares::Px4; }
  uint8_t missionMode() const { return isPx4() ? 4 : 3; }

  void say(const std::string& what) {
    if (log_ == nullptr) return;
    *log_ += std::to_string(station_.nowMs() - 65000) + " ms  ";
    for (char c : what) {
      char shown[8] = {c};
      if (c < ' ' || c > '~') snprintf(shown, sizeof(shown), "\\x%02X", static_cast<uint8_t>(c));
      *log_ += shown;
    }
    *log_ += "\n";
  }
  void breaks(const char* rule) {
    if (broken_ == nullptr) broken_ = rule;
  }

  // --- The typist

  Plan drawnPlan() {
    Plan plan;
    const uint8_t which = static_cast<uint8_t>(random_.below(16));
    for (uint32_t i = 0, count = 1 + random_.below(kMostItems); i < count; ++i) plan.push_back(itemOf(which, i));
    return plan;
  }

  std::string drawnWord() { return kWords[1 + random_.below(12)]; }

  // A file, which may be spoilt in one place.
  std::string drawnFile() {
    std::vector<std::string> lines = fileOf(drawnPlan());
    if (random_.oneIn(3)) {
      const size_t at = random_.below(static_cast<uint32_t>(lines.size()));
      std::string& line = lines[at];
      const char wrong[] = {'x', '\b', '\0', '\xFF', '\x80', '#', 'Q', '-'};
      switch (random_.below(8)) {
        case 0: line[random_.below(static_cast<uint32_t>(line.size()))] = wrong[random_.below(3)]; break;
        case 1: line.insert(random_.below(static_cast<uint32_t>(line.size())), 1, wrong[random_.below(5)]); break;
        case 2: line.resize(random_.below(8)); break;
        case 3: lines.erase(lines.begin() + static_cast<long>(at)); break;
        case 4: lines.insert(lines.begin() + static_cast<long>(at), line); break;
        case 5: line += random_.oneIn(2) ? std::string(300, ' ') : std::string(random_.below(300), '7'); break;
        case 6: lines.insert(lines.begin() + static_cast<long>(at), random_.oneIn(2) ? "" : "# a word"); break;
        default: lines.insert(lines.begin() + static_cast<long>(at), drawnWord()); break;
      }
    }
    std::string file;
    for (const std::string& line : lines) file += line + end_;
    return file;
  }

  std::string drawnLine() {
    std::string word = drawnWord();
    switch (random_.below(12)) {
      case 0: {  // with letters too many, of which some are erased
        const uint32_t more = 1 + random_.below(8);
        word += std::string(more, static_cast<char>('a' + random_.below(26)));
        for (uint32_t erased = random_.below(more + 2); erased != 0; --erased) word += random_.oneIn(2) ? '\b' : '\x7F';
        break;
      }
      case 1: word.erase(random_.below(static_cast<uint32_t>(word.size())), 1); break;
      case 2: word = std::string(random_.below(3), ' ') + "\b" + word + " \t"; break;
      case 3: word[0] = static_cast<char>(toupper(word[0])); break;
      case 4: word += drawnWord(); break;
      case 5: word = std::string(random_.below(600), 'a'); break;
      case 6:
        word.clear();
        for (uint32_t left = random_.below(40); left != 0; --left) word += static_cast<char>(random_.below(256));
        break;
      default: break;
    }
    return word + end_;
  }

  std::string drawnPaste() {
    std::string text;
    for (uint32_t parts = 1 + random_.below(3) * random_.below(2); parts != 0; --parts) {
      if (!random_.oneIn(3)) {
        text += drawnLine();
        continue;
      }
      if (!random_.oneIn(8)) text += "load" + end_;
      text += drawnFile();
      if (!random_.oneIn(8)) text += "end" + end_;
      if (random_.oneIn(2)) text += (random_.oneIn(3) ? "start" : "upload") + end_;
    }
    if (random_.oneIn(20)) text.resize(random_.below(static_cast<uint32_t>(text.size() + 1)));
    return text;
  }

  void typeSomething() {
    if (static_cast<int32_t>(station_.nowMs() - typesMs_) < 0) return;
    const uint32_t most[] = {60, 300, 2000, 6000};
    typesMs_ = station_.nowMs() + random_.below(most[random_.below(4)]);
    const char* const ends[] = {"\n", "\r\n", "\r"};
    end_ = ends[random_.below(3)];
    const std::string text = drawnPaste();
    say("typed: " + text);
    keyboard_.coming.insert(keyboard_.coming.end(), text.begin(), text.end());
  }

  // --- The line: two links, or one that may bring a frame twice

  typedef std::vector<std::pair<uint32_t, Bytes>> Way;

  void send(Way& way, const Bytes& bytes) {
    for (int link = 0; link < 2; ++link) {
      const bool isCopy = link == 1 && secondLinkMs_ == 0;
      if (isCopy && random_.below(100) >= copiesOf100_) continue;
      if (isDown_[link] || random_.below(100) < lossOf100_) continue;
      const uint32_t laterMs = link == 0 ? 0 : isCopy ? 5 + random_.below(296) : secondLinkMs_;
      way.push_back({station_.nowMs() + latencyMs_ + laterMs, bytes});
    }
  }

  bool take(Way& way, Bytes& bytes) {
    for (auto due = way.begin(); due != way.end(); ++due) {
      if (static_cast<int32_t>(station_.nowMs() - due->first) < 0) continue;
      bytes = due->second;
      way.erase(due);
      return true;
    }
    return false;
  }

  // --- The autopilot

  void speak(FrameParts parts) {
    parts.sequence = sequence_++;
    send(toClient_, packed(parts));
  }

  void answer(const Answers& answers) {
    for (int i = 0; i < answers.count; ++i) {
      say("autopilot: " + inWords(answers.messages[i]));
      speak(partsOf(answers.messages[i], firmware_));
    }
  }

  void sayCurrent(uint16_t item) {
    const uint16_t home = !isPx4() && autopilot_.heldCount != 0;
    const uint16_t items = static_cast<uint16_t>(autopilot_.heldCount - home);
    const uint8_t state = items == 0          ? MISSION_STATE_NO_MISSION
                          : aircraft_.isArmed ? MISSION_STATE_ACTIVE
                                              : MISSION_STATE_NOT_STARTED;
    speak(currentParts(item, items == 0 && isPx4() ? 65535 : items, state, autopilot_.heldSum));
  }

  void obey(const mavlink_command_long_t& given) {
    uint8_t result = MAV_RESULT_ACCEPTED;
    switch (given.command) {
      case MAV_CMD_COMPONENT_ARM_DISARM: aircraft_.isArmed = given.param1 == 1; break;
      case MAV_CMD_MISSION_START:
        aircraft_.mode = missionMode();
        if (isPx4()) aircraft_.isArmed = true;
        if (isPx4()) aircraft_.current = 0;
        break;
      case MAV_CMD_DO_SET_MODE: aircraft_.mode = static_cast<uint8_t>(given.param2); break;
      case MAV_CMD_DO_SET_MISSION_CURRENT:
        aircraft_.current = static_cast<uint16_t>(std::max(given.param1, isPx4() ? 0.0f : 1.0f));
        return sayCurrent(aircraft_.current);
      case MAV_CMD_REQUEST_MESSAGE:
        if (given.param1 == MAVLINK_MSG_ID_HEARTBEAT) {
          beat();
        } else if (given.param1 == MAVLINK_MSG_ID_MISSION_CURRENT && !isPx4()) {
          sayCurrent(aircraft_.current);
        } else {
          result = MAV_RESULT_DENIED;
        }
        break;
      default: result = MAV_RESULT_UNSUPPORTED;
    }
    speak(commandAckParts(given.command, result));
  }

  void beat() {
    if (autopilot_.bootsInMs != kNever) return;
    const uint32_t px4Mode = aircraft_.mode == missionMode() ? 4u << 16 | 4u << 24 : 3u << 16;
    speak(heartbeatParts(isPx4() ? MAV_AUTOPILOT_PX4 : MAV_AUTOPILOT_ARDUPILOTMEGA, aircraft_.isArmed ? 1 | 128 : 1,
                         isPx4() ? px4Mode : aircraft_.mode, MAV_TYPE_QUADROTOR,
                         aircraft_.isArmed ? MAV_STATE_ACTIVE : MAV_STATE_STANDBY));
    if (isPx4()) sayCurrent(aircraft_.current);
  }

  void passAutopilot() {
    for (bool& isDown : isDown_) {
      if (secondLinkMs_ != 0 && random_.oneIn(isDown ? 200 : 1000)) isDown = !isDown;
    }
    if (random_.oneIn(20000)) {
      say("the autopilot reboots");
      autopilot_.reboot();
      beside_.reboot();
      aircraft_ = Aircraft();
    }
    // Its pilot lands some time after a start.
    if (aircraft_.isArmed && !station_.client.isBusy() && random_.oneIn(200)) aircraft_ = Aircraft();
    autopilot_.pass(static_cast<uint16_t>(stepMs_));
    beside_.pass(static_cast<uint16_t>(stepMs_));
    for (Autopilot* one : {&autopilot_, &beside_}) {
      while (one->nextMs() == 0) {
        Answers answers;
        one->act(answers);
        answer(answers);
      }
    }
    for (Bytes frame; take(toAutopilot_, frame);) {
      Message message;
      if (autopilot_.bootsInMs != kNever) continue;
      if (decodeCommand(frame)) {
        obey(command_);
      } else if (isOfPlans(frame) && decode(frame, firmware_, message) == nullptr) {
        say(inWords(message) + " arrives");
        Answers answers;
        hearOfKinds(autopilot_, beside_, message, answers);
        answer(answers);
      }
    }
    if (station_.nowMs() - beatMs_ < 1000) return;
    beatMs_ = station_.nowMs();
    beat();
  }

  static uint16_t idOf(const Bytes& frame) { return static_cast<uint16_t>(frame[7] | frame[8] << 8); }
  static bool isOfPlans(const Bytes& frame) {
    const uint16_t id = idOf(frame);
    return (id >= MAVLINK_MSG_ID_MISSION_REQUEST && id <= MAVLINK_MSG_ID_MISSION_ACK &&
            id != MAVLINK_MSG_ID_MISSION_CURRENT && id != MAVLINK_MSG_ID_MISSION_SET_CURRENT) ||
           id == MAVLINK_MSG_ID_MISSION_REQUEST_INT || id == MAVLINK_MSG_ID_MISSION_ITEM_INT;
  }
  // MISSION_SET_CURRENT is the same as a command.
  bool decodeCommand(const Bytes& frame) {
    memset(&command_, 0, sizeof(command_));
    if (idOf(frame) == MAVLINK_MSG_ID_MISSION_SET_CURRENT) {
      command_.command = MAV_CMD_DO_SET_MISSION_CURRENT;
      command_.param1 = frame[10];
    } else if (idOf(frame) == MAVLINK_MSG_ID_COMMAND_LONG) {
      memcpy(&command_, &frame[10], std::min<size_t>(frame[1], sizeof(command_)));
    }
    return command_.command != 0;
  }

  // --- The truth

  Plan aboard() const {
    const uint8_t* first = autopilot_.held;
    const uint8_t* const last = first + autopilot_.heldCount;
    if (!isPx4() && first != last) ++first;
    return Plan(first, last);
  }
  Plan stored() {
    Plan plan;
    const mavmission::ItemSource source = plan_.source();
    for (uint16_t i = 0; plan_.hasPlan() && i < plan_.count(); ++i) {
      MissionItem item;
      plan.push_back(source.read(source.context, i, item) ? itemDownloaded(item, false, kMission) : kNoItemAtAll);
    }
    return plan;
  }
  uint16_t onTheWire() const { return static_cast<uint16_t>(meant_.size() + (!isPx4() && !meant_.empty())); }
  bool runs(unsigned words) const { return ((running_ | leaving_) & words) != 0; }
  // What an operation had on its way out when it ended still leaves.
  void leave() {
    leaving_ = running_;
    running_ = 0;
    leftLoops_ = 5;
  }
  bool usesPlan() const { return running_ != 0 && (running_ & (bit(kClear) | bit(kDownload))) == 0; }

  void judgeOrder(uint16_t command) {
    if (!runs(bit(kStart))) return breaks("the aircraft is ordered to do something, and no line asked for it");
    const bool isUndone = command == MAV_CMD_COMPONENT_ARM_DISARM && command_.param1 == 0;
    if (!isUndone && aboard() != meant_) breaks("what is started is not the plan that the lines have stored");
  }

  void judgeSent(const Bytes& frame) {
    if (decodeCommand(frame)) {
      say("client: command " + std::to_string(command_.command));
      const uint16_t orders[] = {MAV_CMD_COMPONENT_ARM_DISARM, MAV_CMD_MISSION_START, MAV_CMD_DO_SET_MODE,
                                 MAV_CMD_DO_SET_MISSION_CURRENT};
      if (std::count(std::begin(orders), std::end(orders), command_.command)) judgeOrder(command_.command);
      return;
    }
    const uint16_t id = idOf(frame);
    if (id == MAVLINK_MSG_ID_COMMAND_INT || id == MAVLINK_MSG_ID_SET_MODE) return judgeOrder(0);
    if (!isOfPlans(frame)) return;
    Message message;
    const char* const wrong = decode(frame, firmware_, message);
    if (wrong != nullptr) return breaks(wrong);
    say("client: " + inWords(message));
    switch (message.kind) {
      case Kind::ClearAll:
        if (!runs(bit(kClear))) breaks("the plan aboard is deleted, and no line asked for it");
        return;
      case Kind::Count:
        if (!runs(bit(kUpload))) return breaks("a plan is uploaded, and no line asked for it");
        if (message.number != onTheWire()) breaks("another number of items than the lines have stored is announced");
        return;
      case Kind::Item: {
        if (!runs(bit(kUpload))) return breaks("a plan is uploaded, and no line asked for it");
        const size_t at = message.number - (isPx4() ? 0u : 1u);
        const bool isHome = message.number == 0 && !isPx4();
        if (!isHome && (at >= meant_.size() || meant_[at] != message.item))
          breaks("an item is sent that is not of the plan that the lines have stored");
        return;
      }
      case Kind::List:
      case Kind::Request:
        if (!runs(kOperations)) breaks("a plan is read, and no line asked for it");
        return;
      default: return;
    }
  }

  void judgeEnd(Status status, Findings* findings) {
    say(std::string("it ends: ") + mavmission::toString(status));
    if (findings != nullptr) {
      ++findings->operations;
      ++findings->ends[mavmission::toString(status)];
    }
    const bool isMeant = aboard() == meant_;
    switch (status) {
      case Status::Accepted:
      case Status::Verified:
        if (!runs(bit(status == Status::Accepted ? kUpload : kVerify))) breaks("an end that was not asked for");
        if (!isMeant) breaks("Accepted or Verified, and another plan is aboard");
        ours_ = meant_;
        break;
      case Status::OtherPlanAboard:
        if (isMeant) breaks("OtherPlanAboard, and the plan aboard is the plan meant");
        break;
      case Status::Differs:
        if (isMeant) breaks("Differs, and the plan aboard is the plan stored");
        break;
      case Status::Downloaded:
        if (!runs(bit(kDownload))) breaks("an end that was not asked for");
        downloaded_ = aboard();
        if (keyboard_.paper.isDownload) keyboard_.paper.await(downloaded_);
        break;
      case Status::Cleared:
        if (!runs(bit(kClear))) breaks("an end that was not asked for");
        if (!aboard().empty()) breaks("Cleared, and a plan is aboard");
        break;
      case Status::Done:
        if (!runs(bit(kStart))) breaks("an end that was not asked for");
        if (!isMeant || (!aircraft_.isArmed && autopilot_.bootsInMs == kNever))
          breaks("Done, and the plan stored is not flown");
        break;
      default: break;
    }
    judgeAboard();
    if (!station_.client.isBusy()) leave();
  }

  void judgeAboard() {
    const Aboard said = station_.client.aboard();
    if (said == Aboard::OurPlan && aboard() != ours_) breaks("aboard() says our plan, and it is not");
    if (said == Aboard::Nothing && !aboard().empty()) breaks("aboard() says no plan, and one is aboard");
  }

  // What the lines of this loop() have begun.
  void judgeBegun(bool wasBusy) {
    const unsigned asked = keyboard_.paper.asked;
    if (asked == 0 || (wasBusy && (asked & bit(kCancel)) == 0)) return;
    if (!wasBusy && station_.client.isBusy() && (asked & kOperations) == 0)
      return breaks("an operation has begun, and no line asked for it");
    if ((asked & kOperations) == 0) return;
    if (!wasBusy) leave();
    running_ |= asked & kOperations;
    meant_ = stored();
    if (meant_.empty() && runs(bit(kStart))) meant_ = ours_;
    begunMs_ = station_.nowMs();
    if (wasBusy || !station_.client.isBusy())
      return;  // two operations in one update(): it cannot be seen here which of them runs
    if (usesPlan() && (keyboard_.paper.askedInOrder & running_) == 0)
      breaks("a plan is used, and a load or download behind it has failed");
    if (usesPlan() && plan_.hasPlan() && meant_ != kept_)
      breaks("a plan is used that the console has not said to be stored");
  }

  void judgeSaid(const std::string& line) {
    say("console: " + line);
    Paper& paper = keyboard_.paper;
    unsigned done, total;
    int end = 0;
    if (line == kStored) {
      kept_ = stored();
      if (paper.isAwaited && kept_ == paper.awaited) {
        paper.isInDoubt = paper.isAwaited = false;
      } else if (kept_ != downloaded_) {
        breaks("a plan is stored that is neither in the last lines nor was aboard");
      }
      downloaded_.clear();
    } else if (line == kErased) {
      kept_ = stored();
      if (!kept_.empty()) breaks("erased, and a plan is stored");
    } else if (line == "aboard: our plan, whole") {
      judgeAboard();
      if (plan_.hasPlan() && aboard() != stored()) breaks("the console says our plan, and that is not the one stored");
    } else if (line == "aboard: an earlier plan of ours, whole" || line == "aboard: no plan") {
      judgeAboard();
    } else if (line.compare(0, 14, "stored: items ") == 0) {
      // (What is stored may have changed while this was printed.)
      const size_t items = std::stoul(line.substr(14));
      if (items != stored().size() && items != kept_.size()) breaks("it says a wrong number of items");
    } else if (sscanf(line.c_str(), "%u/%u%n", &done, &total, &end) == 2 && end == static_cast<int>(line.size())) {
      if (done > total || (usesPlan() && total != meant_.size()))
        breaks("it counts other items than those of the plan");
    }
  }

  void loop(Findings* findings) {
    passAutopilot();
    for (Bytes frame; take(toClient_, frame);) station_.line.bring(frame);
    keyboard_.pass(stepMs_);
    station_.sent.clear();
    station_.ends.clear();
    station_.run(stepMs_, stepMs_);
    if (findings != nullptr) ++findings->transitions;
    for (const SentFrame& sent : station_.sent) {
      judgeSent(sent.frame);
      send(toAutopilot_, sent.frame);
    }
    if (leftLoops_ != 0 && --leftLoops_ == 0) leaving_ = 0;
    for (Status end : station_.ends) judgeEnd(end, findings);
    plan_.update();
    const bool wasBusy = station_.client.isBusy();
    keyboard_.paper.asked = keyboard_.paper.askedInOrder = 0;
    const bool wasOverrun = console_.isOverrun_;
    console_.update();
    // Behind a silence it takes what comes for a new line.
    if (wasOverrun && !console_.isOverrun_) keyboard_.closeGap();
    judgeBegun(wasBusy);
    for (uint8_t byte : keyboard_.takeWritten()) {
      if (byte >= ' ') said_ += static_cast<char>(byte);
      if (byte == '\n' && !said_.empty()) judgeSaid(said_);
      // A line may be read before the end of this one is printed.
      if (said_ == kStored || said_ == kErased) judgeSaid(said_);
      if (byte == '\n' || said_ == kStored || said_ == kErased) said_.clear();
    }
    if (station_.client.isBusy() && station_.nowMs() - begunMs_ > kMostMs) breaks("an operation has no end");
    if (findings != nullptr && station_.client.isBusy())
      findings->longestMs = std::max(findings->longestMs, station_.nowMs() - begunMs_);
  }

  Random random_;
  std::string* const log_;
  const Firmwares firmware_;
  const char* broken_ = nullptr;

  Keyboard keyboard_;
  ClientOnLine station_;
  EepromPlan plan_{Eeprom{[](uint16_t address) { return memory[address]; },
                          [](uint16_t address, uint8_t value) { memory[address] = value; }, nullptr, 400}};
  MissionItem room_[4];
  PlanConsole console_{keyboard_, station_.client, plan_, room_};

  Autopilot autopilot_, beside_;
  Aircraft aircraft_;
  mavlink_command_long_t command_;
  Way toAutopilot_, toClient_;
  bool isDown_[2] = {};
  uint32_t stepMs_, lossOf100_, copiesOf100_, secondLinkMs_, latencyMs_, beatMs_ = 0, typesMs_ = 65000;
  uint8_t sequence_ = 0;
  std::string end_ = "\n", said_;

  unsigned running_ = 0;  // what was asked for, of which one runs
  unsigned leaving_ = 0, leftLoops_ = 0;
  uint32_t begunMs_ = 0;
  Plan meant_, kept_, ours_, downloaded_;
};

}  // namespace

Findings type(Firmwares firmware, uint32_t seed, unsigned sessions) {
  return findBySeeds(seed, sessions, [firmware](uint32_t one, Findings* findings, std::string* told) {
    return Terminal(firmware, one, told).run(findings);
  });
}
