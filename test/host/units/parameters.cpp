// Parameters by a whole client: what is asked, set, repeated, and what each answer means.
#include "mavmission/service/Parameters.h"

#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>
#include <limits>
#include <string>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

constexpr uint16_t kRead = MAVLINK_MSG_ID_PARAM_REQUEST_READ, kSet = MAVLINK_MSG_ID_PARAM_SET;
constexpr uint8_t kArmed = 128;

uint32_t bitsOf(float value) {
  uint32_t bits;
  memcpy(&bits, &value, sizeof(bits));
  return bits;
}

FlashText inFlash(const char* text) { return reinterpret_cast<FlashText>(text); }

struct Desk : ClientOnLine {
  Parameters parameters;
  const bool isPx4;

  explicit Desk(uint8_t autopilot = kArduPilot)
      : ClientOnLine(autopilot), parameters(client), isPx4(autopilot == kPx4) {
    run(3000);
    sent.clear();
  }

  void tellBits(const char* name, uint8_t type, uint32_t bits, uint8_t systemId = 1) {
    mavlink_param_value_t message = mavlink_param_value_t();
    memcpy(&message.param_value, &bits, sizeof(bits));
    strncpy(message.param_id, name, sizeof(message.param_id));
    message.param_type = type;
    Bytes payload(sizeof(message));
    memcpy(payload.data(), &message, sizeof(message));
    FrameParts parts(MAVLINK_MSG_ID_PARAM_VALUE, payload, MAVLINK_MSG_ID_PARAM_VALUE_CRC);
    parts.systemId = systemId;
    hear(parts);
    run(5);
  }
  // A number as this autopilot sends it.
  void tell(const char* name, uint8_t type, float value) {
    const bool isAsBits = isPx4 && type < MAV_PARAM_TYPE_REAL32;
    tellBits(name, type, isAsBits ? static_cast<uint32_t>(static_cast<int32_t>(value)) : bitsOf(value));
  }
  // The bits that PARAM_SET carries after the parameter was read with this type and another value.
  bool isSet(uint8_t type, uint32_t bits) {
    sent.clear();
    tell("NAME", type, 99);
    if (sent.empty() || sent.back().messageId != kSet) return false;
    mavlink_param_set_t message;
    memcpy(&message, sent.back().payload.data(), sizeof(message));
    uint32_t found;
    memcpy(&found, &message.param_value, sizeof(found));
    CHECK(message.param_type == type);
    CHECK(strcmp(message.param_id, "NAME") == 0);
    CHECK(message.target_system == 1);
    CHECK(message.target_component == 1);
    CHECK(found == bits);
    return found == bits;
  }
  // How setting it ends when it is found with this type and another value, before anything is set.
  Status refused(uint8_t type) {
    ended = Status::Idle;
    tell("NAME", type, 99);
    run(20);
    return ended;
  }
};

}  // namespace

TEST_CASE("a parameter is asked for by its name, and its value is what comes") {
  Desk desk;
  CHECK((desk.parameters.read(inFlash("SERIAL1_BAUD")) == desk.client.status()));
  CHECK(desk.client.isBusy());
  REQUIRE(desk.runUntilSent(kRead, 100));
  mavlink_param_request_read_t request;
  memcpy(&request, desk.sent.back().payload.data(), sizeof(request));
  CHECK(request.param_index == -1);
  CHECK(strcmp(request.param_id, "SERIAL1_BAUD") == 0);
  CHECK(request.target_system == 1);
  CHECK(request.target_component == 1);
  CHECK((desk.parameters.read(inFlash("OTHER")) == Status::Busy));
  // Others change at any time, and other vehicles have the same.
  desk.tell("SERIAL1_BAU", MAV_PARAM_TYPE_INT32, 1);
  desk.tell("SERIAL1_BAUDS", MAV_PARAM_TYPE_INT32, 1);
  desk.tellBits("SERIAL1_BAUD", MAV_PARAM_TYPE_INT32, bitsOf(1), 9);
  CHECK(desk.client.isBusy());
  desk.tell("SERIAL1_BAUD", MAV_PARAM_TYPE_INT32, 57);
  CHECK((desk.ended == Status::Done));
  CHECK(desk.parameters.value() == 57);
  CHECK(desk.parameters.whole() == 57);
  CHECK(desk.parameters.isWhole());
  // What comes behind that is nobody's.
  desk.tell("SERIAL1_BAUD", MAV_PARAM_TYPE_INT32, 58);
  CHECK(desk.parameters.value() == 57);
}

