// Bounds on what any observer could do: the true disturbance as the estimate. No observer may see the truth, so this
// one says only WHICH parts of an estimate it stands for and leaves them zero; the trial fills them in
// (bench/trial.cc). Labelled by ObserverInfo::oracle, never ranked with the observers.
#pragma once

#include "observers/observer.h"

namespace dob {

class OracleObserver final : public DisturbanceObserver {
 public:
  // `name` has to outlive the observer.
  OracleObserver(std::string_view name, bool legs, bool com) : name_(name), legs_(legs), com_(com) {}

  std::string_view name() const noexcept override { return name_; }
  void reset(const ModelTerms& /*now*/) noexcept override {}
  Estimate update(const ObserverInput& /*input*/) noexcept override {
    Estimate estimate;
    estimate.has_legs = legs_;
    estimate.has_com = com_;
    return estimate;
  }

 private:
  std::string_view name_;
  bool legs_;
  bool com_;
};

}  // namespace dob
