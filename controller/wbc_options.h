// Options of the whole-body controller: the paper's figures are the defaults, every departure from the printed
// equations is an option with its reason.
#pragma once

#include <limits>

#include "robot/types.h"

namespace dob {

// Which compensation paths of the controller use an observer's estimate. Part of an observer's profile.
struct Routing {
  // (17): the wrench that the ground reaction forces must produce is reduced by the estimated one.
  bool wrench_17 = true;
  // (18): the same wrench on the right-hand side of the equation of motion. Printed without; then the predicted
  // CoM acceleration, and with it every joint acceleration, is wrong by the disturbance.
  bool dynamics_18 = false;
  // What (17) and (18) take for that wrench.
  enum class WrenchSource {
    kCom,         // the CoM estimate, where there is one, REPLACES J_st,com^T f_hat_st: the leg momentum sees only part
                  // of a force on a leg, and both together would compensate twice. Without one as kStanceLegs
    kStanceLegs,  // J_st,com^T f_hat_st, as printed; a CoM estimate is ignored
    kAllLegs,     // J_com^T f_hat of all feet: what pushes a swinging leg reaches the CoM as well
  };
  WrenchSource wrench_source = WrenchSource::kCom;
  // (36): subtract J_st,j^T f_hat_st from the torque, and bound the torque really sent in (24). Printed without;
  // then (36) contradicts (17) and the compensated force reappears as an error of the ground reaction force.
  bool torque_36 = true;
  // (31): compensation on the swing legs, by the projected operational-space term, by the torque itself, or not.
  enum class Swing { kOff, kProjected, kDirect };
  Swing swing_31 = Swing::kProjected;
};

// What a joint can do, of the robot description; without bounds unless set. Only the rows of
// WbcOptions::joint_acceleration_limits read it.
struct JointLimits {
  static constexpr double kNone = std::numeric_limits<double>::infinity();
  Vec12 lower = Vec12::Constant(-kNone);    // [rad]
  Vec12 upper = Vec12::Constant(kNone);     // [rad]
  Vec12 velocity = Vec12::Constant(kNone);  // [rad/s] either way
};

struct WbcOptions {
  Vec6 wrench_kp = Vec6::Constant(250.0);  // (16) [N/m; N m/rad], section 5.1
  Vec6 wrench_kd = Vec6::Constant(50.0);   // (16) [N s/m; N m s/rad]
  double swing_kp = 25.0;                  // (30) [1/s^2], section 5.1 as printed
  double swing_kd = 100.0;                 // (30) [1/s]
  double wrench_weight = 100.0;            // Q of (17), times I_6
  double regularization = 1.0;             // R of (17), times I
  double slack_weight = 1e8;               // of gamma in (33), as in the published code
  double friction = 1.0;                   // mu of (23), section 5.1
  double min_normal_force = 0.0;           // [N] lower bound of the normal force
  double torque_limit = 60.0;              // [N m] of (24)
  double qp_rate = 400.0;                  // [Hz], section 5.1

  // (16): printed as a difference of ZYX Euler angles, whose components are no rotation about the axes that the moment
  // acts about, except at zero roll and pitch. The rate error is that of the trunk's angular velocity either way.
  enum class OrientationError { kRotationVector, kZyxAngles };
  OrientationError orientation_error = OrientationError::kRotationVector;

  // (24), (36): C_q v, exactly or left out (observers have the same choice for (3)).
  enum class Coriolis { kExact, kNeglected };
  Coriolis coriolis = Coriolis::kExact;

  // (24); without these rows the torque saturates behind the QP's back.
  bool torque_rows = true;

  // Not printed, but in the published code: rows on qdd that keep every joint within its position and velocity limits
  // for the horizon ahead. They forbid, they never demand: see acceleration_limits in controller/acceleration_limits.h.
  bool joint_acceleration_limits = false;
  double acceleration_horizon = 0.025;  // [s], as in the published code
  JointLimits joint_limits;

  // (36) at the ticks between two solves: again with the present model and estimate, or the last torque held.
  enum class BetweenSolves { kRecomputed, kHeld };
  BetweenSolves torque_between_solves = BetweenSolves::kRecomputed;

  // (18) with the sign that (21) prints in front of J_st,com^T. The ground then pulls where it should push, and the
  // robot collapses: for showing just that.
  bool printed_sign_21 = false;
};

}  // namespace dob