TEST_CASE("each type is read as this autopilot sends it") {
  for (uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    for (uint8_t type = MAV_PARAM_TYPE_UINT8; type <= MAV_PARAM_TYPE_REAL64; ++type) {
      Desk desk(autopilot);
      desk.parameters.read(inFlash("NAME"));
      REQUIRE(desk.runUntilSent(kRead, 100));
      desk.tell("NAME", type, -3);
      CHECK((desk.ended == Status::Done));
      CHECK(desk.parameters.value() == -3);
      CHECK(desk.parameters.whole() == -3);
      CHECK(desk.parameters.isWhole() == (type < MAV_PARAM_TYPE_REAL32));
    }
  }
  Desk desk;
  desk.parameters.read(inFlash("NAME"));
  REQUIRE(desk.runUntilSent(kRead, 100));
  desk.tell("NAME", MAV_PARAM_TYPE_REAL32, 2.5f);
  CHECK(desk.parameters.value() == 2.5f);
  CHECK(desk.parameters.whole() == 3);
}

TEST_CASE("a name that nobody knows is asked for every 1500 ms, up to 5 times, and then there is none") {
  Desk desk;
  desk.parameters.read(inFlash("NONE"));
  REQUIRE(desk.runUntilSent(kRead, 100));
  const uint32_t from = desk.nowMs();
  desk.run(7400);
  const std::vector<uint32_t> times = desk.timesOf(kRead, from);
  REQUIRE(times.size() == 5);
  for (uint32_t i = 0; i < 5; ++i) CHECK((times[i] >= 1500 * i && times[i] <= 1500 * i + 20));
  CHECK(desk.client.isBusy());
  desk.run(200);
  CHECK((desk.ended == Status::NoParameter));
}

TEST_CASE("a name has 16 characters at the most") {
  Desk desk;
  desk.parameters.read(inFlash("SIXTEEN_LETTERS_"));
  REQUIRE(desk.runUntilSent(kRead, 100));
  CHECK(memcmp(&desk.sent.back().payload[4], "SIXTEEN_LETTERS_", 16) == 0);
  desk.tell("SIXTEEN_LETTERS_", MAV_PARAM_TYPE_INT8, 1);
  CHECK((desk.ended == Status::Done));
  desk.sent.clear();
  desk.parameters.read(inFlash("SEVENTEEN_LETTERS"));
  desk.run(50);
  CHECK((desk.ended == Status::NoParameter));
  CHECK(desk.timesOf(kRead, 0).empty());
  // A name after a longer one is that name alone.
  desk.parameters.read(inFlash("AB"));
  REQUIRE(desk.runUntilSent(kRead, 100));
  CHECK(desk.sent.back().payload[4 + 2] == 0);
  CHECK(desk.sent.back().payload[4 + 3] == 0);
}

TEST_CASE("a parameter that has the value already is not set") {
  for (uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    Desk desk(autopilot);
    desk.parameters.setWhole(inFlash("NAME"), 12);
    REQUIRE(desk.runUntilSent(kRead, 100));
    desk.tell("NAME", MAV_PARAM_TYPE_INT16, 12);
    CHECK((desk.ended == Status::Done));
    CHECK(desk.timesOf(kSet, 0).empty());
    // -0 is 0.
    desk.parameters.set(inFlash("NAME"), -0.f);
    REQUIRE(desk.runUntilSent(kRead, 100));
    desk.tell("NAME", MAV_PARAM_TYPE_REAL32, 0);
    CHECK((desk.ended == Status::Done));
    CHECK(desk.timesOf(kSet, 0).empty());
  }
}

TEST_CASE("another value is set with the type that was read, and the answer confirms it") {
  for (uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    const bool isPx4 = autopilot == ClientOnLine::kPx4;
    Desk desk(autopilot);
    desk.parameters.setWhole(inFlash("NAME"), -7);
    REQUIRE(desk.runUntilSent(kRead, 100));
    CHECK(desk.isSet(MAV_PARAM_TYPE_INT32, isPx4 ? static_cast<uint32_t>(-7) : bitsOf(-7)));
    CHECK(desk.client.isBusy());
    desk.tell("NAME", MAV_PARAM_TYPE_INT32, -7);
    CHECK((desk.ended == Status::Done));
    CHECK(desk.parameters.whole() == -7);
    desk.parameters.set(inFlash("NAME"), 0.25f);
    REQUIRE(desk.runUntilSent(kRead, 100));
    CHECK(desk.isSet(MAV_PARAM_TYPE_REAL32, bitsOf(0.25f)));
    desk.tell("NAME", MAV_PARAM_TYPE_REAL32, 0.25f);
    CHECK((desk.ended == Status::Done));
    // A whole number for a float, and a float without a fraction for a whole one.
    desk.parameters.setWhole(inFlash("NAME"), 3);
    REQUIRE(desk.runUntilSent(kRead, 100));
    CHECK(desk.isSet(MAV_PARAM_TYPE_REAL32, bitsOf(3)));
    desk.tell("NAME", MAV_PARAM_TYPE_REAL32, 3);
    desk.parameters.set(inFlash("NAME"), 5);
    REQUIRE(desk.runUntilSent(kRead, 100));
    CHECK(desk.isSet(MAV_PARAM_TYPE_UINT8, isPx4 ? 5 : bitsOf(5)));
    desk.tell("NAME", MAV_PARAM_TYPE_UINT8, 5);
    CHECK((desk.ended == Status::Done));
  }
}

