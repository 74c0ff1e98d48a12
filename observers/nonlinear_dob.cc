#include "observers/nonlinear_dob.h"

#include <cmath>

#include <Eigen/Cholesky>

#include "observers/residual.h"

namespace dob {
namespace {

constexpr std::string_view kNonlinearDob = "nonlinear_dob";

}  // namespace

NonlinearDobOptions read_nonlinear_dob_options(const ObserverOptions& options) {
  OptionReader reader(kNonlinearDob, options);
  NonlinearDobOptions result;
  if (reader.choice("reading", {"bandwidth", "literal"}) == "literal") {
    result.reading = NonlinearDobOptions::Reading::kLiteral;
  }
  result.X = reader.number("X", result.X, kGainRange);
  reader.refuse_unknown();
  return result;
}

NonlinearDobObserver::NonlinearDobObserver(const NonlinearDobOptions& options, double dt) : options_(options) {
  check_tick(kNonlinearDob, dt);
}

void NonlinearDobObserver::reset(const ModelTerms& /*now*/) noexcept {
  d_hat_.setZero();
}

Estimate NonlinearDobObserver::update(const ObserverInput& input) noexcept {
  const double dt = input.dt;
  const Vec12 error = acceleration_residual(input) - dt * d_hat_;
  Vec12 next = d_hat_;
  if (options_.reading == NonlinearDobOptions::Reading::kBandwidth) {
    next -= std::expm1(-options_.X * dt) / dt * error;
  } else {
    Mat12 implicit = input.start.M_q;
    implicit.diagonal().array() += options_.X * dt;
    next += options_.X * implicit.llt().solve(error);
  }

  const bool valid = dt > 0.0 && next.allFinite();
  if (valid) d_hat_ = next;
  return leg_estimate(d_hat_, valid);
}

}  // namespace dob
