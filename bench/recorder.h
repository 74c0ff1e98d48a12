// Collects what the metrics see of a tick. The only place of a trial, besides the simulator, that knows the truth about
// the disturbances.
#pragma once

#include <span>

#include "controller/locomotion_controller.h"
#include "observers/observer.h"
#include "results/tick_record.h"
#include "scenarios/scenario.h"
#include "sim/disturbance_schedule.h"
#include "sim/simulator.h"

namespace dob {

class Recorder {
 public:
  Recorder(const RobotDescription& robot, const Scenario& scenario);

  // The tick at time t [s]: `m` is the true model at t, `step` what the simulator did over [t, t + dt] under the forces
  // that `disturbances` has for t, `estimate` the observer's answer to the interval that ended at t.
  const TickRecord& record(double t, const ModelTerms& m, const LocomotionController& controller,
                           const WbcTick& command, const StepResult& step, const Estimate& estimate,
                           const DisturbanceSchedule& disturbances) noexcept;

  // Puts an estimate for the interval of the last record, beside the truth about it, into the estimate's part of `r`.
  void judge(const Estimate& estimate, TickRecord& r) const noexcept;

  // Puts the truth about the interval of the last record into the parts that the estimate says it has: what an oracle
  // stands for.
  void tell_truth(Estimate& estimate) const noexcept;

 private:
  void record_balance(const ModelTerms& m, const LocomotionController& controller) noexcept;
  void remember_truth(const ModelTerms& m, std::span<const AppliedForce> forces) noexcept;

  Vec12 torque_limit_;  // [N m] the robot's or the controller's, whichever is lower
  double dt_;
  TickRecord record_;

  // Truth over the interval that the next estimate answers to.
  bool have_truth_ = false;
  Vec12 true_torque_ = Vec12::Zero();            // [N m]
  Vec6 true_wrench_ = Vec6::Zero();              // [N; N m] about the CoM, along W
  bool single_leg_force_ = false;                // exactly one disturbance acts, and it acts on a leg
  Eigen::Matrix<double, 3, 12> point_jacobian_;  // of its application point, joint columns in CoM coordinates
  Vec3 true_force_ = Vec3::Zero();               // [N]
};

}  // namespace dob
