// All figures of a run directory, and what they leave in a directory: script and data of each, and an index.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results/figure.h"
#include "results/figure_campaign.h"
#include "results/figure_cells.h"
#include "results/figure_gnuplot.h"
#include "results/figure_spec.h"

namespace dob {

struct MadeFigure {
  const FigureSpec* spec = nullptr;
  std::optional<Figure> figure;
  std::string reason;  // why there is none
};

// One for each figure of the set, which must outlive them. Throws StoreError if nothing of the run can be drawn.
std::vector<MadeFigure> make_figures(const FigureSet& set, FigureCells& cells);

// The figures of a campaign, which has none of the paper's. They must outlive what is returned.
std::vector<MadeFigure> made_figures(const std::vector<CampaignFigure>& figures);

// FIGURE.gp and FIGURE.dat. Throws StoreError if the directory or a file cannot be written.
void write_figures(const std::vector<MadeFigure>& figures, FigureFormat format, const std::filesystem::path& out);

// Markdown: the figures with the paper's numbers, captions and cells; then what is not there, with the reasons.
std::string figure_index(const std::vector<MadeFigure>& figures, FigureFormat format,
                         const std::filesystem::path& run_directory);

}  // namespace dob
