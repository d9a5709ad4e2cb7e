// The messages of SensorMessages.h, byte by byte as they are sent: in words, how long they are and all that is not 0.
#include "mavmission/payload/SensorMessages.h"

#include <Arduino.h>
#include <doctest/doctest.h>

#include "Messages.h"

using namespace mavmission;

namespace {

constexpr uint32_t kNowMs = 4294967295u;  // in microseconds it needs more than 32 bits

}  // namespace

TEST_CASE("of the obstacles nothing is known at first, in 72 directions that are at least 5 degrees apart") {
  setMillis(1);
  CHECK(wordsOf(ObstacleDistance(20, 600)) ==
        "167 0: OBSTACLE_DISTANCE time_usec 1000 distances[0-71] 65535 increment 5 min_distance 20 max_distance 600 "
        "frame 12");
  for (uint8_t step : {0, 4, 5, 6, 45, 180}) {
    CHECK(wordsOf(ObstacleDistance(20, 600, step, 3)) ==
          "167 0: OBSTACLE_DISTANCE time_usec 1000 sensor_type 3 distances[0-71] 65535 increment " +
              std::to_string(step < 5 ? 5 : step) + " min_distance 20 max_distance 600 frame 12");
  }
}

TEST_CASE("what no function has set is 0, whatever was in that memory before") {
  setMillis(1);
  CHECK(isSameAnywhere<ObstacleDistance>(20, 600));
  CHECK(isSameAnywhere<VisionPosition>());
}

TEST_CASE("each direction has a distance, is free, or is not known, and one more there is none") {
  setMillis(1);
  ObstacleDistance around(20, 600, 5, 1);
  const auto said = [&around](const std::string& us, const std::string& distances) {
    return wordsOf(around) == "167 0: OBSTACLE_DISTANCE time_usec " + us + " sensor_type 1 " + distances +
                                  " increment 5 min_distance 20 max_distance 600 frame 12";
  };
  const std::string now = "4294967295000";
  setMillis(kNowMs);
  around.set(72, 100);
  around.set(255, 100);
  around.setFree(72);
  around.setUnknown(72);
  CHECK(said("1000", "distances[0-71] 65535"));
  around.set(0, 321);
  CHECK(said(now, "distances[0] 321 distances[1-71] 65535"));
  around.set(71, 45);
  around.set(70, 46);
  around.setFree(1);  // one more than the longest
  CHECK(said(now, "distances[0] 321 distances[1] 601 distances[2-69] 65535 distances[70] 46 distances[71] 45"));
  around.setUnknown(0);
  CHECK(said(now, "distances[0] 65535 distances[1] 601 distances[2-69] 65535 distances[70] 46 distances[71] 45"));
  around.setUnknown();
  CHECK(said(now, "distances[0-71] 65535"));
}

TEST_CASE("a GPS receiver says only what was set, which stays known: all the rest is to be ignored") {
  setMillis(kNowMs);
  // GPS_INPUT_IGNORE_FLAGS: 1 the altitude, 2 and 4 the dilutions, 8 and 16 the velocities, 32, 64 and 128 the
  // accuracies
  CHECK(wordsOf(GpsInput(1)) == "65 63: GPS_INPUT gps_id 1 ignore_flags 255");
  GpsInput placed(2), moving, accurate, diluted, dated;
  placed.set({-35.3632621_deg, 149.1652374_deg}, 584.5_m, GpsFix::ThreeDimensional, 11);
  CHECK(wordsOf(placed) ==
        "65 63: GPS_INPUT time_usec 4294967295000 gps_id 2 ignore_flags 254 fix_type 3 lat -353632621 lon 1491652374 "
        "alt 584.5 satellites_visible 11");
  moving.setVelocity(1, -2, 3.5f);
  CHECK(wordsOf(moving) == "65 63: GPS_INPUT ignore_flags 231 vn 1 ve -2 vd 3.5");
  accurate.setAccuracy(1.5f, 2.5f, 0.25f);
  CHECK(wordsOf(accurate) ==
        "65 63: GPS_INPUT ignore_flags 31 speed_accuracy 0.25 horiz_accuracy 1.5 vert_accuracy 2.5");
  diluted.setDilution(0.75f, 1.25f);
  CHECK(wordsOf(diluted) == "65 63: GPS_INPUT ignore_flags 249 hdop 0.75 vdop 1.25");
  dated.setTime(2345, 604799999);
  dated.setHeading(36000);
  CHECK(wordsOf(dated) == "65 63: GPS_INPUT ignore_flags 255 time_week_ms 604799999 time_week 2345 yaw 36000");
  accurate.setVelocity(1, -2, 3.5f);
  accurate.setDilution(0.75f, 1.25f);
  CHECK(wordsOf(accurate) ==
        "65 63: GPS_INPUT ignore_flags 1 hdop 0.75 vdop 1.25 vn 1 ve -2 vd 3.5 speed_accuracy 0.25 horiz_accuracy 1.5 "
        "vert_accuracy 2.5");
}

