// What an evaluator of a claim answers, and what all evaluators share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/claim_cells.h"

namespace dob {

enum class Verdict { kYes, kNo, kNoData };

std::string_view to_string(Verdict verdict) noexcept;  // yes, no, no data

struct Finding {
  Verdict verdict = Verdict::kNoData;
  bool settled = false;                 // a no that further seeds cannot turn
  std::optional<double> median, worst;  // over the seeds, in the metric's own unit
  int runs = 0;
  int falls = 0;
  std::optional<double> fall_time_median_s;
  std::string measured;  // the same for readers: millimetres, three digits
  std::string remark;    // why there is no data, or what the figure hides
};

// The finding that there is nothing to judge by.
Finding no_data(std::string remark);

// One figure of one run, and whose it is.
struct Sample {
  double value;
  const CellGroup* group;
};

// Of every run that survived and has the metric (index into kMetricFields): figures of a run that fell are those of its
// fall.
std::vector<Sample> samples_of(const std::vector<const CellGroup*>& groups, std::size_t metric);

// The median of samples; nullopt without any.
std::optional<double> median_of(const std::vector<Sample>& samples);

// Runs, falls and their median time over the groups.
void count_falls(const std::vector<const CellGroup*>& groups, Finding& finding);

// "falls 1/3 (25.1 s)"
std::string describe_falls(const Finding& finding);

// A metric's unit as the last part of its name: m, N, Nm, s, rad; empty for a number.
std::string_view unit_of(std::size_t metric);

// "17.5 mm"
std::string describe(std::size_t metric, double value);
// "17.5 (17.6) mm": median and worst; one figure for one run
std::string describe(std::size_t metric, double median, double worst, std::size_t runs);

}  // namespace dob
