// Which specifications of observers would load code.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dob {

// The files of the plugins that `NAME[:options]`, or a pair, names; empty for observers of this program. Loads nothing.
//
// load_observer() takes a plugin from the command line only: its place has no line. A scenario or a profile that names
// one is refused, and whoever takes specifications from elsewhere, as from a run directory, has to ask the user first.
std::vector<std::string> plugin_files(std::string_view specification);

}  // namespace dob
