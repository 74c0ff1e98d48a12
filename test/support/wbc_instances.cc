#include "test/support/wbc_instances.h"

#include "bench/trial.h"
#include "robot/standing_pose.h"
#include "scenarios/loader.h"

namespace dob::test {
namespace {

Vec12 uniform_vector(std::mt19937_64& random, double scale) {
  std::uniform_real_distribution<double> uniform(-scale, scale);
  Vec12 v;
  for (double& x : v) x = uniform(random);
  return v;
}

Scenario case1_tip() {
  return load_scenarios({.name = "case1/tip_lateral", .gains = "paper", .planner = "", .overrides = {}}).front();
}

}  // namespace

std::vector<WbcInstance> recorded_instances(double duration, const std::string& scenario_name) {
  const Scenario scenario = load_scenarios({.name = scenario_name}).front();
  Trial trial(scenario, load_observer("momentum", "matched"), 1);
  std::vector<WbcInstance> instances;
  while (trial.time() < duration) {
    WbcInstance instance;
    instance.m = trial.model_terms();
    if (!trial.tick()) break;
    if (!trial.record().qp_solved) continue;
    instance.stance = trial.controller().stance();
    instance.reference = trial.controller().reference();
    instance.estimate.has_legs = true;
    instance.estimate.leg_torque = trial.record().leg_torque_estimate;
    instances.push_back(instance);
  }
  return instances;
}

std::vector<WbcInstance> recorded_instances(double duration, std::mt19937_64& random) {
  std::vector<WbcInstance> instances = recorded_instances(duration);
  for (WbcInstance& instance : instances) instance.estimate.leg_torque = uniform_vector(random, 15.0);
  return instances;
}

std::vector<WbcInstance> random_instances(int count, std::mt19937_64& random) {
  const Scenario scenario = case1_tip();
  const Model model(load_robot(scenario.robot.urdf, scenario.robot.forward));
  const RobotState standing =
      standing_pose(model, scenario.planner.com_height, scenario.planner.footsteps.foot_offset_x,
                    scenario.planner.footsteps.foot_offset_y, scenario.robot.posture);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vec3 = [&](double scale) { return Vec3(scale * Vec3{uniform(random), uniform(random), uniform(random)}); };
  std::vector<WbcInstance> instances;
  for (int i = 0; i < count; ++i) {
    WbcInstance instance;
    RobotState state = standing;
    state.p_WB += vec3(0.05);
    state.R_WB = Eigen::AngleAxisd(0.3 * uniform(random), vec3(1.0).normalized()).toRotationMatrix();
    state.v_WB = vec3(0.5);
    state.omega_WB = vec3(1.0);
    state.q += uniform_vector(random, 0.3);
    state.qd = uniform_vector(random, 3.0);
    model.compute(state, instance.m);
    for (bool& stands : instance.stance) stands = uniform(random) < 0.3;  // 65 % of the feet
    instance.reference.com = {instance.m.p_com + vec3(0.05), vec3(0.5), vec3(2.0)};
    instance.reference.R_WB = Eigen::AngleAxisd(0.2 * uniform(random), vec3(1.0).normalized()).toRotationMatrix();
    instance.reference.omega = vec3(0.5);
    instance.reference.alpha = vec3(5.0);
    for (int l = 0; l < kLegs; ++l) {
      instance.reference.foot[l] = {instance.m.foot[l].p + vec3(0.05), vec3(0.5), vec3(5.0)};
      instance.reference.foothold[l] = instance.m.foot[l].p;
    }
    instance.estimate.has_legs = true;
    instance.estimate.leg_torque = uniform_vector(random, 15.0);
    instance.estimate.has_com = uniform(random) < 0.0;  // half of them
    instance.estimate.com_wrench = 20.0 * uniform_vector(random, 1.0).head<6>();
    instances.push_back(instance);
  }
  return instances;
}

}  // namespace dob::test
