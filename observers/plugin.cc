#include "observers/plugin.h"

#include <algorithm>
#include <dlfcn.h>
#include <string>

#include <fmt/format.h>

namespace dob {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEntry = "dob_observer_plugin";

[[noreturn]] void refuse(const fs::path& file, std::string_view reason) {
  throw OptionError(fmt::format("plugin {}: {}", file.string(), reason));
}

// The loader's own words, without the path that it puts before them.
std::string last_loader_error(const fs::path& file) {
  const char* text = ::dlerror();  // NOLINT(concurrency-mt-unsafe): of this thread, in glibc
  std::string words = text == nullptr ? "unknown error" : text;
  const std::string path = file.string() + ": ";
  if (words.starts_with(path)) words.erase(0, path.size());
  return words;
}

void check_abi(const fs::path& file, const PluginAbi& theirs) {
  constexpr PluginAbi kOurs = plugin_abi();
  const auto check = [&](const char* what, std::uint32_t built, std::uint32_t needed) {
    if (built == needed) return;
    refuse(file, fmt::format("built for {} {}, this program needs {}; build it again against the installed headers of "
                             "this program, with the same compiler and flags",
                             what, built, needed));
  };
  check("plugin interface", theirs.interface_version, kOurs.interface_version);
  check("C++ ABI", theirs.compiler, kOurs.compiler);
  check("Eigen's alignment of", theirs.eigen_alignment, kOurs.eigen_alignment);
  check("ModelTerms of size", theirs.model_terms_size, kOurs.model_terms_size);
  check("ObserverInput of size", theirs.observer_input_size, kOurs.observer_input_size);
  check("Estimate of size", theirs.estimate_size, kOurs.estimate_size);
  check("ObserverOptions of size", theirs.options_size, kOurs.options_size);
}

void check_name(const fs::path& file, std::string_view name) {
  const bool bare = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
  if (!bare) refuse(file, fmt::format("its name is '{}'; allowed: lower-case letters, digits and _", name));
  for (const ObserverInfo& info : built_in_observers()) {
    if (info.name == name) refuse(file, fmt::format("its name '{}' is that of a built-in observer", name));
  }
}

}  // namespace

bool is_plugin_path(std::string_view name) {
  return name.ends_with(".so") || name.find('/') != std::string_view::npos;
}

ObserverInfo load_plugin(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) refuse(file, "there is no such file");
  const fs::path path = fs::absolute(file);  // a bare name would be searched for in the system's directories
  void* library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) refuse(file, fmt::format("cannot be loaded: {}", last_loader_error(path)));
  const auto entry = reinterpret_cast<decltype(&dob_observer_plugin)>(::dlsym(library, kEntry));
  if (entry == nullptr) refuse(file, fmt::format("it exports no function {}()", kEntry));
  const ObserverPlugin* plugin = entry();
  if (plugin == nullptr) refuse(file, fmt::format("{}() returned nothing", kEntry));
  check_abi(file, plugin->abi);
  check_name(file, plugin->name == nullptr ? "" : plugin->name);
  if (plugin->make == nullptr) refuse(file, "it has no function that makes the observer");
  return {.name = plugin->name,
          .summary = plugin->summary == nullptr ? "" : plugin->summary,
          .source = plugin->source == nullptr ? "" : plugin->source,
          .estimates_legs = plugin->estimates_legs,
          .estimates_com = plugin->estimates_com,
          .make = plugin->make};
}

std::unique_ptr<DisturbanceObserver> make_from_plugin(const fs::path& file, const ObserverOptions& options, double dt) {
  const ObserverInfo info = load_plugin(file);
  std::unique_ptr<DisturbanceObserver> observer;
  try {
    observer = info.make(options, dt);
  } catch (const OptionError&) {
    throw;  // says what is wrong with the options, in its own words
  } catch (const std::exception& error) {
    refuse(file, fmt::format("its factory threw: {}", error.what()));
  } catch (...) {
    refuse(file, "its factory threw something that is no std::exception");
  }
  if (observer == nullptr) refuse(file, "its factory returned no observer");
  return observer;
}

}  // namespace dob
