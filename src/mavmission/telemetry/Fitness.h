// Whether an aircraft is fit to fly, in one word, and why not.
#pragma once

#include <stdint.h>

#include "../base/FlashText.h"

namespace mavmission {

// X(FitReason, "text"), from the best to the worst.
#define MAVMISSION_FIT_REASONS(X)                                                                 \
  /* Fit */                                                                                       \
  X(AllWell, "all is well")                                                                       \
  /* Unknown */                                                                                   \
  X(NotHeard, "not heard for 10 s")        /* the message, or nothing at all */                   \
  X(NotTold, "the autopilot does not say") /* no autopilot that sends the check before arming */  \
  /* NotYet */                                                                                    \
  X(NotReady, "the autopilot is not ready to arm") /* its checks before arming have not passed */ \
  X(NoAttitude, "no attitude yet")                 /* of the estimator (EKF) */                   \
  X(NoPosition, "no position yet")                 /* or no velocity, or no height */             \
  /* Unfit */                                                                                     \
  X(SensorFailed, "a sensor has failed") /* while the aircraft is armed */                        \
  X(GpsGlitch, "the GPS position has jumped")                                                     \
  X(Disagreement, "the sensors disagree") /* the estimator rejects a sensor */                    \
  X(Vibration, "strong vibration")                                                                \
  X(Clipping, "the vibration exceeds the accelerometer's range")

// Why an aircraft is not fit to fly; AllWell if it is.
enum class FitReason : uint8_t {
#define MAVMISSION_NAME(name, text) name,
  MAVMISSION_FIT_REASONS(MAVMISSION_NAME)
#undef MAVMISSION_NAME
};

// X(Fitness, "text").
#define MAVMISSION_FITNESSES(X) \
  X(Fit, "fit")                 \
  X(Unknown, "not known")       \
  X(NotYet, "not yet fit")      \
  X(Unfit, "unfit")

// The word for a FitReason. Fit: fly. NotYet: wait, for example for the GPS. Unfit: do not take off, or land.
enum class Fitness : uint8_t {
#define MAVMISSION_NAME(name, text) name,
  MAVMISSION_FITNESSES(MAVMISSION_NAME)
#undef MAVMISSION_NAME
};

// The word for a reason.
constexpr Fitness fitnessOf(FitReason reason) {
  return reason >= FitReason::SensorFailed ? Fitness::Unfit
         : reason >= FitReason::NotReady   ? Fitness::NotYet
         : reason >= FitReason::NotHeard   ? Fitness::Unknown
                                           : Fitness::Fit;
}

// The worse of two reasons.
constexpr FitReason worse(FitReason one, FitReason other) { return one > other ? one : other; }

// In words, for Serial.print(). Flash text; null for a value that is none of the enumeration.
FlashText toString(Fitness fitness);
FlashText toString(FitReason reason);

}  // namespace mavmission
