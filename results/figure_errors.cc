#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "results/figure_style.h"
#include "results/figure_summary.h"
#include "results/metric_fields.h"
#include "results/statistics.h"

namespace dob {
namespace {

constexpr double kRowPart = 0.76;     // of a row's height that its observers share
constexpr double kObserverPt = 5.0;   // [pt] height of an observer in a row, less where they are many
constexpr double kLongestPt = 480.0;  // [pt] height of the panels, half a page and more
constexpr double kSmallest = 1e-3;    // [mm] the logarithm needs one

struct Runs {
  int runs = 0, falls = 0;
  std::array<std::vector<double>, 2> errors_mm;  // of those that survived: CoM, swinging foot
};

constexpr std::array kMetrics{metric_index("com_error_max_m"), metric_index("foot_error_max_m")};

class ErrorsFigure {
 public:
  ErrorsFigure(const FigureSpec& spec, const FigureCells& cells) : spec_(spec), cells_(cells) {
    const std::vector<std::string> all = cells.observers(spec.leave_out);
    for (const std::string& observer : cells.request().observers.empty() ? all : cells.request().observers) {
      if (is_shown(observer)) observers_.push_back(observer);
    }
    for (const CellKey& key : cells.run().info.cells.rows()) {
      const bool left_out =
          std::find(spec.leave_out.begin(), spec.leave_out.end(), key.scenario) != spec.leave_out.end();
      if (left_out) continue;
      if (scenarios_.empty()) overrides_ = key.overrides;  // those of the first cell; others are other experiments
      if (row_of(key.scenario) == scenarios_.size()) scenarios_.push_back(key.scenario);
    }
  }

  Figure build() {
    collect();
    Figure figure;
    figure.id = spec_.id;
    figure.columns = 3;
    figure.subtitle =
        fmt::format("profile {}, gains {}, planner {}{}; all variants and seeds", cells_.request().profile,
                    cells_.request().gains, cells_.request().planner, overrides_.empty() ? "" : ", set " + overrides_);
    figure.cells = {figure.subtitle};
    figure.panels = {empty_panel("CoM [mm]"), empty_panel("foot [mm]"), empty_panel("falls [%]")};
    for (std::size_t k = 0; k < observers_.size(); ++k) {
      for (std::size_t m = 0; m < 2; ++m) add_errors(k, m, figure.panels[m]);
      add_falls(k, figure.panels[2]);
    }
    for (std::size_t m = 0; m < 2; ++m) set_log_range(figure.panels[m]);
    figure.panels[2].x_range = {-8.0, 108.0};
    for (FigurePanel& panel : figure.panels) add_rules(panel);
    return figure;
  }

 private:
  bool is_shown(const std::string& observer) const {
    const std::vector<CellKey>& keys = cells_.run().info.cells.rows();
    return std::any_of(keys.begin(), keys.end(),
                       [&](const CellKey& key) { return key.observer == observer && cells_.shown(key, ""); });
  }

  std::size_t row_of(const std::string& scenario) const {
    return static_cast<std::size_t>(std::find(scenarios_.begin(), scenarios_.end(), scenario) - scenarios_.begin());
  }

  void collect() {
    runs_.assign(observers_.size(), std::vector<Runs>(scenarios_.size()));
    bool any = false;
    for (const CellResult& cell : cells_.run().cells) {
      const auto observer = std::find(observers_.begin(), observers_.end(), cell.key.observer);
      const std::size_t row = row_of(cell.key.scenario);
      if (observer == observers_.end() || row == scenarios_.size() || !cells_.shown(cell.key, "") ||
          cell.key.overrides != overrides_ || cell.outcome == Outcome::kError) {
        continue;
      }
      any = true;
      Runs& runs = runs_[static_cast<std::size_t>(observer - observers_.begin())][row];
      ++runs.runs;
      runs.falls += cell.outcome == Outcome::kFell ? 1 : 0;
      for (std::size_t m = 0; m < 2 && cell.outcome == Outcome::kSurvived; ++m) {
        const auto value = kMetricFields[kMetrics[m]].of(cell.metrics);
        if (value && std::isfinite(*value)) runs.errors_mm[m].push_back(std::max(1e3 * *value, kSmallest));
      }
    }
    if (!any) throw StoreError("no cell of these scenarios and this profile has been run");
  }

