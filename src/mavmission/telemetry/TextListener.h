// The autopilot's texts (STATUSTEXT), whole: those that come in pieces of 50 characters are put together.
#pragma once

#include "../service/Listener.h"
#include "../service/MissionFollower.h"

namespace mavmission {

// Receives the texts of the client's autopilot, which sends them without a request. PX4 sends them only to a port on
// which it hears a ground station's heartbeats; ours are an onboard computer's (docs/autopilots.md).
//
//   void print(void*, uint8_t severity, const char* text) { Serial.println(text); }
//   TextListener texts(autopilot);
//   ...
//   texts.onText(print);
//
// A MissionFollower gives the same texts as they come, a long one in pieces; it needs no RAM for them.
class TextListener : public detail::Listener {
 public:
  // Must live as long as the client: declare it next to the client, not in a function.
  explicit TextListener(MissionClient& client);

  // The longest text [characters]; the end of a longer one is left out. (PX4's longest has 127.)
  static constexpr uint8_t kLongest = 150;

  // Called from update() with each text. `text` ends with a zero, has at most kLongest characters, and is valid during
  // the call. `severity`: MAV_SEVERITY, 0 (emergency) to 7 (debug). "[...]" stands where a piece was lost; two texts
  // are never mixed. If the last piece was lost, or has exactly 50 characters, the text is given when the next long one
  // begins, or at the second heartbeat, that is after 1 to 2 s. The function may call the same functions as an
  // ItemNumberFunction (MissionFollower).
  void onText(TextFunction function, void* context = nullptr);

  // The last text, or an empty one before the first; while a long one is being received, its beginning.
  const char* lastText() const { return text_; }
  // Its severity.
  uint8_t lastSeverity() const { return severity_; }
  // True once after each text that is complete.
  bool isNew();

 private:
  static void take(detail::Listener& listener, const detail::FrameParser& frame);
  void takePiece(uint16_t number, uint8_t piece, uint8_t severity, const char* text);
  void append(const char* text);
  void give();

  TextFunction function_ = nullptr;
  void* context_ = nullptr;
  uint16_t number_ = 0;         // STATUSTEXT.id of the text in pieces that came last; 0: none
  uint8_t piece_ = 0;           // of it, the piece that is expected
  uint8_t heartbeatsLeft_ = 0;  // before the text is given, or when it is complete, before number_ is forgotten
  uint8_t length_ = 0;
  uint8_t severity_ = 0;
  bool isOpen_ = false;  // more pieces are expected
  bool isNew_ = false;
  char text_[kLongest + 1] = {0};
};

}  // namespace mavmission
