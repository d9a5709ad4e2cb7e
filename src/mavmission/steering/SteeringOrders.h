// A row for each order of Steering: everything in which one differs from another. Steering's code asks for these
// traits, never for an order by its name.
#pragma once

#include <stdint.h>

namespace mavmission {
namespace detail {

// The mode in which an order is carried out. Steering::wantedMode() has this autopilot's number.
enum class OrderMode : uint8_t {
  None,        // no order: it is refused with Status::NoSuchMode
  AsShown,     // whatever mode the heartbeat shows: nothing sets another
  TakingOff,   // GUIDED, or PX4's mode of a takeoff
  FlyingTo,    // GUIDED, or PX4's HOLD
  Mission,     // AUTO, or PX4's MISSION
  Returning,   // RTL
  LandingHere  // LAND
};

enum OrderTrait : uint8_t {
  kTakesHeight = 1 << 0,  // its number is a height, which becomes the target of hasArrived()
  kTakesPlace = 1 << 1,   // the sketch names a place
  kTakesSpeed = 1 << 2,   // its number is a speed
  kFromGround = 1 << 3,   // it sets the mode, arms, and sends MAV_CMD_NAV_TAKEOFF; every other order is for the air
  kRepositions = 1 << 4,  // it sends MAV_CMD_DO_REPOSITION
  kStopsHere = 1 << 5,    // its place is where the aircraft is
  kHasCommand = 1 << 6,   // it always sends a command; without this trait, the mode may be all of the order
  kAdjusts = 1 << 7,      // it changes how the aircraft flies, not where: mode and target stay, COMMAND_ACK is the end
};

struct OrderRow {
  OrderMode mode;
  uint8_t traits;  // an or of OrderTrait
};

enum class Order : uint8_t { TakeOff, GoTo, Pause, Resume, ReturnHome, Land, Speed };

// In the order of Order.
constexpr OrderRow kOrders[] = {
    {OrderMode::TakingOff, kTakesHeight | kFromGround | kHasCommand},
    {OrderMode::FlyingTo, kTakesHeight | kTakesPlace | kRepositions | kHasCommand},
    {OrderMode::FlyingTo, kRepositions | kStopsHere},
    {OrderMode::Mission, 0},
    {OrderMode::Returning, 0},
    {OrderMode::LandingHere, 0},
    {OrderMode::AsShown, kTakesSpeed | kHasCommand | kAdjusts},
};
static_assert(sizeof(kOrders) / sizeof(kOrders[0]) == static_cast<uint8_t>(Order::Speed) + 1,
              "each order has a row; Order's last name stands here");

// A row that has no mode, or whose command is none of those that Steering knows, would be an order that does nothing.
constexpr bool isWhole(OrderRow row) {
  return row.mode != OrderMode::None &&
         ((row.traits & kHasCommand) == 0 || (row.traits & (kTakesSpeed | kFromGround | kRepositions)) != 0);
}
constexpr bool areWhole(uint8_t count) {
  return count == 0 || (isWhole(kOrders[count - 1]) && areWhole(static_cast<uint8_t>(count - 1)));
}
static_assert(areWhole(sizeof(kOrders) / sizeof(kOrders[0])), "each row names a mode, and the command that it sends");

constexpr OrderRow rowOf(Order order) { return kOrders[static_cast<uint8_t>(order)]; }

}  // namespace detail
}  // namespace mavmission
