// A sketch that says `using namespace mavmission` and has names of its own that the library uses inside.
#include <MavMission.h>
using namespace mavmission;

struct Link {};
struct Listener {};
struct Heartbeat {};
struct Command {};
struct Sender {};
struct Request {};
struct Client {};
struct Outbox {};
struct Signing {};
struct FrameParser {};
struct Keeper {};
struct PlanConsole {};
enum class State { Off, On };
int checksum(const char* text) { return text[0]; }

Link link;
Listener listener;
Heartbeat heartbeat;
Command command;
Sender sender;
Request request;
Client client;
Outbox outbox;
Signing signing;
FrameParser parser;
Keeper keeper;
PlanConsole console;
State state = State::On;
extern Stream& port;
MissionClient autopilot(port);

int all() {
  autopilot.update();
  return checksum("a") + static_cast<int>(state);
}
