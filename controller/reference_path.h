// The commanded path: straight and curved pieces driven at constant speed and yaw rate. It is never re-planned;
// path_error is measured against it.
#pragma once

#include <vector>

#include "robot/types.h"

namespace dob {

struct PathSegment {
  double duration = 0.0;  // [s] > 0
  double speed = 0.0;     // [m/s] along the heading
  double yaw_rate = 0.0;  // [rad/s] positive to the left
};

struct PathPoint {
  Vec2 p;           // [m] in W
  double yaw;       // [rad] heading, 0 along x of W
  Vec2 v;           // [m/s] in W
  double yaw_rate;  // [rad/s]
};

class ReferencePath {
 public:
  // Starts at the origin of W with heading 0. Throws std::invalid_argument for an empty path, a duration that is
  // not positive, or values that are not finite.
  explicit ReferencePath(const std::vector<PathSegment>& segments);

  // Closed form on every segment (arcs); after the end the last segment goes on, before 0 the first.
  PathPoint at(double t) const noexcept;

  double duration() const noexcept { return duration_; }  // [s]
  double length() const noexcept { return length_; }      // [m]

 private:
  struct Piece {
    double start, speed, yaw_rate, yaw;
    Vec2 p;
  };
  static PathPoint on_piece(const Piece& piece, double t) noexcept;

  std::vector<Piece> pieces_;
  double duration_ = 0.0;
  double length_ = 0.0;
};

}  // namespace dob
