// What `dobbench tune` searches and how it judges: scenarios/config/tuning.toml, checked.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scenarios/input_error.h"

namespace dob {

struct TuningProcedure {
  std::vector<std::string> scenarios;  // NAME or NAME/VARIANT
  double duration = 0.0;               // [s] of each, from its start
  int first_seed = 0, last_seed = 0;   // training seeds
  std::string gains, planner, profile;
  double com_scale = 1.0;   // [m] of com_error_max in the score
  double foot_scale = 1.0;  // [m] of foot_error_max
};

struct TuningRange {
  double low, high;  // > 0, drawn log-uniformly
};
struct TuningParameter {
  std::string key;  // of the observer's options, or routing.KEY
  std::variant<TuningRange, std::vector<std::string>> values;
};

// Throw InputError for what is wrong in the file.
TuningProcedure load_tuning_procedure();

// The parameters of one observer; an observer without a table: InputError, naming those that have one.
std::vector<TuningParameter> load_tuning_space(std::string_view observer);

}  // namespace dob
