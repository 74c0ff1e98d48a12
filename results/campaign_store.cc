#include "results/campaign_store.h"

#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "results/campaign_text.h"
#include "results/run_plan.h"
#include "results/store_json.h"

namespace dob {
namespace {

Json curve_to_json(const CampaignCurve& curve) {
  const CellKey& key = curve.key;
  return {{"key", {key.scenario, key.variant, key.observer, key.profile, key.gains, key.planner, key.overrides}},
          {"axes", curve.axes},
          {"factors", curve.factors}};
}

CampaignAxis axis_from(const Json& json) {
  return {json.at("name"), json.at("unit"), json.at("levels"), json.at("logarithmic")};
}

CampaignCurve curve_from(const Json& json, std::size_t axes) {
  const Json& key = json.at("key");
  CampaignCurve curve{{key.at(0), key.at(1), key.at(2), key.at(3), key.at(4), key.at(5), key.at(6), 0},
                      json.at("axes"),
                      json.at("factors")};
  for (const int axis : curve.axes) {
    if (axis < 0 || static_cast<std::size_t>(axis) >= axes || curve.axes.size() > 2) {
      throw std::runtime_error("campaign: a curve over an axis that is not there");
    }
  }
  return curve;
}

Json to_json(const Campaign& campaign) {
  Json json{{"kind", kind_name(campaign.kind)}, {"name", campaign.name}, {"summary", campaign.summary},
            {"document", campaign.document},    {"axes", Json::array()}, {"factors", campaign.factors},
            {"curves", Json::array()}};
  for (const CampaignAxis& axis : campaign.axes) json["axes"].push_back(axis_to_json(axis));
  for (const CampaignCurve& curve : campaign.curves) json["curves"].push_back(curve_to_json(curve));
  return json;
}

CampaignKind kind_from(const std::string& name) {
  for (const CampaignKind kind :
       {CampaignKind::kLimit, CampaignKind::kMap, CampaignKind::kBreakdown, CampaignKind::kFactorial}) {
    if (kind_name(kind) == name) return kind;
  }
  throw std::runtime_error(fmt::format("campaign: unknown kind '{}'", name));
}

Campaign from_json(const Json& json) {
  Campaign campaign{.kind = kind_from(json.at("kind")),
                    .name = json.at("name"),
                    .summary = json.at("summary"),
                    .document = json.at("document"),
                    .axes = {},
                    .factors = json.at("factors"),
                    .curves = {},
                    .cells = {}};
  for (const Json& axis : json.at("axes")) campaign.axes.push_back(axis_from(axis));
  for (const Json& curve : json.at("curves")) campaign.curves.push_back(curve_from(curve, campaign.axes.size()));
  return campaign;
}

int level_of(const Campaign& campaign, const CampaignCurve& curve, std::size_t axis, int level) {
  const std::size_t levels =
      axis < curve.axes.size() ? campaign.axes[static_cast<std::size_t>(curve.axes[axis])].levels.size() : 1;
  if (level >= 0 && static_cast<std::size_t>(level) < levels) return level;
  throw std::runtime_error(fmt::format("campaign_cell: level {} of an axis of {}", level, levels));
}

void read_cells(SQLite::Database& database, Campaign& campaign) {
  SQLite::Statement row(database, "SELECT curve, level_0, level_1 FROM campaign_cell ORDER BY cell");
  while (row.executeStep()) {
    const std::int64_t number = row.getColumn(0).getInt64();
    if (number < 0 || number >= static_cast<std::int64_t>(campaign.curves.size())) {
      throw std::runtime_error(fmt::format("campaign_cell: there is no curve {}", number));
    }
    const CampaignCurve& curve = campaign.curves[static_cast<std::size_t>(number)];
    campaign.cells.push_back(
        {static_cast<std::size_t>(number),
         {level_of(campaign, curve, 0, row.getColumn(1)), level_of(campaign, curve, 1, row.getColumn(2))}});
  }
}

}  // namespace

void write_campaign(SQLite::Database& database, const Campaign& campaign, const std::vector<long>& ids) {
  SQLite::Statement document(database, insert_into("campaign", {"document"}));
  RowBinder(document).add(one_line(to_json(campaign)));
  document.exec();
  SQLite::Statement insert(database, insert_into("campaign_cell", {"cell", "curve", "level_0", "level_1"}));
  for (std::size_t i = 0; i < campaign.cells.size(); ++i) {
    const CampaignCell& cell = campaign.cells[i];
    RowBinder(insert)
        .add(ids.at(i))
        .add(static_cast<long>(cell.curve))
        .add(static_cast<long>(cell.level[0]))
        .add(static_cast<long>(cell.level[1]));
    insert.exec();
  }
}

std::string campaign_document(SQLite::Database& database) {
  if (columns_of(database, "campaign").empty()) return "";  // from before there were any
  SQLite::Statement row(database, "SELECT document FROM campaign");
  return row.executeStep() ? row.getColumn(0).getString() : "";
}

std::optional<Campaign> read_campaign(SQLite::Database& database, std::size_t cells) {
  const std::string document = campaign_document(database);
  if (document.empty()) return std::nullopt;
  try {
    Campaign campaign = from_json(Json::parse(document));
    read_cells(database, campaign);
    if (campaign.cells.size() == cells) return campaign;
  } catch (const Json::exception& error) {
    throw std::runtime_error(fmt::format("campaign: {}", error.what()));
  }
  throw std::runtime_error("campaign_cell: not one row for each cell");
}

std::optional<Campaign> read_campaign(const std::filesystem::path& dir) {
  SQLite::Database database = open_database(dir);
  try {
    const SQLite::Transaction one_state_of_it(database);
    const int cells = database.execAndGet("SELECT COUNT(*) FROM cell").getInt();
    return read_campaign(database, static_cast<std::size_t>(cells));
  } catch (const std::runtime_error& error) {  // SQLite's, or a value that is not what it should be
    throw StoreError(fmt::format("{}: {}", (dir / kDatabaseFile).string(), error.what()));
  }
}

}  // namespace dob
