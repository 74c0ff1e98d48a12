// Observers loaded from shared libraries (plugin_api.h).
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "observers/factory.h"
#include "observers/plugin_api.h"

namespace dob {

// Whether an observer's name is the path of a library: it ends in ".so" or holds a '/'.
bool is_plugin_path(std::string_view name);

// Loads the library, or finds it loaded. It stays loaded until the program ends, so that it outlives its observers and
// whatever it has thrown; child processes inherit it. Throws OptionError with the file and the reason in one line: no
// such file, not a library, no dob_observer_plugin(), another interface or compiler, a name that is none or taken by a
// built-in observer, nothing to make an observer with. `make` of the result may throw anything.
ObserverInfo load_plugin(const std::filesystem::path& file);

// Its observer. Throws OptionError as load_plugin() does, and for whatever the plugin's factory throws or if it returns
// nothing.
std::unique_ptr<DisturbanceObserver> make_from_plugin(const std::filesystem::path& file, const ObserverOptions& options,
                                                      double dt);

}  // namespace dob
