#include "results/report_traces.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/report_page.h"
#include "results/report_payload.h"
#include "results/report_text.h"
#include "results/trace.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

using TracedCells = std::vector<const CellResult*>;

// The place of a name in the order in which names are asked for, from 0.
template <typename Name>
class Ranks {
 public:
  std::size_t of(const Name& name) { return ranks_.emplace(name, ranks_.size()).first->second; }

 private:
  std::map<Name, std::size_t> ranks_;
};

// How much each cell is wanted.
class Wanted {
 public:
  using Rank = std::tuple<std::size_t, std::size_t, std::size_t, std::size_t, std::size_t, std::size_t>;

  explicit Wanted(const Run& run, const ReportIndex& index) : index_(index) {
    for (const CellKey& cell : run.info.cells) {
      if (cell.profile == "tuned") profiles_[cell.scenario].of(cell.profile);
      variants_[cell.scenario].of(cell.variant);
      scenarios_.of(cell.scenario);
      if (cell.gains == "paper") settings_[index.scenario(cell)].of(index.setting(cell));
    }
    for (const CellKey& cell : run.info.cells) {
      settings_[index.scenario(cell)].of(index.setting(cell));
      if (cell.profile != "-") profiles_[cell.scenario].of(cell.profile);
    }
  }

  Rank of(const CellKey& cell) {
    const std::size_t seed = seeds_[without_seed(cell)].of(cell.seed);
    return {seed,
            settings_[index_.scenario(cell)].of(index_.setting(cell)),
            cell.profile == "-" ? 0 : profiles_[cell.scenario].of(cell.profile),
            variants_[cell.scenario].of(cell.variant),
            scenarios_.of(cell.scenario),
            index_.observer(cell)};
  }

 private:
  static CellKey without_seed(CellKey cell) {
    cell.seed = 0;
    return cell;
  }

  const ReportIndex& index_;
  Ranks<std::string> scenarios_;
  std::map<std::string, Ranks<std::string>> variants_, profiles_;  // of a scenario
  std::map<std::size_t, Ranks<std::size_t>> settings_;             // of a scenario and variant
  std::map<CellKey, Ranks<int>> seeds_;                            // of a row of the tables
};

// "traces of case1/knee, seed 1: none, momentum@tuned", one for each scenario, setting and seed.
Json left_out_json(const TracedCells& cells, const ReportIndex& index, const std::string& limit) {
  std::map<std::tuple<std::size_t, std::size_t, int>, TracedCells> groups;
  for (const CellResult* cell : cells) {
    groups[{index.scenario(cell->key), index.setting(cell->key), cell->key.seed}].push_back(cell);
  }
  Json list = Json::array();
  for (const auto& [name, group] : groups) {
    const CellKey& first = group.front()->key;
    std::vector<std::string> observers;
    for (const CellResult* cell : group) observers.push_back(index.observer_id(cell->key));
    list.push_back(
        {{"what", fmt::format("traces of {} (gains {}, planner {}{}), seed {}: {}", index.scenario_id(first),
                              first.gains, first.planner, first.overrides.empty() ? "" : ", set " + first.overrides,
                              first.seed, fmt::join(observers, ", "))},
         {"why", limit}});
  }
  return list;
}

// What a recorded trace may lack, and what that costs.
class Lacks {
 public:
  void look_at(const Trace& trace) {
    ++traces_;
    for (Lack& lack : lacks_) {
      if (std::find(trace.names.begin(), trace.names.end(), lack.signal) == trace.names.end()) ++lack.traces;
    }
  }

  void tell(std::vector<std::string>& missing) const {
    for (const Lack& lack : lacks_) {
      if (lack.traces == 0) continue;
      missing.push_back(
          fmt::format("{} in {} of {} traces: an older program recorded them, without {}. Run them again.", lack.costs,
                      lack.traces, traces_, lack.signal));
    }
  }

 private:
  struct Lack {
    const char* signal;
    const char* costs;
    int traces = 0;
  };

  std::vector<Lack> lacks_{{"trunk/qw", "No replay"},
                           {"LF/hip/angle_rad", "No legs in the replay"},
                           {"LF/foothold/x_m", "No planned footholds in the replay"},
                           {"applied/point/x_m", "No applied forces in the replay"},
                           {"path/x_m", "No path error over time"}};
  int traces_ = 0;
};

