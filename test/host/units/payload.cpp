// Payload by a whole client: which commands are carried out, how often, and what is answered to whom.
#include "mavmission/payload/Payload.h"

#include <doctest/doctest.h>
#include <string>

#include "Script.h"
#include "ToldClient.h"

using namespace mavmission;

namespace {

constexpr uint16_t kCommandAck = 77;
constexpr uint16_t kWinch = 42600, kGripper = 211;
const char* const kResults[] = {"accepted", "rejected", "denied", "unsupported", "failed", "in progress"};

struct Address {
  uint8_t systemId, componentId;
};
constexpr Address kStation = {255, 190}, kPilot = {1, 1}, kUs = {1, 191};

struct Carrier : ToldClient {
  Payload payload;
  std::vector<PayloadCommand> carried;

  explicit Carrier(bool hasFunction = true)
      : ToldClient(kArduPilot), payload(client, hasFunction ? carryOut : nullptr, this) {
    plays("wait 3000");
  }

  // What is carried out, "winch 1", and what is answered, "accepted", "in progress 40", "failed to 1/1" if not to the
  // station; each after the milliseconds since the one before. When this happens:
  // winch N, gripper N: the station orders that, with this first parameter; again: for the second time
  // wait N: N ms pass, as in loop()
  // gives X: what the function returns from now on; progress N, finish X: the sketch says so
  std::string plays(const std::string& script) {
    said_ = Transcript();
    spokeMs_ = nowMs();
    for (const Event& event : eventsOf(script)) {
      const size_t blank = event.what.find(' ');
      const std::string object = blank == std::string::npos ? "" : event.what.substr(blank + 1);
      const auto is = [&](const char* verb) { return event.known(event.first() == verb); };
      if (is("winch")) order(kWinch, static_cast<float>(event.number), object == "again");
      if (is("gripper")) order(kGripper, static_cast<float>(event.number), object == "again");
      if (is("gives")) toGive_ = answerOf(object);
      if (is("progress")) payload.progress(static_cast<uint8_t>(event.number));
      if (is("finish")) payload.finish(answerOf(object));
      pass(is("wait") ? event.number : is("finish") ? 2 : 0);
    }
    return said_.text();
  }
  std::string orders(uint16_t id, float first, bool again, Address from, Address to = kUs) {
    said_ = Transcript();
    spokeMs_ = nowMs();
    order(id, first, again, from, to);
    return said_.text();
  }

 private:
  PayloadAnswer toGive_ = PayloadAnswer::Accepted;
  Transcript said_;
  uint32_t spokeMs_ = 0;

  static PayloadAnswer answerOf(const std::string& word) {
    uint8_t result = 0;
    while (word != kResults[result]) REQUIRE(++result < 6);
    return static_cast<PayloadAnswer>(result);
  }
  static PayloadAnswer carryOut(void* context, const PayloadCommand& command) {
    Carrier& self = *static_cast<Carrier*>(context);
    self.carried.push_back(command);
    const std::string what = command.id == kWinch ? "winch " : "gripper ";
    self.said_.note(what + std::to_string(static_cast<int>(command.param[0])), self.sinceSpoken());
    return self.toGive_;
  }
  uint32_t sinceSpoken() {
    const uint32_t ms = nowMs() - spokeMs_;
    spokeMs_ = nowMs();
    return ms < 10 ? 0 : ms;
  }
  // As loop() does.
  void pass(uint32_t ms) {
    for (uint32_t passed = 0; passed <= ms; ++passed) {
      run(passed == ms ? 0 : 1);
      payload.update();
      for (const SentFrame& frame : sent) note(frame);
      sent.clear();
    }
  }
  void note(const SentFrame& frame) {
    if (frame.messageId != kCommandAck) return;
    const auto message = messageIn<mavlink_command_ack_t>(frame.payload);
    CHECK(int32_t{message.result_param2} == 0);
    CHECK((message.command == kWinch || message.command == kGripper || message.command == 0));
    std::string text = message.command == kGripper ? "gripper " : "";
    text += message.command == 0 ? "another" : kResults[message.result];
    if (message.progress != 0) text += " " + std::to_string(uint8_t{message.progress});
    const std::string to =
        std::to_string(uint8_t{message.target_system}) + "/" + std::to_string(uint8_t{message.target_component});
    said_.note(to == "255/190" ? text : text + " to " + to, sinceSpoken());
  }
  void order(uint16_t id, float first, bool again, Address from = kStation, Address to = kUs) {
    FrameParts parts = messageParts("COMMAND_LONG param2 2 param3 3 param4 4 param5 5 param6 6 param7 7 param1 " +
                                    std::to_string(first) + " command " + std::to_string(id) + " confirmation " +
                                    (again ? "1" : "0") + " target_system " + std::to_string(to.systemId) +
                                    " target_component " + std::to_string(to.componentId));
    parts.systemId = from.systemId;
    parts.componentId = from.componentId;
    hear(parts);
    client.update();  // reads the frame; what it has no time for, the next one does
    pass(2);
  }
};

}  // namespace

