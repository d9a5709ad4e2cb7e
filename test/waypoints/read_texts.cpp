// Reads .waypoints texts from standard input through WaypointsSource, and says what it makes of them; for
// support/waypoints_reader.py. Numbers are little-endian.
//
//   in:   length (4), text
//   out:  state (1), error (1), line (2), field (1), type (1), items (2), each item of the plan: 1 if it was given (1),
//         param1 to param4, x, y, z (28), command (2), frame (1), current (1), autocontinue (1)
#include <Arduino.h>
#include <MavMission.h>
#include <stdio.h>

#include <vector>

using namespace mavmission;

namespace {

class TextFile : public Stream {
 public:
  std::vector<char> text;
  size_t position = 0;

  bool seek(uint32_t to) {
    position = to;
    return to <= text.size();
  }
  int available() override { return static_cast<int>(text.size() - position); }
  int peek() override { return position < text.size() ? static_cast<uint8_t>(text[position]) : -1; }
  int read() override {
    const int byte = peek();
    if (byte >= 0) ++position;
    return byte;
  }
  size_t write(uint8_t) override { return 0; }
};

bool take(void* to, size_t size) { return fread(to, 1, size, stdin) == size; }
void put(const void* from, size_t size) { fwrite(from, 1, size, stdout); }
template <typename T>
void put(T value) {
  put(&value, sizeof(value));
}

void putItem(const ItemSource& plan, uint16_t index) {
  MissionItem item = MissionItem();
  put<uint8_t>(plan.read(plan.context, index, item));
  put(&item, kPlaceBytes);
  put(item.command);
  put(item.frame);
  put(item.current);
  put(item.autocontinue);
}

}  // namespace

int main() {
  uint32_t length;
  while (take(&length, sizeof(length))) {
    TextFile file;
    file.text.resize(length);
    if (!take(file.text.data(), length)) return 1;
    WaypointsSource source(file);
    while (source.update() == WaypointsSource::State::Reading) {
    }
    put(source.state());
    put(source.error());
    put(source.errorLine());
    put(source.errorField());
    put(source.type());
    put(source.count());
    const ItemSource plan = source.source();
    for (uint16_t index = 0; index < source.count(); ++index) putItem(plan, index);
    fflush(stdout);
  }
  return 0;
}
