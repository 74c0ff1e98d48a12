#include "results/store_json.h"

#include <fmt/format.h>

#include "results/metric_fields.h"
#include "results/run_database.h"

namespace dob {
namespace {

Json key_to_json(const CellKey& key) {
  return {key.scenario, key.variant, key.observer, key.profile, key.gains, key.planner, key.overrides, key.seed};
}

CellKey key_from_json(const Json& json) {
  return {json.at(0), json.at(1), json.at(2), json.at(3), json.at(4), json.at(5), json.at(6), json.at(7)};
}

Json number_or_null(const std::optional<double>& x) {
  return x ? Json(*x) : Json();  // what is not finite is written as null
}

std::optional<double> optional_number(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

template <typename Row, typename Columns>
Json columns_to_json(const Row& row, const Columns& columns) {
  Json json = Json::array();
  for (const auto& column : columns) json.push_back(number_or_null(row.*column.field));
  return json;
}

template <typename Row, typename Columns>
void columns_from_json(const Json& json, const Columns& columns, Row& row) {
  for (std::size_t i = 0; i < columns.size(); ++i) row.*columns[i].field = optional_number(json.at(i));
}

Json metrics_to_json(const CellMetrics& metrics) {
  Json json = Json::array();
  for (const MetricField& field : kMetricFields) {
    json.push_back(field.value != nullptr ? number_or_null(metrics.*field.value) : Json(metrics.*field.count));
  }
  return json;
}

CellMetrics metrics_from_json(const Json& json) {
  CellMetrics metrics;
  for (std::size_t i = 0; i < kMetricFields.size(); ++i) {
    const MetricField& field = kMetricFields[i];
    if (field.value != nullptr) {
      metrics.*field.value = optional_number(json.at(i));
    } else {
      metrics.*field.count = json.at(i).get<long>();
    }
  }
  return metrics;
}

Outcome numbered_outcome(std::size_t number) {
  if (number < kOutcomes.size()) return static_cast<Outcome>(number);
  throw std::out_of_range(fmt::format("outcome {}", number));
}

}  // namespace

Json axis_to_json(const CampaignAxis& axis) {
  return {{"name", axis.name}, {"unit", axis.unit}, {"levels", axis.levels}, {"logarithmic", axis.logarithmic}};
}

std::string one_line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string cell_to_line(const CellResult& cell) {
  Json checkpoints = Json::array(), shadows = Json::array();
  for (const MetricsCheckpoint& c : cell.checkpoints) {
    checkpoints.push_back({c.t, columns_to_json(c, kCheckpointColumns)});
  }
  for (const ShadowResult& s : cell.shadows) {
    shadows.push_back({s.observer, s.profile, columns_to_json(s, kShadowColumns)});
  }
  return one_line({{"key", key_to_json(cell.key)},
                   {"outcome", static_cast<int>(cell.outcome)},
                   {"reason", cell.reason},
                   {"simulated_s", cell.simulated_s},
                   {"wall_s", cell.wall_s},
                   {"state_hash", cell.state_hash},
                   {"trace", cell.trace},
                   {"qp_solves", cell.metrics.qp_solves},
                   {"metrics", metrics_to_json(cell.metrics)},
                   {"checkpoints", checkpoints},
                   {"shadows", shadows}});
}

CellResult cell_from_line(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    CellResult cell;
    cell.key = key_from_json(json.at("key"));
    cell.outcome = numbered_outcome(json.at("outcome").get<std::size_t>());
    json.at("reason").get_to(cell.reason);
    json.at("simulated_s").get_to(cell.simulated_s);
    json.at("wall_s").get_to(cell.wall_s);
    json.at("state_hash").get_to(cell.state_hash);
    json.at("trace").get_to(cell.trace);
    cell.metrics = metrics_from_json(json.at("metrics"));
    json.at("qp_solves").get_to(cell.metrics.qp_solves);
    for (const Json& c : json.at("checkpoints")) {
      MetricsCheckpoint& checkpoint = cell.checkpoints.emplace_back();
      c.at(0).get_to(checkpoint.t);
      columns_from_json(c.at(1), kCheckpointColumns, checkpoint);
    }
    for (const Json& s : json.at("shadows")) {
      ShadowResult& shadow = cell.shadows.emplace_back();
      s.at(0).get_to(shadow.observer);
      s.at(1).get_to(shadow.profile);
      columns_from_json(s.at(2), kShadowColumns, shadow);
    }
    return cell;
  } catch (const std::exception& error) {
    throw StoreError(fmt::format("a cell's line cannot be read: {}", error.what()));
  }
}

std::string timing_to_line(const CellTiming& timing) {
  Json json = Json::array();
  json.push_back(key_to_json(timing.key));
  for (const TimingColumn& column : kTimingColumns) json.push_back(timing.*column.field);
  for (const HistogramField& histogram : kHistogramFields) {
    json.push_back({(timing.*histogram.field).edges_us, (timing.*histogram.field).counts});
  }
  return one_line(json);
}

CellTiming timing_from_line(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    CellTiming timing;
    timing.key = key_from_json(json.at(0));
    for (std::size_t i = 0; i < kTimingColumns.size(); ++i)
      timing.*kTimingColumns[i].field = json.at(i + 1).get<double>();
    for (std::size_t i = 0; i < kHistogramFields.size(); ++i) {
      const Json& histogram = json.at(i + 1 + kTimingColumns.size());
      histogram.at(0).get_to((timing.*kHistogramFields[i].field).edges_us);
      histogram.at(1).get_to((timing.*kHistogramFields[i].field).counts);
    }
    return timing;
  } catch (const std::exception& error) {
    throw StoreError(fmt::format("a cell's timing cannot be read: {}", error.what()));
  }
}

}  // namespace dob
