// Options and routing as tables of a document. Private to scenarios/.
#pragma once

#include <string>

#include "scenarios/document.h"
#include "scenarios/scenario.h"

namespace dob {

inline constexpr const char* kRouting = "routing";

// One key of the observer's table into `options`. The keys of a table below it, as of one part of a pair, go with its
// name before them: KEY in [momentum_com.legs] is the option `legs.KEY`. Throws InputError.
void read_option(const Node& node, const std::string& observer, const std::string& key, ObserverOptions& options);

// The table `path`. Throws InputError.
Routing read_routing(const Node& node, const std::string& path);

}  // namespace dob
