#include "results/estimate_errors.h"

namespace dob {

EstimateError estimate_error(const TickRecord& tick) noexcept {
  EstimateError error;
  if (tick.has_force_estimate) error.force = (tick.force_estimate - tick.force_true).squaredNorm();
  if (tick.has_leg_estimate) error.joint = (tick.leg_torque_estimate - tick.leg_torque_true).squaredNorm();
  if (tick.has_com_estimate) {
    const Vec6 wrench = tick.com_wrench_estimate - tick.com_wrench_true;
    error.com_force = wrench.head<3>().squaredNorm();
    error.com_moment = wrench.tail<3>().squaredNorm();
  }
  return error;
}

void EstimateErrors::add(const EstimateError& error) noexcept {
  if (error.force) force_.add(*error.force);
  if (error.joint) joint_.add(*error.joint);
  if (error.com_force) com_force_.add(*error.com_force);
  if (error.com_moment) com_moment_.add(*error.com_moment);
}

EstimateRmse EstimateErrors::rmse() const noexcept {
  return {root(force_.value()), root(joint_.value()), root(com_force_.value()), root(com_moment_.value())};
}

}  // namespace dob
