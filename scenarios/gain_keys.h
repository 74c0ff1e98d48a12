// One way to give the gains in place of another, when a specification is laid over a profile.
#pragma once

#include "scenarios/document.h"

namespace dob {

// Removes from the observer's `table` the gains that `overlay` gives in another way (kMomentumGainKeys), with what
// belongs to them: the profile's `gains`, if the command line names a `family`. A family's bandwidth is stated, so it
// also replaces gain_scale. Likewise in the tables below, the parts of a pair.
void drop_replaced_gains(Node& table, const Node& overlay);

}  // namespace dob
