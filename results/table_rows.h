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
#include "results/statistics.h"
#include "results/table.h"

namespace dob {

// Over those seeds that have the metric; nullopt if none has.
struct MetricSummary {
  std::optional<double> median, worst;
  std::optional<Interval> ci95;  // bootstrap, of the median
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
  std::optional<double> real_time_factor;  // median of simulated / wall time over the runs
  bool until_fall = false;                 // metrics are those of fallen runs, up to the fall
  std::string fall_reason, error_reason;   // distinct ones in the order of the seeds, joined by "; "
};

// In the order of the run's scenarios, then observers (or the other way round): the order of first mention in
// run.info.cells. A row whose cells have not been run yet is there, with runs = 0.
std::vector<TableRow> build_rows(const Run& run, TableOrder order);

}  // namespace dob
