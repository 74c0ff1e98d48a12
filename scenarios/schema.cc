#include "scenarios/schema.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scenarios/reader.h"

namespace dob {
namespace {

// Ranges that several keys share: wide enough for any legged robot, narrow enough for a wrong unit to fall out.
constexpr double kMostTicks = 1e8;              // of a trial
constexpr Range kDuration = above(0.0, 10.0);   // [s] of parts of a footstep
constexpr Range kSoftness = between(0.0, 1.0);  // [-] or [1/kg]
constexpr Range kGain = between(0.0, 1e6);
constexpr Range kWeight = above(0.0, 1e16);
constexpr Range kLength = above(0.0, 10.0);  // [m]

constexpr std::array<Choice<Forward>, 4> kForward{
    {{"+x", Forward::kPlusX}, {"-x", Forward::kMinusX}, {"+y", Forward::kPlusY}, {"-y", Forward::kMinusY}}};
constexpr std::array<Choice<int>, kLegs + 1> kMetricLegs{{{"all", -1}, {"LF", 0}, {"RF", 1}, {"LH", 2}, {"RH", 3}}};
constexpr std::array<Choice<PlannerKind>, 3> kPlanners{
    {{"zmp", PlannerKind::kZmp}, {"spline", PlannerKind::kSpline}, {"paper_split", PlannerKind::kPaperSplit}}};
constexpr std::array<Choice<Gait>, 3> kGaits{{{"trot", Gait::kTrot}, {"crawl", Gait::kCrawl}, {"stand", Gait::kStand}}};
constexpr std::array<Choice<WbcOptions::OrientationError>, 2> kOrientationErrors{
    {{"rotation_vector", WbcOptions::OrientationError::kRotationVector},
     {"zyx", WbcOptions::OrientationError::kZyxAngles}}};
constexpr std::array<Choice<WbcOptions::Coriolis>, 2> kCoriolis{
    {{"exact", WbcOptions::Coriolis::kExact}, {"neglected", WbcOptions::Coriolis::kNeglected}}};
constexpr std::array<Choice<WbcOptions::BetweenSolves>, 2> kBetweenSolves{
    {{"recomputed", WbcOptions::BetweenSolves::kRecomputed}, {"held", WbcOptions::BetweenSolves::kHeld}}};

// A path in a file is relative to that file; one on the command line to the working directory.
std::filesystem::path absolute_path(const std::string& text, const Place& place) {
  const std::filesystem::path base = place.line == 0 ? "" : std::filesystem::path(place.source).parent_path();
  return std::filesystem::absolute(base / text).lexically_normal();
}

std::vector<const JointDescription*> joints_of(const RobotDescription& robot) {
  std::vector<const JointDescription*> joints;
  for (const LegDescription& leg : robot.legs) {
    for (const JointDescription& joint : leg.joints) joints.push_back(&joint);
  }
  return joints;
}

// The robot comes first: its joints and feet give other keys their meaning.
RobotDescription read_robot(Reader& r, RobotConfig& config) {
  RobotDescription robot;
  r.table("robot", [&](Reader& t) {
    config.urdf = absolute_path(t.text("urdf"), t.place("urdf"));
    config.forward = t.choice("forward", kForward);
    config.initial_speed = t.number("initial_speed_m_s", between(-10.0, 10.0));
    try {
      robot = load_robot(config.urdf, config.forward);
    } catch (const DescriptionError& error) {
      throw InputError(t.place("urdf"), "robot.urdf", error.what());
    }
    t.table("posture_rad", [&](Reader& p) {
      for (const JointDescription* joint : joints_of(robot))
        config.posture[joint->name] = p.number(joint->name, between(joint->lower, joint->upper));
    });
  });
  return robot;
}

double length_of(const std::vector<PathSegment>& path) {
  double length = 0.0;  // [s]
  for (const PathSegment& segment : path) length += segment.duration;
  return length;
}

// `longest` [s] is also that of all segments together.
std::vector<PathSegment> read_path(Reader& r, double longest) {
  std::vector<PathSegment> path;
  r.each("path", [&](Reader& t) {
    path.push_back({.duration = t.number("duration_s", above(0.0, kLongestTime)),
                    .speed = t.number("speed_m_s", between(-10.0, 10.0)),
                    .yaw_rate = t.number("yaw_rate_rad_s", between(-10.0, 10.0), 0.0)});
  });
  if (path.empty() && r.has("path")) r.refuse("path", "at least one [[path]] segment");
  if (const double length = length_of(path); length > longest)
    r.refuse("path", fmt::format("segments of at most {} s in all, these are {}", longest, length));
  return path;
}

GaitOptions read_gait(Reader& r) {
  GaitOptions gait;
  const auto read_pattern = [](Reader& t) {
    return GaitPattern{.gait = t.choice("kind", kGaits),
                       .stance_duration = t.number("stance_s", kDuration),
                       .swing_duration = t.number("swing_s", kDuration)};
  };
  r.table("gait", [&](Reader& t) {
    gait.pattern = read_pattern(t);
    gait.early_touchdown_window = t.number("early_touchdown_window_s", between(0.0, gait.pattern.swing_duration));
    gait.touchdown_force = t.number("touchdown_force_N", above(0.0, 1e4));
    gait.late_wait = t.number("late_wait_s", between(0.0, 10.0));
    t.each("switch", [&](Reader& s) {
      const GaitSwitch next{s.number("at_s", between(0.0, kLongestTime)), read_pattern(s)};
      if (!gait.switches.empty() && next.time < gait.switches.back().time) {
        s.refuse("at_s", fmt::format("not before the previous switch, {} s", gait.switches.back().time));
      }
      if (next.pattern.swing_duration < gait.early_touchdown_window) {
        s.refuse("swing_s", fmt::format("at least early_touchdown_window_s, {}", gait.early_touchdown_window));
      }
      gait.switches.push_back(next);
    });
  });
  return gait;
}

FootstepOptions read_footsteps(Reader& t) {
  return {.foot_offset_x = t.number("foot_offset_x_m", kLength),
          .foot_offset_y = t.number("foot_offset_y_m", kLength),
          .velocity_feedback = t.number("velocity_feedback_s", between(0.0, 10.0)),
          .path_feedback = t.number("path_feedback", between(0.0, 1.0)),
          .max_path_correction = t.number("max_path_correction_m", between(0.0, 1.0)),
          .start_ramp = t.number("start_ramp_s", between(0.0, 60.0)),
          .max_reach = t.number("max_reach", above(0.0, 1.0))};
}

void require_room_for_samples(const Reader& zmp, const PlannerOptions& planner, const GaitPattern& pattern) {
  const double count = zmp_samples(planner, pattern);
  if (count <= kMaxZmpSamples) return;
  zmp.refuse("sample_s",
             fmt::format("at most {} samples over the {} footsteps of the horizon, these are {} (a stance of "
                         "{} s, a swing of {} s)",
                         kMaxZmpSamples, planner.horizon, count, pattern.stance_duration, pattern.swing_duration));
}

PlannerOptions read_planner(Reader& r, const GaitOptions& gait) {
  PlannerOptions planner;
  r.table("planner", [&](Reader& t) {
    planner.kind = t.choice("kind", kPlanners);
    planner.com_height = t.number("com_height_m", kLength);
    planner.footsteps = read_footsteps(t);
    planner.horizon = t.integer("horizon_footsteps", 1, kMaxHorizon);
    t.table("zmp", [&](Reader& z) {
      planner.zmp = {.line_half_width = z.number("line_half_width_m", above(0.0, 1.0)),
                     .margin = z.number("margin_m", between(0.0, 1.0)),
                     .sample = z.number("sample_s", between(1e-3, 1.0)),
                     .sigma_position = z.number("sigma_position_m", above(0.0, 1e3)),
                     .sigma_velocity = z.number("sigma_velocity_m_s", above(0.0, 1e3)),
                     .sigma_jerk = z.number("sigma_jerk_m_s3", above(0.0, 1e6))};
      require_room_for_samples(z, planner, gait.pattern);
      for (const GaitSwitch& s : gait.switches) require_room_for_samples(z, planner, s.pattern);
    });
    planner.swing.step_height = t.number("step_height_m", above(0.0, 1.0));
    planner.swing.landing_offset = t.number("landing_offset_m", below(0.0, planner.swing.step_height));
    planner.swing.descent_speed = t.number("descent_speed_m_s", above(0.0, 10.0));
  });
  return planner;
}

JointLimits joint_limits(const RobotDescription& robot) {
  JointLimits limits;
  Eigen::Index i = 0;
  for (const JointDescription* joint : joints_of(robot)) {
    limits.lower[i] = joint->lower;
    limits.upper[i] = joint->upper;
    limits.velocity[i++] = joint->velocity_limit;
  }
  return limits;
}

// A limit that all joints keep.
double smallest_effort(const RobotDescription& robot) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const JointDescription* joint : joints_of(robot)) smallest = std::min(smallest, joint->effort_limit);
  return smallest;
}

