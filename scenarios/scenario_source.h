// A scenario's file before its values are read: what it is laid over, its variants, and what it says about itself
// rather than about the trial.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/document.h"
#include "scenarios/loader.h"

namespace dob {

inline constexpr const char* kNameKey = "name";

// The keys of the top level that are not part of a scenario's schema (all optional):
//   name      "NAME" or "NAME/VARIANT"; without it the file's name
//   base      "NAME", "FILE.toml" (relative to the file) or one of their variants, or a list of these, the later laid
//   over
//             the earlier: what this file is laid over; it need not be a whole scenario. A base's variants, its name
//             and its `set`, `observers` and `profiles` are not taken over
//   variant   table of tables of the same schema
//   set       "paper" or "extra" (the default)
//   observers, profiles   what the scenario is about (ScenarioInfo)
//   cells_of  "NAME" or "FILE.toml": this file has no trials of its own, it names those of another one; the only other
//             keys are summary, set, observers and profiles
struct ScenarioSource {
  std::string name;
  std::filesystem::path path;
  Node document;  // laid over its base, without the keys above
  std::vector<Entry> variants;
  std::optional<std::string> asked;  // the variant in the request
  std::string variant;               // that a resolved document is, by its name
  ScenarioInfo info;                 // what the file that was asked for says about itself
};

// `request`: "NAME", "NAME/VARIANT", "FILE.toml" or "FILE.toml/VARIANT". Of a file with cells_of, the source of the
// scenario that it names. Throws InputError.
ScenarioSource read_source(const std::string& request);

// The variants that the request means: all of them, the one asked for, or `variant` where the file has none.
std::vector<std::string> chosen_variants(const ScenarioSource& source);

// Merges a layer over a document. A posture names the joints of one robot, and its torque limit is what its motors can:
// a layer that chooses another robot drops both.
void lay(Node& document, const Node& layer);

// Throws InputError naming what there is when `name` is not among `names`.
void require_known(const std::string& name, const std::vector<std::string>& names, const Place& place,
                   const std::string& key = "");

std::vector<std::string> names_of(const std::vector<Entry>& entries);

}  // namespace dob
