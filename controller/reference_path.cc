#include "controller/reference_path.h"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace dob {

ReferencePath::ReferencePath(const std::vector<PathSegment>& segments) {
  if (segments.empty()) throw std::invalid_argument("path: no segments; at least one is needed");
  Piece piece{0.0, 0.0, 0.0, 0.0, Vec2::Zero()};
  for (const PathSegment& segment : segments) {
    if (!(segment.duration > 0.0) || !std::isfinite(segment.duration) || !std::isfinite(segment.speed) ||
        !std::isfinite(segment.yaw_rate)) {
      throw std::invalid_argument(
          fmt::format("path: segment of {} s at {} m/s, {} rad/s; the duration must be positive and all three finite",
                      segment.duration, segment.speed, segment.yaw_rate));
    }
    piece.speed = segment.speed;
    piece.yaw_rate = segment.yaw_rate;
    pieces_.push_back(piece);
    const PathPoint end = on_piece(piece, piece.start + segment.duration);
    piece.start += segment.duration;
    piece.yaw = end.yaw;
    piece.p = end.p;
    length_ += std::abs(segment.speed) * segment.duration;
  }
  duration_ = piece.start;
}

PathPoint ReferencePath::on_piece(const Piece& piece, double t) noexcept {
  const double s = t - piece.start;
  const double turn = piece.yaw_rate * s;
  const double mean_yaw = piece.yaw + 0.5 * turn;  // direction of the chord
  const double shrink = std::abs(turn) < 1e-6 ? 1.0 - turn * turn / 24.0 : std::sin(0.5 * turn) / (0.5 * turn);
  PathPoint point;
  point.yaw = piece.yaw + turn;
  point.yaw_rate = piece.yaw_rate;
  point.p = piece.p + piece.speed * s * shrink * Vec2(std::cos(mean_yaw), std::sin(mean_yaw));
  point.v = piece.speed * Vec2(std::cos(point.yaw), std::sin(point.yaw));
  return point;
}

PathPoint ReferencePath::at(double t) const noexcept {
  const Piece* piece = &pieces_.front();
  for (const Piece& next : pieces_) {
    if (next.start > t) break;
    piece = &next;
  }
  return on_piece(*piece, t);
}

}  // namespace dob
