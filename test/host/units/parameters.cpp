// Parameters by a whole client: what is asked, set, repeated, and what each answer means.
#include "mavmission/service/Parameters.h"

#include <doctest/doctest.h>
#include <stdio.h>

#include <initializer_list>
#include <limits>
#include <string>

#include "Script.h"
#include "ToldClient.h"

using namespace mavmission;

namespace {

constexpr uint16_t kRead = MAVLINK_MSG_ID_PARAM_REQUEST_READ, kSet = MAVLINK_MSG_ID_PARAM_SET;
constexpr uint8_t kFloat = MAV_PARAM_TYPE_REAL32, kInt32 = MAV_PARAM_TYPE_INT32;

uint32_t bitsOf(float value) {
  uint32_t bits;
  memcpy(&bits, &value, sizeof(bits));
  return bits;
}

FlashText inFlash(const char* text) { return reinterpret_cast<FlashText>(text); }

// Each begins an operation about the parameter NAME, or goes on with it; did() says what came of that.
struct Desk : ToldClient {
  Parameters parameters;
  const bool isPx4;

  explicit Desk(uint8_t autopilot = kArduPilot) : ToldClient(autopilot), parameters(client), isPx4(autopilot == kPx4) {
    run(3000);
    sent.clear();
  }

  Desk& read(const char* name = "NAME") { return parameters.read(inFlash(name)), begun(); }
  Desk& set(float value) { return parameters.set(inFlash("NAME"), value), begun(); }
  Desk& setWhole(int32_t value) { return parameters.setWhole(inFlash("NAME"), value), begun(); }
  Desk& pass(uint32_t ms) { return run(ms), *this; }
  Desk& room(int bytes) { return line.room = bytes, *this; }
  Desk& arm() {
    beats = false;
    hear(heartbeatParts(kArduPilot, MAV_MODE_FLAG_SAFETY_ARMED));
    return pass(5);
  }
  // The parameter has this value, in the form in which this autopilot sends a number of this type.
  Desk& says(uint8_t type, float value, const char* name = "NAME", uint8_t systemId = 1) {
    const bool isAsBits = isPx4 && type < MAV_PARAM_TYPE_REAL32;
    const uint32_t bits = isAsBits ? static_cast<uint32_t>(static_cast<int32_t>(value)) : bitsOf(value);
    mavlink_param_value_t message = mavlink_param_value_t();
    memcpy(&message.param_value, &bits, sizeof(bits));
    strncpy(message.param_id, name, sizeof(message.param_id));
    message.param_type = type;
    FrameParts parts(MAVLINK_MSG_ID_PARAM_VALUE, message, MAVLINK_MSG_ID_PARAM_VALUE_CRC);
    parts.systemId = systemId;
    hear(parts);
    return pass(5);
  }

  // What has left since the last look, each after the milliseconds since the one before, to 10, and how it has ended.
  // "set -7 (6)": to this value, with this type.
  std::string did() {
    Transcript said;
    for (const SentFrame& frame : sent) {
      if (frame.messageId != kRead && frame.messageId != kSet) continue;
      const uint32_t ms = frame.atMs - fromMs_;
      said.note(frame.messageId == kRead ? readBy(frame) : setBy(frame), ms < 30 ? 0 : (ms + 5) / 10 * 10);
      fromMs_ = frame.atMs;
    }
    for (Status status : ends) said.note(nameOf(status));
    sent.clear();
    ends.clear();
    return said.text();
  }

 private:
  uint32_t fromMs_ = 0;

