#include "bench/campaign_spec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "robot/text_input.h"
#include "scenarios/data_directory.h"
#include "scenarios/reader.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

constexpr int kMostSeeds = 1000;
constexpr std::size_t kMostBytes = 1 << 20;  // of the file, which has been parsed by then
constexpr int kMostLevels = 1000;
constexpr double kLargest = 1e9;
constexpr int kDigits = 3;  // to which the levels of a ladder are rounded, so that they can be read

constexpr std::array kKinds{Choice<CampaignKind>{"limit", CampaignKind::kLimit},
                            Choice<CampaignKind>{"map", CampaignKind::kMap},
                            Choice<CampaignKind>{"breakdown", CampaignKind::kBreakdown},
                            Choice<CampaignKind>{"factorial", CampaignKind::kFactorial}};
constexpr std::array kSpacings{Choice<bool>{"linear", false}, Choice<bool>{"log", true}};

fs::path campaigns_directory() {
  return data_directory() / "campaigns";
}

fs::path file_of(const std::string& request) {
  const bool name = is_bare_key(request);
  return name ? campaigns_directory() / (request + ".toml") : fs::path(request);
}

double rounded(double level) {
  return std::stod(fmt::format("{:.{}g}", level, kDigits));
}

std::vector<double> ladder(double from, double to, int levels, bool logarithmic) {
  std::vector<double> ladder;
  for (int i = 0; i < levels; ++i) {
    const double share = static_cast<double>(i) / (levels - 1);
    const double level = logarithmic ? from * std::pow(to / from, share) : from + (to - from) * share;
    ladder.push_back(rounded(level));
  }
  return ladder;
}

bool monotone(const std::vector<double>& levels) {
  return std::adjacent_find(levels.begin(), levels.end(), std::greater_equal<>()) == levels.end() ||
         std::adjacent_find(levels.begin(), levels.end(), std::less_equal<>()) == levels.end();
}

void read_levels(Reader& r, CampaignAxis& axis) {
  if (r.has("values")) {
    axis.levels = r.numbers("values", between(-kLargest, kLargest));
    const bool positive = std::all_of(axis.levels.begin(), axis.levels.end(), [](double x) { return x > 0.0; });
    axis.logarithmic = r.choice("spacing", kSpacings, std::optional(false));
    if (axis.logarithmic && !positive) r.refuse("values", "positive numbers with spacing = \"log\"");
    if (axis.levels.size() < 2 || !monotone(axis.levels)) {
      r.refuse("values", "two numbers or more, all growing or all falling, the mildest first");
    }
    return;
  }
  axis.logarithmic = r.choice("spacing", kSpacings, std::optional(false));
  const Range range = axis.logarithmic ? above(0.0, kLargest) : between(-kLargest, kLargest);
  const double from = r.number("from", range);
  const double to = r.number("to", range);
  const int levels = r.integer("levels", 2, kMostLevels);
  if (!r.has("from") || !r.has("to") || !r.has("levels")) return;  // what is missing is said when the table ends
  axis.levels = ladder(from, to, levels, axis.logarithmic);
  if (!monotone(axis.levels)) {
    r.refuse("levels",
             fmt::format("fewer, so that no two levels from {} to {} are equal to {} digits", from, to, kDigits));
  }
}

constexpr std::string_view kPlaceOfLevel = "{}";

// KEY=VALUE, where braces stand for the level and for nothing else.
bool is_override(std::string text) {
  for (std::size_t at; (at = text.find(kPlaceOfLevel)) != std::string::npos;)
    text.replace(at, kPlaceOfLevel.size(), 1, '1');
  const std::size_t equals = text.find('=');
  return equals != std::string::npos && equals > 0 && text.find_first_of("{}") == std::string::npos;
}

bool has_level(const std::string& text) {
  return text.find(kPlaceOfLevel, text.find('=')) != std::string::npos;
}

AxisSpec read_axis(const Entry& entry) {
  if (!is_bare_key(entry.key)) {
    throw InputError(entry.node.place, "axis", "a name of letters, digits, _ and -, as in [axis.amplitude]");
  }
  AxisSpec spec;
  spec.axis.name = entry.key;
  spec.place = entry.node.place;
  Reader::read(entry.node, "axis." + entry.key, [&](Reader& r) {
    if (r.has("unit")) spec.axis.unit = r.text("unit");
    if (r.has("observer_scale")) {
      spec.observer_scale = r.texts("observer_scale");
    } else {
      spec.set = r.texts("set");
      const bool sound = std::all_of(spec.set.begin(), spec.set.end(), is_override) &&
                         std::any_of(spec.set.begin(), spec.set.end(), has_level);
      if (!sound && r.has("set")) r.refuse("set", "KEY={}, or a list of KEY=VALUE; {} is where the level goes");
    }
    read_levels(r, spec.axis);
    const bool levels = !spec.axis.levels.empty();
    if (levels && !spec.observer_scale.empty() &&
        *std::min_element(spec.axis.levels.begin(), spec.axis.levels.end()) <= 0.0) {
      r.refuse("observer_scale", "positive levels with it: they are factors");
    }
  });
  return spec;
}

std::string key_of(const std::string& override_text) {
  return override_text.substr(0, override_text.find('='));
}

// Of two axes that set the same key the first would have no effect.
void require_other_keys(const AxisSpec& first, const AxisSpec& second) {
  for (const std::string& text : second.set) {
    const auto same = [&](const std::string& other) { return key_of(other) == key_of(text); };
    if (std::none_of(first.set.begin(), first.set.end(), same)) continue;
    throw InputError(second.place, "axis." + second.axis.name,
                     fmt::format("sets {}, as axis.{} does; allowed: another key", key_of(text), first.axis.name));
  }
}

