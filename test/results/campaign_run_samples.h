// Campaigns made by hand: planned cells and, for those that have one, an outcome.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "results/campaign_result.h"
#include "results/store.h"
#include "test/results/run_samples.h"

namespace dob::test {

struct SampleCampaign {
  Campaign campaign;
  Run run;

  // The index of the new curve.
  std::size_t add_curve(const CellKey& key, std::vector<int> axes, std::vector<std::string> factors = {}) {
    campaign.curves.push_back({key, std::move(axes), std::move(factors)});
    campaign.curves.back().key.seed = 0;
    return campaign.curves.size() - 1;
  }

  // A planned cell; what an axis changes is in its overrides.
  CellKey plan(std::size_t curve, std::array<int, 2> level, int seed) {
    CellKey key = campaign.curves[curve].key;
    key.seed = seed;
    for (std::size_t i = 0; i < campaign.curves[curve].axes.size(); ++i) {
      key.overrides += fmt::format(
          " {}={}", campaign.axes.at(static_cast<std::size_t>(campaign.curves[curve].axes[i])).name, level[i]);
    }
    campaign.cells.push_back({curve, level});
    run.info.cells.push_back(key);
    return key;
  }

  void add_survivor(std::size_t curve, std::array<int, 2> level, int seed, double com_error_max_m) {
    run.cells.push_back(survived(plan(curve, level, seed), com_error_max_m));
  }
  void add_fall(std::size_t curve, std::array<int, 2> level, int seed) {
    run.cells.push_back(fell(plan(curve, level, seed), 20.0, 0.5));
  }
  void add_error(std::size_t curve, std::array<int, 2> level, int seed) {
    run.cells.push_back(failed(plan(curve, level, seed), "no such plugin"));
  }

  CampaignResult result() const { return campaign_result(campaign, run); }
};

// A letter for each trial, the seeds 1, 2, ...: 's' survived, 'f' fell, 'e' could not be run, '.' not run yet.
inline void add_trials(SampleCampaign& sample, std::size_t curve, std::array<int, 2> level, const std::string& trials,
                       double com_error_max_m = 0.01) {
  int seed = 0;
  for (const char trial : trials) {
    ++seed;
    if (trial == 's') sample.add_survivor(curve, level, seed, com_error_max_m * seed);
    if (trial == 'f') sample.add_fall(curve, level, seed);
    if (trial == 'e') sample.add_error(curve, level, seed);
    if (trial == '.') sample.plan(curve, level, seed);
  }
}

inline SampleCampaign empty_campaign(CampaignKind kind, std::vector<CampaignAxis> axes) {
  SampleCampaign sample;
  sample.campaign.kind = kind;
  sample.campaign.name = "push";
  sample.campaign.summary = "how hard a push may be";
  sample.campaign.axes = std::move(axes);
  return sample;
}

// Cells in the opposite order of ending.
inline SampleCampaign reversed(SampleCampaign sample) {
  std::reverse(sample.run.cells.begin(), sample.run.cells.end());
  return sample;
}

}  // namespace dob::test
