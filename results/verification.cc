#include "results/verification.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/metric_fields.h"
#include "results/store.h"

namespace dob {
namespace {

constexpr MetricField kTime{"simulated_s"};

std::optional<double> value_of(const CellResult& cell, const MetricField& field) {
  return field.name == kTime.name ? cell.simulated_s : field.of(cell.metrics);
}

// "fell at 1.234 s (trunk low)"
std::string ending(const CellResult& cell) {
  switch (cell.outcome) {
    case Outcome::kSurvived:
      return fmt::format("survived {} s", cell.simulated_s);
    case Outcome::kFell:
      return fmt::format("fell at {} s ({})", cell.simulated_s, cell.reason);
    case Outcome::kError:
      break;
  }
  return fmt::format("error ({})", cell.reason);
}

// All that a row holds beside how long it took and where its time series are, as a text that is the same for the same
// bits.
std::string bits_of(CellResult cell) {
  cell.wall_s = 0.0;
  cell.trace.clear();
  return cell_to_line(cell);
}

bool same_bits(const std::optional<double>& a, const std::optional<double>& b) {
  if (!a || !b) return !a && !b;
  return std::bit_cast<std::uint64_t>(*a) == std::bit_cast<std::uint64_t>(*b);
}

std::string or_null(const std::optional<double>& x) {
  return x ? fmt::format("{}", *x) : "null";
}

std::string differences(const CellResult& stored, const CellResult& again) {
  constexpr std::size_t kShown = 2;  // metrics
  std::vector<std::string> parts;
  if (stored.state_hash != again.state_hash) {
    parts.push_back(fmt::format("state hash {:016x} stored, {:016x} now", stored.state_hash, again.state_hash));
  } else {
    parts.emplace_back("the same trajectory by its hash, another row");
  }
  if (ending(stored) != ending(again)) parts.push_back(fmt::format("{} stored, {} now", ending(stored), ending(again)));
  std::size_t metrics = 0;
  for (const MetricField& field : kMetricFields) {
    const auto a = field.of(stored.metrics), b = field.of(again.metrics);
    if (same_bits(a, b) || ++metrics > kShown) continue;
    parts.push_back(fmt::format("{} {} stored, {} now", field.name, or_null(a), or_null(b)));
  }
  if (metrics > kShown) parts.push_back(fmt::format("{} more metrics", metrics - kShown));
  return fmt::format("{}", fmt::join(parts, "; "));
}

void add(MetricSpread& spread, const MetricField& field, const CellPair& pair) {
  const auto a = value_of(pair.first, field), b = value_of(pair.second, field);
  if (a.has_value() != b.has_value()) ++spread.one_sided;
  if (!a || !b) return;
  ++spread.cells;
  if (same_bits(a, b)) return;
  ++spread.different;
  const double scale = std::max(std::abs(*a), std::abs(*b));
  const double relative = scale > 0.0 ? std::abs(*a - *b) / scale : 0.0;
  if (relative >= std::max(spread.largest, spread.largest_fell)) spread.where = pair.first.key;
  double& largest = pair.first.outcome == Outcome::kFell ? spread.largest_fell : spread.largest;
  largest = std::max(largest, relative);
}

}  // namespace

VerifiedCell verified(const CellResult& stored, const CellResult& again) {
  const auto verdict = [&](Reproduced v, const std::string& detail) { return VerifiedCell{stored.key, v, detail}; };
  const bool error_then = stored.outcome == Outcome::kError, error_now = again.outcome == Outcome::kError;
  if (error_then && stored.reason.starts_with("timeout")) {
    return verdict(Reproduced::kNotVerified, "the stored row is a timeout: " + stored.reason);
  }
  if (error_now && !error_then) return verdict(Reproduced::kNotVerified, "could not be run again: " + again.reason);
  if (stored.outcome != again.outcome) {
    return verdict(Reproduced::kFlipped, fmt::format("{} stored, {} now", ending(stored), ending(again)));
  }
  if (bits_of(stored) == bits_of(again)) return verdict(Reproduced::kEqual, "");
  if (error_then) {
    return verdict(Reproduced::kDifferent, fmt::format("{} stored, {} now", ending(stored), ending(again)));
  }
  return verdict(Reproduced::kDifferent, differences(stored, again));
}

std::vector<MetricSpread> metric_spreads(const std::vector<CellPair>& pairs) {
  std::vector<MetricField> fields{kTime};
  fields.insert(fields.end(), kMetricFields.begin(), kMetricFields.end());
  std::vector<MetricSpread> spreads;
  for (const MetricField& field : fields) {
    MetricSpread spread{.metric = field.name};
    for (const CellPair& pair : pairs) {
      if (pair.first.outcome != pair.second.outcome || pair.first.outcome == Outcome::kError) continue;
      add(spread, field, pair);
    }
    if (spread.cells + spread.one_sided > 0) spreads.push_back(spread);
  }
  return spreads;
}

std::size_t Verification::count(Reproduced verdict) const {
  return static_cast<std::size_t>(
      std::count_if(cells.begin(), cells.end(), [&](const VerifiedCell& cell) { return cell.verdict == verdict; }));
}

}  // namespace dob