std::vector<AxisSpec> read_axes(Reader& r, const Node& document, CampaignKind kind) {
  std::vector<AxisSpec> axes;
  r.has("axis");  // a known key
  if (const Node* table = document.find("axis")) {
    for (const Entry& entry : table_of(*table, "axis")) axes.push_back(read_axis(entry));
  }
  if (kind == CampaignKind::kMap && axes.size() == 2) require_other_keys(axes[0], axes[1]);
  const auto refuse = [&](const char* allowed) {
    throw InputError(r.place("axis"), "axis", fmt::format("{} axes; allowed: {}", axes.size(), allowed));
  };
  if (kind == CampaignKind::kLimit && axes.size() != 1) refuse("one, [axis.NAME], for kind = \"limit\"");
  if (kind == CampaignKind::kMap && axes.size() != 2) refuse("two, [axis.NAME], for kind = \"map\"");
  if (kind == CampaignKind::kBreakdown && axes.empty()) refuse("one or more, [axis.NAME], for kind = \"breakdown\"");
  if (kind == CampaignKind::kFactorial && !axes.empty()) refuse("none for kind = \"factorial\"");
  return axes;
}

std::vector<std::vector<std::string>> read_grid(Reader& r, const Node& document) {
  std::vector<std::vector<std::string>> grid;
  if (!r.has("grid")) return grid;
  r.table("grid", [&](Reader& table) {
    for (const Entry& entry : table_of(*document.find("grid"), "grid")) grid.push_back(table.texts(entry.key));
  });
  return grid;
}

void read_budget(Reader& r, CampaignSpec& spec) {
  if (!r.has("budget")) return;
  spec.budget_place = r.place("budget");
  r.table("budget", [&](Reader& table) {
    if (table.has("trials")) spec.trials = table.integer("trials", 1, 1'000'000'000);
    if (table.has("trials_per_curve")) spec.trials_per_curve = table.integer("trials_per_curve", 1, 1'000'000);
    if (spec.trials > 0 && spec.trials_per_curve > 0) {
      table.refuse("trials", "either trials, of the whole campaign, or trials_per_curve: both contradict each other");
    }
  });
}

// Each once: a cell that is asked for twice is there once.
void require_once(const Reader& r, std::string_view key, const std::vector<std::string>& values) {
  std::set<std::string> seen;
  for (const std::string& value : values) {
    if (!seen.insert(value).second) r.refuse(key, fmt::format("each once; '{}' is there twice", value));
  }
}

std::vector<std::string> texts_or_none(Reader& r, std::string_view key) {
  if (!r.has(key)) return {};
  std::vector<std::string> texts = r.texts(key);
  require_once(r, key, texts);
  return texts;
}

void read_spec(Reader& r, const Node& document, CampaignSpec& spec) {
  spec.kind = r.choice("kind", kKinds);
  spec.summary = r.text("summary");
  spec.scenarios = r.texts("scenarios");
  spec.scenarios_place = r.place("scenarios");
  require_once(r, "scenarios", spec.scenarios);
  if (spec.kind == CampaignKind::kFactorial) {
    spec.observers_place = r.place("legs");
    spec.legs = r.texts("legs");
    spec.com_place = r.place("com");
    spec.com = r.texts("com");
    require_once(r, "legs", spec.legs);
    require_once(r, "com", spec.com);
    spec.profiles_place = r.place("profile");
    spec.profiles = {r.text("profile")};
  } else {
    spec.observers_place = r.place("observers");
    spec.observers = r.texts("observers");
    require_once(r, "observers", spec.observers);
    spec.profiles_place = r.place("profiles");
    spec.profiles = r.texts("profiles");
    require_once(r, "profiles", spec.profiles);
  }
  spec.gains = texts_or_none(r, "gains");
  spec.planners = texts_or_none(r, "planners");
  spec.set = texts_or_none(r, "set");
  spec.set_place = r.place("set");
  spec.grid = read_grid(r, document);
  spec.seeds = r.integer("seeds", 1, kMostSeeds);
  spec.axes = read_axes(r, document, spec.kind);
  read_budget(r, spec);
}

}  // namespace

CampaignSpec read_campaign_spec(const std::string& request, const std::vector<std::string>& overrides, long trials) {
  CampaignSpec spec;
  spec.file = file_of(request);
  spec.name = spec.file.stem().string();
  const Node document = parse_file(spec.file);
  Reader::read(document, "", [&](Reader& r) { read_spec(r, document, spec); });
  spec.document = read_text_file(spec.file, kMostBytes);
  if (trials > 0) {
    spec.trials = trials;
    spec.trials_per_curve = 0;
    spec.budget_place = {.source = "--budget"};
    spec.document += fmt::format("# --budget {}\n", trials);
  }
  for (const std::string& override_text : overrides) {
    spec.set.push_back(override_text);
    spec.document += fmt::format("# --set {}\n", printable_line(override_text, override_text.size()));
  }
  return spec;
}

std::vector<std::pair<std::string, std::string>> list_campaigns() {
  std::vector<std::pair<std::string, std::string>> campaigns;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(campaigns_directory(), error)) {
    if (entry.path().extension() != ".toml") continue;
    const std::string name = entry.path().stem().string();
    campaigns.emplace_back(name, read_campaign_spec(name, {}, 0).summary);
  }
  std::sort(campaigns.begin(), campaigns.end());
  return campaigns;
}

}  // namespace dob
