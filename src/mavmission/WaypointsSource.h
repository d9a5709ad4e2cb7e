// A plan from a .waypoints file (WaypointsText.h) in anything that can be read and sought, such as a File of the SD
// library: the same RAM for 3 items and for 3,000, since each is read when the autopilot asks for it.
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

#include <stdint.h>

#include "ItemSource.h"
#include "text/WaypointsText.h"

class Stream;

namespace mavmission {

// Goes to a place in the text [bytes from its beginning]; false if that cannot be done.
typedef bool (*SeekFunction)(void* context, uint32_t position);

// A plan read from a text, item by item.
class WaypointsSource {
 public:
  // Reading: not read through yet. Good: source() may be uploaded. Bad: error() says why not.
  enum class State : uint8_t { Reading, Good, Bad };

  // The most that one update() reads [bytes]; it reads no further than one field.
  static constexpr uint8_t kBytesPerUpdate = 64;

  // A stream that has seek(position), as SD's File has. It must stay, and nobody else may read or seek it.
  template <typename File>
  explicit WaypointsSource(File& file) : WaypointsSource(file, seekIn<File>, &file) {}
  // Any other stream. It ends where read() gives -1.
  WaypointsSource(Stream& stream, SeekFunction seek, void* context);

  // Begins to read from the beginning: when the file has been opened, or has changed. Not while it is being uploaded.
  void begin();

  // Reads a field more, until the whole text has been read once: it is counted and checked before anything of it is
  // used. Then Good or Bad, until begin().
  State update();
  State state() const { return state_; }

  // The plan, when it is Good; before that, and when it is Bad, one that is refused (Status::SourceRefused). To find an
  // item out of order a text is halved again and again, by a seek each time. In order, which is how transfers ask, an
  // item costs its line.
  ItemSource source();
  // Its items: home is none.
  uint16_t count() const { return state_ == State::Good ? count_ : 0; }
  // What they are, for upload(): all of a mission, all of a fence, or all rally points. When it is Good.
  PlanType type() const { return text_.type(); }

  // Why it is Bad, or why an item could not be read again when it was asked for: toString(error()) has it in words. The
  // line counts from 1, 0: not known. The field counts from 1 to 12, 0: the line as a whole.
  TextError error() const { return text_.error(); }
  uint16_t errorLine() const { return text_.errorLine(); }
  uint8_t errorField() const { return text_.errorField(); }

 private:
  template <typename File>
  static bool seekIn(void* file, uint32_t position) {
    return static_cast<File*>(file)->seek(position);
  }

  // A line, and the number that it begins with.
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
  uint32_t lineStart_;  // of the line that is being read, or was read last
  uint32_t size_;       // of the text, once it is known
  Mark first_;          // the first item
  Mark last_;           // the item that was given last; number 0: none, or not known
  uint16_t count_;
  State state_;
  bool isBegun_;  // the first update() has been
};

}  // namespace mavmission
