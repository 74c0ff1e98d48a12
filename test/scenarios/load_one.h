// A request that means one scenario.
#pragma once

#include <gtest/gtest.h>

#include "scenarios/loader.h"

namespace dob {

inline Scenario load_one(const ScenarioRequest& request) {
  const std::vector<Scenario> scenarios = load_scenarios(request);
  EXPECT_EQ(scenarios.size(), 1u);
  return scenarios.at(0);
}

}  // namespace dob
