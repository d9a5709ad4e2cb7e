// A flight from its plan to its end: upload, wait until the autopilot is ready, arm, fly, stop for work, land, disarm.
#pragma once

#include "../client/CommandPort.h"
#include "../client/MissionClient.h"
#include "../service/Listener.h"
#include "../telemetry/PositionListener.h"
#include "FlightStages.h"
#include "FlightState.h"

namespace mavmission {

// Flies plans, one after the other. Declare one beside the client, and call its update() in the place of the client's:
//
//   MissionClient autopilot(TELEM);
//   Flight flight(autopilot);
//
//   void setup() { flight.fly(inFlash(plan)); }
//   void loop() {
//     if (flight.update()) flight.printTo(Serial);
//   }
//
// fly() uploads the plan, again if its acknowledgement was lost, and then tries to arm every 5 s until the autopilot is
// ready: for at most five minutes (setReadyTimeout()), and only while the autopilot is heard all the time. reason() has
// its own words for why it is not ready. Then it flies the plan, and follows it to the landing. A rover, which stays
// armed at the end of its plan, is disarmed. It is for ArduPilot's copters, rovers and planes (also those that hover),
// and for PX4's copters. A plan for an aircraft must end on the ground: land() or returnToLaunch().
//
// **A person, a failsafe, another station or silence ends the flight.** Somebody who arms or disarms the aircraft, sets
// another mode, also on the ground, or cuts the line there, or replaces the plan: then the state is Ended, and this
// object arms and moves nothing any more, whatever that person does next, until the sketch calls begin(). So does a
// reset: an aircraft that is armed when the sketch begins is left to fly its plan.
//
// What it cannot know: whether a person disarmed the aircraft, or the autopilot, while it was at its plan's last item.
class Flight : private detail::Listener, private detail::FollowRules {
 public:
  // These objects must live as long as the client: declare them next to the client, not in a function.
  explicit Flight(MissionClient& client);
  // The same, and it tells of the plan's stops: waypoints of a copter or a rover with a hold of at least a second, as
  // stopAt() makes them. The state is AtStop while the vehicle stands there: nearer than 3 m, slower than 1 m/s, until
  // the hold has passed, or goOn() is called. `position`: requested at least twice a second. The hold is in the plan:
  // if the Arduino fails at a stop, the autopilot flies on when the hold has passed, and lands.
  Flight(MissionClient& client, const PositionListener& position);

  // Begins a flight. The plan's source must live until the flight has ended. Returns Status::Transferring, or
  // Status::Busy while a flight is under way (a second press of a button changes nothing), or, after Ended, why().
  Status fly(const ItemSource& plan);
  // A bare array is refused: it does not say whether it is in flash or in RAM.
  template <size_t N>
  Status fly(const MissionItem (&)[N]) {
    static_assert(N == 0, "write fly(inFlash(plan)) for a plan with PROGMEM, fly(inRam(plan)) for one without");
    return Status::Idle;
  }
  // Asks for the aircraft again after Ended: the next fly() is allowed. To be called for a reason that a person gave,
  // such as a button that was pressed. It does nothing while a flight is under way.
  void begin();
  // Gives up a flight that has not armed yet; in the air the autopilot flies on.
  void giveUp();
  // At a stop: its work is done, and the vehicle need not wait for the rest of the hold (MISSION_SET_CURRENT). False if
  // it is at no stop, or another operation runs: call it again.
  bool goOn();

  // To be called from loop(), in the place of the client's update(). True once after each change of state(), why() or
  // reason().
  bool update();

  // What is being done, or how the last flight has ended; Idle until the first fly().
  FlightState state() const { return stages_.state(); }
  // Landed and Ended: who has ended the flight. Before: EndedBy::Nobody.
  EndedBy endedBy() const { return stages_.endedBy(); }
  // NotReady: with what it was refused. Ended: why. In the air: Status::Done, or why the last order was refused.
  Status why() const { return stages_.why(); }
  // NotReady: the autopilot's own words for it, at most 50 characters; empty if it gives none (PX4 gives them to a
  // ground station alone).
  const char* reason() const { return reason_; }
  // The item of the stop, in the sketch's numbers; MissionClient::kNoItem where there is none.
  uint16_t stop() const { return state() == FlightState::AtStop ? item_ : MissionClient::kNoItem; }
  // How long the state has lasted [ms].
  uint32_t inStateMs() const;
  // Prints the state with its reason as one line.
  void printTo(Print& out) const;

  // The longest time from fly() to the arming [s]; 300 by default.
  void setReadyTimeout(uint16_t seconds) { stages_.setLimit(seconds); }

 protected:
  // What a flight has that is steered; null: a plan alone is flown.
  struct Ways {
    Status (*begin)(Flight& flight, detail::FlightOrder order);  // begins the operation of an order
    detail::FlightHands (*hands)(const Flight& flight);          // Own: the aircraft is still this sketch's
    bool (*hasArmed)(const Flight& flight);                      // the last order has armed it, and disarmed it again
  };
  // Called at each update() in flight: looks whether the aircraft has come to a stop.
  typedef void (*LookForStop)(Flight& flight);

  // Begins a flight with this order, and forgets the flight before; returns as fly().
  Status beginWith(detail::FlightOrder first);

  MissionClient& autopilot_;     // by which the orders leave
  const Ways* ways_;             // null: there are no orders but those of a plan
  LookForStop lookForStop_;      // null: no stops are told of
  detail::FlightStages stages_;  // decides what is begun next, and when the flight has ended
  uint16_t item_;                // the item being flown
  bool isSteered_ : 1;           // an order has been given in this flight
  bool comesDown_ : 1;           // and it was to land, or to return
  bool isOnTheWay_ : 1;          // to where it was sent
  bool isAsked_ : 1;             // by begin(), until the next update(): a person asks for the aircraft

 private:
  static void take(detail::Listener& listener, const detail::FrameParser& frame);
  static void lookForStop(Flight& flight);
  static void fillDisarming(detail::Client& client, FlightCommand& command);
  static Status onDisarming(detail::Client& client, detail::CommandEvent event, Status status,
                            const detail::FrameParser* frame, uint16_t nowMs);
  void takeHeartbeat();
  void takeCurrent(const detail::FrameParser& frame);
  void takeText(const detail::FrameParser& frame);
  detail::FlightHands hands() const;
  void look(bool hasEnded);
  bool isRover() const;
  MAVMISSION_APART bool findEnd();
  static void beginPlan(Flight& flight, detail::FlightOrder order);

  // Begins the orders of a plan; null until fly() is called: only that refers to the code.
  void (*beginPlan_)(Flight& flight, detail::FlightOrder order);
  const PositionListener* position_;
  ItemSource plan_;
  LatLon place_;          // of the stop
  uint16_t stop_;         // the item that was looked at last: is it a stop?
  uint16_t last_;         // the item with which the plan ends on the ground; kNoItem: not known
  uint8_t beatsLeft_;     // heartbeats before MISSION_CURRENT is asked for
  bool isBeat_ : 1;       // a heartbeat has come
  bool wantsReason_ : 1;  // the next text says why it is not ready
  bool hasBegun_ : 1;     // the plan has been seen under way, before its last item
  bool isAtEnd_ : 1;      // then at its last item, or past it
  bool isComplete_ : 1;   // as the last MISSION_CURRENT says
  bool isDoubted_ : 1;    // that named another plan
  bool isOtherPlan_ : 1;  // so did the one before
  bool isStop_ : 1;       // item stop_ is one
  bool returns_ : 1;      // the plan ends with returnToLaunch()
  char reason_[51];
};

}  // namespace mavmission
