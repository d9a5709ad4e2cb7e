// Reads .waypoints texts from standard input through WaypointsSource, and says what it makes of them; for
// test_waypoints.py. Numbers are little-endian.
//
//   in:   length (4), text; number of items to be asked for again (4), their indices (2 each)
//   out:  state (1), error (1), line (2), field (1), type (1), items (2), the most bytes read for one item asked for
//   again (4), each
//         item of the plan in order and then each that was asked for again: 1 if it was given (1), param1 to param4, x,
//         y, z (28), command (2), frame (1), current (1), autocontinue (1)
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
  size_t bytesRead = 0;

  bool seek(uint32_t to) {
    position = to;
    return to <= text.size();
  }
  int available() override { return static_cast<int>(text.size() - position); }
  int peek() override { return position < text.size() ? static_cast<uint8_t>(text[position]) : -1; }
  int read() override {
    const int byte = peek();
    if (byte >= 0) {
      ++position;
      ++bytesRead;
    }
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
    uint32_t again = 0;
    if (!take(file.text.data(), length) || !take(&again, sizeof(again))) return 1;
    std::vector<uint16_t> indices(again);
    if (!take(indices.data(), again * sizeof(uint16_t))) return 1;

    WaypointsSource source(file);
    for (;;) {
      const size_t before = file.bytesRead;
      if (source.update() != WaypointsSource::State::Reading) break;
      if (file.bytesRead - before > WaypointsSource::kBytesPerUpdate) return 2;
    }
    put(source.state());
    put(source.error());
    put(source.errorLine());
    put(source.errorField());
    put(source.type());
    put(source.count());
    const ItemSource plan = source.source();
    // In order first, then as asked for; the bytes of the latter are known only then, and go out before.
    uint32_t most = 0;
    for (uint16_t index : indices) {
      MissionItem item;
      const size_t before = file.bytesRead;
      plan.read(plan.context, index, item);
      if (file.bytesRead - before > most) most = static_cast<uint32_t>(file.bytesRead - before);
    }
    put(most);
    for (uint16_t index = 0; index < source.count(); ++index) putItem(plan, index);
    for (uint16_t index : indices) putItem(plan, index);
    fflush(stdout);
  }
  return 0;
}
