// A plan from a .waypoints file (WaypointsText.h) in any stream that can seek, such as a File of the SD library: it
// takes the same RAM for 3 items and for 3,000, since each is read when the autopilot requests it.
//
//   File file;
//   WaypointsSource plan(file);
//   ...
//   file = SD.open("PLAN.TXT");
//   plan.begin();
//   ...
//   switch (plan.update()) {                               // in loop()
//     case WaypointsSource::State::Good: autopilot.upload(plan.source(), plan.type()); ...
#pragma once

#include <Arduino.h>
#include <stdint.h>

#include "../plan/ItemSource.h"
#include "WaypointsText.h"

namespace mavmission {

// Seeks a position in the text [bytes from its beginning]; false if that cannot be done.
typedef bool (*SeekFunction)(void* context, uint32_t position);

// A plan read from a text, item by item.
class WaypointsSource {
 public:
  // Reading: the text has not been read to its end yet. Good: source() may be uploaded. Bad: error() says why not.
  enum class State : uint8_t { Reading, Good, Bad };

  // How much one update() reads at most [bytes]; it also stops after one field.
  static constexpr uint8_t kBytesPerUpdate = 64;

  // A stream with seek(position), such as SD's File. It must live as long as the source, and nobody else may read or
  // seek it.
  template <typename File>
  explicit WaypointsSource(File& file) : WaypointsSource(file, seekIn<File>, &file) {}
  // Any other stream. It ends where read() returns -1.
  WaypointsSource(Stream& stream, SeekFunction seek, void* context);

  // Begins to read from the beginning: to be called when the file has been opened, or has changed. Do not call it
  // during an upload.
  void begin();

  // Reads one more field, until the whole text has been read once: the items are counted and checked before any of them
  // is used. Then the state is Good or Bad, until begin().
  State update();
  State state() const { return state_; }

  // The plan, when the state is Good; otherwise an upload of the source is refused (Status::SourceRefused). If items
  // are read in order, as transfers do, one line is read for each item. To find an item out of order, a binary search
  // is made, with one seek in each step.
  ItemSource source();
  // The number of items, without home.
  uint16_t count() const { return state_ == State::Good ? count_ : 0; }
  // The kind of plan, for upload(): a mission, a fence or rally points. Known when the state is Good.
  PlanType type() const { return text_.type(); }

  // Why the state is Bad, or why an item could not be read again when it was requested; toString(error()) says it in
  // words. Lines count from 1 (0: not known), fields from 1 to 12 (0: the line as a whole).
  TextError error() const { return text_.error(); }
  uint16_t errorLine() const { return text_.errorLine(); }
  uint8_t errorField() const { return text_.errorField(); }

 private:
  template <typename File>
  static bool seekIn(void* file, uint32_t position) {
    return static_cast<File*>(file)->seek(position);
  }

  // The position of a line, and the number with which it begins.
  struct Mark {
    uint32_t position;
    uint16_t number;
  };

  static bool readItem(void* source, uint16_t index, MissionItem& item);
  bool find(uint16_t number);
  bool goTo(uint32_t position);
  int next();
  bool readMark(Mark& mark);
  detail::WaypointsText::Step readLine();

  Stream& stream_;
  SeekFunction seek_;
  void* context_;
  detail::WaypointsText text_;
  uint32_t position_;   // of the next byte
  uint32_t lineStart_;  // of the line being read, or read last
  uint32_t size_;       // of the text, once it is known
  Mark first_;          // the first item
  Mark last_;           // the item that was read last; number 0: none, or not known
  uint16_t count_;
  State state_;
  bool isBegun_;  // the first update() has been
};

}  // namespace mavmission
