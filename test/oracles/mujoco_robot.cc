#include "test/oracles/mujoco_robot.h"

#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <unistd.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <mujoco/mujoco.h>

namespace dob::oracle {
namespace {

std::string read_file(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

// MuJoCo welds a URDF's root to the world; a world link with a floating joint frees it.
std::string with_floating_base(std::string urdf, const std::string& trunk) {
  const auto robot = urdf.find("<robot");
  const auto end = urdf.find('>', robot) + 1;
  urdf.insert(end,
              "<mujoco><compiler fusestatic=\"true\" discardvisual=\"true\" balanceinertia=\"false\"/></mujoco>"
              "<link name=\"oracle_world\"/><joint name=\"oracle_floating\" type=\"floating\">"
              "<parent link=\"oracle_world\"/><child link=\"" +
                  trunk + "\"/></joint>");
  return urdf;
}

Eigen::Map<const Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>> rows3(const double* data, int cols) {
  return {data, 3, cols};
}

}  // namespace

struct MujocoRobot::Impl {
  mjModel* model = nullptr;
  mjData* data = nullptr;
  const RobotDescription robot;
  Mat3 R_BD;  // B from description axes
  PerLeg<std::array<int, kJointsPerLeg>> dof, qpos, body;
  Mat3 R_WD = Mat3::Identity();

  explicit Impl(const RobotDescription& r) : robot(r) {}
  ~Impl() {
    mj_deleteData(data);
    mj_deleteModel(model);
  }

  int id(int type, const std::string& name) const {
    const int i = mj_name2id(model, type, name.c_str());
    if (i < 0) throw std::runtime_error("MuJoCo knows no " + name);
    return i;
  }

  // Exact link inertias in the description's axes, principal axes by an eigen-decomposition.
  void overwrite_inertia(int body_id, const LinkInertia& link) const {
    const Mat3& R = robot.R_description_B;
    const Eigen::SelfAdjointEigenSolver<Mat3> eigen(R * link.inertia * R.transpose());
    Mat3 axes = eigen.eigenvectors();
    if (axes.determinant() < 0.0) axes.col(0) *= -1.0;
    const Eigen::Quaterniond quat(axes);
    const Vec3 com = R * link.com;
    model->body_mass[body_id] = link.mass;
    for (int i = 0; i < 3; ++i) {
      model->body_inertia[3 * body_id + i] = eigen.eigenvalues()[i];
      model->body_ipos[3 * body_id + i] = com[i];
    }
    const std::array<double, 4> wxyz{quat.w(), quat.x(), quat.y(), quat.z()};
    for (int i = 0; i < 4; ++i) model->body_iquat[4 * body_id + i] = wxyz[static_cast<std::size_t>(i)];
  }

