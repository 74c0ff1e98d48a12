// Support polygon of the standing feet on level ground, as half-planes.
#pragma once

#include "robot/types.h"

namespace dob {

// n_i^T x <= offset_i for every edge i, n_i unit vectors that point outwards. No edges: nothing stands.
struct SupportPolygon {
  static constexpr int kMaxEdges = kLegs;

  int edges = 0;
  std::array<Vec2, kMaxEdges> normal;
  std::array<double, kMaxEdges> offset{};  // [m]

  // Distance of x [m] to the nearest edge, negative outside; -infinity without edges.
  double margin(const Vec2& x) const noexcept;
};

// Convex hull of three or four feet. Two feet span only a line, which is widened to a rectangle of the given half
// width (section 5.3), and one foot a point, which becomes a square of that half width.
SupportPolygon support_polygon(const PerLeg<bool>& stance, const PerLeg<Vec2>& feet, double half_width) noexcept;

// A point whose margin is at least `margin` [m], near x; x itself if it is one. If the polygon has no such point, one
// near its centre.
Vec2 move_inside(const SupportPolygon& polygon, const Vec2& x, double margin) noexcept;

}  // namespace dob
