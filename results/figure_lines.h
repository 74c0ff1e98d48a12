// Lines and bands of a figure from the time series of a cell.
#pragma once

#include <string>
#include <vector>

#include "results/figure.h"
#include "results/figure_spec.h"
#include "results/trace.h"

namespace dob {

struct FigureSeries {
  std::vector<double> t, value;  // [s], in the unit of the quantity's axis; NaN where it does not apply
};

// Every sample of the trace. Throws StoreError if the trace lacks a signal, named in the message.
FigureSeries series_of(const Trace& trace, const FigureQuantity& quantity, const std::string& leg);
FigureSeries truth_of(const Trace& trace, const FigureQuantity& quantity, const std::string& leg);  // needs a truth

// The part from `from` to `to` [s], both included.
FigureSeries cut(const FigureSeries& series, double from, double to);

// No more than two points for each of `buckets` equal stretches of time, the smallest and the largest value of the
// stretch in their order of time, so that no peak is lost; a series that is short enough stays as it is.
FigureSeries decimated(const FigureSeries& series, std::size_t buckets);

// When the leg swings, and when any disturbance acts. Throws StoreError as above.
std::vector<FigureBand> swings_of(const Trace& trace, const std::string& leg);
std::vector<FigureBand> disturbances_of(const Trace& trace);

}  // namespace dob
