#include "bench/verify.h"

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/batch.h"
#include "bench/cell_runs.h"
#include "bench/progress.h"
#include "bench/stored_cells.h"

namespace dob {
namespace {

// What differs between the programs of the sampled rows and this one.
std::string across_what(const Run& run, const std::vector<std::size_t>& sample) {
  std::set<std::size_t> programs;
  for (const std::size_t cell : sample) programs.insert(run.program_of[cell]);
  const Provenance here = run_info({}, "").provenance();
  std::vector<std::string> different;
  for (const std::size_t program : programs) {
    const std::string difference = differences(run.programs[program], here);
    if (!difference.empty()) different.push_back(difference);
  }
  return fmt::format("{}", fmt::join(different, "; and "));
}

class Verify {
 public:
  Verify(const std::filesystem::path& dir, const VerifyOptions& options)
      : options_(options), run_(read_run(dir)), stored_(dir, run_.info, options.plugins) {
    if (run_.cells.empty()) throw StoreError(dir.string() + ": holds no finished cell, so there is nothing to verify");
    sample_ = draw_sample(run_.cells.size(), options.sample, options.seed);
    Verification& v = result_.verification;
    v.dir = dir.string();
    v.planned = run_.info.cells.size();
    v.finished = run_.cells.size();
    v.seed = options.seed;
    v.across = across_what(run_, sample_);
    if (!v.across.empty() && !options.across) {
      throw StoreError(fmt::format("{}: cannot be compared bit for bit: {}; --across compares outcomes and metrics",
                                   dir.string(), v.across));
    }
  }

  VerifyResult run() {
    sort_out();
    compute();
    for (auto& [cell, verdict] : verdicts_) result_.verification.cells.push_back(std::move(verdict));
    if (options_.across) result_.verification.spreads = metric_spreads(pairs_);
    return std::move(result_);
  }

 private:
  void sort_out() {
    for (const std::size_t cell : sample_) {
      StoredCell stored = stored_.of(run_.cells[cell]);
      if (stored.obstacle.empty()) {
        again_.emplace_back(cell, std::move(stored));
      } else {
        verdicts_[cell] = {run_.cells[cell].key, Reproduced::kNotVerified, stored.obstacle};
      }
    }
    std::stable_sort(again_.begin(), again_.end(), [](const auto& a, const auto& b) {
      return a.second.scenario->duration > b.second.scenario->duration;  // so that the last ones to end are short
    });
  }

  void compute() {
    CellKeys keys;
    double cost = 0.0;
    for (const auto& [cell, stored] : again_) {
      keys.push_back(stored.key);
      cost += stored.scenario->duration;
    }
    Progress progress(sample_.size(), verdicts_.size(), cost, options_.progress);
    const auto compute_one = [&](std::size_t i) {
      const StoredCell& stored = again_[i].second;
      return run_cell(stored.key, *stored.scenario, stored.observer);
    };
    const auto done = [&](std::size_t i, const CellResult& result) {
      const std::size_t cell = again_[i].first;
      verdicts_[cell] = verified(run_.cells[cell], result);
      if (options_.across) pairs_.emplace_back(run_.cells[cell], result);
      progress.add(result, again_[i].second.scenario->duration);
    };
    result_.stop_signal =
        run_cells(keys, {options_.jobs, options_.timeout_s, kDefaultMemoryLimit_MB}, compute_one, done);
  }

  const VerifyOptions& options_;
  Run run_;
  StoredCells stored_;
  std::vector<std::size_t> sample_;                        // indices into run_.cells
  std::vector<std::pair<std::size_t, StoredCell>> again_;  // those of the sample that can be computed again
  std::map<std::size_t, VerifiedCell> verdicts_;
  std::vector<CellPair> pairs_;
  VerifyResult result_;
};

}  // namespace

// Selection sampling (Knuth, vol. 2, algorithm S), in whole numbers: no library's distribution decides.
std::vector<std::size_t> draw_sample(std::size_t size, std::size_t count, long seed) {
  if (count == 0 || count > size) count = size;
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::vector<std::size_t> sample;
  for (std::size_t i = 0; sample.size() < count; ++i) {
    if (random() % (size - i) < count - sample.size()) sample.push_back(i);
  }
  return sample;
}

VerifyResult verify_run(const std::filesystem::path& dir, const VerifyOptions& options) {
  return Verify(dir, options).run();
}

}  // namespace dob
