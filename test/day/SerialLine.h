// The client's line: bytes both ways. In hexadecimal, "-" for none.
#pragma once

#include <Arduino.h>

#include <algorithm>

#include "Words.h"

constexpr size_t kLine = 4096;

// Takes and gives bytes without allocating.
class FixedStream : public Stream {
 public:
  uint8_t toRead[kLine], written[kLine];
  size_t readAt = 0, readEnd = 0, writtenEnd = 0;

  int available() override { return static_cast<int>(readEnd - readAt); }
  int peek() override { return readAt == readEnd ? -1 : toRead[readAt]; }
  int read() override { return readAt == readEnd ? -1 : toRead[readAt++]; }
  int availableForWrite() override { return static_cast<int>(kLine - writtenEnd); }
  size_t write(uint8_t byte) override { return write(&byte, 1); }
  size_t write(const uint8_t* bytes, size_t size) override {
    const size_t taken = std::min(size, kLine - writtenEnd);
    memcpy(written + writtenEnd, bytes, taken);
    writtenEnd += taken;
    return taken;
  }
};

class Line {
 public:
  FixedStream stream;

  // What has come, as the words of a line say it; false if it is too much.
  bool bring(Words& words) {
    const Bytes bytes = words.bytes();
    if (stream.readAt == stream.readEnd) stream.readAt = stream.readEnd = 0;
    if (stream.readEnd + bytes.size() > kLine) return false;
    memcpy(stream.toRead + stream.readEnd, bytes.data(), bytes.size());
    stream.readEnd += bytes.size();
    return true;
  }
  bool hasLeft() const { return stream.writtenEnd != 0; }
  void sayWhatLeft() {
    say(stream.written, stream.writtenEnd);
    stream.writtenEnd = 0;
  }
};