  Desk& begun() {
    fromMs_ = nowMs();
    return pass(20);
  }
  std::string readBy(const SentFrame& frame) {
    const std::string all = "PARAM_REQUEST_READ target_system 1 target_component 1 ";
    const std::string words = wordsOf(frame.messageId, frame.payload), end = " param_index -1";
    REQUIRE(words.find(all) == 0);
    REQUIRE(words.find(end) == words.size() - end.size());
    return "read " + words.substr(all.size(), words.size() - all.size() - end.size()).substr(9);
  }
  std::string setBy(const SentFrame& frame) {
    const auto message = messageIn<mavlink_param_set_t>(frame.payload);
    CHECK(std::string(message.param_id) == "NAME");
    CHECK(message.target_system == 1);
    CHECK(message.target_component == 1);
    int32_t whole;
    memcpy(&whole, &message.param_value, sizeof(whole));
    char text[40];
    const bool isAsBits = isPx4 && message.param_type < MAV_PARAM_TYPE_REAL32;
    isAsBits ? snprintf(text, sizeof(text), "set %ld (%u)", static_cast<long>(whole), message.param_type)
             : snprintf(text, sizeof(text), "set %.9g (%u)", double(message.param_value), message.param_type);
    return text;
  }
};

}  // namespace

TEST_CASE("a parameter is asked for by its name, and its value is what comes") {
  Desk desk;
  CHECK(desk.read("SERIAL1_BAUD").did() == "read SERIAL1_BAUD");
  CHECK((desk.parameters.read(inFlash("OTHER")) == Status::Busy));
  // Others change at any time, and other vehicles have the same.
  desk.says(kInt32, 1, "SERIAL1_BAU").says(kInt32, 1, "SERIAL1_BAUDS").says(kInt32, 1, "SERIAL1_BAUD", 9);
  CHECK(desk.did() == "");
  CHECK(desk.client.isBusy());
  CHECK(desk.says(kInt32, 57, "SERIAL1_BAUD").did() == "Done");
  CHECK(desk.parameters.value() == 57);
  CHECK(desk.parameters.whole() == 57);
  CHECK(desk.parameters.isWhole());
  // What comes after that is nobody's.
  desk.says(kInt32, 58, "SERIAL1_BAUD");
  CHECK(desk.parameters.value() == 57);
}

TEST_CASE("each type is read as this autopilot sends it") {
  for (uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    for (uint8_t type = MAV_PARAM_TYPE_UINT8; type <= MAV_PARAM_TYPE_REAL64; ++type) {
      Desk desk(autopilot);
      CHECK(desk.read().says(type, -3).did() == "read NAME, Done");
      CHECK(desk.parameters.value() == -3);
      CHECK(desk.parameters.whole() == -3);
      CHECK(desk.parameters.isWhole() == (type < MAV_PARAM_TYPE_REAL32));
    }
  }
  Desk desk;
  desk.read().says(kFloat, 2.5f);
  CHECK(desk.parameters.value() == 2.5f);
  CHECK(desk.parameters.whole() == 3);
}

TEST_CASE("a name that nobody knows is asked for every 1500 ms, up to 5 times, and then there is none") {
  Desk desk;
  CHECK(desk.read("NONE").pass(7400).did() == "read NONE, 1500 read NONE (4 times)");
  CHECK(desk.client.isBusy());
  CHECK(desk.pass(200).did() == "NoParameter");
}

TEST_CASE("a name has 16 characters at the most") {
  Desk desk;
  CHECK(desk.read("SIXTEEN_LETTERS_").says(MAV_PARAM_TYPE_INT8, 1, "SIXTEEN_LETTERS_").did() ==
        "read SIXTEEN_LETTERS_, Done");
  CHECK(desk.read("SEVENTEEN_LETTERS").did() == "NoParameter");
  // A name after a longer one is that name alone.
  CHECK(desk.read("AB").did() == "read AB");
}

TEST_CASE("a parameter that has the value already is not set") {
  for (uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    Desk desk(autopilot);
    CHECK(desk.setWhole(12).says(MAV_PARAM_TYPE_INT16, 12).did() == "read NAME, Done");
    CHECK(desk.set(-0.f).says(kFloat, 0).did() == "read NAME, Done");
  }
}

