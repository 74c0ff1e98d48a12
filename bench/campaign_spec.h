// What the file of a campaign asks for, checked as far as it can be without loading a scenario.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "results/campaign.h"
#include "scenarios/input_error.h"

namespace dob {

// An axis with what it changes in a trial.
struct AxisSpec {
  CampaignAxis axis;
  std::vector<std::string> set;             // KEY=VALUE laid over the scenario, with the level in place of {}
  std::vector<std::string> observer_scale;  // options of observers, by which the level multiplies what the profile says
  Place place;
};

struct CampaignSpec {
  CampaignKind kind = CampaignKind::kLimit;
  std::string name, summary, document;  // as in Campaign
  std::filesystem::path file;
  std::vector<std::string> scenarios;
  std::vector<std::string> observers;          // specifications; kFactorial: empty
  std::vector<std::string> legs, com;          // kFactorial: estimators, "none" among them
  std::vector<std::string> profiles, gains;    // gains empty: of each scenario its own
  std::vector<std::string> planners;           // empty: of each scenario its own
  std::vector<std::string> set;                // KEY=VALUE laid over every scenario
  std::vector<std::vector<std::string>> grid;  // of each list one KEY=VALUE, every combination
  std::vector<AxisSpec> axes;                  // kLimit one, kMap two, kBreakdown any number, kFactorial none
  int seeds = 0;                               // 1 to this, at every level
  long trials = 0;                             // budget of the whole campaign; 0: none
  long trials_per_curve = 0;                   // the same of each curve; 0: none
  Place scenarios_place, observers_place, com_place, profiles_place, set_place, budget_place;
};

// `request`: a file, or the name of a shipped campaign (scenarios/campaigns/NAME.toml). `overrides` are laid over every
// scenario behind those of the file; `trials` > 0 takes the place of the file's budget. Keys: docs/campaigns.md. Throws
// InputError with file, line and column.
CampaignSpec read_campaign_spec(const std::string& request, const std::vector<std::string>& overrides, long trials);

// The shipped ones: name and summary.
std::vector<std::pair<std::string, std::string>> list_campaigns();

}  // namespace dob
