// One cell of a batch: its key, how it ended, its metrics. The row of the store and the atom of every table.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "results/time_histogram.h"

namespace dob {

struct CellKey {
  std::string scenario, variant, observer, profile, gains, planner, overrides;
  int seed = 1;

  friend auto operator<=>(const CellKey&, const CellKey&) = default;  // NOLINT(modernize-use-nullptr): a false alarm
};

enum class Outcome { kSurvived, kFell, kError };

// Definitions: docs/metrics.md. nullopt where a metric does not apply.
struct CellMetrics {
  std::optional<double> com_error_max_m, com_error_rms_m, com_error_p99_m, path_error_max_m;
  std::optional<double> foot_error_max_m, foot_error_p99_m, foot_error_onset_max_m, foot_error_stance_max_m;
  std::optional<double> foothold_error_max_m, grf_error_mean_N;
  std::optional<double> estimate_rmse_N, joint_estimate_rmse_Nm;
  std::optional<double> com_force_rmse_N, com_moment_rmse_Nm;
  std::optional<double> orientation_error_max_rad, torque_saturation_ratio, slip_max_m;
  // What only the claims ask for: results/claim_metrics.h.
  std::optional<double> estimate_offset_Nm, estimate_overshoot, estimate_settling_s;
  std::optional<double> com_error_swing_max_m, com_error_stance_max_m;
  std::optional<double> com_peak_before_m, com_peak_push_m, com_peak_recovery_m;
  std::optional<double> foot_peak_push_m, foot_peak_rest_m;
  long qp_solves = 0;
  long planner_failures = 0;  // ZMP optimisations that did not end optimal; the regularised path was walked
  long qp_failures = 0;       // solves that did not end optimal; the fallback was used
};

// The metrics of a trial up to a moment: what a comparison with a trial that ended earlier needs.
struct MetricsCheckpoint {
  double t = 0.0;  // [s]
  std::optional<double> com_error_max_m, com_error_rms_m, path_error_max_m, foot_error_max_m, grf_error_mean_N;
};

// An observer that saw what the cell's observer saw and changed nothing.
struct ShadowResult {
  std::string observer, profile;
  std::optional<double> estimate_rmse_N, joint_estimate_rmse_Nm;
  std::optional<double> com_force_rmse_N, com_moment_rmse_Nm;
};

struct CellResult {
  CellKey key;
  Outcome outcome = Outcome::kError;
  std::string reason;            // why it fell or could not be run; empty when it survived
  double simulated_s = 0.0;      // [s]
  double wall_s = 0.0;           // [s] of the whole trial, next to whatever else ran; no measure of speed
  std::uint64_t state_hash = 0;  // of every state of the trajectory, bit for bit
  CellMetrics metrics;
  std::vector<MetricsCheckpoint> checkpoints;  // in the order of time
  std::vector<ShadowResult> shadows;
  std::string trace;  // file of its time series, relative to the run directory; "": none was kept
};

// What a serial pass has measured of a cell: how long the work of a control tick takes.
struct CellTiming {
  CellKey key;
  double tick_p50_us = 0.0, tick_p99_us = 0.0, tick_max_us = 0.0;  // [us] model, observer, controller with its QP
  double qp_p50_us = 0.0, qp_p99_us = 0.0, qp_max_us = 0.0;        // [us] ticks' QP, at ticks where one was solved
  double real_time_factor = 0.0;                                   // simulated over wall time, simulator included
  TimeHistogram tick_histogram, qp_histogram;                      // of the same; empty: not kept
};

}  // namespace dob