TEST_CASE("a position by a camera has variances that are not known until they are set") {
  setMillis(kNowMs);
  // Of the upper right triangle of a matrix of six by six, row by row, the diagonal.
  const std::string unknown =
      "covariance[0] nan covariance[6] nan covariance[11] nan covariance[15] nan covariance[18] nan covariance[20] nan";
  const std::string known =
      "covariance[0] 0.25 covariance[6] 0.25 covariance[11] 0.25 covariance[15] 0.5 covariance[18] 0.5 "
      "covariance[20] 0.5";
  const std::string placed =
      "117 32: VISION_POSITION_ESTIMATE usec 4294967295000 x 1 y 2 z -3 roll 0.1 pitch -0.2 yaw 3.1 ";
  VisionPosition vision;
  CHECK(wordsOf(vision) == "117 32: VISION_POSITION_ESTIMATE " + unknown);
  vision.set(1, 2, -3, 0.1f, -0.2f, 3.1f);
  CHECK(wordsOf(vision) == placed + unknown);
  vision.setVariance(0.25f, 0.5f);
  CHECK(wordsOf(vision) == placed + known);
  vision.countReset();
  vision.countReset();
  CHECK(wordsOf(vision) == placed + known + " reset_counter 2");
}

TEST_CASE("an odometry is not turned, and neither its speeds nor its variances are known until they are set") {
  setMillis(kNowMs);
  Odometry odometry, set, other(1);
  // MAV_FRAME_LOCAL_FRD and MAV_FRAME_BODY_FRD, by MAV_ESTIMATOR_TYPE_VISION.
  CHECK(wordsOf(odometry) ==
        "233 0: ODOMETRY frame_id 20 child_frame_id 12 q[0] 1 vx nan vy nan vz nan rollspeed nan pitchspeed nan "
        "yawspeed nan pose_covariance[0] nan pose_covariance[6] nan pose_covariance[11] nan pose_covariance[15] nan "
        "pose_covariance[18] nan pose_covariance[20] nan velocity_covariance[0] nan velocity_covariance[6] nan "
        "velocity_covariance[11] nan velocity_covariance[15] nan velocity_covariance[18] nan "
        "velocity_covariance[20] nan estimator_type 2");
  odometry.setPose(1, 2, 3, 0.5f, -0.5f, 0.25f, -0.25f);
  odometry.setVelocity(4, 5, 6);
  odometry.setRotation(0.1f, 0.2f, 0.3f);
  odometry.setVariance(0.01f, 0.02f, 0.04f);
  odometry.setQuality(-1);
  for (int i = 0; i < 3; ++i) odometry.countReset();
  CHECK(wordsOf(odometry) ==
        "233 0: ODOMETRY time_usec 4294967295000 frame_id 20 child_frame_id 12 x 1 y 2 z 3 q[0] 0.5 q[1] -0.5 "
        "q[2] 0.25 q[3] -0.25 vx 4 vy 5 vz 6 rollspeed 0.1 pitchspeed 0.2 yawspeed 0.3 pose_covariance[0] 0.01 "
        "pose_covariance[6] 0.01 pose_covariance[11] 0.01 pose_covariance[15] 0.02 pose_covariance[18] 0.02 "
        "pose_covariance[20] 0.02 velocity_covariance[0] 0.04 velocity_covariance[6] 0.04 "
        "velocity_covariance[11] 0.04 velocity_covariance[15] nan velocity_covariance[18] nan "
        "velocity_covariance[20] nan reset_counter 3 estimator_type 2 quality -1");
  CHECK(wordsOf(other).substr(0, 28) == "233 0: ODOMETRY frame_id 1 c");
}