WbcOptions read_controller(Reader& r, const RobotDescription& robot) {
  WbcOptions wbc;
  wbc.joint_limits = joint_limits(robot);
  const double weakest = smallest_effort(robot);  // [N m]
  r.table("controller", [&](Reader& t) {
    wbc.friction = t.number("friction", above(0.0, 10.0));
    wbc.min_normal_force = t.number("min_normal_force_N", between(0.0, 1e4));
    wbc.torque_limit = t.number("torque_limit_Nm", above(0.0, weakest), weakest);
    wbc.wrench_weight = t.number("wrench_weight", kWeight);
    wbc.regularization = t.number("regularization", kWeight);
    wbc.slack_weight = t.number("slack_weight", kWeight);
    wbc.qp_rate = t.number("qp_rate_Hz", above(0.0, 1e5));
    wbc.orientation_error = t.choice("orientation_error", kOrientationErrors);
    wbc.coriolis = t.choice("coriolis", kCoriolis);
    wbc.torque_rows = t.flag("torque_rows");
    wbc.joint_acceleration_limits = t.flag("joint_acceleration_limits");
    wbc.acceleration_horizon = t.number("acceleration_horizon_s", above(0.0, 10.0));
    wbc.torque_between_solves = t.choice("torque_between_solves", kBetweenSolves);
    wbc.printed_sign_21 = t.flag("printed_sign_21");
  });
  r.table("gains", [&](Reader& t) {
    wbc.wrench_kp.head<3>() = t.vector_or_number("wrench_kp_linear_N_m", kGain);
    wbc.wrench_kp.tail<3>() = t.vector_or_number("wrench_kp_angular_Nm_rad", kGain);
    wbc.wrench_kd.head<3>() = t.vector_or_number("wrench_kd_linear_Ns_m", kGain);
    wbc.wrench_kd.tail<3>() = t.vector_or_number("wrench_kd_angular_Nms_rad", kGain);
    wbc.swing_kp = t.number("swing_kp_1_s2", kGain);
    wbc.swing_kd = t.number("swing_kd_1_s", kGain);
  });
  return wbc;
}

