// Size of the whole-body quadratic problem in its reduced form (controller/whole_body_qp.h), and names for its types.
#pragma once

#include "controller/qp.h"

namespace dob {

inline constexpr int kWbcVariables = 12;
inline constexpr int kWbcMaxRows = 44;  // five per standing foot, twelve torques, twelve joint accelerations

using WbcProblem = QpProblem<kWbcVariables, kWbcMaxRows>;
using WbcQpSolution = QpSolution<kWbcVariables, kWbcMaxRows>;
using WbcActiveSet = QpActiveSet<kWbcVariables>;

}  // namespace dob
