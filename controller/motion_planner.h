// Motion planner (section 4.1): what CoM, trunk and feet shall do, from the measured state and the commanded path.
//
// Three planners of the CoM's horizontal motion share footholds, swing feet and height:
//   zmp          ours: the ZMP optimisation (zmp_plan.h) once per footstep, over stance and swing together
//   spline       once per footstep: a cubic over the stance phase, then constant velocity, no look at the ZMP
//   paper_split  section 4.1 to the letter: a cubic to the centre of the support polygon during stance (4.1.1), the
//                ZMP optimisation again at every lift-off (4.1.2), trunk attitude re-planned by a cubic as well
// The regularised path that the optimisation stays close to is the spline planner's motion, footstep after footstep.
// It crosses the supporting diagonal of a trot in mid-swing; with three feet down (crawl) it rests inside the
// triangle. While the gait stands the path waits. A lift-off that waits for a late foot does not re-time the plan: the
// CoM goes on as planned. Valid for level ground at z = 0 of W.
#pragma once

#include "controller/com_trajectory.h"
#include "controller/cubic.h"
#include "controller/footstep_plan.h"
#include "controller/gait_scheduler.h"
#include "controller/reference_path.h"
#include "controller/swing_trajectory.h"
#include "controller/zmp_plan.h"
#include "robot/model_terms.h"

namespace dob {

enum class PlannerKind { kZmp, kSpline, kPaperSplit };

constexpr std::string_view to_string(PlannerKind kind) noexcept {
  constexpr std::array<std::string_view, 3> kNames{"zmp", "spline", "paper_split"};
  return kNames[static_cast<std::size_t>(kind)];
}

struct PlannerOptions {
  PlannerKind kind = PlannerKind::kZmp;
  double com_height = 0.40;  // [m] above the expected ground
  int horizon = 2;           // footsteps that the ZMP optimisation looks ahead, 1 to kMaxHorizon
  FootstepOptions footsteps;
  ZmpOptions zmp;
  SwingOptions swing;
};

// Samples of one ZMP optimisation while the gait keeps to `pattern`: 0 for the spline planner, else at most
// kMaxZmpSamples.
double zmp_samples(const PlannerOptions& options, const GaitPattern& pattern) noexcept;

// What the whole-body controller shall track at this tick.
struct MotionReference {
  Motion<Vec3> com;           // [m, m/s, m/s^2]
  Mat3 R_WB;                  // trunk attitude
  Vec3 omega;                 // [rad/s]
  Vec3 alpha = Vec3::Zero();  // [rad/s^2]
  Vec2 path = Vec2::Zero();   // [m] where the commanded path says the CoM should be, never re-planned
  PerLeg<Motion<Vec3>> foot;  // sphere centre; meaningful for legs that do not stand
  PerLeg<Vec3> foothold;      // [m] planned sphere centre at the last (or present) landing, on the ground
  PerLeg<bool> clamped{};     // that foothold was out of the leg's reach and has been moved
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
  const PlannerOptions& options() const noexcept { return options_; }
  bool zmp_planned() const noexcept { return zmp_planned_; }  // an optimisation was due at the last update
  // Of the last optimisation. A status other than kOptimal: the regularised path is walked instead.
  const ZmpReport& zmp_report() const noexcept { return zmp_report_; }

 private:
  double path_time(double t) const noexcept { return t - stood_; }
  void follow_gait(double t, const GaitState& gait) noexcept;
  void plan_footstep(double t, const GaitState& gait, const ModelTerms& m) noexcept;
  void plan_stand(const GaitState& gait, const ModelTerms& m) noexcept;
  void plan_swing(double t, const GaitState& gait, const ModelTerms& m) noexcept;
  void append_paper_stance(const Footstep& step) noexcept;
  void append_footstep(const Footstep& step) noexcept;
  void append_swing(const Footstep& step) noexcept;
  void optimize(const Motion<Vec2>& start, const GaitState& gait, bool from_lift_off) noexcept;
  void plan_attitude(double t, double duration, const ModelTerms& m) noexcept;
  void update_attitude(double t) noexcept;

  PlannerOptions options_;
  ReferencePath path_;
  MotionReference reference_{};
  PerLeg<SwingTrajectory> swing_;
  FootstepPlan plan_;
  ComTrajectory com_, path_ahead_;
  HeightTrajectory height_;
  ZmpOptimizer optimizer_;
  ZmpReport zmp_report_;
  bool zmp_planned_ = false;
  double com_start_time_ = 0.0, height_start_time_ = 0.0;
  bool stands_ = true;            // the gait is "stand"
  double last_time_ = 0.0;        // [s] of the last update
  double stood_ = 0.0;            // [s] spent standing, by which the path is late
  double ramp_start_ = 0.0;       // [s] of the path: the end of the last stand
  PerLeg<double> support_mid_{};  // [s] of the path: when each foot is, or was, in the middle of its support
  // paper_split: rotation vector from the path's heading to the reference, a cubic to zero.
  Vec3 tilt_ = Vec3::Zero(), tilt_rate_ = Vec3::Zero();  // [rad, rad/s] at the start
  double attitude_start_time_ = 0.0, attitude_duration_ = 1.0;
};

// Zero-moment point of a CoM motion above the ground z = 0, eqs (10), (11) with L_dot = 0 [m].
Vec2 zero_moment_point(const Motion<Vec3>& com) noexcept;

}  // namespace dob
