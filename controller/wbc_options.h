// Options of the whole-body controller: the paper's figures are the defaults, every departure from the printed
// equations is an option with its reason.
#pragma once

#include "robot/types.h"

namespace dob {

// Which compensation paths of the controller use an observer's estimate. Part of an observer's profile.
struct Routing {
  // (17): the wrench that the ground reaction forces must produce is reduced by the estimated one. With a CoM
  // estimate present, that estimate REPLACES J_st,com^T f_hat_st: the leg momentum sees only part of a force on a
  // leg, and both together would compensate twice.
  bool wrench_17 = true;
  // (18): the same wrench on the right-hand side of the equation of motion. Printed without; then the predicted
  // CoM acceleration, and with it every joint acceleration, is wrong by the disturbance.
  bool dynamics_18 = false;
  // (36): subtract J_st,j^T f_hat_st from the torque, and bound the torque really sent in (24). Printed without;
  // then (36) contradicts (17) and the compensated force reappears as an error of the ground reaction force.
  bool torque_36 = true;
  // (31): compensation on the swing legs, by the projected operational-space term, by the torque itself, or not.
  enum class Swing { kOff, kProjected, kDirect };
  Swing swing_31 = Swing::kProjected;
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
};

}  // namespace dob
