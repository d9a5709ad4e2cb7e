// An ArduPilot on a line in memory that gives and takes its plans as files, and what it is asked for word by word.
#pragma once

#include <string.h>

#include <initializer_list>
#include <map>
#include <string>

#include "AnsweringPeer.h"
#include "PlanFrames.h"
#include "mavmission/base/MavlinkHeaders.h"
#include "mavmission/files/FileFrame.h"

class FilePilot : public AnsweringPeer {
 public:
  enum : uint8_t { kTerminate = 1, kOpen = 4, kRead = 5, kCreate = 6, kWrite = 7, kBurst = 15 };  // MAV_FTP_OPCODE
  enum : int { kFail = 1, kInvalidSession = 4, kFileNotFound = 10 };                              // MAV_FTP_ERR

  typedef std::vector<mavmission::MissionItem> Plan;

  mavmission::PlanFiles files;
  std::vector<Bytes> plans[3];  // by MAV_MISSION_TYPE: the items, of a mission with home, as MISSION_ITEM_INT
  uint8_t type = 0;             // of the file that was opened last
  uint8_t baseMode = 0;
  uint8_t version = 2;         // of MAVLink
  uint16_t lostItem = 0xFFFF;  // of a burst, this one is lost
  uint32_t delayMs = 5;
  uint32_t stored = 0;  // how often a plan has been stored
  Bytes header;         // of the file that was stored last

  // The last request.
  uint16_t sequence = 0;
  uint8_t session = 0;

  // The mission protocol.
  bool servesItems = false;  // it gives and takes items by it
  uint16_t damaged = 0;      // until a plan is uploaded by it, this item is given 1 m higher
  int tooMany = 0;           // and so many items more are said to be there
  int takenAs = 0;           // MAV_MISSION_RESULT of such an upload; kSilent: no item of it is asked for
  uint32_t nameOfPlan = 0;

  // What a download has given.
  struct Taken {
    uint16_t index;
    mavmission::MissionItem item;
  };
  std::vector<Taken> taken;
  size_t takes = 1000;  // so many are taken

  explicit FilePilot(uint8_t autopilot = kArduPilot);

  // What happens, one after the other. It is found, and no file is open any more...
  FilePilot& settle();
  FilePilot& has(const Plan& plan);  // an earlier upload has left it aboard
  FilePilot& answering(uint8_t opcode, int result) {
    gives[opcode] = result;
    return *this;
  }
  FilePilot& answering() {  // as it should
    gives.clear();
    return *this;
  }
  FilePilot& serving() {
    servesItems = true;
    return *this;
  }
  FilePilot& armed(bool isAllowed = true);
  FilePilot& losing();  // three of four frames
  FilePilot& upload(const Plan& plan, mavmission::PlanType ofType = mavmission::PlanType::Mission) {
    return having(files.upload(sourceOf(plan), ofType));
  }
  FilePilot& verify(const Plan& plan) { return having(files.verify(sourceOf(plan))); }
  FilePilot& ensure(const Plan& plan, mavmission::PlanType ofType = mavmission::PlanType::Mission) {
    return having(files.ensure(sourceOf(plan), ofType));
  }
  FilePilot& download(uint16_t limit = 0xFFFE, mavmission::PlanType ofType = mavmission::PlanType::Mission);
  FilePilot& until(const std::string& words);  // have been said
  FilePilot& wait(uint32_t ms) {
    pass(ms);
    return *this;
  }
  FilePilot& cancel() {
    client.cancel();
    return *this;
  }

  // How the operation ends: its status, the item and the field that it names, whether it went by file, what is aboard,
  // and all that was said. Where it goes over to the mission protocol, which is not served, what was said until then.
  std::string how();
  // What is said in this time.
  std::string says(uint32_t ms);

  // An item of a file; what is not set is 0 in it.
  Bytes bytesOf(mavmission::MissionItem item, uint16_t seq) const;
  mavlink_mission_item_int_t itemAboard(size_t number) const;
  void beat();
  // A reply of its own making.
  void reply(uint16_t number, uint8_t inSession, uint8_t opcode, uint8_t requested, uint32_t offset, const Bytes& data,
             bool isComplete = false);
  void refuse(uint16_t number, uint8_t requested, uint8_t error) { reply(number, session, 129, requested, 0, {error}); }

  static mavmission::ItemSource sourceOf(const Plan& plan);
  static bool take(void* pilot, uint16_t index, const mavmission::MissionItem& item);

 private:
  // The same autopilot, with an operation begun.
  FilePilot& having(mavmission::Status) { return *this; }
  void one() override;
  void replyIn(uint32_t ms, uint16_t number, uint8_t opcode, uint8_t requested, uint32_t offset, const Bytes& data);
  static std::string fileOf(const Bytes& path);

  void react(const Bytes& request);
  void giveCount();
  void giveItem(uint8_t number);
  void takeItem(uint16_t number, uint16_t items);

  Bytes home() const;
  Bytes file() const;
  Bytes part(uint32_t offset, uint8_t size) const;
  void burst(uint16_t number, uint32_t offset);
  void store();

  bool isPx4_;
  bool isFirst_ = false;
  uint16_t itemsToTake_ = 0;
  Bytes written_;
};

// That is found already, and has no file open.
struct FoundPilot : FilePilot {
  explicit FoundPilot(uint8_t autopilot = kArduPilot) : FilePilot(autopilot) { settle(); }
};

// A plan, another one which differs in the height of its item 2, and one that is shorter.
extern const FilePilot::Plan kFourItems, kOneHigher, kTwoItems;
// Three corners of a fence.
extern const FilePilot::Plan kThreeCorners;
// So many waypoints.
FilePilot::Plan manyWaypoints(int number);

// What is said where all goes well.
const std::string kFileWritten = "create mission, write 10+190, write 0+10, close";
const std::string kFileRead = "open mission, read 0+10, burst 10+38, close";
const std::string kFileWrittenAndRead = kFileWritten + ", " + kFileRead;
