// Payload by a whole client: which commands are carried out, how often, and what is answered to whom.
#include "mavmission/payload/Payload.h"

#include <doctest/doctest.h>
#include <string.h>

#include <string>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

constexpr uint16_t kCommandAck = 77;
constexpr uint16_t kWinch = 42600, kGripper = 211;

struct Sender {
  uint8_t systemId, componentId;
};
constexpr Sender kStation = {255, 190}, kPilot = {1, 1};

struct Carrier : ClientOnLine {
  Payload payload;
  PayloadAnswer toGive = PayloadAnswer::Accepted;
  std::vector<PayloadCommand> carried;

  explicit Carrier(bool hasFunction = true)
      : ClientOnLine(kArduPilot), payload(client, hasFunction ? carryOut : nullptr, this) {
    pass(3000);
    sent.clear();
  }

  static PayloadAnswer carryOut(void* context, const PayloadCommand& command) {
    Carrier& self = *static_cast<Carrier*>(context);
    self.carried.push_back(command);
    return self.toGive;
  }

  // As loop() does.
  void pass(uint32_t ms) {
    for (; ms != 0; --ms) {
      run(1);
      payload.update();
    }
    run(0);
  }

  void order(uint16_t id, float first, uint8_t confirmation = 0, Sender from = kStation, uint8_t system = 1,
             uint8_t component = 191) {
    mavlink_command_long_t message = mavlink_command_long_t();
    message.param1 = first;
    message.param2 = 2;
    message.param3 = 3;
    message.param4 = 4;
    message.param5 = 5;
    message.param6 = 6;
    message.param7 = 7;
    message.command = id;
    message.target_system = system;
    message.target_component = component;
    message.confirmation = confirmation;
    Bytes bytes(sizeof(message));
    memcpy(bytes.data(), &message, sizeof(message));
    FrameParts parts(76, bytes, 152);
    parts.systemId = from.systemId;
    parts.componentId = from.componentId;
    hear(parts);
    client.update();  // reads the frame; what it has no time for, the next one does
    pass(1);
  }

  // The answers since the last call, each as "command result progress to system/component".
  std::string answers() {
    pass(2);
    std::string text;
    for (const SentFrame& frame : sent) {
      if (frame.messageId != kCommandAck) continue;
      mavlink_command_ack_t message;
      memcpy(&message, frame.payload.data(), sizeof(message));
      if (!text.empty()) text += ", ";
      text += std::to_string(uint16_t{message.command}) + " " + std::to_string(uint8_t{message.result}) + " " +
              std::to_string(uint8_t{message.progress}) + " to " + std::to_string(uint8_t{message.target_system}) +
              "/" + std::to_string(uint8_t{message.target_component});
      CHECK(int32_t{message.result_param2} == 0);
    }
    sent.clear();
    return text;
  }
};

}  // namespace

TEST_CASE("a command to this component is carried out once, with all its fields, and its sender is answered") {
  Carrier carrier;
  carrier.order(kWinch, 1.5f);
  REQUIRE(carrier.carried.size() == 1);
  const PayloadCommand& command = carrier.carried[0];
  CHECK(command.id == kWinch);
  CHECK(command.param[0] == 1.5f);
  for (int i = 1; i < 7; ++i) CHECK(command.param[i] == static_cast<float>(i + 1));
  CHECK(command.systemId == 255);
  CHECK(command.componentId == 190);
  CHECK_FALSE(command.isForAll);
  CHECK(carrier.answers() == "42600 0 0 to 255/190");
  carrier.pass(6000);
  CHECK(carrier.carried.size() == 1);
  CHECK(carrier.answers() == "");
}

TEST_CASE("the function runs in Payload::update(), not while the client reads") {
  Carrier carrier;
  carrier.order(kWinch, 1);
  CHECK(carrier.carried.size() == 1);
  mavlink_command_long_t message = mavlink_command_long_t();
  message.command = kGripper;
  message.target_system = 1;
  message.target_component = 191;
  Bytes bytes(sizeof(message));
  memcpy(bytes.data(), &message, sizeof(message));
  carrier.hear(FrameParts(76, bytes, 152));
  carrier.run(10);
  CHECK(carrier.carried.size() == 1);
  carrier.payload.update();
  CHECK(carrier.carried.size() == 2);
}

