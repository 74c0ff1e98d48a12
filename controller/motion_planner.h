// Motion planner, `spline` variant (section 4.1 without the ZMP optimisation): planned once per footstep from the
// measured state, never again at lift-off.
//
// CoM: a cubic over the stance phase from the measured CoM state to c_B - v T_sw / 2 at velocity v, then constant
// velocity through the swing, so that the CoM crosses the centre c_B of the supporting diagonal in mid-swing.
// Footholds: where the feet's nominal positions will be in the middle of the swing after next, plus feedback of the CoM
// velocity and of the distance from the path. Heading and velocity are the path's; positions are relative to the feet
// that stand, so that a push shifts the plan and only the path feedback brings it back.
// Valid for level ground at z = 0 of W (the expected ground; the terrain is unknown to the planner).
#pragma once

#include "controller/cubic.h"
#include "controller/gait_scheduler.h"
#include "controller/reference_path.h"
#include "controller/swing_trajectory.h"
#include "robot/model_terms.h"

namespace dob {

struct PlannerOptions {
  double com_height = 0.40;           // [m] above the expected ground
  double foot_offset_x = 0.287;       // [m] nominal foot position from the CoM, longitudinal
  double foot_offset_y = 0.187;       // [m] lateral
  double velocity_feedback = 0.1;     // [s] foothold shift per CoM velocity error
  double path_feedback = 0.1;         // [-] foothold shift per distance of the supporting diagonal from the path
  double max_path_correction = 0.02;  // [m] largest such shift per footstep
  double start_ramp = 0.5;  // [s] from marching on the spot to the path's speed; path feedback makes up for it
  SwingOptions swing;
};

// What the whole-body controller shall track at this tick.
struct MotionReference {
  Motion<Vec3> com;           // [m, m/s, m/s^2]
  Mat3 R_WB;                  // trunk attitude
  Vec3 omega;                 // [rad/s]
  PerLeg<Motion<Vec3>> foot;  // sphere centre; meaningful for legs that do not stand
  PerLeg<Vec3> foothold;      // [m] planned sphere centre at the last (or present) landing, on the ground
};

class MotionPlanner {
 public:
  // Throws std::invalid_argument naming the option, its value and what is allowed.
  MotionPlanner(const PlannerOptions& options, const GaitOptions& gait, ReferencePath path);

  // Standing at `m`: the feet are where they are, the CoM reference is the measured CoM.
  void reset(const ModelTerms& m) noexcept;

  // Reference at time t [s] of the path.
  const MotionReference& update(double t, const GaitState& gait, const ModelTerms& m) noexcept;

  const MotionReference& reference() const noexcept { return reference_; }
  const ReferencePath& path() const noexcept { return path_; }

 private:
  void plan_footstep(double t, const GaitState& gait, const ModelTerms& m) noexcept;

  PlannerOptions options_;
  GaitOptions gait_;
  ReferencePath path_;
  MotionReference reference_{};
  PerLeg<SwingTrajectory> swing_;
  PerLeg<Vec3> next_foothold_{};
  Motion<Vec3> com_start_{};
  Motion<Vec3> com_end_{};
  double com_start_time_ = 0.0;
  double com_duration_ = 1.0;
};

}  // namespace dob
