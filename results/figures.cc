#include "results/figures.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/figure_data.h"
#include "results/figure_robot.h"
#include "results/figure_summary.h"
#include "results/table_cells.h"
#include "results/whole_file.h"
#include "scenarios/input_error.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

Figure robot_of(const FigureSpec& spec, const FigureCells& cells) {
  std::vector<fs::path> scenarios;
  for (const CellSource& source : cells.run().info.sources.values()) {
    const fs::path file = cells.dir() / "scenarios" / (source.scenario + ".toml");
    if (std::find(scenarios.begin(), scenarios.end(), file) == scenarios.end()) scenarios.push_back(file);
  }
  if (scenarios.empty()) throw StoreError("the run does not say from which scenarios its cells were made");
  return robot_figure(spec.id, scenarios);
}

Figure make(const FigureSet& set, const FigureSpec& spec, FigureCells& cells) {
  switch (spec.kind) {
    case FigureKind::kTime:
      return time_figure(set, spec, cells);
    case FigureKind::kErrors:
      return errors_figure(spec, cells);
    case FigureKind::kSurvival:
      return survival_figure(spec, cells);
    case FigureKind::kRobot:
      return robot_of(spec, cells);
    case FigureKind::kPicture:
      break;
  }
  throw StoreError(spec.note);
}

// Of a cell of a Markdown table.
std::string cell_text(const std::string& text) {
  std::string safe;
  for (const char c : on_one_line(text)) {
    if (c == '|' || c == '<' || c == '\\') safe += '\\';
    safe += c;
  }
  return safe;
}

std::string drawn_row(const MadeFigure& made, FigureFormat format) {
  const std::string file = fmt::format("{}.{}", made.spec->id, to_string(format));
  std::vector<std::string> notes = made.figure->notes;
  if (!made.spec->note.empty()) notes.insert(notes.begin(), made.spec->note);
  return fmt::format("| {} | [{}]({}) | {} | {} | {} |\n", made.spec->paper.empty() ? "-" : made.spec->paper, file,
                     file, cell_text(made.spec->caption),
                     cell_text(fmt::format("{}", fmt::join(made.figure->cells, "; "))),
                     cell_text(fmt::format("{}", fmt::join(notes, "; "))));
}

}  // namespace

std::vector<MadeFigure> make_figures(const FigureSet& set, FigureCells& cells) {
  std::vector<MadeFigure> figures;
  bool any = false;
  for (const FigureSpec& spec : set.figures) {
    MadeFigure made{&spec, {}, {}};
    try {
      made.figure = make(set, spec, cells);
      any = any || spec.kind != FigureKind::kRobot;
    } catch (const std::exception& missing) {
      made.reason = missing.what();
    }
    figures.push_back(std::move(made));
  }
  if (!any) {
    const auto first = std::find_if(figures.begin(), figures.end(),
                                    [](const MadeFigure& f) { return f.spec->kind == FigureKind::kErrors; });
    throw StoreError(fmt::format("{}: no figure can be drawn: {}", cells.dir().string(),
                                 first == figures.end() ? "" : first->reason));
  }
  return figures;
}

std::vector<MadeFigure> made_figures(const std::vector<CampaignFigure>& figures) {
  std::vector<MadeFigure> made;
  made.reserve(figures.size());
  for (const CampaignFigure& figure : figures) made.push_back({&figure.spec, figure.figure, {}});
  return made;
}

void write_figures(const std::vector<MadeFigure>& figures, FigureFormat format, const fs::path& out) {
  std::error_code error;
  fs::create_directories(out, error);
  if (error) throw StoreError(fmt::format("{}: cannot be made: {}", out.string(), error.message()));
  for (const MadeFigure& made : figures) {
    if (!made.figure) continue;
    fs::remove(out / fmt::format("{}.{}", made.spec->id, to_string(format)), error);  // gnuplot would follow a link
    const GnuplotFiles files = gnuplot_files(*made.figure, format);
    write_whole_file(out / (made.spec->id + ".dat"), files.data);
    write_whole_file(out / (made.spec->id + ".gp"), files.script);
  }
}

std::string figure_index(const std::vector<MadeFigure>& figures, FigureFormat format, const fs::path& run_directory) {
  std::string text = fmt::format(
      "# Figures of {}\n\nDrawn by `dobbench figures`. The paper: Morlando, Teimoorzadeh, Ruggiero, Mechanism and "
      "Machine Theory 164, 2021.\n\n| paper | file | caption | cells | note |\n|---|---|---|---|---|\n",
      cell_text(run_directory.filename().empty() ? run_directory.parent_path().filename().string()
                                                 : run_directory.filename().string()));
  std::string missing;
  for (const MadeFigure& made : figures) {
    if (made.figure) {
      text += drawn_row(made, format);
    } else {
      missing += fmt::format("| {} | {} | {} | {} |\n", made.spec->paper.empty() ? "-" : made.spec->paper,
                             made.spec->id, cell_text(made.spec->caption), cell_text(made.reason));
    }
  }
  if (!missing.empty()) text += "\n## Not drawn\n\n| paper | figure | caption | why |\n|---|---|---|---|\n" + missing;
  return text;
}

}  // namespace dob
