// The observers of a cell from the text that its run keeps of them.
#pragma once

#include <string>
#include <vector>

#include "scenarios/scenario.h"

namespace dob {

struct StoredObservers {
  ObserverConfig observer;
  std::vector<ObserverConfig> shadows;  // that watch it
};

// The inverse of observer_toml(), whatever the profiles have become. Nothing is loaded or made: what there is no such
// observer or option of shows when it is made. Profiles and labels are not in the text and stay empty. `source` is what
// messages call it. Throws InputError.
StoredObservers read_observer_toml(const std::string& text, const std::string& source);

}  // namespace dob
