// Arithmetic on several legs at once: every quantity below holds one value per lane, and all lanes go through the same
// operations. The four legs are identical chains, so that two passes in the 128-bit registers that every x86-64 has, or
// one in the 256-bit registers of AVX2, replace four scalar ones. Plain value types for the inside of Model; nothing
// here knows about robots.
#pragma once

#include <array>
#include <cstring>
#include <utility>

#include "robot/types.h"

namespace dob {

// What the compiler may use decides: the CMake option DOB_FAST_MODEL gives it AVX2 and FMA, in every file of the
// program, because Eigen's types are aligned differently there and inline functions must not exist in two versions.
#if defined(__AVX2__) && defined(__FMA__)
inline constexpr int kLanes = 4;
#else
inline constexpr int kLanes = 2;
#endif

// Vector extension of GCC and Clang: element-wise + - * /, scalars are broadcast, [i] is lane i.
using Lanes = double __attribute__((vector_size(kLanes * sizeof(double))));

inline Lanes broadcast(double x) noexcept {
  return x - Lanes{};
}
// Lanes of numbers that lie `stride` apart in memory.
template <std::size_t stride>
inline Lanes gather_lanes(const double* first) noexcept {
  return [first]<std::size_t... n>(std::index_sequence<n...>) {
    return Lanes{first[stride * n]...};
  }
  (std::make_index_sequence<kLanes>{});
}
// Lane n of the result is lane n + 1 of x, the last one its first.
inline Lanes rotate_lanes(Lanes x) noexcept {
  return [x]<std::size_t... n>(std::index_sequence<n...>) {
    return Lanes{x[(n + 1) % kLanes]...};
  }
  (std::make_index_sequence<kLanes>{});
}
inline double sum_lanes(Lanes x) noexcept {
  double sum = x[0];
  for (int n = 1; n < kLanes; ++n) sum += x[n];
  return sum;
}

struct LanesVec3 {
  Lanes x, y, z;

