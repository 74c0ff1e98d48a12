#include "bench/shard.h"

#include <charconv>
#include <numeric>
#include <string_view>

#include <fmt/format.h>

#include "bench/observer_sources.h"
#include "results/fingerprint.h"
#include "scenarios/input_error.h"

namespace dob {
namespace {

bool parse_whole(std::string_view text, int& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

// Of everything that decides what comes out.
std::string fingerprint_of(const BatchPlan& plan) {
  Fingerprint all;
  const auto add = [&all](std::string_view text) {
    all.add(text);
    all.add(std::string_view("\0", 1));  // so that "ab", "c" is not "a", "bc"
  };
  for (const ResolvedScenario& scenario : plan.resolved) add(scenario.name), add(scenario.toml);
  for (const std::string& source : observer_sources(plan)) add(source);
  for (const PlannedCell& cell : plan.cells) {
    const CellKey& key = cell.key;
    for (const std::string* text :
         {&key.scenario, &key.variant, &key.observer, &key.profile, &key.gains, &key.planner, &key.overrides}) {
      add(*text);
    }
    add(fmt::format("{} {} {}", key.seed, cell.scenario, cell.observer));
  }
  if (plan.campaign) add(plan.campaign->document);
  return all.text();
}

}  // namespace

ShardChoice parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  ShardChoice choice;
  const bool numbers = slash != std::string::npos &&
                       parse_whole(std::string_view(text).substr(0, slash), choice.number) &&
                       parse_whole(std::string_view(text).substr(slash + 1), choice.count);
  if (numbers && choice.number >= 1 && choice.number <= choice.count && choice.count <= kMostShards) return choice;
  throw InputError(fmt::format("--shard {}: allowed: I/N with 1 <= I <= N, up to {}", text, kMostShards));
}

void take_shard(BatchPlan& plan, const ShardChoice& choice) {
  plan.shard = {choice.number, choice.count, plan.cells.size(), fingerprint_of(plan), false};
  if (choice.count == 1) return;
  const auto part = static_cast<std::size_t>(choice.number - 1), parts = static_cast<std::size_t>(choice.count);
  SeededList<PlannedCell> cells;
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    const std::size_t unit = plan.campaign ? plan.campaign->cells[i].curve : i;
    if (unit % parts != part) continue;
    plan.ids.push_back(static_cast<long>(i) + 1);
    if (plan.campaign) plan.campaign->cells[cells.size()] = plan.campaign->cells[i];
    cells.push_back(plan.cells[i]);
  }
  plan.cells = std::move(cells);
  if (plan.campaign) plan.campaign->cells.resize(plan.cells.size());
}

}  // namespace dob
