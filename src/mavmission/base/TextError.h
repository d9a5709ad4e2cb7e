// Why a plan's text was refused.
#pragma once

#include <stdint.h>

#include "FlashText.h"

namespace mavmission {

// The errors of a text, with their wording.
// clang-format off
#define MAVMISSION_TEXT_ERRORS(X)                                                                  \
  X(None, "no error")                                                                              \
  X(NotWaypoints, "the first line is not QGC WPL 110")                                             \
  X(LineTooLong, "a line has more than 255 characters")                                            \
  X(TooFewFields, "a line has fewer than 12 fields")                                               \
  X(TooManyFields, "a line has more than 12 fields")                                               \
  X(BadNumber, "not a number")                                                                     \
  X(TooLarge, "a number too large")                                                                \
  X(OutOfOrder, "the lines are not numbered 0, 1, 2, ...")                                         \
  X(NotZeroOrOne, "neither 0 nor 1")                                                               \
  X(BadTextFrame, "the frame is not 0, 2, 3, 5, 6, 10 or 11")                                      \
  X(NoReference, "an altitude in frame 2: write 3 (above home), 0 (sea level) or 10 (ground)")     \
  X(NotWhole, "not a whole number")                                                                \
  X(BeyondLatitude, "a latitude beyond 90 degrees")                                                \
  X(BeyondLongitude, "a longitude beyond 180 degrees")                                             \
  X(BadTarget, "a jump to home, or out of the plan")                                               \
  X(MixedKinds, "mission, fence or rally items together")                                          \
  X(NoItems, "no item after home")                                                                 \
  X(SecondPlan, "a second plan in one file: FILE_WRITE appends, so remove the file first")         \
  X(Padding, "bytes of 0 or 255: the file was not written to its end")                             \
  X(Unreadable, "it cannot be read to its end")                                                    \
  X(NoRoom, "more items than there is room for")                                                   \
  X(NotKept, "the EEPROM could not store the plan")                                                \
  X(TooFast, "too fast for the EEPROM: send it line by line")
// clang-format on

inline namespace print_it_with_toString {  // what println() of one says: see Status.h
enum class TextError : uint8_t {
#define MAVMISSION_NAME(name, text) name,
  MAVMISSION_TEXT_ERRORS(MAVMISSION_NAME)
#undef MAVMISSION_NAME
};
}  // namespace print_it_with_toString

// In words, for Serial.print(). Flash text; null for a value that is no TextError.
FlashText toString(TextError error);

}  // namespace mavmission