  LanesVec3& operator+=(const LanesVec3& b) noexcept {
    x += b.x;
    y += b.y;
    z += b.z;
    return *this;
  }
};

inline LanesVec3 operator+(const LanesVec3& a, const LanesVec3& b) noexcept {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline LanesVec3 operator-(const LanesVec3& a, const LanesVec3& b) noexcept {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline LanesVec3 operator*(Lanes s, const LanesVec3& a) noexcept {
  return {s * a.x, s * a.y, s * a.z};
}
inline LanesVec3 rotate_lanes(const LanesVec3& a) noexcept {
  return {rotate_lanes(a.x), rotate_lanes(a.y), rotate_lanes(a.z)};
}
inline Lanes dot(const LanesVec3& a, const LanesVec3& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline LanesVec3 cross(const LanesVec3& a, const LanesVec3& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct LanesMat3 {
  LanesVec3 c0, c1, c2;  // columns
};

inline LanesVec3 operator*(const LanesMat3& A, const LanesVec3& b) noexcept {
  return {A.c0.x * b.x + A.c1.x * b.y + A.c2.x * b.z, A.c0.y * b.x + A.c1.y * b.y + A.c2.y * b.z,
          A.c0.z * b.x + A.c1.z * b.y + A.c2.z * b.z};
}
inline LanesMat3 operator*(const LanesMat3& A, const LanesMat3& B) noexcept {
  return {A * B.c0, A * B.c1, A * B.c2};
}

// Symmetric 3x3 matrix.
struct LanesSym3 {
  Lanes xx, yy, zz, xy, xz, yz;

  LanesSym3& operator+=(const LanesSym3& b) noexcept {
    xx += b.xx;
    yy += b.yy;
    zz += b.zz;
    xy += b.xy;
    xz += b.xz;
    yz += b.yz;
    return *this;
  }
};

inline LanesSym3 operator*(Lanes s, const LanesSym3& A) noexcept {
  return {s * A.xx, s * A.yy, s * A.zz, s * A.xy, s * A.xz, s * A.yz};
}
inline LanesVec3 operator*(const LanesSym3& A, const LanesVec3& b) noexcept {
  return {A.xx * b.x + A.xy * b.y + A.xz * b.z, A.xy * b.x + A.yy * b.y + A.yz * b.z,
          A.xz * b.x + A.yz * b.y + A.zz * b.z};
}

// R A R^T.
inline LanesSym3 rotate(const LanesMat3& R, const LanesSym3& A) noexcept {
  const LanesMat3 RA{R * LanesVec3{A.xx, A.xy, A.xz}, R * LanesVec3{A.xy, A.yy, A.yz}, R * LanesVec3{A.xz, A.yz, A.zz}};
  const auto entry = [](Lanes a0, Lanes a1, Lanes a2, Lanes b0, Lanes b1, Lanes b2) {
    return a0 * b0 + a1 * b1 + a2 * b2;
  };
  return {entry(RA.c0.x, RA.c1.x, RA.c2.x, R.c0.x, R.c1.x, R.c2.x),
          entry(RA.c0.y, RA.c1.y, RA.c2.y, R.c0.y, R.c1.y, R.c2.y),
          entry(RA.c0.z, RA.c1.z, RA.c2.z, R.c0.z, R.c1.z, R.c2.z),
          entry(RA.c0.x, RA.c1.x, RA.c2.x, R.c0.y, R.c1.y, R.c2.y),
          entry(RA.c0.x, RA.c1.x, RA.c2.x, R.c0.z, R.c1.z, R.c2.z),
          entry(RA.c0.y, RA.c1.y, RA.c2.y, R.c0.z, R.c1.z, R.c2.z)};
}

// Between lanes and Eigen.
inline LanesVec3 broadcast(const Vec3& a) noexcept {
  return {broadcast(a.x()), broadcast(a.y()), broadcast(a.z())};
}
inline LanesMat3 broadcast(const Mat3& A) noexcept {
  return {broadcast(Vec3(A.col(0))), broadcast(Vec3(A.col(1))), broadcast(Vec3(A.col(2)))};
}
inline LanesSym3 broadcast_symmetric(const Mat3& A) noexcept {
  return {broadcast(A(0, 0)), broadcast(A(1, 1)), broadcast(A(2, 2)),
          broadcast(A(0, 1)), broadcast(A(0, 2)), broadcast(A(1, 2))};
}
inline void set_lane(LanesVec3& a, int i, const Vec3& value) noexcept {
  a.x[i] = value.x();
  a.y[i] = value.y();
  a.z[i] = value.z();
}
inline void set_lane(LanesSym3& A, int i, const Mat3& value) noexcept {
  A.xx[i] = value(0, 0);
  A.yy[i] = value(1, 1);
  A.zz[i] = value(2, 2);
  A.xy[i] = value(0, 1);
  A.xz[i] = value(0, 2);
  A.yz[i] = value(1, 2);
}
inline Vec3 sum_lanes(const LanesVec3& a) noexcept {
  return {sum_lanes(a.x), sum_lanes(a.y), sum_lanes(a.z)};
}
inline Mat3 sum_lanes(const LanesSym3& A) noexcept {
  const double xy = sum_lanes(A.xy), xz = sum_lanes(A.xz), yz = sum_lanes(A.yz);
  Mat3 s;
  s << sum_lanes(A.xx), xy, xz, xy, sum_lanes(A.yy), yz, xz, yz, sum_lanes(A.zz);
  return s;
}

// Writes lane n to the three numbers in a row at target(n).
template <typename Target>
inline void store(const LanesVec3& a, Target target) noexcept {
  using Pair = double __attribute__((vector_size(2 * sizeof(double))));
  for (int n = 0; n < kLanes; ++n) {
    double* p = target(n);
    const Pair xy{a.x[n], a.y[n]};  // one store of 128 bits
    std::memcpy(p, &xy, sizeof xy);
    p[2] = a.z[n];
  }
}

struct SinCos {
  Lanes sin, cos;
};

// Absolute error below 2e-16 for |x| <= 1e5 rad; NaN stays NaN. Takes a fraction of the time of std::sin and
// std::cos. x is reduced by a multiple of pi/2, which is split in three parts (33, 33 and 53 bits) so that the first
// two products are exact; the remainder r in [-pi/4, pi/4] goes into the Taylor series, cut off below 5e-17.
inline SinCos sincos(Lanes x) noexcept {
  using Bits = long long __attribute__((vector_size(sizeof(Lanes))));
  constexpr double kRound = 0x1.8p52;  // adding it leaves the nearest integer in the last bits
  const Lanes shifted = x * 0x1.45f306dc9c883p-1 + kRound;
  const Lanes n = shifted - kRound;
  const Lanes r = ((x - n * 0x1.921fb544p+0) - n * 0x1.0b4611a6p-34) - n * 0x1.3198a2e037073p-69;
  const Lanes u = r * r;
  Lanes s = broadcast(-1.0 / 1307674368e3);  // -1/15!
  s = s * u + 1.0 / 6227020800.0;
  s = s * u - 1.0 / 39916800.0;
  s = s * u + 1.0 / 362880.0;
  s = s * u - 1.0 / 5040.0;
  s = s * u + 1.0 / 120.0;
  s = s * u - 1.0 / 6.0;
  s = s * u * r + r;
  Lanes c = broadcast(1.0 / 20922789888e3);  // 1/16!
  c = c * u - 1.0 / 87178291200.0;
  c = c * u + 1.0 / 479001600.0;
  c = c * u - 1.0 / 3628800.0;
  c = c * u + 1.0 / 40320.0;
  c = c * u - 1.0 / 720.0;
  c = c * u + 1.0 / 24.0;
  c = c * u - 0.5;
  c = c * u + 1.0;
  // Quarter turns: odd ones exchange sine and cosine, bit 1 of the count becomes the sign.
  const Bits quadrant = reinterpret_cast<Bits>(shifted);
  const Bits odd = -(quadrant & 1);
  const Bits difference = (reinterpret_cast<Bits>(s) ^ reinterpret_cast<Bits>(c)) & odd;
  const Bits sin_sign = (quadrant & 2) << 62;
  const Bits cos_sign = ((quadrant + 1) & 2) << 62;
  return {reinterpret_cast<Lanes>(reinterpret_cast<Bits>(s) ^ difference ^ sin_sign),
          reinterpret_cast<Lanes>(reinterpret_cast<Bits>(c) ^ difference ^ cos_sign)};
}

}  // namespace dob