  FigurePanel empty_panel(const std::string& title) const {
    FigurePanel panel;
    panel.title = title;
    panel.y_range = {0.5 - static_cast<double>(scenarios_.size()), 0.5};
    const auto rows = static_cast<double>(scenarios_.size());
    panel.height_pt = std::min(kLongestPt, rows * std::max(12.0, kObserverPt * static_cast<double>(observers_.size())));
    for (std::size_t row = 0; row < scenarios_.size(); ++row) {
      panel.y_ticks.push_back({-static_cast<double>(row), scenarios_[row]});
    }
    return panel;
  }

  double height_of(std::size_t observer, std::size_t row) const {
    const double share = (static_cast<double>(observer) + 0.5) / static_cast<double>(observers_.size());
    return -static_cast<double>(row) + kRowPart * (0.5 - share);
  }

  FigureLine points(std::size_t observer) const {
    FigureLine line;
    line.label = observers_[observer];
    line.look = observer_looks(cells_.observers()).at(line.label);
    line.mark = FigureMark::kPoints;
    return line;
  }

  void add_errors(std::size_t observer, std::size_t metric, FigurePanel& panel) const {
    FigureLine medians = points(observer);
    FigureLine whiskers = medians;
    whiskers.label.clear();
    whiskers.mark = FigureMark::kLine;
    whiskers.look.dash.clear();
    for (std::size_t row = 0; row < scenarios_.size(); ++row) {
      const std::vector<double>& errors = runs_[observer][row].errors_mm[metric];
      if (errors.empty()) continue;
      const double y = height_of(observer, row);
      const auto [low, high] = std::minmax_element(errors.begin(), errors.end());
      whiskers.x.insert(whiskers.x.end(), {*low, *high, kFigureGap});
      whiskers.y.insert(whiskers.y.end(), {y, y, kFigureGap});
      medians.x.push_back(median(errors));
      medians.y.push_back(y);
    }
    panel.lines.push_back(std::move(whiskers));
    panel.lines.push_back(std::move(medians));
    panel.log_x = true;
  }

  void add_falls(std::size_t observer, FigurePanel& panel) const {
    FigureLine falls = points(observer);
    for (std::size_t row = 0; row < scenarios_.size(); ++row) {
      const Runs& runs = runs_[observer][row];
      if (runs.runs == 0) continue;
      falls.x.push_back(100.0 * runs.falls / runs.runs);
      falls.y.push_back(height_of(observer, row));
    }
    panel.lines.push_back(std::move(falls));
  }

  // Between the rows.
  void add_rules(FigurePanel& panel) const {
    FigureLine rules;
    rules.look = {.colour = "#D5DADF", .dash = {}, .point = 1, .width = 0.7};
    for (std::size_t row = 1; row < scenarios_.size(); ++row) {
      const double y = 0.5 - static_cast<double>(row);
      rules.x.insert(rules.x.end(), {panel.x_range[0], panel.x_range[1], kFigureGap});
      rules.y.insert(rules.y.end(), {y, y, kFigureGap});
    }
    panel.lines.insert(panel.lines.begin(), std::move(rules));
  }

  static void set_log_range(FigurePanel& panel) {
    double low = std::numeric_limits<double>::infinity();
    double high = 0.0;
    for (const FigureLine& line : panel.lines) {
      for (const double x : line.x) {
        if (!std::isfinite(x)) continue;
        low = std::min(low, x);
        high = std::max(high, x);
      }
    }
    if (high == 0.0) low = high = 1.0;  // all fell
    panel.x_range = {low / 1.3, high * 1.3};
  }

  const FigureSpec& spec_;
  const FigureCells& cells_;
  std::vector<std::string> observers_, scenarios_;
  std::string overrides_;
  std::vector<std::vector<Runs>> runs_;  // by observer and scenario
};

}  // namespace

Figure errors_figure(const FigureSpec& spec, const FigureCells& cells) {
  return ErrorsFigure(spec, cells).build();
}

}  // namespace dob
