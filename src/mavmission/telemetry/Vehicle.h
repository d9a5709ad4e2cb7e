// What most sketches want of an aircraft, from one object that is declared by one line.
#pragma once

#include "../client/MissionClient.h"
#include "AttitudeListener.h"
#include "BatteryListener.h"
#include "EstimatorListener.h"
#include "GpsListener.h"
#include "HealthListener.h"
#include "HudListener.h"
#include "PositionListener.h"
#include "TextListener.h"
#include "VibrationListener.h"
#include "WaypointListener.h"
#include "WindListener.h"

namespace mavmission {

// The aircraft of a client:
//
//   MissionClient autopilot(TELEM);
//   Vehicle<autopilot> vehicle;
//   ...
//   Serial.println(vehicle.battery().voltageMv());
//   Serial.println(vehicle.modeName());
//
// Each function that gives a listener makes it when it is called for the first time; from then on its message is
// requested. Those that the sketch does not call take neither flash nor RAM (docs/measurements.md has what each takes).
// Call them again and again, in loop(): the values come a moment after the first call.
//
// `client` must be a global variable, without `static`. `intervalMs`: from one message to the next, at most 5000.
template <MissionClient& client, uint16_t intervalMs = 1000>
class Vehicle {
 public:
  // Place, heights, speed and heading; roll, pitch and yaw; the first battery; the GPS.
  static PositionListener& position() { return listener<PositionListener>(); }
  static AttitudeListener& attitude() { return listener<AttitudeListener>(); }
  static BatteryListener& battery() { return listener<BatteryListener>(); }
  static GpsListener& gps() { return listener<GpsListener>(); }
  // Airspeed, climb and throttle; the distance and the bearing to the waypoint; the wind.
  static HudListener& hud() { return listener<HudListener>(); }
  static WaypointListener& waypoint() { return listener<WaypointListener>(); }
  static WindListener& wind() { return listener<WindListener>(); }
  // What fitness() is made of: the autopilot's checks and sensors, its estimator (EKF), its vibration.
  static HealthListener& health() { return listener<HealthListener>(); }
  static EstimatorListener& estimator() { return listener<EstimatorListener>(); }
  static VibrationListener& vibration() { return listener<VibrationListener>(); }
  // The autopilot's texts, such as why it does not arm.
  static TextListener& texts() {
    static TextListener texts(client);
    return texts;
  }

  // Whether it is fit to fly, by health(), estimator() and vibration(), and the worst of their reasons.
  static Fitness fitness() { return fitnessOf(whyNotFit()); }
  static FitReason whyNotFit() { return worse(worse(health().reason(), estimator().reason()), vibration().reason()); }

  // As its last heartbeat has shown it.
  static bool isHeard() { return client.hasAutopilot(); }
  static bool isArmed() { return client.isArmed(); }
  static FlashText modeName() { return client.modeName(); }
  static bool isInMode(FlightMode mode) { return client.isInMode(mode); }

 private:
  template <typename T>
  static T& listener() {
    static T made(client, intervalMs);
    return made;
  }
};

}  // namespace mavmission
