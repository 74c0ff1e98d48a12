#include "controller/com_trajectory.h"

#include <algorithm>
#include <cmath>

namespace dob {

void ComTrajectory::start(const Vec2& p, const Vec2& v) noexcept {
  count_ = 0;
  duration_ = 0.0;
  end_ = {p, v, Vec2::Zero()};
}

void ComTrajectory::append_jerk(double duration, const Vec2& a_start, const Vec2& jerk) noexcept {
  Piece& piece = pieces_[static_cast<std::size_t>(count_++)];
  piece = {duration_, {end_.p, end_.v, a_start}, jerk};
  duration_ += duration;
  end_ = on_piece(piece, duration_);
}

// The cubic Hermite segment of cubic.h by its acceleration at the start and its jerk.
void ComTrajectory::append_cubic(double duration, const Vec2& p_end, const Vec2& v_end) noexcept {
  const Vec2 mean = (p_end - end_.p) / duration;
  const Vec2 a = (6.0 * mean - 4.0 * end_.v - 2.0 * v_end) / duration;
  const Vec2 jerk = 6.0 * (end_.v + v_end - 2.0 * mean) / (duration * duration);
  append_jerk(duration, a, jerk);
}

void ComTrajectory::append_constant_velocity(double duration) noexcept {
  append_jerk(duration, Vec2::Zero(), Vec2::Zero());
}

// The acceleration of a cubic is linear, so its ends decide: 6 d / T^2 - 4 v / T and -6 d / T^2 + 2 v / T.
HeightTrajectory HeightTrajectory::plan(double z, double v, double target, double shortest) noexcept {
  constexpr int kMaxSteps = 60;  // 1.1^60 > 300: whatever is finite fits long before
  HeightTrajectory h{z, v, target, shortest};
  for (int i = 0; i < kMaxSteps; ++i) {
    const double T = h.duration;
    const double d = 6.0 * (target - z) / (T * T);
    const double largest = std::max(std::abs(d - 4.0 * v / T), std::abs(2.0 * v / T - d));
    if (largest <= kMaxAcceleration) break;
    h.duration *= 1.1;
  }
  return h;
}

Motion<Vec2> ComTrajectory::on_piece(const Piece& piece, double t) noexcept {
  const double s = t - piece.start;
  const Motion<Vec2>& m = piece.state;
  return {m.p + s * (m.v + s * (m.a / 2.0 + s / 6.0 * piece.jerk)), m.v + s * (m.a + s / 2.0 * piece.jerk),
          m.a + s * piece.jerk};
}

Motion<Vec2> ComTrajectory::at(double t) const noexcept {
  if (t >= duration_) return {end_.p + (t - duration_) * end_.v, end_.v, Vec2::Zero()};
  int i = 0;
  while (i + 1 < count_ && pieces_[static_cast<std::size_t>(i) + 1].start <= t) ++i;
  return on_piece(pieces_[static_cast<std::size_t>(i)], t);
}

}  // namespace dob
