#include "controller/support_polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dob {
namespace {

constexpr double kSmallest = 1e-6;  // [m] feet closer than this are one, and count as on the line

void add_edge(SupportPolygon& polygon, const Vec2& outward, const Vec2& point) noexcept {
  polygon.normal[polygon.edges] = outward;
  polygon.offset[polygon.edges] = outward.dot(point);
  ++polygon.edges;
}

SupportPolygon rectangle(const Vec2& a, const Vec2& b, double half_width) noexcept {
  const double length = (b - a).norm();
  const Vec2 along = length > kSmallest ? Vec2((b - a) / length) : Vec2::UnitX();
  const Vec2 across(-along.y(), along.x());
  const double beyond = length > kSmallest ? 0.0 : half_width;
  SupportPolygon polygon;
  add_edge(polygon, across, a + half_width * across);
  add_edge(polygon, -across, a - half_width * across);
  add_edge(polygon, along, b + beyond * along);
  add_edge(polygon, -along, a - beyond * along);
  return polygon;
}

}  // namespace

double SupportPolygon::margin(const Vec2& x) const noexcept {
  double nearest = edges == 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
  for (int i = 0; i < edges; ++i) nearest = std::min(nearest, offset[i] - normal[i].dot(x));
  return nearest;
}

SupportPolygon support_polygon(const PerLeg<bool>& stance, const PerLeg<Vec2>& feet, double half_width) noexcept {
  std::array<Vec2, kLegs> p;
  int n = 0;
  for (int l = 0; l < kLegs; ++l) {
    if (stance[l]) p[n++] = feet[l];
  }
  if (n == 0) return {};
  if (n <= 2) return rectangle(p[0], p[n - 1], half_width);
  // A pair of feet is an edge if all the others are on one side of its line.
  SupportPolygon hull;
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      const Vec2 along = p[j] - p[i];
      if (along.norm() < kSmallest) continue;
      const Vec2 normal = Vec2(along.y(), -along.x()).normalized();
      double highest = 0.0;
      double lowest = 0.0;
      for (int k = 0; k < n; ++k) {
        highest = std::max(highest, normal.dot(p[k] - p[i]));
        lowest = std::min(lowest, normal.dot(p[k] - p[i]));
      }
      if (hull.edges == SupportPolygon::kMaxEdges) break;
      if (highest <= kSmallest) add_edge(hull, normal, p[i]);
      if (lowest >= -kSmallest && hull.edges < SupportPolygon::kMaxEdges) add_edge(hull, -normal, p[i]);
    }
  }
  return hull;
}

Vec2 move_inside(const SupportPolygon& polygon, const Vec2& x, double margin) noexcept {
  constexpr int kSweeps = 20;  // each edge in turn; three or four edges at angles of tens of degrees settle in a few
  Vec2 inside = x;
  for (int sweep = 0; sweep < kSweeps && polygon.margin(inside) < margin; ++sweep) {
    for (int i = 0; i < polygon.edges; ++i) {
      const double excess = polygon.normal[i].dot(inside) - polygon.offset[i] + margin;
      if (excess > 0.0) inside -= excess * polygon.normal[i];
    }
  }
  return inside;
}

}  // namespace dob