TEST_CASE("each answer of the function is the result") {
  for (uint8_t result = 0; result < 5; ++result) {
    Carrier carrier;
    carrier.toGive = static_cast<PayloadAnswer>(result);
    carrier.order(kWinch, 1, 0, kPilot);
    CHECK(carrier.answers() == "42600 " + std::to_string(result) + " 0 to 1/1");
    CHECK_FALSE(carrier.payload.isBusy());
  }
}

TEST_CASE("a command to another component or another system is none of ours") {
  Carrier carrier;
  carrier.order(kWinch, 1, 0, kStation, 1, 192);
  carrier.order(kWinch, 1, 0, kStation, 2, 191);
  CHECK(carrier.carried.empty());
  CHECK(carrier.answers() == "");
}

TEST_CASE("a command to all components is answered unless this payload has no such command") {
  Carrier carrier;
  carrier.order(kWinch, 1, 0, kStation, 1, 0);
  REQUIRE(carrier.carried.size() == 1);
  CHECK(carrier.carried[0].isForAll);
  CHECK(carrier.answers() == "42600 0 0 to 255/190");
  carrier.toGive = PayloadAnswer::Unsupported;
  carrier.order(kWinch, 2, 0, kStation, 1, 0);
  CHECK(carrier.answers() == "");
  carrier.order(kWinch, 2, 0, kStation, 1, 191);
  CHECK(carrier.answers() == "42600 3 0 to 255/190");
  CHECK(carrier.carried.size() == 3);
}

TEST_CASE("without a function no command is supported") {
  Carrier carrier(false);
  carrier.order(kWinch, 1);
  CHECK(carrier.answers() == "42600 3 0 to 255/190");
}

TEST_CASE("a repeat gets the same answer, and is not carried out, up to 5 s behind the answer") {
  Carrier carrier;
  carrier.toGive = PayloadAnswer::Failed;
  carrier.order(kWinch, 1);  // it is answered when the time is what it is now
  const uint32_t answeredMs = carrier.nowMs();
  carrier.toGive = PayloadAnswer::Accepted;
  carrier.pass(2999);
  carrier.sent.clear();
  carrier.order(kWinch, 1, 1);
  CHECK(carrier.answers() == "42600 4 0 to 255/190");
  carrier.pass(answeredMs + 4998 - carrier.nowMs());
  carrier.order(kWinch, 1, 2);
  CHECK(carrier.nowMs() == answeredMs + 4999);
  CHECK(carrier.answers() == "42600 4 0 to 255/190");
  CHECK(carrier.carried.size() == 1);
}

TEST_CASE("5 s behind the answer a repeat is another command, whose first copy was lost") {
  Carrier carrier;
  carrier.toGive = PayloadAnswer::Failed;
  carrier.order(kWinch, 1);
  const uint32_t answeredMs = carrier.nowMs();
  carrier.toGive = PayloadAnswer::Accepted;
  carrier.pass(5000);
  CHECK(carrier.nowMs() == answeredMs + 5000);
  carrier.sent.clear();
  carrier.order(kWinch, 1, 1);
  CHECK(carrier.answers() == "42600 0 0 to 255/190");
  CHECK(carrier.carried.size() == 2);
}

TEST_CASE("a command is another one by its number, its parameters, its sender, or as no repeat") {
  Carrier carrier;
  carrier.order(kWinch, 1);
  CHECK(carrier.carried.size() == 1);
  carrier.order(kGripper, 1, 1);
  CHECK(carrier.carried.size() == 2);
  carrier.order(kWinch, 1.25f, 1);
  CHECK(carrier.carried.size() == 3);
  Carrier others;
  others.order(kWinch, 1);
  others.order(kWinch, 1, 1, {254, 190});
  CHECK(others.carried.size() == 2);
  others.order(kWinch, 1, 1, {255, 191});
  CHECK(others.carried.size() == 3);
  others.order(kWinch, 1, 0);
  CHECK(others.carried.size() == 4);
  others.order(kWinch, 1, 1);
  CHECK(others.carried.size() == 4);
}