TEST_CASE("a command to this component is carried out once, with all its fields, and its sender is answered") {
  Carrier carrier;
  CHECK(carrier.orders(kWinch, 1.5f, false, kStation) == "winch 1, accepted");
  REQUIRE(carrier.carried.size() == 1);
  const PayloadCommand& command = carrier.carried[0];
  CHECK(command.id == kWinch);
  CHECK(command.param[0] == 1.5f);
  for (int i = 1; i < 7; ++i) CHECK(command.param[i] == static_cast<float>(i + 1));
  CHECK(command.systemId == 255);
  CHECK(command.componentId == 190);
  CHECK_FALSE(command.isForAll);
  CHECK(carrier.plays("wait 6000") == "");
}

TEST_CASE("the function runs in Payload::update(), not while the client reads, and then for the first command alone") {
  Carrier carrier;
  carrier.hear(messageParts("COMMAND_LONG command 42600 target_system 1 target_component 191"));
  carrier.hear(messageParts("COMMAND_LONG command 211 target_system 1 target_component 191"));
  carrier.run(10);
  CHECK(carrier.carried.empty());
  CHECK(carrier.plays("wait 5") == "winch 0, accepted to 1/1");  // the other one is left to its sender to repeat
}

TEST_CASE("each answer of the function is the result") {
  for (uint8_t result = 0; result < 5; ++result) {
    Carrier carrier;
    carrier.plays(std::string("gives ") + kResults[result]);
    CHECK(carrier.orders(kWinch, 1, false, kPilot) == std::string("winch 1, ") + kResults[result] + " to 1/1");
    CHECK_FALSE(carrier.payload.isBusy());
  }
}

TEST_CASE("a command to another component or another system is none of ours") {
  Carrier carrier;
  CHECK(carrier.orders(kWinch, 1, false, kStation, {1, 192}) == "");
  CHECK(carrier.orders(kWinch, 1, false, kStation, {2, 191}) == "");
}

TEST_CASE("a command to all components is answered unless this payload has no such command") {
  Carrier carrier;
  CHECK(carrier.orders(kWinch, 1, false, kStation, {1, 0}) == "winch 1, accepted");
  CHECK(carrier.carried[0].isForAll);
  carrier.plays("gives unsupported");
  CHECK(carrier.orders(kWinch, 2, false, kStation, {1, 0}) == "winch 2");
  CHECK(carrier.orders(kWinch, 2, false, kStation) == "winch 2, unsupported");
  CHECK(Carrier(false).plays("winch 1") == "unsupported");  // without a function there is none
}

TEST_CASE("a repeat gets the same answer, and is not carried out, up to 5 s after the answer") {
  Carrier carrier;
  CHECK(carrier.plays(
            "wait 500, gives failed, winch 1, gives accepted, wait 2999, winch again 1, wait 1996, winch again 1") ==
        "501 winch 1, failed, 3001 failed, 1998 failed");
  // Then a repeat is another command, whose first copy was lost.
  Carrier late;
  CHECK(late.plays("wait 500, gives failed, winch 1, gives accepted, wait 4999, winch again 1") ==
        "501 winch 1, failed, 5000 winch 1, accepted");
}

TEST_CASE("a command is another one by its number, its parameters, its sender, or as no repeat") {
  Carrier carrier;
  CHECK(carrier.plays("winch 1, gripper again 1, winch again 2") ==
        "winch 1, accepted, gripper 1, gripper accepted, winch 2, accepted");
  Carrier others;
  CHECK(others.plays("winch 1") == "winch 1, accepted");
  CHECK(others.orders(kWinch, 1.25f, true, kStation) == "winch 1, accepted");
  CHECK(others.orders(kWinch, 1, true, {254, 190}) == "winch 1, accepted to 254/190");
  CHECK(others.orders(kWinch, 1, true, {255, 191}) == "winch 1, accepted to 255/191");
  CHECK(others.plays("winch 1, winch again 1") == "winch 1, accepted (2 times)");
}

