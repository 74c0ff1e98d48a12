#include "results/claim_finding.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "results/metric_fields.h"
#include "results/statistics.h"

namespace dob {
namespace {

struct Unit {
  std::string_view ending;  // of the metric's name
  std::string_view key;     // in a claim's keys
  std::string_view shown;
  double scale;  // from the metric's unit to the one shown
};

constexpr std::array kUnits{Unit{"m", "m", " mm", 1e3},      Unit{"N", "N", " N", 1.0},
                            Unit{"Nm", "Nm", " N m", 1.0},   Unit{"s", "s", " s", 1.0},
                            Unit{"rad", "rad", " rad", 1.0}, Unit{"overshoot", "", " %", 1e2},
                            Unit{"ratio", "", " %", 1e2}};
constexpr Unit kNumber{"", "", "", 1.0};

const Unit& unit(std::size_t metric) {
  const std::string_view name = kMetricFields.at(metric).name;
  const std::string_view last = name.substr(name.rfind('_') + 1);
  const auto found = std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& u) { return u.ending == last; });
  return found == kUnits.end() ? kNumber : *found;
}

}  // namespace

std::string_view to_string(Verdict verdict) noexcept {
  constexpr std::array<std::string_view, 3> kWords{"yes", "no", "no data"};
  return kWords[static_cast<std::size_t>(verdict)];
}

Finding no_data(std::string remark) {
  Finding finding;
  finding.remark = std::move(remark);
  return finding;
}

std::vector<Sample> samples_of(const std::vector<const CellGroup*>& groups, std::size_t metric) {
  std::vector<Sample> samples;
  for (const CellGroup* group : groups) {
    for (const CellResult* cell : group->ran) {
      if (cell->outcome != Outcome::kSurvived) continue;
      if (const auto value = kMetricFields.at(metric).of(cell->metrics)) samples.push_back({*value, group});
    }
  }
  return samples;
}

std::optional<double> median_of(const std::vector<Sample>& samples) {
  std::vector<double> values;
  values.reserve(samples.size());
  for (const Sample& sample : samples) values.push_back(sample.value);
  return values.empty() ? std::nullopt : std::optional(median(values));
}

void count_falls(const std::vector<const CellGroup*>& groups, Finding& finding) {
  std::vector<double> times;
  for (const CellGroup* group : groups) {
    finding.runs += static_cast<int>(group->ran.size());
    for (const CellResult* cell : group->ran) {
      if (cell->outcome == Outcome::kFell) times.push_back(cell->simulated_s);
    }
  }
  finding.falls = static_cast<int>(times.size());
  if (!times.empty()) finding.fall_time_median_s = median(times);
}

std::string describe_falls(const Finding& finding) {
  const std::string share = fmt::format("falls {}/{}", finding.falls, finding.runs);
  return finding.fall_time_median_s ? fmt::format("{} ({:.1f} s)", share, *finding.fall_time_median_s) : share;
}

std::string_view unit_of(std::size_t metric) {
  return unit(metric).key;
}

std::string describe(std::size_t metric, double value) {
  return fmt::format("{:.3g}{}", value * unit(metric).scale, unit(metric).shown);
}

std::string describe(std::size_t metric, double median, double worst, std::size_t runs) {
  const double scale = unit(metric).scale;
  return runs < 2 ? describe(metric, worst)
                  : fmt::format("{:.3g} ({:.3g}){}", median * scale, worst * scale, unit(metric).shown);
}

}  // namespace dob
