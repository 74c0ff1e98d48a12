#include "results/table_cells.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace dob {
namespace {

std::string with_sign(double x) {
  return fmt::format("{}{}", x > 0.0 ? "+" : "", rounded(x));
}

}  // namespace

std::string rounded(double x) {
  if (x == std::floor(x) && std::abs(x) < 1e6) return fmt::format("{:.0f}", x);
  const double size = std::abs(x);
  if (size >= 1e6) return fmt::format("{:.1e}", x);
  return fmt::format("{:.{}f}", x, size < 9.995 ? 2 : size < 99.95 ? 1 : 0);
}

std::string median_and_worst(const MetricSummary& metric, double scale) {
  if (!metric.median || !metric.worst) return "-";
  const std::string middle = rounded(*metric.median * scale), worst = rounded(*metric.worst * scale);
  return middle == worst ? middle : fmt::format("{} / {}", middle, worst);
}

std::string interval_cell(const Interval& interval, double scale) {
  return fmt::format("[{}, {}]", with_sign(interval.low * scale), with_sign(interval.high * scale));
}

std::string difference_cell(const PairedDifference& difference, double scale) {
  if (!difference.median) return "-";
  const std::string middle = with_sign(*difference.median * scale);
  return difference.ci95 ? middle + " " + interval_cell(*difference.ci95, scale) : middle;
}

std::string scenario_name(const CellKey& key) {
  return key.variant.empty() ? key.scenario : key.scenario + " / " + key.variant;
}

std::string observer_name(const CellKey& key) {
  return fmt::format("{} ({})", key.observer, key.profile);
}

std::string set_name(const CellKey& key) {
  const std::string set = key.overrides.empty() ? "" : fmt::format(", set {}", key.overrides);
  return fmt::format("gains {}, planner {}{}", key.gains, key.planner, set);
}

std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20; }, ' ');
  return text;
}

}  // namespace dob
