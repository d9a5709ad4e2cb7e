// MavMission: puts a flight plan aboard a Pixhawk from an Arduino. README.md begins with an example; the protocol is
// https://mavlink.io/en/services/mission.html.
#pragma once

// By semantic versioning; the same as in library.properties.
#define MAVMISSION_VERSION "1.0.0"

#include "mavmission/Adjustments.h"
#include "mavmission/AttitudeListener.h"
#include "mavmission/BatteryListener.h"
#include "mavmission/EepromPlan.h"
#include "mavmission/EepromTimestamps.h"
#include "mavmission/EstimatorListener.h"
#include "mavmission/Fitness.h"
#include "mavmission/Flight.h"
#include "mavmission/FlightState.h"
#include "mavmission/GpsListener.h"
#include "mavmission/HealthListener.h"
#include "mavmission/HomeListener.h"
#include "mavmission/HudListener.h"
#include "mavmission/LatLon.h"
#include "mavmission/LinkDoctor.h"
#include "mavmission/MessageListener.h"
#include "mavmission/MissionClient.h"
#include "mavmission/MissionFollower.h"
#include "mavmission/MovingTarget.h"
#include "mavmission/Parameters.h"
#include "mavmission/Payload.h"
#include "mavmission/PayloadMessages.h"
#include "mavmission/PlanFiles.h"
#include "mavmission/PositionListener.h"
#include "mavmission/RadioListener.h"
#include "mavmission/RcListener.h"
#include "mavmission/SensorMessages.h"
#include "mavmission/StandardModes.h"
#include "mavmission/SteeredFlight.h"
#include "mavmission/Steering.h"
#include "mavmission/TelemetryListener.h"
#include "mavmission/TelemetryPause.h"
#include "mavmission/TextListener.h"
#include "mavmission/Vehicle.h"
#include "mavmission/VelocityTarget.h"
#include "mavmission/VibrationListener.h"
#include "mavmission/WaypointListener.h"
#include "mavmission/WaypointsSource.h"
#include "mavmission/WindListener.h"

// Included by Arduino.h since version 2, as Stream::availableForWrite() is there.
#if defined(ARDUINO_ARCH_ESP32) && !defined(ESP_ARDUINO_VERSION_MAJOR)
#error "MavMission needs version 2 or newer of the core for ESP32: Tools, Board, Boards Manager, esp32"
#endif
