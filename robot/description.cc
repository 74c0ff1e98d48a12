#include "robot/description.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "robot/text_input.h"
#include "robot/urdf_reader.h"
#include "robot/urdf_values.h"

namespace dob {
namespace {

constexpr std::size_t kLongestError = 2000;  // [bytes] of a message, which repeats names of the file

// A moving link with everything fixed to it, in the moving link's own axes, and the joints that go on from
// there.
struct Body {
  LinkDescription link;
  struct Branch {
    const urdf::Joint* joint;
    const urdf::Link* child;
    Eigen::Isometry3d pose;  // joint frame in the body's frame
  };
  std::vector<Branch> branches;
};

Mat3 rotated(const Mat3& inertia, const Mat3& R) {
  return R * inertia * R.transpose();
}

// Inertia of two rigidly connected bodies, both given in the same frame (parallel axis theorem).
LinkInertia combined(const LinkInertia& a, const LinkInertia& b) {
  if (a.mass == 0.0 || b.mass == 0.0) {
    return a.mass == 0.0 ? b : a;
  }
  LinkInertia sum;
  sum.mass = a.mass + b.mass;
  sum.com = (a.mass * a.com + b.mass * b.com) / sum.mass;
  const auto about_sum = [&](const LinkInertia& part) -> Mat3 {
    const Mat3 d = skew(part.com - sum.com);
    return part.inertia - part.mass * d * d;
  };
  sum.inertia = about_sum(a) + about_sum(b);
  return sum;
}

void add_link(const urdf::Link& link, const Eigen::Isometry3d& pose, Body& body) {
  LinkInertia inertia = inertia_of(link);
  inertia.com = pose * inertia.com;
  inertia.inertia = rotated(inertia.inertia, pose.linear());
  body.link.inertia = combined(body.link.inertia, inertia);
  for (CollisionShape& shape : shapes_of(link)) {
    shape.position = pose * shape.position;
    shape.rotation = pose.linear() * shape.rotation;
    body.link.shapes.push_back(shape);
  }
  for (std::size_t i = 0; i < link.child_joints.size(); ++i) {
    const urdf::Joint& joint = *link.child_joints[i];
    const urdf::Link& child = *link.child_links[i];
    const Eigen::Isometry3d child_pose = pose * origin_of(joint);
    if (joint.type == urdf::Joint::FIXED) {
      add_link(child, child_pose, body);
    } else {
      body.branches.push_back({&joint, &child, child_pose});
    }
  }
}

Body body_of(const urdf::Link& link) {
  Body body;
  body.link.name = link.name;
  add_link(link, Eigen::Isometry3d::Identity(), body);
  if (body.link.inertia.mass == 0.0) {
    throw DescriptionError(
        fmt::format("link '{}': moves but has no mass; <inertial> with a positive mass [kg] is needed", link.name));
  }
  return body;
}

void check_branches(const Body& body, std::size_t expected, std::string_view why) {
  if (body.branches.size() == expected) {
    return;
  }
  std::string names;
  for (const Body::Branch& branch : body.branches) {
    names += fmt::format("{}'{}'", names.empty() ? "" : ", ", branch.joint->name);
  }
  throw DescriptionError(fmt::format("link '{}': carries {} moving joints ({}); {}", body.link.name,
                                     body.branches.size(), names.empty() ? "none" : names, why));
}

// From the axes of the body's own frame to those of B.
LinkDescription in_base_axes(LinkDescription link, const Mat3& R_B_body) {
  link.inertia.com = R_B_body * link.inertia.com;
  link.inertia.inertia = rotated(link.inertia.inertia, R_B_body);
  for (CollisionShape& shape : link.shapes) {
    shape.position = R_B_body * shape.position;
    shape.rotation = R_B_body * shape.rotation;
  }
  return link;
}

// The only sphere on the lower link is the foot.
void take_foot(LegDescription& leg) {
  LinkDescription& lower = leg.links.back();
  const auto is_sphere = [](const CollisionShape& shape) { return shape.kind == CollisionShape::Kind::kSphere; };
  const auto spheres = std::count_if(lower.shapes.begin(), lower.shapes.end(), is_sphere);
  if (spheres != 1) {
    throw DescriptionError(
        fmt::format("link '{}': has {} collision spheres, those of links fixed to it included; exactly one, "
                    "the foot, is needed",
                    lower.name, spheres));
  }
  const auto foot = std::find_if(lower.shapes.begin(), lower.shapes.end(), is_sphere);
  leg.foot_center = foot->position;
  leg.foot_radius = foot->size[0];
  lower.shapes.erase(foot);
}

LegDescription leg_of(Body::Branch branch, Mat3 R_B_body) {
  LegDescription leg;
  for (std::size_t i = 0; i < kJointsPerLeg; ++i) {
    JointDescription& joint = leg.joints.at(i);
    joint = revolute_joint_of(*branch.joint);
    joint.origin = R_B_body * branch.pose.translation();
    R_B_body = R_B_body * branch.pose.linear();
    joint.axis = R_B_body * joint.axis;
    const Body body = body_of(*branch.child);
    leg.links.at(i) = in_base_axes(body.link, R_B_body);
    if (i + 1 < kJointsPerLeg) {
      check_branches(body, 1, "the three revolute joints of a leg need exactly one to go on");
      branch = body.branches.front();
    } else {
      check_branches(body, 0, "a leg has three revolute joints, whatever comes after them must be fixed");
    }
  }
  take_foot(leg);
  return leg;
}

// Quadrant of each hip as seen from the centre of the four.
PerLeg<LegDescription> sorted_by_hip(std::vector<LegDescription>&& legs) {
  constexpr double kClearance = 1e-6;  // [m] a hip on the border of two quadrants is in neither
  Vec3 center = Vec3::Zero();
  for (const LegDescription& leg : legs) {
    center += leg.joints.front().origin / kLegs;
  }
  PerLeg<std::optional<LegDescription>> sorted;
  for (LegDescription& leg : legs) {
    const JointDescription& hip = leg.joints.front();
    const Vec3 p = hip.origin - center;
    const std::string where = fmt::format(
        "joint '{}': this hip is {:.6g} m to the front and {:.6g} m to the left of "
        "the centre of all hips",
        hip.name, p.x(), p.y());
    if (std::min(std::abs(p.x()), std::abs(p.y())) < kClearance) {
      throw DescriptionError(where + "; front or hind, left or right must be clear");
    }
    const std::size_t index = (p.x() > 0.0 ? 0U : 2U) + (p.y() > 0.0 ? 0U : 1U);  // the order of Leg
    std::optional<LegDescription>& place = sorted.at(index);
    if (place) {
      throw DescriptionError(fmt::format("{}, in the same quadrant as joint '{}'; one hip per quadrant is needed",
                                         where, place->joints.front().name));
    }
    place = std::move(leg);
  }
  PerLeg<LegDescription> result;
  for (std::size_t i = 0; i < kLegs; ++i) {
    result.at(i) = std::move(sorted.at(i)).value();
  }
  return result;
}

Mat3 base_axes(Forward forward) {
  Vec3 x = Vec3::UnitX();
  switch (forward) {
    case Forward::kPlusX:
      break;
    case Forward::kMinusX:
      x = -Vec3::UnitX();
      break;
    case Forward::kPlusY:
      x = Vec3::UnitY();
      break;
    case Forward::kMinusY:
      x = -Vec3::UnitY();
      break;
  }
  Mat3 R;
  R << x, Vec3::UnitZ().cross(x), Vec3::UnitZ();
  return R;
}

// A massless root that carries nothing but a floating joint stands for the world: the trunk is what floats.
const urdf::Link& trunk_of(const urdf::ModelInterface& model) {
  const urdf::Link& root = *model.getRoot();
  const bool is_world = root.child_joints.size() == 1 && root.child_joints.front()->type == urdf::Joint::FLOATING;
  if (!is_world) {
    return root;
  }
  if (inertia_of(root).mass != 0.0) {
    throw DescriptionError(fmt::format("link '{}': has mass although joint '{}' makes it the world; none is allowed",
                                       root.name, root.child_joints.front()->name));
  }
  return *root.child_links.front();
}

RobotDescription build(const urdf::ModelInterface& model, Forward forward) {
  RobotDescription robot;
  robot.name = model.getName();
  robot.R_description_B = base_axes(forward);
  const Mat3 R_B_trunk = robot.R_description_B.transpose();
  const Body trunk = body_of(trunk_of(model));
  check_branches(trunk, kLegs, "the trunk needs exactly four, one per leg");
  robot.trunk = in_base_axes(trunk.link, R_B_trunk);
  std::vector<LegDescription> legs;
  for (const Body::Branch& branch : trunk.branches) {
    legs.push_back(leg_of(branch, R_B_trunk));
  }
  robot.legs = sorted_by_hip(std::move(legs));
  return robot;
}

void scale(LinkInertia& inertia, double factor) {
  inertia.mass *= factor;
  inertia.inertia *= factor;
}

void require_factor(const char* function, double factor) {
  if (factor > 0.0 && std::isfinite(factor)) return;
  throw std::invalid_argument(fmt::format("{}: factor is {}; a positive number is needed", function, factor));
}

}  // namespace

double RobotDescription::total_mass() const {
  double mass = trunk.inertia.mass;
  for (const LegDescription& leg : legs) {
    for (const LinkDescription& link : leg.links) {
      mass += link.inertia.mass;
    }
  }
  return mass;
}

RobotDescription load_robot(const std::filesystem::path& urdf, Forward forward) {
  try {
    return build(*read_urdf(urdf), forward);
  } catch (const DescriptionError& error) {
    throw DescriptionError(printable_line(fmt::format("{}: {}", urdf.string(), error.what()), kLongestError));
  }
}

RobotDescription scale_inertia(RobotDescription robot, double factor) {
  require_factor("scale_inertia", factor);
  scale(robot.trunk.inertia, factor);
  for (LegDescription& leg : robot.legs) {
    for (LinkDescription& link : leg.links) {
      scale(link.inertia, factor);
    }
  }
  return robot;
}

RobotDescription scale_trunk_inertia(RobotDescription robot, double factor) {
  require_factor("scale_trunk_inertia", factor);
  scale(robot.trunk.inertia, factor);
  return robot;
}

RobotDescription scale_rotational_inertia(RobotDescription robot, double factor) {
  require_factor("scale_rotational_inertia", factor);
  robot.trunk.inertia.inertia *= factor;
  for (LegDescription& leg : robot.legs) {
    for (LinkDescription& link : leg.links) {
      link.inertia.inertia *= factor;
    }
  }
  return robot;
}

}  // namespace dob
