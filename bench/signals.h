// What is kept of a tick as time series, by name: the columns of --log csv and of the traces.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "results/tick_record.h"

namespace dob {

// Names are unique, without commas, nest with '/' and end in their unit, as PlotJuggler likes them. A value is NaN
// where it does not apply: an estimate that the observer does not make, the point of a force while none acts. Times,
// states and references are those at the start of the tick; forces and torques act over the step that follows; an
// estimate and its truth are of the step before.
struct Signal {
  std::string name;
  std::function<double(const TickRecord&)> value;
};

// The first one is the time, t_s.
std::vector<Signal> tick_signals();

// Keeps every n-th tick, the first one included, so that about `rate` [Hz] of ticks of dt [s] are left; never more than
// there are.
class Decimation {
 public:
  Decimation(double rate, double dt);
  bool keep() noexcept { return count_++ % stride_ == 0; }
  double rate() const noexcept { return rate_; }  // [Hz] that results

 private:
  long stride_;
  double rate_;
  long count_ = 0;
};

}  // namespace dob