TEST_CASE("a command in progress tells how far it is once a second, and how it has ended") {
  Carrier carrier;
  carrier.toGive = PayloadAnswer::InProgress;
  carrier.order(kWinch, 1);
  const uint32_t toldMs = carrier.nowMs() + 1;
  CHECK(carrier.payload.isBusy());
  CHECK(carrier.answers() == "42600 5 0 to 255/190");
  carrier.payload.progress(40);
  carrier.pass(3100);
  const std::vector<uint32_t> times = carrier.timesOf(kCommandAck, toldMs);
  REQUIRE(times.size() == 3);
  CHECK(times[0] == 1000);
  CHECK(times[1] == 2000);
  CHECK(times[2] == 3000);
  CHECK(carrier.answers() == "42600 5 40 to 255/190, 42600 5 40 to 255/190, 42600 5 40 to 255/190");
  carrier.order(kWinch, 1, 1);  // a repeat
  CHECK(carrier.answers() == "42600 5 40 to 255/190");
  carrier.payload.finish(PayloadAnswer::InProgress);
  CHECK(carrier.payload.isBusy());
  carrier.payload.finish(PayloadAnswer::Failed);
  CHECK_FALSE(carrier.payload.isBusy());
  CHECK(carrier.answers() == "42600 4 0 to 255/190");
  carrier.payload.finish(PayloadAnswer::Accepted);
  CHECK(carrier.answers() == "");
  CHECK(carrier.carried.size() == 1);
  carrier.order(kWinch, 1);
  CHECK(carrier.answers() == "42600 5 0 to 255/190");  // it begins at 0 again
}

TEST_CASE("a repeat behind a long command still gets its end, and only for 5 s from then on") {
  Carrier carrier;
  carrier.toGive = PayloadAnswer::InProgress;
  carrier.order(kWinch, 1);
  carrier.pass(7500);
  carrier.payload.finish(PayloadAnswer::Accepted);
  const uint32_t finishedMs = carrier.nowMs();
  carrier.pass(4998);
  carrier.sent.clear();
  carrier.order(kWinch, 1, 3);
  CHECK(carrier.nowMs() == finishedMs + 4999);
  CHECK(carrier.answers() == "42600 0 0 to 255/190");
  CHECK(carrier.carried.size() == 1);
}

TEST_CASE("while a command is in progress another one may be carried out, but not be in progress too") {
  Carrier carrier;
  carrier.toGive = PayloadAnswer::InProgress;
  carrier.order(kWinch, 1);
  CHECK(carrier.answers() == "42600 5 0 to 255/190");
  carrier.payload.progress(30);
  carrier.order(kGripper, 1);
  CHECK(carrier.answers() == "211 1 0 to 255/190");
  carrier.toGive = PayloadAnswer::Accepted;
  carrier.order(kGripper, 2);
  CHECK(carrier.answers() == "211 0 0 to 255/190");
  CHECK(carrier.payload.isBusy());
  carrier.pass(1000);
  CHECK(carrier.answers() == "42600 5 30 to 255/190");
}

TEST_CASE("four commands may be repeated; the fifth takes the place of the one that was answered first") {
  Carrier carrier;
  for (int i = 0; i < 4; ++i) {
    carrier.order(kWinch, static_cast<float>(i));
    carrier.pass(10);
  }
  for (int i = 0; i < 4; ++i) carrier.order(kWinch, static_cast<float>(i), 1);
  CHECK(carrier.carried.size() == 4);
  carrier.order(kWinch, 4);
  CHECK(carrier.carried.size() == 5);
  for (int i = 1; i < 5; ++i) carrier.order(kWinch, static_cast<float>(i), 1);
  CHECK(carrier.carried.size() == 5);
  carrier.order(kWinch, 0, 1);  // it is forgotten
  CHECK(carrier.carried.size() == 6);
  carrier.order(kWinch, 2, 1);  // and took the place of the next one
  CHECK(carrier.carried.size() == 6);
  carrier.order(kWinch, 1, 1);
  CHECK(carrier.carried.size() == 7);
}

