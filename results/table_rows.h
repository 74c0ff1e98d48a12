// The rows of the comparison table as numbers: cells grouped over their seeds.
//
// Which runs enter a metric: those that SURVIVED. The errors of a run that fell cover another stretch of time and
// would flatter or condemn it at random, so they stay out; falls and their times have fields of their own. Only when
// no run of the row survived do the metrics come from the fallen ones, up to their falls, and until_fall says so.
// Cells that could not be run are errors: counted, with their reason, and in nothing else.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "results/metric_fields.h"
#include "results/paired.h"
#include "results/statistics.h"
#include "results/table.h"

namespace dob {

// Over those seeds that have the metric; nullopt if none has.
struct MetricSummary {
  std::optional<double> median, worst;
  std::optional<Interval> ci95;  // bootstrap, of the median
};

// Of a serial pass: medians over the seeds that were timed, of the longest tick and QP the longest.
struct TimingSummary {
  double tick_p50_us = 0.0, tick_p99_us = 0.0, tick_max_us = 0.0;  // [us]
  double qp_p50_us = 0.0, qp_p99_us = 0.0, qp_max_us = 0.0;        // [us]
  double real_time_factor = 0.0;                                   // simulated / wall time of the trial
};

struct TableRow {
  CellKey key;    // its seed has no meaning
  int seeds = 0;  // that belong to the row, run yet or not
  int runs = 0;   // cells that ran: survived or fell
  int falls = 0;
  int errors = 0;                            // cells that could not be run
  std::optional<double> fall_time_median_s;  // over the runs that fell
  std::optional<Interval> falls_ci95;        // Wilson, of falls / runs
  std::array<MetricSummary, kMetricFields.size()> metrics;
  std::optional<TimingSummary> timing;
  bool oracle = false;      // a bound: never ranked
  std::optional<int> rank;  // 1 is best, within the block; nullopt for an oracle and where nothing was run
  // Filled by compare_with_reference() only: this row minus the reference, pair by pair.
  std::string reference;  // the row it is compared with, OBSERVER@PROFILE; "" if there is none or it is this row
  std::array<PairedDifference, kPairedMetrics.size()> paired;
  bool until_fall = false;                // metrics are those of fallen runs, up to the fall
  std::string fall_reason, error_reason;  // distinct ones in the order of the seeds, joined by "; "
};

// In the order of the run's scenarios, then observers (or the other way round): the order of first mention in
// run.info.cells. A row whose cells have not been run yet is there, with runs = 0.
std::vector<TableRow> build_rows(const Run& run, TableOrder order);

// Whether rows compete: they agree in everything but observer and profile.
bool same_block(const CellKey& a, const CellKey& b) noexcept;

// Ranks each row within its block. Better is, in this order: a smaller share of runs lost (falls and errors), so that a
// fall ranks behind every survivor; a smaller median of com_error_max_m, or, where every run was lost, a later fall.
// Equals share a rank.
void rank_rows(std::vector<TableRow>& rows);

MetricSummary summarise(const std::vector<double>& samples);
CellKey without_seed(CellKey key);

}  // namespace dob
