// simulation/hearing as a WebAssembly module: what its C++ asks of a C++ library, and room for what goes in and out.
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

void* operator new(size_t size) { return malloc(size); }
void operator delete(void* place) noexcept { free(place); }
void operator delete(void* place, size_t) noexcept { free(place); }

namespace {
uint8_t bytes[4096];
uint8_t frame[280];  // MAVLINK_MAX_PACKET_LEN
uint16_t frameLength;
}  // namespace

extern "C" {
uint8_t* room_for_bytes() { return bytes; }
uint32_t size_of_room() { return sizeof(bytes); }
uint8_t* room_for_frame() { return frame; }
uint16_t* room_for_length() { return &frameLength; }
}