TEST_CASE("the one in progress keeps its place") {
  Carrier carrier;
  carrier.toGive = PayloadAnswer::InProgress;
  carrier.order(kWinch, 100);
  carrier.toGive = PayloadAnswer::Accepted;
  for (int i = 0; i < 8; ++i) {
    carrier.pass(10);
    carrier.order(kWinch, static_cast<float>(i));
  }
  CHECK(carrier.payload.isBusy());
  CHECK(carrier.carried.size() == 9);
  carrier.answers();
  carrier.payload.finish(PayloadAnswer::Denied);
  CHECK(carrier.answers() == "42600 2 0 to 255/190");
}

TEST_CASE("an empty place is taken before one whose command may be repeated") {
  Carrier carrier;
  carrier.order(kWinch, 0);
  carrier.pass(4000);
  carrier.order(kWinch, 1);
  carrier.order(kWinch, 2);
  carrier.order(kWinch, 3);
  carrier.pass(1200);  // the first is forgotten, and it alone
  carrier.order(kWinch, 4);
  CHECK(carrier.carried.size() == 5);
  for (int i = 1; i < 5; ++i) carrier.order(kWinch, static_cast<float>(i), 1);
  CHECK(carrier.carried.size() == 5);
}

TEST_CASE("an answer that cannot leave yet is not lost, and its command is not forgotten") {
  Carrier carrier;
  carrier.line.room = 0;
  mavlink_command_ack_t other = mavlink_command_ack_t();
  const OutgoingMessage message = {77, 143, sizeof(other), 3, &other};
  REQUIRE(carrier.client.sendMessage(message));
  for (int i = 0; i < 4; ++i) carrier.order(kWinch, static_cast<float>(i));
  CHECK(carrier.carried.size() == 4);
  carrier.order(kWinch, 4);  // finds no place, and no answer
  CHECK(carrier.carried.size() == 4);
  carrier.pass(6000);
  CHECK(carrier.answers() == "");
  carrier.line.room = MemoryStream::kAlwaysRoom;
  carrier.pass(20);
  CHECK(carrier.answers() ==
        "0 0 0 to 0/0, 42600 0 0 to 255/190, 42600 0 0 to 255/190, 42600 0 0 to 255/190, 42600 0 0 to 255/190");
  carrier.order(kWinch, 0, 1);  // now it is forgotten
  CHECK(carrier.carried.size() == 5);
}

TEST_CASE("a command that comes while another one waits for update() is left to its sender to repeat") {
  Carrier carrier;
  mavlink_command_long_t message = mavlink_command_long_t();
  message.target_system = 1;
  message.target_component = 191;
  for (uint16_t id : {kWinch, kGripper}) {
    message.command = id;
    Bytes bytes(sizeof(message));
    memcpy(bytes.data(), &message, sizeof(message));
    carrier.hear(FrameParts(76, bytes, 152));
  }
  carrier.run(5);
  carrier.pass(5);
  REQUIRE(carrier.carried.size() == 1);
  CHECK(carrier.carried[0].id == kWinch);
}

TEST_CASE("a command with coordinates is ignored") {
  Carrier carrier;
  mavlink_command_int_t message = mavlink_command_int_t();
  message.command = kWinch;
  message.target_system = 1;
  message.target_component = 191;
  Bytes bytes(sizeof(message));
  memcpy(bytes.data(), &message, sizeof(message));
  carrier.hear(FrameParts(75, bytes, 158));
  carrier.pass(5);
  CHECK(carrier.carried.empty());
  CHECK(carrier.answers() == "");
}