TEST_CASE("a command in progress tells how far it is once a second, and how it has ended") {
  Carrier carrier;
  CHECK(carrier.plays("gives in progress, winch 1") == "winch 1, in progress");
  CHECK(carrier.payload.isBusy());
  CHECK(carrier.plays("progress 40, wait 3100") == "1000 in progress 40 (3 times)");
  CHECK(carrier.plays("winch again 1") == "in progress 40");
  CHECK(carrier.plays("finish in progress") == "");
  CHECK(carrier.payload.isBusy());
  CHECK(carrier.plays("finish failed") == "failed");
  CHECK_FALSE(carrier.payload.isBusy());
  CHECK(carrier.plays("finish accepted") == "");
  CHECK(carrier.plays("winch 1") == "winch 1, in progress");  // it begins at 0 again
}

TEST_CASE("a repeat after a long command still gets its end, and only for 5 s from then on") {
  Carrier carrier;
  carrier.plays("gives in progress, winch 1, wait 7500, finish accepted");
  const uint32_t finishedMs = carrier.nowMs();
  CHECK(carrier.plays("wait 4990, winch again 1") == "4992 accepted");
  carrier.plays("wait " + std::to_string(finishedMs + 5000 - carrier.nowMs()));
  CHECK(carrier.plays("winch again 1") == "winch 1, in progress");
}

TEST_CASE("while a command is in progress another one may be carried out, but not be in progress too") {
  Carrier carrier;
  carrier.plays("gives in progress, winch 1, progress 30");
  CHECK(carrier.plays("gripper 1") == "gripper 1, gripper rejected");
  CHECK(carrier.plays("gives accepted, gripper 2") == "gripper 2, gripper accepted");
  CHECK(carrier.payload.isBusy());
  CHECK(carrier.plays("wait 1000") == "996 in progress 30");
}

TEST_CASE("four commands may be repeated; the fifth takes the place of the one that was answered first") {
  Carrier carrier;
  carrier.plays("winch 0, wait 10, winch 1, wait 10, winch 2, wait 10, winch 3, wait 10");
  CHECK(carrier.plays("winch again 0 to 3") == "accepted (4 times)");
  CHECK(carrier.plays("winch 4, winch again 1 to 4") == "winch 4, accepted (5 times)");
  CHECK(carrier.plays("winch again 0") == "winch 0, accepted");  // it is forgotten
  CHECK(carrier.plays("winch again 2") == "accepted");           // and took the place of the next one
  CHECK(carrier.plays("winch again 1") == "winch 1, accepted");
}

TEST_CASE("the one in progress keeps its place") {
  Carrier carrier;
  carrier.plays("gives in progress, winch 100, gives accepted, " + times(8, "wait 10, winch 7"));
  CHECK(carrier.carried.size() == 9);
  CHECK(carrier.payload.isBusy());
  CHECK(carrier.plays("finish denied") == "denied");
}

TEST_CASE("an empty place is taken before one whose command may be repeated") {
  Carrier carrier;
  carrier.plays("winch 0, wait 4000, winch 1 to 3");
  // The first is forgotten, and it alone.
  CHECK(carrier.plays("wait 1200, winch 4") == "1201 winch 4, accepted");
  CHECK(carrier.plays("winch again 1 to 4") == "accepted (4 times)");
}

TEST_CASE("an answer that cannot leave yet is not lost, and its command is not forgotten") {
  Carrier carrier;
  carrier.line.room = 0;
  mavlink_command_ack_t other = mavlink_command_ack_t();
  const OutgoingMessage message = {77, 143, sizeof(other), 3, &other};
  REQUIRE(carrier.client.sendMessage(message));
  // The fifth finds no place, and no answer.
  CHECK(carrier.plays("winch 0 to 4, wait 6000") == "winch 0, winch 1, winch 2, winch 3");
  carrier.line.room = MemoryStream::kAlwaysRoom;
  CHECK(carrier.plays("wait 20") == "another to 0/0, accepted (4 times)");
  CHECK(carrier.plays("winch again 0") == "winch 0, accepted");  // now it is forgotten
}

TEST_CASE("a command with coordinates is ignored") {
  Carrier carrier;
  carrier.hear(messageParts("COMMAND_INT command 42600 target_system 1 target_component 191"));
  CHECK(carrier.plays("wait 5") == "");
}
