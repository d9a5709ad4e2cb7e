// The operations that consist of commands. Each has fill(), which makes its command, and on(), which takes its events.
#pragma once

#include "Client.h"

namespace mavmission {
namespace detail {

// What they have in common.
struct Client::Command {
  static void step(Client& client, const FrameParser* frame, uint16_t nowMs);
  static void takeFrame(Client& client, const FrameParser& frame, uint16_t nowMs);
  static void send(Client& client, bool isBegun, uint16_t nowMs);
  MAVMISSION_APART static uint16_t askAgainMs(Client& client);  // from a request for a heartbeat to the next
  static void takeEvent(Client& client, CommandEvent event, Status status, const FrameParser* frame, uint16_t nowMs);
  static Status whenSilent(const Client& client, Status silence);
};

// send().
struct Client::OwnCommand {
  static void fill(Client& client, FlightCommand& command);
  static void fillAsInt(Client& client, FlightCommand& command);
  static void fillAsLong(Client& client, FlightCommand& command);
  static Status on(Client&, CommandEvent, Status, const FrameParser*, uint16_t);
  static Status sendInOtherForm(Client& client, Status refusal);
};

// arm() and disarm().
struct Client::Arming {
  static void fill(Client& client, FlightCommand& command);
  static void fillDisarming(Client& client, FlightCommand& command);
  static Status on(Client&, CommandEvent, Status, const FrameParser*, uint16_t);
};

// setMode(), setCustomMode(), and whatever else orders a mode.
struct Client::SettingMode {
  static void fill(Client& client, FlightCommand& command);
  static Status on(Client&, CommandEvent, Status, const FrameParser*, uint16_t);
  static Status onCustom(Client&, CommandEvent, Status, const FrameParser*, uint16_t);
  static Status onNamed(Client&, CommandEvent, Status, const FrameParser*, uint16_t);
  static uint16_t seen(const Client& client, uint16_t mode);
};

// setCurrentItem().
struct Client::SettingCurrent {
  static void fill(Client& client, FlightCommand& command);
  static void fillMessage(Client& client, FlightCommand& command);
  static Status on(Client&, CommandEvent, Status, const FrameParser*, uint16_t);
};

// setMessageInterval().
struct Client::SettingInterval {
  static void fill(Client& client, FlightCommand& command);
};

// The question which vehicle an ArduPilot is.
struct Client::AskingVehicle {
  static void fill(Client&, FlightCommand& command);
};

// startMission().
struct Client::BeginningMission {
  static void fill(Client& client, FlightCommand& command);
  static Status on(Client&, CommandEvent, Status, const FrameParser*, uint16_t);
};

// start().
struct Client::Starting {
  static void fill(Client& client, FlightCommand& command);
  static Status on(Client&, CommandEvent, Status, const FrameParser*, uint16_t);
  static Status mayBegin(Client& client);
  MAVMISSION_APART static void begin(Client& client);
  MAVMISSION_APART static void note(Client& client);
  // Remembers who has taken the aircraft, if that is why it has ended; returns the same.
  MAVMISSION_APART static Status noted(Client& client, Status ended);
  static Status lookAtItem(Client& client, const Aircraft& aircraft);
  MAVMISSION_APART static Aircraft aircraftOf(const Client& client, uint16_t nowMs);
};

}  // namespace detail
}  // namespace mavmission
