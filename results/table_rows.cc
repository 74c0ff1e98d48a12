#include "results/table_rows.h"

#include <algorithm>
#include <map>

#include "observers/factory.h"

namespace dob {
namespace {

using KeyField = std::string CellKey::*;

constexpr std::array<KeyField, 7> kScenarioFirst{&CellKey::scenario, &CellKey::variant,   &CellKey::gains,
                                                 &CellKey::planner,  &CellKey::overrides, &CellKey::observer,
                                                 &CellKey::profile};
constexpr std::array<KeyField, 7> kObserverFirst{&CellKey::observer, &CellKey::profile,   &CellKey::gains,
                                                 &CellKey::planner,  &CellKey::overrides, &CellKey::scenario,
                                                 &CellKey::variant};

// Place of every value of every field: its first mention in the run.
class Places {
 public:
  Places(const std::vector<CellKey>& keys, const std::array<KeyField, 7>& fields) : fields_(fields) {
    for (const CellKey& key : keys) {
      for (std::size_t i = 0; i < fields.size(); ++i) {
        places_[i].try_emplace(key.*fields[i], places_[i].size());
      }
    }
  }

  std::array<std::size_t, 7> of(const CellKey& key) const {
    std::array<std::size_t, 7> place{};
    for (std::size_t i = 0; i < place.size(); ++i) place[i] = places_[i].at(key.*fields_[i]);
    return place;
  }

 private:
  std::array<KeyField, 7> fields_;
  std::array<std::map<std::string, std::size_t>, 7> places_;
};

void add_reason(std::string& reasons, const std::string& reason) {
  const std::string separator = "; ";
  if (reason.empty() || (separator + reasons + separator).find(separator + reason + separator) != std::string::npos) {
    return;
  }
  reasons += (reasons.empty() ? "" : separator) + reason;
}

void count(TableRow& row, const std::vector<const CellResult*>& cells) {
  std::vector<double> fall_times;
  for (const CellResult* cell : cells) {
    if (cell->outcome == Outcome::kError) {
      ++row.errors;
      add_reason(row.error_reason, cell->reason);
      continue;
    }
    ++row.runs;
    if (cell->outcome != Outcome::kFell) continue;
    ++row.falls;
    fall_times.push_back(cell->simulated_s);
    add_reason(row.fall_reason, cell->reason);
  }
  row.fall_time_median_s = summarise(fall_times).median;
  row.falls_ci95 = wilson_interval(row.falls, row.runs);
  row.until_fall = row.falls > 0 && row.falls == row.runs;
}

TableRow make_row(const CellKey& key, int seeds, std::vector<const CellResult*> cells) {
  std::sort(cells.begin(), cells.end(), [](auto* a, auto* b) { return a->key.seed < b->key.seed; });
  TableRow row;
  row.key = key;
  row.seeds = seeds;
  row.oracle = is_oracle(key.observer.substr(0, key.observer.find(':')));
  count(row, cells);
  const Outcome counted = row.until_fall ? Outcome::kFell : Outcome::kSurvived;
  for (std::size_t i = 0; i < kMetricFields.size(); ++i) {
    std::vector<double> samples;
    for (const CellResult* cell : cells) {
      if (cell->outcome != counted) continue;
      if (const std::optional<double> value = kMetricFields[i].of(cell->metrics)) samples.push_back(*value);
    }
    row.metrics[i] = summarise(samples);
  }
  return row;
}

TimingSummary summarise_timings(const std::vector<const CellTiming*>& timings) {
  const auto values = [&](double CellTiming::*field) {
    std::vector<double> samples;
    samples.reserve(timings.size());
    for (const CellTiming* timing : timings) samples.push_back(timing->*field);
    return samples;
  };
  return {.tick_p50_us = median(values(&CellTiming::tick_p50_us)),
          .tick_p99_us = median(values(&CellTiming::tick_p99_us)),
          .tick_max_us = quantile(values(&CellTiming::tick_max_us), 1.0),
          .qp_p50_us = median(values(&CellTiming::qp_p50_us)),
          .qp_p99_us = median(values(&CellTiming::qp_p99_us)),
          .qp_max_us = quantile(values(&CellTiming::qp_max_us), 1.0),
          .real_time_factor = median(values(&CellTiming::real_time_factor))};
}

}  // namespace

MetricSummary summarise(const std::vector<double>& samples) {
  if (samples.empty()) return {};
  return {median(samples), *std::max_element(samples.begin(), samples.end()), bootstrap_median_interval(samples)};
}

CellKey without_seed(CellKey key) {
  key.seed = 0;
  return key;
}

std::vector<TableRow> build_rows(const Run& run, TableOrder order) {
  std::map<CellKey, int> seeds;
  for (const CellKey& key : run.info.cells) ++seeds[without_seed(key)];
  std::map<CellKey, std::vector<const CellResult*>> cells;
  for (const CellResult& cell : run.cells) cells[without_seed(cell.key)].push_back(&cell);
  std::map<CellKey, std::vector<const CellTiming*>> timings;
  for (const CellTiming& timing : run.timings) timings[without_seed(timing.key)].push_back(&timing);

  std::vector<TableRow> rows;
  rows.reserve(seeds.size());
  for (const auto& [key, number] : seeds) {
    rows.push_back(make_row(key, number, cells[key]));
    if (timings.contains(key)) rows.back().timing = summarise_timings(timings[key]);
  }
  rank_rows(rows);
  const Places places(run.info.cells.rows(), order == TableOrder::kByObserver ? kObserverFirst : kScenarioFirst);
  std::sort(rows.begin(), rows.end(),
            [&](const TableRow& a, const TableRow& b) { return places.of(a.key) < places.of(b.key); });
  return rows;
}

}  // namespace dob