TEST_CASE("another value is set with the type that was read, and the answer confirms it") {
  for (uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    Desk desk(autopilot);
    CHECK(desk.setWhole(-7).says(kInt32, 99).did() == "read NAME, set -7 (6)");
    CHECK(desk.client.isBusy());
    CHECK(desk.says(kInt32, -7).did() == "Done");
    CHECK(desk.parameters.whole() == -7);
    CHECK(desk.set(0.25f).says(kFloat, 99).says(kFloat, 0.25f).did() == "read NAME, set 0.25 (9), Done");
    // A whole number for a float, and a float without a fraction for a whole one.
    CHECK(desk.setWhole(3).says(kFloat, 99).says(kFloat, 3).did() == "read NAME, set 3 (9), Done");
    CHECK(desk.set(5).says(MAV_PARAM_TYPE_UINT8, 99).says(MAV_PARAM_TYPE_UINT8, 5).did() ==
          "read NAME, set 5 (1), Done");
  }
}

TEST_CASE("another value that stays is told when it was set twice, and after 2 s") {
  Desk desk;
  // The first answer may be a late one to the reading.
  CHECK(desk.set(500).says(kFloat, 99).says(kFloat, 100).did() == "read NAME, set 500 (9)");
  CHECK(desk.pass(1500).says(kFloat, 100).did() == "1500 set 500 (9)");
  CHECK(desk.client.isBusy());
  CHECK(desk.pass(1000).says(kFloat, 100).did() == "OtherValue");
  CHECK(desk.parameters.value() == 100);
  // The 2 s count from the setting, and not from the reading.
  CHECK(desk.set(500).pass(1200).says(kFloat, 99).pass(1500).says(kFloat, 100).did() ==
        "read NAME, 1220 set 500 (9), 1500 set 500 (9)");
  CHECK(desk.client.isBusy());
  CHECK(desk.pass(500).says(kFloat, 100).did() == "OtherValue");
}

TEST_CASE("another value counts when it was set twice, however long that takes") {
  Desk desk;
  CHECK(desk.set(500).says(kFloat, 99).did() == "read NAME, set 500 (9)");
  CHECK(desk.room(0).pass(2500).says(kFloat, 100).did() == "");  // the second attempt cannot leave
  CHECK(desk.room(MemoryStream::kAlwaysRoom).pass(100).says(kFloat, 100).did() == "2510 set 500 (9), OtherValue");
}

TEST_CASE("a set value that nobody confirms is unconfirmed after 5 attempts") {
  Desk desk;
  CHECK(desk.set(500).says(kFloat, 99).pass(7400).did() == "read NAME, set 500 (9), 1500 set 500 (9) (4 times)");
  CHECK(desk.client.isBusy());
  CHECK(desk.pass(200).did() == "Unconfirmed");
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
      CHECK(desk.setWhole(number).says(range.type, 99).did() ==
            "read NAME, set " + std::to_string(number) + " (" + std::to_string(range.type) + ")");
    }
    Desk desk(ClientOnLine::kPx4);
    CHECK(desk.setWhole(range.least - 1).says(range.type, 99).pass(20).did() == "read NAME, NotKept");
    if (range.most == INT32_MAX) continue;
    CHECK(desk.setWhole(range.most + 1).says(range.type, 99).pass(20).did() == "read NAME, NotKept");
    CHECK(desk.set(static_cast<float>(range.most + 1)).says(range.type, 99).pass(20).did() == "read NAME, NotKept");
  }
  Desk wide(ClientOnLine::kPx4);
  CHECK(wide.setWhole(INT32_MIN).says(kInt32, 99).did() == "read NAME, set -2147483648 (6)");
}

