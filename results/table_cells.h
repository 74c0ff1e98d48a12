// How figures and names stand in a reader's table. Private to results/.
#pragma once

#include <string>

#include "results/cell.h"
#include "results/paired.h"
#include "results/table_rows.h"

namespace dob {

// About three digits: enough to compare, few enough to read.
std::string rounded(double x);

// "median / worst"; one figure where they are the same, "-" where there is none. `scale`: from SI to the unit.
std::string median_and_worst(const MetricSummary& metric, double scale);

// "[low, high]"
std::string interval_cell(const Interval& interval, double scale);

// "+1.23 [+1.01, +1.40]", the interval where there is one; "-" without pairs.
std::string difference_cell(const PairedDifference& difference, double scale);

std::string scenario_name(const CellKey& key);  // "case1 / knee"
std::string observer_name(const CellKey& key);  // "momentum (paper)"
std::string set_name(const CellKey& key);       // "gains paper, planner zmp", and the overrides

// Reasons come from anywhere: control characters become blanks.
std::string on_one_line(std::string text);

}  // namespace dob
