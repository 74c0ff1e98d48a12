// Single links and joints of a URDF as our values, each number checked. Internal to robot/.
//
// All functions throw DescriptionError naming link or joint, the value and what is allowed (not the file: the
// caller does). Numbers are finite and, in SI units, at most 1e6 in magnitude, so that nothing derived from
// them overflows.
#pragma once

#include <vector>

#include <urdf_model/joint.h>
#include <urdf_model/link.h>

#include "robot/description.h"

namespace dob {

// Inertia in the axes of the link itself, without the links fixed to it; zero without <inertial> or with an
// all-zero one (a mere frame). Otherwise the mass is positive and the inertia is one that a rigid body can
// have: positive definite, no principal moment larger than the sum of the other two.
LinkInertia inertia_of(const urdf::Link& link);

// Boxes, cylinders and spheres in the axes of the link itself; meshes are left out.
std::vector<CollisionShape> shapes_of(const urdf::Link& link);

// Name, unit axis (in the joint's own frame) and limits of a revolute joint; the origin is left at zero.
JointDescription revolute_joint_of(const urdf::Joint& joint);

// Joint frame in the parent link's frame.
Eigen::Isometry3d origin_of(const urdf::Joint& joint);

}  // namespace dob
