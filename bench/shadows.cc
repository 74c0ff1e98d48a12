#include "bench/shadows.h"

#include "observers/factory.h"

namespace dob {

Shadows::Shadows(const std::vector<ObserverConfig>& observers, double dt) {
  shadows_.reserve(observers.size());
  for (const ObserverConfig& config : observers) {
    shadows_.push_back({.label = config.label.empty() ? config.observer : config.label,
                        .profile = config.profile,
                        .oracle = is_oracle(config.observer),
                        .observer = make_observer(config.observer, config.options, dt),
                        .estimate = {},
                        .error = {},
                        .errors = {}});
  }
}

void Shadows::reset(const ModelTerms& now) noexcept {
  for (Shadow& shadow : shadows_) shadow.observer->reset(now);
}

void Shadows::judge(const Recorder& recorder) noexcept {
  for (Shadow& shadow : shadows_) {
    recorder.judge(shadow.estimate, judged_);
    shadow.error = estimate_error(judged_);
  }
}

void Shadows::update(const ObserverInput& input, const Recorder& recorder) noexcept {
  for (Shadow& shadow : shadows_) {
    shadow.estimate = shadow.observer->update(input);
    if (shadow.oracle) recorder.tell_truth(shadow.estimate);
  }
}

void Shadows::count() noexcept {
  for (Shadow& shadow : shadows_) shadow.errors.add(shadow.error);
}

std::vector<ShadowResult> Shadows::results() const {
  std::vector<ShadowResult> results;
  for (const Shadow& shadow : shadows_) {
    const EstimateRmse rmse = shadow.errors.rmse();
    results.push_back({.observer = shadow.label,
                       .profile = shadow.profile,
                       .estimate_rmse_N = finite(rmse.force_N),
                       .joint_estimate_rmse_Nm = finite(rmse.joint_Nm),
                       .com_force_rmse_N = finite(rmse.com_force_N),
                       .com_moment_rmse_Nm = finite(rmse.com_moment_Nm)});
  }
  return results;
}

}  // namespace dob
