// Plans as files: ArduPilot sends and receives a whole plan as a file, by MAVLink FTP.
#pragma once

#include "../base/Status.h"
#include "../item/PlanType.h"
#include "../plan/ItemSink.h"
#include "../plan/ItemSource.h"
#include "../service/Listener.h"
#include "../transfer/FileReadTransfer.h"
#include "../transfer/FileWriteTransfer.h"

namespace mavmission {

namespace detail {
class Client;
class PlanPort;
}  // namespace detail

// Transfers plans as files where that is quicker, and by the mission protocol everywhere else. Declare one next to the
// client; it contains the RAM that these transfers need:
//
//   MissionClient autopilot(Serial1);
//   PlanFiles files(autopilot);
//
// A plan that is uploaded by file replaces the old plan in one step, when all of it has arrived: an upload that breaks
// off leaves the old plan aboard, not a mixture.
//
// Its operations are operations of the client: only one runs at a time, update() returns its status, and status(),
// aboard(), failedItem() and the callbacks work as for the client's own operations. The object changes to the mission
// protocol by itself where files cannot be used (PX4, a MAVLink 1 link, FTP switched off, a file that another ground
// station has open), and for reading on a lossy link.
class PlanFiles : public detail::Listener {
 public:
  // This object must live as long as the client: declare it next to the client, not in a function.
  explicit PlanFiles(MissionClient& client);

  // As MissionClient::upload(), but the plan is always read back, since the autopilot does not acknowledge the content
  // of a file. Status::Accepted means that the plan is aboard, Status::Differs that another plan was read back,
  // Status::Unconfirmed that none could be read. aboard() says afterwards what is aboard: the old plan if the upload
  // has broken off, not known after Differs and Unconfirmed. The mission protocol is used also for a plan with a
  // command that this library does not know, for a plan of more than 650 items, for a fence of up to three items, for a
  // plan that is shorter than the plan aboard an armed aircraft, and on a signed link; and when the open file is lost,
  // because the autopilot has restarted or another station has opened it, or when another plan is read back on a lossy
  // link. Then isByFile() is false, and aboard() may be a mixture.
  Status upload(const ItemSource& plan, PlanType type = PlanType::Mission);
  // A bare array is refused: it does not say whether it is in flash or in RAM.
  template <size_t N, typename... More>
  Status upload(const MissionItem (&)[N], More...) {
    static_assert(N == 0, "write upload(inFlash(plan)) for a plan with PROGMEM, upload(inRam(plan)) for one without");
    return Status::Idle;
  }

  // As MissionClient::ensure(): finds out which plan is aboard, and uploads only if it is another one. ArduPilot's plan
  // is read as a file, and replaced as by upload(). MissionClient::ensure() is used instead on PX4, where files cannot
  // be used, on a lossy link, and while the autopilot is armed, since opening a file would store a plan that another
  // client has left open. An armed autopilot keeps its plan: Status::Armed.
  Status ensure(const ItemSource& plan, PlanType type = PlanType::Mission);
  template <size_t N, typename... More>
  Status ensure(const MissionItem (&)[N], More...) {
    static_assert(N == 0, "write ensure(inFlash(plan)) for a plan with PROGMEM, ensure(inRam(plan)) for one without");
    return Status::Idle;
  }

  // As MissionClient::verify() and download(). For a sink with an isReady function the mission protocol is used.
  Status verify(const ItemSource& plan, PlanType type = PlanType::Mission);
  Status download(const ItemSink& sink, PlanType type = PlanType::Mission);

  // True if the running or last operation of this object transfers by file; false once it has changed to the mission
  // protocol.
  bool isByFile() const { return isByFile_; }

 private:
  typedef void (*Step)(detail::Client& client, const detail::FrameParser* frame, uint16_t nowMs);
  typedef detail::FileWriteTransfer::Request Request;

  // The most items, home included, that a file may have: of more ArduPilot stores the first ones, and says nothing.
  static constexpr uint16_t kMostItems = 650;
  static constexpr uint8_t kUntilClosed = 255;

