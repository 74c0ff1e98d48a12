// Observers that see what the observer in the loop sees and change nothing: how good each estimate is on identical
// data.
#pragma once

#include <memory>
#include <vector>

#include "bench/recorder.h"
#include "observers/observer.h"
#include "results/cell.h"
#include "results/estimate_errors.h"
#include "scenarios/scenario.h"

namespace dob {

// In the order of a tick: judge() before the recorder moves on to the next interval, update() with what the observer in
// the loop gets, count() if the tick counts for the metrics. None of them allocates.
class Shadows {
 public:
  // Ticks of dt [s]. Throws what make_observer throws.
  Shadows(const std::vector<ObserverConfig>& observers, double dt);

  void reset(const ModelTerms& now) noexcept;
  void judge(const Recorder& recorder) noexcept;
  void update(const ObserverInput& input, const Recorder& recorder) noexcept;
  void count() noexcept;

  std::vector<ShadowResult> results() const;

 private:
  struct Shadow {
    std::string label, profile;
    bool oracle;
    std::unique_ptr<DisturbanceObserver> observer;
    Estimate estimate;    // for the interval of the recorder's last record
    EstimateError error;  // of the estimate that was judged last
    EstimateErrors errors;
  };

  std::vector<Shadow> shadows_;
  TickRecord judged_;  // only the estimate's part of it is used
};

}  // namespace dob
