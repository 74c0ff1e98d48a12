#include "bench/tuning.h"

#include <cmath>
#include <map>
#include <random>

#include <fmt/format.h>

#include "scenarios/loader.h"
#include "sim/random_stream.h"

namespace dob {
namespace {

// Fixed seed of an observer's draws: FNV-1a of its name.
std::uint64_t seed_of(const std::string& name) noexcept {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return hash;
}

struct Draw {
  std::mt19937_64& random;

  std::string operator()(const TuningRange& range) const {
    return fmt::format("{:.3g}", range.low * std::pow(range.high / range.low, uniform(random)));
  }
  std::string operator()(const std::vector<std::string>& words) const {
    return words[static_cast<std::size_t>(uniform(random) * static_cast<double>(words.size()))];
  }
};

}  // namespace

std::vector<std::string> tuning_candidates(const std::string& observer, const std::vector<TuningParameter>& space,
                                           int count) {
  std::mt19937_64 random(seed_of(observer));
  std::vector<std::string> candidates{observer};
  while (static_cast<int>(candidates.size()) < count) {
    std::string specification = observer;
    char separator = ':';
    for (const TuningParameter& p : space) {
      specification += fmt::format("{}{}={}", separator, p.key, std::visit(Draw{random}, p.values));
      separator = ',';
    }
    candidates.push_back(specification);
  }
  return candidates;
}

TuningResult judge(const std::string& specification, const std::vector<CellResult>& cells,
                   const TuningProcedure& procedure) {
  constexpr double kFall = 10.0;
  TuningResult r{.specification = specification};
  int survivors = 0;
  for (const CellResult& cell : cells) {
    if (cell.key.observer != specification) continue;
    ++r.runs;
    if (cell.outcome != Outcome::kSurvived) {
      ++r.falls;
      r.score += kFall + 1.0 - std::min(1.0, cell.simulated_s / procedure.duration);
      continue;
    }
    ++survivors;
    const double com = cell.metrics.com_error_max_m.value_or(0.0);
    const double foot = cell.metrics.foot_error_max_m.value_or(0.0);
    r.com_error_max += com;
    r.foot_error_max += foot;
    r.score += com / procedure.com_scale + foot / procedure.foot_scale;
  }
  if (r.runs > 0) r.score /= r.runs;
  if (survivors > 0) {
    r.com_error_max /= survivors;
    r.foot_error_max /= survivors;
  }
  return r;
}

std::vector<TuningResult> tune(const std::string& observer, int budget, const BatchOptions& options, int& stop_signal) {
  const TuningProcedure procedure = load_tuning_procedure();
  BatchRequest request;
  request.scenarios = procedure.scenarios;
  request.observers = tuning_candidates(observer, load_tuning_space(observer), budget);
  request.profiles = {procedure.profile};
  request.gains = {procedure.gains};
  request.planner = procedure.planner;
  request.overrides = {fmt::format("duration_s={}", procedure.duration)};
  request.first_seed = procedure.first_seed;
  request.last_seed = procedure.last_seed;
  const BatchSummary summary = run_batch(plan_batch(request), options);
  stop_signal = summary.stop_signal;
  if (stop_signal != 0) return {};
  const std::vector<CellResult> cells = read_cells(summary.dir);
  std::vector<TuningResult> results;
  for (const std::string& specification : request.observers) results.push_back(judge(specification, cells, procedure));
  return results;
}

}  // namespace dob