  // The operations.
  struct ReadingFile;
  struct EnsuringFile;
  struct WritingFile;

  struct Writing {
    detail::FileWriteTransfer transfer;
    Request going;   // the write that is on its way out
    uint8_t pieces;  // of that write which have been made
    bool isBroken;   // the source has given no item
  };

  // In PlanFiles.cpp
  static void take(detail::Listener& listener, const detail::FrameParser& frame);
  void beginOperation(Step operation);
  bool isRunning() const;
  bool isUsable() const;
  void takeNumbers();
  void beginFile();
  bool isReply(const detail::FrameParser& frame) const;
  void send(uint16_t sequence, uint8_t opcode, uint8_t size = 0, uint32_t offset = 0);
  void sendOpening(uint16_t sequence, uint8_t opcode);
  void closeLeftOpen();

  // In PlanFilesReading.cpp
  static void readStep(detail::Client& client, const detail::FrameParser* frame, uint16_t nowMs);
  void beginReading();
  void readOn(uint16_t nowMs);
  void takeReadReply(const detail::FrameParser& frame, uint16_t nowMs);
  void takeCount(const detail::FrameParser& frame, uint16_t nowMs);
  void takeItem(const detail::FrameParser& frame, uint16_t item, uint16_t nowMs);
  void readByItems(uint16_t first, uint16_t nowMs);
  void endReading(Status status, uint16_t nowMs);

  // In PlanFilesEnsuring.cpp
  static void ensureStep(detail::Client& client, const detail::FrameParser* frame, uint16_t nowMs);
  static void takeEnsured(PlanFiles& self, Status status, uint16_t nowMs);

  // In PlanFilesWriting.cpp
  static void writeStep(detail::Client& client, const detail::FrameParser* frame, uint16_t nowMs);
  static void takeLook(PlanFiles& self, Status status, uint16_t nowMs);
  static void takeProof(PlanFiles& self, Status status, uint16_t nowMs);
  static void proveByItemsStep(detail::Client& client, const detail::FrameParser* frame, uint16_t nowMs);
  static Status proveItem(detail::Client& client, uint16_t wireItem, MissionItem& item);
  static uint8_t nextPiece(void* context, uint8_t* piece);
  void check(uint16_t nowMs);
  bool isChecked();
  detail::PlanPort& plans() const;
  bool isForFile() const;
  bool isForeseen(const MissionItem& item) const;
  void beginWriting();
  void beginComparing(void (*onRead)(PlanFiles& self, Status status, uint16_t nowMs));
  void writeOn(uint16_t nowMs);
  void sendItems(uint16_t nowMs);
  uint8_t makeHead(uint8_t* piece) const;
  Status makeItem(uint16_t wireItem, void* piece) const;
  void takeWriteReply(const detail::FrameParser& frame, uint16_t nowMs);
  void uploadByItems(uint16_t nowMs);
  void proveByItems(uint16_t nowMs);
  void uploadDamaged(uint16_t nowMs);

  Step operation_;  // the client's while one of this object runs
  // What follows a reading; null: the operation ends.
  void (*onRead_)(PlanFiles& self, Status status, uint16_t nowMs);
  union {
    detail::FileReadTransfer reading_;
    Writing writing_;
  };
  uint16_t sequence_;       // of the last request
  uint16_t firstSequence_;  // answers to the running operation have later ones
  uint8_t session_;
  uint8_t closings_;  // how often the file is still to be closed; kUntilClosed: until that is answered
  bool isByFile_ : 1;
  bool isForeseen_ : 1;
  bool isLook_ : 1;         // only the number of items aboard is read
  bool isEnsuring_ : 1;     // ensure(): an armed autopilot gets no plan
  bool isWholeLook_ : 1;    // ensure() reads the plan aboard
  bool isLengthKnown_ : 1;  // the plan aboard is not longer than ours
  bool isStorable_ : 1;     // the file that may be open has its header: closing it stores it
  bool isDamaged_ : 1;      // what was read back is another plan: it is uploaded item by item
  bool isWithdrawing_ : 1;  // the last request is to take that header away
};

}  // namespace mavmission
