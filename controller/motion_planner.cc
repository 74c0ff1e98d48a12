#include "controller/motion_planner.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace dob {
namespace {

void require(bool ok, const char* name, double value, const char* allowed) {
  if (!ok || !std::isfinite(value)) {
    throw std::invalid_argument(fmt::format("planner: {} = {}; allowed: {}", name, value, allowed));
  }
}

Mat3 heading(double yaw) noexcept {
  return Eigen::AngleAxisd(yaw, Vec3::UnitZ()).toRotationMatrix();
}

}  // namespace

MotionPlanner::MotionPlanner(const PlannerOptions& o, const GaitOptions& gait, ReferencePath path)
    : options_(o), gait_(gait), path_(std::move(path)) {
  require(o.com_height > 0.0, "com_height_m", o.com_height, "> 0");
  require(o.foot_offset_x > 0.0, "foot_offset_x_m", o.foot_offset_x, "> 0");
  require(o.foot_offset_y > 0.0, "foot_offset_y_m", o.foot_offset_y, "> 0");
  require(o.velocity_feedback >= 0.0, "velocity_feedback_s", o.velocity_feedback, ">= 0");
  require(o.path_feedback >= 0.0 && o.path_feedback <= 1.0, "path_feedback", o.path_feedback, "0 to 1");
  require(o.max_path_correction >= 0.0, "max_path_correction_m", o.max_path_correction, ">= 0");
  require(o.start_ramp >= 0.0, "start_ramp_s", o.start_ramp, ">= 0");
  require(o.swing.step_height > 0.0, "step_height_m", o.swing.step_height, "> 0");
  require(o.swing.landing_offset >= 0.0 && o.swing.landing_offset < o.swing.step_height, "landing_offset_m",
          o.swing.landing_offset, "0 to step_height_m");
  require(o.swing.descent_speed > 0.0, "descent_speed_m_s", o.swing.descent_speed, "> 0");
}

void MotionPlanner::reset(const ModelTerms& m) noexcept {
  com_start_ = {m.p_com, m.v_c.head<3>(), Vec3::Zero()};
  com_end_ = com_start_;
  com_start_time_ = 0.0;
  for (int l = 0; l < kLegs; ++l) {
    reference_.foothold[l] = m.foot[l].p;
    reference_.foot[l] = {m.foot[l].p, Vec3::Zero(), Vec3::Zero()};
    next_foothold_[l] = m.foot[l].p;
  }
}

void MotionPlanner::plan_footstep(double t, const GaitState& gait, const ModelTerms& m) noexcept {
  const double to_lift_off = std::max(gait_.stance_duration - gait.footstep_time, 0.1 * gait_.stance_duration);
  const double half_swing = 0.5 * gait_.swing_duration;
  const double t_mid = t + to_lift_off + half_swing;  // the CoM crosses the supporting diagonal
  const double t_next_mid = t_mid + gait_.stance_duration + gait_.swing_duration;
  const PathPoint mid = path_.at(t_mid);
  const PathPoint next_mid = path_.at(t_next_mid);
  const double ramp = t < options_.start_ramp ? t / options_.start_ramp : 1.0;
  const Vec2 velocity = ramp * mid.v;

  Vec2 center = Vec2::Zero();
  for (int l = 0; l < kLegs; ++l) {
    if (!gait.next_swing[l]) center += 0.5 * m.foot[l].p.head<2>();
  }
  com_start_ = {m.p_com, m.v_c.head<3>(), Vec3::Zero()};
  com_start_time_ = t;
  com_duration_ = to_lift_off;
  com_end_.p << center - velocity * half_swing, options_.com_height;
  com_end_.v << velocity, 0.0;

  Vec2 correction = options_.path_feedback * (mid.p - center);
  if (correction.norm() > options_.max_path_correction) correction *= options_.max_path_correction / correction.norm();
  const Vec2 next_center =
      center + ramp * (next_mid.p - mid.p) + correction + options_.velocity_feedback * (m.v_c.head<2>() - velocity);
  const Mat3 R = heading(next_mid.yaw);
  for (int l = 0; l < kLegs; ++l) {
    if (!gait.next_swing[l]) continue;
    const bool front = l == 0 || l == 1;
    const bool left = l == 0 || l == 2;
    const Vec3 offset(front ? options_.foot_offset_x : -options_.foot_offset_x,
                      left ? options_.foot_offset_y : -options_.foot_offset_y, 0.0);
    const double radius = m.foot[l].p.z() - m.contact[l].p.z();
    next_foothold_[l] << next_center + (R * offset).head<2>(), radius;
  }
}

const MotionReference& MotionPlanner::update(double t, const GaitState& gait, const ModelTerms& m) noexcept {
  if (gait.footstep_begins) plan_footstep(t, gait, m);
  for (int l = 0; l < kLegs; ++l) {
    if (gait.lift_off[l]) {
      swing_[l].plan(m.foot[l].p, next_foothold_[l], gait_.swing_duration, options_.swing);
      reference_.foothold[l] = next_foothold_[l];
    }
    if (!gait.stands(l)) reference_.foot[l] = swing_[l].at(gait.swing_time[l]);
  }
  reference_.com =
      cubic_at<Vec3>(t - com_start_time_, com_duration_, com_start_.p, com_start_.v, com_end_.p, com_end_.v);
  const PathPoint now = path_.at(t);
  reference_.R_WB = heading(now.yaw);
  reference_.omega = Vec3(0.0, 0.0, now.yaw_rate);
  return reference_;
}

}  // namespace dob
