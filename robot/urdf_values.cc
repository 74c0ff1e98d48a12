#include "robot/urdf_values.h"

#include <array>
#include <string>
#include <string_view>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

namespace dob {
namespace {

constexpr double kShortestAxis = 1e-6;  // below, the direction of a joint axis is rounding
constexpr double kRounding = 1e-9;      // relative; eigenvalues of a flat body's inertia

// Every number is within its range of urdf_ranges.h; here is what several of them have to be together.

Vec3 vector_of(const urdf::Vector3& v) {
  return {v.x, v.y, v.z};
}

// `where` is "link 'name'" or "joint 'name'".
Eigen::Isometry3d pose_of(const std::string& where, const urdf::Pose& pose) {
  const urdf::Rotation& r = pose.rotation;
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = Eigen::Quaterniond(r.w, r.x, r.y, r.z).toRotationMatrix();
  result.translation() = vector_of(pose.position);
  if (!result.linear().allFinite()) {
    throw DescriptionError(fmt::format("{}: the rpy of its origin is not a rotation", where));
  }
  return result;
}

void check_inertia(const std::string& where, const Mat3& inertia) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(inertia, Eigen::EigenvaluesOnly);
  const Vec3& moments = solver.eigenvalues();  // ascending
  const std::string values =
      fmt::format("principal moments of inertia are {:g}, {:g}, {:g} kg m^2", moments[0], moments[1], moments[2]);
  if (!(moments[0] > 0.0)) {
    throw DescriptionError(fmt::format("{}: {}; all must be positive", where, values));
  }
  if (moments[2] > (moments[0] + moments[1]) * (1.0 + kRounding)) {
    throw DescriptionError(
        fmt::format("{}: {}; none may exceed the sum of the other two (triangle inequality)", where, values));
  }
}

std::string type_name(const urdf::Joint& joint) {
  constexpr std::array<const char*, 7> kNames{"unknown",  "revolute", "continuous", "prismatic",
                                              "floating", "planar",   "fixed"};
  const auto index = static_cast<std::size_t>(joint.type);
  return index < kNames.size() ? kNames.at(index) : "unknown";
}

}  // namespace

LinkInertia inertia_of(const urdf::Link& link) {
  if (!link.inertial) {
    return {};
  }
  const std::string where = fmt::format("link '{}'", link.name);
  const urdf::Inertial& in = *link.inertial;
  Mat3 inertia;
  inertia << in.ixx, in.ixy, in.ixz, in.ixy, in.iyy, in.iyz, in.ixz, in.iyz, in.izz;
  if (in.mass == 0.0 && inertia.isZero(0.0)) {
    return {};
  }
  if (in.mass == 0.0) {
    throw DescriptionError(fmt::format("{}: mass is 0 kg beside an inertia; a positive number is needed", where));
  }
  check_inertia(where, inertia);
  const Eigen::Isometry3d pose = pose_of(where, in.origin);
  return {in.mass, pose.translation(), pose.linear() * inertia * pose.linear().transpose()};
}

std::vector<CollisionShape> shapes_of(const urdf::Link& link) {
  const std::string where = fmt::format("link '{}'", link.name);
  std::vector<CollisionShape> shapes;
  for (const urdf::CollisionSharedPtr& collision : link.collision_array) {
    CollisionShape shape;
    if (const auto* box = dynamic_cast<const urdf::Box*>(collision->geometry.get())) {
      shape.kind = CollisionShape::Kind::kBox;
      shape.size = vector_of(box->dim);
    } else if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(collision->geometry.get())) {
      shape.kind = CollisionShape::Kind::kCylinder;
      shape.size = {cylinder->radius, cylinder->length, 0.0};
    } else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(collision->geometry.get())) {
      shape.kind = CollisionShape::Kind::kSphere;
      shape.size = {sphere->radius, 0.0, 0.0};
    } else {
      continue;  // a mesh
    }
    const Eigen::Isometry3d pose = pose_of(where, collision->origin);
    shape.position = pose.translation();
    shape.rotation = pose.linear();
    shapes.push_back(shape);
  }
  return shapes;
}

JointDescription revolute_joint_of(const urdf::Joint& joint) {
  const std::string where = fmt::format("joint '{}'", joint.name);
  if (joint.type != urdf::Joint::REVOLUTE || !joint.limits) {
    throw DescriptionError(
        fmt::format("{}: its type is {}; a joint of a leg must be revolute, with <limit> lower, upper, "
                    "effort and velocity",
                    where, type_name(joint)));
  }
  if (joint.mimic) {
    throw DescriptionError(fmt::format("{}: mimics joint '{}'; every joint of a leg needs a motor of its own", where,
                                       joint.mimic->joint_name));
  }
  const Vec3 axis = vector_of(joint.axis);
  if (axis.norm() < kShortestAxis) {
    throw DescriptionError(
        fmt::format("{}: axis is ({}, {}, {}); a direction is needed", where, axis.x(), axis.y(), axis.z()));
  }
  JointDescription result;
  result.name = joint.name;
  result.axis = axis.normalized();
  result.lower = joint.limits->lower;
  result.upper = joint.limits->upper;
  if (!(result.lower < result.upper)) {
    throw DescriptionError(fmt::format("{}: lower limit is {} rad; less than the upper one, {} rad, is needed", where,
                                       result.lower, result.upper));
  }
  result.effort_limit = joint.limits->effort;
  result.velocity_limit = joint.limits->velocity;
  return result;
}

Eigen::Isometry3d origin_of(const urdf::Joint& joint) {
  return pose_of(fmt::format("joint '{}'", joint.name), joint.parent_to_joint_origin_transform);
}

}  // namespace dob
