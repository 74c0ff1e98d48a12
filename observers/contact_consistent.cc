#include "observers/contact_consistent.h"

#include <Eigen/LU>

#include "observers/residual.h"

namespace dob {
namespace {

constexpr std::string_view kContactConsistent = "contact_consistent";

ExactFilterOptions read_options(const ObserverOptions& options, double dt) {
  check_tick(kContactConsistent, dt);
  OptionReader reader(kContactConsistent, options);
  const ExactFilterOptions result = read_exact_filter_options(reader, "");
  reader.refuse_unknown();
  return result;
}

// What must act on the feet to explain the joints [N s], along W. False when a leg is singular.
bool foot_impulses(const ModelTerms& m, const Vec12& joints, Vec12& impulses) noexcept {
  constexpr double kSmallestDeterminant = 1e-9;  // [m^3]
  for (int l = 0; l < kLegs; ++l) {
    Mat3 inverse;
    bool invertible = false;
    m.contact[l].J_q.computeInverseWithCheck(inverse, invertible, kSmallestDeterminant);
    if (!invertible) return false;
    impulses.segment<3>(3 * l).noalias() = inverse.transpose() * joints.segment<3>(3 * l);
  }
  return true;
}

}  // namespace

ContactConsistentObserver::ContactConsistentObserver(const ObserverOptions& options, double dt)
    : legs_(read_options(options, dt), dt),
      com_(read_options(options, dt), dt),
      legs_at_rest_(legs_),
      com_at_rest_(com_) {}

void ContactConsistentObserver::reset(const ModelTerms& /*now*/) noexcept {
  legs_ = legs_at_rest_;
  com_ = com_at_rest_;
}

Estimate ContactConsistentObserver::update(const ObserverInput& input) noexcept {
  const ModelTerms& m = input.start;
  ObserverInput blind = input;
  blind.foot_force.setZero();
  Vec6 wrench = com_residual(blind);
  Vec12 impulses = Vec12::Zero();
  const bool regular = foot_impulses(m, leg_residual(blind) + m.A_c.transpose() * wrench, impulses);

  Vec12 standing = impulses;
  Vec12 swinging = impulses;
  for (int l = 0; l < kLegs; ++l) (input.stance[l] ? swinging : standing).segment<3>(3 * l).setZero();
  wrench -= com_wrench(m, m.contact, standing);
  ExactFilter<kJoints> legs = legs_;
  ExactFilter<6> com = com_;
  legs.step(joint_torques(m, m.contact, swinging), input.dt);
  com.step(wrench, input.dt);

  const bool valid = regular && input.dt > 0.0 && legs.finite() && com.finite();
  if (valid) {
    legs_ = legs;
    com_ = com;
  }
  Estimate estimate = com_estimate(com_.estimate(), valid);
  estimate.has_legs = true;
  estimate.leg_torque = legs_.estimate();
  return estimate;
}

}  // namespace dob
