// One colour, dash and point per observer, the same in every figure; the colours of the best known ones are those of
// the report page. After Okabe and Ito, to be told apart by the colour-blind.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "results/figure.h"

namespace dob {

// Of each observer; those without a look of their own take what is left in the order of the list.
std::map<std::string, FigureLook> observer_looks(const std::vector<std::string>& observers);

// Of lines that are not observers (orders), in their order.
FigureLook numbered_look(std::size_t number);

// What an estimate is compared with: black and broad, for the estimates to lie upon.
FigureLook truth_look();

}  // namespace dob
