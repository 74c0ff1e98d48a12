// A resolved document is the scenario: it loads to the same values without the files it came from.
#include <algorithm>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "scenarios/loader.h"
#include "test/scenarios/scratch_files.h"

namespace dob::resolved_toml_test {
namespace {

// Every field, bit for bit.
class Print {
 public:
  Print() { out_ << std::hexfloat; }
  template <typename... T>
  Print& operator()(const T&... values) {
    ((out_ << values << ' '), ...);
    return *this;
  }
  std::string text() const { return out_.str(); }

 private:
  std::ostringstream out_;
};

void print_motion(Print& p, const Scenario& s) {
  for (const PathSegment& segment : s.path) p(segment.duration, segment.speed, segment.yaw_rate);
  const GaitOptions& g = s.gait;
  p(to_string(g.pattern.gait), g.pattern.stance_duration, g.pattern.swing_duration);
  p(g.early_touchdown_window, g.touchdown_force, g.late_wait);
  for (const GaitSwitch& w : g.switches) p(w.time, to_string(w.pattern.gait), w.pattern.stance_duration);
  const PlannerOptions& m = s.planner;
  p(m.com_height, m.footsteps.foot_offset_x, m.footsteps.foot_offset_y, m.footsteps.velocity_feedback);
  p(to_string(m.kind), m.horizon, m.zmp.line_half_width, m.zmp.margin, m.zmp.sample, m.footsteps.max_reach);
  p(m.zmp.sigma_position, m.zmp.sigma_velocity, m.zmp.sigma_jerk);
  p(m.swing.step_height, m.swing.landing_offset, m.swing.descent_speed);
  const WbcOptions& c = s.controller;
  for (int i = 0; i < 6; ++i) p(c.wrench_kp[i], c.wrench_kd[i]);
  p(c.swing_kp, c.swing_kd, c.wrench_weight, c.regularization, c.slack_weight, c.friction, c.min_normal_force);
  p(c.torque_limit, c.qp_rate);
}

void print_world(Print& p, const Scenario& s) {
  const SimOptions& o = s.sim;
  p(o.dt, o.erp, o.cfm, o.contact_erp, o.contact_cfm, o.gravity, o.robot_friction, o.contacts, o.joint_stops);
  p(s.terrain.ground_friction);
  for (const TerrainBox& b : s.terrain.boxes) {
    for (int i = 0; i < 3; ++i) p(b.center[i], b.size[i]);
    p(b.yaw_rad, b.friction);
  }
  if (s.block_field) {
    const BlockField& field = *s.block_field;
    p(field.start, field.end, field.width, field.tile_x, field.tile_y);
    for (const BlockField::Kind& kind : field.kinds) p(kind.height, kind.friction);
  }
  for (const Disturbance& d : s.disturbances) {
    const ForceProfile& f = d.profile;
    p(static_cast<int>(f.kind), f.amplitude_N, f.period_s, f.phase_rad, f.start_s, f.duration_s);
    p(f.ramp_s, f.f0_Hz, f.f1_Hz);
    if (d.trigger) p(static_cast<int>(d.trigger->leg), d.trigger->phase);
    p(d.leg, static_cast<int>(d.link), static_cast<int>(d.frame));
    for (int i = 0; i < 3; ++i) p(d.p_L[i], d.direction[i]);
  }
  for (const RandomPush& r : s.random_pushes) {
    p(r.min_N, r.max_N, r.hold_s, r.start_s, r.duration_s);
    for (const Leg leg : r.legs) p(static_cast<int>(leg));
  }
}

std::string print(const Scenario& s) {
  Print p;
  p(s.name, s.variant, s.summary, s.duration, s.robot.urdf.string(), static_cast<int>(s.robot.forward));
  for (const auto& [joint, angle] : s.robot.posture) p(joint, angle);
  print_motion(p, s);
  print_world(p, s);
  p(s.noise.torque_relative, s.noise.foot_force_relative, s.metric_leg ? static_cast<int>(*s.metric_leg) : -1);
  p(s.model_error.mass_scale, s.model_error.trunk_mass_scale, s.model_error.rotational_inertia_scale);
  const SensingErrors& e = s.sensing;
  p(e.base_velocity_noise, e.base_angular_velocity_noise, e.torque_bias, e.foot_force_bias, e.delay_ticks);
  for (const Payload& load : s.payloads) p(load.start_s, load.mass, load.p_B.x(), load.p_B.y(), load.p_B.z());
  p(s.swing_compensation, s.robot.initial_speed);
  p(s.fall.min_height_ratio, s.fall.max_tilt);
  const SeedVariation& v = s.seed_variation;
  p(v.gait_phase, v.position, v.velocity, v.disturbance_onset);
  return p.text();
}

void expect_round_trip(const ScenarioRequest& request) {
  const ScratchFiles files;
  for (const Scenario& scenario : load_scenarios(request)) {
    const std::string text = resolved_toml(request, scenario.variant);
    const std::string path = files.write("resolved.toml", text);
    const std::vector<Scenario> again = load_scenarios({.name = path});
    ASSERT_EQ(again.size(), 1u);
    EXPECT_EQ(print(again[0]), print(scenario));
    EXPECT_EQ(resolved_toml({.name = path}, again[0].variant), text);
  }
}

TEST(ResolvedToml, LoadsToTheSameScenarioForEveryShippedOneAndGainSet) {
  for (const ScenarioInfo& info : list_scenarios()) {
    for (const std::string& gains : list_gain_sets()) expect_round_trip({.name = info.name, .gains = gains});
  }
}

TEST(ResolvedToml, HoldsGainsPlannerAndOverrides) {
  const ScenarioRequest request{
      .name = "case1/tip_lateral",
      .gains = "stiff",
      .planner = "spline",
      .overrides = {"disturbance.0.direction=[0.1, 0.2, -0.7]", "gains.swing_kp_1_s2=0.1", "sim.dt_s=0.0007",
                    "terrain.boxes=[{center_m=[1,0,0], size_m=[1,1,0.1], friction=0.3}]", "metric_leg=RH",
                    "disturbance.0.duration_s=3", "summary=\"quotes \\\" and \\\\ in it\""}};
  expect_round_trip(request);
  const Scenario s = load_scenarios(request).at(0);
  EXPECT_EQ(s.controller.swing_kp, 0.1);
  EXPECT_EQ(s.controller.wrench_kp[0], 2500.0);
  EXPECT_EQ(s.sim.dt, 0.0007);
  EXPECT_EQ(s.terrain.boxes.size(), 1u);
  EXPECT_EQ(s.summary, "quotes \" and \\ in it");
}

TEST(ResolvedToml, DoesNotNeedTheDefaultsItWasMadeWith) {
  const ScratchFiles files;
  const std::string shipped = std::string(DOB_SOURCE_DIR) + "/scenarios/config/";
  const ScenarioRequest request{.name = "case1/knee_lateral", .gains = "swing300"};
  const Scenario scenario = load_scenarios(request).at(0);
  const std::string path = files.write("resolved.toml", resolved_toml(request, "knee_lateral"));

  std::string defaults = read_text(shipped + "defaults.toml");
  defaults.replace(defaults.find("stance_s = 0.15"), 15, "stance_s = 0.99");
  std::string gains = read_text(shipped + "gains.toml");
  for (std::size_t at = 0; (at = gains.find("250.0", at)) != std::string::npos;) gains.replace(at, 5, "777.0");
  files.write("data/config/defaults.toml", defaults);
  files.write("data/config/gains.toml", gains);
  setenv("DOBBENCH_SCENARIOS", (files.directory() / "data").c_str(), 1);
  const std::vector<Scenario> again = load_scenarios({.name = path});
  unsetenv("DOBBENCH_SCENARIOS");
  EXPECT_EQ(print(again.at(0)), print(scenario));
}

TEST(ResolvedToml, IsRefusedForAVariantThatWasNotAskedFor) {
  EXPECT_THROW(resolved_toml({.name = "case1/knee_lateral"}, "tip_lateral"), InputError);
  EXPECT_THROW(resolved_toml({.name = "case1"}, ""), InputError);
}

}  // namespace
}  // namespace dob::resolved_toml_test
