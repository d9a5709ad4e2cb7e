// send() by a whole client: a command that the autopilot takes in its other form only, COMMAND_LONG or COMMAND_INT.
#include <doctest/doctest.h>
#include <string.h>

#include <cmath>

#include "ClientOnLine.h"

using namespace mavmission;

namespace {

constexpr uint16_t kCommandInt = 75, kCommandLong = 76;
constexpr uint8_t kUnsupported = 3, kFailed = 4, kLongOnly = 7, kIntOnly = 8;  // MAV_RESULT
constexpr uint16_t kId = 2500;                                                 // VIDEO_START_CAPTURE
constexpr uint16_t kServo = 183;                                               // not to be carried out twice

template <typename Value>
Value valueAt(const SentFrame& frame, size_t at) {
  Value value;
  memcpy(&value, &frame.payload[at], sizeof(value));
  return value;
}

// A command without a place goes out as COMMAND_LONG; with a place, which CoordinateFrame::Mission makes two numbers,
// as COMMAND_INT.
FlightCommand withNumbers(uint16_t id, int32_t x, int32_t y, CoordinateFrame frame = CoordinateFrame::Mission) {
  FlightCommand command = flightCommand(id, 1.5f, 2.5f, 3.5f, 4.5f, 0, 0, 7.5f);
  command.hasPlace = true;
  command.frame = frame;
  command.x = x;
  command.y = y;
  return command;
}

struct Ordering : ClientOnLine {
  const FlightCommand command;

  explicit Ordering(const FlightCommand& one) : ClientOnLine(kArduPilot), command(one) {
    run(3000);
    client.send(command);
    REQUIRE(runUntilSent(command.hasPlace ? kCommandInt : kCommandLong, 10));
    sent.clear();
  }
  void answer(uint8_t result) {
    const uint8_t low = static_cast<uint8_t>(command.id), high = static_cast<uint8_t>(command.id >> 8);
    hear(FrameParts(77, {low, high, result, 0, 0, 0, 0, 0, 1, 191}, 143));
    run(10);
  }
  // Refused with this, it is not sent again in any form.
  Status refusal(uint8_t result) {
    answer(result);
    run(2000);
    CHECK(timesOf(kCommandInt, 0).empty());
    CHECK(timesOf(kCommandLong, 0).empty());
    return ended;
  }
};

}  // namespace

TEST_CASE("a command of numbers goes out as COMMAND_INT where the autopilot takes no COMMAND_LONG") {
  const struct {
    float given;
    int32_t sent;
  } kNumbers[] = {{3, 3}, {-7, -7}, {0, 0}, {16777216, 16777216}, {-1000000000, -1000000000}};
  for (const auto& fifth : kNumbers) {
    for (const auto& sixth : kNumbers) {
      Ordering desk(flightCommand(kId, 1.5f, 2.5f, 3.5f, 4.5f, fifth.given, sixth.given, 7.5f));
      desk.answer(kIntOnly);
      REQUIRE(desk.timesOf(kCommandInt, 0).size() == 1);
      const SentFrame& frame = desk.sent.back();
      for (size_t i = 0; i < 4; ++i) CHECK(valueAt<float>(frame, 4 * i) == 1.5f + static_cast<float>(i));
      CHECK(valueAt<int32_t>(frame, 16) == fifth.sent);
      CHECK(valueAt<int32_t>(frame, 20) == sixth.sent);
      CHECK(valueAt<float>(frame, 24) == 7.5f);
      CHECK(valueAt<uint16_t>(frame, 28) == kId);
      CHECK(frame.payload[30] == 1);  // for the autopilot
      CHECK(frame.payload[31] == 1);
      CHECK(frame.payload[32] == static_cast<uint8_t>(CoordinateFrame::Mission));
      CHECK(frame.payload[33] == 0);
      CHECK(frame.payload[34] == 0);
      desk.answer(0);
      CHECK((desk.ended == Status::Done));
    }
  }
}

