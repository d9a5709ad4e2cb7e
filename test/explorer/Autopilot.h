// Mission servers as small models: plain data, a message or time in, messages out. What the two autopilots do was
// observed on ArduPilot 4.6.3 and PX4 1.17.0 (simulation/recordings); fences and rally points by their sources.
#pragma once

#include <type_traits>

#include "Message.h"

constexpr uint16_t kNever = 0xFFFF;

// What a model sends in answer to one message or at one moment.
struct Answers {
  Message messages[kMostHeld + 1];
  int count = 0;
  void add(const Message& message) { messages[count++] = message; }
  void acknowledge(Result result, uint32_t opaqueId = 0) { add(message(Kind::Ack, result, 0, opaqueId)); }
};

// One kind of plan (MAV_MISSION_TYPE), and the transfer of it. ArduPilot has one transfer for each kind, side by side;
// PX4 has one in all, which goes from the one kind to the other (hearOfKinds()). Times are what is left of a wait [ms],
// or kNever.
struct Autopilot {
  static constexpr uint16_t kBootMs = 3000;  // how long it is deaf and silent after a reboot

  enum class State : uint8_t { Idle, Receiving, Sending };

  Firmwares firmware;
  State state;
  uint16_t expected;  // the item that it waits for, or will be asked for
  uint16_t count;     // items of the transfer
  uint16_t heldCount;
  uint8_t held[kMostHeld];    // the plan aboard
  uint8_t staged[kMostHeld];  // PX4: the plan that is being received
  uint8_t hasPartner;         // PX4: knows with whom it transfers or has transferred
  uint8_t isUploadOpen;       // PX4: outlives the state in some corners, and then bars COUNT
  uint8_t requests;           // generic: that have drawn no item
  uint8_t type;
  uint8_t hasTransfer;  // PX4: its one transfer is of this kind
  uint8_t unused[1];
  uint16_t refused;  // ArduPilot: the item that it does not take; 0: none
  uint16_t asksInMs;
  uint16_t givesUpInMs;
  uint16_t acceptsInMs;  // LateArduPilot: the final ACK is under way in itself
  uint16_t bootsInMs;
  uint32_t heldSum;  // PX4: opaque_id
  uint32_t stagedSum;

  // With nothing aboard. `kind`: MAV_MISSION_TYPE.
  void begin(Firmwares firmware, uint8_t kind);
  // The next moment at which it does something of its own accord [ms from now].
  uint16_t nextMs() const;
  void pass(uint16_t ms);
  void hear(const Message& message, Answers& answers);
  // Does what is due now.
  void act(Answers& answers);
  // Forgets every transfer, keeps the plan.
  void reboot();
  void hold(uint8_t plan, uint16_t items);
  // True if this plan is aboard, or the one that is aboard there.
  bool holds(uint8_t plan, uint16_t items) const;
  bool holdsAs(const Autopilot& other) const;

  // What the models have in common. For the item that it waits for it asks, and again later.
  void ask(Answers& answers);
  uint16_t asksAgainMs() const;
  void goIdle();
  // Of its transfer it then knows nothing any more.
  void forget();
  // So many of the items that were staged are aboard.
  void keep(uint16_t items, uint32_t sum = 0);
};
static_assert(std::has_unique_object_representations<Autopilot>::value, "folded by its bytes");

// What an autopilot with a plan of another kind beside the first one does.
void hearOfKinds(Autopilot& one, Autopilot& other, const Message& message, Answers& answers);
void hearAsPx4OfKinds(Autopilot& has, Autopilot& other, const Message& message, Answers& answers);

void hearAsArduPilot(Autopilot& autopilot, const Message& message, Answers& answers);
void actAsArduPilot(Autopilot& autopilot, Answers& answers);
void hearAsPx4(Autopilot& autopilot, const Message& message, Answers& answers);
void actAsPx4(Autopilot& autopilot, Answers& answers);
void hearAsGeneric(Autopilot& autopilot, const Message& message, Answers& answers);
void actAsGeneric(Autopilot& autopilot, Answers& answers);
