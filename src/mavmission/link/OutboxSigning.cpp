// The part of Outbox for signed frames.
#include "Outbox.h"

#if MAVMISSION_SIGNING

namespace mavmission {
namespace detail {

void Outbox::startSigning(Signing& signing) {
  if (writeForeign_ == nullptr) {
    const Signing::Piece whole = {frame_, length_};
    return signing.sign(&whole, 1);
  }
  const Signing::Piece pieces[] = {
      {foreign_.around, foreign_.headLength},
      {foreign_.body, foreign_.bodyLength},
      {foreign_.around + foreign_.headLength, 2},  // the checksum
  };
  signing.sign(pieces, 3);
}

}  // namespace detail
}  // namespace mavmission

#endif