SimOptions read_sim(Reader& r) {
  SimOptions sim;
  r.table("sim", [&](Reader& t) {
    sim.dt = t.number("dt_s", between(1e-5, 0.01));
    sim.erp = t.number("erp", kSoftness);
    sim.cfm = t.number("cfm_1_kg", kSoftness);
    sim.contact_erp = t.number("contact_erp", kSoftness);
    sim.contact_cfm = t.number("contact_cfm_1_kg", kSoftness);
    sim.gravity = t.number("gravity_m_s2", between(0.0, 100.0));
    sim.robot_friction = t.number("robot_friction", kFriction);
    sim.joint_stops = t.flag("joint_stops");
  });
  return sim;
}

void read_trial(Reader& r, Scenario& s) {
  r.table("noise", [&](Reader& t) {
    s.noise.torque_relative = t.number("torque_relative", between(0.0, 10.0));
    s.noise.foot_force_relative = t.number("foot_force_relative", between(0.0, 10.0));
  });
  r.table("fall", [&](Reader& t) {
    s.fall.min_height_ratio = t.number("min_height_ratio", below(0.0, 1.0));
    s.fall.max_tilt = t.number("max_tilt_rad", above(0.0, std::numbers::pi));
  });
  r.table("seeds", [&](Reader& t) {
    s.seed_variation.gait_phase = t.number("gait_phase", between(0.0, 1.0));
    s.seed_variation.position = t.number("position_m", between(0.0, 1.0));
    s.seed_variation.velocity = t.number("velocity_m_s", between(0.0, 10.0));
    s.seed_variation.disturbance_onset = t.number("disturbance_onset_s", between(0.0, kLongestTime));
  });
  const int leg = r.choice("metric_leg", kMetricLegs);
  if (leg >= 0) s.metric_leg = static_cast<Leg>(leg);
}

}  // namespace

Scenario read_scenario(const Node& document) {
  Scenario s;
  Reader::read(document, "", [&](Reader& r) {
    s.summary = r.text("summary");
    const RobotDescription robot = read_robot(r, s.robot);
    s.sim = read_sim(r);
    const double longest = std::min(kLongestTime, std::round(kMostTicks * s.sim.dt));  // [s]
    s.path = read_path(r, longest);
    s.duration = r.number("duration_s", above(0.0, longest), length_of(s.path));
    s.gait = read_gait(r);
    s.planner = read_planner(r, s.gait);
    s.controller = read_controller(r, robot);
    r.table("compensation", [&](Reader& t) { s.swing_compensation = t.flag("swing"); });
    read_terrain(r, s);
    r.each("disturbance", [&](Reader& t) { read_disturbance(t, robot, s); });
    read_trial(r, s);
    read_imperfections(r, s);
  });
  return s;
}

}  // namespace dob
