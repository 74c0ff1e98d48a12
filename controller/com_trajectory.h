// Motion of the CoM: horizontal as a sequence of cubics (constant jerk on each piece), vertical as one.
#pragma once

#include "controller/cubic.h"
#include "robot/types.h"

namespace dob {

class ComTrajectory {
 public:
  static constexpr int kMaxPieces = 24;

  // Time 0 at this position [m] and velocity [m/s]; no pieces yet.
  void start(const Vec2& p, const Vec2& v) noexcept;

  // Appends a piece of this duration [s] from the present end. Precondition: fewer than kMaxPieces pieces, duration >
  // 0.
  void append_cubic(double duration, const Vec2& p_end, const Vec2& v_end) noexcept;
  void append_constant_velocity(double duration) noexcept;
  void append_jerk(double duration, const Vec2& a_start, const Vec2& jerk) noexcept;

  // At t [s] since reset. After the last piece the motion goes on at the final velocity.
  Motion<Vec2> at(double t) const noexcept;

  const Motion<Vec2>& end() const noexcept { return end_; }  // at the end of the last piece
  double duration() const noexcept { return duration_; }     // [s]

 private:
  struct Piece {
    double start;        // [s]
    Motion<Vec2> state;  // there
    Vec2 jerk;           // [m/s^3]
  };
  static Motion<Vec2> on_piece(const Piece& piece, double t) noexcept;

  std::array<Piece, kMaxPieces> pieces_{};
  int count_ = 0;
  double duration_ = 0.0;
  Motion<Vec2> end_{Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
};

// Height of the CoM, planned before the horizontal motion so that the ZMP rows (10)-(11) are linear: a cubic from the
// measured state to rest at the nominal height, which is held after that.
struct HeightTrajectory {
  double z = 0.0, v = 0.0;  // [m, m/s] at the start
  double target = 0.0;      // [m]
  double duration = 1.0;    // [s] > 0

  // The quickest cubic of at least `shortest` [s] whose acceleration stays within +-kMaxAcceleration: a CoM thrown up
  // or down shall not be asked to fall freely (then it has no ZMP), nor the legs to carry half as much again.
  static constexpr double kMaxAcceleration = 3.0;  // [m/s^2]
  static HeightTrajectory plan(double z, double v, double target, double shortest) noexcept;

  // Height [m] and its rates along z of W at t [s] since the start.
  Motion<double> at(double t) const noexcept { return cubic_at(t, duration, z, v, target, 0.0); }
};

}  // namespace dob
