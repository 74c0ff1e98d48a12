#include "controller/footstep_plan.h"

#include <algorithm>
#include <cmath>

namespace dob {
namespace {

Vec2 turned(double yaw, const Vec2& x) noexcept {
  return Eigen::Rotation2Dd(yaw) * x;
}

Vec2 nominal_offset(const FootstepOptions& o, int leg) noexcept {
  const bool front = leg == static_cast<int>(Leg::kLF) || leg == static_cast<int>(Leg::kRF);
  const bool left = leg == static_cast<int>(Leg::kLF) || leg == static_cast<int>(Leg::kLH);
  return {front ? o.foot_offset_x : -o.foot_offset_x, left ? o.foot_offset_y : -o.foot_offset_y};
}

// Largest horizontal distance of a foothold from below the hip [m]: what the leg reaches at the hip's present height,
// less what the body moves ahead of the foot until it lifts off again.
double reach(const FootstepOptions& o, const ModelTerms& m, int leg, double travel) noexcept {
  const auto& links = m.link[leg];
  const Vec3& hip = links[static_cast<int>(LegLink::kUpper)].p_WL;
  const Vec3& knee = links[static_cast<int>(LegLink::kLower)].p_WL;
  const double length = o.max_reach * ((knee - hip).norm() + (m.foot[leg].p - knee).norm());
  const double radius = m.foot[leg].p.z() - m.contact[leg].p.z();
  const double height = hip.z() - radius;
  return std::sqrt(std::max(0.0, length * length - height * height)) - travel;
}

class Planner {
 public:
  Planner(const FootstepOptions& o, const ReferencePath& path, double ramp, const GaitPattern& pattern,
          const ModelTerms& m) noexcept
      : o_(o), path_(path), ramp_(ramp), pattern_(pattern), m_(m) {}

  // The footstep number `step` of the gait that begins at t with the feet at `feet`.
  Footstep plan(int step, double t, double to_lift_off, const PerLeg<Vec2>& feet, const PerLeg<double>& support_mid,
                bool first) const noexcept {
    Footstep s;
    s.swings = swing_legs(pattern_.gait, step);
    s.to_lift_off = to_lift_off;
    s.swing_duration = pattern_.swing_duration;
    s.feet = feet;
    s.footholds = feet;
    s.support_mid = support_mid;
    const double mid = t + to_lift_off + 0.5 * pattern_.swing_duration;
    const double next_mid = mid + 0.5 * (pattern_.swing_duration + pattern_.support_duration());
    const PathPoint at_mid = path_.at(mid);
    const PathPoint at_next_mid = path_.at(next_mid);
    s.velocity = ramp_ * at_mid.v;
    s.body = body(at_mid, s);
    const Vec2 shift = first ? feedback(at_mid, s.body, s.velocity) : Vec2(Vec2::Zero());
    const Vec2 center = s.body + ramp_ * (at_next_mid.p - at_mid.p);
    for (int l = 0; l < kLegs; ++l) {
      if (!s.swings[l]) continue;
      s.support_mid[l] = next_mid;
      s.footholds[l] = center + turned(at_next_mid.yaw, nominal_offset(o_, l)) + shift;
      s.clamped[l] = clamp(l, center, at_next_mid, s.velocity, s.footholds[l]);
    }
    return s;
  }

 private:
  Vec2 body(const PathPoint& at_mid, const Footstep& s) const noexcept {
    const bool line = std::count(s.swings.begin(), s.swings.end(), true) >= 2;
    Vec2 sum = Vec2::Zero();
    int standing = 0;
    for (int l = 0; l < kLegs; ++l) {
      if (s.swings[l]) continue;
      const PathPoint support_mid = line ? at_mid : path_.at(s.support_mid[l]);
      sum += s.feet[l] - turned(support_mid.yaw, nominal_offset(o_, l)) + ramp_ * (at_mid.p - support_mid.p);
      ++standing;
    }
    return standing == 0 ? at_mid.p : Vec2(sum / standing);
  }

  Vec2 feedback(const PathPoint& at_mid, const Vec2& body, const Vec2& velocity) const noexcept {
    Vec2 correction = o_.path_feedback * (at_mid.p - body);
    const double size = correction.norm();
    if (size > o_.max_path_correction) correction *= o_.max_path_correction / size;
    return correction + o_.velocity_feedback * (m_.v_c.head<2>() - velocity);
  }

  // To the circle that the leg reaches while the body is where the path and the standing feet say.
  bool clamp(int leg, const Vec2& center, const PathPoint& support_mid, const Vec2& velocity,
             Vec2& foothold) const noexcept {
    const Vec3 hip_from_com = m_.link[leg][static_cast<int>(LegLink::kUpper)].p_WL - m_.p_com;
    const Vec3 hip_B = m_.state.R_WB.transpose() * hip_from_com;
    const Vec2 hip = center + turned(support_mid.yaw, hip_B.head<2>());
    const double radius = std::max(0.0, reach(o_, m_, leg, 0.5 * velocity.norm() * pattern_.support_duration()));
    const Vec2 from_hip = foothold - hip;
    const double distance = from_hip.norm();
    if (distance <= radius) return false;
    foothold = hip + from_hip * (radius / distance);
    return true;
  }

  const FootstepOptions& o_;
  const ReferencePath& path_;
  double ramp_;
  const GaitPattern& pattern_;
  const ModelTerms& m_;
};

}  // namespace

FootstepPlan plan_footsteps(const FootstepOptions& options, const ReferencePath& path, const FootstepStart& start,
                            const GaitState& gait, const ModelTerms& m, int count) noexcept {
  FootstepPlan plan;
  if (gait.pattern.gait == Gait::kStand) return plan;
  constexpr double kShortest = 0.1;  // of the stance phase: time left for the CoM when a footstep begins late
  const double stance = gait.pattern.stance_duration;
  const Planner planner(options, path, start.ramp, gait.pattern, m);
  PerLeg<Vec2> feet;
  for (int l = 0; l < kLegs; ++l) feet[l] = m.foot[l].p.head<2>();
  PerLeg<double> support_mid = start.support_mid;
  double t = start.t;
  double to_lift_off = std::max(stance - gait.footstep_time, kShortest * stance);
  for (int k = 0; k < std::min(count, kMaxHorizon); ++k) {
    const Footstep step = planner.plan(gait.step + k, t, to_lift_off, feet, support_mid, k == 0);
    plan.steps[static_cast<std::size_t>(k)] = step;
    ++plan.count;
    feet = step.footholds;
    support_mid = step.support_mid;
    t += to_lift_off + gait.pattern.swing_duration;
    to_lift_off = stance;
  }
  return plan;
}

}  // namespace dob
