#include "results/figure_data.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/claim_cells.h"
#include "results/figure_lines.h"
#include "results/figure_style.h"

namespace dob {
namespace {

constexpr std::size_t kBuckets = 420;  // of a line across the whole column: about twice what can be told apart in print
constexpr double kBeforeFall = 1.0;    // [s] of a fall that do not count for the range of the values

void add_once(std::vector<std::string>& list, const std::string& text) {
  if (std::find(list.begin(), list.end(), text) == list.end()) list.push_back(text);
}

class TimeFigure {
 public:
  TimeFigure(const FigureSet& set, const FigureSpec& spec, FigureCells& cells)
      : set_(set), spec_(spec), cells_(cells), looks_(observer_looks(cells.observers())) {
    figure_.id = spec.id;
    figure_.columns = spec.columns;
  }

  Figure build() {
    for (const FigurePanelSpec& panel : spec_.panels) add_panels(panel);
    if (figure_.panels.empty()) throw StoreError(fmt::format("{}", fmt::join(figure_.notes, "; ")));
    set_ranges();
    figure_.subtitle = subtitle();
    return std::move(figure_);
  }

 private:
  // What is told of a panel once all lines are known.
  struct Extent {
    const FigurePanelSpec* spec;
    double end_s = 0.0;            // of the longest trial in it
    double low = 0.0, high = 0.0;  // of the values that are shown
  };

  struct Shown {
    FigureCell cell;
    FigureSeries series;
    std::string label;
  };

  const std::vector<std::string>& observers_of(const FigurePanelSpec& panel) const {
    if (!panel.labels.empty()) return panel.observers;  // it is about these
    if (!cells_.request().observers.empty()) return cells_.request().observers;
    return panel.observers.empty() ? spec_.observers : panel.observers;
  }

  void add_panels(const FigurePanelSpec& spec) {
    const std::vector<std::string>& observers = observers_of(spec);
    if (!spec.each_observer) return add_panel(spec, observers);
    for (const std::string& observer : observers) add_panel(spec, {observer});
  }

  void add_panel(const FigurePanelSpec& spec, const std::vector<std::string>& observers) {
    const FigureQuantity& quantity = set_.quantity(spec.quantity);
    FigurePanel panel;
    panel.title = spec.each_observer ? observers.front() : spec.title;
    panel.x_axis = "t [s]";
    panel.y_axis = with_leg(quantity.axis, spec.leg);
    Extent extent{&spec};
    const std::vector<Shown> all = find_cells(spec, quantity, observers);
    if (all.empty()) return;
    const FigureCell& longest = std::max_element(all.begin(), all.end(), [](const Shown& a, const Shown& b) {
                                  return a.cell.cell->simulated_s < b.cell.cell->simulated_s;
                                })->cell;
    add_background(spec, quantity, longest, panel, extent);
    for (const Shown& shown : all) {
      add_line(shown.series, shown.cell, spec.each_observer ? "" : shown.label, look_of(spec, quantity, shown), panel,
               extent);
      if (shown.cell.cell->outcome == Outcome::kFell) mark_fall(spec, *shown.cell.cell, panel.lines.back());
      remember(shown.cell.cell->key);
    }
    figure_.panels.push_back(std::move(panel));
    extents_.push_back(extent);
  }

  // What `read` gets from the cell's trace; an error names it.
  template <typename Read>
  static auto from_trace(const FigureCell& cell, Read read) {
    try {
      return read(*cell.trace);
    } catch (const StoreError& error) {
      throw StoreError(fmt::format("{}: {}", cell.cell->trace, error.what()));
    }
  }

  // Those of the observers that have something to show; why others have not goes to the notes.
  std::vector<Shown> find_cells(const FigurePanelSpec& spec, const FigureQuantity& quantity,
                                const std::vector<std::string>& observers) {
    std::vector<Shown> all;
    for (std::size_t i = 0; i < observers.size(); ++i) {
      try {
        const FigureCell cell = cells_.find(spec.cells.empty() ? spec_.cells : spec.cells, observers[i], spec_.profile);
        const FigureSeries series =
            from_trace(cell, [&](const Trace& trace) { return series_of(trace, quantity, spec.leg); });
        all.push_back(
            {cell, shown_part(spec, quantity, series, cell), spec.labels.empty() ? observers[i] : spec.labels[i]});
      } catch (const StoreError& missing) {
        add_once(figure_.notes, missing.what());
      }
    }
    return all;
  }

  // What is the same for all observers, from the trial that lasted longest.
  void add_background(const FigurePanelSpec& spec, const FigureQuantity& quantity, const FigureCell& cell,
                      FigurePanel& panel, Extent& extent) const {
    if (spec.shade_swing) {
      panel.bands = shown_bands(spec, from_trace(cell, [&](const Trace& trace) { return swings_of(trace, spec.leg); }));
    }
    if (spec.shade_disturbance) {
      for (const FigureBand& band : shown_bands(spec, from_trace(cell, disturbances_of))) panel.bands.push_back(band);
    }
    if (quantity.truth.empty()) return;
    const FigureSeries truth =
        shown_part(spec, quantity,
                   from_trace(cell, [&](const Trace& trace) { return truth_of(trace, quantity, spec.leg); }), cell);
    add_line(truth, cell, "true", truth_look(), panel, extent);
  }

