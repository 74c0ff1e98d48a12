// A plugin that shows that it was loaded, whatever becomes of it then: as soon as it is, the file PLUGIN_WAS_LOADED is
// in the working directory.
#include <fstream>

#include "observers/plugin_api.h"

namespace {

[[gnu::constructor]] void leave_a_mark() {
  std::ofstream("PLUGIN_WAS_LOADED");
}

class Nothing final : public dob::DisturbanceObserver {
 public:
  std::string_view name() const noexcept override { return "leaves_a_mark"; }
  void reset(const dob::ModelTerms& /*now*/) noexcept override {}
  dob::Estimate update(const dob::ObserverInput& /*input*/) noexcept override { return {.has_legs = true}; }
};

std::unique_ptr<dob::DisturbanceObserver> make(const dob::ObserverOptions& /*options*/, double /*dt*/) {
  return std::make_unique<Nothing>();
}

}  // namespace

const dob::ObserverPlugin* dob_observer_plugin() {
  static constexpr dob::ObserverPlugin plugin{
      .name = "leaves_a_mark", .summary = "for tests", .source = "here", .estimates_legs = true, .make = make};
  return &plugin;
}
