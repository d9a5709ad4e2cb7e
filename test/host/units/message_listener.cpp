// A MessageListener: what a sketch is given of a message, and that it takes nothing from the library's own listeners.
#include "mavmission/service/MessageListener.h"

#include <doctest/doctest.h>
#include <memory>
#include <string>
#include <vector>

#include "ToldClient.h"

using namespace mavmission;

namespace {

const MessageKey kOwn[] = {messageKey(4321, 77, 6), messageKey(24, 24, 30)};
const MessageKey kOfPayload[] = {messageKey(MAVLINK_MSG_ID_COMMAND_LONG, MAVLINK_MSG_ID_COMMAND_LONG_CRC, 33)};

// What is given, "4321 of 42/77 by MAVLink 2: 1 2 3".
void keep(void* copies, const ReceivedMessage& message) {
  std::string copy = std::to_string(message.id) + " of " + std::to_string(message.systemId) + "/" +
                     std::to_string(message.componentId) + " by MAVLink " + std::to_string(message.version) + ":";
  for (uint8_t i = 0; i < message.length; ++i) copy += " " + std::to_string(message.payload[i]);
  static_cast<std::vector<std::string>*>(copies)->push_back(copy);
}

struct Desk : ToldClient {
  std::vector<std::string> copies;

  void tell(uint32_t id, uint8_t crcExtra, const Bytes& payload, uint8_t version = 2) {
    FrameParts parts(id, payload, crcExtra);
    parts.systemId = 42;
    parts.componentId = 77;
    parts.version = version;
    ToldClient::tell(parts);
  }
};

PayloadAnswer carryOut(void* count, const PayloadCommand&) {
  ++*static_cast<int*>(count);
  return PayloadAnswer::Accepted;
}

}  // namespace

TEST_CASE("a message of the sketch's own is given as it lies on the wire, from any sender") {
  Desk desk;
  MessageListener listener(desk.client, kOwn, keep, &desk.copies);
  desk.run(10);
  desk.tell(4321, 77, {1, 2, 3, 4, 5, 6, 7});
  CHECK(desk.copies == std::vector<std::string>{"4321 of 42/77 by MAVLink 2: 1 2 3 4 5 6 7"});
  desk.tell(24, 24, Bytes(30, 9), 1);
  REQUIRE(desk.copies.size() == 2);
  CHECK(desk.copies[1].substr(0, 30) == "24 of 42/77 by MAVLink 1: 9 9 ");
  desk.tell(24, 24, Bytes(29, 9), 1);       // MAVLink 1 omits nothing
  desk.tell(4321, 78, {1, 2, 3, 4, 5, 6});  // of another dialect
  desk.tell(MAVLINK_MSG_ID_ATTITUDE, MAVLINK_MSG_ID_ATTITUDE_CRC, Bytes(28, 1));
  CHECK(desk.copies.size() == 2);
  MessageListener second(desk.client, kOwn, keep, &desk.copies);
  desk.tell(24, 24, Bytes(30, 9));
  CHECK(desk.copies.size() == 4);  // each hears it
}

TEST_CASE(
    "a message of the sketch's own leaves after an autopilot's heartbeat, and where MAVLink 1 has none it does not") {
  const uint8_t payload[] = {1, 2, 3};
  for (MavlinkVersion version : {MavlinkVersion::Version1, MavlinkVersion::Version2}) {
    Desk desk;
    desk.client.setMavlinkVersion(version);
    CHECK_FALSE(desk.client.sendMessage(OutgoingMessage{180, 77, 3, 3, payload}));
    desk.run(1500);
    const bool isV2 = version == MavlinkVersion::Version2;
    CHECK(desk.client.sendMessage(OutgoingMessage{256, 77, 3, 3, payload}) == isV2);
    desk.run(50);
    CHECK(desk.client.sendMessage(OutgoingMessage{180, 77, 3, 0, payload}) == isV2);
    desk.run(50);
    CHECK(desk.client.sendMessage(OutgoingMessage{180, 77, 3, 3, payload}));
    desk.run(50);
    CHECK(desk.timesOf(180, 0).size() == (isV2 ? 2u : 1u));
  }
}

TEST_CASE("without a function a message is received, and nothing is done") {
  Desk desk;
  MessageListener listener(desk.client, kOwn, nullptr);
  desk.run(10);
  const uint16_t before = desk.client.counters().frames;
  desk.tell(24, 24, Bytes(30, 9));
  CHECK(desk.client.counters().frames == before + 1);
}

TEST_CASE("copyTo() fills with zeros what MAVLink 2 has omitted, and leaves out what has no room") {
  const uint8_t payload[] = {1, 2, 3, 4};
  const ReceivedMessage message = {24, 1, 1, 2, 4, payload};
  const auto copied = [&message](uint8_t size) {
    Bytes room(8, 0xEE);
    message.copyTo(room.data(), size);
    return room;
  };
  CHECK(copied(6) == Bytes{1, 2, 3, 4, 0, 0, 0xEE, 0xEE});
  CHECK(copied(4) == Bytes{1, 2, 3, 4, 0xEE, 0xEE, 0xEE, 0xEE});
  CHECK(copied(3) == Bytes{1, 2, 3, 0xEE, 0xEE, 0xEE, 0xEE, 0xEE});
  CHECK(copied(0) == Bytes(8, 0xEE));
}

TEST_CASE("a sketch that hears a payload's commands does not make it take those for others") {
  for (bool isFirst : {true, false}) {
    CAPTURE(isFirst);
    Desk desk;
    int carriedOut = 0;
    std::unique_ptr<MessageListener> own;
    const auto listen = [&] { own.reset(new MessageListener(desk.client, kOfPayload, keep, &desk.copies)); };
    if (isFirst) listen();
    Payload payload(desk.client, carryOut, &carriedOut);
    if (!isFirst) listen();
    desk.run(3500);
    for (const std::string component : {"154", "191"}) {
      desk.ToldClient::tell("COMMAND_LONG command 42600 target_system 1 target_component " + component);
      payload.update();
      desk.run(5);
      const bool isOurs = component == "191";
      CHECK(carriedOut == (isOurs ? 1 : 0));
      CHECK(desk.timesOf(MAVLINK_MSG_ID_COMMAND_ACK, 0).size() == (isOurs ? 1u : 0u));
    }
    CHECK(desk.copies.size() == 2);
  }
}