  FigureLook look_of(const FigurePanelSpec& spec, const FigureQuantity& quantity, const Shown& shown) {
    FigureLook look = spec.labels.empty() ? looks_.at(shown.label) : numbered_look(index_of(shown.label));
    if (!quantity.truth.empty()) look.width = 0.8;
    if (spec.each_observer) look.dash.clear();  // alone in its panel, which bears its name
    return look;
  }

  static FigureSeries shown_part(const FigurePanelSpec& spec, const FigureQuantity& quantity, const FigureSeries& whole,
                                 const FigureCell& cell) {
    FigureSeries part = spec.time_s ? cut(whole, (*spec.time_s)[0], (*spec.time_s)[1]) : whole;
    if (std::none_of(part.value.begin(), part.value.end(), [](double v) { return std::isfinite(v); })) {
      throw StoreError(fmt::format("{}, {}: no {} in the part that is shown", case_name(cell.cell->key),
                                   cell.cell->key.observer, with_leg(quantity.axis, spec.leg)));
    }
    return part;
  }

  void add_line(const FigureSeries& series, const FigureCell& cell, const std::string& label, const FigureLook& look,
                FigurePanel& panel, Extent& extent) const {
    const bool fell = cell.cell->outcome == Outcome::kFell;
    const double until = fell ? cell.cell->simulated_s - kBeforeFall : std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < series.t.size(); ++i) {
      if (!std::isfinite(series.value[i]) || series.t[i] > until) continue;
      extent.low = std::min(extent.low, series.value[i]);
      extent.high = std::max(extent.high, series.value[i]);
    }
    extent.end_s = std::max(extent.end_s, cell.cell->simulated_s);
    FigureSeries drawn = decimated(series, kBuckets / static_cast<std::size_t>(figure_.columns));
    panel.lines.push_back({label, look, FigureMark::kLine, std::move(drawn.t), std::move(drawn.value), {}});
  }

  static void mark_fall(const FigurePanelSpec& spec, const CellResult& cell, FigureLine& line) {
    if (!spec.time_s || (cell.simulated_s >= (*spec.time_s)[0] && cell.simulated_s <= (*spec.time_s)[1])) {
      line.ended_at = cell.simulated_s;
    }
  }

  static std::vector<FigureBand> shown_bands(const FigurePanelSpec& spec, const std::vector<FigureBand>& bands) {
    std::vector<FigureBand> shown;
    for (FigureBand band : bands) {
      if (spec.time_s) {
        band.from = std::max(band.from, (*spec.time_s)[0]);
        band.to = std::min(band.to, (*spec.time_s)[1]);
      }
      if (band.from < band.to) shown.push_back(band);
    }
    return shown;
  }

  // Panels of one quantity over the same time have one range, for the eye to compare.
  void set_ranges() {
    double end_s = 0.0;
    for (const Extent& e : extents_) end_s = std::max(end_s, e.end_s);
    for (std::size_t i = 0; i < extents_.size(); ++i) {
      FigurePanel& panel = figure_.panels[i];
      panel.x_range = extents_[i].spec->time_s.value_or(std::array{0.0, end_s});
      double low = 0.0;
      double high = 0.0;
      for (const Extent& e : extents_) {
        if (e.spec->quantity != extents_[i].spec->quantity || e.spec->time_s != extents_[i].spec->time_s) continue;
        if (e.spec->limits) continue;
        low = std::min(low, e.low);
        high = std::max(high, e.high);
      }
      const double margin = 0.06 * std::max(high - low, 1e-9);
      panel.y_range = extents_[i].spec->limits.value_or(std::array{low < 0.0 ? low - margin : 0.0, high + margin});
    }
  }

  std::size_t index_of(const std::string& label) {
    add_once(labels_, label);
    return static_cast<std::size_t>(std::find(labels_.begin(), labels_.end(), label) - labels_.begin());
  }

  void remember(const CellKey& key) {
    const std::string scenario = case_name(key);
    const std::string overrides = key.overrides.empty() ? "" : ", " + key.overrides;
    add_once(scenarios_, scenario);
    add_once(observers_, fmt::format("{}@{}", key.observer.substr(0, key.observer.find(':')), key.profile));
    add_once(settings_, fmt::format("gains {}, planner {}, seed {}{}", key.gains, key.planner, key.seed, overrides));
    add_once(figure_.cells, fmt::format("{} {}@{} gains {} planner {} seed {}{}", scenario, key.observer, key.profile,
                                        key.gains, key.planner, key.seed, overrides));
  }

  std::string subtitle() const {
    return fmt::format("{}; {}; {}", fmt::join(scenarios_, ", "), fmt::join(observers_, ", "),
                       fmt::join(settings_, "; "));
  }

  const FigureSet& set_;
  const FigureSpec& spec_;
  FigureCells& cells_;
  std::map<std::string, FigureLook> looks_;
  Figure figure_;
  std::vector<Extent> extents_;  // of the figure's panels
  std::vector<std::string> labels_, scenarios_, observers_, settings_;
};

}  // namespace

Figure time_figure(const FigureSet& set, const FigureSpec& spec, FigureCells& cells) {
  return TimeFigure(set, spec, cells).build();
}

}  // namespace dob
