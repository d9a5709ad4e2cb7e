// A stream between two queues of bytes, with as much room to write as the test says.
#pragma once

#include <Arduino.h>

#include <deque>
#include <vector>

class MemoryStream : public Stream {
 public:
  static constexpr int kAlwaysRoom = 1000000;

  std::deque<uint8_t> toRead;
  std::vector<uint8_t> written;
  int room = kAlwaysRoom;  // what availableForWrite() says
  size_t takes = 1000000;  // what one write() takes, at most
  size_t bytesRead = 0;
  size_t writes = 0;        // calls of write()
  size_t largestWrite = 0;  // bytes offered in one call

  void bring(const std::vector<uint8_t>& bytes) { toRead.insert(toRead.end(), bytes.begin(), bytes.end()); }

  std::vector<uint8_t> takeWritten() {
    std::vector<uint8_t> bytes;
    bytes.swap(written);
    return bytes;
  }

  int available() override { return static_cast<int>(toRead.size()); }
  int peek() override { return toRead.empty() ? -1 : toRead.front(); }
  int read() override {
    if (toRead.empty()) return -1;
    const uint8_t byte = toRead.front();
    toRead.pop_front();
    ++bytesRead;
    return byte;
  }

  int availableForWrite() override { return room; }
  size_t write(uint8_t byte) override { return write(&byte, 1); }
  size_t write(const uint8_t* bytes, size_t size) override {
    ++writes;
    if (size > largestWrite) largestWrite = size;
    const size_t taken = size < takes ? size : takes;
    written.insert(written.end(), bytes, bytes + taken);
    return taken;
  }
};
