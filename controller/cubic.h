// Cubic Hermite segment x(t), t in [0, T], between two states of position and velocity.
#pragma once

namespace dob {

template <typename T>
struct Motion {
  T p, v, a;  // position [m], velocity [m/s], acceleration [m/s^2]; of angles [rad, rad/s, rad/s^2]
};

// t and duration T [s]. At t > T the motion goes on at the final velocity (zero acceleration). Precondition: duration >
// 0.
template <typename T>
Motion<T> cubic_at(double t, double duration, const T& p0, const T& v0, const T& p1, const T& v1) noexcept {
  if (t >= duration) return {T(p1 + v1 * (t - duration)), v1, T(v1 * 0.0)};
  const double s = t / duration;
  const T d = (p1 - p0) / duration;  // mean velocity
  const T c2 = 3.0 * d - 2.0 * v0 - v1;
  const T c3 = v0 + v1 - 2.0 * d;
  return {T(p0 + duration * s * (v0 + s * (c2 + s * c3))), T(v0 + s * (2.0 * c2 + 3.0 * s * c3)),
          T((2.0 * c2 + 6.0 * s * c3) / duration)};
}

}  // namespace dob
