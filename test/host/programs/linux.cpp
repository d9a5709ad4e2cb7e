// A program for Linux without Arduino: a client on a file descriptor, which may be a serial port that is open already.
// Sends heartbeats once one has been heard, for as many milliseconds as the first argument says.
#include <Arduino.h>
#include <MavMission.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace {

class FileStream : public Stream {
 public:
  FileStream(int in, int out) : in_(in), out_(out) {}
  int available() override {
    int bytes = 0;
    return ioctl(in_, FIONREAD, &bytes) == 0 ? bytes : 0;
  }
  int read() override {
    uint8_t byte;
    return ::read(in_, &byte, 1) == 1 ? byte : -1;
  }
  int peek() override { return -1; }  // the library never peeks
  int availableForWrite() override { return 64; }
  size_t write(uint8_t byte) override { return ::write(out_, &byte, 1) == 1 ? 1 : 0; }
  using Print::write;

 private:
  int in_, out_;
};

}  // namespace

int main(int, char** arguments) {
  FileStream port(0, 1);
  mavmission::MissionClient client(port);
  const uint32_t limitMs = static_cast<uint32_t>(atol(arguments[1]));
  for (uint32_t nowMs = 1; nowMs <= limitMs; ++nowMs) {
    setMillis(nowMs);
    client.update();
  }
  return client.hasAutopilot() ? 0 : 1;
}
