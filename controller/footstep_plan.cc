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

// How many footsteps after `step` the leg swings next.
int footsteps_until_swing(Gait gait, int step, int leg) noexcept {
  const int cycle = footsteps_per_cycle(gait);
  int k = 0;
  while (k < cycle && !swing_legs(gait, step + k)[leg]) ++k;
  return k;
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
  Planner(const FootstepOptions& o, const ReferencePath& path, double t, const GaitState& gait,
          const ModelTerms& m) noexcept
      : o_(o), path_(path), pattern_(gait.pattern), m_(m), ramp_(t < o.start_ramp ? t / o.start_ramp : 1.0) {}

  // The footstep number `step` of the gait that begins at t with the feet at `feet`.
  Footstep plan(int step, double t, double to_lift_off, const PerLeg<Vec2>& feet, bool first) const noexcept {
    Footstep s;
    s.swings = swing_legs(pattern_.gait, step);
    s.to_lift_off = to_lift_off;
    s.swing_duration = pattern_.swing_duration;
    s.feet = feet;
    s.footholds = feet;
    const double lift_off = t + to_lift_off;
    const double mid = lift_off + 0.5 * pattern_.swing_duration;
    const PathPoint at_mid = path_.at(mid);
    s.velocity = ramp_ * at_mid.v;
    s.body = body(step, lift_off, at_mid, feet, s.swings);
    Vec2 shift = Vec2::Zero();
    if (first) shift = feedback(at_mid, s.body, s.velocity);
    for (int l = 0; l < kLegs; ++l) {
      if (!s.swings[l]) continue;
      const PathPoint support_mid = path_.at(lift_off + pattern_.swing_duration + 0.5 * pattern_.support_duration());
      const Vec2 center = s.body + ramp_ * (support_mid.p - at_mid.p);
      s.footholds[l] = center + turned(support_mid.yaw, nominal_offset(o_, l)) + shift;
      s.clamped[l] = clamp(l, center, support_mid, s.velocity, s.footholds[l]);
    }
    return s;
  }

 private:
  Vec2 body(int step, double lift_off, const PathPoint& at_mid, const PerLeg<Vec2>& feet,
            const PerLeg<bool>& swings) const noexcept {
    Vec2 sum = Vec2::Zero();
    int standing = 0;
    for (int l = 0; l < kLegs; ++l) {
      if (swings[l]) continue;
      const double next_lift_off =
          lift_off + footsteps_until_swing(pattern_.gait, step, l) * pattern_.footstep_duration();
      const PathPoint support_mid = path_.at(next_lift_off - 0.5 * pattern_.support_duration());
      sum += feet[l] - turned(support_mid.yaw, nominal_offset(o_, l)) + ramp_ * (at_mid.p - support_mid.p);
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
  const GaitPattern& pattern_;
  const ModelTerms& m_;
  double ramp_;
};

}  // namespace

FootstepPlan plan_footsteps(const FootstepOptions& options, const ReferencePath& path, double t, const GaitState& gait,
                            const ModelTerms& m, int count) noexcept {
  FootstepPlan plan;
  if (gait.pattern.gait == Gait::kStand) return plan;
  constexpr double kShortest = 0.1;  // of the stance phase: time left for the CoM when a footstep begins late
  const double stance = gait.pattern.stance_duration;
  const Planner planner(options, path, t, gait, m);
  PerLeg<Vec2> feet;
  for (int l = 0; l < kLegs; ++l) feet[l] = m.foot[l].p.head<2>();
  double to_lift_off = std::max(stance - gait.footstep_time, kShortest * stance);
  for (int k = 0; k < std::min(count, kMaxHorizon); ++k) {
    const Footstep step = planner.plan(gait.step + k, t, to_lift_off, feet, k == 0);
    plan.steps[static_cast<std::size_t>(k)] = step;
    ++plan.count;
    feet = step.footholds;
    t += to_lift_off + gait.pattern.swing_duration;
    to_lift_off = stance;
  }
  return plan;
}

}  // namespace dob
