// What a quadruped of our topology is made of: a floating trunk and four legs of three revolute joints.
//
// All link frames are CANONICAL: at zero joint angles every link frame has the axes of the base frame B, whose
// x points in the direction of travel, y to the left, z up. The loader removes joint-origin rotations and the
// description's own idea of "forward"; nobody behind it needs to know them.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "robot/types.h"

namespace dob {

// Rigid-body inertia of one link.
struct LinkInertia {
  double mass = 0.0;            // [kg]
  Vec3 com = Vec3::Zero();      // [m] centre of mass in the link frame
  Mat3 inertia = Mat3::Zero();  // [kg m^2] about the centre of mass, axes of the link frame
};

// Simplified collision solid of a link.
struct CollisionShape {
  enum class Kind { kBox, kCylinder, kSphere };
  Kind kind = Kind::kBox;
  Vec3 size = Vec3::Zero();          // [m] box: full edges; cylinder: radius, length (along z), unused; sphere: radius
  Vec3 position = Vec3::Zero();      // [m] centre, in the link frame
  Mat3 rotation = Mat3::Identity();  // shape axes to link axes
};

// Revolute joint; its frame is the frame of the link it moves.
struct JointDescription {
  std::string name;
  Vec3 origin = Vec3::Zero();   // [m] in the parent link's frame
  Vec3 axis = Vec3::UnitX();    // unit vector, same components in parent and child at any angle
  double lower = 0.0;           // [rad]
  double upper = 0.0;           // [rad]
  double effort_limit = 0.0;    // [N m]
  double velocity_limit = 0.0;  // [rad/s]
};

struct LinkDescription {
  std::string name;
  LinkInertia inertia;
  std::vector<CollisionShape> shapes;  // without the foot sphere
};

struct LegDescription {
  std::array<JointDescription, kJointsPerLeg> joints;
  std::array<LinkDescription, kJointsPerLeg> links;
  Vec3 foot_center = Vec3::Zero();  // [m] centre of the foot's contact sphere, in the lower link's frame
  double foot_radius = 0.0;         // [m]
};

struct RobotDescription {
  std::string name;
  LinkDescription trunk;  // its frame is B
  PerLeg<LegDescription> legs;
  Mat3 R_description_B = Mat3::Identity();  // axes of B in the description's own base frame

  double total_mass() const;  // [kg]
};

// A robot description that cannot be used. what() names the file, the link or joint, the value, what is expected.
class DescriptionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Direction of travel in the description's base frame.
enum class Forward { kPlusX, kMinusX, kPlusY, kMinusY };

// Loads a URDF whose links, apart from those fixed to them, are a trunk and four chains of three revolute joints
// ending in a link with exactly one collision sphere (the foot). Throws DescriptionError.
//  - Links behind fixed joints are merged into the link they are fixed to: inertia, shapes, joints.
//  - A massless root above a single floating joint stands for the world; the trunk is the link below it.
//  - Legs are named by the quadrant of their hip joint's origin around the centre of the four.
//  - Collision boxes, cylinders and spheres are kept, meshes are left out. Ignored besides: visuals, <dynamics>,
//    <safety_controller>, the elements of other programs.
//  - Numbers are read independently of the locale. Files of 4 MiB or with more than 5000 XML elements are refused.
// Safe to call from several threads; prints nothing.
RobotDescription load_robot(const std::filesystem::path& urdf, Forward forward);

// The same description with all masses and inertias multiplied (the model error of case study 5). A factor that is not
// positive and finite: std::invalid_argument.
RobotDescription scale_inertia(RobotDescription robot, double factor);

// The trunk's alone. std::invalid_argument as above.
RobotDescription scale_trunk_inertia(RobotDescription robot, double factor);

// Every link's rotational inertia about its centre of mass alone; masses stay. std::invalid_argument as above.
RobotDescription scale_rotational_inertia(RobotDescription robot, double factor);

}  // namespace dob