TEST_CASE("a number with a fraction, or with more digits than a float, is not set where it would not be kept") {
  Desk desk;
  const MissionItem odd[] = {anyCommandAt(kNavWaypoint, -35_deg, 149_deg, 20_m, 2.5f)};
  desk.client.upload(inRam(odd));
  CHECK(desk.pass(50).did() == "NotKept");
  CHECK(desk.client.keptValue() == 2);
  for (float number : {1.5f, -0.25f, 3e9f, 1e38f}) {
    CHECK(desk.set(number).says(kInt32, 99).pass(20).did() == "read NAME, NotKept");
    CHECK_FALSE(desk.client.keptValue() == desk.client.keptValue());  // of a plan alone
  }
  // ArduPilot's whole numbers are floats on the wire; PX4's are not.
  CHECK(desk.setWhole(16777217).says(kInt32, 99).pass(20).did() == "read NAME, NotKept");
  CHECK(desk.setWhole(16777217).says(kFloat, 99).pass(20).did() == "read NAME, NotKept");
  CHECK(desk.setWhole(16777216).says(kInt32, 99).did() == "read NAME, set 16777216 (6)");
  Desk px4(ClientOnLine::kPx4);
  CHECK(px4.setWhole(16777217).says(kInt32, 99).did() == "read NAME, set 16777217 (6)");
}

TEST_CASE("what is no number is refused before anything is sent") {
  Desk desk;
  CHECK(desk.set(std::numeric_limits<float>::quiet_NaN()).did() == "NotANumber");
  CHECK(desk.set(-std::numeric_limits<float>::infinity()).did() == "NotFinite");
  CHECK(desk.setWhole(0x7FC00000).did() == "read NAME");  // the same bits as a whole number are one
}

TEST_CASE("an armed autopilot's parameters are read, and set only where the sketch allows it") {
  Desk desk;
  CHECK(desk.arm().read().says(kFloat, 1).did() == "read NAME, Done");
  CHECK(desk.setWhole(2).did() == "Armed");
  CHECK(desk.set(2).did() == "Armed");
  desk.client.allowWhileArmed(true);
  CHECK(desk.set(2).says(kFloat, 99).did() == "read NAME, set 2 (9)");
  Desk later;  // it is armed between the reading and the setting
  CHECK(later.set(2).arm().did() == "read NAME, Armed");
}

TEST_CASE("nothing that comes before the request has left is its answer, and nothing after cancel()") {
  Desk desk;
  CHECK(desk.room(0).read().says(kFloat, 1).did() == "");
  CHECK(desk.client.isBusy());
  CHECK(desk.room(MemoryStream::kAlwaysRoom).pass(1000).did() == "read NAME");
  desk.client.cancel();
  CHECK(desk.pass(5).did() == "Cancelled");
  desk.says(kFloat, 3);
  CHECK(desk.parameters.value() == 0);
  // Nor is it of another operation's.
  desk.client.setMessageInterval(30, 100000);
  desk.pass(100).says(kFloat, 4);
  CHECK(desk.parameters.value() == 0);
}

TEST_CASE("an operation that takes too long ends as such") {
  Desk desk;
  desk.client.setOperationTimeout(3);
  CHECK(desk.read("NONE").pass(2500).did() == "read NONE, 1500 read NONE");
  CHECK(desk.client.isBusy());
  CHECK(desk.pass(1600).did() == "TookTooLong");
}

TEST_CASE("a parameter is asked for in the update() that follows, and its time begins then") {
  Desk desk;
  desk.pass(10).did();
  desk.parameters.read(inFlash("NAME"));
  desk.pass(1);
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

TEST_CASE("a value that comes while the client clears a plan ends nothing, though its reading was cancelled") {
  Desk desk;
  desk.read().client.cancel();
  CHECK(desk.pass(5).did() == "read NAME, Cancelled");
  desk.client.clear();
  REQUIRE(desk.runUntilSent(MAVLINK_MSG_ID_MISSION_CLEAR_ALL, 3000));
  CHECK(desk.says(kFloat, 4).did() == "");
  CHECK(desk.client.isBusy());
  CHECK(desk.parameters.value() == 0);
}