TEST_CASE("a number that no integer holds does not fit into COMMAND_INT") {
  for (const float value : {0.5f, -1.25f, 3e9f, -1e20f, INFINITY, NAN}) {
    CHECK((Ordering(flightCommand(kId, 0, 0, 0, 0, value, 1)).refusal(kIntOnly) == Status::CommandIntOnly));
    CHECK((Ordering(flightCommand(kId, 0, 0, 0, 0, 1, value)).refusal(kIntOnly) == Status::CommandIntOnly));
    CHECK((Ordering(flightCommand(kId, 0, 0, 0, 0, value, value)).refusal(kIntOnly) == Status::CommandIntOnly));
  }
}

TEST_CASE("a command of integers goes out as COMMAND_LONG where the autopilot takes no COMMAND_INT") {
  const int32_t kNumbers[] = {3, -7, 0, 16777216, -16777218};
  for (const int32_t fifth : kNumbers) {
    for (const int32_t sixth : kNumbers) {
      Ordering desk(withNumbers(kId, fifth, sixth));
      desk.answer(kLongOnly);
      REQUIRE(desk.timesOf(kCommandLong, 0).size() == 1);
      const SentFrame& frame = desk.sent.back();
      for (size_t i = 0; i < 4; ++i) CHECK(valueAt<float>(frame, 4 * i) == 1.5f + static_cast<float>(i));
      CHECK(valueAt<float>(frame, 16) == static_cast<float>(fifth));
      CHECK(valueAt<float>(frame, 20) == static_cast<float>(sixth));
      CHECK(valueAt<float>(frame, 24) == 7.5f);
      CHECK(valueAt<uint16_t>(frame, 28) == kId);
      CHECK(frame.payload[32] == 0);  // its first attempt
      desk.answer(0);
      CHECK((desk.ended == Status::Done));
    }
  }
}

TEST_CASE("an integer that no float holds does not fit into COMMAND_LONG, and neither does a place") {
  CHECK((Ordering(withNumbers(kId, 16777217, 1)).refusal(kLongOnly) == Status::CommandLongOnly));
  CHECK((Ordering(withNumbers(kId, 1, 16777217)).refusal(kLongOnly) == Status::CommandLongOnly));
  CHECK((Ordering(withNumbers(kId, 16777217, 16777217)).refusal(kLongOnly) == Status::CommandLongOnly));
  CHECK((Ordering(withNumbers(kId, 1, 1, CoordinateFrame::GlobalRelative)).refusal(kLongOnly) ==
         Status::CommandLongOnly));
}

TEST_CASE("no other refusal is answered by the other form") {
  const FlightCommand asLong = flightCommand(kId, 0, 0, 0, 0, 1, 1), asInt = withNumbers(kId, 1, 1);
  CHECK((Ordering(asLong).refusal(kLongOnly) == Status::CommandLongOnly));
  CHECK((Ordering(asInt).refusal(kIntOnly) == Status::CommandIntOnly));
  CHECK((Ordering(asLong).refusal(kUnsupported) == Status::CommandUnsupported));
  CHECK((Ordering(asInt).refusal(kUnsupported) == Status::CommandUnsupported));
  CHECK((Ordering(asLong).refusal(kFailed) == Status::CommandFailed));
  CHECK((Ordering(asInt).refusal(kFailed) == Status::CommandFailed));
}

TEST_CASE("a command that is refused in both forms is refused") {
  Ordering asLong(flightCommand(kId, 0, 0, 0, 0, 1, 1)), asInt(withNumbers(kId, 1, 1));
  asLong.answer(kIntOnly);
  asLong.sent.clear();
  CHECK((asLong.refusal(kIntOnly) == Status::CommandIntOnly));
  asInt.answer(kLongOnly);
  asInt.sent.clear();
  CHECK((asInt.refusal(kLongOnly) == Status::CommandLongOnly));
}

TEST_CASE("what must not be carried out twice is sent once in the other form too") {
  for (const uint16_t id : {kId, kServo}) {
    Ordering desk(flightCommand(id, 0, 0, 0, 0, 1, 1));
    desk.answer(kIntOnly);
    desk.run(10000);
    CHECK(desk.timesOf(kCommandInt, 0).size() == (id == kServo ? 1 : 5));
    CHECK((desk.ended == (id == kServo ? Status::Unconfirmed : Status::NoAnswer)));
  }
}
