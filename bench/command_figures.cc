#include <map>
#include <memory>

#include <fmt/format.h>

#include "bench/commands.h"
#include "bench/gnuplot_process.h"
#include "results/campaign_result.h"
#include "results/figure_campaign.h"
#include "results/figures.h"
#include "results/plain_files.h"
#include "results/whole_file.h"
#include "scenarios/input_error.h"

namespace dob {
namespace {

struct FiguresArguments {
  std::filesystem::path dir, out;
  FigureFormat format = FigureFormat::kSvg;
  FigureRequest request;
};

void list(const std::vector<MadeFigure>& figures, const FiguresArguments& arguments) {
  for (const MadeFigure& made : figures) {
    if (!made.figure) continue;
    fmt::print("{}.{}  {}\n", made.spec->id, to_string(arguments.format), made.spec->caption);
    for (const std::string& note : made.figure->notes) fmt::print("    without: {}\n", note);
  }
  for (const MadeFigure& made : figures) {
    if (!made.figure) fmt::print("not drawn: {}: {}\n", made.spec->id, made.reason);
  }
  fmt::print("\nfigures, their scripts and data: {}\n", arguments.out.string());
}

// The figures with what describes them.
struct Drawn {
  FigureSet paper;
  std::vector<CampaignFigure> campaign;
  std::vector<MadeFigure> figures;

  explicit Drawn(const FiguresArguments& arguments) {
    Run run = read_run(arguments.dir);
    if (const std::optional<Campaign> read = read_campaign(arguments.dir)) {
      campaign = campaign_figures(campaign_result(*read, run), arguments.request);
      figures = made_figures(campaign);
      return;
    }
    paper = load_figures(paper_figures_file());
    FigureCells cells(arguments.dir, std::move(run), arguments.request);
    figures = make_figures(paper, cells);
  }
  Drawn(const Drawn&) = delete;
  Drawn& operator=(const Drawn&) = delete;
};

int draw(FiguresArguments arguments) {
  if (arguments.out.empty()) {
    arguments.out = arguments.dir / "figures";
    require_plain_directory(arguments.out);
  }
  const Drawn drawn(arguments);
  const std::vector<MadeFigure>& figures = drawn.figures;
  try {
    write_figures(figures, arguments.format, arguments.out);
    write_whole_file(arguments.out / "index.md", figure_index(figures, arguments.format, arguments.dir));
  } catch (const WriteError& error) {  // nothing is lost
    throw InputError(error.what());
  }
  try {
    for (const MadeFigure& made : figures) {
      if (made.figure) run_gnuplot(arguments.out, made.spec->id + ".gp");
    }
  } catch (const GnuplotError& error) {
    throw GnuplotError(fmt::format("{}; scripts and data are in {}", error.what(), arguments.out.string()));
  }
  list(figures, arguments);
  return kExitOk;
}

}  // namespace

Command add_figures_command(CLI::App& app) {
  const std::map<std::string, FigureFormat> formats{
      {"svg", FigureFormat::kSvg}, {"pdf", FigureFormat::kPdf}, {"png", FigureFormat::kPng}};
  auto arguments = std::make_shared<FiguresArguments>();
  CLI::App* command =
      app.add_subcommand("figures", "the paper's figures, redrawn from a run directory, or those of a campaign");
  command->add_option("dir", arguments->dir, "run directory")->required();
  command->add_option("--format", arguments->format, "svg, pdf or png")->transform(CLI::CheckedTransformer(formats));
  command->add_option("--out", arguments->out,
                      "directory for the figures, their scripts and data (default DIR/figures)");
  command->add_option("--profile", arguments->request.profile, "of the cells (default tuned, else the run's first)");
  command->add_option("--gains", arguments->request.gains, "of the cells (default paper, else the run's first)");
  command->add_option("--planner", arguments->request.planner, "of the cells (default the run's first)");
  command->add_option("--observer", arguments->request.observers, "show these instead of those that a figure names")
      ->allow_extra_args(false);
  return [arguments] { return draw(*arguments); };
}

}  // namespace dob
