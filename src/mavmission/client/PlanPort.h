// What a service sees of the client that transfers a plan in its own way, as PlanFiles does by file. (Item by item the
// client does it itself.)
#pragma once

#include <stdint.h>

#include "../item/PlanType.h"
#include "../plan/ItemSink.h"
#include "../plan/ItemSource.h"
#include "../plan/WirePlan.h"
#include "Port.h"

namespace mavmission {

class PlanFiles;

namespace detail {

class PlanPort {
 public:
  // Takes an item that was read. Returns Transferring, Checking (not ready: request it again), or why the operation
  // ends.
  typedef Status (*TakeItem)(Client& client, uint16_t wireItem, MissionItem& item);

  // The object whose operation transfers by file; and the one whose upload is read back item by item.
  static PlanFiles& filesOf(const Client& client);
  static PlanFiles& proverOf(const Client& client);

  // --- Beginning: each returns the first status of the operation

  // When a fence of fewer than three corners or circles replaces a longer fence, ArduPilot accepts the short fence,
  // still has it in a read-back at once, and wipes it at its next check of the fence, 3 to 25 times a second depending
  // on the vehicle. A return point is neither a corner nor a circle, so such a short fence has at most three items.
  static bool isShortFence(const ItemSource& plan, PlanType type);
  // Begins an upload item by item, which is read back.
  Status startUploading(const ItemSource& plan, PlanType type, Readback proof = Readback::InDoubt);
  // From an operation that uploads, which was just begun with this status: its plan is checked as checkNextOfAny()
  // does.
  Status checkAreas(Status status);
  // Begin a reading of this object's own. To be called only while no operation runs.
  Status startVerifying(const ItemSource& plan, PlanType type, Port::Step operation, PlanFiles& files);
  Status startDownloading(const ItemSink& sink, PlanType type, Port::Step operation, PlanFiles& files);
  // The operation that runs goes on as this one.
  void goOnBy(Port::Step operation, PlanFiles& files);

  // --- The plan, and what is aboard of its type

  PlanType planType() const;
  // The sketch's plan as this autopilot wants it.
  WirePlan& plan();
  void nowAboard(Aboard what);
  // True if the link's version of MAVLink carries plans of this type.
  MAVMISSION_APART bool isTypeCarried() const;

  // --- Checking it

  // The autopilot is found: its plan is checked from the first item on.
  void beginChecking();
  // Checks the next item. Accepted: it is good, and lies in the link's draft(). Transferring: all are. Checking: not in
  // this update(), or no more, as running() says.
  Status checkNext();
  // The same for a plan of any type: the items of a fence, and rally points, are looked at together, too.
  Status checkNextOfAny();

  // --- Reading what is aboard

  // The autopilot is found. True if it can be read: the operation is then Transferring.
  bool beginsReading(uint16_t nowMs);
  // True if the plan aboard is compared with the sketch's; false: it is downloaded.
  bool isCompared() const;
  // True if it goes to a sink that may have to be waited for.
  bool mayWaitForSink() const;
  // From now on an update() leaves the time for the comparison of an item, or need not.
  void keepTimeFree(bool isKept);
  // Takes the number of items aboard. Transferring, or why the operation ends: SinkFull, Differs.
  Status takeCount(uint16_t count);
  // True for a MISSION_COUNT of another number of items than the plan has that was uploaded.
  bool isOtherCount(const FrameParser& frame) const;
  // Stores an item, or compares it.
  Status takeItem(uint16_t wireItem, MissionItem& item);
  Status compare(uint16_t wireItem, MissionItem& item);
  // So many items on the wire are done.
  void progress(uint16_t wireItems);
  MAVMISSION_APART void noteFailed(uint16_t wireItem);
  // No item has failed, after all.
  void forgetFailed();
  // Ends it: what is aboard is our plan.
  void endAsOurs(Status status);

  // --- Within an upload

  // The plan aboard is compared, without any progress; and that is over.
  void beginComparing(Port::Step operation, PlanFiles& files);
  void endComparing();
  // All of the plan has been given to the autopilot, and it has not refused it.
  void noteWhole();

  // --- Going over to the mission protocol

  void uploadByItems(uint16_t nowMs);
  // Before that, where a comparison has found another plan aboard: the upload is then read back in any case.
  void proveInAnyCase();
  void ensureByItems();
  // From this item on.
  void readByItems(uint16_t first, uint16_t nowMs);
  // Reads an upload back, which this object watches.
  void proveByItems(Port::Step operation, TakeItem take, PlanFiles& prover, uint16_t nowMs);
  void readOnByItems(const FrameParser* frame, uint16_t nowMs);
};

}  // namespace detail
}  // namespace mavmission
