#include "bench/signals.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace dob {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

using Record = TickRecord;

class SignalList {
 public:
  template <typename Value>
  void add(std::string name, Value value) {
    signals_.push_back({std::move(name), [value](const Record& r) { return static_cast<double>(value(r)); }});
  }

  // x, y (, z) of a vector.
  template <typename Vector>
  void add_axes(const std::string& name, std::string_view unit, int size, Vector vector) {
    for (int i = 0; i < size; ++i) {
      add(fmt::format("{}/{}_{}", name, "xyz"[i], unit), [vector, i](const Record& r) { return vector(r)[i]; });
    }
  }

  std::vector<Signal> take() { return std::move(signals_); }

 private:
  std::vector<Signal> signals_;
};

void add_body(SignalList& list) {
  list.add_axes("com", "m", 3, [](const Record& r) { return r.com; });
  list.add_axes("com_reference", "m", 3, [](const Record& r) { return r.com_reference; });
  list.add("com_error_m", [](const Record& r) { return (r.com - r.com_reference).norm(); });
  list.add_axes("path", "m", 2, [](const Record& r) { return r.path_position; });
  list.add_axes("trunk", "m", 3, [](const Record& r) { return r.trunk; });
  list.add("trunk/qw", [](const Record& r) { return r.trunk_rotation.w(); });
  list.add("trunk/qx", [](const Record& r) { return r.trunk_rotation.x(); });
  list.add("trunk/qy", [](const Record& r) { return r.trunk_rotation.y(); });
  list.add("trunk/qz", [](const Record& r) { return r.trunk_rotation.z(); });
  list.add("orientation_error_rad", [](const Record& r) { return r.orientation_error; });
}

void add_balance(SignalList& list) {
  list.add_axes("zmp/reference", "m", 2, [](const Record& r) { return r.zmp_reference; });
  list.add("zmp/margin_m", [](const Record& r) { return r.zmp_margin; });
  list.add_axes("zmp/cop", "m", 2, [](const Record& r) { return r.center_of_pressure; });
  list.add("zmp/planned", [](const Record& r) { return r.zmp_planned; });
  list.add("zmp/status", [](const Record& r) { return static_cast<int>(r.zmp_status); });
  list.add("zmp/active_rows", [](const Record& r) { return r.zmp_active_rows; });
  list.add("zmp/slack_m", [](const Record& r) { return r.zmp_slack; });
}

void add_joint(SignalList& list, const std::string& name, int j) {
  list.add(name + "/angle_rad", [j](const Record& r) { return r.joint_angle[j]; });
  list.add(name + "/torque_Nm", [j](const Record& r) { return r.joint_torque[j]; });
  list.add(name + "/estimate_Nm",
           [j](const Record& r) { return r.has_leg_estimate ? r.leg_torque_estimate[j] : kNone; });
  list.add(name + "/true_disturbance_Nm", [j](const Record& r) { return r.leg_torque_true[j]; });
}

void add_leg(SignalList& list, std::size_t l) {
  const std::string leg(kLegNames[l]);
  const auto first = 3 * static_cast<int>(l);
  list.add(leg + "/stance", [l](const Record& r) { return r.stance[l]; });
  list.add_axes(leg + "/foot", "m", 3, [l](const Record& r) { return r.foot[l]; });
  list.add_axes(leg + "/foot_reference", "m", 3, [l](const Record& r) { return r.foot_reference[l]; });
  list.add(leg + "/foot_error_m", [l](const Record& r) { return (r.foot[l] - r.foot_reference[l]).norm(); });
  list.add_axes(leg + "/foothold", "m", 3, [l](const Record& r) { return r.foothold[l]; });
  list.add(leg + "/foothold_clamped", [l](const Record& r) { return r.foothold_clamped[l]; });
  list.add_axes(leg + "/force_commanded", "N", 3,
                [first](const Record& r) { return Vec3(r.foot_force_commanded.segment<3>(first)); });
  list.add_axes(leg + "/force", "N", 3, [first](const Record& r) { return Vec3(r.foot_force.segment<3>(first)); });
  for (int j = 0; j < kJointsPerLeg; ++j) {
    add_joint(list, fmt::format("{}/{}", leg, kLegLinkNames[static_cast<std::size_t>(j)]), first + j);
  }
}

void add_disturbance(SignalList& list) {
  const auto if_made = [](bool made, const Vec3& v) { return made ? v : Vec3::Constant(kNone).eval(); };
  list.add_axes("force_estimate", "N", 3,
                [=](const Record& r) { return if_made(r.has_force_estimate, r.force_estimate); });
  list.add_axes("force_true", "N", 3, [](const Record& r) { return r.force_true; });
  list.add_axes("com_force_estimate", "N", 3,
                [=](const Record& r) { return if_made(r.has_com_estimate, r.com_wrench_estimate.head<3>()); });
  list.add_axes("com_moment_estimate", "Nm", 3,
                [=](const Record& r) { return if_made(r.has_com_estimate, r.com_wrench_estimate.tail<3>()); });
  list.add_axes("com_force_true", "N", 3, [](const Record& r) { return Vec3(r.com_wrench_true.head<3>()); });
  list.add_axes("com_moment_true", "Nm", 3, [](const Record& r) { return Vec3(r.com_wrench_true.tail<3>()); });
  list.add("applied/forces", [](const Record& r) { return r.applied_forces; });
  list.add_axes("applied/point", "m", 3,
                [=](const Record& r) { return if_made(r.applied_forces > 0, r.applied_point); });
  list.add_axes("applied/force", "N", 3, [](const Record& r) { return r.applied_force; });
  list.add("disturbance_active", [](const Record& r) { return r.disturbance_active; });
}

}  // namespace

std::vector<Signal> tick_signals() {
  SignalList list;
  list.add("t_s", [](const Record& r) { return r.t; });
  add_body(list);
  add_balance(list);
  for (std::size_t l = 0; l < kLegs; ++l) add_leg(list, l);
  add_disturbance(list);
  list.add("saturated_joints", [](const Record& r) { return r.saturated_joints; });
  list.add("qp/solved", [](const Record& r) { return r.qp_solved; });
  list.add("qp/status", [](const Record& r) { return static_cast<int>(r.qp_status); });
  list.add("qp/iterations", [](const Record& r) { return r.qp_iterations; });
  return list.take();
}

Decimation::Decimation(double rate, double dt)
    : stride_(std::max(1L, std::lround(1.0 / (rate * dt)))), rate_(1.0 / (static_cast<double>(stride_) * dt)) {}

}  // namespace dob
