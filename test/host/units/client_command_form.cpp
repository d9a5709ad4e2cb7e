// send() by a whole client: a command that the autopilot takes in its other form only, COMMAND_LONG or COMMAND_INT.
#include <doctest/doctest.h>

#include <cmath>

#include "Conversation.h"

using namespace mavmission;

namespace {

// What a command gets that this is the answer to, and then this.
std::string answered(const FlightCommand& command, const std::string& result, const std::string& events = "2 s") {
  Conversation desk(Conversation::kArduPilot);
  desk.command = command;
  desk.plays("send, 10 ms");
  return desk.plays("answer " + std::to_string(command.id) + " " + result + ", " + events);
}

FlightCommand withFloats(float fifth, float sixth) {
  return flightCommand(2500, 1.5f, 2.5f, 3.5f, 4.5f, fifth, sixth, 7.5f);
}

// A command without a place goes out as COMMAND_LONG; with a place, which CoordinateFrame::Mission makes two numbers,
// as COMMAND_INT.
FlightCommand withNumbers(int32_t x, int32_t y, CoordinateFrame frame = CoordinateFrame::Mission) {
  FlightCommand command = withFloats(0, 0);
  command.hasPlace = true;
  command.frame = frame;
  command.x = x;
  command.y = y;
  return command;
}

}  // namespace

TEST_CASE("a command of numbers goes out in the other form where the autopilot takes no other one") {
  const int32_t kNumbers[] = {3, -7, 0, 16777216, -1000000000, -16777218};
  for (const int32_t fifth : kNumbers) {
    for (const int32_t sixth : kNumbers) {
      const std::string both = std::to_string(fifth) + " " + std::to_string(sixth) + " 7.5";
      const std::string then = "answer 2500 accepted";
      CHECK(answered(withFloats(static_cast<float>(fifth), static_cast<float>(sixth)), "int only", then) ==
            "INT 2500 frame 2 1.5 2.5 3.5 4.5 at " + both + ", -> Done (NotKnown)");
      CHECK(answered(withNumbers(fifth, sixth), "long only", then) ==
            "LONG 2500 1.5 2.5 3.5 4.5 " + both + ", -> Done (NotKnown)");
    }
  }
}

TEST_CASE("a number that no integer holds does not fit into COMMAND_INT") {
  for (const float value : {0.5f, -1.25f, 3e9f, -1e20f, INFINITY, NAN}) {
    CHECK(answered(withFloats(value, 1), "int only") == "-> CommandIntOnly (NotKnown)");
    CHECK(answered(withFloats(1, value), "int only") == "-> CommandIntOnly (NotKnown)");
    CHECK(answered(withFloats(value, value), "int only") == "-> CommandIntOnly (NotKnown)");
  }
}

TEST_CASE("an integer that no float holds does not fit into COMMAND_LONG, and neither does a place") {
  for (const FlightCommand& one : {withNumbers(16777217, 1), withNumbers(1, 16777217), withNumbers(16777217, 16777217),
                                   withNumbers(1, 1, CoordinateFrame::GlobalRelative)}) {
    CHECK(answered(one, "long only") == "-> CommandLongOnly (NotKnown)");
  }
}

TEST_CASE("no other refusal is answered by the other form, and what is refused in both forms is refused") {
  const FlightCommand asLong = withFloats(1, 1), asInt = withNumbers(1, 1);
  CHECK(answered(asLong, "long only") == "-> CommandLongOnly (NotKnown)");
  CHECK(answered(asInt, "int only") == "-> CommandIntOnly (NotKnown)");
  for (const FlightCommand& one : {asLong, asInt}) {
    CHECK(answered(one, "unsupported") == "-> CommandUnsupported (NotKnown)");
    CHECK(answered(one, "failed") == "-> CommandFailed (NotKnown)");
  }
  CHECK(answered(asLong, "int only", "answer 2500 int only, 2 s") ==
        "INT 2500 frame 2 1.5 2.5 3.5 4.5 at 1 1 7.5, -> CommandIntOnly (NotKnown)");
  CHECK(answered(asInt, "long only", "answer 2500 long only, 2 s") ==
        "LONG 2500 1.5 2.5 3.5 4.5 1 1 7.5, -> CommandLongOnly (NotKnown)");
}
