// An observer from outside: what its shared library has to export. One function,
//
//     const dob::ObserverPlugin* dob_observer_plugin() {
//       static constexpr dob::ObserverPlugin plugin{.name = "mine", .estimates_legs = true, .make = make_mine};
//       return &plugin;
//     }
//
// declared below, so that the compiler checks it and exports it. Library and program exchange C++ values and
// exceptions: both need the same compiler, standard library, Eigen and (for AVX) flags. `abi` holds what of that can be
// seen, and a program that finds another one refuses the library. Inside, the library may do as it likes; it brings its
// own copy of the functions of dob::observer_api that it uses, and shares no state with the program.
#pragma once

#include <cstdint>
#include <memory>

#include "observers/observer.h"
#include "observers/options.h"

namespace dob {

// Changes whenever the meaning of what is exchanged changes without its size.
inline constexpr std::uint32_t kPluginInterface = 1;

struct PluginAbi {
  std::uint32_t interface_version;
  std::uint32_t compiler;          // version of the C++ ABI
  std::uint32_t eigen_alignment;   // [byte] largest that Eigen gives its types
  std::uint32_t model_terms_size;  // [byte]
  std::uint32_t observer_input_size;
  std::uint32_t estimate_size;
  std::uint32_t options_size;

  friend constexpr bool operator==(const PluginAbi&, const PluginAbi&) = default;
};

// As seen by whoever is being compiled.
constexpr PluginAbi plugin_abi() {
  return {.interface_version = kPluginInterface,
          .compiler = __GXX_ABI_VERSION,
          .eigen_alignment = EIGEN_MAX_ALIGN_BYTES,
          .model_terms_size = sizeof(ModelTerms),
          .observer_input_size = sizeof(ObserverInput),
          .estimate_size = sizeof(Estimate),
          .options_size = sizeof(OptionValue) + sizeof(ObserverOptions)};
}

struct ObserverPlugin {
  PluginAbi abi = plugin_abi();  // stays the first member in all versions
  const char* name = nullptr;  // in tables and profiles: lower-case letters, digits and _, no built-in observer's name
  const char* summary = "";    // one line
  const char* source = "";     // where the method comes from
  bool estimates_legs = false;
  bool estimates_com = false;
  // An observer for ticks of dt [s]. Throws OptionError for options that it does not take (OptionReader says it well);
  // any other exception is reported as a fault of the plugin.
  std::unique_ptr<DisturbanceObserver> (*make)(const ObserverOptions& options, double dt) = nullptr;
};

}  // namespace dob

extern "C" [[gnu::visibility("default")]] const dob::ObserverPlugin* dob_observer_plugin();
