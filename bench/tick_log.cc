#include "bench/tick_log.h"

#include <cctype>
#include <iterator>

#include <fmt/format.h>

#include "results/store.h"

namespace dob {
namespace {

template <typename Vector>
void append(std::string& line, const Vector& v) {
  for (int i = 0; i < v.size(); ++i) fmt::format_to(std::back_inserter(line), ",{}", v[i]);
}

void append_names(std::string& line, std::string_view name, std::string_view unit) {
  for (const char axis : {'x', 'y', 'z'}) fmt::format_to(std::back_inserter(line), ",{}_{}_{}", name, axis, unit);
}

std::string header() {
  std::string line = "t_s";
  append_names(line, "com", "m");
  append_names(line, "com_reference", "m");
  line +=
      ",path_x_m,path_y_m,orientation_error_rad,zmp_reference_x_m,zmp_reference_y_m,zmp_margin_m,cop_x_m,cop_y_m,zmp_"
      "planned,zmp_status,zmp_active_rows,zmp_slack_m";
  for (const std::string_view leg : kLegNames) {
    fmt::format_to(std::back_inserter(line), ",{}_stance", leg);
    append_names(line, fmt::format("{}_foot", leg), "m");
    append_names(line, fmt::format("{}_foot_reference", leg), "m");
    fmt::format_to(std::back_inserter(line), ",{}_foothold_clamped", leg);
    append_names(line, fmt::format("{}_force_commanded", leg), "N");
    append_names(line, fmt::format("{}_force", leg), "N");
    for (const std::string_view what : {"torque", "estimate", "true_disturbance"}) {
      for (const std::string_view joint : kLegLinkNames) {
        fmt::format_to(std::back_inserter(line), ",{}_{}_{}_Nm", leg, joint, what);
      }
    }
  }
  append_names(line, "force_estimate", "N");
  append_names(line, "force_true", "N");
  line += ",disturbance_active,saturated_joints,qp_solved,qp_status,qp_iterations\n";
  return line;
}

}  // namespace

TickLog::TickLog(const std::filesystem::path& file) : file_(file), out_(file) {
  out_ << header();
  if (!out_) throw StoreError(fmt::format("{}: cannot be written", file.string()));
}

void TickLog::add(const TickRecord& r) {
  line_.clear();
  fmt::format_to(std::back_inserter(line_), "{}", r.t);
  append(line_, r.com);
  append(line_, r.com_reference);
  append(line_, r.path_position);
  fmt::format_to(std::back_inserter(line_), ",{}", r.orientation_error);
  append(line_, r.zmp_reference);
  fmt::format_to(std::back_inserter(line_), ",{}", r.zmp_margin);
  append(line_, r.center_of_pressure);
  fmt::format_to(std::back_inserter(line_), ",{},{},{},{}", r.zmp_planned ? 1 : 0, to_string(r.zmp_status),
                 r.zmp_active_rows, r.zmp_slack);
  for (int l = 0; l < kLegs; ++l) {
    fmt::format_to(std::back_inserter(line_), ",{}", r.stance[l] ? 1 : 0);
    append(line_, r.foot[l]);
    append(line_, r.foot_reference[l]);
    fmt::format_to(std::back_inserter(line_), ",{}", r.foothold_clamped[l] ? 1 : 0);
    append(line_, r.foot_force_commanded.segment<3>(3 * l));
    append(line_, r.foot_force.segment<3>(3 * l));
    append(line_, r.joint_torque.segment<3>(3 * l));
    append(line_, r.leg_torque_estimate.segment<3>(3 * l));
    append(line_, r.leg_torque_true.segment<3>(3 * l));
  }
  append(line_, r.force_estimate);
  append(line_, r.force_true);
  fmt::format_to(std::back_inserter(line_), ",{},{},{},{},{}\n", r.disturbance_active ? 1 : 0, r.saturated_joints,
                 r.qp_solved ? 1 : 0, to_string(r.qp_status), r.qp_iterations);
  out_ << line_;
}

void TickLog::close() {
  out_.close();
  if (!out_) throw StoreError(fmt::format("{}: could not be written completely", file_.string()));
}

std::string log_name(const CellKey& key) {
  std::string name = fmt::format("{}_{}_{}_{}_{}_{}_seed{}", key.scenario, key.variant, key.observer, key.profile,
                                 key.gains, key.planner, key.seed);
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '_' && c != '-') c = '_';
  }
  return name + ".csv";
}

}  // namespace dob
