// From a figure's description and a run to what is drawn.
#pragma once

#include "results/figure.h"
#include "results/figure_cells.h"
#include "results/figure_spec.h"

namespace dob {

// A figure of kind kTime. What is missing of it stands in its notes. Throws StoreError, with the reason, if the run has
// nothing of it.
Figure time_figure(const FigureSet& set, const FigureSpec& spec, FigureCells& cells);

}  // namespace dob
