// Whole-body QP inputs for tests and benchmarks: recorded from real trials, and random ones around the standing pose.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "controller/compensation.h"
#include "controller/motion_planner.h"
#include "robot/model.h"

namespace dob::test {

struct WbcInstance {
  ModelTerms m;
  PerLeg<bool> stance{};
  MotionReference reference;
  DisturbanceEstimate estimate;
};

// Every tick at which DogBot solved its QP in a scenario, for `duration` [s] of simulated time, with the observer's
// estimate. By default a trot under case 1's force (20 N sine on the foot tip).
std::vector<WbcInstance> recorded_instances(double duration, const std::string& scenario = "case1/tip_lateral");

// The same with every estimate replaced by a random one of up to 15 N m per joint.
std::vector<WbcInstance> recorded_instances(double duration, std::mt19937_64& random);

// Random states near the standing pose, random references, estimates and stance sets (any number of feet).
std::vector<WbcInstance> random_instances(int count, std::mt19937_64& random);

}  // namespace dob::test
