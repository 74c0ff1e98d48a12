// The ZMP optimisation of section 4.1.2: horizontal CoM motion as cubics that are joined with continuous acceleration,
// over a sequence of stance and swing phases. It minimises the deviation from a regularised path
//     sum over samples of |p - p_reg|^2 / sigma_p^2 + |v - v_reg|^2 / sigma_v^2  +  sum over pieces of |j|^2 /
//     sigma_j^2
// (each sum as a mean over time) subject to
//  - position, velocity and acceleration given at the start,
//  - at the end: position given, velocity and acceleration zero, so that the robot can stop and stand,
//  - the ZMP inside the support polygon at every sample, one row per edge: eqs (10), (11) with L_dot = 0,
//        n^T (p - z / (g + z_dd) a) - s <= offset - margin,     s >= 0 with a quadratic and a linear penalty.
// The height is planned first (and kept from falling: HeightTrajectory), so the rows are linear; one slack s for all
// rows keeps the problem feasible.
#pragma once

#include <memory>

#include "controller/com_trajectory.h"
#include "controller/footstep_plan.h"
#include "controller/qp.h"
#include "controller/support_polygon.h"

namespace dob {

struct ZmpOptions {
  double line_half_width = 0.03;  // [m] of the rectangle that two standing feet's line is widened to
  double margin = 0.0;            // [m] by which polygons of three and four feet are shrunk
  double sample = 0.010;          // [s] distance of the ZMP rows
  double sigma_position = 0.01;   // [m] weights of the cost
  double sigma_velocity = 0.1;    // [m/s]
  double sigma_jerk = 20.0;       // [m/s^3]
};

struct ZmpPhase {
  double duration = 0.0;  // [s]
  int pieces = 1;         // cubics of equal duration
  SupportPolygon polygon;
  double margin = 0.0;  // [m]
};

inline constexpr int kMaxZmpPhases = 2 * kMaxHorizon + 1;
inline constexpr int kStancePieces = 3;
inline constexpr int kSwingPieces = 2;
inline constexpr int kMaxZmpSamples = 300;  // over all phases; validated against the gait by MotionPlanner

struct ZmpTask {
  Motion<Vec2> start;
  Vec2 end;
  HeightTrajectory height;
  int phases = 0;
  std::array<ZmpPhase, kMaxZmpPhases> phase;
};

struct ZmpReport {
  QpStatus status = QpStatus::kInvalidInput;
  int iterations = 0;
  int active_rows = 0;  // ZMP rows that hold with equality
  double slack = 0.0;   // [m] s at the optimum
};

class ZmpOptimizer {
 public:
  // `horizon`: footsteps, 1 to kMaxHorizon; decides the size of the problem once and for all.
  ZmpOptimizer(const ZmpOptions& options, int horizon);
  ~ZmpOptimizer();
  ZmpOptimizer(ZmpOptimizer&&) noexcept;
  ZmpOptimizer& operator=(ZmpOptimizer&&) noexcept;

  // Writes the optimum to `motion`, which is left alone if the status is not kOptimal. No heap.
  // Precondition: the task has at most 2 horizon + 1 phases and kMaxZmpSamples samples.
  ZmpReport solve(const ZmpTask& task, const ComTrajectory& path, ComTrajectory& motion) noexcept;

 private:
  struct Program;
  std::unique_ptr<Program> program_;
};

}  // namespace dob
