#include "results/figure_lines.h"

#include <cmath>

#include "results/extremes.h"

namespace dob {
namespace {

using Columns = std::vector<const std::vector<float>*>;

Columns traced_columns(const Trace& trace, const std::vector<std::string>& names, const std::string& leg) {
  Columns columns;
  for (const std::string& name : names) columns.push_back(&trace.column(with_leg(name, leg)));
  return columns;
}

double combined(const Columns& signals, const Columns& minus, std::size_t row) {
  double squares = 0.0;
  double last = 0.0;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    last = (*signals[i])[row];
    if (!minus.empty()) last -= (*minus[i])[row];
    squares += last * last;
  }
  return signals.size() == 1 ? last : std::sqrt(squares);
}

FigureSeries combine(const Trace& trace, const std::vector<std::string>& signals, const std::vector<std::string>& minus,
                     const FigureQuantity& quantity, const std::string& leg) {
  const Columns plus = traced_columns(trace, signals, leg);
  const Columns less = traced_columns(trace, minus, leg);
  const std::vector<float>* gate =
      quantity.while_signal.empty() ? nullptr : &trace.column(with_leg(quantity.while_signal, leg));
  const std::vector<float>& t = trace.column("t_s");
  FigureSeries series;
  series.t.assign(t.begin(), t.end());
  for (std::size_t row = 0; row < t.size(); ++row) {
    const bool shown = gate == nullptr || (*gate)[row] != 0.0F;
    series.value.push_back(shown ? quantity.scale * combined(plus, less, row) : kFigureGap);
  }
  return series;
}

// Points of one bucket: those of the smallest and the largest value, or one NaN where there is none.
void add_extremes(const FigureSeries& in, std::size_t begin, std::size_t end, FigureSeries& out) {
  const auto [first, second] = extremes(in.value, begin, end);
  for (const std::size_t i : {first, second}) {
    out.t.push_back(in.t[i]);
    out.value.push_back(in.value[i]);
    if (first == second) break;
  }
}

// Stretches in which the signal is not `off`.
std::vector<FigureBand> bands(const Trace& trace, const std::vector<float>& signal, bool when, bool disturbance) {
  const std::vector<float>& t = trace.column("t_s");
  std::vector<FigureBand> bands;
  bool inside = false;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const bool now = (signal[i] != 0.0F) == when;
    if (now && !inside) bands.push_back({t[i], t[i], disturbance});
    if (inside) bands.back().to = t[i];
    inside = now;
  }
  return bands;
}

}  // namespace

FigureSeries series_of(const Trace& trace, const FigureQuantity& quantity, const std::string& leg) {
  return combine(trace, quantity.signals, quantity.minus, quantity, leg);
}

FigureSeries truth_of(const Trace& trace, const FigureQuantity& quantity, const std::string& leg) {
  return combine(trace, quantity.truth, {}, quantity, leg);
}

FigureSeries cut(const FigureSeries& series, double from, double to) {
  FigureSeries part;
  for (std::size_t i = 0; i < series.t.size(); ++i) {
    if (series.t[i] < from || series.t[i] > to) continue;
    part.t.push_back(series.t[i]);
    part.value.push_back(series.value[i]);
  }
  return part;
}

FigureSeries decimated(const FigureSeries& series, std::size_t buckets) {
  const std::size_t n = series.t.size();
  if (n <= 2 * buckets) return series;
  FigureSeries out;
  for (std::size_t b = 0; b < buckets; ++b) add_extremes(series, b * n / buckets, (b + 1) * n / buckets, out);
  return out;
}

std::vector<FigureBand> swings_of(const Trace& trace, const std::string& leg) {
  return bands(trace, trace.column(leg + "/stance"), false, false);
}

std::vector<FigureBand> disturbances_of(const Trace& trace) {
  return bands(trace, trace.column("disturbance_active"), true, true);
}

}  // namespace dob
