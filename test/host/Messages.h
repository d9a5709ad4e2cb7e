// Messages of MAVLink in words: "ATTITUDE roll 0.5 yaw nan" is the one whose other fields are 0.
#pragma once

#include <string.h>

#include <new>
#include <string>

#include "Frames.h"
#include "mavmission/link/OutgoingMessage.h"

// The frame of that message, without the zeros at its end, as MAVLink 2 sends it. Names are those of the definition;
// `distances[3-5] 7` is three elements, and a text is all that follows the name of its field. Throws
// std::invalid_argument where there is no such message or field.
FrameParts messageParts(const std::string& words);
// The same as MAVLink 1 sends it: with all its zeros, and without extensions.
FrameParts messagePartsV1(const std::string& words);

// The other way round. What is 0 is left out.
std::string wordsOf(uint32_t messageId, const Bytes& payload);
// Of a message of the library's, after how many bytes it has, in MAVLink 1 too: "14 14: DISTANCE_SENSOR id 3".
std::string wordsOf(const mavmission::OutgoingMessage& message);

// The shortest number that is this one.
std::string shortest(float value);

// True if such a message of the library's says the same wherever it is made: in memory that is zero, or all ones.
template <typename Message, typename... Of>
bool isSameAnywhere(Of... of) {
  alignas(8) uint8_t zeros[sizeof(Message)], ones[sizeof(Message)];
  memset(zeros, 0, sizeof(zeros));
  memset(ones, 255, sizeof(ones));
  return wordsOf(*new (zeros) Message(of...)) == wordsOf(*new (ones) Message(of...));
}
