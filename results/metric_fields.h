// The metrics of a cell by name, in the order of the table's fields. Store and tables read this one list.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "results/cell.h"

namespace dob {

struct MetricField {
  std::string_view name;                                // with its unit, as in every file and table
  std::optional<double> CellMetrics::*value = nullptr;  // one of the two
  long CellMetrics::*count = nullptr;

  std::optional<double> of(const CellMetrics& m) const {
    return value != nullptr ? m.*value : std::optional(static_cast<double>(m.*count));
  }
};

inline constexpr std::array kMetricFields{
    MetricField{"com_error_max_m", &CellMetrics::com_error_max_m},
    MetricField{"com_error_rms_m", &CellMetrics::com_error_rms_m},
    MetricField{"com_error_p99_m", &CellMetrics::com_error_p99_m},
    MetricField{"path_error_max_m", &CellMetrics::path_error_max_m},
    MetricField{"foot_error_max_m", &CellMetrics::foot_error_max_m},
    MetricField{"foot_error_p99_m", &CellMetrics::foot_error_p99_m},
    MetricField{"foot_error_onset_max_m", &CellMetrics::foot_error_onset_max_m},
    MetricField{"foot_error_stance_max_m", &CellMetrics::foot_error_stance_max_m},
    MetricField{"foothold_error_max_m", &CellMetrics::foothold_error_max_m},
    MetricField{"grf_error_mean_N", &CellMetrics::grf_error_mean_N},
    MetricField{"estimate_rmse_N", &CellMetrics::estimate_rmse_N},
    MetricField{"joint_estimate_rmse_Nm", &CellMetrics::joint_estimate_rmse_Nm},
    MetricField{"com_force_rmse_N", &CellMetrics::com_force_rmse_N},
    MetricField{"com_moment_rmse_Nm", &CellMetrics::com_moment_rmse_Nm},
    MetricField{"orientation_error_max_rad", &CellMetrics::orientation_error_max_rad},
    MetricField{"torque_saturation_ratio", &CellMetrics::torque_saturation_ratio},
    MetricField{"qp_failures", nullptr, &CellMetrics::qp_failures},
    MetricField{"slip_max_m", &CellMetrics::slip_max_m},
    MetricField{"planner_failures", nullptr, &CellMetrics::planner_failures},
    MetricField{"estimate_offset_Nm", &CellMetrics::estimate_offset_Nm},
    MetricField{"estimate_overshoot", &CellMetrics::estimate_overshoot},
    MetricField{"estimate_settling_s", &CellMetrics::estimate_settling_s},
    MetricField{"com_error_swing_max_m", &CellMetrics::com_error_swing_max_m},
    MetricField{"com_error_stance_max_m", &CellMetrics::com_error_stance_max_m},
    MetricField{"com_peak_before_m", &CellMetrics::com_peak_before_m},
    MetricField{"com_peak_push_m", &CellMetrics::com_peak_push_m},
    MetricField{"com_peak_recovery_m", &CellMetrics::com_peak_recovery_m},
    MetricField{"foot_peak_push_m", &CellMetrics::foot_peak_push_m},
    MetricField{"foot_peak_rest_m", &CellMetrics::foot_peak_rest_m},
};

// Index of a name in kMetricFields; a name that is not there does not compile.
consteval std::size_t metric_index(std::string_view name) {
  for (std::size_t i = 0; i < kMetricFields.size(); ++i) {
    if (kMetricFields[i].name == name) return i;
  }
  throw "no such metric";  // NOLINT: never thrown, ends the compilation
}

}  // namespace dob