TEST_CASE("another value that stays is told when it was set twice, and after 2 s") {
  Desk desk;
  desk.parameters.set(inFlash("NAME"), 500);
  REQUIRE(desk.runUntilSent(kRead, 100));
  CHECK(desk.isSet(MAV_PARAM_TYPE_REAL32, bitsOf(500)));
  desk.tell("NAME", MAV_PARAM_TYPE_REAL32, 100);  // a late answer to the reading, perhaps
  CHECK(desk.client.isBusy());
  REQUIRE(desk.runUntilSent(kSet, 1600));
  desk.tell("NAME", MAV_PARAM_TYPE_REAL32, 100);
  CHECK(desk.client.isBusy());
  desk.run(1000);
  desk.tell("NAME", MAV_PARAM_TYPE_REAL32, 100);
  CHECK((desk.ended == Status::OtherValue));
  CHECK(desk.parameters.value() == 100);
}

TEST_CASE("a set value that nobody confirms is unconfirmed after 5 attempts") {
  Desk desk;
  desk.parameters.set(inFlash("NAME"), 500);
  REQUIRE(desk.runUntilSent(kRead, 100));
  CHECK(desk.isSet(MAV_PARAM_TYPE_REAL32, bitsOf(500)));
  desk.run(7400);
  CHECK(desk.client.isBusy());
  CHECK(desk.timesOf(kSet, 0).size() == 5);
  desk.run(200);
  CHECK((desk.ended == Status::Unconfirmed));
}

TEST_CASE("a number that the parameter's type does not have is not set") {
  const struct {
    uint8_t type;
    int32_t least, most;
  } kRanges[] = {{MAV_PARAM_TYPE_UINT8, 0, 255},        {MAV_PARAM_TYPE_INT8, -128, 127},
                 {MAV_PARAM_TYPE_UINT16, 0, 65535},     {MAV_PARAM_TYPE_INT16, -32768, 32767},
                 {MAV_PARAM_TYPE_UINT32, 0, INT32_MAX}, {MAV_PARAM_TYPE_UINT64, 0, INT32_MAX}};
  for (const auto& range : kRanges) {
    for (int32_t number : {range.least, range.most}) {
      Desk desk(ClientOnLine::kPx4);
      desk.parameters.setWhole(inFlash("NAME"), number);
      REQUIRE(desk.runUntilSent(kRead, 100));
      CHECK(desk.isSet(range.type, static_cast<uint32_t>(number)));
    }
    Desk desk(ClientOnLine::kPx4);
    desk.parameters.setWhole(inFlash("NAME"), range.least - 1);
    REQUIRE(desk.runUntilSent(kRead, 100));
    CHECK((desk.refused(range.type) == Status::NotKept));
    if (range.most == INT32_MAX) continue;
    desk.parameters.setWhole(inFlash("NAME"), range.most + 1);
    REQUIRE(desk.runUntilSent(kRead, 100));
    CHECK((desk.refused(range.type) == Status::NotKept));
    desk.parameters.set(inFlash("NAME"), static_cast<float>(range.most + 1));
    REQUIRE(desk.runUntilSent(kRead, 100));
    CHECK((desk.refused(range.type) == Status::NotKept));
    CHECK(desk.timesOf(kSet, 0).empty());
  }
  Desk wide(ClientOnLine::kPx4);
  wide.parameters.setWhole(inFlash("NAME"), INT32_MIN);
  REQUIRE(wide.runUntilSent(kRead, 100));
  CHECK(wide.isSet(MAV_PARAM_TYPE_INT32, 0x80000000));
}

