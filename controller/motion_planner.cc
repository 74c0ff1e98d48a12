#include "controller/motion_planner.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace dob {
namespace {

void require(bool ok, const char* name, double value, std::string_view allowed) {
  if (!ok || !std::isfinite(value)) {
    throw std::invalid_argument(fmt::format("planner: {} = {}; allowed: {}", name, value, allowed));
  }
}

void require_valid(const FootstepOptions& o) {
  require(o.foot_offset_x > 0.0, "foot_offset_x_m", o.foot_offset_x, "> 0");
  require(o.foot_offset_y > 0.0, "foot_offset_y_m", o.foot_offset_y, "> 0");
  require(o.velocity_feedback >= 0.0, "velocity_feedback_s", o.velocity_feedback, ">= 0");
  require(o.path_feedback >= 0.0 && o.path_feedback <= 1.0, "path_feedback", o.path_feedback, "0 to 1");
  require(o.max_path_correction >= 0.0, "max_path_correction_m", o.max_path_correction, ">= 0");
  require(o.start_ramp >= 0.0, "start_ramp_s", o.start_ramp, ">= 0");
  require(o.max_reach > 0.0 && o.max_reach <= 1.0, "max_reach", o.max_reach, "> 0, at most 1");
}

void require_valid(const ZmpOptions& o) {
  require(o.line_half_width > 0.0, "zmp.line_half_width_m", o.line_half_width, "> 0");
  require(o.margin >= 0.0, "zmp.margin_m", o.margin, ">= 0");
  require(o.sample > 0.0, "zmp.sample_s", o.sample, "> 0");
  require(o.sigma_position > 0.0, "zmp.sigma_position_m", o.sigma_position, "> 0");
  require(o.sigma_velocity > 0.0, "zmp.sigma_velocity_m_s", o.sigma_velocity, "> 0");
  require(o.sigma_jerk > 0.0, "zmp.sigma_jerk_m_s3", o.sigma_jerk, "> 0");
}

void require_room_for_samples(const PlannerOptions& o, const GaitPattern& p) {
  const double count = zmp_samples(o, p);
  require(count <= kMaxZmpSamples, "zmp.sample_s", o.zmp.sample,
          fmt::format("at most {} samples over the {} footsteps of the horizon, these are {}", kMaxZmpSamples,
                      o.horizon, count));
}

Mat3 heading(double yaw) noexcept {
  return Eigen::AngleAxisd(yaw, Vec3::UnitZ()).toRotationMatrix();
}

Mat3 rotation(const Vec3& vector) noexcept {
  const double angle = vector.norm();
  return angle < 1e-12 ? Mat3(Mat3::Identity()) : Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

PerLeg<bool> standing(const Footstep& step) noexcept {
  PerLeg<bool> stance{};
  for (int l = 0; l < kLegs; ++l) stance[l] = !step.swings[l];
  return stance;
}

// With three feet or more down the CoM can rest.
bool is_static(const Footstep& step) noexcept {
  return std::count(step.swings.begin(), step.swings.end(), true) <= 1;
}

Vec2 center_of(const PerLeg<Vec2>& feet) noexcept {
  return 0.25 * (feet[0] + feet[1] + feet[2] + feet[3]);
}

constexpr PerLeg<bool> kAllStand{true, true, true, true};

}  // namespace

Vec2 zero_moment_point(const Motion<Vec3>& com) noexcept {
  return com.p.head<2>() - com.p.z() / (kGravity + com.a.z()) * com.a.head<2>();
}

double zmp_samples(const PlannerOptions& o, const GaitPattern& p) noexcept {
  if (o.kind == PlannerKind::kSpline) return 0.0;
  const auto samples = [&o](double duration) { return std::ceil(duration / o.zmp.sample - 1e-9); };
  return (o.horizon + 1) * samples(p.stance_duration) + o.horizon * samples(p.swing_duration);
}

MotionPlanner::MotionPlanner(const PlannerOptions& o, const GaitOptions& gait, ReferencePath path)
    : options_(o), path_(std::move(path)), optimizer_(o.zmp, o.horizon) {
  require(o.com_height > 0.0, "com_height_m", o.com_height, "> 0");
  require_valid(o.footsteps);
  require_valid(o.zmp);
  require_room_for_samples(o, gait.pattern);
  for (const GaitSwitch& s : gait.switches) require_room_for_samples(o, s.pattern);
  require(o.swing.step_height > 0.0, "step_height_m", o.swing.step_height, "> 0");
  require(o.swing.landing_offset >= 0.0 && o.swing.landing_offset < o.swing.step_height, "landing_offset_m",
          o.swing.landing_offset, "0 to step_height_m");
  require(o.swing.descent_speed > 0.0, "descent_speed_m_s", o.swing.descent_speed, "> 0");
}

void MotionPlanner::reset(const ModelTerms& m) noexcept {
  com_.start(m.p_com.head<2>(), Vec2::Zero());
  com_start_time_ = height_start_time_ = attitude_start_time_ = 0.0;
  height_ = HeightTrajectory::plan(m.p_com.z(), m.v_c.z(), options_.com_height, 1.0);
  last_time_ = stood_ = ramp_start_ = 0.0;
  support_mid_.fill(0.0);
  tilt_.setZero();
  tilt_rate_.setZero();
  plan_ = {};
  zmp_report_ = {};
  reference_.clamped.fill(false);
  for (int l = 0; l < kLegs; ++l) {
    reference_.foothold[l] = m.foot[l].p;
    reference_.foot[l] = {m.foot[l].p, Vec3::Zero(), Vec3::Zero()};
  }
}

// The spline planner's motion during the swing phase of a footstep.
void MotionPlanner::append_swing(const Footstep& step) noexcept {
  if (is_static(step)) {
    path_ahead_.append_cubic(step.swing_duration, path_ahead_.end().p, Vec2::Zero());
  } else {
    path_ahead_.append_constant_velocity(step.swing_duration);
  }
}

// The same for the whole footstep: to the place from which mid-swing is met at the path's velocity, or to rest.
void MotionPlanner::append_footstep(const Footstep& step) noexcept {
  if (is_static(step)) {
    const SupportPolygon polygon = support_polygon(standing(step), step.feet, options_.zmp.line_half_width);
    path_ahead_.append_cubic(step.to_lift_off, move_inside(polygon, step.body, options_.zmp.margin), Vec2::Zero());
  } else {
    path_ahead_.append_cubic(step.to_lift_off, step.body - 0.5 * step.swing_duration * step.velocity, step.velocity);
  }
  append_swing(step);
}

// 4.1.1: to the centre of the support polygon. In a crawl that can only mean the coming triangle, since the centre of
// four feet lies on its edge.
void MotionPlanner::append_paper_stance(const Footstep& step) noexcept {
  if (!is_static(step)) {
    path_ahead_.append_cubic(step.to_lift_off, center_of(step.feet), step.velocity);
    return;
  }
  Vec2 center = Vec2::Zero();
  for (int l = 0; l < kLegs; ++l) {
    if (!step.swings[l]) center += step.feet[l] / 3.0;
  }
  path_ahead_.append_cubic(step.to_lift_off, center, Vec2::Zero());
}

// The path waits while the gait stands, and starts again with the ramp.
void MotionPlanner::follow_gait(double t, const GaitState& gait) noexcept {
  stands_ = gait.pattern.gait == Gait::kStand;
  if (stands_) {
    stood_ += t - last_time_;
    ramp_start_ = path_time(t);
    support_mid_.fill(ramp_start_);
  }
  last_time_ = t;
}

void MotionPlanner::plan_stand(const GaitState& gait, const ModelTerms& m) noexcept {
  PerLeg<Vec2> feet;
  for (int l = 0; l < kLegs; ++l) feet[l] = m.foot[l].p.head<2>();
  path_ahead_.append_cubic(gait.pattern.stance_duration, center_of(feet), Vec2::Zero());
  com_ = path_ahead_;
}

void MotionPlanner::plan_footstep(double t, const GaitState& gait, const ModelTerms& m) noexcept {
  const Vec2 acceleration = com_.at(t - com_start_time_).a;  // planned: the reference stays smooth
  const Motion<Vec2> start{m.p_com.head<2>(), m.v_c.head<2>(), acceleration};
  const int horizon = options_.kind == PlannerKind::kSpline ? 1 : options_.horizon;
  const double since_stand = path_time(t) - ramp_start_;
  const double ramp = options_.footsteps.start_ramp;
  plan_ = plan_footsteps(options_.footsteps, path_,
                         {path_time(t), since_stand < ramp ? since_stand / ramp : 1.0, support_mid_}, gait, m, horizon);
  com_start_time_ = height_start_time_ = t;
  path_ahead_.start(start.p, start.v);
  const double to_lift_off = plan_.count == 0 ? gait.pattern.stance_duration : plan_.steps[0].to_lift_off;
  height_ = HeightTrajectory::plan(m.p_com.z(), m.v_c.z(), options_.com_height, to_lift_off);
  if (plan_.count == 0) {
    plan_stand(gait, m);
    return;
  }
  if (options_.kind == PlannerKind::kPaperSplit) {
    append_paper_stance(plan_.steps[0]);
    com_ = path_ahead_;
    plan_attitude(t, to_lift_off, m);
    return;
  }
  for (int k = 0; k < plan_.count; ++k) append_footstep(plan_.steps[static_cast<std::size_t>(k)]);
  if (options_.kind == PlannerKind::kSpline) {
    com_ = path_ahead_;
  } else {
    optimize(start, gait, false);
  }
}

// paper_split, 4.1.2: optimised again from the state measured at lift-off.
void MotionPlanner::plan_swing(double t, const GaitState& gait, const ModelTerms& m) noexcept {
  const Motion<Vec2> start{m.p_com.head<2>(), m.v_c.head<2>(), com_.at(t - com_start_time_).a};
  const Footstep& step = plan_.steps[0];
  height_ = HeightTrajectory::plan(m.p_com.z(), m.v_c.z(), options_.com_height, step.swing_duration);
  plan_attitude(t, step.swing_duration, m);
  com_start_time_ = height_start_time_ = t;
  path_ahead_.start(start.p, start.v);
  if (is_static(step)) {
    path_ahead_.append_cubic(step.swing_duration, start.p, Vec2::Zero());
  } else {
    path_ahead_.append_cubic(step.swing_duration, step.body + 0.5 * step.swing_duration * step.velocity, step.velocity);
  }
  for (int k = 1; k < plan_.count; ++k) append_footstep(plan_.steps[static_cast<std::size_t>(k)]);
  optimize(start, gait, true);
}

// Completes the regularised path by a stop at the centre of the last polygon and optimises.
void MotionPlanner::optimize(const Motion<Vec2>& start, const GaitState& gait, bool from_lift_off) noexcept {
  const double width = options_.zmp.line_half_width;
  ZmpTask task;
  task.start = start;
  task.height = height_;
  const auto add = [&](double duration, const PerLeg<bool>& stance, const PerLeg<Vec2>& feet, int pieces) {
    const bool line = std::count(stance.begin(), stance.end(), true) <= 2;
    task.phase[static_cast<std::size_t>(task.phases++)] = {duration, pieces, support_polygon(stance, feet, width),
                                                           line ? 0.0 : options_.zmp.margin};
  };
  for (int k = 0; k < plan_.count; ++k) {
    const Footstep& step = plan_.steps[static_cast<std::size_t>(k)];
    if (k > 0 || !from_lift_off) add(step.to_lift_off, kAllStand, step.feet, kStancePieces);
    add(step.swing_duration, standing(step), step.feet, kSwingPieces);
  }
  const PerLeg<Vec2>& last = plan_.steps[static_cast<std::size_t>(plan_.count) - 1].footholds;
  add(gait.pattern.stance_duration, kAllStand, last, kStancePieces);
  task.end = center_of(last);
  path_ahead_.append_cubic(gait.pattern.stance_duration, task.end, Vec2::Zero());
  com_ = path_ahead_;
  zmp_report_ = optimizer_.solve(task, path_ahead_, com_);
  zmp_planned_ = true;
}

void MotionPlanner::plan_attitude(double t, double duration, const ModelTerms& m) noexcept {
  const PathPoint now = path_.at(path_time(t));
  const Eigen::AngleAxisd tilt(Mat3(m.state.R_WB * heading(now.yaw).transpose()));
  tilt_ = tilt.angle() * tilt.axis();
  tilt_rate_ = m.state.omega_WB - Vec3(0.0, 0.0, now.yaw_rate);
  attitude_start_time_ = t;
  attitude_duration_ = duration;
}

// The rates of a rotation vector are an angular velocity and acceleration about one fixed axis; otherwise they are off
// by up to half the tilt (tilt x rate / 2): 10 % at 0.2 rad.
void MotionPlanner::update_attitude(double t) noexcept {
  const PathPoint now = path_.at(path_time(t));
  const Motion<Vec3> tilt =
      cubic_at<Vec3>(t - attitude_start_time_, attitude_duration_, tilt_, tilt_rate_, Vec3::Zero(), Vec3::Zero());
  reference_.R_WB = rotation(tilt.p) * heading(now.yaw);
  reference_.omega = tilt.v;
  if (!stands_) reference_.omega.z() += now.yaw_rate;
  reference_.alpha = tilt.a;
  reference_.path = now.p;
}

const MotionReference& MotionPlanner::update(double t, const GaitState& gait, const ModelTerms& m) noexcept {
  zmp_planned_ = false;
  follow_gait(t, gait);
  if (gait.footstep_begins) plan_footstep(t, gait, m);
  for (int l = 0; l < kLegs; ++l) {
    if (gait.lift_off[l]) {
      const double radius = m.foot[l].p.z() - m.contact[l].p.z();
      reference_.foothold[l] << plan_.steps[0].footholds[l], radius;
      reference_.clamped[l] = plan_.steps[0].clamped[l];
      support_mid_[l] = plan_.steps[0].support_mid[l];
      swing_[l].plan(m.foot[l].p, reference_.foothold[l], gait.pattern.swing_duration, options_.swing);
    }
    if (!gait.stands(l)) reference_.foot[l] = swing_[l].at(gait.swing_time[l]);
  }
  if (options_.kind == PlannerKind::kPaperSplit && gait.lifts_off()) plan_swing(t, gait, m);
  const Motion<Vec2> xy = com_.at(t - com_start_time_);
  const Motion<double> z = height_.at(t - height_start_time_);
  reference_.com = {Vec3(xy.p.x(), xy.p.y(), z.p), Vec3(xy.v.x(), xy.v.y(), z.v), Vec3(xy.a.x(), xy.a.y(), z.a)};
  update_attitude(t);
  return reference_;
}

}  // namespace dob
