// A MessageListener: what a sketch is given of a message, and that it takes nothing from the library's own listeners.
#include "mavmission/service/MessageListener.h"

#include <doctest/doctest.h>
#include <string.h>

#include <vector>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

const MessageKey kOwn[] = {messageKey(4321, 77, 6), messageKey(24, 24, 30)};
const MessageKey kOfPayload[] = {messageKey(MAVLINK_MSG_ID_COMMAND_LONG, MAVLINK_MSG_ID_COMMAND_LONG_CRC, 33)};

struct Copy {
  uint16_t id;
  uint8_t systemId, componentId, version, length;
  Bytes payload;
};

void keep(void* copies, const ReceivedMessage& message) {
  static_cast<std::vector<Copy>*>(copies)->push_back({message.id, message.systemId, message.componentId,
                                                      message.version, message.length,
                                                      Bytes(message.payload, message.payload + message.length)});
}

struct Desk : ClientOnLine {
  std::vector<Copy> copies;
  Desk() : ClientOnLine(kArduPilot) {}

  void tell(uint32_t id, uint8_t crcExtra, const Bytes& payload, uint8_t version = 2) {
    FrameParts parts(id, payload, crcExtra);
    parts.systemId = 42;
    parts.componentId = 77;
    parts.version = version;
    hear(parts);
    while (!line.toRead.empty()) run(1);
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
  REQUIRE(desk.copies.size() == 1);
  const Copy& copy = desk.copies[0];
  CHECK(copy.id == 4321);
  CHECK(copy.systemId == 42);
  CHECK(copy.componentId == 77);
  CHECK(copy.version == 2);
  CHECK(copy.length == 7);
  CHECK(copy.payload == Bytes{1, 2, 3, 4, 5, 6, 7});
  desk.tell(24, 24, Bytes(30, 9), 1);
  REQUIRE(desk.copies.size() == 2);
  CHECK(desk.copies[1].id == 24);
  CHECK(desk.copies[1].version == 1);
  CHECK(desk.copies[1].length == 30);
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
    struct Listening : Desk {
      int carriedOut = 0;
      MessageListener* before;
      Payload payload;
      MessageListener* behind;
      explicit Listening(bool isBefore)
          : before(isBefore ? new MessageListener(client, kOfPayload, keep, &copies) : nullptr),
            payload(client, carryOut, &carriedOut),
            behind(isBefore ? nullptr : new MessageListener(client, kOfPayload, keep, &copies)) {}
      void command(uint8_t component) {
        Bytes bytes(33, 0);
        bytes[28] = 42600 & 255;
        bytes[29] = 42600 >> 8;
        bytes[30] = 1;
        bytes[31] = component;
        tell(MAVLINK_MSG_ID_COMMAND_LONG, MAVLINK_MSG_ID_COMMAND_LONG_CRC, bytes);
        payload.update();
        run(5);
      }
    } desk(isFirst);
    desk.run(3500);
    desk.command(154);
    CHECK(desk.carriedOut == 0);
    CHECK(desk.timesOf(MAVLINK_MSG_ID_COMMAND_ACK, 0).empty());
    desk.command(191);
    CHECK(desk.carriedOut == 1);
    CHECK(desk.timesOf(MAVLINK_MSG_ID_COMMAND_ACK, 0).size() == 1);
    CHECK(desk.copies.size() == 2);
    delete desk.before;
    delete desk.behind;
  }
}
