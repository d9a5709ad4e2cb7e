#include "EitherListener.h"

#include "../client/Port.h"

namespace mavmission {
namespace detail {

void EitherListener::takeEither(Listener& listener, const FrameParser& frame) {
  EitherListener& self = static_cast<EitherListener&>(listener);
  self.request(has(self.client_.autopilot().firmware(), kStreamsAsArduPilot) ? &self.keys_[0] : &self.keys_[1]);
  take(listener, frame);
}

}  // namespace detail
}  // namespace mavmission
