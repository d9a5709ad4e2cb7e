// simulation/hearing, and the library's reader of .waypoints, as a WebAssembly module: what their C++ asks of a C++
// library, and room for what goes in and out.
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include "../planning/read_text.h"

void* operator new(size_t size) { return malloc(size); }
void operator delete(void* place) noexcept { free(place); }
void operator delete(void* place, size_t) noexcept { free(place); }

namespace {
uint8_t bytes[4096];
uint8_t frame[280];  // MAVLINK_MAX_PACKET_LEN
uint16_t frameLength;

TextReading reading;
TextReading::Event event;
}  // namespace

extern "C" {
uint8_t* room_for_bytes() { return bytes; }
uint32_t size_of_room() { return sizeof(bytes); }
uint8_t* room_for_frame() { return frame; }
uint16_t* room_for_length() { return &frameLength; }

void text_begin() { reading = TextReading(); }
// How many of the bytes are taken, up to the next event; no bytes are the text's end.
uint32_t text_take(uint32_t length) {
  uint32_t taken = 0;
  do event = reading.take(taken < length ? bytes[taken++] : -1);
  while (event == TextReading::kMore && taken < length);
  return taken;
}
uint32_t text_event() { return event; }
uint32_t text_line() { return reading.text().errorLine(); }
uint32_t text_field() { return reading.text().errorField(); }
uint32_t text_error() { return static_cast<uint32_t>(reading.text().error()); }
uint32_t text_type() { return static_cast<uint32_t>(reading.text().type()); }
const mavmission::MissionItem* text_item() { return &reading.text().item(); }
}
