#include "results/figure_spec.h"

#include <algorithm>

#include "results/claim_keys.h"
#include "robot/types.h"
#include "scenarios/data_root.h"
#include "scenarios/reader.h"

namespace dob {
namespace {

constexpr std::array<Choice<FigureKind>, 5> kFigureKinds{{
    {"time", FigureKind::kTime},
    {"errors", FigureKind::kErrors},
    {"survival", FigureKind::kSurvival},
    {"robot", FigureKind::kRobot},
    {"picture", FigureKind::kPicture},
}};

std::vector<std::string> texts_or_none(Reader& reader, std::string_view key) {
  return reader.has(key) ? reader.texts(key) : std::vector<std::string>{};
}

std::optional<std::array<double, 2>> read_interval(Reader& reader, std::string_view key) {
  if (!reader.has(key)) return std::nullopt;
  const std::vector<double> ends = reader.numbers(key, kAnyNumber);
  if (ends.size() != 2 || ends[0] >= ends[1]) reader.refuse(key, "[from, to] with from < to");
  return std::array{ends[0], ends[1]};
}

FigureQuantity read_quantity(Reader& reader, const FigureSet& set) {
  FigureQuantity q;
  q.id = reader.text("id");
  q.axis = reader.text("axis");
  q.scale = reader.number("scale", above(0.0, 1e9), 1.0);
  q.signals = reader.texts("signals");
  q.minus = texts_or_none(reader, "minus");
  q.truth = texts_or_none(reader, "truth");
  q.while_signal = text_or(reader, "while", "");
  for (const auto& [key, list] : {std::pair("minus", &q.minus), std::pair("truth", &q.truth)}) {
    if (!list->empty() && list->size() != q.signals.size()) reader.refuse(key, "as many as there are signals");
  }
  const auto same = [&](const FigureQuantity& other) { return other.id == q.id; };
  if (std::any_of(set.quantities.begin(), set.quantities.end(), same)) {
    reader.refuse("id", "an id that no other quantity has");
  }
  return q;
}

FigurePanelSpec read_panel(Reader& reader, const FigureSet& set) {
  FigurePanelSpec panel;
  panel.quantity = reader.text("quantity");
  const auto named = [&](const FigureQuantity& q) { return q.id == panel.quantity; };
  if (std::none_of(set.quantities.begin(), set.quantities.end(), named)) reader.refuse("quantity", "id of a quantity");
  panel.leg = text_or(reader, "leg", "");
  if (!panel.leg.empty() && std::find(kLegNames.begin(), kLegNames.end(), panel.leg) == kLegNames.end()) {
    reader.refuse("leg", "one of LF, RF, LH, RH");
  }
  panel.title = text_or(reader, "title", "");
  panel.cells = texts_or_none(reader, "cells");
  panel.observers = texts_or_none(reader, "observers");
  panel.labels = texts_or_none(reader, "labels");
  if (!panel.labels.empty() && panel.labels.size() != panel.observers.size()) {
    reader.refuse("labels", "as many as there are observers");
  }
  panel.each_observer = reader.flag("each_observer", false);
  panel.shade_swing = reader.flag("shade_swing", false);
  if (panel.shade_swing && panel.leg.empty()) reader.refuse("shade_swing", "only with a leg");
  panel.shade_disturbance = reader.flag("shade_disturbance", false);
  panel.time_s = read_interval(reader, "time_s");
  panel.limits = read_interval(reader, "limits");
  return panel;
}

FigureSpec read_figure(Reader& reader, const FigureSet& set) {
  FigureSpec figure;
  figure.id = reader.text("id");
  const auto same = [&](const FigureSpec& other) { return other.id == figure.id; };
  if (!is_bare_key(figure.id) || std::any_of(set.figures.begin(), set.figures.end(), same)) {
    reader.refuse("id", "letters, digits, _ and -, and no other figure's id");
  }
  figure.paper = text_or(reader, "paper", "");
  figure.caption = reader.text("caption");
  figure.note = text_or(reader, "note", "");
  figure.kind = reader.choice("kind", kFigureKinds, std::optional(FigureKind::kTime));
  figure.cells = texts_or_none(reader, "cells");
  figure.observers = texts_or_none(reader, "observers");
  figure.leave_out = texts_or_none(reader, "leave_out");
  figure.profile = text_or(reader, "profile", "");
  if (reader.has("columns")) figure.columns = reader.integer("columns", 1, 2);
  if (figure.kind == FigureKind::kTime) {
    reader.each("panel", [&](Reader& r) { figure.panels.push_back(read_panel(r, set)); });
  }
  return figure;
}

}  // namespace

const FigureQuantity& FigureSet::quantity(const std::string& id) const {
  return *std::find_if(quantities.begin(), quantities.end(), [&](const FigureQuantity& q) { return q.id == id; });
}

std::filesystem::path paper_figures_file() {
  return data_root() / "results" / "paper_figures.toml";
}

FigureSet load_figures(const std::filesystem::path& file) {
  FigureSet set;
  const Node document = parse_file(file);
  Reader::read(document, "", [&](Reader& reader) {
    reader.each("quantity", [&](Reader& r) { set.quantities.push_back(read_quantity(r, set)); });
    reader.each("figure", [&](Reader& r) { set.figures.push_back(read_figure(r, set)); });
  });
  return set;
}

std::string with_leg(std::string text, const std::string& leg) {
  for (std::size_t at = text.find('$'); at != std::string::npos; at = text.find('$', at + leg.size())) {
    text.replace(at, 1, leg);
  }
  return text;
}

}  // namespace dob
