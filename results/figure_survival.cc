#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/figure_style.h"
#include "results/figure_summary.h"
#include "scenarios/document.h"

namespace dob {
namespace {

constexpr const char* kAmplitude = "amplitude_N";

struct SurvivalCount {
  int runs = 0, survived = 0;
};
using Curves = std::map<std::string, std::map<double, SurvivalCount>>;  // by observer, by amplitude [N]

// Of the first disturbance in a resolved scenario; nullopt if it has none.
std::optional<double> amplitude_in(const std::filesystem::path& scenario) {
  const Node document = parse_file(scenario);
  const Node* list = document.find("disturbance");
  const auto* disturbances = list == nullptr ? nullptr : std::get_if<Array>(&list->value);
  if (disturbances == nullptr || disturbances->empty()) return std::nullopt;
  const Node* amplitude = disturbances->front().find(kAmplitude);
  const auto* value = amplitude == nullptr ? nullptr : std::get_if<double>(&amplitude->value);
  return value == nullptr ? std::nullopt : std::optional(*value);
}

// "a=1; disturbance.0.amplitude_N=40" is shown with "a=1".
std::string other_overrides(const std::string& overrides) {
  std::vector<std::string> others;
  for (std::size_t begin = 0; begin < overrides.size();) {
    const std::size_t end = std::min(overrides.find("; ", begin), overrides.size());
    const std::string one = overrides.substr(begin, end - begin);
    if (!one.starts_with(std::string("disturbance.0.") + kAmplitude)) others.push_back(one);
    begin = end + 2;
  }
  return fmt::format("{}", fmt::join(others, "; "));
}

// By what stands above the panel: scenario and other overrides.
std::map<std::string, Curves> curves_of(const FigureSpec& spec, const FigureCells& cells) {
  const RunInfo& info = cells.run().info;
  std::map<CellKey, std::string> sources;
  for (std::size_t i = 0; i < info.sources.size() && i < info.cells.size(); ++i) {
    sources[info.cells[i]] = info.sources[i].scenario;
  }
  std::map<std::string, std::optional<double>> amplitudes;  // by resolved scenario
  std::map<std::string, Curves> all;
  for (const CellResult& cell : cells.run().cells) {
    const CellKey& key = cell.key;
    const auto source = sources.find(key);
    const bool left_out = std::find(spec.leave_out.begin(), spec.leave_out.end(), key.scenario) != spec.leave_out.end();
    const std::vector<std::string>& wanted = cells.request().observers;
    const bool wished_for = wanted.empty() || std::find(wanted.begin(), wanted.end(), key.observer) != wanted.end();
    if (source == sources.end() || left_out || !wished_for || cell.outcome == Outcome::kError ||
        !cells.shown(key, "")) {
      continue;
    }
    auto known = amplitudes.find(source->second);
    if (known == amplitudes.end()) {
      const auto file = cells.dir() / "scenarios" / (source->second + ".toml");
      known = amplitudes.emplace(source->second, amplitude_in(file)).first;
    }
    if (!known->second) continue;
    const std::string others = other_overrides(key.overrides);
    SurvivalCount& count = all[key.scenario + (others.empty() ? "" : ", " + others)][key.observer][*known->second];
    ++count.runs;
    count.survived += cell.outcome == Outcome::kSurvived ? 1 : 0;
  }
  return all;
}

bool has_several_amplitudes(const Curves& curves) {
  return std::any_of(curves.begin(), curves.end(), [](const auto& curve) { return curve.second.size() > 1; });
}

FigurePanel panel_of(const std::string& title, const Curves& curves, const std::vector<std::string>& observers) {
  FigurePanel panel;
  panel.title = title;
  panel.x_axis = "amplitude [N]";
  panel.y_axis = "survived [%]";
  panel.y_range = {-6.0, 106.0};
  double low = curves.begin()->second.begin()->first;
  double high = low;
  const std::map<std::string, FigureLook> looks = observer_looks(observers);
  for (const std::string& observer : observers) {
    const auto curve = curves.find(observer);
    if (curve == curves.end()) continue;
    FigureLine line{observer, looks.at(observer), FigureMark::kLinePoints, {}, {}, {}};
    line.look.width = std::max(0.8, 2.4 - 0.4 * static_cast<double>(panel.lines.size()));  // equal ones show below
    for (const auto& [amplitude, count] : curve->second) {
      line.x.push_back(amplitude);
      line.y.push_back(100.0 * count.survived / count.runs);
    }
    low = std::min(low, line.x.front());
    high = std::max(high, line.x.back());
    panel.lines.push_back(std::move(line));
  }
  const double margin = 0.04 * (high - low);
  panel.x_range = {low - margin, high + margin};
  return panel;
}

}  // namespace

Figure survival_figure(const FigureSpec& spec, const FigureCells& cells) {
  Figure figure;
  figure.id = spec.id;
  figure.subtitle = fmt::format("profile {}, gains {}, planner {}; all variants and seeds", cells.request().profile,
                                cells.request().gains, cells.request().planner);
  figure.cells = {figure.subtitle};
  for (const auto& [title, curves] : curves_of(spec, cells)) {
    if (has_several_amplitudes(curves)) figure.panels.push_back(panel_of(title, curves, cells.observers()));
  }
  if (figure.panels.empty()) {
    throw StoreError(
        "no scenario of this run has cells with several amplitudes (docs/figures.md says how to make them)");
  }
  return figure;
}

}  // namespace dob
