// What the tables call the gains that a cell's controller has.
#pragma once

#include <string>
#include <string_view>

namespace dob {

struct ScenarioRequest;

// Gains that a scenario brings itself. As ScenarioRequest::gains it means what an empty one does.
inline constexpr std::string_view kOwnGains = "own";

// The set that was asked for, else the one whose values the scenario has ("paper" where its file says nothing), else
// kOwnGains. `variant` as in the Scenario; overrides do not count, they have a column of their own. Throws InputError.
std::string gains_name(const ScenarioRequest& request, std::string_view variant);

}  // namespace dob
