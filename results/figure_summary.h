// Figures of a whole run rather than of time series.
#pragma once

#include "results/figure.h"
#include "results/figure_cells.h"
#include "results/figure_spec.h"

namespace dob {

// Kind kErrors: a row for each scenario, an observer's runs of all variants and seeds together. Of the cells that the
// FigureCells show. Throws StoreError if none has been run.
Figure errors_figure(const FigureSpec& spec, const FigureCells& cells);

// Kind kSurvival: a panel for each scenario that was run with several amplitudes of its first disturbance, as the
// resolved scenarios of the run directory have them. Throws StoreError if there is none.
Figure survival_figure(const FigureSpec& spec, const FigureCells& cells);

}  // namespace dob
