#include "robot/inverse_kinematics.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace dob {
namespace {

constexpr double kTolerance = 1e-12;     // [m]
constexpr int kMaxIterations = 100;      // a straight knee is a double root: one bit per iteration
constexpr double kLeastDamping = 1e-16;  // [m^2] squared singular values of J, below them
constexpr double kStalled = 1e4;         // [m^2] even steps this short do not come closer

struct FootKinematics {
  Vec3 p_BF;  // [m]
  Mat3 J;     // d p_BF / d q [m/rad]
};

const LegDescription& description_of(const RobotDescription& robot, Leg leg) noexcept {
  return robot.legs[static_cast<std::size_t>(leg)];
}

FootKinematics foot_kinematics(const LegDescription& leg, const Vec3& q) noexcept {
  std::array<Vec3, kJointsPerLeg> axis;
  std::array<Vec3, kJointsPerLeg> origin;
  Mat3 R = Mat3::Identity();
  Vec3 p = Vec3::Zero();
  for (std::size_t i = 0; i < kJointsPerLeg; ++i) {
    const JointDescription& joint = leg.joints[i];
    p += R * joint.origin;
    origin[i] = p;
    axis[i] = R * joint.axis;
    R = R * Eigen::AngleAxisd(q[static_cast<Eigen::Index>(i)], joint.axis).toRotationMatrix();
  }
  FootKinematics foot;
  foot.p_BF = p + R * leg.foot_center;
  for (std::size_t i = 0; i < kJointsPerLeg; ++i) {
    foot.J.col(static_cast<Eigen::Index>(i)) = axis[i].cross(foot.p_BF - origin[i]);
  }
  return foot;
}

struct Limits {
  explicit Limits(const LegDescription& leg) {
    for (Eigen::Index i = 0; i < kJointsPerLeg; ++i) {
      lower[i] = leg.joints[static_cast<std::size_t>(i)].lower;
      upper[i] = leg.joints[static_cast<std::size_t>(i)].upper;
    }
  }
  Vec3 clip(const Vec3& q) const { return q.cwiseMax(lower).cwiseMin(upper); }
  Vec3 at(double a, double b, double c) const { return lower + Vec3(a, b, c).cwiseProduct(upper - lower); }

  Vec3 lower, upper;
};

std::optional<Vec3> solve_from(const LegDescription& leg, const Limits& limits, const Vec3& p_BF, const Vec3& seed) {
  Vec3 q = limits.clip(seed);
  FootKinematics foot = foot_kinematics(leg, q);
  double damping = 1e-3;  // [m^2]
  for (int iteration = 0; iteration < kMaxIterations && damping < kStalled; ++iteration) {
    const Vec3 error = p_BF - foot.p_BF;
    if (error.norm() <= kTolerance) {
      return q;
    }
    const Mat3 normal = foot.J.transpose() * foot.J + damping * Mat3::Identity();
    const Vec3 candidate = limits.clip(q + normal.ldlt().solve(foot.J.transpose() * error));
    const FootKinematics candidate_foot = foot_kinematics(leg, candidate);
    if ((p_BF - candidate_foot.p_BF).norm() < error.norm()) {
      q = candidate;
      foot = candidate_foot;
      damping = std::max(0.1 * damping, kLeastDamping);
    } else {
      damping *= 10.0;
    }
  }
  return std::nullopt;
}

}  // namespace

Vec3 foot_center_in_base(const RobotDescription& robot, Leg leg, const Vec3& q) noexcept {
  return foot_kinematics(description_of(robot, leg), q).p_BF;
}

std::optional<Vec3> solve_leg(const RobotDescription& robot, Leg leg, const Vec3& p_BF, const Vec3& seed_q) {
  const LegDescription& description = description_of(robot, leg);
  const Limits limits(description);
  if (auto q = solve_from(description, limits, p_BF, seed_q)) {
    return q;
  }
  for (const double a : {0.5, 0.2, 0.8}) {
    for (const double b : {0.5, 0.2, 0.8}) {
      for (const double c : {0.5, 0.2, 0.8}) {
        if (auto q = solve_from(description, limits, p_BF, limits.at(a, b, c))) {
          return q;
        }
      }
    }
  }
  return std::nullopt;
}

}  // namespace dob
