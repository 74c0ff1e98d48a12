// The baseline without an observer: estimates nothing, whatever comes in.
#pragma once

#include "observers/observer.h"

namespace dob {

class NoObserver final : public DisturbanceObserver {
 public:
  std::string_view name() const noexcept override { return "none"; }
  void reset(const ModelTerms& /*now*/) noexcept override {}
  Estimate update(const ObserverInput& /*input*/) noexcept override { return {}; }
};

}  // namespace dob