// "case1/knee, momentum@tuned, seed 1"
std::string name_of(const CellKey& cell, const ReportIndex& index) {
  return fmt::format("{}, {}, seed {}", index.scenario_id(cell), index.observer_id(cell), cell.seed);
}

// The message without the run directory's place.
std::string within(const fs::path& dir, std::string message) {
  const std::string before = (dir / "").string();
  if (message.starts_with(before)) message.erase(0, before.size());
  return without_directories(message);
}

void note_scenarios_without(const Run& run, const TracedCells& with_trace, const ReportIndex& index,
                            std::vector<std::string>& missing) {
  std::set<std::size_t> finished, kept;
  for (const CellResult& cell : run.cells) {
    if (cell.outcome != Outcome::kError) finished.insert(index.scenario(cell.key));
  }
  for (const CellResult* cell : with_trace) kept.insert(index.scenario(cell->key));
  std::vector<std::string> without;
  for (const std::size_t scenario : finished) {
    if (!kept.contains(scenario)) without.push_back(index.scenario_id(index.scenarios()[scenario]));
  }
  if (without.empty()) return;
  missing.push_back(
      fmt::format("No plots over time and no replay of {}: the run kept no time series (`dobbench run "
                  "--keep first-seed` does).",
                  fmt::join(without, ", ")));
}

std::map<CellKey, std::size_t> places_of(const CellKeys& cells) {
  std::map<CellKey, std::size_t> places;
  for (std::size_t i = 0; i < cells.size(); ++i) places[cells[i]] = i;
  return places;
}

Json description_json(const CellResult& cell, const ReportIndex& index, std::size_t place, const TracePayload& trace) {
  Json json{{"cell", place}};
  json.update(index.ids(cell.key));
  json["seed"] = cell.key.seed;
  json["bytes"] = trace.base64.size();
  json.update(trace.description);
  return json;
}

}  // namespace

std::vector<const CellResult*> traces_in_order(const Run& run, const ReportIndex& index) {
  TracedCells cells;
  for (const CellResult& cell : run.cells) {
    if (!cell.trace.empty()) cells.push_back(&cell);
  }
  Wanted wanted(run, index);
  std::map<const CellResult*, Wanted::Rank> ranks;
  for (const CellResult* cell : cells) ranks[cell] = wanted.of(cell->key);
  std::stable_sort(cells.begin(), cells.end(), [&](auto* a, auto* b) { return ranks[a] < ranks[b]; });
  return cells;
}

ReportTraces take_traces(const fs::path& dir, const Run& run, const ReportIndex& index, std::size_t room,
                         const std::string& limit) {
  ReportTraces out;
  const TracedCells all = traces_in_order(run, index);
  note_scenarios_without(run, all, index, out.missing);
  const std::map<CellKey, std::size_t> places = places_of(run.info.cells);
  Lacks lacks;
  // As if everything were left out: what is said about it shrinks with each trace that is taken.
  std::size_t used = script_json(left_out_json(all, index, limit)).size() + script_json(out.missing).size();
  std::size_t next = 0;
  for (; next < all.size(); ++next) {
    const CellResult& cell = *all[next];
    try {
      const Trace recorded = read_trace(dir / cell.trace);
      const TracePayload trace = encode_trace(recorded);
      Json description = description_json(cell, index, places.at(cell.key), trace);
      const std::size_t size =
          script_json(description).size() + 1 + trace_element(out.payloads.size(), trace.base64).size();
      if (used + size > room) break;
      used += size;
      lacks.look_at(recorded);
      out.descriptions.push_back(std::move(description));
      out.payloads.push_back(trace.base64);
    } catch (const StoreError& error) {
      out.missing.push_back(fmt::format("The time series of {} cannot be shown: {}.", name_of(cell.key, index),
                                        within(dir, error.what())));
      used += out.missing.back().size() + 8;
    }
  }
  out.left_out = left_out_json({all.begin() + static_cast<std::ptrdiff_t>(next), all.end()}, index, limit);
  lacks.tell(out.missing);
  return out;
}

}  // namespace dob