TEST_CASE("a number with a fraction, or with more digits than a float, is not set where it would not be kept") {
  Desk desk;
  const MissionItem odd[] = {anyCommandAt(kNavWaypoint, -35_deg, 149_deg, 20_m, 2.5f)};
  desk.client.upload(inRam(odd));
  desk.run(50);
  CHECK(desk.client.keptValue() == 2);
  for (float number : {1.5f, -0.25f, 3e9f, 1e38f}) {
    desk.parameters.set(inFlash("NAME"), number);
    REQUIRE(desk.runUntilSent(kRead, 100));
    CHECK((desk.refused(MAV_PARAM_TYPE_INT32) == Status::NotKept));
    CHECK_FALSE(desk.client.keptValue() == desk.client.keptValue());  // of a plan alone
    desk.sent.clear();
  }
  // ArduPilot's whole numbers are floats on the wire; PX4's are not.
  desk.parameters.setWhole(inFlash("NAME"), 16777217);
  REQUIRE(desk.runUntilSent(kRead, 100));
  CHECK((desk.refused(MAV_PARAM_TYPE_INT32) == Status::NotKept));
  desk.parameters.setWhole(inFlash("NAME"), 16777217);
  REQUIRE(desk.runUntilSent(kRead, 100));
  CHECK((desk.refused(MAV_PARAM_TYPE_REAL32) == Status::NotKept));
  desk.parameters.setWhole(inFlash("NAME"), 16777216);
  REQUIRE(desk.runUntilSent(kRead, 100));
  CHECK(desk.isSet(MAV_PARAM_TYPE_INT32, bitsOf(16777216)));
  Desk px4(ClientOnLine::kPx4);
  px4.parameters.setWhole(inFlash("NAME"), 16777217);
  REQUIRE(px4.runUntilSent(kRead, 100));
  CHECK(px4.isSet(MAV_PARAM_TYPE_INT32, 16777217));
}

TEST_CASE("what is no number is refused before anything is sent") {
  Desk desk;
  desk.parameters.set(inFlash("NAME"), std::numeric_limits<float>::quiet_NaN());
  desk.run(20);
  CHECK((desk.ended == Status::NotANumber));
  desk.parameters.set(inFlash("NAME"), -std::numeric_limits<float>::infinity());
  desk.run(20);
  CHECK((desk.ended == Status::NotFinite));
  CHECK(desk.timesOf(kRead, 0).empty());
  // The same bits as a whole number are one.
  desk.parameters.setWhole(inFlash("NAME"), 0x7FC00000);
  CHECK(desk.runUntilSent(kRead, 100));
}

TEST_CASE("an armed autopilot's parameters are read, and set only where the sketch allows it") {
  Desk desk;
  const auto arm = [&desk]() {
    desk.beats = false;
    desk.hear(heartbeatParts(ClientOnLine::kArduPilot, kArmed));
    desk.run(5);
  };
  arm();
  desk.parameters.read(inFlash("NAME"));
  REQUIRE(desk.runUntilSent(kRead, 100));
  desk.tell("NAME", MAV_PARAM_TYPE_REAL32, 1);
  CHECK((desk.ended == Status::Done));
  desk.sent.clear();
  for (bool isWhole : {true, false}) {
    isWhole ? desk.parameters.setWhole(inFlash("NAME"), 2) : desk.parameters.set(inFlash("NAME"), 2);
    desk.run(20);
    CHECK((desk.ended == Status::Armed));
    CHECK(desk.timesOf(kRead, 0).empty());
  }
  desk.client.allowWhileArmed(true);
  desk.parameters.set(inFlash("NAME"), 2);
  CHECK(desk.runUntilSent(kRead, 100));
  CHECK(desk.isSet(MAV_PARAM_TYPE_REAL32, bitsOf(2)));
  // One that is armed between the reading and the setting.
  Desk later;
  later.parameters.set(inFlash("NAME"), 2);
  REQUIRE(later.runUntilSent(kRead, 100));
  later.beats = false;
  later.hear(heartbeatParts(ClientOnLine::kArduPilot, kArmed));
  later.run(5);
  CHECK((later.ended == Status::Armed));
}

