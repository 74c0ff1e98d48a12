#include "controller/swing_trajectory.h"

#include <algorithm>

namespace dob {

void SwingTrajectory::plan(const Vec3& lift_off, const Vec3& landing, double duration,
                           const SwingOptions& options) noexcept {
  start_ = lift_off;
  landing_ = landing;
  duration_ = duration;
  apex_ = std::max(lift_off.z(), landing.z()) + options.step_height;
  target_z_ = landing.z() - options.landing_offset;
  descent_speed_ = options.descent_speed;
}

Motion<Vec3> SwingTrajectory::at(double t) const noexcept {
  const Vec2 zero = Vec2::Zero();
  const Motion<Vec2> xy = cubic_at<Vec2>(t, duration_, start_.head<2>(), zero, landing_.head<2>(), zero);
  const double half = 0.5 * duration_;
  Motion<double> z;
  if (t < half) {
    z = cubic_at(t, half, start_.z(), 0.0, apex_, 0.0);
  } else if (t < duration_) {
    z = cubic_at(t - half, half, apex_, 0.0, target_z_, 0.0);
  } else {
    z = {target_z_ - descent_speed_ * (t - duration_), -descent_speed_, 0.0};
  }
  return {Vec3(xy.p.x(), xy.p.y(), z.p), Vec3(xy.v.x(), xy.v.y(), z.v), Vec3(xy.a.x(), xy.a.y(), z.a)};
}

}  // namespace dob
