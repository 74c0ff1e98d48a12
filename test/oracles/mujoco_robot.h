// Independent dynamics oracle: the robot's URDF in MuJoCo, terms converted to this project's conventions.
//
// MuJoCo: qpos = [p; quaternion wxyz; q], qvel = [p_dot world; R^T omega; qd] (base frame of the description).
// With G = diag(I, R, I): M_W = G M G^T, h_W = G h, J_W = J G^T; Jdot v needs no change of basis.
// MuJoCo fuses the foot link and its fused inertia is off by 4e-9, so inertias are overwritten before use.
#pragma once

#include <filesystem>
#include <memory>

#include "robot/description.h"

namespace dob::oracle {

struct MujocoTerms {
  Mat18 M;
  Vec18 h;  // bias forces including gravity
  Vec3 p_com;
  PerLeg<Vec3> p_foot;  // centre of the foot sphere
  PerLeg<Mat3x18> J_foot;
  PerLeg<Mat3x18> J_lower_angular;  // angular Jacobian of the lower links
  PerLeg<Vec3> Jdot_v_foot;
};

class MujocoRobot {
 public:
  // `robot` must be the description loaded from the same file; it supplies the order of legs and the inertias.
  MujocoRobot(const std::filesystem::path& urdf, const RobotDescription& robot);
  ~MujocoRobot();
  MujocoRobot(const MujocoRobot&) = delete;
  MujocoRobot& operator=(const MujocoRobot&) = delete;

  void set_state(const RobotState& state);
  void compute(MujocoTerms& terms);  // at the state last set

  // The same terms left in MuJoCo's own arrays and coordinates: what a benchmark compares with. Mass matrix, bias
  // forces, foot Jacobians and foot accelerations at v_dot = 0.
  void compute_raw();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace dob::oracle