TEST_CASE("nothing that comes before the request has left is its answer, and nothing after cancel()") {
  Desk desk;
  desk.line.room = 0;
  desk.parameters.read(inFlash("NAME"));
  desk.run(20);
  desk.tell("NAME", MAV_PARAM_TYPE_REAL32, 1);
  CHECK(desk.client.isBusy());
  desk.line.room = MemoryStream::kAlwaysRoom;
  REQUIRE(desk.runUntilSent(kRead, 1000));
  desk.client.cancel();
  desk.run(5);
  CHECK((desk.ended == Status::Cancelled));
  desk.tell("NAME", MAV_PARAM_TYPE_REAL32, 3);
  CHECK(desk.parameters.value() == 0);
  // Nor is it of another operation's.
  desk.client.setMessageInterval(30, 100000);
  desk.run(100);
  desk.tell("NAME", MAV_PARAM_TYPE_REAL32, 4);
  CHECK(desk.parameters.value() == 0);
}

TEST_CASE("an operation that takes too long ends as such") {
  Desk desk;
  desk.client.setOperationTimeout(3);
  desk.parameters.read(inFlash("NONE"));
  desk.run(2500);
  CHECK(desk.client.isBusy());
  desk.run(1600);
  CHECK((desk.ended == Status::TookTooLong));
}

TEST_CASE("another value counts when it was set twice, however long that takes") {
  Desk desk;
  desk.parameters.set(inFlash("NAME"), 500);
  REQUIRE(desk.runUntilSent(kRead, 100));
  CHECK(desk.isSet(MAV_PARAM_TYPE_REAL32, bitsOf(500)));
  desk.line.room = 0;  // the second attempt cannot leave
  desk.run(2500);
  desk.tell("NAME", MAV_PARAM_TYPE_REAL32, 100);
  CHECK(desk.client.isBusy());
  desk.line.room = MemoryStream::kAlwaysRoom;
  REQUIRE(desk.runUntilSent(kSet, 100));
  desk.tell("NAME", MAV_PARAM_TYPE_REAL32, 100);
  CHECK((desk.ended == Status::OtherValue));
}

TEST_CASE("the 2 s after which another value is believed count from the setting, and not from the reading") {
  Desk desk;
  desk.parameters.set(inFlash("NAME"), 500);
  REQUIRE(desk.runUntilSent(kRead, 100));
  desk.run(1200);
  CHECK(desk.isSet(MAV_PARAM_TYPE_REAL32, bitsOf(500)));
  REQUIRE(desk.runUntilSent(kSet, 1600));
  desk.tell("NAME", MAV_PARAM_TYPE_REAL32, 100);
  CHECK(desk.client.isBusy());
  desk.run(500);
  desk.tell("NAME", MAV_PARAM_TYPE_REAL32, 100);
  CHECK((desk.ended == Status::OtherValue));
}

TEST_CASE("a parameter is asked for in the update() that follows, and its time begins then") {
  Desk desk;
  desk.run(10);
  desk.parameters.read(inFlash("NAME"));
  desk.run(1);
  CHECK(desk.timesOf(kRead, 0).size() == 1);

  ClientOnLine waiting(ClientOnLine::kArduPilot);
  Parameters parameters(waiting.client);
  waiting.client.setOperationTimeout(2);
  waiting.beats = false;
  parameters.read(inFlash("NAME"));
  waiting.run(3500);
  waiting.beats = true;
  REQUIRE(waiting.runUntilSent(kRead, 4000));
  waiting.run(1900);
  CHECK(waiting.client.isBusy());
}

TEST_CASE("a value is for the one that has asked") {
  Desk desk;
  Parameters other(desk.client);
  desk.tell("NAME", MAV_PARAM_TYPE_REAL32, 1);
  for (Parameters* one : {&desk.parameters, &other}) {
    one->read(inFlash("NAME"));
    REQUIRE(desk.runUntilSent(kRead, 100));
    const float value = one == &other ? 8 : 7;
    desk.tell("NAME", MAV_PARAM_TYPE_REAL32, value);
    CHECK((desk.ended == Status::Done));
    CHECK(one->value() == value);
    CHECK_FALSE((one == &other ? desk.parameters : other).value() == value);
  }
}

TEST_CASE("a value that comes while the client clears a plan ends nothing, though its reading was cancelled") {
  Desk desk;
  desk.parameters.read(inFlash("NAME"));
  REQUIRE(desk.runUntilSent(kRead, 100));
  desk.client.cancel();
  desk.run(5);
  desk.ended = Status::Idle;
  desk.client.clear();
  REQUIRE(desk.runUntilSent(MAVLINK_MSG_ID_MISSION_CLEAR_ALL, 3000));
  desk.tell("NAME", MAV_PARAM_TYPE_REAL32, 4);
  CHECK(desk.client.isBusy());
  CHECK((desk.ended == Status::Idle));
  CHECK(desk.parameters.value() == 0);
}
