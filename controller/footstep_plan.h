// Where the next feet go (section 4.1): the footsteps ahead, as far as a horizon, from the feet that stand now.
//
// Every foot lands where its nominal position will be in the middle of its time on the ground, so that the standing
// feet tell where the body should be: b(t) = mean over them of (foot - R offset) moved along the commanded path from
// the middle of their own support to t. With two feet down b in mid-swing is the centre of their line, whatever the
// path says: there is nowhere else to stand. Heading and velocity are the path's, positions relative to the feet, so
// that a push shifts the plan; feedback of the CoM velocity and of the distance from the path acts on the first
// footstep only. Valid for level ground at z = 0 of W (the expected ground; the terrain is unknown to the planner).
#pragma once

#include "controller/gait_scheduler.h"
#include "controller/reference_path.h"
#include "robot/model_terms.h"

namespace dob {

inline constexpr int kMaxHorizon = 3;  // footsteps

struct FootstepOptions {
  double foot_offset_x = 0.287;       // [m] nominal foot position from the CoM, longitudinal
  double foot_offset_y = 0.187;       // [m] lateral
  double velocity_feedback = 0.1;     // [s] foothold shift per CoM velocity error
  double path_feedback = 0.1;         // [-] foothold shift per distance of the body from the path
  double max_path_correction = 0.02;  // [m] largest such shift per footstep
  double start_ramp = 0.5;            // [s] from marching on the spot to the path's speed
  double max_reach = 0.97;            // [-] of the stretched leg, hip to foot; footholds beyond are clamped
};

// One footstep: all feet stand, then those that swing move to their footholds.
struct Footstep {
  PerLeg<bool> swings{};
  double to_lift_off = 0.0;  // [s] from the start of the footstep; less than the stance phase if part of it is over
  double swing_duration = 0.0;
  PerLeg<Vec2> feet;             // [m] sphere centres before lift-off
  PerLeg<Vec2> footholds;        // [m] after landing
  PerLeg<double> support_mid{};  // [s] of the path: when the feet after landing are in the middle of their support
  PerLeg<bool> clamped{};        // the foothold was out of the leg's reach and has been moved
  Vec2 body = Vec2::Zero();      // [m] b in mid-swing
  Vec2 velocity = Vec2::Zero();  // [m/s] of the path there
};

struct FootstepPlan {
  int count = 0;
  std::array<Footstep, kMaxHorizon> steps;
};

// Where the plan starts.
struct FootstepStart {
  double t = 0.0;                // [s] of the path
  double ramp = 1.0;             // [-] share of the path's speed, below 1 after standing
  PerLeg<double> support_mid{};  // [s] of the path: when each foot is, or was, in the middle of its support
};

// `count` <= kMaxHorizon footsteps; the first is the gait's present one. Count 0, and the gait that stands, give an
// empty plan.
FootstepPlan plan_footsteps(const FootstepOptions& options, const ReferencePath& path, const FootstepStart& start,
                            const GaitState& gait, const ModelTerms& m, int count) noexcept;

}  // namespace dob