  // [p_dot; omega; qd] of ours from MuJoCo's column or row order.
  Eigen::Matrix<double, 18, 18> basis() const {
    Mat18 G = Mat18::Zero();  // v_W = G v_mujoco, permuted to our leg order
    G.topLeftCorner<3, 3>().setIdentity();
    G.block<3, 3>(3, 3) = R_WD;
    for (int l = 0; l < kLegs; ++l) {
      for (int k = 0; k < kJointsPerLeg; ++k) G(6 + 3 * l + k, dof[l][k]) = 1.0;
    }
    return G;
  }
};

MujocoRobot::MujocoRobot(const std::filesystem::path& urdf, const RobotDescription& robot)
    : impl_(std::make_unique<Impl>(robot)) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("dob_oracle_" + std::to_string(::getpid()) + ".urdf");
  std::ofstream(file) << with_floating_base(read_file(urdf), robot.trunk.name);
  std::array<char, 1024> error{};
  impl_->model = mj_loadXML(file.c_str(), nullptr, error.data(), static_cast<int>(error.size()));
  std::filesystem::remove(file);
  if (impl_->model == nullptr) throw std::runtime_error(std::string("MuJoCo: ") + error.data());
  impl_->model->opt.disableflags |= mjDSBL_CONTACT | mjDSBL_LIMIT | mjDSBL_PASSIVE;
  const auto& m = *impl_->model;
  for (int l = 0; l < kLegs; ++l) {
    for (int k = 0; k < kJointsPerLeg; ++k) {
      const int joint = impl_->id(mjOBJ_JOINT, robot.legs[l].joints[k].name);
      impl_->dof[l][k] = m.jnt_dofadr[joint];
      impl_->qpos[l][k] = m.jnt_qposadr[joint];
      impl_->body[l][k] = impl_->id(mjOBJ_BODY, robot.legs[l].links[k].name);
      impl_->overwrite_inertia(impl_->body[l][k], robot.legs[l].links[k].inertia);
    }
  }
  impl_->overwrite_inertia(impl_->id(mjOBJ_BODY, robot.trunk.name), robot.trunk.inertia);
  impl_->data = mj_makeData(impl_->model);
  mj_setConst(impl_->model, impl_->data);
}

MujocoRobot::~MujocoRobot() = default;

void MujocoRobot::set_state(const RobotState& state) {
  mjData& d = *impl_->data;
  impl_->R_WD = state.R_WB * impl_->robot.R_description_B.transpose();
  const Eigen::Quaterniond quat(impl_->R_WD);
  const Vec3 omega_D = impl_->R_WD.transpose() * state.omega_WB;
  for (int i = 0; i < 3; ++i) {
    d.qpos[i] = state.p_WB[i];
    d.qvel[i] = state.v_WB[i];
    d.qvel[3 + i] = omega_D[i];
  }
  d.qpos[3] = quat.w();
  d.qpos[4] = quat.x();
  d.qpos[5] = quat.y();
  d.qpos[6] = quat.z();
  for (int l = 0; l < kLegs; ++l) {
    for (int k = 0; k < kJointsPerLeg; ++k) {
      d.qpos[impl_->qpos[l][k]] = state.q[3 * l + k];
      d.qvel[impl_->dof[l][k]] = state.qd[3 * l + k];
    }
  }
}

void MujocoRobot::compute(MujocoTerms& t) {
  const mjModel& m = *impl_->model;
  mjData& d = *impl_->data;
  mj_fwdPosition(&m, &d);
  mj_fwdVelocity(&m, &d);
  const Mat18 G = impl_->basis();
  Eigen::Matrix<double, 18, 18, Eigen::RowMajor> full;
  mj_fullM(&m, full.data(), d.qM);
  t.M = G * full * G.transpose();
  t.h = G * Eigen::Map<const Vec18>(d.qfrc_bias);
  const int trunk = impl_->id(mjOBJ_BODY, impl_->robot.trunk.name);
  t.p_com = Eigen::Map<const Vec3>(d.subtree_com + 3 * trunk);
  // Classical accelerations at v_dot = 0: MuJoCo's include -gravity.
  mju_zero(d.qacc, m.nv);
  mj_rnePostConstraint(&m, &d);
  const Vec3 gravity = Eigen::Map<const Vec3>(m.opt.gravity);
  for (int l = 0; l < kLegs; ++l) {
    const int body = impl_->body[l][kJointsPerLeg - 1];
    const Mat3 R = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(d.xmat + 9 * body);
    const Vec3 origin = Eigen::Map<const Vec3>(d.xpos + 3 * body);
    const Vec3 com = Eigen::Map<const Vec3>(d.xipos + 3 * body);
    const Vec3 foot = origin + R * impl_->robot.R_description_B * impl_->robot.legs[l].foot_center;
    t.p_foot[l] = foot;
    std::array<double, 3 * kDof> jac_p{}, jac_r{};
    mj_jac(&m, &d, jac_p.data(), jac_r.data(), foot.data(), body);
    t.J_foot[l] = rows3(jac_p.data(), kDof) * G.transpose();
    t.J_lower_angular[l] = rows3(jac_r.data(), kDof) * G.transpose();
    std::array<double, 6> acc{}, vel{};
    mj_objectAcceleration(&m, &d, mjOBJ_BODY, body, acc.data(), 0);
    mj_objectVelocity(&m, &d, mjOBJ_BODY, body, vel.data(), 0);
    const Vec3 alpha(acc[0], acc[1], acc[2]);
    const Vec3 omega(vel[0], vel[1], vel[2]);
    const Vec3 r = foot - com;  // mj_objectAcceleration refers to the inertial frame of the body
    t.Jdot_v_foot[l] = Vec3(acc[3], acc[4], acc[5]) + gravity + alpha.cross(r) + omega.cross(omega.cross(r));
  }
}

void MujocoRobot::compute_raw() {
  const mjModel& m = *impl_->model;
  mjData& d = *impl_->data;
  mj_fwdPosition(&m, &d);
  mj_fwdVelocity(&m, &d);
  std::array<double, static_cast<std::size_t>(kDof) * kDof> full{};
  mj_fullM(&m, full.data(), d.qM);
  mju_zero(d.qacc, m.nv);
  mj_rnePostConstraint(&m, &d);
  for (int l = 0; l < kLegs; ++l) {
    const int body = impl_->body[l][kJointsPerLeg - 1];
    std::array<double, 3 * kDof> jac_p{}, jac_r{};
    mj_jac(&m, &d, jac_p.data(), jac_r.data(), d.xpos + 3 * body, body);
    std::array<double, 6> acceleration{};
    mj_objectAcceleration(&m, &d, mjOBJ_BODY, body, acceleration.data(), 0);
  }
}

}  // namespace dob::oracle
