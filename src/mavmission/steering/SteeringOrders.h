// A row for each order of Steering: everything in which one differs from another. Steering's code asks for these
// traits, never for an order by its name.
#pragma once

#include <stdint.h>

namespace mavmission {
namespace detail {

// The mode in which an order is carried out. Steering::wantedMode() has this autopilot's number.
enum class TargetMode : uint8_t {
  None,        // no order: it is refused with Status::NoSuchMode
  AsShown,     // whatever mode the heartbeat shows: nothing sets another
  TakingOff,   // GUIDED, or PX4's mode of a takeoff
  FlyingTo,    // GUIDED, or PX4's HOLD
  Mission,     // AUTO, or PX4's MISSION
  Returning,   // RTL
  LandingHere  // LAND
};

// The command that an order sends. Steering::fillCommand() has a branch for each, which the compiler demands.
enum class OrderCommand : uint8_t {
  None,         // the mode is all of the order
  TakeOff,      // MAV_CMD_NAV_TAKEOFF
  Reposition,   // MAV_CMD_DO_REPOSITION
  ChangeSpeed,  // MAV_CMD_DO_CHANGE_SPEED: its number is a speed
  Other         // whoever begins the order fills it (CommandPort::takeOver())
};

// In one byte beside an OrderCommand, of which there may be eight. The last two follow from the mode: they make room
// for further traits, at the cost of some bytes of flash.
enum OrderTrait : uint8_t {
  kTakesHeight = 1 << 3,  // its number is a height, which becomes the target of hasArrived()
  kTakesPlace = 1 << 4,   // the sketch names a place
  kStopsHere = 1 << 5,    // its place is where the aircraft is, if it does not stop by a mode
  kFromGround = 1 << 6,   // it sets the mode and arms before its command; every other order is for the air
  kAdjusts = 1 << 7,      // it changes how the aircraft flies, not where: mode and target stay, COMMAND_ACK is the end
};

struct OrderRow {
  TargetMode mode;
  uint8_t bits;

  constexpr OrderRow(TargetMode mode = TargetMode::None, OrderCommand command = OrderCommand::None, uint8_t traits = 0)
      : mode(mode), bits(static_cast<uint8_t>(static_cast<uint8_t>(command) | traits)) {}

  constexpr OrderCommand command() const { return static_cast<OrderCommand>(bits & 7); }
};

enum class Order : uint8_t { TakeOff, GoTo, Pause, Resume, ReturnHome, Land, Speed, Stream, Adjust };

// In the order of Order.
constexpr OrderRow kOrders[] = {
    {TargetMode::TakingOff, OrderCommand::TakeOff, kTakesHeight | kFromGround},
    {TargetMode::FlyingTo, OrderCommand::Reposition, kTakesHeight | kTakesPlace},
    {TargetMode::FlyingTo, OrderCommand::Reposition, kStopsHere},
    {TargetMode::Mission, OrderCommand::None},
    {TargetMode::Returning, OrderCommand::None},
    {TargetMode::LandingHere, OrderCommand::None},
    {TargetMode::AsShown, OrderCommand::ChangeSpeed, kAdjusts},
    {TargetMode::FlyingTo, OrderCommand::Reposition},  // a MovingTarget: in its place a mode is set, or targets leave
    {TargetMode::AsShown, OrderCommand::Other, kAdjusts},
};
static_assert(sizeof(kOrders) / sizeof(kOrders[0]) == static_cast<uint8_t>(Order::Adjust) + 1,
              "each order has a row; Order's last name stands here");

// A row that sets no mode and sends no command would be an order that does nothing.
constexpr bool isWhole(OrderRow row) {
  return row.mode != TargetMode::None && (row.mode != TargetMode::AsShown || row.command() != OrderCommand::None);
}
constexpr bool areWhole(uint8_t count) {
  return count == 0 || (isWhole(kOrders[count - 1]) && areWhole(static_cast<uint8_t>(count - 1)));
}
static_assert(areWhole(sizeof(kOrders) / sizeof(kOrders[0])),
              "each row names a mode, or the command that it sends in any");

constexpr OrderRow rowOf(Order order) { return kOrders[static_cast<uint8_t>(order)]; }

}  // namespace detail
}  // namespace mavmission
